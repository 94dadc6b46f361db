"""The drawing of stages of operational amplifiers, from their netlist."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.conversions.op_amp_to_circuit import circuit_of
from solver.tasks.modelling import circuit_figures

if TYPE_CHECKING:
    from solver.derivation.figures import Schematic
    from solver.systems import OpAmp


def schematic_of(system: OpAmp) -> tuple[Schematic, ...]:
    """Return the drawing; nothing where the stages cannot be laid out well."""
    return circuit_figures.schematic_of(circuit_of(system))
