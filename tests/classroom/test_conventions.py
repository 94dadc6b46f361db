"""Where the problem names no convention, an answer by another usual one is right: one of each option."""

import pytest

from tests.helpers.marked import marked

PLANT = """
title: Conventions
{display}
system: {{transfer_function: "(s + 3)/(s^2 + 3s + 2)"}}
find:
  open: {{task: realization, form: {form}}}
  named: {{task: realization, form: {form}, convention: last_row}}
  later: {{task: controllability, system: {{from: open}}}}
"""
FIRST = {
    "controllable": {"A": "[[-3, -2], [1, 0]]", "B": "[1, 0]", "C": "[1, 3]", "D": "0"},
    "observable": {"A": "[[-3, 1], [-2, 0]]", "B": "[1, 3]", "C": "[1, 0]", "D": "0"},
}
LAST = {
    "controllable": {"A": "[[0, 1], [-2, -3]]", "B": "[0, 1]", "C": "[3, 1]", "D": "0"},
    "observable": {"A": "[[0, -2], [1, -3]]", "B": "[3, 1]", "C": "[0, 1]", "D": "0"},
}
JORDAN = """
title: Chains
find:
  open: {task: realization, form: jordan, system: {transfer_function: "1/(s + 1)^2"}}
  named: {task: realization, form: jordan, convention: subdiagonal, system: {transfer_function: "1/(s + 1)^2"}}
"""
ABOVE = {"A": "[[-1, 1], [0, -1]]", "B": "[0, 1]", "C": "[1, 0]"}
COST = """
title: A regulator
system: {A: [[0, 1], [0, 0]], B: [0, 1], C: [1, 0]}
find:
  open: {task: lqr, Q: [[1, 0], [0, 1]], R: 1, initial_state: [1, 0], marks: 2, answers: [P, cost]}
  half: {task: lqr, Q: [[1, 0], [0, 1]], R: 1, initial_state: [1, 0], cost_factor: 1/2}
  whole: {task: lqr, Q: [[1, 0], [0, 1]], R: 1, initial_state: [1, 0], cost_factor: 1}
"""
P = "[[sqrt(3), 1], [1, sqrt(3)]]"
FIRST_ROW = "it follows another usual convention, “convention: first_row”"


def plant(form, display=""):
    return PLANT.format(form=form, display=display)


def part_of(problem, part, values):
    """The verdicts of one part with these values submitted."""
    lines = "".join(f"    {name}: {value}\n" for name, value in values.items())
    return marked(problem, f"answers:\n  {part}:\n{lines}")[part]


def words(part):
    return {name: str(each.verdict) for name, each in part.answers.items()}


@pytest.mark.parametrize("form", FIRST)
def test_either_companion_form_is_right_where_none_is_named(form):
    usual = part_of(plant(form), "open", LAST[form])
    assert set(words(usual).values()) == {"correct"}
    assert not any(each.note for each in usual.answers.values())
    other = part_of(plant(form), "open", FIRST[form])
    assert set(words(other).values()) == {"correct"}
    assert {name: each.note for name, each in other.answers.items()} == dict.fromkeys("ABC", FIRST_ROW) | {"D": ""}
    assert other.marks == other.out_of > 0


@pytest.mark.parametrize("form", FIRST)
def test_only_the_convention_that_is_named_is_right(form):
    assert set(words(part_of(plant(form), "named", LAST[form])).values()) == {"correct"}
    other = part_of(plant(form), "named", FIRST[form])
    assert words(other) == dict.fromkeys("ABC", "wrong") | {"D": "correct"}


def test_a_part_follows_one_convention():
    first, last = FIRST["controllable"], LAST["controllable"]
    mostly_last = words(part_of(plant("controllable"), "open", {**last, "C": first["C"]}))
    assert mostly_last == {"A": "correct", "B": "correct", "C": "wrong", "D": "correct"}
    mostly_first = part_of(plant("controllable"), "open", {**first, "A": last["A"]})
    assert words(mostly_first) == {"A": "wrong", "B": "correct", "C": "correct", "D": "correct"}
    assert mostly_first.answers["A"].reason.startswith("it follows the other convention")


