"""What formulas on a page mean: each is judged against the value computed here, and against one a little wrong."""

import pytest
import sympy as sp

from solver.derivation import CheckStatus
from solver.derivation.displayed import STANDS, Displayed, Written
from solver.displayed.sides import half_unit
from tests.displayed.test_planted_errors import CHI, PHI, RESOLVENT, A, B, C, K, checks_of, corrupted, eq, text

s, t = sp.symbols("s t")
I2 = sp.eye(2)
R = sp.Rational

VALUES = {
    "signs": ("-2 + 3 - 4", -3),
    "a sign in brackets": (r"2 - (3 - 4)", 3),
    "juxtaposed": (r"2(3)(4)", 24),
    "dots": (r"2 \cdot 3 \cdot 4", 24),
    "a slash": ("12/4/3", 1),
    "a slash after a product": (r"2 \cdot 6/4", 3),
    "a fraction and a factor": (r"\frac{6}{4}2", 3),
    "a power before its factor": ("2 \\cdot 3^{2}", 18),
    "a negative power": ("2^{-1}", R(1, 2)),
    "a power of brackets": ("(1 + 2)^{2}", 9),
    "a decimal": ("0.25 + 1.5", R(7, 4)),
    "a root": (r"\sqrt{16} + \sqrt{9}", 7),
    "bars": (r"|3 - 5|", 2),
    "tall bars": (r"\left|3 - 5\right| - 1", 1),
    "bars beside a factor": (r"2|-3|", 6),
    "a power of tall bars": (r"A\left|3\right|^{2}", 9 * A),
    "a power of brackets with a sum": (r"A(1 + 2)^{2}", 9 * A),
    "a function of what follows": (r"\cos 0 + 1", 2),
    "a function of brackets": (r"\sin(\pi/2) + 1", 2),
    "a power of a function": (r"\sin^{2}(\pi/6)", R(1, 4)),
    "functions side by side": (r"\sin\frac{\pi}{6}\cos\frac{\pi}{3}", R(1, 4)),
    "a function of a product": (r"\cos 2\pi", 1),
    "a logarithm": (r"\ln e^{3}", 3),
    "inverse functions": (r"\arccos 0 + \arctan 1", 3 * sp.pi / 4),
    "hyperbolic functions": (r"\cosh^{2}1 - \sinh^{2}1", 1),
    "real and imaginary part": (r"\operatorname{Re}(3 + 4j) + \operatorname{Im}(3 + 4j)", 7),
    "imaginary": ("j^{2}", -1),
    "an exponential of a number": (r"e^{-1}\exp(1)", 1),
    "a product of matrices": ("CAB", (C * A * B)[0]),
    "a matrix and numbers": ("2A - 3I", 2 * A - 3 * I2),
    "a number for its identity": ("A^{2} + 3A + 2", sp.zeros(2)),
    "a negative matrix": ("-A", -A),
    "an identity in a product": ("A(I - BC)", A * (I2 - B * C)),
    "an identity alone in brackets": ("(I)A", A),
    "an inverse": ("A^{-1}B", A.inv() * B),
    "a transpose of a product": ("(AB)^{T}", (A * B).T),
    "transposes": ("B^{T}A^{T}", (A * B).T),
    "a matrix over a number": (r"\frac{A}{2}", A / 2),
    "determinant of a sum": (r"\det(A + 2I)", (A + 2 * I2).det()),
    "trace, determinant, rank": (r"\operatorname{tr}A + 10\det A + 100\operatorname{rank}A", -3 + 20 + 200),
    "adjugate over determinant": (r"\frac{\operatorname{adj}A}{\det A}", A.inv()),
    "blocks in a row": (r"\begin{bmatrix}B & AB\end{bmatrix}", sp.Matrix.hstack(B, A * B)),
    "blocks in a column": (r"\begin{bmatrix}C \\ CA\end{bmatrix}", sp.Matrix.vstack(C, C * A)),
    "blocks with zeros": (
        r"\begin{bmatrix}A - BK_f & BK_f \\ 0 & A\end{bmatrix}",
        sp.Matrix(sp.BlockMatrix([[A - B * K, B * K], [sp.zeros(2), A]])),
    ),
    "blocks with an identity": (
        r"\begin{bmatrix}0 & I \\ C & 0\end{bmatrix}",
        sp.Matrix([[0, 0, 1, 0], [0, 0, 0, 1], [1, 0, 0, 0]]),
    ),
    "a row of units": (r"\begin{bmatrix}0 & \cdots & 0 & 1\end{bmatrix}A", sp.Matrix([[0, 1]]) * A),
    "a matrix of numbers": (r"\begin{bmatrix}1 & -2 \\ \frac{1}{2} & 0\end{bmatrix}B", sp.Matrix([-2, 0])),
    "the resolvent": ("C(sI - A)^{-1}B", (C * RESOLVENT * B)[0]),
    "a matrix exponential": (r"e^{At}B", PHI * B),
    "a value at": (r"\left[e^{-t}\right]_{t = 0}", 1),
    "an inverse transform": (r"\mathcal{L}^{-1}\left\{(sI - A)^{-1}B\right\}", PHI * B),
    "an integral": (r"\int_{0}^{1} 2t\,dt", 1),
    "an integral to infinity": (r"\int_{0}^{\infty} e^{-2t}\,dt", sp.Rational(1, 2)),
    "an integral of a matrix": (r"\int_{0}^{2} A\,dt", 2 * A),
    "a sum": (r"\sum_{k=1}^{3} k^{2}", 14),
    "a limit": (r"\lim_{t \to \infty}e^{-t} + 2", 2),
    "a limit of a quotient": (r"\lim_{s \to 0}\frac{s}{s^{2} + s}", 1),
    "the polynomial of a matrix": (r"\det(sI - A)", CHI),
}


