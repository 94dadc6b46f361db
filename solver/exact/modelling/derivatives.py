"""Partial derivatives of sums and products of powers, sines and cosines, term by term; of anything else by sympy."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import sympy as sp


def partial(expression: sp.Expr, x: sp.Symbol) -> sp.Expr:
    """Return ∂e/∂x, nothing multiplied out."""
    found: sp.Expr = _partial(expression, x, {})
    return found


def _partial(e: Any, x: sp.Symbol, known: dict[Any, Any]) -> Any:
    if e.is_Atom:
        return sp.S.One if e == x else sp.S.Zero
    if e not in known:
        known[e] = _taken(e, x, known)
    return known[e]


def _taken(e: Any, x: sp.Symbol, known: dict[Any, Any]) -> Any:
    if e.is_Add:
        return sp.Add(*(_partial(term, x, known) for term in e.args))
    if e.is_Mul:
        return sp.Add(*_product_rule(e.args, x, known))
    if e.is_Pow and e.exp.is_Rational:
        return _power_rule(e, _partial(e.base, x, known))
    if isinstance(e, sp.sin | sp.cos):
        inner = _partial(e.args[0], x, known)
        outer = sp.cos(e.args[0]) if isinstance(e, sp.sin) else -sp.sin(e.args[0])
        return inner * outer if inner != 0 else inner
    return sp.diff(e, x)


def _power_rule(power: Any, inner: Any) -> Any:
    """The derivative of a power whose base has the derivative `inner`."""
    base, k = power.args
    if inner == 0:
        return inner
    if base.is_Add and k.is_Integer and k > 0:  # the number goes into what is simpler: 4 x (x² + 1)
        return inner * k * base ** (k - 1)
    return k * base ** (k - 1) * inner


def _product_rule(factors: tuple[Any, ...], x: sp.Symbol, known: dict[Any, Any]) -> list[Any]:
    slopes = [_partial(factor, x, known) for factor in factors]
    return [sp.Mul(slope, *factors[:i], *factors[i + 1 :]) for i, slope in enumerate(slopes) if slope != 0]


def is_nonlinear(expressions: Collection[sp.Expr], symbols: Collection[sp.Symbol]) -> bool:
    """Whether it is seen that expressions are not linear in symbols: one stands in a function, power or denominator."""
    inside = frozenset(symbols)
    return any(_holds(e, inside) for e in expressions)


def _holds(e: Any, inside: frozenset[Any]) -> bool:
    if e.is_Atom:
        return False
    if e.is_Add or e.is_Mul:
        return any(_holds(part, inside) for part in e.args)
    if e.is_Pow and e.exp.is_Integer and e.exp > 0:
        return _holds(e.base, inside)
    return bool(e.free_symbols & inside)
