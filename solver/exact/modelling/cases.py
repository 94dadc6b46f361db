"""Cases: an outcome put into one, values as they are given at its end."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import mpmath
import sympy as sp

from solver.exact.linear_algebra.signs import possible_signs
from solver.exact.modelling.branches import Branch, Outcome, Point
from solver.exact.modelling.evaluation import DIGITS, decimal, evaluator, vanishes
from solver.exact.modelling.factors_of_equations import factored
from solver.exact.modelling.real_roots import in_factors

SHOWN = 15
"""Digits of decimals in points."""


def with_outcome(branch: Branch, outcome: Outcome) -> Branch | None:
    """The case with an outcome put into it; None where that contradicts what is assumed, or was said before."""
    put = outcome.put
    if any(_forbidden(x, v) for x, v in put.items()):
        return None
    found = {x: put_in(v, put) for x, v in branch.found.items()} | dict(put)
    integers = branch.integers + ((outcome.integer,) if outcome.integer is not None else ())
    others = (put_in(e, outcome.known) for e in branch.equations)
    equations = tuple(put_in(e, put) for e in (*outcome.equations, *others))
    needs = tuple(need.xreplace(put) for need in (*branch.needs, *outcome.needs))
    nonzero = tuple(put_in(e, put) for e in (*branch.nonzero, *outcome.nonzero))
    if any(vanishes(each) for each in nonzero):
        return None
    return replace(branch, equations=equations, found=found, integers=integers, needs=needs, nonzero=nonzero)


def _forbidden(x: Any, v: Any) -> bool:
    """Whether a value contradicts what is assumed of an unknown."""
    signs = possible_signs(_with_real_roots(v)) if x.is_positive or x.is_negative or x.is_nonzero else None
    return bool(
        signs is not None
        and ((x.is_positive and 1 not in signs) or (x.is_negative and -1 not in signs) or not signs - {0})
    )


def _with_real_roots(v: Any) -> Any:
    """A value that is real with its square roots as what they then are: numbers that are not negative."""
    roots = [p for p in v.atoms(sp.Pow) if p.exp == sp.S.Half and p.base.free_symbols and not p.is_nonnegative]
    return v.xreplace({root: sp.Dummy("r", nonnegative=True) for root in roots}) if roots else v


def allowed(branch: Branch, put: Point) -> bool:
    """Whether the equations hold as they stand, also where they have been cleared of divisors."""
    return all(vanishes(put_in(e, put)) or e.free_symbols - set(put) for e in branch.equations)


def put_in(expression: Any, put: Mapping[Any, Any]) -> Any:
    """Return an expression with values in place of symbols or functions."""
    return expression.xreplace(dict(put)) if put and expression.has(*put) else expression


def settled(value: Any) -> Any:
    """Decimals as they are given."""
    if value.has(sp.Float) and not value.free_symbols:
        with mpmath.workdps(DIGITS):
            return decimal(evaluator(value, [])(mpmath.mp, []), SHOWN)
    if value.free_symbols and not value.has(sp.Float, sp.pi):
        value = in_factors(value)
    return value.xreplace({f: sp.Float(f, SHOWN) for f in value.atoms(sp.Float)} | _turned(value))


def _turned(value: Any) -> dict[Any, Any]:
    """(−1)ⁿ in place of its inverse."""
    powers = [p for p in value.atoms(sp.Pow) if p.base == -1 and p.exp.could_extract_minus_sign()]
    return {p: sp.S.NegativeOne**-p.exp for p in powers}


def cleared(e: Any) -> Any:
    """The product of the factors, without divisors."""
    parts = factored(e)
    return sp.Mul(*parts.factors) if parts.factors else e
