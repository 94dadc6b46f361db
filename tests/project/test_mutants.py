"""The tool that makes slips in the program: which ones, in a sample that stays, and whether a test's eye is seen."""

import ast
from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest

from tools.mutants.__main__ import candidates, equivalents, sample, table
from tools.mutants.operators import mutants_of
from tools.mutants.reached import Reached
from tools.mutants.running import chosen_for, outcomes

ROOT = Path(__file__).parents[2]
ROUTH = ROOT / "solver" / "exact" / "stability" / "routh.py"


def slips(tmp_path, code):
    path = tmp_path / "file.py"
    path.write_text(code, encoding="utf-8")
    return list(mutants_of(path, tmp_path))


@pytest.mark.parametrize(
    ("expression", "changed"),
    [
        ("a - b", {"(a + b)", "(a)"}),
        ("a * b", {"(a)", "(b)"}),
        ("-a", {"(a)"}),
        ("a and b", {"(a or b)", "(a)", "(b)"}),
        ("not a", {"(a)"}),
        ("a < b", {"(a <= b)"}),
        ("a is None", {"(a is not None)"}),
        ("a[3]", {"a[4]"}),
        ("True", {"False"}),
        ("f(a, b)", {"f(b, a)"}),
        ("zip(a, b, strict=True)", set()),
        ("'a' + b", set()),
        ("[a] + b", set()),
        ("f'{a + b}'", set()),
        ("cast(a, -1)", set()),
    ],
)
def test_the_slips_of_an_expression(tmp_path, expression, changed):
    found = slips(tmp_path, f"def f(a, b):\n    return {expression}\n")
    results = {each.applied((tmp_path / "file.py").read_bytes()).decode().split("return ")[1] for each in found}
    assert {ast.unparse(ast.parse(result)) for result in results} == {ast.unparse(ast.parse(c)) for c in changed}
    assert {each.function for each in found} <= {"f"}


def test_what_is_not_computed_is_left_alone(tmp_path):
    code = '"""A text - with 1."""\nif TYPE_CHECKING:\n    x = 1\n\n\n@f(1)\ndef g(x: "a - b") -> "1":\n    "No 2."\n'
    assert slips(tmp_path, code) == []


def test_letters_of_several_bytes_do_not_move_a_slip(tmp_path):
    (sign,) = [each for each in slips(tmp_path, "x = 'λ', a + b\n") if each.kind == "sign"]
    assert sign.applied((tmp_path / "file.py").read_bytes()).decode() == "x = 'λ', (a - b)\n"


def test_a_sample_keeps_its_members_when_lines_move(tmp_path):
    before = sample(slips(tmp_path, "def f(a, b):\n    return [a - b, a < b, a * b]\n"), 3, seed=1)
    after = sample(slips(tmp_path, "\n\ndef f(a, b):\n    return [a - b, a < b, a * b]\n"), 3, seed=1)
    assert [each.key for each in before] == [each.key for each in after]
    assert before != sample(before, 3, seed=2) or len(before) < 2


def test_the_program_with_a_slip_is_still_python():
    for each in sample(candidates([ROOT / "solver"]), 100, seed=1):
        changed = each.applied((ROOT / each.file).read_bytes())
        assert ast.dump(ast.parse(changed)) != ast.dump(ast.parse((ROOT / each.file).read_bytes())), each


@pytest.mark.parametrize("known", equivalents(), ids=lambda each: f"{each['function']}: {each['after']}")
def test_a_slip_that_is_excused_can_be_made_and_has_its_reason(known):
    made = mutants_of(ROOT / known["file"], ROOT)
    assert any(
        (each.function, each.before, each.after) == (known["function"], known["before"], known["after"])
        for each in made
    )
    assert len(known["reason"]) > 20


def test_own_tests_come_first_and_the_quick_ones_of_each_function_before_its_other_cases():
    (slip, *_) = mutants_of(ROUTH, ROOT)
    seconds = {
        "tests/tasks/t.py::a": 0.1,
        "tests/exact/t.py::b[1]": 1,
        "tests/exact/t.py::b[2]": 2,
        "tests/exact/t.py::c": 3,
    }
    reached = Reached(dict(seconds))
    reached.lines[slip.file][slip.line] |= set(seconds)
    order = [test.rpartition(":")[2] for test in chosen_for(slip, reached)]
    assert order == ["b[1]", "c", "b[2]", "a"]


@pytest.mark.slow
def test_a_slip_is_killed_by_a_test_that_sees_it_and_survives_one_that_does_not():
    slip = next(each for each in mutants_of(ROUTH, ROOT) if each.kind == "sign")
    folder = "tests/exact/test_routh.py::test_"
    seeing, blind = f"{folder}textbook_arrays[coefficients0-rows0]", f"{folder}a_leading_zero_is_refused"
    found = {}
    for test in (seeing, blind):
        reached = Reached({test: 0.1})
        reached.lines[slip.file][slip.line].add(test)
        ((_, found[test]),) = outcomes([slip], reached, lanes=1)
    reached = Reached({seeing: 0.1})
    reached.lines[slip.file][slip.line].add(seeing)
    nothing = replace(slip, after=slip.before)
    assert [outcome for _, outcome in outcomes([slip, nothing], reached, lanes=1)] == ["killed", "survived"]
    assert found == {seeing: "killed", blind: "survived"}
    assert "50%" in table({"exact": Counter(found.values())})
