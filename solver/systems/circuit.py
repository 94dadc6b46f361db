"""Electrical networks as a netlist: resistors, inductors, capacitors, sources, ideal operational amplifiers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from functools import cached_property
from typing import TYPE_CHECKING, Any

from solver.jets import Jet, jet_symbol
from solver.lazy import sympy as sp
from solver.systems.kind import Key, Kind, ListOf, MappingTo, Reader, Value, Values
from solver.systems.netlists import KEY, floating, read_netlist
from solver.systems.networks import GROUND, Element, Tree, nodes_of, normal_tree

if TYPE_CHECKING:
    from sympy import Expr, Symbol


@dataclass(frozen=True)
class Circuit:
    """`elements` in the order of the list; `states` are names of inductor currents and capacitor voltages.

    `outputs` are expressions in voltages and currents (v_NAME, i_NAME, v_NODE) and inputs; `initial` are values of
    states at the beginning. `chosen` tells that the file names the states; what is `assumed` of states and
    inputs holds of its equations.
    """

    elements: tuple[Element, ...]
    outputs: tuple[Expr, ...]
    states: tuple[str, ...]
    initial: Mapping[Jet, Expr] = field(default_factory=dict)
    chosen: bool = False
    discrete: bool = False
    sample_time: Expr | None = None
    assumed: Mapping[str, Symbol] = field(default_factory=dict)

    @property
    def kind(self) -> str:
        """The name of the kind that words it."""
        return KEY

    @cached_property
    def inputs(self) -> tuple[str, ...]:
        """The names of the inputs, in the order of the list."""
        return tuple(dict.fromkeys(element.source for element in self.elements if element.source))

    @property
    def input_symbols(self) -> tuple[Symbol, ...]:
        """The symbols of the inputs."""
        return tuple(map(symbol_of, self.inputs))

    @cached_property
    def tree(self) -> Tree:
        """The normal tree."""
        return normal_tree(self.elements)

    @cached_property
    def is_linear(self) -> bool:
        """Whether no source is a constant other than zero, and outputs are sums of voltages, currents and inputs."""
        if any(each.letter in "VI" and each.value for each in self.elements):
            return False
        signals = [symbol_of(name) for name in (*signals_of(self.elements), *self.inputs)]
        slopes = [sp.diff(output, x) for output in self.outputs for x in signals]
        rests = [output.xreplace(dict.fromkeys(signals, sp.S.Zero)) for output in self.outputs]
        return not any(slope.has(*signals) for slope in slopes) and not any(rests)

    @property
    def functions(self) -> tuple[str, ...]:
        """The functions of time that its equations are about: states and inputs."""
        return (*self.states, *self.inputs)

    @property
    def nodes(self) -> tuple[str, ...]:
        """The nodes in the order in which they occur."""
        return nodes_of(self.elements)

    @cached_property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols but the voltages, currents and inputs, sorted by name."""
        own = {symbol_of(name) for name in (*signals_of(self.elements), *self.inputs)}
        values = [*self.outputs, *(element.value for element in self.elements if element.value is not None)]
        found: set[Any] = {symbol for value in values for symbol in value.free_symbols} - own
        return tuple(sorted(found, key=str))

    @property
    def provides(self) -> frozenset[str]:
        """The circuit; "inputs" and "initial_state" tell what a state space made of it will have."""
        given = {KEY, *(["inputs"] if self.inputs else []), *(["initial_state"] if self.initial else [])}
        return frozenset(given)

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return "the system is given by its circuit" + ("" if self.inputs else ", without inputs")

    def symbol(self, name: str) -> Symbol:
        """Return the symbol of a voltage, a current or an input."""
        return symbol_of(name)

    def size(self, of: str) -> int | None:
        """Return the number of states "n", inputs "m" or outputs "p"."""
        return {"n": len(self.states), "m": len(self.inputs), "p": len(self.outputs)}[of]

    def names(self, of: str) -> tuple[str, ...]:
        """Return the names of the "state"s and "input"s."""
        return {"input": self.inputs, "state": self.states}.get(of, ())


def symbol_of(name: str) -> Symbol:
    """Return the symbol of a voltage, a current or an input."""
    return jet_symbol((name, 0))


def voltage(element: Element) -> Symbol:
    """Return the symbol of the voltage of an element, from its first node to its second."""
    return symbol_of(f"v_{element.name}")


def current(element: Element) -> Symbol:
    """Return the symbol of the current of an element, from its first node to its second."""
    return symbol_of(f"i_{element.name}")


def signals_of(elements: Sequence[Element]) -> tuple[str, ...]:
    """Return the names of all voltages and currents: of elements, and of nodes."""
    of_elements = [f"{letter}_{element.name}" for element in elements for letter in "vi"]
    return (*of_elements, *(f"v_{node}" for node in nodes_of(elements) if node != GROUND))


def usual_states(elements: Sequence[Element]) -> tuple[str, ...]:
    """Return the names of inductor currents and capacitor voltages, in the order of the list."""
    return tuple(f"{'i' if each.letter == 'L' else 'v'}_{each.name}" for each in elements if each.letter in "LC")


