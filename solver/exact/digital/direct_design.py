"""Direct design: the controller D = (1/G) T/(1 − T) that gives a sampled loop the transfer function T, and what it cancels.

With coprime G = N/M and T = P/R it is D = M P/(N (R − P)). The loop has the characteristic polynomial R times what D
cancels: the factor of N that P does not have, and the factor of M that R − P does not have.
Source: G. F. Franklin, J. D. Powell, M. L. Workman, Digital Control of Dynamic Systems, §7.3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.design.placement import conjugate_pairs, monic
from solver.exact.linear_algebra.fields import domain_matrix, expression
from solver.exact.representation.polynomials import expanded, factored_form, factors_of, signed_fraction
from solver.exact.stability.location import is_stable_polynomial

Coefficients = tuple[sp.Expr, ...]


@dataclass(frozen=True)
class DirectDesign:
    """What a target asks of a plant; polynomials that are cancelled are monic, by their coefficients.

    `hidden` is what numerator and denominator of the plant had in common. `lag` and `target_lag` are by how many steps
    plant and target are late, `lateness` by how many the controller would be: below zero it is not causal. `rest` is
    1 − T, `control` is T/G, `controller` is D.
    """

    plant: sp.Expr
    target: sp.Expr
    rest: sp.Expr
    controller: sp.Expr
    control: sp.Expr
    lag: int
    target_lag: int
    lateness: int
    hidden: Coefficients
    cancelled_zeros: Coefficients
    cancelled_poles: Coefficients
    target_denominator: Coefficients


def direct_design(plant: sp.Expr, target: sp.Expr, z: sp.Symbol) -> DirectDesign:
    """Return the design; raises ValueError for a plant or a target that is zero, and for T = 1. Raises NotExact."""
    N, M, P, R = _polynomials((plant, target), z)
    Q = R - P
    if N.is_zero or P.is_zero or Q.is_zero:
        raise ValueError("there is no such controller")
    hidden = N.gcd(M).monic()
    N, M = N.quo(hidden), M.quo(hidden)
    common = P.gcd(R).monic()
    P, R, Q = P.quo(common), R.quo(common), Q.quo(common)
    zeros, poles = (each.quo(each.gcd(other)).monic() for each, other in ((N, P), (M, Q)))
    (above, shared), (below, kept) = _without_common(P, N), _without_common(Q, M)
    return DirectDesign(
        plant=_fraction(N, M),
        target=_fraction(P, R),
        rest=_fraction(Q, R),
        controller=_fraction(poles * above, zeros * below, _lead(M) * _lead(shared) / (_lead(N) * _lead(kept))),
        control=_fraction(P * M, R * N),
        lag=M.degree() - N.degree(),
        target_lag=R.degree() - P.degree(),
        lateness=N.degree() + Q.degree() - M.degree() - P.degree(),
        hidden=_coefficients(hidden),
        cancelled_zeros=_coefficients(zeros),
        cancelled_poles=_coefficients(poles),
        target_denominator=_coefficients(R.monic()),
    )


def _polynomials(functions: Sequence[sp.Expr], z: sp.Symbol) -> list[sp.Poly]:
    """Numerators and denominators over one field."""
    sides = [side for each in functions for side in sp.fraction(sp.together(each))]
    listed = [[sp.expand(c) for c in sp.Poly(sp.expand(side), z).all_coeffs()] for side in sides]
    matrix = domain_matrix(sp.Matrix([[c for each in listed for c in each]]))
    K, (flat,), found, start = matrix.domain, matrix.to_list(), [], 0
    for each in listed:
        found.append(sp.Poly(flat[start : start + len(each)], z, domain=K))
        start += len(each)
    return found


def _without_common(p: sp.Poly, other: sp.Poly) -> tuple[sp.Poly, sp.Poly]:
    """(p without its common factor with another, that factor); the first keeps the leading coefficient."""
    common = p.gcd(other).monic()
    return p.quo(common), common


def _lead(p: sp.Poly) -> Any:
    return p.rep.to_list()[0]


def _fraction(above: sp.Poly, below: sp.Poly, factor: Any = None) -> sp.Expr:
    """κ above/below in lowest terms, both in factors; κ is 1 where none is given."""
    K, common = above.domain, above.gcd(below).monic()
    above, below = above.quo(common), below.quo(common)
    gain = _lead(above) / _lead(below) * (K.one if factor is None else factor)
    parts = [factored_form(factors_of(each.monic())) for each in (above, below)]
    number = expression(K, gain)
    top, bottom = sp.fraction(number)
    if number.is_Rational or not number.free_symbols:
        return signed_fraction(number * parts[0], parts[1])
    return signed_fraction(top * parts[0], bottom * parts[1])


def _coefficients(p: sp.Poly) -> Coefficients:
    return tuple(expression(p.domain, c) for c in p.rep.to_list())


@dataclass(frozen=True)
class DirectTarget:
    """T = gain · zeros/(poles · z^delays), with T(1) = 1; `zeros` and `poles` are in factors."""

    gain: sp.Expr
    zeros: sp.Expr
    poles: sp.Expr
    delays: int
    function: sp.Expr


def direct_target(poles: Sequence[sp.Expr], zeros: Sequence[sp.Expr], lag: int, z: sp.Symbol) -> DirectTarget:
    """Return the target with these poles and zeros, late enough for a plant that is late by `lag` steps.

    Raises ZeroDivisionError where a pole or a zero is 1, so that T(1) = 1 cannot be.
    """
    delays = max(0, len(zeros) + lag - len(poles))
    at_one = [sp.radsimp(sp.expand(sp.Add(*monic(roots)))) for roots in (poles, zeros)]
    if 0 in at_one:
        raise ZeroDivisionError("a pole or a zero at 1")
    gain = sp.radsimp(sp.cancel(at_one[0] / at_one[1]))
    above, below = (_in_factors(roots, z) for roots in (zeros, poles))
    return DirectTarget(gain, above, below, delays, gain * above / (below * z**delays))


def _in_factors(roots: Sequence[sp.Expr], z: sp.Symbol) -> sp.Expr:
    """Π(z − root), pairs as quadratic factors."""
    pairs, others = conjugate_pairs(list(roots))
    quadratic = [sp.expand(z**2 - 2 * re * z + re**2 + im**2) for re, im in pairs]
    return sp.Mul(*quadratic, *(z - root for root in others))


def outside_the_circle(p: Coefficients, z: sp.Symbol) -> sp.Expr:
    """The factors of a polynomial, with numbers, that do not have all roots inside the unit circle; 1 for none."""
    (found,) = _polynomials_of([p], z)
    kept = [(f, m) for f, m in factors_of(found.monic()) if is_stable_polynomial(_coefficients(f), discrete=True) is False]
    return factored_form(kept)


def _polynomials_of(listed: Sequence[Coefficients], z: sp.Symbol) -> list[sp.Poly]:
    return _polynomials([sp.Add(*(c * z ** (len(p) - 1 - i) for i, c in enumerate(p))) for p in listed], z)[::2]


def admissible_target(plant: sp.Expr, denominator: Coefficients, z: sp.Symbol) -> sp.Expr | None:
    """The target with these poles and T(1) = 1 that cancels nothing outside, of the lowest degree; None: there is none.

    Its numerator is B times the factor of N with roots outside, B = R/that modulo the factor of M with roots outside
    and z − 1; missing poles are at 0.
    """
    N, M, R, one = _polynomials((plant, 1 / sp.Add(*(c * z ** (len(denominator) - 1 - i) for i, c in
                                                     enumerate(denominator)))), z)[0:4]  # fmt: skip
    del R, one
    return None if N.is_zero or M.is_zero else None
