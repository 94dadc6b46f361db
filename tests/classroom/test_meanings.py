"""What a wrong value would mean is told in the student's terms, and never our answer."""

import pytest
import sympy as sp

from solver.classroom.mistakes.equalities import broken
from solver.derivation import Check, CheckStatus, Claim
from solver.numeric import check_claim
from solver.stated.algebra import product
from solver.tasks.told import Told, short, spectrum, told
from solver.words import formula
from tests.helpers.marked import marked, solved

pytestmark = pytest.mark.xdist_group("meanings")  # its problem is solved once

PLANT = """
title: Meanings
language: {language}
system: {{A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}}
find:
  gain: {{task: pole_placement, poles: ["-3 ± 2j"]}}
  observer: {{task: observer, poles: [-4, -5]}}
  servo: {{task: servo, poles: [-1, -2, -3]}}
  lqr: {{task: lqr, Q: [[1, 0], [0, 1]], R: 1}}
  eigen: eigenstructure
  polynomial: characteristic_polynomial
  Phi: state_transition_matrix
  samples: {{task: state_transition_matrix, system: {{A: [[0, 1], [-2, -3]], time: discrete}}}}
  G: transfer_function
  response: {{task: response, kind: complete, input: "1", initial_state: [1, 0]}}
  second: {{task: desired_poles, overshoot: "14%", settling_time: 2}}
  range: {{task: stability_range, system: {{A: [[0, 1, 0], [0, 0, 1], ["-K", -2, -3]]}}}}
  lyapunov: {{task: stability, method: lyapunov}}
  reduced: {{task: reduced_observer, poles: [-4]}}
  tracking: {{task: reference_tracking, poles: [-1, -2]}}
  costly: {{task: lqr, Q: [[1, 0], [0, 1]], R: 1, initial_state: [0, 1], cost_factor: 1}}
  routh: {{task: stability, method: routh, system: {{A: [[0, 1, 0], [0, 0, 1], [-4, -3, -2]]}}}}
  tabled: {{task: routh_hurwitz, system: {{polynomial: "s^3 + 3s^2 + 2s + K"}}, parameter: K}}
  chained: {{task: eigenstructure, system: {{A: [[3, 1, 0], [0, 3, 0], [0, 0, 2]]}}}}
  cubed: {{task: matrix_function, function: "A^3"}}
  feedback: {{task: observer_feedback, poles: [-4, -5], observer_poles: [-8, -9]}}
  hidden: {{task: stabilizability, system: {{A: [[-1, 0], [0, -2]], B: [1, 0]}}}}
"""

