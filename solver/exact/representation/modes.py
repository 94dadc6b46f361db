"""Realizations on the modes of a transfer matrix, exact: diagonal, Jordan and real modal form.

They are built on the residues R_j of (x − λ)⁻ʲ. Sources: lecture note, equation (1.10.21); several inputs and outputs:
E. G. Gilbert, Controllability and observability in multivariable control systems, SIAM J. Control 1 (1963).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.functions.residues import Residue, residues_at
from solver.exact.linear_algebra.fields import Algebraic, Modulus, NotExact, expression
from solver.exact.linear_algebra.instances import element_at
from solver.exact.linear_algebra.row_reduction import row_reduce
from solver.exact.linear_algebra.spectrum import Factor, Root, spectrum
from solver.exact.representation.polynomials import companion, elements
from solver.exact.representation.realization import Realization
from solver.exact.representation.transfer import TransferMatrix

Matrix = sp.ImmutableMatrix


@dataclass(frozen=True)
class Mode:
    """A pole λ with the residues R₁ … R_M (p×m) of (x − λ)⁻ʲ; `over_L` are the same over L = K[x]/(p)."""

    root: Root
    factor: Factor
    residues: tuple[sp.ImmutableMatrix, ...]
    over_L: tuple[Residue, ...]

    @property
    def multiplicity(self) -> int:
        """How often λ is a root of the (uncancelled) common denominator."""
        return self.root.multiplicity

    @property
    def rank(self) -> int:
        """The rank of R₁: how many states the first power needs."""
        rows = _algebraic(self.over_L[0], self.factor.modulus)
        return len(row_reduce(tuple(tuple(row) for row in rows)).pivots)

    @property
    def simple(self) -> bool:
        """Whether no higher power of (x − λ)⁻¹ than the first occurs."""
        return all(R.is_zero_matrix for R in self.residues[1:])


def modes(G: TransferMatrix) -> list[Mode]:
    """The modes of the common denominator with their residues, pole by pole; raises NotExact."""
    d = G.common_denominator
    if d.degree() == 0:
        return []
    K, n = d.domain, d.degree()
    over_d = [
        elements(top * d.quo(bottom), n)
        for tops, bottoms in zip(G.remainders, G.bottoms, strict=True)
        for top, bottom in zip(tops, bottoms, strict=True)
    ]
    p, m = G.shape
    numerator = [
        DomainMatrix([[over_d[i * m + j][k] for j in range(m)] for i in range(p)], (p, m), K) for k in range(n)
    ]
    found = []
    for factor in spectrum(companion(d)).factors:
        same = _over(K, factor)
        residues = residues_at(numerator, elements(d, n + 1), same).residues
        for root in factor.roots:
            instances = tuple(_at(root, Z, same.modulus, (p, m)) for Z in residues)
            found.append(Mode(root, same, instances, tuple(residues)))
    return found


def _over(K: Any, factor: Factor) -> Factor:
    """The factor with its coefficients in a larger field."""
    p = factor.modulus
    return Factor(Modulus(tuple(K.convert(c, p.domain) for c in p.low), K), factor.multiplicity, factor.roots)


def _algebraic(Z: Residue, modulus: Modulus) -> list[list[Algebraic]]:
    parts = [M.to_list() for M in Z]
    rows, columns = Z[0].shape
    return [[Algebraic([part[i][j] for part in parts], modulus) for j in range(columns)] for i in range(rows)]


def _at(root: Root, Z: Residue, modulus: Modulus, shape: tuple[int, int]) -> sp.ImmutableMatrix:
    return Matrix(*shape, [_written(a, root) for row in _algebraic(Z, modulus) for a in row])


def _written(a: Algebraic, root: Root) -> sp.Expr:
    """The element c₀ + c₁λ at a root σ ± δ with parameters as (c₀ + c₁σ) ± c₁δ, each part factored."""
    if root.kind != "symbolic" or root.shift == 0 or len(a.coefficients) != 2:
        return element_at(a, root)
    c0, c1 = (expression(a.modulus.domain, c) for c in a.coefficients)
    return sp.Add(sp.factor(c0 + c1 * root.sigma), sp.factor(c1) * root.shift)


Block = tuple[sp.MatrixBase, sp.MatrixBase, sp.MatrixBase]
"""A, B, C of one block."""


def jordan_realization(G: TransferMatrix, *, superdiagonal: bool = False) -> Realization:
    """Chains x₁' = λx₁ + bu, x_{k+1}' = λx_{k+1} + x_k (ones below the diagonal), or with the states in reverse."""
    blocks = [block for mode in modes(G) for block in _jordan_blocks(G, mode)]
    return _assembled(G, blocks, superdiagonal=superdiagonal)


def diagonal_realization(G: TransferMatrix) -> Realization:
    """One state a pole, repeated ones too; for poles whose higher residues vanish (raises ValueError for others)."""
    blocks = []
    for mode in modes(G):
        if not mode.simple:
            raise ValueError("a repeated pole has a chain")
        blocks += _simple_blocks(mode, mode.multiplicity)
    return _assembled(G, blocks)


def modal_realization(G: TransferMatrix, *, superdiagonal: bool = False) -> Realization:
    """As the Jordan form, but with a real block [[σ, ω], [−ω, σ]] for each conjugate pair σ ± jω."""
    blocks: list[Block] = []
    for mode in modes(G):
        kind, shift = mode.root.kind, mode.root.shift
        if shift == 0 or kind == "surd":
            blocks += _jordan_blocks(G, mode)
        elif kind == "symbolic":
            blocks += _undecided_block(G, mode)
        elif is_upper(mode):
            blocks += [_real_pair(block, mode.root) for block in _jordan_blocks(G, mode)]
    return _assembled(G, blocks, superdiagonal=superdiagonal)


def is_upper(mode: Mode) -> bool:
    """Whether the root is the first of its pair."""
    roots = mode.factor.roots
    return roots.index(mode.root) == min(
        i
        for i, other in enumerate(roots)
        if other.kind == mode.root.kind and other.sigma == mode.root.sigma and abs(other.shift) == abs(mode.root.shift)
    )


def _jordan_blocks(G: TransferMatrix, mode: Mode) -> list[Block]:
    """The blocks of one pole, ones below the diagonal."""
    p, m = G.shape
    if p == m == 1:
        return [_chain(mode.root.value, sp.eye(1), [R[0, 0] * sp.eye(1) for R in mode.residues])]
    if mode.simple:
        return _simple_blocks(mode, 1)
    if m <= p:  # a chain for each input, as long as its column needs
        return [
            _chain(
                mode.root.value,
                sp.Matrix(1, m, lambda _, k, j=j: int(k == j)),
                _until_zero([R[:, j] for R in mode.residues]),
            )
            for j in range(m)
            if any(R[:, j] != sp.zeros(p, 1) for R in mode.residues)
        ]
    return [
        _dual_chain(
            mode.root.value,
            sp.Matrix(p, 1, lambda k, _, i=i: int(k == i)),
            _until_zero([R[i, :] for R in mode.residues]),
        )
        for i in range(p)
        if any(R[i, :] != sp.zeros(1, m) for R in mode.residues)
    ]


def _until_zero(vectors: list[sp.MatrixBase]) -> list[sp.MatrixBase]:
    last = max(i for i, v in enumerate(vectors) if not v.is_zero_matrix)
    return vectors[: last + 1]


def _chain(value: sp.Expr, b: sp.MatrixBase, columns: Sequence[sp.MatrixBase]) -> Block:
    """The input drives the first state through b, each state the next; the outputs take column k of state k."""
    size = len(columns)
    B = sp.zeros(size, b.cols)
    B[0, :] = b
    return _lower(value, size), B, sp.Matrix.hstack(*columns)


def _dual_chain(value: sp.Expr, c: sp.MatrixBase, rows: Sequence[sp.MatrixBase]) -> Block:
    """The output is the last state, through the column c; u drives every state: R_k enters k − 1 states before it."""
    size = len(rows)
    C = sp.zeros(c.rows, size)
    C[:, size - 1] = c
    return _lower(value, size), sp.Matrix.vstack(*reversed(rows)), C


def _lower(value: sp.Expr, size: int) -> sp.Matrix:
    return sp.Matrix(size, size, lambda i, j: value if i == j else sp.Integer(int(i == j + 1)))


def _simple_blocks(mode: Mode, least: int) -> list[Block]:
    """R₁ = Σ cᵢ bᵢ, as few terms as the rank of R₁ (but `least`: a mode that does not show keeps its state)."""
    value, modulus = mode.root.value, mode.factor.modulus
    rows = _algebraic(mode.over_L[0], modulus)
    p, m = len(rows), len(rows[0])
    blocks: list[Block] = []
    if p == m == 1:
        if mode.residues[0][0, 0] != 0:
            blocks.append((sp.eye(1) * value, sp.eye(1), mode.residues[0].as_mutable()))
    else:
        reduction = row_reduce(tuple(tuple(row) for row in rows))
        for r, pivot in enumerate(reduction.pivots):
            b = sp.Matrix(1, m, [element_at(a, mode.root) for a in reduction.reduced[r]])
            c = sp.Matrix(p, 1, [element_at(row[pivot], mode.root) for row in rows])
            blocks.append((sp.eye(1) * value, b, c))
    hidden = (sp.eye(1) * value, sp.Matrix(1, m, lambda _, j: int(j == 0)), sp.zeros(p, 1))
    return blocks + [hidden] * (least - len(blocks))


def _real_pair(block: Block, root: Root) -> Block:
    """The real block of z' = λz + bu and its conjugate, in the states (Re z, −Im z)."""
    A, B, C = block
    n, pair = A.rows, sp.Matrix([[root.sigma, root.shift], [-root.shift, root.sigma]])
    real_A = sp.zeros(2 * n)
    for i in range(n):
        real_A[2 * i : 2 * i + 2, 2 * i : 2 * i + 2] = pair
        if i:
            real_A[2 * i : 2 * i + 2, 2 * i - 2 : 2 * i] = sp.eye(2) * A[i, i - 1]
    real_B, real_C = sp.zeros(2 * n, B.cols), sp.zeros(C.rows, 2 * n)
    for i in range(n):
        for j in range(B.cols):
            real, imaginary = real_and_imaginary(B[i, j])
            real_B[2 * i, j], real_B[2 * i + 1, j] = real, -imaginary
        for k in range(C.rows):
            real, imaginary = real_and_imaginary(C[k, i])
            real_C[k, 2 * i], real_C[k, 2 * i + 1] = 2 * real, 2 * imaginary
    return real_A, real_B, real_C


