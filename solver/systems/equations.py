"""Differential (discrete: difference) equations as a problem gives them, with algebraic ones among them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from solver.jets import Jet, jet_symbol
from solver.lazy import sympy as sp
from solver.stated.algebra import total
from solver.systems.kind import Key, Kind, ListOf, MappingTo, Reader, Value, Values

if TYPE_CHECKING:
    from sympy import Expr, Symbol


@dataclass(frozen=True)
class Equations:
    """`sides` are left and right of each equation, `jets` the derivatives that occur in them, by their symbols.

    `unknowns` are the functions asked for in their order, `algebraic` those among them that are to be eliminated,
    `inputs` the given ones; `states` are as named (none: the usual ones); `outputs` are expressions in the jets,
    `initial` the values of jets at the beginning. `written` are the terms of the sides in the order of the file.
    `assumed` are the symbols of functions of which something is assumed, by their names.
    """

    sides: tuple[tuple[Expr, Expr], ...]
    unknowns: tuple[str, ...]
    algebraic: tuple[str, ...] = ()
    inputs: tuple[str, ...] = ()
    states: tuple[Jet, ...] = ()
    outputs: tuple[Expr, ...] = ()
    initial: Mapping[Jet, Expr] = field(default_factory=dict)
    jets: Mapping[Symbol, Jet] = field(default_factory=dict)
    discrete: bool = False
    sample_time: Expr | None = None
    written: tuple[tuple[tuple[Expr, ...], ...], ...] = ()
    assumed: Mapping[str, Symbol] = field(default_factory=dict)

    @property
    def as_written(self) -> Sequence[tuple[Any, Any]]:
        """Left and right side of each equation, with the terms in the order of the file."""
        shown = [
            tuple(
                total(*terms) if len(terms) > 1 and sp.Add(*terms) == side else side
                for terms, side in zip(written, sides, strict=True)
            )
            for written, sides in zip(self.written, self.sides, strict=True)
        ]
        return [(left, right) for left, right in shown] if shown else self.sides

    @property
    def kind(self) -> str:
        """The name of the kind that words it."""
        return "equations"

    @property
    def functions(self) -> tuple[str, ...]:
        """The functions of time: unknowns and inputs."""
        return (*self.unknowns, *self.inputs)

    @property
    def idle_inputs(self) -> tuple[str, ...]:
        """The inputs that occur in no equation and in no output."""
        inside = {name for symbol, (name, _) in self.jets.items() if any(e.has(symbol) for e in self._written)}
        return tuple(name for name in self.inputs if name not in inside)

    @property
    def _written(self) -> list[Expr]:
        """The sides and the outputs."""
        return [side for pair in self.sides for side in pair] + list(self.outputs)

    @cached_property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols but the functions of time, their derivatives and the number of a sample, sorted by name."""
        found: set[Any] = {symbol for side in self._written for symbol in side.free_symbols} - set(self.jets)
        return tuple(sorted((each for each in found if not (self.discrete and each.name == "k")), key=str))

    def symbol(self, jet: Jet) -> Symbol:
        """Return the symbol of a derivative."""
        return jet_symbol(jet, discrete=self.discrete, assumed=self.assumed)

    def assuming(self, assumed: Mapping[str, Symbol]) -> Equations:
        """Return the equations in symbols of which something is assumed, in place of those that are only real."""
        if not assumed:
            return self
        mine = replace(self, assumed=assumed)
        put: dict[Any, Any] = {symbol: mine.symbol(jet) for symbol, jet in self.jets.items()}
        return replace(
            mine,
            sides=tuple((left.xreplace(put), right.xreplace(put)) for left, right in self.sides),
            outputs=tuple(output.xreplace(put) for output in self.outputs),
            jets={put[symbol]: jet for symbol, jet in self.jets.items()},
            written=tuple(tuple(tuple(t.xreplace(put) for t in side) for side in pair) for pair in self.written),
        )

    @property
    def provides(self) -> frozenset[str]:
        """The equations, and when it is at "rest"; "inputs" and "initial_state" tell what a state space of it has.

        In continuous time they are what a "machine" computes.
        """
        given = {"inputs"} if self.inputs else set()
        started = ["initial_state"] if self.initial else []
        return frozenset({"equations", "rest", *given, *started, *([] if self.discrete else ["machine"])})

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return "the system is given by its equations" + ("" if self.inputs else ", without inputs")

    def size(self, of: str) -> int | None:
        """Return the number of inputs "m" and outputs "p"; that of states, where they are named."""
        return {"n": len(self.states) or None, "m": len(self.inputs), "p": len(self.outputs)}[of]

    def names(self, of: str) -> tuple[str, ...]:
        """Return the names of the "input"s."""
        return self.inputs if of == "input" else ()


