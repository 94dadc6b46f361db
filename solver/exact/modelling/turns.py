"""Linear equations solved one after the other, as a person does: the one in which a single unknown is left comes next.

Where each holds several, an unknown is kept for a while (a "tear"): the others are expressed in it until an equation
holds nothing else, which gives it. Among the unknowns the one is kept that leads there in the fewest steps.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy as sp
from sympy.polys.constructor import construct_domain
from sympy.polys.matrices import DomainMatrix
from sympy.polys.matrices.exceptions import DMNonInvertibleMatrixError

Side = tuple[sp.Expr, sp.Expr]
Form = dict[Any, Any]
"""Coefficients in K of symbols; that of 1 is the constant term."""
ONE = sp.S.One


@dataclass(frozen=True)
class Turn:
    """Unknowns found at once, usually one: `stated` is what an equation says of it, `values` are in what is known.

    Several, or one that was kept for a while: `through` has what was expressed in them on the way (by which
    equation, as stated and put in), `closing` are the equations in which nothing else is left, with both sides.
    """

    symbols: tuple[sp.Symbol, ...]
    values: tuple[sp.Expr, ...]
    equation: int = -1
    stated: sp.Expr | None = None
    through: tuple[tuple[int, sp.Symbol, sp.Expr, sp.Expr], ...] = ()
    closing: tuple[tuple[int, sp.Expr, sp.Expr], ...] = ()


@dataclass(frozen=True)
class Solved:
    """The turns that lead to what is wanted, and the `values` of all that was found.

    `tied` are equations that hold known quantities alone: these are not independent; `lacking` are unknowns that are
    wanted and not determined.
    """

    turns: tuple[Turn, ...]
    values: Mapping[sp.Symbol, sp.Expr]
    tied: tuple[sp.Expr, ...] = ()
    lacking: tuple[sp.Symbol, ...] = ()

    @property
    def used(self) -> set[int]:
        """The numbers of the equations that lead to what is wanted."""
        through = {each[0] for turn in self.turns for each in turn.through}
        through |= {each[0] for turn in self.turns for each in turn.closing}
        return through | {turn.equation for turn in self.turns if turn.stated is not None}


@dataclass
class _Elimination:
    """Equations as forms in the unknowns and in what is known; `found` are the unknowns as forms in what is known."""

    equations: Sequence[Side]
    known: set[Any]
    unknown: set[Any]
    K: Any
    forms: list[Form]
    found: dict[Any, Form] = field(default_factory=dict)
    used: set[int] = field(default_factory=set)

    def left_in(self, i: int, found: Mapping[Any, Form], kept: Iterable[Any] = ()) -> list[Any]:
        """The unknowns of an equation that are not found."""
        return [x for x in self.forms[i] if x in self.unknown and x not in found and x not in kept]

    def put(self, i: int, found: Mapping[Any, Form]) -> Form:
        """An equation with what was found put in."""
        return combined((c, found.get(x, {x: self.K.one})) for x, c in self.forms[i].items())

    def advance(self, found: dict[Any, Form], used: set[int], kept: Iterable[Any] = ()) -> list[tuple[int, Any]]:
        """Find what can be found one by one; returns equation and unknown in this order."""
        order: list[tuple[int, Any]] = []
        moved = True
        while moved:
            moved = False
            for i in range(len(self.forms)):
                left = self.left_in(i, found, kept) if i not in used else []
                if len(left) == 1 and self.solve(i, left[0], found):
                    used.add(i)
                    order.append((i, left[0]))
                    moved = True
                    break
        return order

    def solve(self, i: int, x: Any, found: dict[Any, Form]) -> bool:
        """Solve an equation for the unknown that is left; False where it drops out."""
        form = self.put(i, found)
        factor = form.pop(x, self.K.zero)
        if not factor:
            return False
        found[x] = {y: -c / factor for y, c in form.items()}
        return True

    def closings(self, found: Mapping[Any, Form], used: set[int], kept: Sequence[Any]) -> list[tuple[int, Form]]:
        """Equations in which nothing but the unknowns that are kept is left, and these are."""
        complete = [i for i in range(len(self.forms)) if i not in used and not self.left_in(i, found, kept)]
        forms = [(i, self.put(i, found)) for i in complete]
        return [(i, form) for i, form in forms if any(x in form for x in kept)]

    def steps_to_close(self, kept: Sequence[Any]) -> tuple[int, int]:
        """How many equations hold nothing but these when they are kept, and after how many steps."""
        rows = [set(self.left_in(i, self.found)) for i in range(len(self.forms)) if i not in self.used]
        rows = [row for row in rows if row]
        gone, steps = set(kept), 0
        while True:
            closed = [row for row in rows if row <= gone]
            if len(closed) >= len(kept):
                return len(kept), steps
            single = next((row - gone for row in rows if len(row - gone) == 1), None)
            if single is None:
                return len(closed), -steps
            (x,) = single
            rows = _without_first(rows, gone | single, gone)
            gone.add(x)
            steps += 1


def _without_first(rows: Sequence[set[Any]], inside: set[Any], outside: set[Any]) -> list[set[Any]]:
    """The rows but the first that lies in one set and not in the other: it was used to find what is new."""
    at = next(i for i, row in enumerate(rows) if row <= inside and not row <= outside)
    return [row for i, row in enumerate(rows) if i != at]


def combined(terms: Iterable[tuple[Any, Form]]) -> Form:
    """The sum of forms with factors, without zeros."""
    found: Form = {}
    for factor, form in terms:
        for x, c in form.items():
            found[x] = found[x] + factor * c if x in found else factor * c
    return {x: c for x, c in found.items() if c}


def solved_in_turn(
    equations: Sequence[Side], known: Sequence[sp.Expr], unknown: Sequence[sp.Expr], wanted: Iterable[Any]
) -> Solved:
    """Solve equations that are linear in the known and unknown symbols; what is not wanted on the way is left out."""
    work = _begun(equations, known, unknown)
    turns: list[Turn] = []
    while True:
        for i, x in work.advance(work.found, work.used):
            turns.append(_plain(work, i, x))
        left = [x for x in unknown if x not in work.found]
        turn = _torn(work, left) if left else None
        if turn is None:
            break
        turns.append(turn)
    idle = [i for i in range(len(work.forms)) if i not in work.used and not work.left_in(i, work.found)]
    tied = tuple(_expression(work.K, form) for i in idle if (form := work.put(i, work.found)))
    lacking = tuple(x for x in wanted if x in work.unknown and x not in work.found)
    values = {x: _expression(work.K, form) for x, form in work.found.items()}
    return Solved(tuple(_needed(turns, set(wanted))), values, tied, lacking)


def _begun(equations: Sequence[Side], known: Sequence[Any], unknown: Sequence[Any]) -> _Elimination:
    """The equations as forms over the smallest field found for their coefficients."""
    names = {*known, *unknown}
    rows: list[dict[Any, sp.Expr]] = []
    for left, right in equations:
        difference = left - right
        inside = [x for x in (*unknown, *known) if x in difference.free_symbols]
        row = {x: sp.diff(difference, x) for x in inside}
        row[ONE] = difference.xreplace(dict.fromkeys(inside, sp.S.Zero))
        rows.append({x: c for x, c in row.items() if c != 0})
    coefficients = [c for row in rows for c in row.values()]
    K, elements = construct_domain([*coefficients, sp.S.One], field=True, extension=True)
    each = iter(elements)
    forms = [{x: next(each) for x in row} for row in rows]
    return _Elimination(equations, set(known), names - set(known), K, forms)


def _plain(work: _Elimination, i: int, x: Any) -> Turn:
    """One unknown from the one equation in which it is left."""
    stated = _solved(work, i, x)
    return Turn((x,), (_expression(work.K, work.found[x]),), i, stated)


def _torn(work: _Elimination, left: Sequence[Any]) -> Turn | None:
    """Unknowns kept until equations hold nothing else; None where that never happens."""
    kept: list[Any] = []
    while len(kept) < len(left):
        ways = [(work.steps_to_close([*kept, x]), x) for x in left if x not in kept]
        closing = [(steps, x) for (count, steps), x in ways if count > len(kept)]
        if closing:
            kept.append(min(closing, key=lambda way: way[0])[1])
            break
        kept.append(max(ways, key=lambda way: (way[0][0], -way[0][1]))[1])
    found, used = dict(work.found), set(work.used)
    order = work.advance(found, used, kept)
    ends = work.closings(found, used, kept)[: len(kept)]
    values = _values(work.K, ends, kept)
    if values is None:
        return None
    order = _leading_to(work, order, [i for i, _ in ends])
    through = tuple((i, x, _solved(work, i, x), _expression(work.K, found[x])) for i, x in order)
    inside = {x: value for _, x, _, value in through} | {x: _expression(work.K, form) for x, form in work.found.items()}
    shown = tuple((i, *(side.xreplace(inside) for side in work.equations[i])) for i, _ in ends)
    work.found.update(values)
    work.used.update(i for i, _ in ends)
    return Turn(tuple(kept), tuple(_expression(work.K, values[x]) for x in kept), through=through, closing=shown)


def _leading_to(work: _Elimination, order: Sequence[tuple[int, Any]], ends: Sequence[int]) -> list[tuple[int, Any]]:
    """The steps of an order whose unknowns some equations hold, or those that lead to them."""
    wanted, kept = {x for i in ends for x in work.forms[i]}, list[tuple[int, Any]]()
    for i, x in reversed(order):
        if x in wanted:
            kept.insert(0, (i, x))
            wanted |= set(work.forms[i])
    return kept


def _solved(work: _Elimination, i: int, x: Any) -> sp.Expr:
    """What an equation says of one of its unknowns."""
    left, right = work.equations[i]
    if left == x and not right.has(x):
        return right
    difference = sp.expand(left - right)
    factor, rest = sp.diff(difference, x), difference.xreplace({x: sp.S.Zero})
    solved: sp.Expr = -rest if factor == 1 else rest if factor == -1 else sp.expand(-rest / factor)
    return (rest if factor.could_extract_minus_sign() else -rest) / _unsigned(factor) if factor.is_Add else solved


def _unsigned(factor: sp.Expr) -> sp.Expr:
    """The factor without the minus sign that can be taken out of it."""
    return -factor if factor.could_extract_minus_sign() else factor


def _values(K: Any, ends: Sequence[tuple[int, Form]], kept: Sequence[Any]) -> dict[Any, Form] | None:
    """The unknowns that were kept, from as many equations; None where these do not determine them."""
    if len(ends) != len(kept):
        return None
    rest = list(dict.fromkeys(y for _, form in ends for y in form if y not in kept))
    n = len(kept)
    M = DomainMatrix([[form.get(x, K.zero) for x in kept] for _, form in ends], (n, n), K)
    right = DomainMatrix([[-form.get(y, K.zero) for y in rest] for _, form in ends], (n, len(rest)), K)
    try:
        solution = (M.inv() * right).to_list()
    except DMNonInvertibleMatrixError:
        return None
    return {x: {y: c for y, c in zip(rest, row, strict=True) if c} for x, row in zip(kept, solution, strict=True)}


def _expression(K: Any, form: Form) -> sp.Expr:
    """A form as an expression."""
    return sp.Add(*(K.to_sympy(c) * x for x, c in form.items()))


def _needed(turns: Sequence[Turn], wanted: set[Any]) -> list[Turn]:
    """The turns that lead to what is wanted."""
    kept: list[Turn] = []
    for turn in reversed(turns):
        if wanted & set(turn.symbols):
            kept.insert(0, turn)
            sides = [turn.stated] if turn.stated is not None else [stated for _, _, stated, _ in turn.through]
            sides += [side for _, *closing in turn.closing for side in closing]
            wanted |= set().union(*(side.free_symbols for side in sides))
    return kept
