"""Lemma: several differential equations, some of them algebraic, by elimination: one unknown after another."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.jets import jet_symbol
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.variations.unknowns import MOST, Unknown

if TYPE_CHECKING:
    from collections.abc import Callable

    from sympy import Expr, Symbol

    from solver.tasks.variations.unknowns import Constants

    Solve = Callable[[Expr, Unknown, Symbol, Constants], Derivation[Expr]]

Functions = dict[str, "Expr"]


@dataclass(frozen=True)
class Together:
    """Equations that are zero, with their numbers among those given, and the unknowns that are left.

    They are `shown` where they have just been displayed.
    """

    equations: tuple[tuple[int, Expr], ...]
    unknowns: tuple[Unknown, ...]
    shown: bool = False

    def inside(self, equation: Expr) -> list[Unknown]:
        """The unknowns in an equation."""
        return [each for each in self.unknowns if each.order_in(equation) >= 0]

    def without(self, number: int, unknown: Unknown, values: dict[Symbol, Expr], *, shown: bool = False) -> Together:
        """What is left when an equation has given an unknown, which is put into the others."""
        rest = tuple((i, _tidy(e.xreplace(values))) for i, e in self.equations if i != number)
        return Together(rest, tuple(each for each in self.unknowns if each != unknown), shown)


def _tidy(equation: Expr) -> Expr:
    expanded = sp.expand(equation)
    return expanded if expanded.count_ops() <= equation.count_ops() else equation


def can_be_solved(system: Together, t: Symbol, way: Callable[[Expr, Unknown], str]) -> bool:
    """Whether elimination arrives; what single equations bring is not known then, so they count as zero."""
    if not system.unknowns:
        return True
    single = _single(system)
    if single is not None:
        number, equation, unknown = single
        if unknown.order_in(equation) > 0 and not way(equation, unknown):
            return False
        return can_be_solved(system.without(number, unknown, dict.fromkeys(unknown.jets, sp.S.Zero)), t, way)
    chosen = _solvable(system, t)
    if chosen is not None:
        number, unknown, value = chosen
        return can_be_solved(system.without(number, unknown, _derivatives(unknown, value, system, t)), t, way)
    other = _untangled(system) or _lowered(system)
    return other is not None and can_be_solved(other if isinstance(other, Together) else other[0], t, way)


@lemma("equations_in_turn")
def solved_in_sequence(system: Together, t: Symbol, constants: Constants, solve: Solve) -> Derivation[Functions]:
    """The functions by name; `solve` is the lemma for one equation. Raises Unsolved where elimination stops."""
    if not system.unknowns:
        return {}
    single = _single(system)
    if single is not None:
        return (yield from _by_itself(system, single, t, constants, solve))
    chosen = _solvable(system, t)
    if chosen is not None:
        return (yield from _eliminated(system, chosen, t, constants, solve))
    untangled = _untangled(system)
    if untangled is not None:
        yield Step("untangled", unclaimed="linear combinations of the equations", equations=untangled.equations)
        return (yield from solved_in_sequence(untangled, t, constants, solve))
    lowered = _lowered(system)
    if lowered is None:
        raise Unsolved("ordinary_equations/system", equations=[each for _, each in system.equations])
    return (yield from _integrated_after(lowered, t, constants, solve))


def _single(system: Together) -> tuple[int, Expr, Unknown] | None:
    """An equation with one unknown in it, an algebraic one first."""
    found = [(i, e, inside[0]) for i, e in system.equations if len(inside := system.inside(e)) == 1]
    return min(found, key=lambda each: (each[2].order_in(each[1]) > 0, each[0]), default=None)


@lemma("equations_in_turn")
def _by_itself(
    system: Together, single: tuple[int, Expr, Unknown], t: Symbol, constants: Constants, solve: Solve
) -> Derivation[Functions]:
    """An equation with one unknown, solved, and put into the others."""
    number, equation, unknown = single
    x = unknown.symbol
    if unknown.order_in(equation) == 0:
        slope = sp.diff(equation, x)
        if slope.has(x):
            raise Unsolved("ordinary_equations/beyond", equation=equation)
        function = sp.expand(sp.cancel(-equation.subs(x, 0) / slope))
        claims = {"solved": Claim(equation.xreplace({x: function}), sp.S.Zero, "the equation solved")}
        yield Step("algebraic", claims=claims, x=x, equation=equation, function=function)
    else:
        if not system.shown:
            yield Step("alone", unclaimed="one of the equations", x=x, equation=equation)
        function = yield from solve(equation, unknown, t, constants)
    rest = system.without(number, unknown, unknown.put(function, t))
    return {unknown.name: function} | (yield from solved_in_sequence(rest, t, constants, solve))


def _solvable(system: Together, t: Symbol) -> tuple[int, Unknown, Expr] | None:
    """An equation that gives an unknown by the others: linear in it, without its derivatives; the lowest one first."""
    found, moving = [], [jet for each in system.unknowns for jet in each.jets]
    for number, equation in system.equations:
        for unknown in system.inside(equation):
            slope = sp.diff(equation, unknown.symbol)
            if unknown.order_in(equation) == 0 and not slope.has(t, *moving):
                value = sp.expand((slope * unknown.symbol - equation) / slope)
                highest = max(each.order_in(e) for each in [unknown] for _, e in system.equations)
                order = max((each.order_in(value) for each in system.unknowns), default=0)
                found.append(((highest > 0, order + max(highest, 0), number), number, unknown, value))
    return min(found, key=lambda each: each[0])[1:] if found else None


def _derivatives(unknown: Unknown, value: Expr, system: Together, t: Symbol) -> dict[Symbol, Expr]:
    """The unknown and its derivatives by those of the others, as far as they occur."""
    following = {a: b for each in system.unknowns for a, b in zip(each.jets, each.jets[1:], strict=False)}
    highest = max(unknown.order_in(equation) for _, equation in system.equations)
    found = {}
    for jet in unknown.jets[: highest + 1]:
        found[jet] = value
        value = sp.expand(sp.diff(value, t) + exact.time_derivative(value, following))
    return found


@lemma("equations_in_turn")
def _eliminated(
    system: Together, chosen: tuple[int, Unknown, Expr], t: Symbol, constants: Constants, solve: Solve
) -> Derivation[Functions]:
    """An unknown by the others, put into the other equations; these solved, and back."""
    number, unknown, value = chosen
    values = _derivatives(unknown, value, system, t)
    rest = system.without(number, unknown, values, shown=True)
    yield Step("eliminated", unclaimed="one of the equations, solved for one unknown",
               equation=dict(system.equations)[number],
               values=list(values.items()), equations=[(i, e) for i, e in rest.equations
                                                       if e != dict(system.equations)[i]])  # fmt: skip
    functions = yield from solved_in_sequence(rest, t, constants, solve)
    jets: dict[Any, Any] = {}
    for each in rest.unknowns:
        jets |= each.put(functions[each.name], t)
    put_in = value.xreplace(jets)
    function = _by_constants(put_in, constants.found)
    yield Step("back", claims={"back": Claim(put_in, function, "the others put in")}, x=unknown.symbol, value=value,
               function=function)  # fmt: skip
    return {unknown.name: function} | functions


def _by_constants(function: Expr, constants: Sequence[Symbol]) -> Expr:
    """A function that is linear in the constants, each with its factor."""
    shares = [sp.expand(sp.diff(function, c), power_exp=False) for c in constants]
    waves = [sorted(each.atoms(sp.exp, sp.sin, sp.cos), key=sp.default_sort_key) for each in shares]
    parts = [c * sp.collect(each, of) for c, each, of in zip(constants, shares, waves, strict=True)]
    rest = function.subs(dict.fromkeys(constants, 0))
    return sp.Add(*parts, sp.expand(rest, power_exp=False))


def _untangled(system: Together) -> Together | None:
    """The equations solved for the highest derivatives, where these stand together in one; None if they do not."""
    highest = [each.jets[max(each.order_in(e) for _, e in system.equations)] for each in system.unknowns]
    if not any(sum(e.has(jet) for jet in highest) > 1 for _, e in system.equations):
        return None
    expressions = [e for _, e in system.equations]
    if len(expressions) != len(highest) or not exact.are_linear_in(expressions, highest):
        return None
    found = exact.solved_for(expressions, highest)
    if found is None:
        return None
    numbered = zip((i for i, _ in system.equations), highest, strict=True)
    return Together(tuple((i, sp.expand(jet - found[jet])) for i, jet in numbered), system.unknowns, shown=True)


@dataclass(frozen=True)
class Lowered:
    """A system in which a derivative of a function is called by a name of its own."""

    system: Together
    unknown: Unknown
    derivative: Unknown
    order: int


def _lowered(system: Together) -> tuple[Together, Lowered] | None:
    """A derivative of an unknown as the unknown, where nothing lower occurs."""
    for unknown in system.unknowns:
        occurring = [i for i, jet in enumerate(unknown.jets) if any(e.has(jet) for _, e in system.equations)]
        lowest = min(occurring, default=0)
        if lowest == 0:
            continue
        name = f"v_{unknown.name}"
        fresh = Unknown(name, tuple(jet_symbol((name, k)) for k in range(MOST + 1)))
        renamed: dict[Any, Any] = dict(zip(unknown.jets[lowest:], fresh.jets, strict=False))
        equations = tuple((i, e.xreplace(renamed)) for i, e in system.equations)
        unknowns = tuple(fresh if each == unknown else each for each in system.unknowns)
        together = Together(equations, unknowns, shown=True)
        return together, Lowered(together, unknown, fresh, lowest)
    return None


@lemma("equations_in_turn")
def _integrated_after(
    lowered: tuple[Together, Lowered], t: Symbol, constants: Constants, solve: Solve
) -> Derivation[Functions]:
    """The system for a derivative, and the integrals of that."""
    system, names = lowered
    yield Step("lowered", unclaimed="a name", derivative=names.unknown.jets[names.order], name=names.derivative.symbol,
               equations=system.equations)  # fmt: skip
    functions = yield from solved_in_sequence(system, t, constants, solve)
    rate = functions.pop(names.derivative.name)
    equation = names.unknown.jets[names.order] - rate
    function = yield from solve(equation, names.unknown, t, constants)
    return {names.unknown.name: function} | functions