def _read(reader: Reader) -> Equations:
    """Return the equations; unknowns are named by their derivatives, as states or as algebraic ones."""
    inputs = reader.names("inputs")
    algebraic = reader.names("algebraic")
    states = reader.jets("states")
    named = dict.fromkeys([*reader.dynamic_names("equations"), *(name for name, _ in states), *algebraic])
    if not (named or reader.discrete) and (static := _static(reader)):
        algebraic, others = static
        named, inputs = dict.fromkeys(algebraic), inputs or others
    unknowns = tuple(name for name in named if name not in inputs)
    functions = (*unknowns, *inputs)
    sides, jets = reader.relations("equations", functions)
    outputs, of_outputs = reader.formulas("outputs", functions)
    initial = reader.initial("initial", functions)
    reader.conclude()
    _check_numbers(reader, sides, jets, unknowns, tuple(states), algebraic)
    check_outputs(reader, outputs, of_outputs, functions)
    assumed = reader.assumed(functions)
    reader.conclude()
    if not outputs:
        first = jet_symbol((unknowns[0], 0), discrete=reader.discrete)
        outputs, of_outputs = (first,), {first: (unknowns[0], 0)}
    known = {**jets, **of_outputs}
    found = Equations(
        tuple(sides), unknowns, algebraic, inputs, tuple(states), tuple(outputs), initial, known,
        reader.discrete, reader.sample_time, reader.written("equations", functions),
    )  # fmt: skip
    return found.assuming(assumed)


def _static(reader: Reader) -> tuple[tuple[str, ...], tuple[str, ...]] | None:
    """Of relations without derivatives, v_o = -v1 - 10 v2, the names alone on the left, and all other names.

    None where a side on the left is no name alone, or there is no name on the right.
    """
    sides, _ = reader.relations("equations", ())
    reader.conclude()
    left = tuple(str(side) for side, _ in sides if side.is_Symbol)
    terms = [term for _, right in reader.written("equations", ()) for term in right]
    named = dict.fromkeys(str(each) for term in terms for each in sorted(term.free_symbols, key=str))
    others = tuple(name for name in named if name not in left)
    return (left, others) if len(left) == len(sides) and others else None


def check_outputs(
    reader: Reader, outputs: Sequence[Expr], jets: Mapping[Symbol, Jet], functions: Sequence[str]
) -> None:
    """An output changes with time: a mistyped name would be a parameter."""
    for i, output in enumerate(outputs):
        if output.free_symbols and not output.free_symbols & set(jets):
            reader.complain("outputs", "no unknown and no input occurs in this output", item=i, like=functions)


def _check_numbers(
    reader: Reader,
    sides: tuple[tuple[Expr, Expr], ...],
    jets: Mapping[Symbol, Jet],
    unknowns: tuple[str, ...],
    states: tuple[Jet, ...],
    algebraic: tuple[str, ...],
) -> None:
    """As many equations as unknowns, each unknown in one of them; a state is below the highest derivative."""
    inside = [{jet for symbol, jet in jets.items() if any(side.has(symbol) for side in pair)} for pair in sides]
    orders = {name: max((k for jet, k in set().union(*inside) if jet == name), default=None) for name in unknowns}
    if not unknowns:
        reader.complain("equations", "no unknown is found: none occurs with a derivative, or is named by 'states'")
        return
    idle = [i for i, found in enumerate(inside) if not any(name in unknowns for name, _ in found)]
    twice = [i for i, pair in enumerate(sides) if i not in idle and pair in sides[:i]]
    for i in idle:
        reader.complain("equations", "no unknown occurs in this equation", item=i)
    for i in twice:
        reader.complain("equations", "this equation stands above already", item=i)
    lacking = [name for name, order in orders.items() if order is None]
    for name in lacking:
        key = "algebraic" if name in algebraic else "states"
        at = algebraic.index(name) if name in algebraic else [each for each, _ in states].index(name)
        others = [other for other in unknowns if other not in lacking]
        reader.complain(key, f"there is no equation for {name}", item=at, like=others)
    if len(sides) != len(unknowns) and not (idle or twice or lacking):
        counts = ((len(sides), "equation"), (len(unknowns), "unknown"))
        given, wanted = (f"{n} {what}{'s' * (n != 1)}" for n, what in counts)
        reader.complain("equations", f"{given} for {wanted} ({', '.join(unknowns)})")
    for name, k in () if reader.discrete else states:
        if orders.get(name) is not None and k >= (orders[name] or 0):
            message = f"is no state: the highest derivative of {name} is of order {orders[name]}"
            reader.complain("states", name + "'" * k + " " + message)


EQUATIONS = Kind(
    "equations",
    doc="Differential equations (discrete: difference equations), with algebraic ones among them.",
    keys=(
        Key("equations", ListOf(Value()), "each left = right, or an expression that is zero", required=True),
        Key("inputs", Values(), "names of the inputs"),
        Key("outputs", Values(), "expressions; the first unknown if absent"),
        Key("states", Values(), "the states in their order, as [x, x'] (discrete: [y(k), y(k+1)])"),
        Key("algebraic", Values(), "unknowns without a derivative, which are eliminated"),
        Key("initial", MappingTo(Value()), 'initial values, as {x: 0, "x\'": 1}'),
    ),
    read=_read,
    example=(
        ("equations: [\"m x'' + d x' + k x = u\"]", "x' and x'' are derivatives"),
        ("inputs: [u]", "every other name is a parameter"),
    ),
)
