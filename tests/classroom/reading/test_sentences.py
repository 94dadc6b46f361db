"""Values within sentences, chains of equalities, laws, pieces of functions; what denies them is not read."""

import pytest

from solver.classroom.reading.control_laws import gain_of, law_of
from solver.classroom.reading.piecewise import as_steps
from solver.classroom.reading.sentences import concluded, sides_of, with_true_signs, without_words
from tests.helpers.marked import verdict

GAIN = "{system: {A: [[0, 1], [0, 0]], B: [0, 1]}, find: {a: {task: pole_placement, poles: [-2, -3]}}}"  # K = [6, 5]
MODES = "{find: {a: {task: eigenstructure, system: {matrix: [[0, 1], [6, 1]]}}}}"  # −2, 3
PULSE = """
find:
  a: {task: response, kind: zero_state, input: step(t) - step(t-1), system: {transfer_function: 1/(s+1)}}
"""
FIRST = "{find: {a: {task: transfer_function, system: {A: [[-3]], B: [2], C: [1]}}}}"
STEP = "{find: {a: {task: response, kind: zero_state, input: 1, system: {transfer_function: 6/(s+3)}}}}"
SPACES = "{find: {a: {task: fundamental_subspaces, matrix: [[1, 2], [2, 4]], system: {matrix: [[1, 2], [2, 4]]}}}}"
POINTS = """
find:
  a: {task: equilibrium_points, system: {equations: ["x1' = x2", "x2' = 4 x1 - x1^3"]}}
"""


def said(problem, name, text):
    return str(verdict(problem, "a", name, f"'{text.replace(chr(39), chr(39) * 2)}'").verdict)


@pytest.mark.parametrize(
    "text",
    [
        "u = -6 x1 - 5 x2", "u = -(6x1 + 5x2)", "u = -[6 5] x", "u = r - [6, 5]x", "u(t) = -6x_1(t) - 5x_2(t)",
        "K = [k1 k2] = [6 5]", "K = place(A, B, [-2 -3]) = [6 5]", "k1 = 6, k2 = 5", "k1 is 6 and k2 is 5",
        "k2 = 5, 2 k1 = 12 → K = [6 5]", "u = -Kx, K = [6, 5]", "The gain is [6, 5]", "[6 5]",
    ],
)  # fmt: skip
def test_a_gain_in_all_its_forms_is_right(text):
    assert said(GAIN, "K", text) == "correct"


@pytest.mark.parametrize(
    "text",
    [
        "u = 6 x1 + 5 x2", "u = -6 x1 + 5 x2", "u = -[5 6] x", "u = r + [6 5]x", "u = -6x1 - 5x2 - x1",
        "u = Kx, K = [6, 5]", "-K = [6 5]", "2K = [6 5]", "K/2 = [6 5]", "The gain is not K = [6, 5]", "not [6 5]",
        "K = [5 6] = [6 5]", "L = [6 5]",
    ],
)  # fmt: skip
def test_another_gain_or_one_that_is_denied_is_never_right(text):
    assert said(GAIN, "K", text) != "correct"


@pytest.mark.parametrize(
    "text",
    ["The eigenvalues are 3 and -2.", "λ_1 = -2 and λ_2 = 3", "-2 (stable), 3 (unstable)",
     "Die Eigenwerte sind 3 und -2",
     "λ₁ = 3 > 0, λ₂ = -2 < 0", "(λ+2)(λ-3) = 0 => λ = -2, 3", "λ_{1,2} = -2, 3"],
)  # fmt: skip
def test_eigenvalues_in_a_sentence_are_right(text):
    assert said(MODES, "eigenvalues", text) == "correct"


@pytest.mark.parametrize("text", ["The eigenvalues are not 3 and -2.", "neither 3 nor -2", "λ₁ = 3 < 0, λ₂ = -2 < 0"])
def test_eigenvalues_that_are_denied_are_never_right(text):
    assert said(MODES, "eigenvalues", text) != "correct"


