"""Signal-flow graphs: nodes that are signals, branches that add a gain times one signal to another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from solver.lazy import sympy as sp
from solver.systems.kind import Key, Kind, ListOf, Reader, Value

if TYPE_CHECKING:
    from sympy import Expr, Symbol

KEY = "signal_flow"
MOST_BRANCHES = 40
"""Of a larger graph the paths and loops would not be listed."""


@dataclass(frozen=True, slots=True)
class Branch:
    """A branch that adds `gain` times the signal of the node `source` to that of the node `target`."""

    source: str
    target: str
    gain: Expr


@dataclass(frozen=True)
class SignalFlow:
    """The branches in the order of the file; parallel ones may be among them. `input` and `output` are nodes."""

    branches: tuple[Branch, ...]
    input: str
    output: str
    discrete: bool = False
    sample_time: Expr | None = None

    @property
    def kind(self) -> str:
        """The name of the kind that words it."""
        return KEY

    @property
    def variable(self) -> Symbol:
        """The symbol s (discrete: z)."""
        return sp.Symbol("z" if self.discrete else "s")

    @cached_property
    def nodes(self) -> tuple[str, ...]:
        """The names of the nodes, the input first, the others in the order in which they occur."""
        return tuple(
            dict.fromkeys([self.input, *(end for each in self.branches for end in (each.source, each.target))])
        )

    @cached_property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols of the gains but the variable, sorted by name."""
        found: set[Any] = set().union(*(each.gain.free_symbols for each in self.branches))
        return tuple(sorted(found - {self.variable}, key=str))

    def symbol(self, node: str) -> Symbol:
        """Return the symbol of a node; one that is numbered only is a signal x."""
        return node_symbol(node)

    @property
    def rows(self) -> list[tuple[Symbol, Symbol, Expr]]:
        """The branches with the symbols of their nodes."""
        return [(node_symbol(each.source), node_symbol(each.target), each.gain) for each in self.branches]

    @property
    def provides(self) -> frozenset[str]:
        """A task can ask for the graph."""
        return frozenset({KEY})

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return "the system is given by a signal-flow graph"

    def size(self, of: str) -> int | None:
        """Return the number of inputs "m" or outputs "p"; that of states is not known yet."""
        return {"m": 1, "p": 1}.get(of)

    def names(self, of: str) -> tuple[str, ...]:
        """Return the names of the "input" or "output"."""
        return {"input": (self.input,), "output": (self.output,)}.get(of, ())


def node_symbol(node: str) -> Symbol:
    """Return the symbol of a node; one that is numbered only is a signal x."""
    return sp.Symbol(f"x_{node}" if node.isdigit() else node)


def _read(reader: Reader) -> SignalFlow:
    """Return the graph; input and output are nodes of it, and the one leads to the other."""
    branches = tuple(Branch(*each) for each in reader.branches(KEY))
    ends = [reader.node_name(key) for key in ("input", "output")]
    reader.conclude()
    if len(branches) > MOST_BRANCHES:
        reader.complain(KEY, f"a graph of at most {MOST_BRANCHES} branches can be read", at_key=True)
    nodes = list(dict.fromkeys(end for each in branches for end in (each.source, each.target)))
    for key, name in zip(("input", "output"), ends, strict=True):
        if name not in nodes:
            reader.complain(key, f"there is no node {name}; the nodes are {', '.join(nodes)}", like=nodes)
    reader.conclude()
    start, end = ends
    for item, message in _faults(branches, start, end):
        if item is None:
            reader.complain("output", message)
        else:
            reader.complain_branch(KEY, item, message)
    reader.conclude()
    return SignalFlow(branches, start, end, reader.discrete, reader.sample_time)


def _faults(branches: Sequence[Branch], start: str, end: str) -> Iterator[tuple[int | None, str]]:
    """Yield what is wrong with the graph as a whole: the number of a branch (None: the output), and a message."""
    for item, each in enumerate(branches):
        if each.target == start:
            yield item, f"a branch leads into the input {start}: an input is given; let the branch end at another node"
    letters = {str(symbol) for each in branches for symbol in each.gain.free_symbols}
    for item, each in enumerate(branches):
        for name in (each.source, each.target):
            if name in letters:
                yield item, f"{name} is a node and stands in a gain; give one of them another name"
                letters.discard(name)
    if start == end:
        yield None, f"input and output are the same node, {start}"
    elif end not in reached(branches, start):
        yield None, f"no branches lead from the input {start} to {end}"


def reached(branches: Sequence[Branch], start: str) -> set[str]:
    """Return the nodes to which branches lead from one, itself among them."""
    found, waiting = {start}, [start]
    while waiting:
        node = waiting.pop()
        new = {each.target for each in branches if each.source == node} - found
        found |= new
        waiting += sorted(new)
    return found


SIGNAL_FLOW = Kind(
    KEY,
    doc="A signal-flow graph, or a block diagram as one.",
    keys=(
        Key(KEY, ListOf(ListOf(Value())), "branches [from, to, gain], gains in s (discrete: z)", required=True),
        Key("input", Value(), "the node that is given", required=True),
        Key("output", Value(), "the node that is asked for", required=True),
    ),
    read=_read,
    example=(
        ('signal_flow: [[r, e, 1], [e, y, "1/({x} + 1)"], [y, e, -1]]', "branches [from, to, gain]"),
        ("input: r", ""),
        ("output: y", ""),
    ),
)
