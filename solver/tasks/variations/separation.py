"""Lemma: equations of first order whose variables can be separated, first integrals among them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import power
from solver.stated.calculus import derivative
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.tasks.variations.unknowns import Constants, Unknown


@dataclass(frozen=True)
class Ways:
    """How an equation of first order is separated: x' or x'², the functions, and the constant that became a square."""

    rate: exact.Rate
    plain: exact.Rate
    squared: Any
    found: exact.Separated


def ways_to_separate(
    equation: Expr, unknown: Unknown, t: Symbol, constants: Sequence[Symbol], new: Symbol
) -> Ways | None:
    """What separation would find; None where it does not apply."""
    rate = exact.rate_of(equation, unknown.jets[1])
    if rate is None or unknown.order_in(equation) != 1:
        return None
    renamed = exact.with_square(rate, constants)
    used, squared = renamed if renamed is not None else (rate, None)
    found = exact.separated(used, unknown.symbol, t, new)
    return None if found is None else Ways(used, rate, squared, found)


@lemma("separation")
def by_separation(ways: Ways, unknown: Unknown, t: Symbol, constants: Constants) -> Derivation[list[Expr]]:
    """x' or x'² by x (or t), then its integral, turned round: one function or two branches."""
    x, rate = unknown.jets[:2]
    new = constants.found[-1]
    yield Step("rate", unclaimed="the equation, solved for x'", rate=rate, power=ways.plain.power,
               value=ways.plain.value, squared=ways.squared, renamed=ways.rate.value, x=x)  # fmt: skip
    claims = {}
    for i, f in enumerate(ways.found.functions, 1):
        slope: Any = derivative(f, t)
        stated = slope if ways.rate.power == 1 else power(slope, 2)
        if len(ways.found.functions) == 1 or i == 1:
            claims[f"solves{i}"] = Claim(stated, ways.rate.value.xreplace({x: f}), Phrase("the equation for $x'$"))
    sound = {} if _may_leave_the_reals(ways.found.functions) else claims
    yield Step("separated", claims=sound, unclaimed="" if sound else "roots whose radicands depend on the constants",
               way=ways.found.kind, auxiliary=ways.found.auxiliary, functions=list(ways.found.functions), x=x,
               integral=ways.found.integral, constant=new, rate=ways.rate.value, power=ways.rate.power)  # fmt: skip
    return list(ways.found.functions)


def _may_leave_the_reals(functions: Sequence[Expr]) -> bool:
    """Whether a power of constants may have a negative base at random values."""
    return any(not p.exp.is_Integer and p.base.free_symbols for f in functions for p in f.atoms(sp.Pow))
