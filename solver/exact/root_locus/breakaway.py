"""Where poles of a loop meet: multiple roots of D + K N, roots of N D' − N' D at which K is real and not negative."""

from __future__ import annotations

from dataclasses import dataclass

import mpmath
import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.fields import Algebraic
from solver.exact.linear_algebra.instances import element_at
from solver.exact.root_locus.equation import (
    WORKING_DIGITS,
    LocusEquation,
    PlacedRoot,
    element_of,
    quotient_at,
    roots_with_factors,
    value_of,
)

TINY = sp.Float(10) ** -20


@dataclass(frozen=True)
class Meeting:
    """A candidate s with K = −D/N there (None at a zero of L) and the number of branches that meet if it `belongs`.

    `why` says why it does not belong, or is special: "", "zero", "negative", "complex", "pole" (K = 0).
    """

    point: PlacedRoot
    gain: sp.Expr | None
    branches: int
    why: str

    @property
    def belongs(self) -> bool:
        """Whether branches meet there for a gain K ≥ 0."""
        return self.why in ("", "pole")


def turning_polynomial(equation: LocusEquation) -> sp.Poly:
    """N D' − N' D."""
    N, D = equation.numerator, equation.denominator
    return N * D.diff() - N.diff() * D


def meetings(equation: LocusEquation) -> tuple[Meeting, ...]:
    """All roots of N D' − N' D with their gains, those that belong to the locus told from the others."""
    return tuple(_meeting(equation, each) for each in roots_with_factors(turning_polynomial(equation)))


def _meeting(equation: LocusEquation, at: PlacedRoot) -> Meeting:
    N, D = equation.numerator, equation.denominator
    if not element_of(N, at):
        return Meeting(at, None, at.multiplicity + 1, "zero")
    if not element_of(D, at):
        return Meeting(at, sp.Integer(0), at.multiplicity + 1, "pole")
    element = -quotient_at(D, N, at)
    value = value_of(element, at)
    if not at.real and not _is_real(element, at):
        return Meeting(at, value, at.multiplicity + 1, "complex")
    gain = value if at.real else _real_part(element, at)
    negative = sp.N(gain, WORKING_DIGITS) < 0
    return Meeting(at, gain, at.multiplicity + 1, "negative" if negative else "")


def _real_part(element: Algebraic, at: PlacedRoot) -> sp.Expr:
    value = value_of(element, at)
    found: sp.Expr = value.as_real_imag()[0]
    return found


def _is_real(element: Algebraic, at: PlacedRoot) -> bool:
    """Whether an element of K[x]/(p), K real, is real at a root that is not.

    Then it has the same value at two roots of p, so its characteristic polynomial has a multiple root.
    """
    if not any(element.coefficients[1:]):
        return True
    if element.modulus.degree <= 2 or _has_simple_conjugates(element):
        return False
    with mpmath.workdps(WORKING_DIGITS):
        value = sp.N(element_at(element, at.root), WORKING_DIGITS)
    return bool(abs(sp.im(value)) <= TINY * (1 + abs(value)))


def _has_simple_conjugates(element: Algebraic) -> bool:
    d, K = element.modulus.degree, element.modulus.domain
    basis = [Algebraic([K.one if i == j else K.zero for i in range(d)], element.modulus) for j in range(d)]
    columns = [(element * e).coefficients for e in basis]
    matrix = DomainMatrix([[columns[j][i] for j in range(d)] for i in range(d)], (d, d), K)
    return bool(sp.Poly(matrix.charpoly(), sp.Dummy("x"), domain=K).is_sqf)
