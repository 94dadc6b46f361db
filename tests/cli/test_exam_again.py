"""An exam made again: what is there and unchanged stays, a question that changed changes the papers that have it."""

import json
import shutil
from contextlib import chdir
from types import SimpleNamespace

import pytest

from solver.cli import main
from solver.cli.kept import hash_of_folder
from solver.papers.judging import Rejection
from solver.papers.kept import keep_drawn
from solver.resources import root
from tests.papers.conftest import FAMILY
from tests.papers.exams import EXAM, PROBLEM, write_exam

OUT = "exam-papers"
pytestmark = pytest.mark.xdist_group("exam_again")  # one exam serves all


def state(folder):
    """The bytes and times of all that is not hidden."""
    files = sorted(
        each for each in folder.rglob("*") if each.is_file() and ".solve" not in str(each.relative_to(folder))
    )
    return {str(each.relative_to(folder)): (each.read_bytes(), each.stat().st_mtime_ns) for each in files}


def bytes_of(folder):
    return {name: content for name, (content, _) in state(folder).items()}


@pytest.fixture(scope="module")
def once(tmp_path_factory):
    """A folder in which the exam was made."""
    folder = tmp_path_factory.mktemp("exam")
    with chdir(folder):
        assert main(["exam", write_exam(folder)]) == 0
    return folder


@pytest.fixture
def made(once, tmp_path):
    """The exam was made in this folder: what it was made of, with what was kept, stands here as it was left."""
    shutil.copytree(once, tmp_path, dirs_exist_ok=True)


def test_nothing_is_solved_or_written_again(solve, tmp_path, called):
    write_exam(tmp_path)
    first = solve("exam", "exam.yaml")
    assert first.code == 0
    assert called
    before = state(tmp_path / OUT)
    called.clear()
    again = solve("exam", "exam.yaml")
    assert again == first
    assert not called
    assert state(tmp_path / OUT) == before
    assert solve("exam", "exam.yaml", "--again") == first
    assert {name for name, _ in called} == {"tried", "made_of", "_written"}
    assert bytes_of(tmp_path / OUT) == {name: content for name, (content, _) in before.items()}


def test_members_of_a_small_family_are_shared_again(solve, tmp_path, called):
    few = FAMILY.replace('["a != 2", controllable]', '["a > 2", "b > 1", "p < -3"]')
    write_exam(tmp_path, EXAM.replace("count: 2", "students: class.csv"), family=few)
    (tmp_path / "class.csv").write_text("Ann\nBen\nCem\nDan\n", "utf-8")
    first = solve("exam", "exam.yaml")
    assert first.code == 0, first.err
    assert "in turn" in first.err
    called.clear()
    assert solve("exam", "exam.yaml") == first
    assert not called


def test_what_kept_a_family_from_having_enough_members_is_told_again(solve, tmp_path):
    write_exam(tmp_path, family=FAMILY.replace('["a != 2", controllable]', '["a > 3", "b > 1", "p < -3"]'))
    first = solve("exam", "exam.yaml")
    assert "found 1 of 2 members" in first.err
    assert solve("exam", "exam.yaml") == first


def test_a_question_that_changed_is_solved_alone(solve, made, tmp_path, called):
    (tmp_path / "step.yaml").write_text(PROBLEM.replace("s+4", "s+5"), encoding="utf-8")
    assert solve("exam", "exam.yaml").code == 0
    assert [text for name, text in called if name == "made_of"] == [PROBLEM.replace("s+4", "s+5")]
    assert [label for name, label in called if name == "_written"] == ["1", "2"]
    anew = tmp_path / "anew"
    assert solve("exam", "exam.yaml", "-o", "anew").code == 0
    ours, other = bytes_of(tmp_path / OUT), bytes_of(anew)
    assert {n: c for n, c in ours.items() if "answers/" not in n} == {
        n: c for n, c in other.items() if "answers/" not in n
    }


def test_a_paper_that_was_changed_or_lost_is_made_again_alone(solve, made, tmp_path, called):
    before = bytes_of(tmp_path / OUT)
    (tmp_path / OUT / "papers" / "paper-1.html").write_text("mine", encoding="utf-8")
    (tmp_path / OUT / "keys" / "key-2.html").unlink()
    called.clear()
    assert solve("exam", "exam.yaml").code == 0
    assert called == [("_written", "1"), ("_written", "2")]
    assert bytes_of(tmp_path / OUT) == before