@pytest.mark.parametrize("name", VALUES)
def test_a_formula_has_its_value_and_no_other(name):
    latex, value = VALUES[name]
    value = sp.ImmutableMatrix(value) if isinstance(value, sp.MatrixBase) else sp.sympify(value)
    for displayed in (eq(latex, value), eq(value, latex), eq("W", latex, value)):
        assert {check.status for check in checks_of(displayed)} <= {CheckStatus.PASSED}, latex
    assert CheckStatus.FAILED in {check.status for check in checks_of(eq(latex, corrupted(value)))}


UNREAD = {
    "a bar without a partner": "|3 + 2",
    "an operation nobody knows": r"2 \star 3",
    "a function nobody knows": r"\gcd(2, 3)",
    "a function of nothing": r"2\sin",
    "several arguments": "A(1, 2)",
    "a prime of a formula": "(1 + 2)'",
    "an index of a formula": "(1 + 2)_{3}",
    "an ellipsis": r"1 + \cdots + 5",
    "an integral without its variable": r"\int_{0}^{1} 2",
    "an integral without limits": r"\int 2\,dt",
    "an integral without beginning": r"\int_{-\infty}^{0} e^{t}\,dt",
    "an integral that does not converge": r"\int_{0}^{\infty} e^{t}\,dt",
    "a limit without its variable": r"\lim 3",
    "rows of different lengths": r"\begin{bmatrix}1 & 2 \\ 3\end{bmatrix}",
    "a transform of nothing": r"\mathcal{L}^{-1} 3",
    "a sign at the end": "2 +",
    "a name that stands for nothing, in brackets": "5(q)",
    "a value beside it": "A(q)",
}


@pytest.mark.parametrize("name", UNREAD)
def test_what_is_not_read_is_counted_and_never_passes(name):
    found = {check.status for check in checks_of(eq(UNREAD[name], sp.Integer(5)))}
    assert CheckStatus.PASSED not in found
    assert CheckStatus.FAILED not in found


RELATIONS = {
    "less": ("1 < 2", True),
    "less, not": ("2 < 2", False),
    "at most": (r"2 \le 2", True),
    "greater": (r"\operatorname{rank}A > 1", True),
    "greater, not": (r"\operatorname{rank}A > 2", False),
    "at least": (r"3 \ge 4", False),
    "different": (r"\det A \ne 0", True),
    "different, not": (r"\det A \ne 2", False),
    "nearly": (r"\pi \approx 3.142", True),
    "nearly, not": (r"\pi \approx 3.143", False),
    "nearly, more digits": (r"\sqrt{2} \approx 1.4142", True),
    "a chain": (r"1 < 2 = 2 < 3", True),
    "a chain, not": (r"1 < 2 = 2 < 1", False),
}


@pytest.mark.parametrize("name", RELATIONS)
def test_relations_between_formulas(name):
    latex, holds = RELATIONS[name]
    found = {check.status for check in checks_of(text(latex))}
    assert (CheckStatus.FAILED in found) != holds
    assert not holds or found <= {CheckStatus.PASSED}


def test_half_a_unit_in_the_last_place():
    assert half_unit(R(3142, 1000)) == pytest.approx(0.0005 / 3.142)
    assert half_unit(R(25)) == pytest.approx(0.5 / 25)
    assert half_unit(-R(25, 10)) == pytest.approx(0.05 / 2.5)
    assert half_unit(0) == half_unit(R(1, 3)) == half_unit(sp.pi) == 1e-9
    assert half_unit(sp.Float("3.1", 2)) > half_unit(sp.Float("3.1", 4)) > 1e-6


def test_a_name_of_a_function_is_the_function_at_any_argument():
    named = eq("G(s)", 1 / (s + 2))
    for displayed in (eq("G(0)", R(1, 2)), eq("G(2)", R(1, 4)), eq("G(-s)", 1 / (2 - s))):
        assert [check.status for check in checks_of(named, displayed)] == [CheckStatus.PASSED]
    for displayed in (eq("G(0)", R(1, 3)), eq("G(-s)", 1 / (2 + s)), eq("G(2)", R(1, 2))):
        assert [check.status for check in checks_of(named, displayed)] == [CheckStatus.FAILED]


def test_a_derivative_of_a_named_function():
    named = eq("p(s)", s**3 + 2 * s)
    assert checks_of(named, eq(r"\frac{dp}{ds}", 3 * s**2 + 2))[-1].status is CheckStatus.PASSED
    assert checks_of(named, eq(r"\frac{dp}{ds}", 3 * s**2))[-1].status is CheckStatus.FAILED


def test_a_name_stands_for_one_value_until_it_is_said_to_stand_for_another():
    first, other = Displayed((Written("W"), A), STANDS), Displayed((Written("W"), 2 * A), STANDS)
    assert {check.status for check in checks_of(first, eq("W", A), other, eq("W", 2 * A))} <= {CheckStatus.PASSED}
    assert CheckStatus.FAILED in {check.status for check in checks_of(first, eq("W", 2 * A))}
    assert CheckStatus.FAILED in {check.status for check in checks_of(first, other, eq("W", A))}
