"""A functional: an integral of functions of time and their derivatives, with what is asked of them at its ends."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from solver.jets import Jet, jet_symbol
from solver.lazy import sympy as sp
from solver.stated.algebra import total
from solver.stated.calculus import integral, value_at
from solver.systems.ends import End, IntegralConstraint
from solver.systems.kind import AtEnd, Key, Keyed, Kind, ListOf, MappingTo, Reader, Value, Values

if TYPE_CHECKING:
    from sympy import Expr, Symbol

TIME = "t"
MULTIPLIERS = ("lambda", "lamda")
"""Spellings of the name of a multiplier before its number."""


@dataclass(frozen=True)
class Functional:
    """The integral of the `integrand` from `start` to `stop` (None: free), plus a `terminal_cost`.

    Expressions are in t, in the `functions` and their derivatives, whose symbols `jets` has; in the terminal cost these
    are the values at the end, and t is the end. `ends` are what is asked at both ends, of those that are named. The
    functions keep `constraints` (sides of equations) at all times and `integral_constraints` over all of the time.
    """

    integrand: Expr
    functions: tuple[str, ...]
    start: Expr
    stop: Expr | None
    ends: Mapping[Jet, tuple[End, End]] = field(default_factory=dict)
    terminal_cost: Expr = field(default_factory=lambda: sp.S.Zero)
    integral_constraints: tuple[IntegralConstraint, ...] = ()
    constraints: tuple[tuple[Expr, Expr], ...] = ()
    jets: Mapping[Symbol, Jet] = field(default_factory=dict)
    assumed: Mapping[str, Symbol] = field(default_factory=dict)

    @property
    def kind(self) -> str:
        """The name of the kind that words it."""
        return "functional"

    @property
    def discrete(self) -> bool:
        """Time is continuous."""
        return False

    @property
    def sample_time(self) -> Expr | None:
        """There is none."""
        return None

    @cached_property
    def t(self) -> Symbol:
        """The time."""
        return sp.Symbol(TIME)

    @cached_property
    def end_time(self) -> Expr:
        """The end of the time, by its name where it is free."""
        return sp.Symbol("t_f", real=True) if self.stop is None else self.stop

    @property
    def cost(self) -> Any:
        """The functional as it is written: the terminal cost and the integral."""
        whole = integral(self.integrand, self.t, self.start, self.end_time)
        return whole if self.terminal_cost == 0 else total(value_at(self.terminal_cost, self.t, self.end_time), whole)

    @property
    def integrals(self) -> list[tuple[Any, Expr]]:
        """The integrals of the constraints with their values."""
        return [(integral(b.integrand, self.t, self.start, self.end_time), b.value) for b in self.integral_constraints]

    @property
    def fixed(self) -> list[tuple[Symbol, Expr, Expr]]:
        """The values asked for: the function or derivative, the time, the value."""
        times = (self.start, self.end_time)
        return [
            (self.symbol(jet), time, end.value)
            for jet, pair in self.ends.items()
            for time, end in zip(times, pair, strict=True)
            if end.value is not None
        ]

    @property
    def open(self) -> list[tuple[Symbol, Expr]]:
        """The ends named as free: the function or derivative, the time."""
        times = (self.start, self.end_time)
        return [
            (self.symbol(jet), time)
            for jet, pair in self.ends.items()
            for time, end in zip(times, pair, strict=True)
            if end.free
        ]

    @property
    def curves(self) -> list[tuple[Symbol, Expr]]:
        """The curves on which functions end."""
        return [(self.symbol(jet), last.curve) for jet, (_, last) in self.ends.items() if last.curve is not None]

    @cached_property
    def expressions(self) -> tuple[Expr, ...]:
        """Everything that is given."""
        ends = [each for pair in self.ends.values() for end in pair for each in (end.value, end.curve)]
        integrals = [each for bound in self.integral_constraints for each in (bound.integrand, bound.value)]
        sides = [side for pair in self.constraints for side in pair]
        given = (self.integrand, self.start, self.stop, *ends, self.terminal_cost, *integrals, *sides)
        return tuple(each for each in given if each is not None)

    @cached_property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols but the time, the functions and their derivatives, sorted by name."""
        found: set[Any] = set().union(*(each.free_symbols for each in self.expressions)) - {*self.jets, self.t}
        return tuple(sorted(found, key=str))

    def assuming(self, assumed: Mapping[str, Symbol]) -> Functional:
        """Return the functional in symbols of which something is assumed, in place of those that are only real."""
        if not assumed:
            return self
        mine = replace(self, assumed=assumed)
        put: dict[Any, Any] = {symbol: mine.symbol(jet) for symbol, jet in self.jets.items()}
        return replace(
            mine,
            integrand=self.integrand.xreplace(put),
            terminal_cost=self.terminal_cost.xreplace(put),
            integral_constraints=tuple(
                IntegralConstraint(each.integrand.xreplace(put), each.value) for each in self.integral_constraints
            ),
            constraints=tuple((left.xreplace(put), right.xreplace(put)) for left, right in self.constraints),
            jets={put[symbol]: jet for symbol, jet in self.jets.items()},
        )

    @property
    def provides(self) -> frozenset[str]:
        """The functional."""
        return frozenset({"functional"})

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return "the question is about a functional"

    @cached_property
    def multipliers(self) -> tuple[str, ...]:
        """The names of the multipliers: functions for the constraints, then constants for those by integrals."""
        number = len(self.constraints) + len(self.integral_constraints)
        return tuple(f"lambda{i}" for i in range(1, number + 1))

    @cached_property
    def orders(self) -> Mapping[str, int]:
        """The highest derivative of each function in the integrands and constraints."""
        inside: set[Any] = set().union(*(each.free_symbols for each in self._of_time))
        found = {name: [k for symbol, (of, k) in self.jets.items() if of == name and symbol in inside]
                 for name in self.functions}  # fmt: skip
        return {name: max(orders, default=0) for name, orders in found.items()}

    @property
    def _of_time(self) -> list[Expr]:
        sides = [side for pair in self.constraints for side in pair]
        return [self.integrand, *(bound.integrand for bound in self.integral_constraints), *sides]

    def symbol(self, jet: Jet) -> Symbol:
        """Return the symbol of a function of time, or of its derivative."""
        return jet_symbol(jet, assumed=self.assumed)

    def symbols(self, order: int = 0) -> list[Symbol]:
        """Return the symbols of the functions, or of their derivatives."""
        return [self.symbol((name, order)) for name in self.functions]

    def size(self, of: str) -> int | None:  # noqa: ARG002 - whatever is asked
        """Return the number of states "n", inputs "m" and outputs "p": it has none."""
        return None

    def names(self, of: str) -> tuple[str, ...]:  # noqa: ARG002 - whatever is asked
        """Return the names of inputs and outputs: it has none."""
        return ()


