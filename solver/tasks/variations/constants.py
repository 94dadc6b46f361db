"""Lemma: the constants of integration, multipliers and the free time, from what holds at the ends."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import power
from solver.stated.calculus import integral
from solver.tasks.modelling.solutions import solutions_of
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import Functional
    from solver.tasks.variations.end_conditions import Condition
    from solver.tasks.variations.euler_equations import Stationary
    from solver.tasks.variations.unknowns import Family

Side = tuple["Expr", "Expr"]
WHOLE_TURNS = range(-3, 4)
"""Of solutions that repeat, the ones that are looked through."""


@dataclass(frozen=True)
class Fitted:
    """A branch with its constants found: the functions, the values of multipliers, the end of the time."""

    family: Family
    functions: Mapping[str, Expr]
    values: Mapping[Symbol, Expr]
    t_f: Expr

    @property
    def left(self) -> list[Symbol]:
        """Constants that the ends do not fix."""
        inside: set[Any] = set().union(*(each.free_symbols for each in self.functions.values()))
        return [each for each in self.family.constants if each in inside]


@lemma("constants")
def fitted_of(
    found: Stationary, families: Sequence[Family], conditions: Sequence[Condition]
) -> Derivation[list[Fitted]]:
    """The members of the families that satisfy the conditions; raises Unsolved where there are none."""
    fitted: list[Fitted] = []
    for number, family in enumerate(families, 1):
        sides = yield from _put_in(found, family, conditions, number if len(families) > 1 else 0)
        sides = yield from _without_powers(sides, [*family.constants, *found.constants])
        points = yield from _solved(found, family, sides)
        fitted += [_member(found, family, point) for point in points]
    if not fitted:
        raise Unsolved("extremal/no_extremal", several=len(families) > 1, free=found.system.stop is None)
    left = [each for each in fitted if _leaves_reals(found.system, each)]
    if len(left) == len(fitted):
        functions = [f for each in left for f in each.functions.values()]
        raise Unsolved("extremal/not_real", functions=functions, start=found.system.start, stop=left[0].t_f)
    fitted = [each for each in fitted if each not in left]
    names = [found.system.symbol((n, 0)) for n in found.functions]
    yield Step("functions", unclaimed="the constants put in", names=names,
               members=[[each.functions[n] for n in found.functions] for each in fitted],
               times=[each.t_f for each in fitted], free=found.system.stop is None,
               left=[each.left for each in fitted], hyperbolic=_turned_hyperbolic(fitted))  # fmt: skip
    return fitted


def _leaves_reals(system: Functional, member: Fitted) -> bool:
    """Whether a function is not real, or not finite, at some time between the ends."""
    return any(exact.leaves_reals(f, system.t, system.start, member.t_f) for f in member.functions.values())


def _turned_hyperbolic(fitted: Sequence[Fitted]) -> bool:
    """Whether exponentials of a general solution are told as cosh and sinh."""
    return any(
        each.functions[name].has(sp.cosh, sp.sinh) and not general.has(sp.cosh, sp.sinh)
        for each in fitted
        for name, general in each.family.functions.items()
    )


def jets_along(system: Functional, family: Mapping[str, Expr], orders: int) -> dict[Symbol, Expr]:
    """Return the functions and their derivatives, by their symbols, as expressions in t."""
    return {
        system.symbol((name, k)): sp.diff(function, system.t, k)
        for name, function in family.items()
        for k in range(orders + 1)
    }


@lemma("constants")
def _put_in(found: Stationary, family: Family, conditions: Sequence[Condition], number: int) -> Derivation[list[Side]]:
    """Each condition with the general solution in it."""
    t, orders = found.system.t, 2 * max(found.system.orders.values())
    jets = jets_along(found.system, family.functions, orders)
    sides: list[Side] = []
    claims: dict[str, Claim] = {}
    shown: list[tuple[str, Any, Expr, Expr]] = []
    for i, condition in enumerate(conditions, 1):
        along = condition.left.xreplace(jets)
        right = condition.right.xreplace({t: condition.time})
        if condition.kind == "integral":
            integrand = exact.along(along, t)
            value = exact.definite_integral(integrand, t, found.system.start, condition.time)
            if value is None:
                raise Unsolved("extremal/integral", integrand=integrand, variable=t)
            stated = integral(integrand, t, found.system.start, condition.time)
            claims[f"integral{i}"] = Claim(stated, value, Phrase("the integral of constraint {i}", i=i))
            shown.append((condition.kind, stated, value, right))
            sides.append((value, right))
            continue
        value = along.xreplace({t: condition.time})
        shown.append((condition.kind, (condition.left, condition.time), value, right))
        sides.append((value, right))
    yield Step("put_in", claims=claims, unclaimed="" if claims else "conditions for the constants", shown=shown,
               number=number, used=[k for k in jets if any(c.left.has(k) for c in conditions)],
               constants=list(family.constants))  # fmt: skip
    return sides


@lemma("constants")
def _without_powers(sides: list[Side], constants: Sequence[Symbol]) -> Derivation[list[Side]]:
    """c Bʳ = a as B = (a/c)^(1/r), where a/c is positive and r a fraction other than a half."""
    found: list[Side] = []
    claims: dict[str, Claim] = {}
    for left, right in sides:
        factor, root = left.as_independent(*constants, as_Add=False)
        base, exponent = root.as_base_exp()
        value: Any = right / factor
        if exponent.is_Rational and sp.denom(exponent) > 2 and value.is_positive:
            found.append((base, value ** (1 / exponent)))
            name = f"power{len(claims) + 1}"
            claims[name] = Claim(power(value, 1 / exponent), found[-1][1], "the right side to that power")
        else:
            found.append((left, right))
    if claims:
        yield Step("powers", claims=claims, sides=[each for each in found if each not in sides])
    return found


@lemma("constants")
def _solved(found: Stationary, family: Family, sides: Sequence[Side]) -> Derivation[list[dict[Symbol, Expr]]]:
    """The constants: linear equations in turn, others case by case."""
    system = found.system
    unknowns: list[Any] = [*family.constants, *found.constants, *([system.end_time] if system.stop is None else [])]
    expressions = [left - right for left, right in sides]
    if found.constants and any(not f.is_polynomial(*found.constants) for f in family.functions.values()):
        raise Unsolved("extremal/constants", equations=list(sides), unknowns=unknowns)
    if all(_is_linear(each, unknowns) for each in expressions):
        return (yield from _linear(system, sides, unknowns))
    try:
        roots = yield from solutions_of(expressions, unknowns, {}, (), unknowns)
    except (exact.NotExact, TypeError) as reason:  # sympy compares nan where a case is outside of a function's domain
        raise Unsolved("extremal/constants", equations=list(sides), unknowns=unknowns) from reason
    if not roots.points and not roots.certain:
        raise Unsolved("extremal/constants", equations=list(sides), unknowns=unknowns)
    points = [dict(point) for point in roots.points]
    return list(_in_time(system, points))


def _is_linear(expression: Expr, unknowns: Sequence[Symbol]) -> bool:
    rates = [sp.diff(expression, x) for x in unknowns]
    return not any(rate.has(*unknowns) for rate in rates)


@lemma("constants")
def _linear(
    system: Functional, sides: Sequence[Side], unknowns: Sequence[Symbol]
) -> Derivation[list[dict[Symbol, Expr]]]:
    """Linear equations, the one with a single unknown first."""
    solved = exact.solved_in_turn(sides, [], unknowns, unknowns)
    if any(not exact.is_zero(each) for each in solved.tied):
        yield Step("contradiction", unclaimed="what is left of the equations", rest=list(solved.tied))
        return []
    values = {x: exact.in_time(value, system.t) for x, value in solved.values.items()}
    claims: dict[str, Claim] = {}
    rows: list[tuple[Symbol, Any, Expr]] = []
    kept: list[Any] = []
    for turn in solved.turns:
        if turn.stated is None:
            kept.append(([(x, value) for _, x, _, value in turn.through],
                         [(left, right) for _, left, right in turn.closing],
                         [(x, values[x]) for x in turn.symbols]))  # fmt: skip
            for n, left, right in turn.closing:
                says = "the constants put into the condition"
                claims[f"closing{n}"] = Claim(left.xreplace(values), right.xreplace(values), says)
            rows.append((turn.symbols[0], len(kept) - 1, sp.S.Zero))
            continue
        (x,) = turn.symbols
        rows.append((x, turn.stated, values[x]))
        claims[str(x)] = Claim(turn.stated.xreplace(values), values[x], Phrase("the value of {name}", name=str(x)))
    yield Step("linear", claims=claims, unclaimed="" if claims else "nothing is left to be found", rows=rows, kept=kept,
               lacking=list(solved.lacking), plain=not system.multipliers)  # fmt: skip
    return [values]


def _in_time(system: Any, points: Sequence[dict[Symbol, Expr]]) -> Iterator[dict[Symbol, Expr]]:
    """The solutions whose end comes after the beginning; of those that repeat, the first."""
    for point in points:
        whole = sorted({s for value in point.values() for s in value.free_symbols if s.is_integer}, key=str)
        members = [point] if not whole else [
            {x: value.xreplace({whole[0]: sp.Integer(n)}) for x, value in point.items()} for n in WHOLE_TURNS
        ]  # fmt: skip
        if system.stop is not None:
            yield from members[: 1 if not whole else len(members)]
            continue
        later = [each for each in members if (each[system.end_time] - system.start).is_negative is not True
                 and each[system.end_time] != system.start]  # fmt: skip
        yield from sorted(later, key=lambda each: sp.N(each[system.end_time]))[:1] if whole else later


def _member(found: Stationary, family: Family, point: Mapping[Any, Expr]) -> Fitted:
    system, t = found.system, found.system.t
    t_f = point[system.end_time] if system.stop is None else system.end_time
    functions = {
        name: exact.without_squares(exact.in_time(f.xreplace(dict(point)), t), t, system.start, t_f)
        for name, f in family.functions.items()
    }
    return Fitted(family, functions, {x: v for x, v in point.items() if x in found.constants}, t_f)
