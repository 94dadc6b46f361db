"""Optimal control over a finite horizon: transfers with least energy, Riccati equations run back from the end."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from solver.derivation import Claim
from solver.postconditions.structure import krylov
from solver.stated.algebra import difference, exponential, product, total
from solver.stated.calculus import derivative, value_at
from solver.stated.matrices import inverse, rank, transpose


def of_minimum_energy(found: Any, A: Any, B: Any, R: Any, ends: Any, T: Any) -> Iterator[Claim]:
    """W η = d; x' = A x + B u from the one end to the other; λ' = −Aᵀλ; rows that annihilate what is reached."""
    t = sp.Symbol("t")
    x0, xf = ends
    yield Claim(exponential(product(A, t)), found.transition)
    yield Claim(product(exponential(product(A, T)), x0), found.drift)
    yield Claim(difference(xf, found.drift), found.gap)
    yield Claim(product(found.gramian, found.eta), found.gap)
    moving = total(product(A, found.gramian), product(found.gramian, transpose(A)))
    moved = product(exponential(product(A, T)), B)
    yield Claim(moving, difference(product(moved, inverse(R), transpose(moved)), product(B, inverse(R), transpose(B))))
    yield Claim(derivative(found.x, t), total(product(A, found.x), product(B, found.u)))
    yield Claim(value_at(found.x, t, sp.S.Zero), x0)
    yield Claim(value_at(found.x, t, T), xf)
    yield Claim(derivative(found.adjoint, t), product(-1, transpose(A), found.adjoint))
    yield Claim(value_at(found.adjoint, t, T), found.eta)
    yield Claim(value_at(found.adjoint, t, sp.S.Zero), found.start)
    yield Claim(product(inverse(R), transpose(B), found.adjoint), found.u)
    yield Claim(total(product(found.transition, x0), product(found.spread, found.start)), found.x)
    yield Claim(product(transpose(found.gap), found.eta), found.energy)
    yield Claim(rank(krylov(A, B)), sp.Integer(A.rows - found.unreached.rows))
    if found.unreached.rows:
        yield Claim(
            product(found.unreached, krylov(A, B)), sp.ImmutableMatrix(sp.zeros(found.unreached.rows, B.cols * A.rows))
        )
