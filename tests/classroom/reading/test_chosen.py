"""Of several readings of a value the only right one counts; otherwise it is not judged, with all of them."""

import re

import pytest
import sympy as sp

from solver.resources import root
from tests.helpers.marked import marked
from tests.helpers.reading import read

PLANT = """
system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}
find:
  a: {task: pole_placement, poles: [-3, -4]}
  b: eigenstructure
  c: state_transition_matrix
  d: characteristic_polynomial
  e: transfer_function
  f: stability
  g: controllability
  h: {task: response, kind: zero_input, initial_state: [1, 0]}
"""
PHI = "[[2e^-t - e^-2t, e^-t - e^-2t], [-2e^-t + 2e^-2t, {}]]"


def submitted(part, name, value):
    """The verdict of a value that stands on a line of its own."""
    return marked(PLANT, f"answers:\n  {part}:\n    {name}: {value}\n")[part].answers[name]


@pytest.mark.parametrize(
    ("part", "name", "value"),
    [
        ("a", "K", "[10 4]"),
        ("a", "K", "(10, 4)"),
        ("a", "K", "[[10], [4]]"),
        ("a", "K", "[10; 4]"),
        ("a", "K", "K_f = [10, 4]"),
        ("a", "K", r"\begin{pmatrix} 10 & 4 \end{pmatrix}"),
        ("a", "K", "np.array([[10., 4.]])"),
        ("a", "polynomial", "s^2 + 7s + 12 = 0"),
        ("a", "polynomial", "[1 7 12]"),
        ("b", "eigenvalues", "{-1, -2}"),
        ("b", "eigenvalues", "-1, -2"),
        ("b", "eigenvalues", "[-1 -2]"),
        ("b", "eigenvalues", r"'\lambda_1 = -1, \lambda_2 = -2'"),
        ("c", "Phi", PHI.format("-e^-t + 2e^-2t")),
        ("c", "Phi", "'[2e^-t-e^-2t e^-t-e^-2t; -2e^-t+2e^-2t -e^-t+2e^-2t]'"),
        ("d", "polynomial", "s² + 3s + 2"),
        ("d", "polynomial", "[1, 3, 2]"),
        ("e", "G", "G(s) = 1/(s^2 + 3s + 2)"),
        ("e", "G", "tf(1, [1 3 2])"),
        ("e", "G", r"\frac{1}{s^{2}+3s+2}"),
        ("e", "G", "2/2 (s^2 + 3s + 2)^-1"),
        ("f", "verdict", "Asymptotically stable."),
        ("g", "controllable", "ja"),
        ("h", "y", "y(t) = 4/2 e^(-t) - e^-2t"),
        ("h", "y", "(2e^-t - e^-2t) u(t)"),
        ("h", "y", "(2e^-t - e^-2t) σ(t)"),
        ("h", "y", "'y(t) = 2e^-t - e^-2t, t >= 0'"),
        ("h", "y", "2e^-t - e^-2t for t > 0"),
        ("h", "x", "[2e^-t - e^-2t; -2e^-t + 2e^-2t]"),
        ("a", "K", "K_1 = 10, K_2 = 4"),
        ("a", "K", "k2 = 4; k1 = 10"),
    ],
)
def test_a_right_value_is_right_in_the_forms_that_students_write(part, name, value):
    found = submitted(part, name, value)
    assert (found.verdict, found.reason) == ("correct", "")


@pytest.mark.parametrize(
    ("part", "name", "value"),
    [
        ("a", "K", "[10 -4]"),
        ("a", "K", "[4 10]"),
        ("a", "polynomial", "[12 7 1]"),
        ("b", "eigenvalues", "[-1 - 2]"),
        ("b", "eigenvalues", "{1, 2}"),
        ("c", "Phi", PHI.format("-e^-t + 3e^-2t")),
        ("d", "polynomial", "s^2 + 3s - 2 = 0"),
        ("e", "G", "tf([1 3 2], 1)"),
        ("e", "G", "1/s^2+3s+2"),
        ("f", "verdict", "unstable."),
        ("g", "controllable", "not controllable"),
    ],
)
def test_a_wrong_value_is_wrong_in_these_forms_too(part, name, value):
    assert submitted(part, name, value).verdict == "wrong"


@pytest.mark.parametrize(
    ("part", "name", "value", "words"),
    [
        ("f", "verdict", "oscillating", "no such word"),
        ("a", "K", "L = [10, 4]", "it is labelled L, and K is asked for"),
        ("a", "K", "polynomial = [10, 4]", "it is labelled polynomial"),
        ("g", "rank", "2 dB", "the unit dB is not read"),
    ],
)
def test_what_is_not_clear_is_not_judged(part, name, value, words):
    found = submitted(part, name, value)
    assert found.verdict == "not judged"
    assert words in found.reason


@pytest.mark.parametrize(("part", "name", "value"), [("e", "G", "1/2 s"), ("h", "y", "1/3 e^(-t)")])
def test_what_is_wrong_in_both_readings_is_not_judged_and_both_are_told(part, name, value):
    found = submitted(part, name, value)
    assert found.verdict == "not judged"
    assert re.search(r"may be read as \$.*\$ or as \$.*\$, and neither is right", found.reason)


def test_the_reading_that_counts_is_the_one_that_is_kept():
    found = submitted("h", "y", "4/2 e^(-t) - e^(-2t)")
    assert (found.respelt, str(found.value)) == (True, "2*exp(-t) - exp(-2*t)")


def test_one_value_of_several_readings_costs_the_others_nothing():
    found = marked(PLANT, "answers: {h: {y: 1/3 e^(-t), x: ['2e^-t - e^-2t', '-2e^-t + 2e^-2t']}}")["h"].answers
    assert [found["y"].verdict, found["x"].verdict] == ["not judged", "correct"]


def test_the_values_of_a_flow_mapping_may_hold_commas():
    found = marked(PLANT, "answers: {b: {eigenvalues: -1, -2, diagonalizable: yes}, a: {K: (10, 4)}}")
    assert found["b"].answers["eigenvalues"].verdict == "correct"
    assert found["b"].answers["diagonalizable"].verdict == "correct"
    assert found["a"].answers["K"].verdict == "correct"


@pytest.mark.parametrize(
    ("kind", "ours"),
    [
        ("number", sp.Symbol("a")), ("complex", [sp.Symbol("a")]), ("polynomial", sp.Symbol("s") ** 2 + sp.Symbol("s")),
        ("list", [sp.Symbol("a"), sp.Symbol("b")]), ("function", sp.Symbol("t")),
        ("step", sp.Heaviside(sp.Symbol("t"))),
        ("transfer", 1 / sp.Symbol("s")), ("matrix", sp.ones(2)), ("row", sp.ones(1, 2)), ("trivial", sp.ones(2)),
    ],
)  # fmt: skip
def test_what_the_page_for_students_shows_is_read(kind, ours):
    lines = documented_lines(kind)
    assert lines
    for text in re.findall(r"`([^`]+)`", lines):
        if "…" not in text:
            found = read(f'"{text}"' if "'" in text else f"'{text}'", ours)
            assert found.others == (), text


def documented_lines(kind):
    """What stands in the second column of the table beside a kind."""
    text = (root("templates").parent / "docs" / "writing-answers.md").read_text(encoding="utf-8")
    return next(line.split(" | ")[1] for line in text.splitlines() if line.startswith(f"| {kind}"))
