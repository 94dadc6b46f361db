"""Equations as products: the numerator of an expression in irreducible factors, and what its quotient must not be."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import sympy as sp

from solver.exact.modelling.evaluation import is_not_negative, sign_of
from solver.exact.modelling.quotients import quotients_in

MULTIPLES = 4
"""The highest multiple of an angle that is written by the angle itself."""


@dataclass(frozen=True)
class Factored:
    """The factors of a numerator that hold a variable, with their `powers`, and the `divisor` of the quotient."""

    factors: tuple[sp.Expr, ...]
    divisor: sp.Expr
    constant: sp.Expr
    powers: tuple[int, ...] = ()

    @property
    def is_zero(self) -> bool:
        """Whether the whole expression is zero."""
        return bool(self.constant == 0)


def angles_apart(expression: Any) -> Any:
    """Return an expression in which no angle holds a multiple of π: sin(x + nπ) is (−1)ⁿ sin x."""

    def apart(function: Any) -> Any:
        x = function.args[0]
        if x.is_Add and any(term.has(sp.pi) for term in x.args):
            turns = sp.Add(*(term for term in x.args if term.has(sp.pi)))
            rest = x - turns
            s, c = sp.sin(turns), sp.cos(turns)
            if isinstance(function, sp.sin):
                return sp.sin(rest) * c + sp.cos(rest) * s
            return sp.cos(rest) * c - sp.sin(rest) * s
        return function

    return expression.replace(lambda e: isinstance(e, sp.sin | sp.cos), apart)


@lru_cache(maxsize=512)
def factored(expression: Any) -> Factored:
    """Return the numerator of an expression in irreducible factors."""
    expression = _in_one_angle(angles_apart(_inside_expanded(expression)))
    field = quotients_in([expression])
    above, below = field.of(expression)
    if not above:
        return Factored((), sp.S.One, sp.S.Zero)
    number, factors = above.factor_list()
    constants = [sp.Rational(number)]
    kept: list[tuple[Any, int]] = []
    for factor, power in factors:
        value = factor.as_expr(*field.variables)
        if value.is_number:
            constants.append(value**power)
        else:
            kept.append((value, power))
    return Factored(
        tuple(f for f, _ in kept), below.as_expr(*field.variables), sp.Mul(*constants), tuple(k for _, k in kept)
    )


def _in_one_angle(expression: Any) -> Any:
    """Sines and cosines of multiples of an angle by those of the angle itself, where both are there."""
    angles = list(dict.fromkeys(f.args[0] for f in expression.atoms(sp.sin, sp.cos)))
    ratios = {a: b for a in angles for b in angles if a != b and (a / b).is_Integer and 1 < abs(a / b) <= MULTIPLES}
    put = {f: sp.expand_trig(f) for f in expression.atoms(sp.sin, sp.cos) if f.args[0] in ratios}
    return expression.xreplace(put)


def _inside_expanded(expression: Any) -> Any:
    """The arguments of functions and roots multiplied out, so that equal ones look alike."""
    found = {f: f.func(sp.expand(f.args[0]), *f.args[1:]) for f in expression.atoms(sp.Function) if f.args}
    roots = {p: sp.expand(p.base) ** p.exp for p in expression.atoms(sp.Pow) if not p.exp.is_Integer and p.base.is_Add}
    return expression.xreplace({**found, **roots})


def generators(expression: Any, unknowns: set[Any]) -> list[Any]:
    """Return the symbols and functions with unknowns in them of which a polynomial is made."""
    return [g for g in quotients_in([expression]).variables if g.free_symbols & unknowns
            and expression.has(g)]  # fmt: skip


def without_known_signs(value: Any) -> Any:
    """Return an expression of the same sign, without the factors whose signs are known."""
    parts = factored(value)
    below = factored(parts.divisor)
    sign, left = sign_of(parts.constant) or 1, []
    for f, power in (*zip(parts.factors, parts.powers, strict=True), *zip(below.factors, below.powers, strict=True)):
        known = sign_of(f)
        if power % 2 and known is None and not is_not_negative(f):
            left.append(f)
        elif power % 2 and known == -1:
            sign = -sign
    return sign * sp.Mul(*left)
