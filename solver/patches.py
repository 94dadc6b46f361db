"""Programs of an analog computer: elements patched together, and what the shape of such a program shows."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

KEYS: Mapping[str, tuple[str, ...]] = {
    "source": ("value",),
    "pot": ("input", "setting"),
    "summer": ("inputs",),
    "integrator": ("inputs", "initial"),
    "inverter": ("input",),
}
"""The kinds of elements with what is written of each."""

AMPLIFIERS = ("summer", "integrator", "inverter")
"""The elements that change the sign."""


@dataclass(frozen=True, slots=True)
class Element:
    """One element of a program.

    `inputs` are the ids of what feeds it, each with its gain (1 for a potentiometer and an inverter). A source has a
    `value` in volts: a number, the symbol of an input or an expression in tau; a potentiometer its `setting`; an
    integrator the volts of its output at the start, `initial`: it computes v = initial - ∫ Σ gain·input dτ.
    """

    id: str
    kind: str
    inputs: tuple[tuple[str, Any], ...] = ()
    value: Any = None
    setting: Any = None
    initial: Any = None

    @property
    def is_amplifier(self) -> bool:
        """Whether it is a summer, an integrator or an inverter."""
        return self.kind in AMPLIFIERS


@dataclass(frozen=True, slots=True)
class Program:
    """The elements in the order of the list; `readout`: a variable is the volts of an element times a factor."""

    reference: Any
    elements: tuple[Element, ...]
    readout: Mapping[str, tuple[str, Any]]

    def __getitem__(self, name: str) -> Element:
        """Return the element of that id. Raises KeyError."""
        for each in self.elements:
            if each.id == name:
                return each
        raise KeyError(name)

    def of_kind(self, *kinds: str) -> list[Element]:
        """Return the elements of some kinds in their order."""
        return [each for each in self.elements if each.kind in kinds]

    @property
    def potentiometers(self) -> dict[str, Any]:
        """The setting of each potentiometer by its id."""
        return {each.id: each.setting for each in self.of_kind("pot")}

    def destinations(self, name: str) -> list[tuple[Element, Any]]:
        """Return the elements that an element feeds, with the gain of each of these inputs."""
        return [(each, gain) for each in self.elements for source, gain in each.inputs if source == name]


class PatchFault(NamedTuple):
    """What is wrong with a program: where (keys and places in its data) and what, a sentence without a full stop.

    `kind` is "form" where it cannot be read, else "loop", "setting", "gain", "reference": it could not be patched.
    """

    place: tuple[str | int, ...]
    message: str
    kind: str = "form"


class NotAProgram(ValueError):  # noqa: N818 - said of a value, not of the program
    """Data that are no program; `faults` say why."""

    def __init__(self, faults: Sequence[PatchFault]) -> None:
        super().__init__("; ".join(each.message for each in faults))
        self.faults: tuple[PatchFault, ...] = tuple(faults)


def data_of(program: Program, number: Callable[[Any], Any], text: Callable[[Any], str]) -> dict[str, Any]:
    """Return a program as JSON data; `number` makes a number of Python of an exact one, `text` writes an expression."""
    elements = []
    for each in program.elements:
        data: dict[str, Any] = {"id": each.id, "kind": each.kind}
        for key in KEYS[each.kind]:
            data[key] = _entry(each, key, number, text)
        elements.append(data)
    readout = {name: [fed, number(factor)] for name, (fed, factor) in program.readout.items()}
    return {"reference": number(program.reference), "elements": elements, "readout": readout}


def _entry(element: Element, key: str, number: Callable[[Any], Any], text: Callable[[Any], str]) -> Any:
    if key == "input":
        return element.inputs[0][0]
    if key == "inputs":
        return [[fed, number(gain)] for fed, gain in element.inputs]
    value = getattr(element, key)
    return text(value) if key == "value" and value.free_symbols else number(value)


def program_of(data: Any, read: Callable[[Any], Any]) -> Program:
    """Return the program that JSON data describe; `read` makes a value of a number or a text, ValueError if it cannot.

    Raises NotAProgram with every fault of form. What could be read and not patched is told by `faults_of`.
    """
    faults = list(_faults_of_form(data))
    if faults:
        raise NotAProgram(faults)
    reader = _Reader(read, [])
    elements = tuple(reader.element(i, each) for i, each in enumerate(data["elements"]))
    known = {each.id for each in elements}
    readout = {}
    for name, (fed, factor) in data["readout"].items():
        readout[str(name)] = (str(fed), reader.number(factor, ("readout", name)))
        if str(fed) not in known:
            reader.faults.append(PatchFault(("readout", name), f"there is no element {fed}"))
    reference = reader.number(data["reference"], ("reference",))
    reader.faults.extend(_faults_of_names(elements, known))
    if reader.faults:
        raise NotAProgram(reader.faults)
    return Program(reference, elements, readout)


def faults_of(program: Program, gains: Iterable[Any] = ()) -> Iterator[PatchFault]:
    """Yield why a program could not be patched on a machine with these gains (none given: any gain will do)."""
    allowed = list(gains)
    for i, each in enumerate(program.elements):
        place = ("elements", i)
        if each.kind == "pot" and not 0 <= each.setting <= 1:
            yield PatchFault((*place, "setting"), f"the setting of {each.id} is not between 0 and 1", "setting")
        for j, (fed, gain) in enumerate(each.inputs):
            if each.kind in ("summer", "integrator") and allowed and gain not in allowed:
                told = f"{each.id} has the gain {gain} for {fed}, which the machine lacks"
                yield PatchFault((*place, "inputs", j), told, "gain")
        for key in ("value", "initial"):
            volts = getattr(each, key)
            if volts is not None and not volts.free_symbols and not abs(volts) <= program.reference:
                yield PatchFault((*place, key), f"{each.id} cannot have {volts} V: the reference is less", "reference")
    loop = algebraic_loop(program)
    if loop:
        yield PatchFault(("elements",), f"{' → '.join([*loop, loop[0]])} is a loop without an integrator", "loop")


def algebraic_loop(program: Program) -> list[str]:
    """Return the ids of a loop in which nothing integrates, in the order of the signal; empty if there is none."""
    _, rest = in_order(program)
    if not rest:
        return []
    waiting = {each.id: each for each in rest}
    path: list[str] = [rest[0].id]
    while True:  # against the signal: each that waits is fed by another one that waits
        fed = next(name for name, _ in waiting[path[-1]].inputs if name in waiting)
        if fed in path:
            return path[path.index(fed) :][::-1]
        path.append(fed)


def in_order(program: Program) -> tuple[list[Element], list[Element]]:
    """Return the elements so that each follows what feeds it, integrators first, and those on algebraic loops."""
    ordered = program.of_kind("integrator", "source")
    done = {each.id for each in ordered}
    rest = [each for each in program.elements if each.id not in done]
    while ready := [each for each in rest if all(name in done for name, _ in each.inputs)]:
        ordered += ready
        done |= {each.id for each in ready}
        rest = [each for each in rest if each.id not in done]
    return ordered, rest


@dataclass(frozen=True, slots=True)
class _Reader:
    """Reads values and keeps what is wrong with them."""

    read: Callable[[Any], Any]
    faults: list[PatchFault]

    def value(self, data: Any, place: tuple[str | int, ...]) -> Any:
        try:
            return self.read(data)
        except ValueError:
            self.faults.append(PatchFault(place, f"{data!r} is not a value"))
            return None

    def number(self, data: Any, place: tuple[str | int, ...]) -> Any:
        value = self.value(data, place)
        if value is not None and (value.free_symbols or not value.is_real):
            self.faults.append(PatchFault(place, f"{data!r} is not a number"))
        return value

    def element(self, i: int, data: Mapping[str, Any]) -> Element:
        place = ("elements", i)
        inputs = [(data["input"], 1)] if "input" in data else data.get("inputs", [])
        return Element(
            str(data["id"]),
            data["kind"],
            tuple((str(fed), self.number(gain, (*place, "inputs", j))) for j, (fed, gain) in enumerate(inputs)),
            self.value(data["value"], (*place, "value")) if "value" in data else None,
            self.number(data["setting"], (*place, "setting")) if "setting" in data else None,
            self.number(data.get("initial", 0), (*place, "initial")) if data["kind"] == "integrator" else None,
        )


def _faults_of_form(data: Any) -> Iterator[PatchFault]:
    """Yield where data have not the shape of a program."""
    if not isinstance(data, Mapping):
        yield PatchFault((), "a program is a mapping of reference, elements and readout")
        return
    for key, kind in (("reference", object), ("elements", Sequence), ("readout", Mapping)):
        if key not in data:
            yield PatchFault((), f"{key} is missing")
        elif not isinstance(data[key], kind) or (isinstance(data[key], str) and kind is not object):
            told = "a list" if kind is Sequence else "a mapping"
            yield PatchFault((key,), f"{key} is {told}")
    elements = data.get("elements")
    if isinstance(elements, Sequence) and not isinstance(elements, str):
        for i, each in enumerate(elements):
            yield from _faults_of_element(("elements", i), each)
    readout = data.get("readout")
    for name, each in readout.items() if isinstance(readout, Mapping) else ():
        if not _is_pair(each):
            yield PatchFault(("readout", name), "a readout is a pair: an element and a factor")


def _faults_of_element(place: tuple[str | int, ...], data: Any) -> Iterator[PatchFault]:
    if not isinstance(data, Mapping) or "id" not in data:
        yield PatchFault(place, "an element has an id and a kind")
        return
    kind: Any = data.get("kind")
    if kind not in KEYS:
        yield PatchFault(place, f"{data['id']} has no kind among {', '.join(KEYS)}")
        return
    for key in KEYS[kind]:
        if key not in data and key != "initial":
            yield PatchFault(place, f"{data['id']} has no {key}")
    for key in data:
        if key not in ("id", "kind", *KEYS[kind]):
            yield PatchFault((*place, key), f"{data['id']}: a {kind} has no {key}")
    inputs = data.get("inputs", [])
    if not isinstance(inputs, list) or not all(map(_is_pair, inputs)):
        yield PatchFault((*place, "inputs"), f"{data['id']}: inputs are pairs of an element and a gain")


def _faults_of_names(elements: Sequence[Element], known: set[str]) -> Iterator[PatchFault]:
    seen: set[str] = set()
    for i, each in enumerate(elements):
        if each.id in seen:
            yield PatchFault(("elements", i), f"there are two elements {each.id}")
        seen.add(each.id)
        for fed, _ in each.inputs:
            if fed not in known:
                yield PatchFault(("elements", i), f"{each.id} is fed by {fed}, which is no element")


def _is_pair(value: Any) -> bool:
    return isinstance(value, Sequence) and not isinstance(value, str) and len(value) == 2
