"""Every link of every displayed chain is evaluated by the oracle, with the names on the page bound to their values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any

import sympy as sp

from solver.derivation import Check, CheckStatus, Claim
from solver.derivation.displayed import Written
from solver.displayed.budget import Budget
from solver.displayed.matrix_functions import is_left, undone, with_matrices
from solver.displayed.meaning import Unknown, Writer
from solver.displayed.names import VARIABLES, Names
from solver.displayed.shapes import SCALAR, Shape, shape_of
from solver.displayed.sides import frozen, half_unit, has_value, listed
from solver.displayed.statements import Chain, Side, legible, name_in, names_in, spelled
from solver.displayed.tree import Meaning, Unreadable
from solver.displayed.unknowns import Unknowns
from solver.lazy import numeric
from solver.stated import Stated
from solver.words import Phrase

RELATIONS = {
    **{"<": "<", ">": ">", r"\lt": "<", r"\gt": ">", r"\le": "≤", r"\leq": "≤", r"\ge": "≥", r"\geq": "≥"},
    **{r"\ne": "≠", r"\neq": "≠", r"\approx": "≈"},
}
"""Relations that are judged, besides equality, where both sides are numbers."""

MOST_REMEMBERED = 2000
_EVALUATED: dict[tuple[Any, Any], Check] = {}
"""Checks of exact equalities, the latest last."""


@dataclass
class Judge:
    """What is known while the steps of a part are gone through in the order of reading."""

    names: Names
    unknowns: Unknowns
    environments: Any
    free: frozenset[str] = frozenset()
    matrices: Mapping[str, Any] = field(default_factory=dict)
    known: dict[Any, Any] = field(default_factory=dict)
    seen: set[tuple[Any, ...]] = field(default_factory=set)
    checks: list[Check] = field(default_factory=list)
    budget: Budget = field(default_factory=Budget)
    laws: list[tuple[Sequence[Any], int, str]] = field(default_factory=list)
    step: int = 0
    where: str = ""

    def begin(self, number: int, where: str) -> None:
        """Begin a step: unknowns do not stand for names any more."""
        self.step, self.where = number, where
        self.unknowns.forget(self.names)

    def stands(self, name: Written, value: Any) -> None:
        """From here on a name stands for another value, or for one still to be shown: the step says so."""
        key = spelled(legible(name))
        if value is None or self.names.value(key) not in (None, value):
            self.names.changed.add(key.partition("(")[0])
        if value is None:
            self.names.forget(key)
        else:
            self.names.found.pop(f"{key.partition('(')[0]}()", None)
            self.names.bind(key, value)

    def chain(self, chain: Chain) -> None:
        """Bind the names of a chain and check its links."""
        if len(chain.sides) < 2:
            return
        runs: list[list[Any]] = [[chain.sides[0]]]
        others = [relation for relation in chain.relations if relation != "="]
        for relation, side in zip(chain.relations, chain.sides[1:], strict=True):
            if relation == "=":
                runs[-1].append(side)
            else:
                runs.append([side])
        formulas = [self.equal(run) for run in runs]
        for i, relation in enumerate(others):
            if relation in RELATIONS:
                self.related(formulas[i][-1], RELATIONS[relation], formulas[i + 1][0])

    def equal(self, sides: Sequence[Any]) -> list[Any]:
        """Check sides that are stated to be equal; return their formulas, None for those without a value."""
        read = [side.meaning if isinstance(side, Side) else None for side in sides]
        for meaning in read:
            if key := name_in(meaning):
                self.choose(key, [side.value if isinstance(side, Side) else side for side in sides])
        formulas = [self.formula(side) for side in sides]
        shape = _common_shape(formulas)
        formulas = [
            formula if has_value(formula) and shape_of(formula) in (None, shape) else self.formula(side, shape)
            for side, formula in zip(sides, formulas, strict=True)
        ]
        values = [frozen(formula) for formula in formulas if has_value(formula)]
        if values:
            for meaning, formula in zip(read, formulas, strict=True):
                if formula is None and meaning is not None:
                    self.bind(meaning, values)
            for refusal in (formula for formula in formulas if isinstance(formula, Unreadable)):
                self.skip(refusal.reason)
        found = [self.formula(side) if each is None else each for side, each in zip(sides, formulas, strict=True)]
        for left, right in pairwise(frozen(each) for each in found if has_value(each)):
            self.link(left, right)
        printed = any(not isinstance(side, Side) or side.value is not None for side in sides)
        if printed and any(each is None for each in found):
            self.laws.append((sides, self.step, self.where))
        return found

    def choose(self, name: str, values: Sequence[Any]) -> None:
        """Let a name of the part stand for the one of its values that is displayed, or for unknowns to be found."""
        for value in values:
            fixed = self.names.fixed.get(name, ())
            if value is not None and (name in self.free or any(value == each for each in fixed)):
                self.names.found[name] = value
            else:
                self.unknowns.may_hold(self.names, name, value)

    def formula(self, side: Any, shape: Shape = None) -> Any:
        """Return a side as a value or formula; None for a name to be bound, and for what has no value.

        What cannot be read is returned as the refusal. `shape` is that of the other sides, for an identity or a zero.
        """
        if not isinstance(side, Side) or listed(side.value):
            value = side.value if isinstance(side, Side) else side
            return sp.zeros(*shape) if shape is not None and _is_zero(value) else value
        if side.meaning is None or self.is_new(side.meaning):
            return Unreadable(side.refusal) if side.refusal else None
        writer = Writer(self.names, side.values, self.known)
        try:
            return writer.formula(side.meaning, shape)
        except Unknown:
            return None
        except Unreadable as refusal:
            return refusal if writer.knows(side.meaning) else None

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
        if not key or not self.is_new(meaning) or meaning.text.startswith(r"\dot"):  # a derivative
            return
        value = next((v for v in values if not isinstance(v, Stated)), values[0])
        self.names.bind(key, value)
        if meaning.kind == "apply" and meaning.parts[1].text in VARIABLES:
            self.names.found[f"{meaning.text}()"] = (value, VARIABLES[meaning.parts[1].text])

    def link(self, left: Any, right: Any) -> None:
        """Check that two sides are equal, once; what is the same on both needs no check."""
        if listed(left) or listed(right) or left == right or not self.seen.isdisjoint(((left, right), (right, left))):
            return
        if left in self.unknowns.given or right in self.unknowns.given:  # a condition: where t = 0, if a = b
            return
        self.seen.add((left, right))
        left, right = undone(with_matrices(left, self.matrices), with_matrices(right, self.matrices))
        if is_left(left) or is_left(right):
            self.skip("a root or logarithm of a matrix within a formula")
            return
        symbols = numeric.free_symbols(left) | numeric.free_symbols(right)
        if {symbol.name for symbol in symbols} & self.matrices.keys():
            self.skip("a formula in which a matrix stands as a symbol")
            return
        if self.unknowns.those_in(symbols):
            self.unknowns.equations.append((left, right, self.step, self.where))
        else:
            self.check(left, right)

    def related(self, left: Any, relation: str, right: Any) -> None:
        """Check that two numbers are in a relation, once; with symbols in them an order is a condition."""
        if not (has_value(left) and has_value(right)) or listed(left) or listed(right):
            return
        symbols = numeric.free_symbols(left) | numeric.free_symbols(right)
        if symbols and relation == "≈":
            self.skip("an approximation of a function")
        known = (left, relation, right) in self.seen
        if known or (symbols and relation != "≠") or self.unknowns.those_in(symbols):
            return
        self.seen.add((left, relation, right))
        if self._affordable(left, right):
            near = half_unit(right) if relation == "≈" else numeric.TOLERANCE
            known = self.environments
            self._add(numeric.check_relation(left, relation, right, self.where, near=near, environments=known))

    def check(self, left: Any, right: Any) -> None:
        """Evaluate an equality, if so much may still be evaluated."""
        if left != right and self._affordable(left, right):
            check = self._evaluated(left, right)
            if check.status is CheckStatus.PASSED:
                self.learn(left, right)
            self._add(check)

    def _evaluated(self, left: Any, right: Any) -> Check:
        """Return the check of an equality; of an exact one it is remembered, so that levels and languages share it.

        Decimals are equal that have different numbers of digits, and may be judged differently.
        """
        exact = not (numeric.holds_decimals(left) or numeric.holds_decimals(right))
        known = _EVALUATED.get((left, right)) if exact else None
        if known is not None:
            return replace(known, claim=self.where)
        check = numeric.check_claim(Claim(left, right), self.where, environments=self.environments, shown=True)
        if exact:
            if len(_EVALUATED) >= MOST_REMEMBERED:
                _EVALUATED.pop(next(iter(_EVALUATED)))
            _EVALUATED[left, right] = check
        return check

    def claimed(self, left: Any, right: Any) -> None:
        """Note an equality that is claimed, and checked as a claim."""
        self.seen.add((left, right))
        self.learn(left, right)

    def learn(self, left: Any, right: Any) -> None:
        """Note that a formula is a matrix, which takes its place in other formulas and is evaluated in its stead."""
        for formula, value in ((left, right), (right, left)):
            if isinstance(formula, Stated) and isinstance(value, sp.MatrixBase):
                self.known.setdefault(formula, value)

    def _affordable(self, *formulas: Any) -> bool:
        if self.budget.allows(formulas):
            return True
        self._add(Check.skipped(self.where, "none", "what the part displays is too large to be evaluated whole"))
        return False

    def skip(self, reason: str) -> None:
        """Note that a display is not evaluated, once for each reason in a step."""
        if (self.where, reason) not in self.seen:
            self.seen.add((self.where, reason))
            words = Phrase("a display is not evaluated: {reason}", reason=reason)
            self._add(Check.skipped(self.where, "none", words))

    def _add(self, check: Check) -> None:
        self.checks.append(check.displayed_in(self.step))

    def finish(self) -> None:
        """Check what stood before its names had values, and equations between unknowns, with what was found."""
        self.unknowns.forget(self.names)
        laws, self.laws = self.laws, []
        for sides, step, where in laws:
            self.step, self.where = step, where
            laws_of_names = [side.meaning for side in sides if isinstance(side, Side) and not name_in(side.meaning)]
            changed = any(self.names.changed & names_in(meaning) for meaning in laws_of_names)
            found = () if changed else zip(sides, self.equal(sides), strict=True)
            if changed or any(each is None and not name_in(getattr(side, "meaning", None)) for side, each in found):
                self.skip("a name in it stands for no value")
        for left, right, step, where in self.unknowns.solved(self.names):
            self.step, self.where = step, where
            self.check(left, right)


def _common_shape(formulas: Sequence[Any]) -> Shape:
    """Return the shape of the sides of a chain, by values rather than by what is written; None where none has one."""
    known = sorted((each for each in formulas if has_value(each)), key=lambda each: isinstance(each, Stated))
    sizes = [size for size in map(shape_of, known) if size is not None]
    return next((size for size in sizes if size != SCALAR), SCALAR if sizes else None)


def _is_zero(value: Any) -> bool:
    return isinstance(value, int | sp.Integer) and value == 0
