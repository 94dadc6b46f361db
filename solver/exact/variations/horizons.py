"""The regulator over a finite horizon: −P' = AᵀP + PA − PGP + Q with P(T) = S, by its Hamiltonian matrix.

In the time to go τ = T − t, the columns of [X; Y] = e^{−Hτ} [I; S] follow the equations of the state and the costate
backwards from the end, with H = [[A, −G], [−Q, −Aᵀ]], and P = Y X⁻¹. The optimal motion is X(τ) X(T)⁻¹ x(0).
Source: W. T. Reid, Riccati Differential Equations (1972); B. D. O. Anderson, J. B. Moore, Optimal Control (1990), 2.3.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, reduce
from typing import Any

import sympy as sp

from solver.exact.functions.closed_forms import exponential
from solver.exact.optimal.weighting import weighted_input, weighted_transpose
from solver.exact.structure.ranks import hidden_part
from solver.exact.variations.exponential_sums import (
    ExponentialSum,
    Rows,
    determinant_and_adjugate,
    multiplied,
    read,
    read_matrix,
)
from solver.exact.variations.limits import long_run
from solver.exact.variations.quotients import quotient


@dataclass(frozen=True)
class Block:
    """States that are coupled to no others, in the order of the plant: X and Y of them, det X, and Y adj X."""

    states: tuple[int, ...]
    X: Rows
    Y: Rows
    determinant: ExponentialSum
    adjugate: Rows
    numerators: Rows
    reduce_: bool


@dataclass(frozen=True)
class FiniteHorizon:
    """The equation for A, G, Q, S (n×n) solved in the time to go `tau`; `law` is R⁻¹Bᵀ (m×n)."""

    A: sp.ImmutableMatrix
    H: sp.ImmutableMatrix
    law: sp.ImmutableMatrix
    tau: sp.Symbol
    blocks: tuple[Block, ...]

    @property
    def order(self) -> int:
        """The number n of states."""
        return int(self.A.rows)

    @cached_property
    def X(self) -> sp.ImmutableMatrix:
        """The upper half of e^{−Hτ} [I; S] (n×n)."""
        return self._whole("X")

    @cached_property
    def Y(self) -> sp.ImmutableMatrix:
        """The lower half of it (n×n)."""
        return self._whole("Y")

    def _whole(self, half: str) -> sp.ImmutableMatrix:
        found = sp.zeros(self.order)
        for block in self.blocks:
            for row, i in zip(getattr(block, half), block.states, strict=True):
                for entry, j in zip(row, block.states, strict=True):
                    found[i, j] = quotient(entry, ONE)
        return sp.ImmutableMatrix(found)

    @cached_property
    def determinant(self) -> sp.Expr:
        """The determinant of X."""
        return quotient(reduce(lambda a, b: a * b, (block.determinant for block in self.blocks)), ONE)

    @cached_property
    def P(self) -> sp.ImmutableMatrix:
        """P as a function of τ (n×n)."""
        found = sp.zeros(self.order)
        for block in self.blocks:
            for a, i in enumerate(block.states):
                for b, j in enumerate(block.states[a:], a):
                    value = quotient(block.numerators[a][b], block.determinant, reduce_=block.reduce_)
                    found[i, j] = found[j, i] = value
        return sp.ImmutableMatrix(found)

    @cached_property
    def K(self) -> sp.ImmutableMatrix:
        """R⁻¹ Bᵀ P as a function of τ (m×n)."""
        if self.order == 1:
            return sp.ImmutableMatrix([c * self.P[0, 0] for c in self.law.flat()])
        found = sp.zeros(*self.law.shape)
        for block in self.blocks:
            law = read_matrix(self.law.extract(list(range(self.law.rows)), list(block.states)), ())
            gains = multiplied(law, block.numerators)
            for k, row in enumerate(gains):
                for entry, j in zip(row, block.states, strict=True):
                    found[k, j] = quotient(entry, block.determinant, reduce_=block.reduce_)
        return sp.ImmutableMatrix(found)

    @cached_property
    def limit(self) -> sp.ImmutableMatrix | None:
        """P for τ → ∞; None where an entry has no limit (it grows, or oscillates), or the signs are open."""
        found = sp.zeros(self.order)
        for block in self.blocks:
            for a, i in enumerate(block.states):
                for b, j in enumerate(block.states[a:], a):
                    value = long_run(block.numerators[a][b], block.determinant, self.tau)
                    if value is None:
                        return None
                    found[i, j] = found[j, i] = value
        return sp.ImmutableMatrix(found)

    def in_time(self, M: sp.ImmutableMatrix, T: sp.Expr) -> sp.ImmutableMatrix:
        """A matrix of functions of τ with T − t for τ; arguments with other terms are multiplied out."""
        found = M.xreplace({self.tau: T - sp.Symbol("t")})
        functions: set[Any] = found.atoms(sp.exp, sp.cosh, sp.sinh, sp.cos, sp.sin, sp.tanh)
        mixed = {f: f.func(sp.expand(f.args[0])) for f in functions if f.args[0].is_Add}
        return sp.ImmutableMatrix(found.xreplace(mixed))

    def motion(self, x0: sp.ImmutableMatrix, T: sp.Expr) -> tuple[sp.ImmutableMatrix, sp.ImmutableMatrix]:
        """The optimal x (n×1) and u (m×1) as functions of τ from x(0) = x₀, for a horizon T."""
        x, u = sp.zeros(self.order, 1), sp.zeros(self.law.rows, 1)
        times: set[Any] = {self.tau, *T.free_symbols}
        parts: list[list[sp.Expr]] = [[] for _ in range(self.law.rows)]
        for block in self.blocks:
            D = _at(block.determinant, self.tau, T)
            adjugate = [[_at(entry, self.tau, T) for entry in row] for row in block.adjugate]
            start = multiplied(adjugate, read_matrix(x0.extract(list(block.states), [0]), times))
            law = read_matrix(self.law.extract(list(range(self.law.rows)), list(block.states)), ())
            states, costates = multiplied(block.X, start), multiplied(block.Y, start)
            for row, i in zip(states, block.states, strict=True):
                x[i, 0] = quotient(row[0], D, reduce_=block.reduce_)
            for k, row in enumerate(multiplied(law, costates)):
                parts[k].append(-quotient(row[0], D, reduce_=block.reduce_))
        for k, each in enumerate(parts):
            u[k, 0] = sp.Add(*each)
        return sp.ImmutableMatrix(x), sp.ImmutableMatrix(u)

    def value(self, x0: sp.ImmutableMatrix, T: sp.Expr) -> sp.Expr:
        """x₀ᵀ P(0) x₀ for a horizon T."""
        times: set[Any] = set(T.free_symbols)
        found = []
        for block in self.blocks:
            start = read_matrix(x0.extract(list(block.states), [0]), times)
            at_T = [[_at(entry, self.tau, T) for entry in row] for row in block.numerators]
            form = multiplied([[row[0] for row in start]], multiplied(at_T, start))[0][0]
            found.append(quotient(form, _at(block.determinant, self.tau, T), reduce_=block.reduce_))
        return sp.Add(*found)


def _at(part: ExponentialSum, tau: sp.Symbol, T: sp.Expr) -> ExponentialSum:
    """A sum in τ for τ = T."""
    times: set[Any] = set(T.free_symbols)
    return read(part.expression.xreplace({tau: T}), times)


ONE = ExponentialSum.constant(sp.S.One)


def finite_horizon(
    A: sp.ImmutableMatrix,
    B: sp.ImmutableMatrix,
    Q: sp.ImmutableMatrix,
    R: sp.ImmutableMatrix,
    S: sp.ImmutableMatrix,
) -> FiniteHorizon:
    """Return it for A n×n, B n×m, Q ≥ 0 and S ≥ 0 n×n, R > 0 m×m.

    Raises NotExact where the spectrum of the Hamiltonian matrix has no usable form.
    """
    tau = sp.Symbol("tau")
    G = weighted_input(B, R)
    H = _hamiltonian(A, G, Q)
    blocks = tuple(_block(A, G, Q, S, states, tau) for states in _components(A, G, Q, S))
    return FiniteHorizon(A, H, weighted_transpose(B, R), tau, blocks)


def _hamiltonian(A: sp.ImmutableMatrix, G: sp.ImmutableMatrix, Q: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    upper, lower = sp.Matrix.hstack(sp.Matrix(A), -sp.Matrix(G)), sp.Matrix.hstack(-sp.Matrix(Q), -sp.Matrix(A.T))
    return sp.ImmutableMatrix(sp.Matrix.vstack(upper, lower))


def _components(*matrices: sp.ImmutableMatrix) -> list[tuple[int, ...]]:
    """The states in groups that no entry of the matrices couples."""
    groups: list[set[int]] = []
    for i in range(matrices[0].rows):
        linked = {i} | {j for M in matrices for j in range(M.cols) if M[i, j] != 0 or M[j, i] != 0}
        for group in [each for each in groups if each & linked]:
            groups.remove(group)
            linked |= group
        groups.append(linked)
    return sorted(tuple(sorted(group)) for group in groups)


def _block(
    A: sp.ImmutableMatrix,
    G: sp.ImmutableMatrix,
    Q: sp.ImmutableMatrix,
    S: sp.ImmutableMatrix,
    states: tuple[int, ...],
    tau: sp.Symbol,
) -> Block:
    """X and Y of some states by themselves."""
    own = list(states)
    A, G, Q, S = (sp.ImmutableMatrix(M.extract(own, own)) for M in (A, G, Q, S))
    n = len(own)
    backwards = exponential(sp.ImmutableMatrix(-_hamiltonian(A, G, Q)), tau).matrix
    moved = read_matrix(backwards, (tau,))
    end = read_matrix(sp.Matrix.vstack(sp.eye(n), sp.Matrix(S)), ())
    both = multiplied(moved, end) if any(S.flat()) else [row[:n] for row in moved]
    X, Y = both[:n], both[n:]
    D, adjugate = determinant_and_adjugate(X)
    reduce_ = n > 1 and (hidden_part(A, G) is not None or hidden_part(sp.ImmutableMatrix(A.T), Q) is not None)
    return Block(states, X, Y, D, adjugate, multiplied(Y, adjugate), reduce_)
