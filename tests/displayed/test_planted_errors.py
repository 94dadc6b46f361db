"""Errors planted in what a page displays turn `verified` into `failed`, wherever they stand."""

import pytest
import sympy as sp

from solver.derivation import CheckStatus, Claim, PartResult, Status, Step
from solver.derivation.displayed import FIRST_MARK, STANDS, Displayed, Written
from solver.displayed import displayed_checks
from solver.displayed.statements import chains_in
from solver.problem.model import Part
from solver.render.wording import WordedStep
from solver.stated.matrices import determinant
from solver.systems import StateSpace

s, t, p = sp.symbols("s t p")
A, B, C = sp.ImmutableMatrix([[0, 1], [-2, -3]]), sp.ImmutableMatrix([0, 1]), sp.ImmutableMatrix([[1, 0]])
K = sp.ImmutableMatrix([[4, 2]])
PHI = sp.ImmutableMatrix((A * t).exp())
CHI = s**2 + 3 * s + 2
RESOLVENT = sp.ImmutableMatrix((s * sp.eye(2) - A).inv())
BORDERED = sp.ImmutableMatrix([[0, 1, 0], [-2, -3, 1], [-1, 0, 0]])
MARK = chr(FIRST_MARK)


def eq(*sides, relation="="):
    """A display; a text is LaTeX as it stands."""
    return Displayed(tuple(Written(side) if isinstance(side, str) else side for side in sides), relation)


def text(latex, *values):
    """A formula in worded Markdown with values printed in it."""
    return Displayed((Written(latex, values),))


def checks_of(*displayed, answers=None, symbols=None):
    """The checks of a step that displays these formulas."""
    step = WordedStep("Title", "", (), Step("kind", unclaimed="a test"), (), displayed)
    result = PartResult("a", "task", "method", Status.VERIFIED, {"K": K, **(answers or {})})
    part = Part("a", "task", ("method",), StateSpace(A, B, C))
    return displayed_checks(result, [step], part, {"K": "K_f", **(symbols or {})})


