"""Realizations put together: their transfer matrices in series and in a loop."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.stated import Stated
from solver.stated.algebra import product, total
from solver.stated.matrices import determinant, inverse


def of_constant_realization(found: Any, D: Any) -> Iterator[Claim | Check]:
    """No states, and D."""
    yield Check.that("no states", "counted", found.A.shape == (0, 0) and found.B.cols == D.cols)
    yield Claim(D, found.D)


def of_in_series(found: Any, first: Any, second: Any) -> Iterator[Claim | Check]:
    """G₂ G₁, with the states of both."""
    yield _states(found, first, second)
    if found.A.rows:
        yield Claim(product(_transfer(second), _transfer(first)), _transfer(found))


def of_fed_back(found: Any, forward: Any, back: Any) -> Iterator[Claim | Check]:
    """L (I + H L)⁻¹, with the states of both; None where I + D_H D_L has no inverse."""
    identity = sp.ImmutableMatrix(sp.eye(forward.B.cols))
    if found is None:
        yield Claim(determinant(total(identity, product(back.D, forward.D))), sp.Integer(0))
        return
    yield _states(found, forward, back)
    if found.A.rows:
        L, H = _transfer(forward), _transfer(back)
        yield Claim(product(L, inverse(total(identity, product(H, L)))), _transfer(found))


def _states(found: Any, first: Any, second: Any) -> Check:
    return Check.that("the states of both", "counted", found.A.rows == first.A.rows + second.A.rows)


def _transfer(of: Any) -> Stated:
    """C (sI − A)⁻¹ B + D."""
    if not of.A.rows:
        return total(of.D)
    s = sp.Symbol("s")
    pencil = sp.ImmutableMatrix(s * sp.eye(of.A.rows) - of.A)
    return total(product(of.C, inverse(pencil), of.B), of.D)
