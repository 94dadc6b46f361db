"""The one change that would make a wrong program right: a sign, a start, a setting, factors upside down."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import sympy as sp
from scipy.optimize import lsq_linear

from solver.numeric.judges.analog.netlists import netlist_of
from solver.numeric.judges.analog.posed import Asked, Posed
from solver.numeric.judges.analog.programs import Run, within_digits
from solver.patches import Element, Program

ROUGH, NEAR = 2e-2, 1e-6
"""How far a program whose digits are not yet allowed for may be, and one whose digits are."""
STEP = sp.Rational(1, 10**6)
ROUNDS = 6

Repair = tuple[str, str, str]
"""What is to be changed ("input", "initial", "readout", "setting") and where: the element, and what feeds it."""


def repair_of(asked: Asked, program: Program) -> Repair | None:
    """Return the one change that makes a program compute what is asked; None if no single one does."""
    posed = Posed(asked)
    names = [name for name in program.readout if name in asked.readouts]
    if not set(asked.required) <= set(names):
        return None
    for repair, other in (*_changed(program), *_reset(posed, program, names)):
        if _gap(posed, other, names) < ROUGH and _gap(posed, within_digits(asked, other), names) < NEAR:
            return repair
    return None


def _gap(posed: Posed, program: Program, names: list[str]) -> float:
    gaps = Run(posed, netlist_of(program)).gaps(names)
    worst = float(np.max(np.abs(gaps), initial=0.0))
    return worst if np.isfinite(worst) else np.inf


def _changed(program: Program) -> Iterator[tuple[Repair, Program]]:
    """The program with one sign changed, or with its factors upside down."""
    upside = {name: (of, 1 / factor) for name, (of, factor) in program.readout.items() if factor != 0}
    yield ("readout", "", ""), replace(program, readout=upside)
    for name, (of, factor) in program.readout.items():
        yield ("readout_sign", name, of), replace(program, readout={**program.readout, name: (of, -factor)})
    for i, each in enumerate(program.elements):
        if each.kind == "integrator" and each.initial != 0:
            yield ("initial", each.id, ""), _with(program, i, replace(each, initial=-each.initial))
        for j, (fed, gain) in enumerate(each.inputs if each.is_amplifier else ()):
            inputs = (*each.inputs[:j], (fed, -gain), *each.inputs[j + 1 :])
            yield ("input", each.id, fed), _with(program, i, replace(each, inputs=inputs))


def _reset(posed: Posed, program: Program, names: list[str]) -> Iterator[tuple[Repair, Program]]:
    """The program with one setting moved to where it fits best."""
    for i, each in enumerate(program.elements):
        if each.kind != "pot":
            continue
        here = program
        for _ in range(ROUNDS):
            gaps = Run(posed, netlist_of(here)).gaps(names)
            moved = _with(here, i, replace(here.elements[i], setting=here.elements[i].setting + STEP))
            slopes = (Run(posed, netlist_of(moved)).gaps(names) - gaps) / float(STEP)
            if not (np.all(np.isfinite(slopes)) and np.all(np.isfinite(gaps)) and np.any(slopes)):
                break
            setting = float(here.elements[i].setting)
            by = lsq_linear(slopes[:, None], -gaps, (-setting - 1e-9, 1.0 - setting + 1e-9)).x[0]
            here = _with(here, i, replace(here.elements[i], setting=here.elements[i].setting + sp.Rational(float(by))))
        yield ("setting", each.id, ""), here


def _with(program: Program, i: int, element: Element) -> Program:
    return replace(program, elements=(*program.elements[:i], element, *program.elements[i + 1 :]))