def _read(reader: Reader) -> Functional:
    """Return the functional; its functions are those that occur with a derivative, where none are named."""
    if reader.discrete:
        reader.complain("time", "a functional is an integral over continuous time")
    inner = reader.within("functional")
    inner.timed = True
    named = inner.names("functions") or tuple(
        dict.fromkeys([*inner.dynamic_names("integrand"), *inner.dynamic_names("constraints")])
    )
    if not named:
        inner.complain("integrand", "no function occurs with a derivative: name them, as in functions: [x]")
    return _Parts(inner, named).read()


class _Parts:
    """Reads what stands under `functional`, and keeps the derivatives that occur."""

    def __init__(self, reader: Reader, functions: tuple[str, ...]) -> None:
        self.reader = reader
        self.functions = functions
        self.jets: dict[Any, Jet] = {}

    def read(self) -> Functional:
        """Return the functional; every fault is raised together."""
        reader = self.reader
        integrand = self._formula(reader, "integrand")
        integrals = [(self._formula(each, "integrand"), self._number(each, "value"))
                     for each in reader.each("integral_constraints")]  # fmt: skip
        sides, jets = reader.relations("constraints", self.functions)
        self.jets |= jets
        free = list(reader.texts("to")) == ["free"]
        start, stop = self._number(reader, "from"), None if free else self._number(reader, "to")
        inside = set(self.jets.values())
        orders = {name: max((k for of, k in inside if of == name), default=0) for name in self.functions}
        ends = reader.ends("ends", orders, free_time=free)
        cost = self._formula(reader, "terminal_cost")
        self._check_times(start, stop)
        self._check_names(inside, [cost, integrand, *(each for pair in integrals for each in pair)])
        assumed = reader.assumed(self.functions)
        reader.conclude()
        if cost is not None and free:
            cost = cost.xreplace({each: sp.Symbol(TIME) for each in cost.free_symbols if str(each) in ("t_f", "tf")})
        usual = {jet_symbol((name, k)): (name, k) for name in self.functions for k in (0, 1)}
        found = Functional(
            integrand or sp.S.Zero, self.functions, sp.S.Zero if start is None else start, stop,
            {jet: (first, last) for jet, (first, last) in ends.items()}, cost or sp.S.Zero,
            tuple(IntegralConstraint(f or sp.S.Zero, v or sp.S.Zero) for f, v in integrals),
            tuple(sides), {**usual, **self.jets},
        )  # fmt: skip
        return found.assuming(assumed)

    def _formula(self, reader: Reader, key: str) -> Expr | None:
        found, jets = reader.formulas(key, self.functions)
        self.jets |= jets
        return found[0] if found else None

    def _number(self, reader: Reader, key: str) -> Expr | None:
        """A value that does not vary with time."""
        found, _ = reader.formulas(key, ())
        for i, each in enumerate(found):
            if each.has(sp.Symbol(TIME)):
                reader.complain(key, "this is to be a value, no function of t", item=i)
        return found[0] if found else None

    def _check_times(self, start: Expr | None, stop: Expr | None) -> None:
        """The first time is given; the last one is after it, where both are numbers."""
        if list(self.reader.texts("from")) == ["free"]:
            self.reader.complain("from", "only the end of the time may be free")
        elif start is not None and stop is not None and (stop - start).is_positive is False:
            self.reader.complain("to", "the last time is to be after the first one")

    def _check_names(self, inside: set[Jet], found: list[Expr | None]) -> None:
        """Each function must occur; the names of multipliers must not."""
        reader, occurring = self.reader, {name for name, _ in inside}
        for i, name in enumerate(self.functions):
            if name not in occurring and reader.gives("functions"):
                reader.complain("functions", f"'{name}' occurs nowhere", item=i)
        key = next((key for key in ("constraints", "integral_constraints") if reader.gives(key)), None)
        named = {*self.functions, *(str(each) for value in found if value is not None for each in value.free_symbols)}
        taken = sorted(name for name in named if name.rstrip("0123456789") in MULTIPLIERS and name not in MULTIPLIERS)
        if key is not None and taken:
            message = f"'{taken[0]}' is the multiplier of a constraint: call what it stands for by another name"
            reader.complain(key, message, at_key=True)


