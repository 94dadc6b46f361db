"""Stages of ideal operational amplifiers: the current law at each minus input, at random s and along random signals.

The unknowns are the outputs; every minus input is at zero volts. At a random s the currents are admittances times
transforms; in time signals are polynomials, which are differentiated and integrated term by term.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from random import Random
from typing import Any

import numpy as np
import sympy as sp
from numpy.polynomial import Polynomial
from sympy.core.function import AppliedUndef

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.points import SEED, PointSource, free_symbols

TRIALS = 3
DEGREE = 6
TIMES = (0.31, 0.87, 1.6)
"""Signals are judged at these times."""


def _number(value: Any, point: Mapping[Any, complex]) -> complex:
    return complex(evaluate(value, point)) if free_symbols(value) else complex(value)


def _points(system: Any, answer: Any, variable: str) -> Iterator[dict[Any, complex]]:
    """Values of the parameters, and of what else stands in the answer but signals."""
    own = {name for each in (*system.inputs, *system.outputs) for name in (each, each[:1].upper() + each[1:])}
    symbols = {x for x in free_symbols([answer]) | set(system.parameters) if str(x) not in {*own, variable}}
    source = PointSource(sorted(symbols, key=str))
    for _ in range(TRIALS):
        yield dict(source.draw())


def _values(system: Any, point: Mapping[Any, complex]) -> list[tuple[list[tuple[str, str, complex]], str, complex]]:
    """Each stage as (signal, letter, value) of its inputs, and letter and value of its feedback."""
    return [
        ([(name, part.letter, _number(part.value, point)) for name, part in stage.inputs],
         stage.feedback.letter, _number(stage.feedback.value, point))
        for stage in system.stages
    ]  # fmt: skip


def _before(system: Any, point: Mapping[Any, complex]) -> dict[str, complex]:
    """The outputs before t = 0, all inputs zero: no current through capacitors, those in feedbacks hold theirs."""
    names, stages = list(system.outputs), _values(system, point)
    M, b = np.zeros((len(names), len(names)), dtype=complex), np.zeros(len(names), dtype=complex)
    for row, (stage, (inputs, letter, value)) in enumerate(zip(system.stages, stages, strict=True)):
        if letter == "C":
            M[row, row], b[row] = 1, _number(stage.initial, point)
            continue
        M[row, row] = 1 / value
        for name, kind, size in inputs:
            if kind == "R" and name in names:
                M[row, names.index(name)] += 1 / size
    return dict(zip(names, np.linalg.solve(M, b), strict=True))


def transform_residual(system: Any, answer: Any) -> float:
    """Return how far a transform of the output is from the solution of the nodal equations at random s."""
    random, worst, names = Random(SEED), 0.0, list(system.outputs)  # noqa: S311 - nothing secret
    for point in _points(system, answer, "s"):
        s = complex(random.uniform(0.4, 2.0), random.uniform(0.4, 2.0))
        given = {name: complex(random.uniform(-2, 2), random.uniform(-2, 2)) for name in system.inputs}
        before = _before(system, point)
        M, b = np.zeros((len(names), len(names)), dtype=complex), np.zeros(len(names), dtype=complex)
        for row, (inputs, letter, value) in enumerate(_values(system, point)):
            for name, kind, size in [*inputs, (names[row], letter, value)]:
                Y = 1 / size if kind == "R" else s * size
                b[row] += size * before.get(name, 0) if kind == "C" else 0
                if name in given:
                    b[row] -= Y * given[name]
                else:
                    M[row, names.index(name)] += Y
        wanted = np.linalg.solve(M, b)[-1]
        symbols = {str(x): x for x in free_symbols([answer])}
        at = {**point, **{symbols[n]: v for n, v in _transforms(given).items() if n in symbols}}
        at |= {symbols["s"]: s} if "s" in symbols else {}
        worst = max(worst, _distance(np.array([_number(answer, at)]), np.array([wanted])))
    return worst


def _transforms(given: Mapping[str, complex]) -> dict[str, complex]:
    return {name[:1].upper() + name[1:]: value for name, value in given.items()}


def _signal(random: Random, flat: int) -> tuple[Fraction, ...]:
    """The coefficients of a signal in t; so many of its derivatives, itself among them, are zero at t = 0."""
    return (
        *(Fraction(0),) * flat,
        *(Fraction(random.choice((-1, 1)) * random.randint(3, 15), 10) for _ in range(DEGREE)),
    )


def output_residual(system: Any, answer: Any) -> float:
    """Return how far an output in time is from what the currents at the minus inputs make of random signals.

    Where there are capacitors at inputs the signals begin smoothly, so that they are zero before and behind t = 0.
    """
    random, worst, t = Random(SEED + 1), 0.0, sp.Symbol("t")  # noqa: S311 - nothing secret
    flat = sum(part.letter == "C" for each in system.stages for _, part in each.inputs)
    for point in _points(system, answer, "t"):
        signals = {name: _signal(random, flat) for name in system.inputs}
        wanted = _moved(system, point, signals)
        formulas = {name: _formula(each) for name, each in signals.items()}
        found = _with_signals(answer, formulas)
        values = [_number(found, {**point, t: at}) for at in TIMES]
        worst = max(worst, _distance(np.array(values), np.array([wanted(at) for at in TIMES])))
    return worst


def _formula(coefficients: Sequence[Fraction]) -> Any:
    t = sp.Symbol("t")
    return sp.Add(*(sp.Rational(c.numerator, c.denominator) * t**k for k, c in enumerate(coefficients)))


def _with_signals(answer: Any, signals: Mapping[str, Any]) -> Any:
    """An answer with the signals put in, whether these stand as v or as v(t)."""
    t = sp.Symbol("t")
    found = answer.replace(
        lambda each: isinstance(each, AppliedUndef) and each.func.__name__ in signals,
        lambda each: signals[each.func.__name__].xreplace({t: each.args[0]}),
    )
    return found.xreplace({x: signals[str(x)] for x in free_symbols([found]) if str(x) in signals})


def _moved(system: Any, point: Mapping[Any, complex], signals: Mapping[str, Sequence[Fraction]]) -> Any:
    """The last output as a polynomial: the current law at each minus input, stage by stage."""
    before = {**_before(system, point), **dict.fromkeys(signals, 0.0)}
    known: dict[str, Any] = {name: Polynomial([complex(c) for c in each]) for name, each in signals.items()}
    nothing = Polynomial([0j])
    for output, stage, (inputs, letter, value) in zip(
        system.outputs, system.stages, _values(system, point), strict=True
    ):
        resistive, current, charge = nothing, nothing, nothing
        for name, kind, size in inputs:
            if kind == "R":
                resistive = resistive + known[name] / size
            else:
                current = current + size * known[name].deriv()
                charge = charge + size * (known[name] - before[name])
        if letter == "R":
            known[output] = -value * (resistive + current)
        else:
            flown = resistive.integ() + charge
            known[output] = _number(stage.initial, point) - flown / value
    return known[system.outputs[-1]]


def _distance(found: Array, wanted: Array) -> float:
    size = float(np.max(np.abs(wanted), initial=0.0)) or 1.0
    distance = float(np.max(np.abs(found - wanted), initial=0.0)) / size
    return distance if np.isfinite(distance) else np.inf