TOLD = [
    ("gain", "K", "[11, 4]", r"with your $K_f$ the poles are $-3.5 \pm 0.866j$; asked were $-3 \pm 2j$"),
    ("gain", "K", "[10, 5]", r"with your $K_f$ the poles are $-6,\ -2$; asked were $-3 \pm 2j$"),
    ("gain", "closed_loop_A", "[[0, 1], [-12, -8]]",
     r"with your $A - BK_f$ the poles are $-6,\ -2$; asked were $-3 \pm 2j$"),
    ("gain", "polynomial", "s^2 + 8s + 12", r"its roots are $-6,\ -2$; asked were $-3 \pm 2j$"),
    ("observer", "L", "[5, 0]", r"with your $L_c$ the poles are $-4 \pm j$; asked were $-5,\ -4$"),
    ("servo", "closed_loop_A", "[[0, 1, 0], [-2, -3, 1], [-1, 0, 0]]",
     r"with your $\bar{A} - \bar{B}\bar{K}$ the poles are $-2.325,\ -0.3376 \pm 0.5623j$; asked were $-3,\ -2,\ -1$"),
    ("reduced", "L", "[[3]]", r"with your $L_c$ the poles are $-6$; asked were $-4$"),
    ("reduced", "J", "[[-3]]", r"with your $J$ the poles are $-3$; asked were $-4$"),
    ("tracking", "K", "[1, 1]", r"with your $K_f$ the poles are $-3,\ -1$; asked were $-2,\ -1$"),
    ("lqr", "K", "[-3, 0]", r"with your $K_f$ the poles are $-3.303,\ 0.3028$: that is not asymptotically stable"),
    ("costly", "K", "[1, 1]",
     r"with your $K_f$ the loop is stable, with the poles $-3,\ -1$, but from $x(0) = \begin{bmatrix}0\\1\end{bmatrix}$"
     r" the cost with the factor $1$ before it is $J = \frac{1}{3}$; the least is $J^{*} = 0.2361$"),
    ("servo", "K", "[10, 4]", r"with your $K_f$ the poles add up to $-7$, whatever the gain of the integrator is;"
     " those asked for add up to $-6$"),
    ("routh", "array", "[[1, 3], [2, 5], [1, 0], [4, 0]]",
     "the entry in row 2, column 2, $5$, is the first that does not follow from the coefficients"),
    ("routh", "array", "[[1, 3], [2, 4], [3, 0], [4, 0]]",
     "the entry in row 3, column 1, $3$, is the first that does not follow from the two rows above it"),
    ("tabled", "array", "[[1, 2], [3, K], [6 + K, 0], [K, 0]]",
     "the entry in row 3, column 1, $K + 6$, is the first that does not follow from the two rows above it"),
    ("chained", "jordan_form", "[[3, 0, 0], [0, 3, 0], [0, 0, 2]]",
     r"for $\lambda = 3$ its rank $\operatorname{rank}(J - \lambda I)$ is $1$;"
     r" $\operatorname{rank}(A - \lambda I)$ is $2$"),
    ("chained", "jordan_form", "[[3, 1, 1], [0, 3, 0], [0, 0, 2]]", "a Jordan form has zeros off the diagonal and the"
     " entries above it; in row 1, column 3 stands $1$"),
    ("cubed", "F", "[[6, 7], [-14, -14]]",
     "a function of $A$ commutes with $A$; with yours, $AF$ and $FA$ have $-14$ and $-15$ in row 1, column 2"),
    ("feedback", "closed_loop_A", "[[0, 1, 0, 0], [-20, -9, 18, 6], [0, 0, -14, 1], [0, 0, -30, -4]]",
     r"with your $A_{\text{closed}}$ the poles are $-9 \pm 2.236j,\ -5,\ -4$; asked were $-9,\ -8,\ -5,\ -4$"),
    ("eigen", "eigenvalues", "[-1, 3]", r"$3$ is no eigenvalue: there $\det(\lambda I - A) = 20$, not $0$"),
    ("eigen", "eigenvalues", "[-1, -1]", r"their sum is $-2$; that of the eigenvalues is the trace, $-3$"),
    ("eigen", "eigenvalues", "[-1]", "$A$ has $2$ eigenvalues, each as often as its multiplicity; these are $1$"),
    ("eigen", "right_eigenvectors", "[[1, 1], [-1, 2]]",
     r"column 2 is $v = \begin{bmatrix}1\\2\end{bmatrix}$, and $Av = \begin{bmatrix}2\\-8\end{bmatrix}$ is no multiple"
     " of it"),
    ("eigen", "left_eigenvectors", "[[1, 3], [1, 1]]",
     r"row 1 is $m = \begin{bmatrix}1 & 3\end{bmatrix}$, and $mA = \begin{bmatrix}-6 & -8\end{bmatrix}$ is no multiple"
     " of it"),
    ("polynomial", "polynomial", "lambda^2 + 3lambda + 1", r"at $\lambda = 1$ it is $5$, not $6$"),
    ("Phi", "Phi", "[[1, t], [0, 2]]", r"at $t = 0$ it is $\begin{bmatrix}1 & 0\\0 & 2\end{bmatrix}$, not $I$"),
    ("Phi", "Phi", "[[1, t], [0, 1]]",
     r"its derivative at $t = 0$ is $\begin{bmatrix}0 & 1\\0 & 0\end{bmatrix}$, not $A$"),
    ("samples", "Phi", "[[1, k], [0, 1]]", r"at $k = 1$ it is $\begin{bmatrix}1 & 1\\0 & 1\end{bmatrix}$, not $A$"),
    ("G", "G", "1/(s + 1)", r"at $s = 1$ it is $\frac{1}{2}$, not $\frac{1}{6}$"),
    ("G", "poles", "[-1, -4]", r"at $s = -4$ the transfer function is $\frac{1}{6}$: that is no pole"),
    ("response", "x", "[[2], [0]]",
     r"at $t = 0$ it is $\begin{bmatrix}2\\0\end{bmatrix}$; the initial state is $\begin{bmatrix}1\\0\end{bmatrix}$"),
    ("response", "x", "[[1 + t], [t]]",
     r"it fails the check “$\dot{x} = A x + B u$”: at $t = 1$ in row 2, column 1 the sides are $1$ and $-6$"),
    ("response", "y", "2 - exp(-t)/3", r"at $t = 0$ it is $\frac{5}{3}$, not $1$"),
    ("second", "poles", '["-2 ± 3j"]', "with these poles the overshoot is $0.1231$; asked was $0.14$"),
    ("range", "condition", "0 < K < 8", r"$K = 7$ fulfils it, but there the eigenvalues $0.04337 \pm 1.505j$ do not lie"
     " in the left half plane"),
    ("range", "condition", "0 < K < 4", r"$K = 4$ does not fulfil it, but there all eigenvalues, $-2.796,\ -0.1018 \pm"
     r" 1.192j$, lie in the left half plane"),
    ("lyapunov", "P", "[[1, 0], [0, 1]]",
     "it fails the check “$P$ put into Lyapunov's equation”: in row 1, column 1 the sides are $0$ and $-1$"),
    ("hidden", "hidden_modes", "[-3]", r"$-3$ is no eigenvalue: there $\det(\lambda I - A) = 2$, not $0$"),
]  # fmt: skip


