"""Usual mistakes with circuits, as the circuit that would have the value submitted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations
from typing import TYPE_CHECKING, Any, TypeVar

from solver.derivation import Options, Slip, Task
from solver.lazy import systems

if TYPE_CHECKING:
    from solver.systems import Circuit
    from solver.systems.networks import Element

O = TypeVar("O", bound=Options)

SOURCE_REVERSED = Slip("source_sign", "the source counts the other way round")
CURRENT_REVERSED = Slip("current_sign", "the current of an inductor counts the other way round")
CONTROLLED_REVERSED = Slip("controlled_sign", "the controlled source has the wrong sign")
STORES_EXCHANGED = Slip("L_and_C", "inductance and capacitance are exchanged")
IN_PARALLEL = Slip("series_parallel", "resistors in series are taken as parallel, or the reverse")


def name_mistakes(task: Task[Any, Any]) -> None:
    """Register what goes wrong with circuits in a task."""
    task.mistaken_question(SOURCE_REVERSED)(source_reversed)
    task.mistaken_question(CURRENT_REVERSED)(current_reversed)
    task.mistaken_question(CONTROLLED_REVERSED)(controlled_reversed)
    task.mistaken_question(STORES_EXCHANGED)(stores_exchanged)
    task.mistaken_question(IN_PARALLEL)(in_parallel)


def _changed(system: Any, options: O, elements: Sequence[Element]) -> tuple[Circuit, O] | None:
    """The question about a circuit with other elements; None where nothing is changed."""
    circuit: Circuit = system
    return None if tuple(elements) == circuit.elements else (replace(circuit, elements=tuple(elements)), options)


def _reversed(system: Any, options: O, letters: str) -> tuple[Circuit, O] | None:
    if not isinstance(system, systems.Circuit):
        return None
    turned = [replace(e, nodes=e.nodes[::-1]) if e.letter in letters else e for e in system.elements]
    return _changed(system, options, turned)


def source_reversed(system: Any, options: O) -> tuple[Circuit, O] | None:
    """Each independent source between its nodes in reverse."""
    return _reversed(system, options, "VI")


def current_reversed(system: Any, options: O) -> tuple[Circuit, O] | None:
    """Each inductor between its nodes in reverse."""
    return _reversed(system, options, "L")


def controlled_reversed(system: Any, options: O) -> tuple[Circuit, O] | None:
    """Each controlled source between its nodes in reverse."""
    return _reversed(system, options, "EFGH")


def stores_exchanged(system: Any, options: O) -> tuple[Circuit, O] | None:
    """The value of the only inductor with that of the only capacitor."""
    if not isinstance(system, systems.Circuit):
        return None
    stores = [[e for e in system.elements if e.letter == letter] for letter in "LC"]
    if [len(each) for each in stores] != [1, 1]:
        return None
    ((coil,), (capacitor,)) = stores
    values = {coil.name: capacitor.value, capacitor.name: coil.value}
    return _changed(system, options, [replace(e, value=values.get(e.name, e.value)) for e in system.elements])


def in_parallel(system: Any, options: O) -> tuple[Circuit, O] | None:
    """Two resistors between the same nodes one after the other, or two in a row beside each other."""
    if not isinstance(system, systems.Circuit):
        return None
    ends = [node for e in system.elements for node in (*e.nodes, *e.watched)]
    for first, second in combinations([e for e in system.elements if e.letter == "R"], 2):
        if set(first.nodes) == set(second.nodes):
            (a, b), middle = first.nodes, "_".join((first.name, second.name))
            return _changed(system, options, _put(system, {first: (a, middle), second: (middle, b)}))
        shared = [node for node in set(first.nodes) & set(second.nodes) if ends.count(node) == 2 and node != "0"]
        if shared:
            outer = tuple(node for e in (first, second) for node in e.nodes if node not in shared)
            return _changed(system, options, _put(system, {first: outer, second: outer}))
    return None


def _put(circuit: Circuit, nodes: dict[Element, Any]) -> list[Element]:
    """The elements, some between other nodes."""
    return [replace(e, nodes=nodes[e]) if e in nodes else e for e in circuit.elements]