@pytest.mark.parametrize(
    "text",
    [
        "1 - e^-t for 0 <= t < 1, (e - 1) e^-t for t >= 1", "1 - e^-t (0 < t < 1); e^(1-t) - e^-t (t > 1)",
        r"\begin{cases} 1-e^{-t} & 0\le t<1 \\ (e-1)e^{-t} & t\ge 1\end{cases}",
        "Piecewise((1 - exp(-t), t < 1), (exp(1-t) - exp(-t), True))",
        "0 for t < 0, 1 - e^-t for 0 ≤ t < 1, (e - 1)e^-t for t ≥ 1",
    ],
)  # fmt: skip
def test_a_function_in_pieces_is_right(text):
    assert said(PULSE, "y", text) == "correct"


@pytest.mark.parametrize(
    "text",
    [
        "1 - e^-t for 0 <= t < 1, (1 - e) e^-t for t >= 1", "1 - e^-t for 0 <= t < 2, (e - 1) e^-t for t >= 2",
        "1 - e^-t for t < 1", "Piecewise((1 - exp(-t), t > 1), (exp(1-t) - exp(-t), True))",
    ],
)  # fmt: skip
def test_other_pieces_are_never_right(text):
    assert said(PULSE, "y", text) != "correct"


@pytest.mark.parametrize("text", ["s G(s) = 2/(s+3)", "G(-s) = 2/(s+3)", "1/G = 2/(s+3)", "G(s)/2 = 2/(s+3)"])
def test_what_is_labelled_as_another_function_is_never_right(text):
    assert said(FIRST, "G", text) != "correct"


@pytest.mark.parametrize("text", ["y'(t) = 2 - 2e^-3t", "y(2t) = 2 - 2e^-3t", "y_dot = 2 - 2e^-3t"])
def test_a_derivative_or_another_time_is_never_right(text):
    assert said(STEP, "y", text) != "correct"


def test_the_beginning_is_not_the_end():
    assert said(STEP, "y_final", "y(0) = 2") != "correct"
    assert said(STEP, "y_final", "y(∞) = 2") == said(STEP, "y_final", "lim_{t→∞} y(t) = 2") == "correct"


@pytest.mark.parametrize(
    ("name", "text", "right"),
    [
        ("null_space", "[[-0.89442719], [0.4472136]]", True),
        ("null_space", "[[-0.89443], [0.44721]]", True),
        ("null_space", "[[-0.8944], [0.4471]]", False),
        ("column_space", "[[0.447], [0.8945]]", True),
        ("column_space", "[[0.447], [0.896]]", False),
        ("null_space", "x = c [2; -1]", True),
        ("null_space", "x = c [2; 1]", False),
    ],
)
def test_rounded_vectors_of_a_space(name, text, right):
    assert (said(SPACES, name, text) == "correct") == right


@pytest.mark.parametrize(
    ("text", "right"),
    [
        ("x1 = 0, ±2; x2 = 0", True), ("{(0, 0), (2, 0), (-2, 0)}", True), ("(0|0), (2|0), (-2|0)", True),
        ("P1 = (0,0), P2 = (2,0), P3 = (-2,0)", True), ("x1 ∈ {0, 2, -2}, x2 = 0", True),
        ("x1 = 0 or x1 = ±2, x2 = 0", True), ("x1 ∈ {2, -2}, x2 = 0", False), ("x1 = 0, ±2; x2 = 1", False),
    ],
)  # fmt: skip
def test_points_in_all_their_forms(text, right):
    assert (said(POINTS, "points", text) == "correct") == right


def test_the_pieces_of_these_readers():
    assert gain_of("u = -[18 6] x") == "[18 6]"
    assert gain_of("u = 18 x1") == "[-(((18)))]"
    assert gain_of("v = -[18 6] x") == law_of("u = -K x") == ""
    assert as_steps("2 for t < 1") == as_steps("f for t < 1, g for t > 2") == as_steps("1 + t") == ""
    assert concluded("2 + k = 5 ⇒ k = 3") == "k = 3"
    assert sides_of("K is not K = 3") == sides_of("a = 1, b = 2") == []
    assert with_true_signs("λ = 1 < 0") == ""
    assert without_words("at most 2", "rank") != "2"
    assert without_words("about 2", "rank", count=True) == ""