def test_a_slip_within_the_other_convention_costs_itself_only():
    found = part_of(plant("controllable"), "open", {**FIRST["controllable"], "C": "[1, -3]"})
    assert words(found) == {"A": "correct", "B": "correct", "C": "wrong", "D": "correct"}


def test_a_later_part_goes_on_with_the_students_own_form():
    values = FIRST["controllable"]
    lines = "".join(f"    {name}: {value}\n" for name, value in values.items())
    own = "  later: {controllability_matrix: [[1, -3], [0, 1]], determinant: 1}\n"
    later = marked(plant("controllable"), f"answers:\n  open:\n{lines}{own}")["later"]
    assert words(later) == {"controllability_matrix": "correct", "determinant": "correct"}
    assert later.answers["controllability_matrix"].follows


def test_ones_of_a_chain_stand_on_either_side():
    found = part_of(JORDAN, "open", ABOVE)
    assert set(words(found).values()) == {"correct"}
    assert found.answers["A"].note == "it follows another usual convention, “convention: superdiagonal”"
    assert words(part_of(JORDAN, "named", ABOVE))["A"] == "wrong"


def test_a_cost_may_have_either_factor_where_none_is_named():
    half, whole = {"P": P, "cost": "sqrt(3)/2"}, {"P": P, "cost": "sqrt(3)"}
    assert words(part_of(COST, "open", half)) == words(part_of(COST, "open", whole))
    found = part_of(COST, "open", whole)
    assert words(found) == {"P": "correct", "cost": "correct"}
    assert found.marks == 2
    assert found.answers["cost"].note == "it follows another usual convention, “cost_factor: 1”"
    assert words(part_of(COST, "open", {"P": P, "cost": "2sqrt(3)"}))["cost"] == "wrong"
    assert words(part_of(COST, "half", whole)) == {"P": "correct", "cost": "wrong"}
    assert words(part_of(COST, "whole", half)) == {"P": "correct", "cost": "wrong"}


def test_a_cost_by_the_other_factor_follows_from_the_own_solution():
    wrong = "[[sqrt(5), 1], [1, sqrt(3)]]"
    found = part_of(COST, "open", {"P": wrong, "cost": "sqrt(5)"})
    assert words(found) == {"P": "wrong", "cost": "correct"}
    assert found.answers["cost"].follows
    note = "it follows another usual convention, “cost_factor: 1”; right with your own P of part open"
    assert found.answers["cost"].note == note


def test_the_convention_is_told_in_german():
    german = part_of(plant("controllable", "language: de"), "open", FIRST["controllable"])
    assert german.answers["A"].note == "nach einer anderen üblichen Konvention, „convention: first_row“"


STEP = """
title: A step response
system: {transfer_function: "9/(s^2 + 3s + 9)"}
find:
  open: {task: step_specifications, method: response}
"""


def test_two_options_have_each_their_convention():
    """A band of 5 % and an overshoot in per cent: each is right, and each value says which convention is its own."""
    found = part_of(STEP, "open", {"settling_time": "1.76", "overshoot": "16.3", "peak_time": "1.21"})
    assert set(words(found).values()) == {"correct"}
    assert "settling_band: 5%" in str(found.answers["settling_time"].note)
    assert "overshoot_in: percent" in str(found.answers["overshoot"].note)
    assert "convention" not in str(found.answers["peak_time"].note)


def test_what_no_convention_makes_right_is_wrong():
    """What is right by none stays wrong, whatever is right beside it."""
    found = part_of(STEP, "open", {"settling_time": "9.9", "overshoot": "16.3"})
    assert words(found) == {"settling_time": "wrong", "overshoot": "correct"}