def verdict(part, name, value, language="en"):
    value = value if value.startswith("[") else f'"{value}"'
    text = f"answers: {{{part}: {{{name}: {value}}}}}"
    return marked(PLANT.format(language=language), text)[part].answers[name]


@pytest.mark.parametrize(("part", "name", "value", "words"), TOLD)
def test_a_wrong_value_is_told_by_what_it_would_mean(part, name, value, words):
    found = verdict(part, name, value)
    assert (found.verdict, found.mistake) == ("wrong", "")
    assert found.reason == words


@pytest.mark.parametrize(("part", "name", "value", "words"), TOLD)
def test_our_answer_is_never_in_it(part, name, value, words):
    ours = next(result.answers[name] for result in solved(PLANT.format(language="en")).parts if result.id == part)
    assert isinstance(ours, list) or formula(ours) not in words


@pytest.mark.parametrize(("name", "value"), [each[1:3] for each in TOLD if each[0] in ("gain", "polynomial")])
def test_it_is_told_in_german(name, value):
    part = "polynomial" if "lambda" in value else "gain"
    said = verdict(part, name, value, "de").reason
    assert not {"with", "your", "the", "asked", "were", "roots", "not"} & set(said.replace("$", " ").split())


def test_beside_a_mistake_it_is_a_note():
    found = verdict("gain", "K", "[3, 11]")
    assert (found.mistake, found.reason) == ("reversed", "the entries stand in reverse order")
    assert found.note == r"with your $K_f$ the poles are $-13.63,\ -0.3668$; asked were $-3 \pm 2j$"


def test_an_equality_in_which_the_value_stands_alone_is_not_told():
    A, right, wrong = sp.ImmutableMatrix([[1, 2], [3, 4]]), sp.ImmutableMatrix([1, 2]), sp.ImmutableMatrix([1, 3])
    alone = check_claim(Claim(product(A, right), wrong), "$A x$")
    within = check_claim(Claim(product(A, wrong), sp.ImmutableMatrix([5, 11])), "$A x = b$")
    assert alone.status is within.status is CheckStatus.FAILED
    assert broken([alone], wrong) is None
    assert str(broken([alone, within], wrong)) == (
        "it fails the check “$A x = b$”: in row 1, column 1 the sides are $7$ and $5$"
    )


def test_a_check_that_passed_keeps_no_sides():
    A = sp.ImmutableMatrix([[1, 2], [3, 4]])
    passed: Check = check_claim(Claim(product(A, A), sp.ImmutableMatrix(A * A)), "$A^2$")
    assert (passed.status, passed.sides) == (CheckStatus.PASSED, None)


@pytest.mark.parametrize(
    ("number", "shown"),
    [
        (sp.Rational(7, 3), sp.Rational(7, 3)),
        (sp.Float("0.333333333333333333", 30), sp.Rational(1, 3)),
        (sp.sqrt(2), sp.Float("1.414", 15)),
        (sp.Rational(1, 97), sp.Float("0.01031", 15)),
        (sp.Integer(10) ** 7, sp.Float("1e7", 15)),
        (sp.Integer(-3) + 2 * sp.I, -3 + 2 * sp.I),
        (sp.Rational(1, 2) + sp.sqrt(2) * sp.I, sp.Float("0.5", 15) + sp.Float("1.414", 15) * sp.I),
        (sp.Symbol("K"), sp.Symbol("K")),
        (sp.oo, sp.oo),
    ],
)
def test_numbers_are_exact_where_they_are_short(number, shown):
    assert short(number) == shown


@pytest.mark.parametrize(
    ("rows", "found"),
    [([], []), ([[-3]], [Told(-3)]), ([[0, 1], [-13, -6]], [Told(-3, 2)]), ([[sp.Symbol("K")]], None)],
)
def test_the_eigenvalues_of_a_matrix_of_any_size_are_told(rows, found):
    assert spectrum(sp.ImmutableMatrix(len(rows), len(rows), [x for row in rows for x in row])) == found


def test_pairs_are_told_as_one_in_rising_order():
    roots = [sp.Integer(1), -3 - 2 * sp.I, sp.Integer(-5), -3 + 2 * sp.I, sp.I]
    assert told(roots) == [Told(-5), Told(-3, 2), Told(sp.I), Told(1)]


