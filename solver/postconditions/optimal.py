"""Riccati equations: their cases, and whether a solution is exact."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
import sympy as sp

from solver.derivation import Check, Claim
from solver.stated.algebra import product, total
from solver.stated.matrices import inverse, transpose


def of_case_split(found: Any, equations: Sequence[Any], unknowns: Sequence[Any]) -> Iterator[Claim | Check]:
    """Every end solves the equations; the roots of an equation are all that it has, its factors make it up."""
    for end in found.ends() if found is not None else ():
        there = [equation.xreplace(dict(end)) for equation in equations]
        yield Claim(sp.ImmutableMatrix(there), sp.ImmutableMatrix(sp.zeros(len(there), 1)))
        yield Check.that("every unknown", "counted", set(end) == set(unknowns))
    if found is not None:
        yield from _complete(found, set(unknowns))


def _complete(case: Any, unknowns: set[Any]) -> Iterator[Claim | Check]:
    if case.kind == "roots" and case.condition is None:
        p = sp.Poly(case.equation, case.unknown)
        if p.degree() == len(case.values):
            yield Claim(case.equation, product(p.LC(), *(case.unknown - value for value in case.values)))
        elif not p.free_symbols_in_domain:
            roots = p.sqf_part().nroots(n=30, maxsteps=500)  # multiple ones converge slowly, if at all
            count = sum(abs(complex(root).imag) < 1e-12 for root in roots)
            yield Check.that("real roots", "sympy.nroots", count == len(case.values))
    if case.kind == "factors":
        rest = sp.cancel(case.equation / sp.Mul(*case.values))
        for value in case.values:  # a factor may stand there several times
            while not sp.denom(less := sp.cancel(rest / value)).free_symbols & unknowns:
                rest = less
        yield Check.that("factors of an equation", "sympy.cancel", not rest.free_symbols & unknowns)
    outcomes = {"roots": len(case.values), "factors": len(case.values), "substitute": 1}
    yield Check.that("cases", "counted", len(case.following) == outcomes.get(case.kind, 0))
    for each in case.following:
        yield from _complete(each, unknowns)


def of_weighted_input(found: Any, B: Any, R: Any) -> Iterator[Claim]:
    """B R⁻¹ Bᵀ."""
    yield Claim(product(B, inverse(R), transpose(B)), found)


def of_riccati(found: Any, A: Any, B: Any, Q: Any, R: Any) -> Iterator[Claim | Check]:
    """H of A, B R⁻¹ Bᵀ and Q; P solves the equation, its loop is stable; it is exact where it holds no decimals.

    Of numbers the loop has as many eigenvalues as states.
    """
    H, P = found.H, found.stabilizing.P
    hamiltonian = sp.Matrix(sp.BlockMatrix([[A, -found.G], [-Q, -A.T]]))
    yield Check.that("the Hamiltonian matrix", "compared", hamiltonian == H)
    yield Claim(product(B, inverse(R), transpose(B)), found.G)
    yield Claim(total(product(transpose(A), P), product(P, A), Q), product(P, found.G, P))
    every = (found.stabilizing, *(found.solutions if "solutions" in vars(found) else ()))  # one check for all of them
    yield Check.that("exactness", "decimals", all(bool(each.P.has(sp.Float)) != bool(each.exact) for each in every))
    if not P.free_symbols:
        yield Check.that("eigenvalues of the loop", "counted", len(found.eigenvalues) == A.rows)
    yield from _stable(A - found.G * P, lambda values: values.real)


def of_discrete_riccati(found: Any, A: Any, B: Any, Q: Any, R: Any) -> Iterator[Claim | Check]:
    """P solves the equation, its loop is stable; H is that of the pencil; it is exact where it holds no decimals."""
    P, Bt = found.stabilizing.P, transpose(B)
    gain = product(inverse(total(R, product(Bt, P, B))), Bt, P, A)
    yield Claim(total(Q, product(transpose(A), P, A)), total(P, product(transpose(A), P, B, gain)))
    yield Check.that("exactness", "decimals", bool(P.has(sp.Float)) != bool(found.stabilizing.exact))
    if R.rank() == R.rows:
        one, G = sp.eye(A.rows), sp.Matrix(B * R.LUsolve(sp.Matrix(B.T)))
        M = sp.Matrix(sp.BlockMatrix([[A, sp.zeros(*A.shape)], [-Q, one]]))
        E = sp.Matrix(sp.BlockMatrix([[one, G], [sp.zeros(*A.shape), A.T]]))
        yield Claim(product(sp.ImmutableMatrix(M + E), found.H), sp.ImmutableMatrix(M - E))
    if not any(X.free_symbols for X in (A, B, R, P)):
        a, b, r, p = (np.array(X.evalf(30).tolist(), dtype=float) for X in (A, B, R, P))
        loop = a - b @ np.linalg.solve(r + b.T @ p @ b, b.T @ p @ a)
        yield from _stable(sp.Matrix(loop), lambda values: np.abs(values) - 1)


def _stable(loop: Any, excess: Callable[[Any], Any]) -> Iterator[Check]:
    """No eigenvalue exceeds the border of stability by more than rounding does."""
    if not loop.free_symbols and loop.is_square:
        values = np.linalg.eigvals(np.array(loop.evalf(30).tolist(), dtype=complex))
        stable = bool(excess(values).max() < 1e-6 * (1 + np.abs(values).max()))
        yield Check.that("the stabilizing solution", "numpy.linalg.eigvals", stable)


def of_minimal_solution(found: Any, A: Any, _B: Any, Q: Any, _R: Any, *, discrete: bool = False) -> Iterator[Check]:
    """The modes that do not decay and that Q does not see; none where [λI − A; Q] has rank n at each of them."""
    if A.free_symbols or Q.free_symbols:
        return
    a, q = (np.array(M.evalf(30).tolist(), dtype=float) for M in (A, Q))

    def grows(value: Any) -> bool:
        return bool(abs(value) > 1 if discrete else value.real > 0)

    if found is None:
        for value in filter(grows, np.linalg.eigvals(a)):
            sizes = np.linalg.svd(np.vstack([value * np.eye(len(a)) - a, q]), compute_uv=False)
            yield Check.that("modes that are seen", "numpy.linalg.svd", bool(sizes[-1] > 1e-9 * sizes[0]))
        return
    V = np.array(found.unseen.evalf(30).tolist(), dtype=float)
    within = np.linalg.lstsq(V, a @ V, rcond=None)[0]
    values = sorted(filter(grows, np.linalg.eigvals(within)), key=_place)
    modes = sorted(map(complex, found.modes), key=_place)
    same = len(modes) == len(values) and np.allclose(modes, values, atol=1e-4 * (1 + np.abs(a).max()))
    yield Check.that("modes that are not seen", "numpy.linalg.eigvals", bool(same))


def _place(value: complex) -> tuple[float, float]:
    return round(value.real, 3), value.imag
