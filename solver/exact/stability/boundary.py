"""The roots of a polynomial on the boundary of stability: the imaginary axis, in discrete time the unit circle.

On the axis p(jω) = E(−ω²) + jω O(−ω²) is zero where the even and the odd part are. Source: F. R. Gantmacher, The Theory
of Matrices II, XV §6. On the circle p(e^{jθ}) = E(cos θ) + j sin θ O(cos θ), by Chebyshev's polynomials.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import domain_matrix
from solver.exact.stability.inequalities import sign_of


def boundary_roots(coefficients: Sequence[sp.Expr], *, discrete: bool) -> tuple[sp.Expr, ...]:
    """Simple roots on the boundary, of a conjugate pair the one above: those with a square root as formula.

    `coefficients`, highest power first, are exact. With parameters they are roots for all values of these; ω² in jω may
    then have any sign. On the circle: 1, −1, and the pair of a quadratic polynomial.
    """
    found = _on_the_circle(coefficients) if discrete else _on_the_axis(coefficients)
    slope = [c * (len(coefficients) - 1 - i) for i, c in enumerate(coefficients[:-1])]
    return tuple(root for root in found if _value(slope, root) != 0)


def _value(coefficients: Sequence[sp.Expr], x: sp.Expr) -> sp.Expr:
    """The polynomial at x, multiplied out (Horner's scheme)."""
    value: sp.Expr = sp.Integer(0)
    for c in coefficients:
        value = sp.expand(value * x + c)
    return value


def _on_the_axis(coefficients: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    (flat,) = (matrix := domain_matrix(sp.Matrix([list(coefficients)]))).to_list()
    n, u = len(flat) - 1, sp.Dummy("u")
    parts = [
        sp.Poly([c for i, c in enumerate(flat) if (n - i) % 2 == r] or [0], u, domain=matrix.domain) for r in (0, 1)
    ]
    found: list[sp.Expr] = [sp.Integer(0)] if coefficients[-1] == 0 else []
    for factor, _ in parts[0].gcd(parts[1]).factor_list()[1]:
        if factor.degree() == 1 and factor.TC() != 0:
            square = sp.factor(factor.TC() / factor.LC())
            if sign_of(square) != -1:
                found.append(sp.I * sp.sqrt(square))
    return tuple(found)


def _on_the_circle(coefficients: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    z = sp.Dummy("z")
    p = sp.Poly(list(coefficients), z)
    found: list[sp.Expr] = [x for x in (sp.Integer(1), sp.Integer(-1)) if _value(coefficients, x) == 0]
    if p.degree() == 2 and not found and sp.expand(p.TC() - p.LC()) == 0:
        half = sp.factor(-p.nth(1) / (2 * p.LC()))
        found.append(half + sp.I * sp.sqrt(sp.factor(1 - half**2)))
    return tuple(found)


def parts_on_circle(p: sp.Poly, c: sp.Symbol) -> tuple[sp.Poly, sp.Poly]:
    """E and O, polynomials in c, of p(e^{jθ}) = E(c) + j sin θ O(c) with c = cos θ; p has real coefficients.

    They are those of e^{jkθ} = cos kθ + j sin kθ, each by 2 cos θ times the one before it minus that before.
    """
    K = p.domain
    zero, one, twice = (sp.Poly(each, c, domain=K) for each in (0, 1, 2 * c))
    cosines, sines = [one, sp.Poly(c, c, domain=K)], [zero, one]
    for _ in range(p.degree() - 1):
        for listed in (cosines, sines):
            listed.append(twice * listed[-1] - listed[-2])
    rising = list(reversed(p.rep.to_list()))
    even, odd = (sum((q.mul_ground(a) for a, q in zip(rising, listed, strict=False)), zero)
                 for listed in (cosines, sines))  # fmt: skip
    return even, odd


def edges(condition: sp.Basic) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """The bounds of parameters in a condition: where a strict inequality x < c or x > c ends, or a linear one in x."""
    strict = sorted(condition.atoms(sp.StrictLessThan, sp.StrictGreaterThan), key=sp.default_sort_key)
    found = [next(_solved_for(each), None) for each in strict]
    return tuple(dict.fromkeys(each for each in found if each is not None))


def _solved_for(relation: Any) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    if relation.has(sp.Float):
        return
    for x, bound in (relation.args, relation.args[::-1]):
        if x.is_Symbol and x not in bound.free_symbols:
            yield x, bound
    vanishing = relation.gts - relation.lts
    for x in sorted(vanishing.free_symbols, key=str):
        slope = vanishing.diff(x)
        if slope.is_Rational:
            yield x, sp.expand(x - vanishing / slope)
