"""Every link of every displayed chain is evaluated by the oracle, with the names on the page bound to their values."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.derivation.displayed import Written
from solver.displayed.budget import Budget
from solver.displayed.meaning import SCALAR, Shape, Unknown, Writer, key_of, shape_of
from solver.displayed.names import VARIABLES, Names
from solver.displayed.reading import Meaning, Unreadable, read
from solver.displayed.statements import Chain, Side, legible, statements
from solver.formula import latex
from solver.lazy import numeric
from solver.matrices import entries
from solver.render.symbols import named
from solver.stated import Stated
from solver.stated.calculus import value_at


@dataclass
class Judge:
    """What is known while the steps of a part are gone through in the order of reading."""

    names: Names
    given: frozenset[Any]
    answered: frozenset[Any]
    environments: Any
    free: frozenset[str] = frozenset()
    of_system: frozenset[Any] = frozenset()
    matrices: frozenset[str] = frozenset()
    unknowns: dict[str, Any] = field(default_factory=dict)
    later: list[tuple[Any, Any, int, str]] = field(default_factory=list)
    seen: set[tuple[Any, Any]] = field(default_factory=set)
    checks: list[Check] = field(default_factory=list)
    sought: frozenset[Any] = frozenset()
    budget: Budget = field(default_factory=Budget)
    step: int = 0
    where: str = ""

    def chain(self, chain: Chain) -> None:
        """Bind the names of a chain and check its links."""
        run: list[Any] = []
        for i, side in enumerate(chain.sides):
            run.append(side)
            if i == len(chain.sides) - 1 or chain.relations[i] != "=":
                self.equal(run)
                run = []

    def equal(self, sides: Sequence[Any]) -> None:
        """Check sides that are stated to be equal; those without a value are passed over."""
        if len(sides) < 2:
            return
        read_sides = [meaning_of(side) for side in sides]
        for meaning in read_sides:
            if meaning is not None and (key := name_in(meaning)):
                self.choose(key, [_value_of(side) for side in sides])
        formulas = [self.formula(side, meaning) for side, meaning in zip(sides, read_sides, strict=True)]
        sizes = [shape_of(f) for f in sorted((f for f in formulas if f is not None), key=_is_stated)]
        shape = next((size for size in sizes if size not in (None, SCALAR)), SCALAR)
        if shape != SCALAR:
            formulas = [
                self.formula(side, meaning, shape) if formula is None or shape_of(formula) != shape else formula
                for side, meaning, formula in zip(sides, read_sides, formulas, strict=True)
            ]
        values = [frozen(formula) for formula in formulas if formula is not None]
        if not values:
            return
        for meaning, formula in zip(read_sides, formulas, strict=True):
            if formula is None and meaning is not None:
                self.bind(meaning, values)
        for left, right in pairwise(values):
            self.link(left, right)

    def choose(self, name: str, values: Sequence[Any]) -> None:
        """Let a name of the part stand for the one of its values that is displayed, or for unknowns to be found."""
        for value in values:
            fixed = self.names.fixed.get(name, ())
            if value is not None and (name in self.free or any(value == each for each in fixed)):
                self.names.found[name] = value
                continue
            known = self.of_system if fixed else self.given
            if isinstance(value, sp.MatrixBase) and not numeric.free_symbols(value) <= known:
                self.names.found[name] = self.unknowns[name] = value
                self.sought |= numeric.free_symbols(value) - known

    def stands(self, name: Written, value: Any) -> None:
        """From here on a name stands for another value, or for one still to be shown: the step says so."""
        key = spelled(legible(name))
        for known in (self.names.found, self.names.fixed):
            known.pop(key, None)
            known.pop(f"{key.partition('(')[0]}()", None)
        if value is not None:
            self.names.fixed[key] = [value]

    def begin(self, number: int, where: str) -> None:
        """Begin a step: unknowns do not stand for names any more, and names may be given other values."""
        self.names.in_step.clear()
        self.step, self.where = number, where
        for name in self.unknowns:
            if numeric.free_symbols(self.names.found.get(name)) & self.sought:
                del self.names.found[name]

    def formula(self, side: Any, meaning: Meaning | None, shape: Shape = None) -> Any:
        """Return a side as a value or formula; None for a name to be bound, and for what has no value.

        `shape` is that of the other sides, for an identity or a zero.
        """
        if not isinstance(side, Side):
            return sp.zeros(*shape) if shape is not None and _is_zero(side) else side
        if meaning is None or self.is_new(meaning):
            return None
        try:
            return Writer(self.names, side.values).formula(meaning, shape)
        except (Unknown, Unreadable):
            return None

    def is_new(self, meaning: Meaning) -> bool:
        """Whether what stands there is a name without a value."""
        key = name_in(meaning)
        if meaning.kind == "apply" and self._is_function(meaning):
            return False
        return bool(key) and key not in VARIABLES and self.names.is_free(key)

    def _is_function(self, meaning: Meaning) -> bool:
        """Whether f(x) has a value because f has one, unless f(x) is what f was bound as."""
        if meaning.text in self.names.fixed:
            return True
        function = self.names.value(f"{meaning.text}()")
        return function is not None and meaning.parts[1].text not in VARIABLES

    def bind(self, meaning: Meaning, values: Sequence[Any]) -> None:
        """Let a name stand for the value it is set equal to."""
        key = name_in(meaning)
        if not key or not self.is_new(meaning):
            return
        value = next((v for v in values if not isinstance(v, Stated)), values[0])
        self.names.bind(key, value)
        if meaning.kind == "apply" and meaning.parts[1].text in VARIABLES:
            self.names.found[f"{meaning.text}()"] = (value, VARIABLES[meaning.parts[1].text])

    def link(self, left: Any, right: Any) -> None:
        """Check that two sides are equal, once."""
        if left is right or listed(left) or listed(right) or (left, right) in self.seen:
            return
        if left in self.given or right in self.given:  # a condition: where t = 0, if a = b
            return
        symbols = {symbol.name for symbol in numeric.free_symbols(left) | numeric.free_symbols(right)}
        if symbols & self.matrices:  # a polynomial in A: its coefficients are checked, and what it is evaluated to
            return
        self.seen.add((left, right))
        if self.unknown(left, right):
            self.later.append((left, right, self.step, self.where))
            return
        self.check(left, right, self.step, self.where)

    def unknown(self, *formulas: Any) -> frozenset[Any]:
        """Return the symbols of formulas that stand for what is to be found."""
        symbols = frozenset().union(*map(numeric.free_symbols, formulas))
        return frozenset((symbols & self.sought) | (symbols - self.given - self.answered))

    def check(self, left: Any, right: Any, step: int, where: str) -> None:
        """Evaluate an equality, if so much may still be evaluated."""
        if not self.budget.allows((left, right)):
            reason = "what the part displays is too large to be evaluated whole"
            self.checks.append(replace(Check.skipped(where, "random points", reason), step=step))
            return
        check = numeric.check_claim(Claim(left, right), where, environments=self.environments)
        self.checks.append(replace(check, step=step))

    def finish(self) -> None:
        """Check the equations between unknowns, with what was found for them in their place."""
        self.begin(self.step, self.where)
        solution: dict[Any, Any] = {}
        for name, ansatz in self.unknowns.items():
            value = self.names.value(name)
            if getattr(value, "shape", None) == ansatz.shape:
                solution.update(_found(zip(entries(ansatz), entries(value), strict=True)))
        for left, right, step, where in self.later:
            unknown = self.unknown(left, right)
            by_name = {each: self.names.value(spelled(latex(named(each.name)))) for each in unknown}
            values = {**{each: value for each, value in by_name.items() if isinstance(value, sp.Expr)}, **solution}
            if unknown <= values.keys() and not any(values[each].has(sp.Float) for each in unknown):
                self.check(_with(left, values), _with(right, values), step, where)


def _is_stated(formula: Any) -> bool:
    return isinstance(formula, Stated)


def _is_zero(value: Any) -> bool:
    return isinstance(value, int | sp.Integer) and value == 0


def frozen(value: Any) -> Any:
    """Return a value that can be looked up; some matrices of steps are mutable."""
    if isinstance(value, Stated):
        return Stated(value.operation, tuple(map(frozen, value.operands)))
    return sp.ImmutableMatrix(value) if isinstance(value, sp.MutableDenseMatrix) else value


def _value_of(side: Any) -> Any:
    """Return the value that a side consists of; None for what is written."""
    if not isinstance(side, Side):
        return side
    meaning = meaning_of(side)
    return side.values[meaning.text] if meaning is not None and meaning.kind == "value" else None


def spelled(latex: str) -> str:
    """Return a name in the spelling of those that are read."""
    found = statements(latex)
    meaning = meaning_of(Side(found[0].sides[0], ())) if found else None
    return name_in(meaning) if meaning is not None else latex


def _found(pairs: Iterable[tuple[Any, Any]]) -> Iterator[tuple[Any, Any]]:
    """Return what unknowns were found to be, from the entries c·x of a matrix of unknowns and their values."""
    for entry, value in pairs:
        factor, unknown = entry.as_coeff_Mul()
        if unknown.is_Symbol:
            yield unknown, value / factor


def _with(formula: Any, values: Mapping[Any, Any]) -> Any:
    """Return a formula with values in place of unknowns."""
    for unknown in numeric.free_symbols(formula) & values.keys():
        if values[unknown] != unknown:
            formula = value_at(formula, unknown, values[unknown])
    return formula


def listed(value: Any) -> bool:
    """Whether a value is no formula: a list, a text, a truth value."""
    return isinstance(value, list | tuple | str | bool)


def meaning_of(side: Any) -> Meaning | None:
    """Return what a written side means; None where it can't be read, and for a value."""
    if not isinstance(side, Side) or not side.items:
        return None
    try:
        return read(side.items)
    except Unreadable:
        return None


def name_in(meaning: Meaning) -> str:
    r"""Return the name that a side consists of: `K_{f}`, `\Phi(t)`; else nothing."""
    return str(meaning.text) if meaning.kind == "name" else key_of(meaning) if meaning.kind == "apply" else ""
