"""What must hold of what the kernels of variations and finite horizons find."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import sympy as sp

from solver.derivation import Check, Claim
from solver.lazy import numeric
from solver.stated.algebra import difference, product, total
from solver.stated.calculus import derivative, integral, time_derivative

PLACES = 60
NEAR = 1e-9


def of_linear_form(found: Any, equation: Any, jets: Sequence[Any]) -> Iterator[Claim]:
    """The equation is the coefficient of its highest derivative times the sum that was found."""
    if found is not None:
        lead = sp.diff(equation, jets[found.order])
        yield Claim(equation, product(lead, found.of(jets) - found.right), "the equation as a sum")


def _put_in(coefficients: Sequence[Any], function: Any, t: Any) -> Any:
    return total(*(product(c, derivative(function, t, i)) for i, c in enumerate(coefficients) if c != 0))


def of_fundamental_system(found: Any, coefficients: Sequence[Any], t: Any) -> Iterator[Claim | Check]:
    """As many functions as the order says, each a solution."""
    yield Check.that("as many solutions as the order", "counted", len(found.functions) == len(coefficients) - 1)
    n, point = len(found.functions), {t: sp.Rational(3, 7)}
    names = frozenset().union(*(function.free_symbols for function in found.functions)) - {t}
    rows = [[sp.diff(function, t, k).xreplace(point) for function in found.functions] for k in range(n)]
    if not names:
        values = np.array([[complex(sp.N(entry)) for entry in row] for row in rows])
        yield Check.that("independent solutions", "numpy.linalg.matrix_rank", np.linalg.matrix_rank(values) == n)
    for function in found.functions:
        yield Claim(_put_in(coefficients, function, t), sp.S.Zero, "a solution of the homogeneous equation")


def of_trials(found: Sequence[Any], form: Any, t: Any) -> Iterator[Claim]:
    """Each gives its part of the right side, and together these are all of it."""
    for each in found:
        yield Claim(_put_in(form.coefficients, each.solution, t), each.right, "a particular solution")
    yield Claim(sp.Add(*(each.right for each in found)), form.right, "the right side in parts")


def of_integrating_factor(found: Any, form: Any, t: Any) -> Iterator[Claim]:
    """The exponent and the integral are antiderivatives."""
    if found is not None:
        yield Claim(derivative(found.exponent, t), form.coefficients[0], "the exponent of the factor")
        yield Claim(derivative(found.integral, t), product(sp.exp(found.exponent), form.right), "the integral")


def of_table_integral(found: Any, f: Any, x: Any) -> Iterator[Claim]:
    """The derivative of what was found."""
    if found is not None:
        yield Claim(derivative(found, x), f, "an antiderivative")


def of_integrated(found: Any, f: Any, x: Any, _times: int) -> Iterator[Claim]:
    """Each one is the derivative of the next."""
    for before, after in zip((f, *(found or ())), found or (), strict=False):
        yield Claim(derivative(after, x), before, "an antiderivative")


def of_with_values(found: Any, _general: Any, _constants: Any, t: Any, start: Any, values: Any) -> Iterator[Claim]:
    """The value and the slope at the start."""
    if found is not None:
        yield Claim(found.subs(t, start), values[0], "the value at the start")
        yield Claim(sp.diff(found, t).subs(t, start), values[1], "the slope at the start")


def _sampled(f: Any, t: Any, start: Any, stop: Any) -> np.ndarray | None:
    """Values between two times that are numbers; None with parameters."""
    if (f.free_symbols | start.free_symbols | stop.free_symbols) - {t}:
        return None
    times = np.linspace(float(start), float(stop), PLACES + 2)[1:-1]
    return np.broadcast_to(numeric.values_at(f, t, times), times.shape)


def of_signs_in_time(found: Any, f: Any, t: Any, start: Any, stop: Any) -> Iterator[Check]:
    """No other sign is seen at some times between; both are seen where it is said so."""
    values = None if found is None else _sampled(f, t, start, stop)
    if values is None:
        return
    size = NEAR * max(1.0, float(np.nanmax(np.abs(values))))
    seen = {int(np.sign(value)) for value in values[np.abs(values) > size]}
    yield Check.that("the signs over the time", "sampled", seen <= set(found) | {0})


def of_without_squares(found: Any, f: Any, t: Any, start: Any, stop: Any) -> Iterator[Check]:
    """The same values at some times between."""
    before, after = (_sampled(each, t, start, stop) for each in (f, found))
    if before is not None and after is not None:
        yield Check.that("a square under a root", "sampled", bool(np.allclose(after, before, rtol=NEAR)))


def of_definite_in_time(found: str, R: Any, t: Any, start: Any, stop: Any) -> Iterator[Check]:
    """The eigenvalues at some times have the sign that is told."""
    entries = [_sampled(entry, t, start, stop) for entry in R.flat()]
    if not found or any(entry is None for entry in entries):
        return
    values = np.linalg.eigvalsh(np.array(entries).T.reshape(PLACES, *R.shape))
    low, high = float(values.min()), float(values.max())
    size = NEAR * max(1.0, abs(low), abs(high))
    fits = {"positive": low > 0, "negative": high < 0, "positive semidefinite": low > -size,
            "negative semidefinite": high < size, "changing": True}  # fmt: skip
    yield Check.that("definite over the time", "numpy.linalg.eigvalsh", bool(fits[found]))


def of_bending(found: str, H: Any, *_: Any) -> Iterator[Check]:
    """A constant matrix of numbers is semidefinite as told."""
    if found and not H.free_symbols:
        values = np.linalg.eigvalsh(np.array(H.evalf(20), dtype=float))
        right = values.min() >= -NEAR if found == "convex" else values.max() <= NEAR
        yield Check.that("convex or concave", "numpy.linalg.eigvalsh", bool(right))


def of_conjugate(found: Any, u: Any, t: Any, start: Any, stop: Any) -> Iterator[Claim | Check]:
    """A zero, and no sign before it; where there is none, none up to a time well behind the end."""
    if found is None:
        return
    last = stop + 2 * (stop - start) if found.point is None else found.point
    if found.point is not None and not (found.point - start).free_symbols:
        behind = bool(sp.N(found.point - start) > 0)
        yield Check.that("behind the start", "compared", behind)
        if not behind:
            return
    if found.point is not None and not found.point.has(sp.Float):
        yield Claim(u.subs(t, found.point), sp.S.Zero, "the conjugate point")
    values = _sampled(u, t, start, last if found.searched is None or found.point is not None else found.searched)
    if values is not None:
        kept = values[: PLACES - 1]
        yield Check.that("no zero before", "sampled", bool(np.all(kept > 0) or np.all(kept < 0)))


def of_in_time(found: Any, function: Any, t: Any) -> Iterator[Claim]:  # noqa: ARG001 - the same at any time
    """The function, written otherwise."""
    if found != function:
        yield Claim(function, found, "a function in another form")


def of_along(found: Any, integrand: Any, t: Any) -> Iterator[Claim]:  # noqa: ARG001 - the same at any time
    """The integrand, written otherwise."""
    if found != integrand:
        yield Claim(integrand, found, "an integrand in another form")


def of_definite_integral(found: Any, integrand: Any, t: Any, start: Any, stop: Any) -> Iterator[Claim]:
    """The integral by quadrature."""
    if found is not None:
        yield Claim(integral(integrand, t, start, stop), found, "an integral")


def of_cleared(found: Any, expression: Any, *_: Any) -> Iterator[Claim]:
    """The equation is what is left times what was divided by."""
    yield Claim(product(found.left, found.by), expression, "the equation with its factors")


def of_variational_derivative(found: Any, _phi: Any, jets: Sequence[Any], following: Any) -> Iterator[Claim | Check]:
    """Each derivative by a k-th one is differentiated k times; their sum with signs in turns; p_k from p_(k+1)."""
    yield Check.that("as many derivatives by the time", "counted", [*map(len, found.rates)] == [*range(len(jets))])
    last = [(partial, *rates)[-1] for partial, rates in zip(found.partials, found.rates, strict=True)]
    yield Claim(sp.Add(*((-1) ** k * each for k, each in enumerate(last))), found.expression, "the sum of the terms")
    above = [*found.momenta[1:], sp.S.Zero]
    for partial, p, behind in zip(found.partials[1:], found.momenta, above, strict=False):
        rate = time_derivative(behind, following.items())
        yield Claim(difference(partial, rate), p, "what stands beside a variation at the ends")