def test_matrices_of_another_transfer_function_are_told_by_its_value():
    text = "system: {transfer_function: '(s+3)/(s^2+3s+2)'}\nfind: {a: {task: realization, form: controllable}}"
    answers = "answers: {a: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [3, 2]}}"
    found = marked(text, answers)["a"].answers
    assert "wrong" in [str(each.verdict) for each in found.values()]
    told = [each.reason for each in found.values()] + [each.note for each in found.values()]
    assert any(r"with your $A$, $B$, $C$, at $s = 1$ the transfer function is $\frac{5}{6}$" in each for each in told)


@pytest.mark.parametrize(
    ("numerator", "D", "words"),
    [
        ("s + 3", "", r"$C$, at $s = 1$ the transfer function is $\frac{5}{6}$, not $\frac{2}{3}$"),
        ("s + 3", ", D: 0", r"$C$, at $s = 1$ the transfer function is $\frac{5}{6}$, not $\frac{2}{3}$"),
        ("s + 3", ", D: 1", r"$C$ and $D = G(\infty)$, at $s = 1$ the transfer function is $\frac{5}{6}$, not"),
        ("s^2 + 4s + 5", ", D: 1", r"$C$ and $D = G(\infty)$, at $s = 1$ the transfer function is $\frac{11}{6}$, not"),
        ("s^2 + 4s + 5", ", D: 0", r"$C$ and $D = G(\infty)$, at $s = 1$ the transfer function is $\frac{11}{6}$, not"),
    ],
)
def test_the_direct_path_in_the_figure_is_named_and_never_a_wrong_one(numerator, D, words):
    text = f"""
system: {{transfer_function: '({numerator})/(s^2+3s+2)'}}
find: {{a: {{task: realization, form: controllable}}}}
"""
    found = marked(text, f"answers: {{a: {{A: [[0, 1], [-2, -3]], B: [0, 1], C: [3, 2]{D}}}}}")["a"].answers["C"]
    assert words in found.reason + found.note


@pytest.mark.parametrize(
    ("cost", "words"),
    [
        ("7.348", r"the cost with the factor $1$ before it is $J = 12.73$; the least is $J^{*} = 7.348$"),
        ("3.674", r"the cost is $J = 6.364$; the least is $J^{*} = 3.674$"),
    ],
)
def test_a_factor_that_is_taken_over_from_the_cost_is_told_of_the_gain(cost, words):
    # with K = [9, 3√2] the Lyapunov equation gives X = [[9√2, 5], [5, 7√2/3]]: xᵀXx = 9√2 = 12.73 from (1, 0)
    text = """
system: {A: [[0, 1], [0, 0]], B: [0, 1], C: [1, 0]}
find: {e: {task: lqr, output_weight: 9, R: 1, initial_state: [1, 0]}}
"""
    found = marked(text, f"answers: {{e: {{K: [9, 4.243], cost: {cost}}}}}")["e"].answers
    assert found["cost"].verdict == "correct"
    assert words in found["K"].reason + found["K"].note


def test_both_gains_of_a_loop_are_named_with_its_poles():
    answers = "answers: {servo: {K: [10, 4], k_I: 6}}"
    found = marked(PLANT.format(language="en"), answers)["servo"].answers["K"]
    assert found.reason.startswith("with your $K_f$ and $k_I$ the poles are")
    in_german = marked(PLANT.format(language="de"), answers)["servo"].answers["K"]
    assert in_german.reason.startswith("mit Ihrem $K_f$ und $k_I$ sind die Pole")


@pytest.mark.parametrize("value", ["1.00001 exp(-t)", "[[1.00002, 0], [0, 1]]"])
def test_what_is_told_alike_is_not_told_apart(value):
    part, name = ("Phi", "Phi") if value.startswith("[") else ("response", "y")
    assert "it is $1.0$" not in verdict(part, name, value).reason


def test_a_term_that_is_left_out_is_no_intermediate_result():
    found = marked(PLANT.format(language="en"), "answers: {polynomial: {polynomial: lambda^2 + 2}}")["polynomial"]
    assert (found.answers["polynomial"].mistake, found.answers["polynomial"].reason) == ("term", "a term is missing")


def test_roots_of_any_multiplicity_are_told():
    """Roots of multiplicity three did not converge in 30 digits."""
    system = "{A: [[0, 1, 0], [0, 0, 1], [1, -1, -2]], B: [0, 1, 0]}"
    problem = f"title: Triple\nsystem: {system}\nfind: {{a: {{task: pole_placement, poles: [-1, -1, -1]}}}}"
    found = marked(problem, "answers: {a: {polynomial: (s - 2)^3}}")["a"].answers["polynomial"]
    assert found.reason == r"its roots are $2,\ 2,\ 2$; asked were $-1,\ -1,\ -1$"
