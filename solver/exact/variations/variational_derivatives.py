"""Variational derivatives: ∂φ/∂x − d/dt ∂φ/∂x' + d²/dt² ∂φ/∂x'' − …, and equations as a person writes them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.modelling.time_derivatives import time_derivative
from solver.exact.variations.increments import tidied


@dataclass(frozen=True, slots=True)
class VariationalDerivative:
    """The derivatives of φ by q, q', q'', ..., what d/dt makes of the k-th after k times, and the sum of them.

    `momenta[k]` stands beside the variation of the k-th derivative at the ends:
    p_k = ∂φ/∂q^(k+1) − d/dt p_(k+1).
    """

    partials: tuple[sp.Expr, ...]
    rates: tuple[tuple[sp.Expr, ...], ...]
    momenta: tuple[sp.Expr, ...]
    expression: sp.Expr


def variational_derivative(
    phi: sp.Expr, jets: Sequence[sp.Symbol], following: Mapping[sp.Symbol, sp.Expr]
) -> VariationalDerivative:
    """Return the variational derivative by a function whose value and derivatives are `jets`, the value first.

    `following` has the derivative of every symbol that varies with time. Source: Gelfand and Fomin, §4, §11.
    """
    partials = tuple(tidied(sp.diff(phi, q)) for q in jets)
    rates = []
    for k, partial in enumerate(partials):
        chain = [partial]
        for _ in range(k):
            chain.append(spread(time_derivative(chain[-1], following)))
        rates.append(tuple(chain[1:]))
    momenta: list[sp.Expr] = []
    for partial in reversed(partials[1:]):
        above = time_derivative(momenta[0], following) if momenta else sp.S.Zero
        momenta.insert(0, spread(partial - above))
    whole = sp.Add(partials[0], *((-1) ** (k + 1) * chain[-1] for k, chain in enumerate(rates[1:])))
    return VariationalDerivative(partials, tuple(rates), tuple(momenta), whole)


def spread(expression: sp.Expr) -> sp.Expr:
    """Return a sum with plain terms multiplied out; over one denominator where there are roots or quotients."""
    if not isinstance(expression, sp.Add | sp.Mul | sp.Pow):
        return expression
    if expression.is_polynomial(*expression.free_symbols) or _is_plain(expression):
        return sp.expand(expression)
    return sp.factor(sp.together(expression))


def _is_plain(expression: sp.Expr) -> bool:
    """Whether roots, and sums below a bar, are absent."""
    powers = expression.atoms(sp.Pow)
    return not any(not p.exp.is_Integer or (p.exp.is_negative and p.base.is_Add) for p in powers if not p.is_number)


@dataclass(frozen=True, slots=True)
class Cleared:
    """`left` is zero where the expression is; `by` is what the expression was divided by, never zero."""

    left: sp.Expr
    by: sp.Expr


def cleared(expression: sp.Expr, jets: Sequence[sp.Symbol], varying: Sequence[sp.Symbol] = ()) -> Cleared:
    """Return an equation without numbers, denominators and factors that are never zero.

    So are factors of parameters alone, where it is told what else is `varying`.

    The terms with the first of `jets` in it that occurs, the highest derivatives, are given a positive sign.
    """
    if expression == 0:
        return Cleared(expression, sp.S.One)
    number, factors = sp.factor_list(sp.numer(together := sp.together(expression)))
    kept: list[sp.Expr] = []
    dropped: list[sp.Expr] = [number / sp.denom(together)]
    for base, exponent in factors:
        given = bool(varying) and base.free_symbols.isdisjoint({*jets, *varying})
        (dropped if given or never_zero(base) else kept).append(base**exponent)
    kept, implied = _without_implied(kept, jets)
    dropped += implied
    left = sp.Mul(*kept)
    if len(kept) == 1 and not isinstance(left, sp.Pow):
        left = sp.expand(left) if left.is_polynomial(*left.free_symbols) or _is_plain(left) else left
    if _leads_negative(left, jets):
        left, dropped = _reversed(left), [*dropped, sp.Integer(-1)]
    return Cleared(left, sp.Mul(*dropped))


def _without_implied(factors: list[sp.Expr], jets: Sequence[sp.Symbol]) -> tuple[list[sp.Expr], list[sp.Expr]]:
    """Of x' x'' = 0 the higher derivative alone, which is zero where the lower one is: the factors kept, and the rest.

    `jets` are derivatives, the highest first.
    """
    bases = [factor.as_base_exp()[0] for factor in factors]
    ranks = [jets.index(base) if base in jets else -1 for base in bases]
    if len(factors) < 2 or any(rank < 0 or "_d" not in str(base) for rank, base in zip(ranks, bases, strict=True)):
        return factors, []
    if len({str(base).rpartition("_")[0] for base in bases}) > 1:
        return factors, []
    first = min(range(len(factors)), key=lambda i: ranks[i])
    return [bases[first]], [factor for i, factor in enumerate(factors) if i != first]


def _reversed(left: sp.Expr) -> sp.Expr:
    return sp.Add(*(-term for term in sp.Add.make_args(left)))


def never_zero(factor: sp.Expr) -> bool:
    """Whether a factor has no zeros where it is defined: numbers, exponentials, sums of squares and one, 1/x."""
    if factor.is_positive or factor.is_negative or isinstance(factor, sp.exp):
        return True
    if isinstance(factor, sp.Pow):
        return bool(factor.exp.is_negative) or never_zero(factor.base)
    return bool(factor.is_zero is False)


def _leads_negative(left: sp.Expr, jets: Sequence[sp.Symbol]) -> bool:
    """Whether the terms with the highest derivative are negative."""
    whole = sp.expand(left)
    terms = sp.Add.make_args(whole)
    leading = next((found for q in jets if (found := [term for term in terms if term.has(q)])), list(terms))
    return all(term.could_extract_minus_sign() for term in leading)
