"""Inverting stages of operational amplifiers as a textbook draws them: inputs at the left, the feedback above.

The stages stand side by side; the first input of each comes from the stage before along a straight wire, the others
from terminals that lie below it. Units are those of `circuit_layout`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from solver.derivation.figures import Component, Schematic
from solver.figures.laid_circuits import Amplifier, CircuitLayout, Placed, Point, Terminal, dots_of

GROUND = "0"
PART, ROW, PINS, LANE = 2.6, 1.35, 1.0, 1.5
"""Length of a part with its ends, distance of rows, of the inputs of an amplifier, and of lanes above it."""
NODE, FRONT, BODY, OUT, APART = 0.7, 1.5, 1.9, 0.9, 0.7
"""How far behind the inputs the feedback branches off and the amplifier begins; how long it and its wire are, and more
before the next stage."""


@dataclass(frozen=True)
class Drawn:
    """A stage: its amplifier, the parts at its inputs with the nodes that they come from, and those in the feedback."""

    amplifier: Component
    inputs: Sequence[tuple[str, Component]]
    feedback: Sequence[Component]

    @property
    def output(self) -> str:
        """The node of the output."""
        return self.amplifier.nodes[0]


def stages_in(schematic: Schematic) -> list[Drawn] | None:
    """Return the stages from left to right; None where there is anything else in the circuit."""
    sources = {_other(each, GROUND): each for each in schematic.components if each.letter == "V"}
    amplifiers = [each for each in schematic.components if each.letter == "O"]
    parts = [each for each in schematic.components if each.letter not in "VO"]
    if not amplifiers or any(each.inputs[0] != GROUND for each in amplifiers) or "" in sources:
        return None
    outputs = [each.nodes[0] for each in amplifiers]
    found, used = [], 0
    for amplifier in amplifiers:
        joined = [(_other(each, amplifier.inputs[1]), each) for each in parts if amplifier.inputs[1] in each.nodes]
        feedback = [each for node, each in joined if node == amplifier.nodes[0]]
        inputs = [(node, each) for node, each in joined if node != amplifier.nodes[0]]
        known = all(node in sources or node in outputs for node, _ in inputs)
        if not feedback or not inputs or not known or any(each.letter not in "RLC" for _, each in joined):
            return None
        used += len(joined)
        found.append(Drawn(amplifier, inputs, feedback))
    return _in_order(found) if used == len(parts) else None


def _other(each: Component, node: str) -> str:
    """The other end of a component, "" where the node is no end of it."""
    a, b = each.nodes
    return b if a == node else a if b == node else ""


def _in_order(stages: Sequence[Drawn]) -> list[Drawn] | None:
    """The stages so that each is fed by those before it, by the last of them first; None where there is a loop."""
    found: list[Drawn] = []
    waiting = list(stages)
    while waiting:
        ahead = {each.output for each in waiting}
        free = [each for each in waiting if not any(node in ahead for node, _ in each.inputs)]
        if not free:
            return None
        last = found[-1].output if found else ""
        following = next((each for each in free if any(node == last for node, _ in each.inputs)), free[0])
        waiting.remove(following)
        inputs = sorted(following.inputs, key=lambda pair: pair[0] != last)
        found.append(Drawn(following.amplifier, inputs, following.feedback))
    return found


def stages_layout(schematic: Schematic) -> CircuitLayout | None:
    """Return the layout of inverting stages, None where the circuit is none or a stage does not feed the next."""
    stages = stages_in(schematic)
    if stages is None or any(each.inputs[0][0] != before.output for before, each in pairwise(stages)):
        return None
    labels = {_other(each, GROUND): each.label for each in schematic.components if each.letter == "V"}
    labels = {**{each.output: output_label(each.output) for each in stages}, **labels, **dict(schematic.voltages)}
    layout, at = CircuitLayout(), (0.0, 0.0)
    for i, stage in enumerate(stages):
        at = _place(layout, stage, at, labels, first=i == 0)
        if i + 1 < len(stages):
            layout.voltages.append(((at[0] - OUT / 2, at[1]), labels[stage.output]))
            layout.wires.append((at, (at[0] + APART, at[1])))
            at = at[0] + APART, at[1]
        layout.names.append(((at[0], at[1] + 0.1), stage.output))
    layout.terminals.append(Terminal(at, labels[stages[-1].output], right=True))
    if schematic.voltages:
        layout.names.clear()
    else:
        layout.voltages.clear()
    layout.dots = dots_of(layout)
    return layout


def output_label(node: str) -> str:
    """The voltage of a node as LaTeX."""
    return f"v_{{{node}}}" if node.isalnum() else r"v_{\mathrm{" + node.replace("_", r"\_") + "}}"


def _place(layout: CircuitLayout, stage: Drawn, start: Point, labels: dict[str, str], *, first: bool) -> Point:
    """Place a stage whose first input comes from `start`; return where its output ends."""
    count = len(stage.inputs)
    bus, y = start[0] + PART, start[1]
    rows = [y + ((count - 1) / 2 - j) * ROW if first else y - j * ROW for j in range(count)]
    for (node, part), row in zip(stage.inputs, rows, strict=True):
        ends = (start[0], row), (bus, row)
        layout.placed.append(Placed(part, *(ends if part.nodes[0] == node else ends[::-1])))
        if first or row != y:
            layout.terminals.append(Terminal(ends[0], labels[node]))
            layout.names.append(((start[0] + 0.4, row), node))
    heights = sorted({*rows, y}, reverse=True)
    layout.wires += [((bus, a), (bus, b)) for a, b in pairwise(heights)]
    branch, front = bus + NODE, bus + FRONT
    layout.wires += [((bus, y), (branch, y)), ((branch, y), (front, y))]
    layout.names.append(((branch, y), stage.amplifier.inputs[1]))
    tip = (front + BODY, y - PINS / 2)
    layout.amplifiers.append(Amplifier(stage.amplifier, (front, y), (front, y - PINS), tip, True))
    pin = front - 0.35
    layout.wires.append(((front, y - PINS), (pin, y - PINS), (pin, y - PINS - 0.35)))
    layout.grounds.append((pin, y - PINS - 0.35))
    back = tip[0] + OUT / 2
    _feedback(layout, stage, (branch, y), (back, tip[1]))
    end = (tip[0] + OUT, tip[1])
    layout.wires += [(tip, (back, tip[1])), ((back, tip[1]), end)]
    return end


def _feedback(layout: CircuitLayout, stage: Drawn, left: Point, right: Point) -> None:
    """Place the parts of a feedback in lanes above the amplifier, with wires down at both ends."""
    below = left[1], right[1]
    for lane, part in enumerate(stage.feedback, 1):
        height = left[1] + LANE * lane
        middle = (left[0] + right[0]) / 2
        ends = (middle - PART / 2, height), (middle + PART / 2, height)
        turned = part.nodes[0] == stage.output
        layout.placed.append(Placed(part, *(ends[::-1] if turned else ends)))
        layout.wires += [
            ((left[0], below[0]), (left[0], height)),
            ((left[0], height), ends[0]),
            (ends[1], (right[0], height)),
            ((right[0], height), (right[0], below[1])),
        ]
        below = height, height
