"""Rational maps from s to z that stand for integration rules: Euler forwards and backwards, Tustin.

s = (z − 1)/h, (z − 1)/(h z), (z − 1)/(h (z + 1)) with h = T, T, T/2 (Åström, Wittenmark, Computer-Controlled Systems,
§8.2); prewarped h = tan(ωT/2)/ω, so that z = e^{jωT} belongs to s = jω.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.digital.fractions import content_of
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.linear_algebra.matrices import determinant, inverse, multiply
from solver.exact.linear_algebra.spectrum import Root, is_lower
from solver.exact.transforms.sampled import in_z

FORWARD, BACKWARD, TUSTIN = "forward_euler", "backward_euler", "tustin"


@dataclass(frozen=True)
class Rule:
    """A rule by its name, with its h."""

    name: str
    h: sp.Expr

    @property
    def marked(self) -> tuple[sp.Expr, dict[sp.Symbol, sp.Expr]]:
        """A value of h to calculate with, and what takes it back: a tangent is a symbol as long."""
        mark = sp.Dummy("h", positive=True)
        return (mark, {mark: self.h}) if self.h.has(sp.tan) else (self.h, {})

    def above(self, z: sp.Symbol) -> sp.Expr:
        """The numerator of s: always z − 1."""
        return z - 1

    def below(self, z: sp.Symbol) -> sp.Expr:
        """The denominator of s without h: 1, z or z + 1."""
        return {FORWARD: sp.S.One, BACKWARD: z, TUSTIN: z + 1}[self.name]

    def s(self, z: sp.Symbol) -> sp.Expr:
        """What stands for s."""
        return self.above(z) / (self.h * self.below(z))

    def z(self, s: sp.Expr) -> sp.Expr:
        """Where the rule sends s."""
        hs = self.h * s
        return {FORWARD: 1 + hs, BACKWARD: 1 / (1 - hs), TUSTIN: (1 + hs) / (1 - hs)}[self.name]


def rule_of(name: str, T: sp.Expr, prewarp: sp.Expr | None = None) -> Rule:
    """The rule of that name for a period T; `prewarp` is the frequency that is kept."""
    if prewarp is not None:
        return Rule(name, sp.tan(prewarp * T / 2) / prewarp)
    return Rule(name, T / 2 if name == TUSTIN else T)


@dataclass(frozen=True)
class Mapped:
    """A plant by a rule: `inverted` is (I − hA)⁻¹ (None: not needed); B, C, D are None where the plant has none."""

    inverted: sp.ImmutableMatrix | None
    A: sp.ImmutableMatrix
    B: sp.ImmutableMatrix | None
    C: sp.ImmutableMatrix | None
    D: sp.ImmutableMatrix | None


def mapped_matrices(
    A: sp.ImmutableMatrix,
    B: sp.ImmutableMatrix | None,
    C: sp.ImmutableMatrix | None,
    D: sp.ImmutableMatrix | None,
    by: Rule,
) -> Mapped:
    """The discrete plant whose transfer matrix is that of A, B, C, D with what the rule puts for s.

    Raises NotExact where I − hA is singular: the plant has a pole that the rule sends to infinity.
    """
    h, back = by.marked
    identity = sp.ImmutableMatrix(sp.eye(A.rows))
    if by.name == FORWARD:
        return Mapped(None, _put(identity + h * A, back), None if B is None else _put(h * B, back), C, D)
    pencil = sp.ImmutableMatrix(identity - h * A)
    if determinant(pencil) == 0:
        raise NotExact("discretization/no_inverse", h=by.h)
    M = inverse(pencil)
    moved = multiply(M, sp.ImmutableMatrix(identity + h * A)) if by.name == TUSTIN else M
    through = None if B is None else multiply(M, sp.ImmutableMatrix((2 if by.name == TUSTIN else 1) * h * B))
    out = None if C is None else multiply(C, M)
    direct = None
    if out is not None and B is not None and D is not None:
        direct = _put(D + multiply(out, sp.ImmutableMatrix(h * B)), back)
    B_d, C_d = (None if each is None else _put(each, back) for each in (through, out))
    return Mapped(_put(M, back), _put(moved, back), B_d, C_d, direct)


def _put(M: sp.MatrixBase, back: dict[sp.Symbol, sp.Expr]) -> sp.ImmutableMatrix:
    """The entries in lowest terms, with the value of h in place of its mark."""
    found = M.applyfunc(lambda entry: sp.factor(entry) if entry.free_symbols else entry)
    return sp.ImmutableMatrix(found.xreplace(back))


@dataclass(frozen=True)
class MappedQuotient:
    """N/D with what a rule puts for s: `above` over `below` multiplied out, and in lowest terms as it is shown."""

    above: sp.Expr
    below: sp.Expr
    whole: sp.Expr


def mapped_quotient(N: sp.Expr, D: sp.Expr, s: sp.Symbol, z: sp.Symbol, by: Rule) -> MappedQuotient:
    """The quotient of two polynomials in s, D of no lower degree than N; raises NotExact where D maps to zero."""
    h, back = by.marked
    degree = int(sp.degree(D, s))
    above, below = (_homogeneous(p, degree, s, by.above(z), h * by.below(z)) for p in (N, D))
    p, q = sp.Poly(above, z), sp.Poly(below, z)
    if q.degree() < p.degree() or q.is_zero:
        raise NotExact("discretization/no_inverse", h=by.h)
    shared = p.gcd(q)
    whole = _shown(p.quo(shared), q.quo(shared), z)
    return MappedQuotient(*(each.xreplace(back) for each in (p.as_expr(), q.as_expr(), whole)))


def _homogeneous(p: sp.Expr, degree: int, s: sp.Symbol, a: sp.Expr, b: sp.Expr) -> sp.Expr:
    """Σ cᵢ aⁱ b^{degree − i} for p = Σ cᵢ sⁱ."""
    terms = sp.Poly(p, s).terms()
    found: sp.Expr = sp.expand(sp.Add(*(c * a**i * b ** (degree - i) for (i,), c in terms)))
    return found


def _shown(p: sp.Poly, q: sp.Poly, z: sp.Symbol) -> sp.Expr:
    """A quotient of polynomials in factors, each by powers of z, monic where its coefficients are numbers."""
    (c, above), (d, below) = (side.factor_list() for side in (p, q))
    constant = sp.S.One * c / d
    parts = []
    for factors, sign in ((above, 1), (below, -1)):
        for each, m in factors:
            common, left = content_of(each.all_coeffs())
            lead = left[0] if left[0].is_number else sp.S.One
            constant *= (common * lead) ** (sign * m)
            parts.append(in_z([x / lead for x in left], z) ** (sign * m))
    return sp.Mul(sp.factor(constant), *parts)


def longest_period(roots: Sequence[Root]) -> list[tuple[Root, sp.Expr]]:
    """For each root σ ± jω with σ < 0 the period below which |1 + Tλ| < 1: −2σ/(σ² + ω²); conjugates once."""
    found = []
    for root in roots:
        omega = root.shift if root.kind in ("complex", "decimal") else sp.S.Zero
        sigma = root.sigma if root.kind in ("complex", "decimal") else root.value
        if omega != 0 and is_lower(root):
            continue
        found.append((root, sp.radsimp(sp.factor(-2 * sigma / sp.expand(sigma**2 + omega**2)))))
    return found
