"""Which answers become fields: laid out in which form, right by our own marking, wrong where usual mistakes lead."""

from decimal import Decimal
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.classroom.verdicts import Verdict
from solver.papers.export import fields as exported
from solver.papers.export.decimals import unit_of
from solver.papers.export.quiz import Choice, Fixed, Number
from tests.papers.banks.making import bench_of, items_of

GAIN = """\
title: Gains
system: {A: [[0, 1], [1, 3]], B: [0, 3]}
partial: {K: {sign: 1}}
find:
  a: {task: pole_placement, poles: [-1, -2], answers: [K, polynomial], marks: {K: 4, polynomial: 1}}
"""


def laid_out(asked):
    """The lines as text: LaTeX, and the values of fields in brackets."""
    return [" ".join(cell.latex if isinstance(cell, Fixed) else f"[{cell.value}]" for cell in line)
            for line in asked.lines]  # fmt: skip


def only(text, name="a"):
    """The only answer of a part with fields."""
    (asked,) = items_of(text)[name].answers
    return asked


def test_a_gain_is_a_grid_and_a_polynomial_its_coefficients():
    item = items_of(GAIN)["a"]
    gain, polynomial = item.answers
    assert item.marks == 5
    assert (gain.name, gain.grid, gain.whole, gain.marks) == ("K", True, False, 4)
    assert laid_out(gain) == ["[1] [2]"]
    assert (polynomial.grid, polynomial.whole, polynomial.marks) == (False, True, 1)
    assert laid_out(polynomial) == [r"\hat{p} = s^{2} + [3] s + [2]"]
    assert [each.label for each in gain.fields] == ["K, row 1, column 1", "K, row 1, column 2"]
    assert len({each.key for each in item.fields}) == 4
    assert [each.marks for each in item.fields] == [2, 2, Fraction(1, 2), Fraction(1, 2)]


def test_a_named_mistake_earns_its_share_with_its_words():
    first = next(iter(items_of(GAIN)["a"].answers[0].fields))
    sign = first.wrong[0]
    assert (sign.value, sign.share) == (Decimal(-1), Fraction(3, 4))
    assert sign.hint == "It is the gain of $A + BK_f$; the feedback is subtracted, $A - BK_f$."
    assert all(each.share == 0 for each in first.wrong if each.hint != sign.hint)
    assert any(each.value == Decimal("0.5") and "factor 2" in each.hint for each in first.wrong)


@pytest.mark.parametrize(
    ("rule", "shares"), [("", {0}), ("partial: none", {0}), ("partial: named", {0, Fraction(1, 2)})]
)
def test_the_share_of_a_mistake_is_what_marking_leaves(rule, shares):
    asked = items_of(GAIN.replace("partial: {K: {sign: 1}}", rule))["a"].answers[0]
    assert {wrong.share for each in asked.fields for wrong in each.wrong} | {0} == shares | {0}
    assert asked.whole == (rule == "partial: none")


def test_each_wrong_value_is_wrong_by_our_marking_and_named_as_it_names_it():
    bench, parts = bench_of(GAIN)
    asked = items_of(GAIN)["a"].answers[0]
    columns = [{wrong.hint: wrong.value for wrong in each.wrong} for each in asked.fields]
    shared = [hint for hint in columns[0] if all(hint in column for column in columns)]
    assert len(shared) >= 2
    for hint in shared:
        found = bench.verdict((parts["a"], "K"), f"[{', '.join(str(column[hint]) for column in columns)}]")
        assert found.verdict is Verdict.WRONG
        assert hint.rstrip(".").lower() == bench.blank.messages.told(found.reason).lower()


SPECTRUM = "system: {A: %s}\nfind: {a: {task: eigenstructure, answers: [eigenvalues]}}\n"


def test_a_spectrum_is_asked_for_in_ascending_order():
    asked = only("title: t\n" + SPECTRUM % "[[3, 0], [0, -1]]")
    assert laid_out(asked) == [r"\lambda_{1} = [-1] + [0] j", r"\lambda_{2} = [3] + [0] j"]
    assert asked.form.startswith("In these fields the values stand in ascending order, each as often as it counts.")


def test_complex_values_have_two_fields_each():
    asked = only("title: t\n" + SPECTRUM % "[[0, 1, 0], [-5, -2, 0], [0, 0, -7]]")
    values = [str(each.value) for each in asked.fields]
    assert values == ["-7", "0", "-1", "-2", "-1", "2"]
    assert laid_out(asked)[1].endswith("[-1] + [-2] j")
    assert "real parts" in asked.form


def test_a_transfer_function_is_asked_for_in_a_normal_form():
    text = """\
title: t
system: {A: [[0, 1], [-8, -6]], B: [0, 3], C: [2, 1]}
find: {a: {task: transfer_function, answers: [G]}}
"""
    asked = only(text)
    assert laid_out(asked) == [r"G = \frac{b}{a},\quad b = [3]", "a = s + [4]"]
    assert asked.whole
    assert "lowest terms" in asked.form


@pytest.mark.parametrize(
    ("find", "lines"),
    [
        ("{task: stability_range, parameters: [K]}", ["[0] < K < [6]"]),
        ("{task: routh_hurwitz, parameter: K, answers: [condition]}", ["[0] < K < [6]"]),
    ],
)
def test_bounds_of_a_parameter_are_fields(find, lines):
    text = f'title: t\nsystem: {{transfer_function: "K/(s^3 + 3s^2 + 2s + K)"}}\nfind: {{a: {find}}}\n'
    assert laid_out(only(text)) == lines


