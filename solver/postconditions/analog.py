"""Machine equations: what is put in, the scaling of each coefficient, motions, and their largest sizes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import sympy as sp

from solver.derivation import Check, Claim
from solver.lazy import numeric
from solver.numeric.evaluation.arithmetic import DOUBLE
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.values import SAFETY
from solver.stated.algebra import product
from solver.stated.calculus import derivative, value_at

TIME, MACHINE_TIME = sp.Symbol("t"), sp.Symbol("tau")
SEEN = 1e-8
"""How much larger a sampled value may be than what was found to be the largest size."""


def _sum(terms: Any) -> Any:
    return sp.Add(*(a * term for term, a in terms.items()))


def _started(value: Any) -> Any:
    """A function for positive times: step(t), which no text keeps, is 1."""
    return value.replace(sp.Heaviside, lambda inside, *_: sp.S.One if inside == TIME else sp.Heaviside(inside))


def of_machine_equations(found: Any, rates: Any, initial: Any, sums: Any, inputs: Any) -> Iterator[Claim | Check]:
    """Each sum of terms is the right side with the inputs put in; the initial values are those given."""
    known = {u: value for u, value in inputs.items() if value is not None}
    given = [*rates.items(), *sums.items()]
    for each, (variable, value) in zip((*found.integrated, *found.summed), given, strict=True):
        yield Check.that("the variable of an integrator or summer", "compared", each.variable == variable)
        yield Claim(_started(value.xreplace(known)), _sum(each.terms))
    for each, start in zip(found.integrated, initial, strict=True):
        yield Claim(start, each.initial)
    yield Check.that(
        "the inputs left as names", "compared", list(found.inputs) == [u for u in inputs if u not in known]
    )


def of_scale_factors(found: Any, maxima: Any, reference: Any) -> Iterator[Claim | Check]:
    """Volts per unit times maximum is the reference; 1 where nothing moves."""
    for x, value in maxima.items():
        yield Claim(product(found[x], value), reference) if value != 0 else Claim(found[x], sp.S.One)
    yield Check.that("the variables that are scaled", "compared", list(found) == list(maxima))


def of_in_decimals(found: Any, value: Any) -> Iterator[Claim]:
    """The number itself."""
    yield Claim(value, found)


def of_scaled_symbols(found: Any, equations: Any, scaling: Any) -> Iterator[Check]:
    """X1, X2, … of the states in their order, and capitals of what else is scaled."""
    states = [each.variable for each in equations.integrated]
    others = [each.variable for each in equations.summed]
    others += [u for u in equations.inputs if u in scaling.factors]
    names = {x: f"X{i}" for i, x in enumerate(states, 1)} | {x: x.name[0].upper() + x.name[1:] for x in others}
    yield Check.that("the names of the voltages", "compared", {x: str(volts) for x, volts in found.items()} == names)


def of_scaled(found: Any, equations: Any, scaling: Any) -> Iterator[Claim | Check]:
    """With X = L x and τ = β t put in, each right side is L/β times the one before; a sum L times, a start L times."""
    factors, beta = scaling.factors, scaling.time_scale
    before = (*equations.integrated, *equations.summed)
    after = (*found.integrated, *found.summed)
    pairs = [*((b.variable, a.variable) for b, a in zip(before, after, strict=True)),
             *zip(equations.inputs, found.inputs, strict=True)]  # fmt: skip
    back = {volts: factors.get(x, 1) * x for x, volts in pairs} | {MACHINE_TIME: beta * TIME}
    for i, (one, other) in enumerate(zip(before, after, strict=True)):
        slower = beta if i < len(equations.integrated) else 1
        expected = factors.get(one.variable, 1) / slower * _sum(one.terms)
        if not expected.has(sp.Heaviside):
            yield Claim(expected, _sum(other.terms).xreplace(back))
        if i < len(equations.integrated):
            yield Claim(product(factors.get(one.variable, sp.S.One), one.initial), other.initial)


def of_motions_of(found: Any, equations: Any) -> Iterator[Claim | Check]:
    """Each motion begins at its initial value and changes as its equation says."""
    for each in equations.integrated:
        x, right = found[each.variable], _sum(each.terms).xreplace(found)
        if x.has(sp.Heaviside) or right.has(sp.Heaviside):
            yield Check.that("the equation at several times", "sampled", _holds_at_times(x, right))
        else:
            yield Claim(derivative(x, TIME), right)
        yield Claim(value_at(_started(x), TIME, sp.S.Zero), each.initial)


def _holds_at_times(x: Any, right: Any) -> bool:
    """Whether x' is the right side at times between the jumps."""
    slope = sp.diff(x, TIME).replace(sp.DiracDelta, lambda *_: sp.S.Zero)
    gaps = ((slope - right).subs(TIME, sp.Rational(37 * i + 1, 89)) for i in range(1, 24))
    size = max(abs(complex(sp.N(right.subs(TIME, sp.Rational(37 * i + 1, 89)), 15))) for i in range(1, 24))
    return all(abs(complex(sp.N(gap, 15))) <= SEEN * max(size, 1e-12) for gap in gaps)


def of_largest_size(found: Any, equations: Any, terms: Any) -> Iterator[Claim | Check]:
    """No sampled value is larger; a peak is reached at its time, a start at the beginning."""
    start = sp.Add(*(terms.get(each.variable, 0) * each.initial for each in equations.integrated))
    size = float(sp.N(found.value, 20))
    latest = 4.0 * float(sp.N(found.time, 20)) if found.time else 20.0
    times = np.linspace(0.0, latest, 401)[1:]
    values = _sizes(found.motion, times[::10], SEEN / 10 * size)
    yield Check.that("the largest size", "sampled", bool(np.all(values <= size * (1 + SEEN) + 1e-12)))
    if found.kind in ("start", "zero"):
        yield Claim(sp.Abs(start), found.value)
    elif found.kind == "peak":
        yield Claim(sp.Abs(found.motion.subs(TIME, found.time)), found.value)


def _sizes(motion: Any, times: Any, within: float) -> Any:
    """The sizes of a motion at some times; with more digits where doubles do not show them to within so much."""
    found = value_of(motion, Environment.at([{TIME: complex(t)} for t in times]))
    sizes = np.array(np.broadcast_to(np.abs(np.real(found.value)), times.shape))
    unsure = np.broadcast_to(SAFETY * DOUBLE.eps * found.magnitude > within, times.shape)
    for i in np.flatnonzero(unsure):
        sizes[i] = abs(numeric.evaluate(motion, {TIME: complex(times[i])}).real)
    return sizes