RIGHT = {
    "left side of a macro": [eq(r"\det(sI - A)", CHI)],
    "claim with a prefix": [eq(r"\det A", determinant(A), sp.Integer(2))],
    "block in Markdown": [text(r"AB = " + MARK, A * B)],
    "inline formula": [text(r"\operatorname{tr}A = -3")],
    "name of an answer": [eq("K_f", K)],
    "name with and without braces": [eq("K_{f}", K)],
    "name of the step": [eq("T", A), eq("T^{-1}", A.inv())],
    "name of another step": [eq("N", B), eq("AN", A * B)],
    "closed loop": [eq("A - BK_f", A - B * K)],
    "rows aligned": [text(r"\begin{aligned}x_{1} &= 1 \\ x_{1} + 1 &= 2\end{aligned}")],
    "resolvent": [eq("(sI - A)^{-1}", RESOLVENT)],
    "transfer function": [eq("G(s)", "C(sI - A)^{-1}B", (C * RESOLVENT * B)[0])],
    "inverse transform": [eq(r"\Phi(t)", r"\mathcal{L}^{-1}\left\{(sI - A)^{-1}\right\}", PHI)],
    "exponential": [eq("e^{At}", PHI)],
    "value at zero": [eq(r"\Phi(t)", PHI), text(r"\Phi(0) = I")],
    "function of a matrix": [eq(r"\hat{p}(s)", CHI), text(r"\hat{p}(A) = 0")],
    "argument changed": [eq("p(s)", CHI), eq("p(-s)", s**2 - 3 * s + 2)],
    "block matrix": [
        eq(r"\begin{bmatrix}A & B \\ -C & 0\end{bmatrix}", sp.Matrix([[0, 1, 0], [-2, -3, 1], [-1, 0, 0]]))
    ],
    "identity in a block": [eq(r"\begin{bmatrix}I \\ K_f\end{bmatrix}", sp.Matrix([[1, 0], [0, 1], [4, 2]]))],
    "transposed": [eq("C^{T}", C.T)],
    "transposed identity": [eq("2A + I^{T}", 2 * A + sp.eye(2))],
    "adjugate": [eq(r"\operatorname{adj}A", sp.Matrix([[-3, -1], [2, 0]]))],
    "rank": [text(r"\operatorname{rank}\begin{bmatrix}B & AB\end{bmatrix} = 2")],
    "fraction": [text(r"\frac{1}{2}\operatorname{tr}A = -\frac{3}{2}")],
    "numbers": [text("3 - 2 = 1")],
    "chain": [text(r"r = 2 < 3 = n,\qquad r + 1 = n")],
    "arrow": [text(r"u = 1 \quad\Rightarrow\quad u + 1 = 2")],
    "power": [eq("A^{2}", A**2)],
    "power of a symbol": [eq(sp.Symbol("A") ** 2, A**2)],
    "integral": [eq(r"\int_{0}^{1} C^{T}C\,t\,dt", C.T * C / 2)],
    "sum": [eq(r"\sum_{k=0}^{1} A^{k}BB^{T}(A^{T})^{k}", B * B.T + A * B * B.T * A.T)],
    "roots and powers": [text(r"\omega = 2,\qquad \sigma = 1,\qquad \sqrt{\sigma^{2} + \omega^{2}} = \sqrt{5}")],
    "trigonometric": [text(r"\beta = 1,\qquad \sin^{2}\beta + \cos^{2}\beta = 1")],
    "absolute value": [text(r"\mu = -2,\qquad |\mu| = 2")],
    "complex": [text(r"(1 + 2j)(1 - 2j) = 5")],
    "zero": [eq("A - A", sp.zeros(2, 2)), text("AB - AB = 0")],
    "unknowns found": [eq("K_f", sp.Matrix([sp.symbols("k1 k2")])), eq(sp.Symbol("k1") + 1, sp.Integer(5))],
    "decimals": [eq(r"\det(sI - A)", s**2 + sp.Float("3.0", 30) * s + 2)],
    "another meaning": [eq("A", A), eq("A", A + B * C, relation=STANDS), eq(r"\det(sI - A)", s**2 + 3 * s + 1)],
    "two signs": [eq("K_f", "-K_f + 2K_f")],
    "quotient of names": [text(r"a = 6,\qquad b = 3,\qquad a/b = 2")],
    "primes and accents": [eq(r"\bar{A}", A), eq(r"\bar{A}B", A * B)],
    "partial sums": [eq("A + A^{2}", A + A**2)],
    "product of written values": [text(MARK + chr(FIRST_MARK + 1) + " = AB", A, B)],
}
"""Displays that hold, by the place where an error is planted in the next table."""


def planted(displayed):
    """The same displays with an error in the last of them: a number changed, a sign turned, an entry moved."""
    *before, last = displayed
    sides = last.sides
    if len(sides) == 1:  # the last digit of the LaTeX, or the value printed in it
        written = sides[0]
        if written.values:
            values = (corrupted(written.values[0]), *written.values[1:])
            return [*before, Displayed((Written(written.latex, values),))]
        place = max(i for i, letter in enumerate(written.latex) if letter.isdigit() or letter == "I")
        changed = "7" if written.latex[place] != "I" else "A"
        return [*before, Displayed((Written(written.latex[:place] + changed + written.latex[place + 1 :]),))]
    right = sides[-1]
    wrong = Written(right.latex.replace("2", "3")) if isinstance(right, Written) else corrupted(right)
    return [*before, Displayed((*sides[:-1], wrong), last.relation)]


def corrupted(value):
    """A value that is wrong by a thousandth, in every entry of a matrix."""
    if not isinstance(value, sp.MatrixBase):
        return value + sp.Rational(1, 1000)
    return sp.ImmutableMatrix(value + sp.ones(*value.shape) / 1000)


@pytest.mark.parametrize("place", RIGHT)
def test_what_holds_passes(place):
    checks = checks_of(*RIGHT[place])
    assert all(check.status is CheckStatus.PASSED for check in checks), checks


@pytest.mark.parametrize("place", RIGHT)
def test_an_error_planted_there_fails(place):
    assert any(check.status is CheckStatus.FAILED for check in checks_of(*planted(RIGHT[place])))


