"""The drawing of stages of operational amplifiers, from their netlist."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.derivation.figures import Component, Schematic
from solver.lazy import sympy as sp
from solver.tasks.analog.stage_netlists import circuit_of
from solver.words import formula

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpAmp
    from solver.systems.networks import Element

PREFIXES = {
    6: r"\mathrm{M}",
    3: r"\mathrm{k}",
    0: "",
    -3: r"\mathrm{m}",
    -6: r"\mu",
    -9: r"\mathrm{n}",
    -12: r"\mathrm{p}",
}
UNITS = {"R": r"\Omega", "C": r"\mathrm{F}"}


def schematic_of(system: OpAmp) -> tuple[Schematic, ...]:
    """Return the drawing; nothing where the stages cannot be laid out well."""
    from solver.figures.circuit_layout import layout_of  # noqa: PLC0415 - it is asked only whether there is a layout

    circuit = circuit_of(system)
    components = tuple(
        Component(each.letter, _label(each), each.nodes, each.controls if each.letter == "O" else ())
        for each in circuit.elements
    )
    amplifiers = [each.nodes[0] for each in circuit.elements if each.letter == "O"]
    voltages = tuple(
        (node, formula(system.symbol(name))) for node, name in zip(amplifiers, system.outputs, strict=True)
    )
    drawing = Schematic("The circuit", components, tuple(each.name for each in circuit.elements), voltages=voltages)
    return (drawing,) if layout_of(drawing) is not None else ()


def _label(element: Element) -> str:
    """What stands beside an element: the signal, or its symbol with its value and unit where this is short."""
    if element.letter in "VO":
        return formula(element.given) if element.letter == "V" else ""
    value = element.value
    if value is None or value == element.symbol:
        return formula(element.symbol)
    said = _with_unit(value, element.letter)
    return f"{formula(element.symbol)} = {said}" if said else formula(element.symbol)


def _with_unit(value: Expr, letter: str) -> str:
    """A number of up to four digits with a prefix, 5 kΩ; a symbol by itself; else nothing."""
    if value.is_Symbol:
        return formula(value)
    for power, prefix in PREFIXES.items():
        scaled = value / sp.Integer(10) ** power
        if value.is_Rational and 1 <= scaled < 1000 and (scaled * 1000).is_Integer:
            number = f"{float(scaled):.6g}"
            return rf"{number}\,{prefix}{UNITS[letter]}"
    return ""
