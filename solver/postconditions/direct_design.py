"""Direct design of sampled loops: targets, controllers, what they cancel."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import sympy as sp

from solver.derivation import Check, Claim

NEAR = 1e-6
"""Roots so near to the unit circle are not told apart from those on it."""


def of_direct_design(found: Any, plant: tuple[Any, Any], target: Any, z: Any) -> Iterator[Claim | Check]:
    """D G (1 − T) = T, and what D cancels: R times it is the characteristic polynomial of the loop."""
    G = plant[0] / plant[1]
    yield Claim(G, found.plant)
    yield Claim(target, found.target)
    yield Claim(1 - target, found.rest)
    yield Claim(target / (1 - target), found.forward)
    yield Claim(found.controller * G * (1 - target), target)
    yield Claim(found.control * G, target)
    parts = [sp.Poly(sp.expand(side), z) for each in (found.plant, found.target, found.controller)
             for side in sp.fraction(sp.together(each))]  # fmt: skip
    N, M, P, R, above, below = parts
    lags = (M.degree() - N.degree(), R.degree() - P.degree(), below.degree() - above.degree())
    yield Check.that("delays", "counted", lags == (found.lag, found.target_lag, found.lateness))
    whole = sp.expand((N * above + M * below).as_expr())
    parts_of_it = (found.cancelled_zeros, found.cancelled_poles, found.target_denominator)
    yield Claim(whole, sp.Poly(whole, z).LC() * sp.Mul(*(_written(each, z) for each in parts_of_it)))


def of_direct_target(
    found: Any, poles: Sequence[Any], zeros: Sequence[Any], lag: int, z: Any
) -> Iterator[Claim | Check]:
    """These poles and zeros, T(1) = 1, and so late as the plant, no later than poles and zeros make it."""
    yield Claim(found.zeros, sp.Mul(*(z - each for each in zeros)))
    yield Claim(found.poles, sp.Mul(*(z - each for each in poles)))
    yield Claim(found.function, found.gain * found.zeros / (found.poles * z**found.delays))
    yield Claim(found.function.xreplace({z: sp.Integer(1)}), sp.Integer(1))
    late = len(poles) + found.delays - len(zeros)
    yield Check.that("delays", "counted", late >= lag and (late == lag or not found.delays))


def of_admissible_target(
    found: Any, plant: tuple[Any, Any], _denominator: Sequence[Any], z: Any
) -> Iterator[Claim | Check]:
    """T(1) = 1, T is zero where N is outside, 1 where M is: told by numbers."""
    if found is None or any(side.free_symbols - {z} for side in (*plant, found)):
        return
    yield Claim(found.xreplace({z: sp.Integer(1)}), sp.Integer(1))
    for side, wanted in zip(plant, (0.0, 1.0), strict=True):
        roots = np.roots([float(sp.N(c)) for c in sp.Poly(side, z).all_coeffs()])
        outside = [sp.Float(r.real) + sp.I * sp.Float(r.imag) for r in roots if abs(r) > 1 + NEAR]
        values = [complex(found.xreplace({z: each}).evalf()) for each in outside]
        yield Check.that("values at roots outside", "numpy.roots", all(abs(v - wanted) < 1e-3 for v in values))


def of_not_inside(found: Any, p: Sequence[Any], z: Any) -> Iterator[Check]:
    """As many roots are outside as numbers tell."""
    if any(c.free_symbols for c in p):
        return
    sizes = np.abs(np.roots([float(sp.N(c)) for c in p]))
    if np.all(np.abs(sizes - 1) > NEAR):
        own = np.abs(np.roots([float(sp.N(c)) for c in sp.Poly(found, z).all_coeffs()]))
        holds = len(own) >= np.sum(sizes > 1) and bool(np.all((len(own) == 0) == (not np.any(sizes > 1))))
        yield Check.that("factors outside", "numpy.roots", bool(holds))


def of_monic_fraction(found: tuple[Any, Any], plant: tuple[Any, Any], z: Any) -> Iterator[Claim | Check]:
    """The same fraction, of the same degrees."""
    yield Claim(plant[0] / plant[1], found[0] / found[1])
    if plant[0] != 0:
        degrees = [[sp.degree(sp.expand(side), z) for side in each] for each in (found, plant)]
        yield Check.that("nothing is cancelled", "counted", degrees[0] == degrees[1])


def of_factors_in(found: Any, p: Sequence[Any], z: Any) -> Iterator[Claim]:
    """The polynomial itself, but for its leading coefficient."""
    yield Claim(p[0] * found, _written(p, z))


def _written(p: Sequence[Any], z: Any) -> Any:
    return sp.Add(*(c * z ** (len(p) - 1 - i) for i, c in enumerate(p)))