def test_verdicts_and_words_are_choices_and_infinity_is_a_number():
    text = """\
title: t
system: {transfer_function: "1/(s+1)"}
find:
  a: {task: stability, answers: [verdict, bibo_stable]}
  b: {task: stability_margins, answers: [gain_margin]}
"""
    items = items_of(text)
    verdict, stable = items["a"].fields
    assert isinstance(verdict, Choice)
    assert isinstance(stable, Choice)
    assert verdict.words[verdict.right] == "asymptotically stable"
    assert stable.words == ("yes", "no")
    (margin,) = items["b"].fields
    assert isinstance(margin, Number)
    assert (margin.typed, margin.tolerance) == ("999999", 0)


def test_points_of_which_the_number_is_asked_for_are_an_essay():
    text = """\
title: t
system: {equations: ["x1' = x2", "x2' = x1 - x1^2"], states: [x1, x2], inputs: []}
find: {a: equilibrium_points}
"""
    assert items_of(text)["a rest"].essay.reasons == {"points": exported.HOW_MANY}


def test_a_convention_that_the_file_leaves_open_is_stated():
    text = """\
title: t
system: {transfer_function: "4/(s^2+2s+4)"}
find:
  a: {task: step_specifications, answers: [settling_time]}
  b: {task: step_specifications, answers: [settling_time], settling_band: 5%}
"""
    items = items_of(text)
    assert items["a"].answers[0].form == "It is told in s. The settling band is 2%."
    assert items["b"].answers[0].form == "It is told in s."


def test_an_angle_is_asked_for_in_a_range():
    text = """\
title: t
system: {transfer_function: "1/(s(s+1)(s+2))"}
find: {a: {task: root_locus, answers: [asymptote_angles]}}
"""
    asked = only(text)
    assert [str(each.value) for each in asked.fields] == ["-60", "60", "180"]
    assert "above -180 and at most 180" in asked.form
    assert all(-180 < wrong.value <= 180 for each in asked.fields for wrong in each.wrong)


def test_a_sequence_keeps_its_order():
    text = """\
title: t
find: {a: {task: inverse_z_transform, method: long_division, F: "z/(z + 1/2)", terms: 3}}
"""
    asked = only(text)
    assert [str(each.value) for each in asked.fields] == ["1", "-0.5", "0.25"]
    assert asked.form == "In these fields the values stand in their order."


@pytest.mark.parametrize(
    ("find", "name", "why"),
    [
        ("{task: eigenstructure, answers: [right_eigenvectors]}", "right_eigenvectors", "several values are right"),
        ("{task: state_transition_matrix, answers: [Phi]}", "Phi", "it is a function"),
        ("{task: response, kind: zero_input, initial_state: [1, 0], answers: [x]}", "x", "it is a function"),
        ("{task: pole_placement, poles: [p, -1], answers: [K]}", "K", "it is a formula in letters"),
        ("{task: eigenstructure, answers: [jordan_form]}", "jordan_form", "its form is what is asked"),
        ("{task: realization, form: modal, answers: [A]}", "A", "several values are right"),
    ],
)
def test_what_has_no_unique_value_is_an_essay_that_says_why(find, name, why):
    text = f"title: t\nsystem: {{A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}}\nfind: {{a: {find}}}\n"
    item = items_of(text)["a rest"]
    assert not item.answers
    assert item.essay.reasons[name].startswith(why)
    assert item.essay.key.blocks


def test_a_part_with_both_is_two_items():
    text = """\
title: t
system: {A: [[0, 1], [-2, -3]]}
find:
  a: {task: eigenstructure, marks: {eigenvalues: 2, right_eigenvectors: 3}}
"""
    items = items_of(text)
    assert [(name, each.marks) for name, each in items.items()] == [("a", 2), ("a rest", 3)]
    for each in items.values():
        assert any("Here only this is asked" in block.markdown for block in each.question.blocks)


def test_a_part_that_goes_on_from_another_one_asks_it_again():
    text = """\
title: t
system: {A: [[0, 1], [0, 0]], B: [0, 1]}
find:
  a: {task: pole_placement, poles: [-1, -2]}
  b: {task: reference_tracking, gain: {from: a}, system: {A: [[0, 1], [0, 0]], B: [0, 1], C: [1, 0]}}
"""
    blocks = [block.markdown for block in items_of(text)["b"].question.blocks]
    assert "*Part (a), from which this part goes on, asks:*" in blocks
    assert any("poles at" in each for each in blocks)


def test_a_value_that_our_marking_refuses_never_goes_out(monkeypatch):
    monkeypatch.setattr(exported, "typed", lambda number, _digits: str(float(number) + 0.3))
    item = items_of(GAIN)["a rest"]
    assert set(item.essay.reasons.values()) == {exported.NOT_OURS}


EDGES = """\
title: Edges
digits: 3
system: {A: [[0, 1], [-1, -1]], B: [0, 7]}
find: {a: {task: pole_placement, poles: [-2, -3]}}
"""


@pytest.fixture(scope="module")
def edges():
    bench, parts = bench_of(EDGES)
    return bench, parts["a"], items_of(EDGES)["a"].fields


@settings(max_examples=25, deadline=None)
@given(st.integers(-3, 3), st.sampled_from([0, 1]))
def test_the_edges_of_the_tolerance_are_those_of_our_marking(edges, steps, place):
    bench, part, found = edges
    field: Number = found[place]
    unit = unit_of(Fraction(field.value), part.digits)
    texts = [each.typed for each in found]
    texts[place] = str(Decimal(field.typed) + steps * Decimal(unit.numerator) / unit.denominator)
    verdict = bench.verdict((part, "K"), f"[{', '.join(texts)}]")
    is_within = abs(Decimal(texts[place]) - field.value) <= field.tolerance
    assert is_within == (steps == 0)
    assert (verdict.verdict is Verdict.CORRECT) == is_within