def test_there_are_forty_places():
    assert len(RIGHT) >= 40


def test_the_answer_is_the_value_of_its_name():
    error = {"answers": {"e": sp.oo}, "symbols": {"e": r"e_{\text{ramp}}"}}
    right, wrong = (checks_of(eq(r"e_{\text{ramp}}", value), **error) for value in (sp.oo, sp.Integer(0)))
    assert [check.status for check in (*right, *wrong)].count(CheckStatus.FAILED) == 1
    assert all(check.status is not CheckStatus.FAILED for check in right)


def test_one_name_has_one_value_in_all_steps_of_a_part():
    steps = [
        WordedStep("Title", "", (), Step("kind", unclaimed="a test"), (), (each,)) for each in (eq("T", A), eq("T", B))
    ]
    result = PartResult("a", "task", "method", Status.VERIFIED, {})
    (check,) = displayed_checks(result, steps, Part("a", "task", ("method",), StateSpace(A)), {})
    assert check.status is CheckStatus.FAILED


RELATIONS = {
    "1 < 2": "2 < 1",
    "2 > 1": "1 > 1",
    r"1 \le 1": r"2 \le 1",
    r"2 \ge \sqrt{2}": r"1 \ge \sqrt{2}",
    r"1 \ne 2": r"1 \ne 1",
    r"AB \ne B": r"AB \ne AB",
    r"\sqrt{2} \approx 1.414": r"\sqrt{2} \approx 1.415",
    r"\operatorname{tr}A = -3 < 0": r"\operatorname{tr}A = -3 > 0",
    r"\operatorname{rank}A = 2 = 1 + 1 < 3": r"\operatorname{rank}A = 2 = 1 + 1 > 3",
    r"\begin{aligned}x_{1} &= 1 + 1 \\ &= 2\end{aligned}": r"\begin{aligned}x_{1} &= 1 + 1 \\ &= 3\end{aligned}",
    r"-1 < 0 < 1": r"-1 < 0 < -1",
    r"2 < \infty": r"\infty < 2",
}
"""Relations that hold, and the same that do not."""


@pytest.mark.parametrize(("right", "wrong"), RELATIONS.items())
def test_relations_of_numbers_are_judged(right, wrong):
    held = checks_of(text(right))
    assert held
    assert all(check.status is CheckStatus.PASSED for check in held)
    assert any(check.status is CheckStatus.FAILED for check in checks_of(text(wrong)))


@pytest.mark.parametrize("condition", [r"k > 0", r"|\lambda| < 1", r"t \ge 0", r"x \ne 0", r"p + 1 > 0"])
def test_a_relation_with_symbols_is_a_condition(condition):
    assert all(check.status is CheckStatus.PASSED for check in checks_of(text(condition)))


@pytest.mark.parametrize("formula", [r"1 = 1 + \cdots", r"A = f(1, 2)", "3! = 6"])
def test_what_is_not_read_is_counted(formula):
    (check,) = checks_of(text(formula))
    assert check.status is CheckStatus.SKIPPED
    assert check.reason.startswith("a display is not evaluated: ")


def test_conditions_and_laws_are_no_claims():
    law = text(r"\dot{x} = Ax + Bu,\qquad y = Cx"), text(r"t = 0"), text(r"\operatorname{Re}\lambda = 0")
    assert checks_of(*law) == ()


def test_a_claim_is_not_checked_twice():
    step = Step("kind", claims={"value": Claim(determinant(A), sp.Integer(2))})
    worded = WordedStep("Title", "", (), step, (), (eq(determinant(A), sp.Integer(2)),))
    result = PartResult("a", "task", "method", Status.VERIFIED, {})
    assert displayed_checks(result, [worded], Part("a", "task", ("method",), StateSpace(A)), {}) == ()


@pytest.mark.parametrize("latex", [r"1 + \cdots", r"x!", r"\frac{d}{ds}G", r"\lim x"])
def test_what_is_not_read_is_refused_with_the_reason(latex):
    assert chains_in(latex)[0].sides[0].refusal