def real_and_imaginary(value: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Real and imaginary part of a sum of real terms and of real terms times j."""
    written = sp.expand(value)
    imaginary = written.coeff(sp.I)
    return sp.expand(written - sp.I * imaginary), imaginary


def _undecided_block(G: TransferMatrix, mode: Mode) -> list[Block]:
    """The block [[σ, 1], [δ², σ]] of roots σ ± δ, real whether δ² is positive or not; once for the pair."""
    if G.shape != (1, 1) or mode.multiplicity > 1:
        raise NotExact("representation/real_or_conjugate")
    if mode.root != mode.factor.roots[0]:
        return []
    K, sigma, square = mode.factor.modulus.domain, mode.root.sigma, sp.expand(mode.root.shift**2)
    r0, r1 = (expression(K, part.to_list()[0][0]) for part in mode.over_L[0])
    A = sp.Matrix([[sigma, 1], [square, sigma]])
    C = sp.Matrix([[2 * r1 * square, 2 * (r0 + r1 * sigma)]])
    return [(A, sp.Matrix([0, 1]), C.applyfunc(sp.cancel))]


def _assembled(G: TransferMatrix, blocks: Sequence[Block], *, superdiagonal: bool = False) -> Realization:
    """The blocks along the diagonal."""
    p, m = G.shape
    if superdiagonal:
        blocks = [_reversed(block) for block in blocks]
    return Realization(
        Matrix(sp.diag(*(A for A, _, _ in blocks))) if blocks else Matrix(0, 0, []),
        Matrix(sp.Matrix.vstack(sp.zeros(0, m), *(B for _, B, _ in blocks))),
        Matrix(sp.Matrix.hstack(sp.zeros(p, 0), *(C for _, _, C in blocks))),
        G.direct,
        tuple(A.rows for A, _, _ in blocks),
    )


def _reversed(block: Block) -> Block:
    """The chain with its states in reverse, pairs kept in order."""
    A, B, C = block
    step = 2 if A.rows > 1 and A[0, 1] != 0 else 1
    order = [i + k for i in range(A.rows - step, -1, -step) for k in range(step)]
    return A.extract(order, order), B.extract(order, list(range(B.cols))), C.extract(list(range(C.rows)), order)
