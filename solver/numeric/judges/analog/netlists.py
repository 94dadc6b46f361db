"""A program of an analog computer in numbers: what its amplifiers, read one after the other, make of the integrators.

The elements are linear, so that each output is a row of coefficients of the integrators' outputs and of the sources.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.values import NotEvaluable
from solver.patches import Program, in_order


@dataclass(frozen=True)
class Netlist:
    """dv/dτ = F v + G w from `start`, with the sources w; `rows`: each element's output as a row over (v, w).

    `readouts` are such rows of the variables that are read out; `amplifiers` the ids of those that can overload.
    """

    F: Array
    G: Array
    start: Array
    rows: Mapping[str, Array]
    readouts: Mapping[str, Array]
    sources: Sequence[Any]
    amplifiers: Sequence[str]
    reference: float


def number(value: Any) -> float:
    """The value of a real expression without symbols. Raises NotEvaluable."""
    found = complex(evaluate(value, {}))
    if abs(found.imag) > 1e-12 * max(1.0, abs(found)):
        raise NotEvaluable("a number of the program is not real")
    return found.real


def netlist_of(program: Program) -> Netlist:
    """Return the program in numbers. Raises NotEvaluable, also for a loop without an integrator."""
    ordered, looped = in_order(program)
    if looped:
        raise NotEvaluable("the program has a loop without an integrator")
    integrators, sources = program.of_kind("integrator"), program.of_kind("source")
    units = np.eye(len(integrators) + len(sources))
    rows = {each.id: row for each, row in zip([*integrators, *sources], units, strict=True)}
    nothing = np.zeros(len(units))
    for each in ordered:
        if each.id in rows:
            continue
        fed = sum((number(gain) * rows[name] for name, gain in each.inputs), nothing)
        rows[each.id] = -fed if each.is_amplifier else number(each.setting) * fed
    n = len(integrators)
    rates = [-sum((number(gain) * rows[name] for name, gain in each.inputs), nothing) for each in integrators]
    rate = np.array(rates).reshape(n, len(units))
    return Netlist(
        rate[:, :n],
        rate[:, n:],
        np.array([number(each.initial) for each in integrators]),
        rows,
        {name: number(factor) * rows[element] for name, (element, factor) in program.readout.items()},
        [each.value for each in sources],
        [each.id for each in program.elements if each.is_amplifier],
        number(program.reference),
    )
