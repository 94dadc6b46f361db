"""Formulas of `solver.stated.algebra`: what they are equal to, and how they are printed."""

import sympy as sp
from sympy import Rational

from solver.stated.algebra import difference, exponential, power, product, quotient, total
from solver.stated.matrices import adjugate, determinant, partitioned, trace
from tests.stated.values import ADJ, CAPITAL, CHI, PHI, POWER, A, F, M, a, alpha_0, alpha_1, k, m, s, t, x

RIGHT = [
    (product(A, A), sp.Matrix([[-2, -3], [6, 7]])),
    (product(sp.Matrix([[1, a]]), sp.Matrix([3, 1])), 3 + a),
    (product(2, A, sp.Matrix([1, a])), sp.Matrix([2 * a, -4 - 6 * a])),
    (total(A, sp.eye(2), 3 * sp.eye(2)), sp.Matrix([[4, 1], [-2, 1]])),
    (difference(product(s, sp.eye(2)), A), F),
    (quotient(ADJ, CHI), ADJ / CHI),
    (quotient(adjugate(F), determinant(F)), ADJ / CHI),
    (power(A, 3), A**3),
    (power(A, -1), A.inv()),
    (power(A, 0), sp.eye(2)),
    (power(A, k), POWER),
    (power(a, 3), a**3),
    (power(x + 1, sp.Rational(1, 2)), sp.sqrt(x + 1)),
    (exponential(A * t), PHI),
    (exponential(product(A, t)), PHI),
    (exponential(sp.I * a), sp.cos(a) + sp.I * sp.sin(a)),
    (exponential(sp.zeros(2)), sp.eye(2)),
]

PRINTED = [
    (product(2, partitioned(M, (1,), ())), r"2\left[\begin{array}{cc}1 & 2 \\ \hline 3 & 4\end{array}\right]"),
    (power(M, 3), rf"{m}^{{3}}"),
    (power(CAPITAL, 0), "I"),
    (power(CAPITAL, 1), "A"),
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
    (product(total(CAPITAL, M), M), rf"\left(A + {m}\right){m}"),
    (product(), "1"),
    (total(M, product(-2, M)), f"{m} - 2{m}"),
    (total(2, -3, product(-1, a), s), "2 - 3 - a + s"),
    (total(product(alpha_0, power(CAPITAL, 0)), product(alpha_1, power(CAPITAL, 1))), r"\alpha_0I + \alpha_1A"),
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
    (exponential(product(a, t)), "e^{at}"),
    (exponential(product(M, t)), rf"\exp\left({m}t\right)"),
]
