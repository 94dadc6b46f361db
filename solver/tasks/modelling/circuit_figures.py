"""The drawing of a circuit, from its netlist."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.derivation.figures import Component, Schematic
from solver.words import formula

if TYPE_CHECKING:
    from solver.systems import Circuit
    from solver.systems.networks import Element


def schematic_of(circuit: Circuit) -> tuple[Schematic, ...]:
    """Return the drawing; nothing where the circuit cannot be laid out well."""
    from solver.figures.circuit_layout import layout_of  # noqa: PLC0415 - it is asked only whether there is a layout

    components = tuple(
        Component(each.letter, _label(each), each.nodes, each.controls if each.letter == "O" else ())
        for each in circuit.elements
    )
    drawing = Schematic("The circuit", components, tuple(each.name for each in circuit.elements))
    return (drawing,) if layout_of(drawing) is not None else ()


def _label(element: Element) -> str:
    """What stands beside an element: what a source gives, the value where it is short, else the name."""
    if element.letter in "VI":
        return formula(element.given)
    if element.letter in "RLC" and element.value != element.symbol:
        return f"{formula(element.symbol)} = {formula(element.value)}"
    return formula(element.symbol)
