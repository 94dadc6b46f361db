"""The key `decimal_comma` of a problem or a part says whether 1,5 is a number."""

import pytest

from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.marked import verdict

FIND = "find: {a: {task: pole_placement, poles: ['-3/2', '-5/2']}, b: {task: pole_placement, poles: [-1, -2]}}\n"
PLANT = f"system: {{A: [[0, 1], [0, 0]], B: [0, 1]}}\ndecimal_comma: yes\n{FIND}"


@pytest.mark.parametrize("value", ["[3,75; 4]", "[3,75, 4]", "['3,75', 4,0]", "'[3,75 4]'", "[3.75, 4]", "3,75; 4,00"])
def test_a_comma_is_read_as_the_point_where_the_problem_says_so(value):
    assert verdict(PLANT, "a", "K", value).verdict == "correct"


def test_the_digits_written_after_a_comma_count():
    found = [verdict(PLANT, "a", "K", value).verdict for value in ("[3,8; 4]", "[3,6; 4]")]
    assert found == ["correct", "wrong"]


@pytest.mark.parametrize(
    ("part", "value"),
    [("a", "[3,75; 4,0]"), ("a", "'3,75 4,0'"), ("a", "3,75; 4"), ("c", "0,5"), ("d", "s^2 + 1,5s + 0,5")],
)
def test_without_the_key_a_comma_is_a_point_where_nothing_else_makes_sense(part, value):
    more = (
        "c: {task: desired_poles, damping_ratio: 1/2, natural_frequency: 2}, "
        "d: {task: transfer_function, system: {A: [[0, 1], [-1/2, -3/2]], B: [0, 1], C: [1, 0]}}"
    )
    plain = PLANT.replace("decimal_comma: yes\n", "").replace("find: {", f"find: {{{more}, ")
    name = {"a": "K", "c": "damping_ratio", "d": "G"}[part]
    value = f"1/({value})" if part == "d" else value
    found = verdict(plain, part, name, value)
    assert (found.verdict, found.respelt) == ("correct", True)


def test_without_the_key_a_comma_separates():
    plain = PLANT.replace("decimal_comma: yes\n", "")
    assert verdict(plain, "a", "K", "[3,75]").verdict == "wrong"
    assert verdict(plain, "b", "K", "[2,3]").verdict == "correct"


@pytest.mark.parametrize(("said", "read"), [("yes", True), ("true", True), ("no", False), ("false", False)])
def test_a_part_says_it_for_itself(said, read):
    text = PLANT.replace("task: pole_placement, poles: [-1", f"decimal_comma: {said}, task: pole_placement, poles: [-1")
    parts = read_problem(Source("p.yaml", text), catalogue()).parts
    assert [part.decimal_comma for part in parts] == [True, read]


def test_what_is_neither_yes_nor_no_is_refused():
    with pytest.raises(InputError, match="yes"):
        read_problem(Source("p.yaml", PLANT.replace("comma: yes", "comma: maybe")), catalogue())


def test_what_can_be_a_decimal_or_a_list_is_told_with_both_readings():
    plant = "system: {matrix: [[1, 0, 0], [0, 2, 0], [0, 0, 3]]}\ndecimal_comma: yes\nfind: {a: eigenstructure}\n"
    found = verdict(plant, "a", "eigenvalues", "'1,5'")
    assert found.verdict == "not judged"
    assert "may be read as" in found.reason
    assert "frac{3}{2}" in found.reason
