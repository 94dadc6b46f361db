"""`solve variants`: members of a family as files, what is told of them, and what is wrong."""

import json

import pytest

import solver
from solver.problem.source import InputError
from tests.papers.conftest import FAMILY


@pytest.fixture
def family(tmp_path):
    """A family in a file."""
    (tmp_path / "family.yaml").write_text(FAMILY, encoding="utf-8")
    return "family.yaml"


def written(folder):
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir()) if path.is_file()}


def test_members_are_problem_files_that_are_solved(solve, family, tmp_path):
    done = solve("variants", family, "--count", 3, "--seed", 7, "-o", "build/", "--check")
    assert done.code == 0
    lines = done.out.splitlines()
    assert lines[0] == "family-01: a = 3, b = -2, p = -2"
    assert lines[3] == "wrote 3 members (yaml) to build"
    assert lines[4].split(" draws of ")[1].startswith("108 choices")
    assert [line[:20].strip() for line in lines[6:]] == ["digits of a number", "steps", "nested roots", "decimals"]
    assert sorted(written(tmp_path / "build")) == ["family-01.yaml", "family-02.yaml", "family-03.yaml"]
    text = (tmp_path / "build" / "family-01.yaml").read_text(encoding="utf-8")
    assert text.startswith("# family.yaml, seed 7, member 1: a = 3, b = -2, p = -2\ntitle: A family\n")
    assert "parameters: {a: 3, b: -2, p: -2}" in text
    assert "vary" not in text
    assert solve("build/family-01.yaml", "-f", "json", "-o", "-").code == 0


def test_the_same_seed_writes_the_same_bytes(solve, family, tmp_path):
    for jobs, folder in ((1, "one"), (2, "two")):
        words = ("variants", family, "--count", 2, "--seed", 3, "-f", "yaml,html,json", "--jobs", jobs, "-o", folder)
        assert solve(*words).code == 0
    assert written(tmp_path / "one") == written(tmp_path / "two")
    assert len(written(tmp_path / "one")) == 6
    data = json.loads((tmp_path / "one" / "family-01.json").read_text(encoding="utf-8"))
    assert data["status"] == "verified"


def test_what_was_drawn_is_not_drawn_or_solved_again(solve, family, tmp_path, called):
    words = ("variants", family, "--seed", 7, "-f", "yaml,html", "-o", "build")
    first = solve(*words, "--count", 1)
    assert first.code == 0
    before = written(tmp_path / "build")
    called.clear()
    again = solve(*words, "--count", 1)
    assert (again, called) == (first, [])
    assert solve(*words, "--count", 2).code == 0
    assert {name for name, _ in called} == {"tried"}
    tried = len(called)
    more = written(tmp_path / "build")
    assert {name: more[name] for name in before} == before
    called.clear()
    assert solve(*words, "--count", 2, "--again").code == 0
    assert {name for name, _ in called} == {"tried"}
    assert len(called) > tried
    assert written(tmp_path / "build") == more
    called.clear()
    for path in (tmp_path / "build" / ".solve").iterdir():
        path.write_bytes(b"[")
    assert solve(*words, "--count", 2).code == 0
    assert {name for name, _ in called} == {"tried"}
    assert written(tmp_path / "build") == more
    (tmp_path / family).write_text(FAMILY.replace("A family", "Another family"), encoding="utf-8")
    called.clear()
    assert solve(*words, "--count", 2).code == 0
    assert len(called) >= 2


def test_where_there_are_too_few_it_is_said_what_rejected_the_others(solve, tmp_path):
    few = FAMILY.replace('["a != 2", controllable]', '["a > 3", "b > 1", "p < -3"]')
    (tmp_path / "few.yaml").write_text(few, encoding="utf-8")
    done = solve("variants", "few.yaml", "--count", 5, "-o", "build")
    assert done.code == 1
    assert "few-01: a = 4, b = 2, p = -4" in done.out
    assert "few.yaml:8:8: error: found 1 of 5 members: all 108 choices were drawn" in done.err
    (tmp_path / "none.yaml").write_text(FAMILY.replace("a != 2", "a > 4"), encoding="utf-8")
    done = solve("variants", "none.yaml")
    assert done.code == 1
    assert "none.yaml:7:11: error: found no member: all 108 choices were drawn" in done.err
    assert not (tmp_path / "none-variants").exists()


def test_what_is_no_family_is_refused(solve, good, family, tmp_path):
    done = solve("variants", good)
    assert done.code == 2
    assert "this problem is no family: it has no key 'vary'" in done.err
    (tmp_path / "bad.yaml").write_text(FAMILY.replace("from: 1", "frm: 1"), encoding="utf-8")
    done = solve("variants", "bad.yaml")
    assert done.code == 2
    assert "did you mean 'from'?" in done.err
    assert solve("variants", "nowhere.yaml").code == 2
    assert solve("variants", family, "-o", "-").code == 2
    assert "Did you mean yaml?" in solve("variants", family, "-f", "yml").err


def test_images_stand_beside_the_members(solve, tmp_path):
    picture = b"\x89PNG\r\n\x1a\n" + b"0" * 20
    (tmp_path / "p.png").write_bytes(picture)
    text = FAMILY.replace("title: A family", 'title: A family\nstatement: "![a plant](p.png)"')
    (tmp_path / "family.yaml").write_text(text, encoding="utf-8")
    assert solve("variants", "family.yaml", "-o", "build").code == 0
    assert (tmp_path / "build" / "p.png").read_bytes() == picture


def test_families_have_a_python_interface():
    told = []
    one, two = solver.variants(FAMILY, count=2, seed=7, progress=lambda *each: told.append(each))
    assert told[-1][:2] == (2, 2)
    assert told[-1][2].endswith(" draws")
    assert (one.number, dict(one.values)) == (1, {"a": "3", "b": "-2", "p": "-2"})
    assert one.solve().status == "verified"
    assert two.values != one.values
    with pytest.raises(InputError, match="found 45 of 46 members"):
        solver.variants(FAMILY, count=46)