@pytest.mark.parametrize(
    ("changed", "called_again"),
    [
        (lambda text: text.replace("Final", "Second"), {"_written"}),
        (lambda text: text.replace("duration: 120", "duration: 90"), {"_written"}),
        (lambda text: text.replace("seed: 2026", "seed: 2027"), {"tried", "_written"}),
        (lambda text: text.replace("marks: 10}", "marks: 12}"), {"made_of", "_written"}),
        (lambda text: f"# a comment\n{text}", set()),
    ],
)
def test_what_depends_on_a_change_is_made(solve, made, tmp_path, called, changed, called_again):
    write_exam(tmp_path, changed(EXAM))
    assert solve("exam", "exam.yaml").code == 0
    assert {name for name, _ in called} == called_again


def test_what_cannot_be_read_is_made_again(solve, made, tmp_path, called):
    first = solve("exam", "exam.yaml")
    before = bytes_of(tmp_path / OUT)
    for number, path in enumerate(sorted((tmp_path / OUT / ".solve").iterdir())):
        path.write_bytes([b"", b"{}", path.read_bytes()[:-9]][number % 3])
    (tmp_path / OUT / ".solve.json").write_text("[", encoding="utf-8")
    called.clear()
    again = solve("exam", "exam.yaml")
    assert (again.code, again.out) == (first.code, first.out)
    assert "is not used, and all is made again" in again.err
    assert {name for name, _ in called} == {"tried", "made_of", "_written"}
    assert bytes_of(tmp_path / OUT) == before


def test_what_is_not_needed_any_more_is_taken_away(solve, made, tmp_path):
    before = {each.name for each in (tmp_path / OUT / ".solve").iterdir()}
    write_exam(tmp_path, EXAM.replace("seed: 2026", "seed: 1"))
    solve("exam", "exam.yaml")
    after = {each.name for each in (tmp_path / OUT / ".solve").iterdir()}
    assert len(after) == len(before)
    assert after != before
    record = json.loads((tmp_path / OUT / ".solve.json").read_text("utf-8"))
    assert [name for name in record["made"] if name.startswith("paper")] == ["paper 1", "paper 2"]


def test_templates_count(solve, tmp_path, called):
    write_exam(tmp_path)
    own = tmp_path / "own"
    (own / "html").mkdir(parents=True)
    shutil.copy(root("templates") / "html" / "style.css", own / "html")
    assert solve("exam", "exam.yaml", "--templates", "own").code == 0
    called.clear()
    assert solve("exam", "exam.yaml", "--templates", "own").code == 0
    assert not called
    with (own / "html" / "style.css").open("a", encoding="utf-8") as file:
        file.write("/* mine */")
    hash_of_folder.cache_clear()
    assert solve("exam", "exam.yaml", "--templates", "own").code == 0
    assert "_written" in {name for name, _ in called}


def test_more_variants_keep_those_there_are(solve, made, tmp_path, called):
    before = bytes_of(tmp_path / OUT)
    called.clear()
    write_exam(tmp_path, EXAM.replace("count: 2", "count: 3"))
    assert solve("exam", "exam.yaml").code == 0
    assert len([name for name, _ in called if name == "tried"]) == 1
    after = bytes_of(tmp_path / OUT)
    assert {name: after[name] for name in before if name != "variants.csv"} == {
        name: content for name, content in before.items() if name != "variants.csv"
    }


def test_a_search_that_a_limit_cut_short_is_not_kept():
    kept, search = [], SimpleNamespace(rejections={Rejection("a > 1"): 2, Rejection.by_limits("time limit"): 1})
    search.judgements = {}
    search.draws = search.count = search.seed = search.most = 9
    search.source = SimpleNamespace(name="", text="")
    members = [({}, "")]
    keep_drawn(SimpleNamespace(put=lambda *data: kept.append(data)), search, 2, members)
    assert not kept
    keep_drawn(SimpleNamespace(put=lambda *data: kept.append(data)), search, 1, members)
    assert len(kept) == 1