_INTEGRALS = Keyed("integral_constraints", (
    Key("integrand", Value(), "in t, the functions and their derivatives", required=True),
    Key("value", Value(), "the value of its integral", required=True),
))  # fmt: skip
_FUNCTIONAL = Keyed("functional", (
    Key("integrand", Value(), "in t, the functions and their derivatives, as x^2 - x'^2", required=True),
    Key("functions", Values(), "the functions that are sought; those with a derivative if absent"),
    Key("from", Value(), "the first time", required=True),
    Key("to", Value(), "the last time, or free", required=True),
    Key("ends", MappingTo(ListOf(AtEnd())), 'both ends of functions and derivatives, as {x: [0, 1], "x\'": [0, free]}; '
        "the last one may be {on: 2 - t}"),
    Key("terminal_cost", Value(), "what is added, of the values at the last time (t is that time)"),
    Key("integral_constraints", ListOf(_INTEGRALS), "integrals with a given value"),
    Key("constraints", Values(), "equations that hold at all times, as [\"x1' = x2\", \"x2' = u\"]"),
))  # fmt: skip

FUNCTIONAL = Kind(
    "functional",
    doc="A functional of one or several functions of time, for the calculus of variations.",
    keys=(Key("functional", _FUNCTIONAL, "integrand, functions, times and ends", required=True),),
    read=_read,
    example=(
        (
            'functional: {integrand: "x\'^2 + x^2", functions: [x], from: 0, to: 1, ends: {x: [0, 1]}}',
            "an end is a value, free or {on: curve} with to: free",
        ),
    ),
)
