"""Optimal control over a finite horizon: transfers with least energy, Riccati equations run back from the end."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from solver.derivation import Claim
from solver.postconditions.structure import krylov
from solver.stated.algebra import difference, exponential, product, total
from solver.stated.calculus import derivative, value_at
from solver.stated.matrices import determinant, inverse, rank, transpose


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


def of_finite_horizon(found: Any, A: Any, B: Any, Q: Any, R: Any, S: Any) -> Iterator[Claim]:
    """[X; Y] begins at [I; S] and follows −H; P X = Y, K = R⁻¹BᵀP; the limit solves the algebraic equation."""
    tau, n = found.tau, A.rows
    both = sp.ImmutableMatrix(sp.Matrix.vstack(sp.Matrix(found.X), sp.Matrix(found.Y)))
    end = sp.ImmutableMatrix(sp.Matrix.vstack(sp.eye(n), sp.Matrix(S)))
    G = product(B, inverse(R), transpose(B))
    yield Claim(value_at(both, tau, sp.S.Zero), end)
    yield Claim(derivative(found.X, tau), difference(product(G, found.Y), product(A, found.X)))
    yield Claim(derivative(found.Y, tau), total(product(Q, found.X), product(transpose(A), found.Y)))
    yield Claim(determinant(found.X), found.determinant)
    yield Claim(product(found.P, found.X), found.Y)
    yield Claim(product(inverse(R), transpose(B), found.P), found.K)
    if (P := found.limit) is not None:
        yield Claim(total(product(transpose(A), P), product(P, A), Q), product(P, G, P))


def of_riccati_recursion(
    found: Any, A: Any, B: Any, Q: Any, R: Any, S: Any, steps: int, x0: Any = None
) -> Iterator[Claim]:
    """P_N = S; each gain and each matrix follows from the matrix after it, each state from the one before."""
    yield Claim(sp.Integer(len(found.P)), sp.Integer(steps + 1))
    yield Claim(sp.Integer(len(found.K)), sp.Integer(steps))
    yield Claim(found.P[-1], S)
    for earlier, later, K in zip(found.P, found.P[1:], found.K, strict=False):
        weight = total(R, product(transpose(B), later, B))
        yield Claim(product(weight, K), product(transpose(B), later, A))
        yield Claim(total(Q, product(transpose(A), later, difference(A, product(B, K)))), earlier)
    if x0 is not None:
        yield Claim(found.x[0], x0)
        for before, after, u, K in zip(found.x, found.x[1:], found.u, found.K, strict=False):
            yield Claim(product(-1, K, before), u)
            yield Claim(total(product(A, before), product(B, u)), after)