def _read(reader: Reader) -> Circuit:
    """Return the circuit with its states, outputs and initial values."""
    elements = read_netlist(reader)
    if reader.discrete:
        reader.complain(KEY, "a circuit is a system in continuous time", at_key=True)
    reader.conclude()
    inputs = tuple(dict.fromkeys(element.source for element in elements if element.source))
    for item, message in _misnamed(elements, inputs):
        reader.complain(KEY, message, item=item)
    states = _states(reader, elements)
    outputs = _outputs(reader, elements, inputs)
    seen = {str(symbol)[2:] for output in outputs for symbol in output.free_symbols if str(symbol)[:2] == "v_"}
    for item, message in floating(elements, sorted(seen)):
        reader.complain(KEY, message, item=item)
    initial = reader.initial("initial", states)
    assumed = reader.assumed((*states, *inputs))
    reader.conclude()
    if not outputs:
        last = next(node for node in reversed(nodes_of(elements)) if node != GROUND)
        outputs = (symbol_of(states[0] if states else f"v_{last}"),)
    return Circuit(elements, outputs, states, initial, reader.gives("states"), assumed=assumed)


def _misnamed(elements: Sequence[Element], inputs: Sequence[str]) -> Iterator[tuple[int, str]]:
    """Yield names that would have two meanings: the number of an element, and a message."""
    names = {element.name for element in elements}
    signals, told = set(signals_of(elements)), set[str]()
    for i, element in enumerate(elements):
        for node in element.nodes:
            if node in names and node not in told:
                yield i, f"a node and an element are named {node}: v_{node} would have two meanings"
                told.add(node)
        own = {f"v_{element.name}", *(f"v_{node}" for node in element.nodes if GROUND in element.nodes)}
        if element.source in signals - (own if element.letter == "V" and element.nodes[1] == GROUND else set()):
            yield i, f"{element.source} is a voltage or a current of the circuit; give the input another name"
        for symbol in sorted(getattr(element.value, "free_symbols", ()), key=str):
            if str(symbol) in signals or str(symbol) in inputs:
                what = "an input" if str(symbol) in inputs else "a voltage or a current of the circuit"
                yield i, f"{symbol} is {what}, so it cannot be the value of {element.name}"


def _states(reader: Reader, elements: Sequence[Element]) -> tuple[str, ...]:
    """Return the states as named, else the usual ones."""
    usual = usual_states(elements)
    if not reader.gives("states"):
        return usual
    named = reader.names("states")
    for item, name in enumerate(named):
        if name not in usual:
            near = (get_close_matches(name, usual, n=1) or [""])[0]
            said = f"the states are {', '.join(usual)}" if usual else "there is neither an inductor nor a capacitor"
            reader.complain_inside("states", item, (0, len(name)), f"{name} is no state: {said}", near)
    lacking = [name for name in usual if name not in named]
    if lacking and set(named) <= set(usual):
        reader.complain("states", f"{', '.join(lacking)} {'is a state' if len(lacking) == 1 else 'are states'} too")
    return named


def _outputs(reader: Reader, elements: Sequence[Element], inputs: Sequence[str]) -> tuple[Expr, ...]:
    """Return the outputs; each is made of voltages, currents and inputs, and of values of the circuit."""
    signals = (*signals_of(elements), *inputs)
    outputs, jets = reader.formulas("outputs", signals)
    values = {str(s) for each in elements for s in getattr(each.value, "free_symbols", ())}
    for item, output in enumerate(outputs):
        inside = output.free_symbols
        names = sorted(str(symbol) for symbol in inside)
        if any(jets[symbol][1] for symbol in inside & set(jets)):
            reader.complain(
                "outputs", "an output is made of voltages and currents, not of their derivatives", item=item
            )
            continue
        strange = [name for name in names if name not in signals and name not in values]
        for name in strange[:1]:
            alike = [signal for signal in signals if signal.lower() == name.lower()]
            near = (alike or get_close_matches(name, signals, n=1) or [""])[0]
            text = reader.texts("outputs")[item]
            span = (max(text.find(name), 0), len(name) if name in text else len(text))
            message = f"{name} is no voltage and no current of the circuit (v_NAME, i_NAME, v_NODE)"
            reader.complain_inside("outputs", item, span, message, near)
        if not strange and not inside & set(jets):
            reader.complain("outputs", "no voltage and no current occurs in this output", item=item)
    return outputs


CIRCUIT = Kind(
    KEY,
    doc="An electrical network, one element a line.",
    keys=(
        Key(KEY, ListOf(Value()), "elements: NAME NODE NODE VALUE, a name begins with its kind", required=True),
        Key("outputs", Values(), "voltages and currents v_NAME, i_NAME, v_NODE; the first state if absent"),
        Key("states", Values(), "inductor currents and capacitor voltages in their order"),
        Key("initial", MappingTo(Value()), "initial values of states, as {i_L: 0, v_C: 1}"),
    ),
    read=_read,
    example=(
        (
            'circuit: ["V1 1 0 v_s", "R 1 2", "L 2 3", "C 3 0"]',
            "the value of a source names the input; node 0 is ground",
        ),
        ("outputs: [v_C]", "the states are i_L and v_C"),
    ),
)
