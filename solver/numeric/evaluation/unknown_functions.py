"""Unknown functions, q(t) or w(x, t): an equality that holds for all of them holds for one that is chosen at random.

Each name stands for a sum of products of sines with random frequencies, phases and amplitudes: analytic everywhere, and
its values and derivatives of any order at a point are as good as independent. Where a formula is differentiated by q or
by q̇ as by a variable, the environment gives these a value of their own.
"""

from __future__ import annotations

from functools import lru_cache
from random import Random
from typing import Any, NamedTuple

import numpy as np
import sympy as sp
from sympy.core.function import AppliedUndef

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.operations import derivative
from solver.numeric.evaluation.points import SEED
from solver.numeric.evaluation.values import NoRule, NotEvaluable, Value
from solver.numeric.evaluation.walk import exactly, rule, walk

WAVES = 6


class Wave(NamedTuple):
    """Amplitude, and of each argument the frequency and the phase."""

    amplitude: float
    frequencies: tuple[float, ...]
    phases: tuple[float, ...]


@lru_cache(maxsize=64)
def _waves(name: str, arguments: int) -> tuple[Wave, ...]:
    random = Random(f"{SEED} {name}")  # noqa: S311 - nothing secret
    return tuple(
        Wave(
            random.uniform(0.3, 1.5),
            tuple(random.uniform(0.3, 2.5) for _ in range(arguments)),
            tuple(random.uniform(0.0, 6.0) for _ in range(arguments)),
        )
        for _ in range(WAVES)
    )


@rule(AppliedUndef)
def _unknown(function: Any, environment: Environment) -> Value:
    if function in environment.values:
        return exactly(environment.values[function], environment.arithmetic)
    return _differentiated(function, (0,) * len(function.args), environment)


@rule(sp.Derivative)
def _derivative(expression: Any, environment: Environment) -> Value:
    """A derivative of an unknown function; of anything else by Cauchy's formula, one variable after the other."""
    if expression in environment.values:
        return exactly(environment.values[expression], environment.arithmetic)
    function, *variables = expression.args
    if isinstance(function, AppliedUndef):
        counts = {variable: int(times) for variable, times in variables}
        if not set(counts) <= set(function.args) or not all(each.is_Symbol for each in counts):
            raise NoRule(str(expression))
        return _differentiated(function, tuple(counts.get(each, 0) for each in function.args), environment)
    if len(variables) > 1:
        raise NotEvaluable("mixed derivatives of a formula are not evaluated")
    (variable, order) = variables[0]
    return derivative.evaluate(environment, function, variable, order)


def _differentiated(function: Any, orders: tuple[int, ...], environment: Environment) -> Value:
    """Return Σ a Π ωᵢⁿ sin(ωᵢ xᵢ + φᵢ + n π/2), n the order of the derivative by the argument xᵢ."""
    arithmetic = environment.arithmetic
    arguments = [walk(each, environment) for each in function.args]
    quarter = arithmetic.constant("pi") / 2
    value: Any = 0
    magnitude: Any = 0.0
    for wave in _waves(function.func.__name__, len(arguments)):
        term: Any = arithmetic.number(wave.amplitude)
        size: Any = wave.amplitude
        slope: Any = 1.0
        for x, frequency, phase, order in zip(arguments, wave.frequencies, wave.phases, orders, strict=True):
            angle = x.value * arithmetic.number(frequency) + (arithmetic.number(phase) + order * quarter)
            term = arithmetic.apply("sin", angle) * (term * arithmetic.number(frequency) ** order)
            size = size * frequency**order * np.cosh(np.imag(arithmetic.approximate(angle)))
            slope = slope + frequency * x.magnitude + arithmetic.size(angle)
        value, magnitude = term + value, magnitude + size * slope
    return Value(value, magnitude)
