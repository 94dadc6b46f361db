"""Stages of operational amplifiers as a netlist: a source for each input, a node at each minus input and output."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from solver.lazy import systems
from solver.systems.networks import GROUND, Element
from solver.systems.op_amp import OUTPUT

if TYPE_CHECKING:
    from solver.systems import Circuit, OpAmp
    from solver.systems.op_amp import Part


def circuit_of(system: OpAmp) -> Circuit:
    """Return the stages as a circuit; its output is the voltage of the last node."""
    nodes = dict(_nodes(system))
    elements = [
        Element(f"V{i}" if len(system.inputs) > 1 else "V", (nodes[name], GROUND), source=name)
        for i, name in enumerate(system.inputs, 1)
    ]
    taken, initial = {each.name for each in elements}, {}
    for i, stage in enumerate(system.stages, 1):
        mark = str(i) if len(system.stages) > 1 else ""
        minus, out = f"n{mark}", nodes[stage.output]
        elements += [_element(part, (nodes[name], minus), taken) for name, part in stage.inputs]
        elements.append(_element(stage.feedback, (out, minus), taken))
        if stage.initial != 0:
            initial[(f"v_{elements[-1].name}", 0)] = stage.initial
        elements.append(Element(f"O{mark}", (out, GROUND), controls=(GROUND, minus)))
    states = tuple(f"v_{each.name}" for each in elements if each.letter == "C")
    return systems.Circuit(tuple(elements), (systems.symbol_of(OUTPUT),), states, initial, assumed=system.assumed)


def _nodes(system: OpAmp) -> Iterator[tuple[str, str]]:
    """The nodes of signals: that of v_in is called in, so that its voltage has the name of the signal."""
    for i, name in enumerate(system.outputs[:-1], 1):
        yield name, f"o{i}"
    yield OUTPUT, "o"
    count = len(system.inputs)
    for i, name in enumerate(system.inputs, 1):
        own = name[2:] if name.startswith("v_") and name[2:].isalpha() and name[2:] not in ("n", "o") else ""
        yield name, own or (f"in{i}" if count > 1 else "in")


def _element(part: Part, nodes: tuple[str, str], taken: set[str]) -> Element:
    """A part as an element; a name that is taken gets a number."""
    name = base = str(part.symbol)
    number = 2
    while name in taken:
        name, number = f"{base}_{number}", number + 1
    taken.add(name)
    return Element(name, nodes, part.value)
