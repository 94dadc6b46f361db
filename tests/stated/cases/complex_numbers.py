"""Formulas of `solver.stated.complex_numbers`: what they are equal to, and how they are printed."""

import sympy as sp

from solver.stated.algebra import quotient
from solver.stated.complex_numbers import (
    absolute,
    arctangent,
    argument,
    conjugate,
    imaginary_part,
    norm,
    phase,
    real_part,
)
from tests.stated.values import M, a, m, s

RIGHT = [
    (real_part(quotient(1, 1 + sp.I * a)), 1 / (1 + a**2)),
    (imaginary_part(quotient(1, 1 + sp.I * a)), -a / (1 + a**2)),
    (real_part(sp.Matrix([[sp.I, 2 + sp.I]])), sp.Matrix([[0, 2]])),
    (conjugate(quotient(1, 1 + sp.I * a)), 1 / (1 - sp.I * a)),
    (absolute(quotient(2, 1 + sp.I * a)), 2 / sp.sqrt(1 + a**2)),
    (absolute(sp.exp(sp.I * a)), 1),
    (argument(quotient(1, 1 + sp.I * a)), -sp.atan(a)),
    (argument(-1 - sp.I), -3 * sp.pi / 4),
    (argument(-2), sp.pi),
    (phase(quotient(1, 1 + sp.I * sp.sqrt(3))), -60),
    (phase(quotient(1, -1 + sp.I)), -135),
    (arctangent(-sp.sqrt(3)), -60),
    (arctangent(quotient(a, 1)), 180 * sp.atan(a) / sp.pi),
    (norm(sp.Matrix([3, 4 * sp.I])), 5),
    (norm(sp.Matrix([[3, a]])), sp.sqrt(9 + a**2)),
    (norm(M), sp.sqrt(15 + sp.sqrt(221))),
    (norm(M, "1"), 6),
    (norm(M, "oo"), 7),
    (norm(sp.Matrix([[3, -4 * sp.I], [1, 1]]), "oo"), 7),
    (norm(sp.Matrix([[3, -4], [0, 5 * a]]), "F"), 5 * sp.sqrt(1 + a**2)),
    (norm(sp.Matrix([3, -4, 0]), "oo"), 4),
    (norm([3, -4, 12]), 13),
]

PRINTED = [
    (real_part(s), r"\operatorname{Re}(s)"),
    (imaginary_part(quotient(1, s)), r"\operatorname{Im}\left(\frac{1}{s}\right)"),
    (conjugate(s + 1), r"\overline{s + 1}"),
    (absolute(s + 1), r"\left|s + 1\right|"),
    (argument(s), r"\operatorname{arg}(s)"),
    (phase(s), r"\angle(s)"),
    (arctangent(2), r"\arctan(2)"),
    (norm(M), rf"\left\|{m}\right\|"),
    (norm(M, "1"), rf"\left\|{m}\right\|_{{1}}"),
    (norm(M, "oo"), rf"\left\|{m}\right\|_{{\infty}}"),
    (norm(M, "F"), rf"\left\|{m}\right\|_{{F}}"),
]
