"""Formulas as stated: every operation, with parentheses where they are needed and signs that merge."""

import pytest
import sympy as sp
from sympy import Integer, Rational, exp, eye, oo

from solver.formula import MathProblem, read
from solver.render.latex import tex
from solver.stated import every_operation
from solver.stated.algebra import difference, exponential, power, product, quotient, total
from solver.stated.calculus import derivative, integral, summation, value_at
from solver.stated.matrices import adjugate, determinant, inverse, partitioned, rank, trace, transpose
from solver.stated.transforms import inverse_laplace, inverse_z

s, z, t, k, a, alpha_0, alpha_1, A = sp.symbols("s z t k a alpha_0 alpha_1 A")
M = sp.ImmutableMatrix([[1, 2], [3, 4]])
m = r"\begin{bmatrix}1 & 2 \\ 3 & 4\end{bmatrix}"
I2 = r"\begin{bmatrix}1 & 0 \\ 0 & 1\end{bmatrix}"

TABLE = [
    (determinant(M), rf"\det{m}"),
    (determinant(difference(product(s, eye(2)), M)), rf"\det\left(s{I2} - {m}\right)"),
    (adjugate(M), rf"\operatorname{{adj}}{m}"),
    (partitioned(M, (1,), (1,)), r"\left[\begin{array}{c|c}1 & 2 \\ \hline 3 & 4\end{array}\right]"),
    (partitioned(M, (), (1,)), r"\left[\begin{array}{c|c}1 & 2 \\ 3 & 4\end{array}\right]"),
    (partitioned(M, (0, 2), (2,)), m),
    (product(2, partitioned(M, (1,), ())), r"2\left[\begin{array}{cc}1 & 2 \\ \hline 3 & 4\end{array}\right]"),
    (rank(M), rf"\operatorname{{rank}}{m}"),
    (trace(product(M, M)), rf"\operatorname{{tr}}\left({m}{m}\right)"),
    (inverse(M), rf"{m}^{{-1}}"),
    (inverse(difference(product(s, eye(2)), M)), rf"\left(s{I2} - {m}\right)^{{-1}}"),
    (transpose(M), rf"{m}^{{T}}"),
    (power(M, 3), rf"{m}^{{3}}"),
    (power(A, 0), "I"),
    (power(A, 1), "A"),
    (power(s + 1, 2), "(s + 1)^{2}"),
    (power(-2, 3), "(-2)^{3}"),
    (power(Rational(1, 2), k), r"\left(\frac{1}{2}\right)^{k}"),
    (product(2, 3), r"2 \cdot 3"),
    (product(2, Rational(1, 2)), r"2 \cdot \frac{1}{2}"),
    (product(1, M), m),
    (product(-1, M), f"-{m}"),
    (product(-1, s + 1), "-(s + 1)"),
    (product(-2, -3), "(-2)(-3)"),
    (product(s, s + 3), "s(s + 3)"),
    (product(-a, M), f"-a{m}"),
    (product(M, -2), f"{m}(-2)"),
    (product(M, M, M), f"{m}{m}{m}"),
    (product(total(A, M), M), rf"\left(A + {m}\right){m}"),
    (product(), "1"),
    (total(M, product(-2, M)), f"{m} - 2{m}"),
    (total(2, -3, product(-1, a), s), "2 - 3 - a + s"),
    (total(product(alpha_0, power(A, 0)), product(alpha_1, power(A, 1))), r"\alpha_0I + \alpha_1A"),
    (total(), "0"),
    (difference(s, -2), "s - (-2)"),
    (difference(s, a + 1), "s - (a + 1)"),
    (difference(product(s, s + 3), product(-1, 2)), "s(s + 3) - (-2)"),
    (
        difference(a, product(Rational(-1, 4), Rational(-1, 10))),
        r"a - \left(-\frac{1}{4}\right)\left(-\frac{1}{10}\right)",
    ),
    (quotient(M, s**2 + 1), rf"\frac{{1}}{{s^{{2}} + 1}}{m}"),
    (quotient(product(-1, trace(M)), 2), rf"-\frac{{1}}{{2}}\operatorname{{tr}}{m}"),
    (quotient(a, 1), "a"),
    (quotient(product(-1, a), 2), r"-\frac{a}{2}"),
    (exponential(-2 * t), "e^{-2t}"),
    (exponential(product(M, t)), rf"\exp\left({m}t\right)"),
    (inverse_laplace(1 / (s + 1), s, t), r"\mathcal{L}^{-1}\left\{\frac{1}{s + 1}\right\}"),
    (inverse_z(z / (z - 1), z, k), r"\mathcal{Z}^{-1}\left\{\frac{z}{z - 1}\right\}"),
    (derivative(exp(-t), t), r"\frac{d}{dt}e^{-t}"),
    (derivative(exp(-t) + 1, t), r"\frac{d}{dt}(1 + e^{-t})"),
    (derivative(M, t, 2), rf"\frac{{d^{{2}}}}{{dt^{{2}}}}{m}"),
    (derivative(exp(-t), t, 0), "e^{-t}"),
    (integral(exp(-t) + 1, t, Integer(0), oo), r"\int_{0}^{\infty}(1 + e^{-t})\,dt"),
    (summation(a + k, k, Integer(0), Integer(3)), r"\sum_{k = 0}^{3}(a + k)"),
    (value_at(s**2 + 1, s, Integer(-2)), r"\left.(s^{2} + 1)\right|_{s = -2}"),
    (value_at(derivative(M, t), t, Integer(0)), rf"\left.\frac{{d}}{{dt}}{m}\right|_{{t = 0}}"),
]


@pytest.mark.parametrize(("formula", "printed"), TABLE, ids=lambda item: str(item)[:60])
def test_formulas_are_printed_as_stated(formula, printed):
    assert tex(formula) == printed
    read(printed)


@pytest.mark.parametrize(
    "formula",
    [
        r"\hline",
        r"\begin{bmatrix}\hline 1 & 2\end{bmatrix}",
        r"\begin{array}{cc}1 & \hline 2\end{array}",
        r"\begin{array}{cc}1 & 2 \hline 3 & 4\end{array}",
    ],
)
def test_a_line_stands_only_at_the_start_of_a_row_of_an_array(formula):
    with pytest.raises(MathProblem, match="hline"):
        read(formula)


def test_every_operation_has_a_notation_and_a_row_in_the_table():
    assert set(every_operation()) == {formula.operation for formula, _ in TABLE}
