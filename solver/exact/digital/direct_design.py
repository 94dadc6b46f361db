"""Direct design: the controller D = (1/G) T/(1 − T) that gives a sampled loop the transfer function T.

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
from solver.exact.representation.polynomials import factored_form, factors_of, signed_fraction
from solver.exact.stability.location import is_stable_polynomial

Coefficients = tuple[sp.Expr, ...]
Fraction = tuple[sp.Expr, sp.Expr]
"""A numerator and a denominator, not cancelled."""


@dataclass(frozen=True)
class DirectDesign:
    """What a target asks of a plant; polynomials that are cancelled are monic, by their coefficients.

    `hidden` is what numerator and denominator of the plant had in common. `lag` and `target_lag` are by how many steps
    plant and target are late, `lateness` by how many the controller would be: below zero it is not causal. `rest` is
    1 − T, `forward` is T/(1 − T) = D G, `control` is T/G, `controller` is D.
    """

    plant: sp.Expr
    target: sp.Expr
    rest: sp.Expr
    forward: sp.Expr
    controller: sp.Expr
    control: sp.Expr
    lag: int
    target_lag: int
    lateness: int
    hidden: Coefficients
    cancelled_zeros: Coefficients
    cancelled_poles: Coefficients
    target_denominator: Coefficients


def direct_design(plant: Fraction, target: sp.Expr, z: sp.Symbol) -> DirectDesign:
    """Return the design for a plant N/M; raises ValueError for a plant or a target that is zero, and for T = 1.

    Raises NotExact for numbers without exact arithmetic.
    """
    N, M, P, R = _polynomials((plant, sp.fraction(sp.together(target))), z)
    Q = R - P
    if N.is_zero or P.is_zero or Q.is_zero:
        raise ValueError("there is no such controller")
    hidden = N.gcd(M).monic()
    N, M = N.quo(hidden), M.quo(hidden)
    common = P.gcd(R).monic()
    P, R, Q = P.quo(common), R.quo(common), Q.quo(common)
    zeros, poles = (each.quo(each.gcd(other)).monic() for each, other in ((N, P), (M, Q)))
    return DirectDesign(
        plant=_fraction(N, M),
        target=_fraction(P, R),
        rest=_fraction(Q, R),
        forward=_fraction(P, Q),
        controller=_fraction(M * P, N * Q),
        control=_fraction(P * M, R * N),
        lag=M.degree() - N.degree(),
        target_lag=R.degree() - P.degree(),
        lateness=N.degree() + Q.degree() - M.degree() - P.degree(),
        hidden=_coefficients(hidden),
        cancelled_zeros=_coefficients(zeros),
        cancelled_poles=_coefficients(poles),
        target_denominator=_coefficients(R.monic()),
    )


def monic_fraction(plant: Fraction, z: sp.Symbol) -> Fraction:
    """Return numerator and denominator in factors, nothing cancelled, the leading coefficient in the numerator."""
    N, M = _polynomials((plant,), z)
    if N.is_zero:
        return sp.Integer(0), factored_form(factors_of(M.monic()))
    top, bottom = (factored_form(factors_of(each.monic())) for each in (N, M))
    number = expression(N.domain, _lead(N) / _lead(M))
    over, under = sp.fraction(number) if number.free_symbols else (number, sp.Integer(1))
    return over * top, under * bottom


def factors_in(p: Coefficients, z: sp.Symbol) -> sp.Expr:
    """The monic polynomial with these coefficients, highest power first, in its factors."""
    (found, _) = _polynomials(((_written(p, z), sp.Integer(1)),), z)
    return factored_form(factors_of(found.monic()))


def _written(p: Coefficients, z: sp.Symbol) -> sp.Expr:
    return sp.Add(*(c * z ** (len(p) - 1 - i) for i, c in enumerate(p)))


def _polynomials(fractions: Sequence[Fraction], z: sp.Symbol) -> list[sp.Poly]:
    """Numerators and denominators over one field."""
    sides = [side for each in fractions for side in each]
    listed = [[sp.expand(c) for c in sp.Poly(sp.expand(side), z).all_coeffs()] for side in sides]
    matrix = domain_matrix(sp.Matrix([[c for each in listed for c in each]]))
    K, (flat,), found, start = matrix.domain, matrix.to_list(), [], 0
    for each in listed:
        found.append(sp.Poly(flat[start : start + len(each)], z, domain=K))
        start += len(each)
    return found


def _lead(p: sp.Poly) -> Any:
    return p.rep.to_list()[0]


def _fraction(above: sp.Poly, below: sp.Poly) -> sp.Expr:
    """above/below in lowest terms, both in factors."""
    K, common = above.domain, above.gcd(below).monic()
    above, below = above.quo(common), below.quo(common)
    top, bottom = (factored_form(factors_of(each.monic())) for each in (above, below))
    number = expression(K, _lead(above) / _lead(below))
    if not number.free_symbols:
        return signed_fraction(number * top, bottom)
    over, under = sp.fraction(number)
    return signed_fraction(over * top, under * bottom)


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


def admissible_target(plant: Fraction, denominator: Coefficients, z: sp.Symbol) -> sp.Expr | None:
    """The target with these poles and T(1) = 1 that cancels nothing outside the unit circle; None where there is none.

    Its numerator is B N⁻, N⁻ the factor of N with the roots that are not inside, of the lowest degree with
    B N⁻ = R modulo the same factor of M and z − 1. Poles are put at 0 until it is as late as the plant.
    """
    N, M, _, R = _polynomials((plant, (sp.Integer(1), _written(denominator, z))), z)
    common = N.gcd(M)
    N, M = N.quo(common), M.quo(common)
    zeros, poles = _outside(N), _outside(M)
    if zeros is None or poles is None:
        return None
    K = N.domain
    m = poles.lcm(sp.Poly([K.one, -K.one], z, domain=K))
    if zeros.gcd(m).degree() > 0:
        return None
    lag = M.degree() - N.degree()
    while True:
        top = zeros * (R * zeros.invert(m)).rem(m)
        if R.degree() - top.degree() >= lag:
            return _fraction(top, R)
        R = R * sp.Poly(z, z, domain=K)


def _outside(p: sp.Poly) -> sp.Poly | None:
    """The monic factor with the roots that are not inside; None where parameters decide."""
    found = sp.Poly(1, p.gen, domain=p.domain)
    for factor, m in factors_of(p.monic()):
        stable = is_stable_polynomial(_coefficients(factor), discrete=True)
        if stable is None:
            return None
        found = found if stable else found * factor**m
    return found


def not_inside(p: Coefficients, z: sp.Symbol) -> sp.Expr:
    """The factors of a polynomial, highest power first, of which it is known that not all roots are inside; 1: none."""
    (found, _) = _polynomials(((_written(p, z), sp.Integer(1)),), z)
    kept = [
        (factor, m)
        for factor, m in factors_of(found.monic())
        if is_stable_polynomial(_coefficients(factor), discrete=True) is False
    ]
    return factored_form(kept)
