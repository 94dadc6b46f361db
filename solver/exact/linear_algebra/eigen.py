"""Eigenvectors, chains of generalized eigenvectors and Jordan form, exactly, one computation for each factor of χ.

Over L = K[x]/(p) the root x of p is an eigenvalue, so null spaces of powers of A − xI are found by row reduction in L
and then instantiated at each root of p.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property, lru_cache, partial, reduce
from itertools import islice
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import Algebraic, Modulus, domain_matrix
from solver.exact.linear_algebra.instances import element_at
from solver.exact.linear_algebra.multiples import Vector, cleared, without_common_factor
from solver.exact.linear_algebra.row_reduction import RowReduction, Rows, null_space, row_reduce
from solver.exact.linear_algebra.spectrum import Factor, Root, Spectrum, spectrum

Chain = tuple[sp.ImmutableMatrix, ...]


@dataclass(frozen=True)
class Eigenspace:
    """One eigenvalue: chains of column vectors n×1, each chain from its eigenvector up; (A − λI) c_{j+1} = c_j.

    `over_L` is the row reduction of xI − A over L (None for decimal λ). `nullities` are the dimensions of
    the null spaces of (A − λI)ᵏ, k = 1, 2, … until they stay. `dual` are the rows of V⁻¹ for
    these columns of V, chain by chain, written as columns.
    """

    root: Root
    chains: tuple[Chain, ...]
    nullities: tuple[int, ...]
    over_L: RowReduction | None = field(repr=False)
    dual: tuple[Chain, ...]

    @cached_property
    def reduction(self) -> RowReduction | None:
        """The row reduction of λI − A in expressions; made when asked for, since few pages show it."""
        return self.over_L and self.over_L.mapped(partial(element_at, root=self.root))

    def __getstate__(self) -> dict[str, Any]:
        """What is sent from one process to another: not the elements of L, since sympy can't pickle their fields."""
        return {**self.__dict__, "over_L": None}

    @property
    def algebraic(self) -> int:
        """Algebraic multiplicity."""
        return self.root.multiplicity

    @property
    def geometric(self) -> int:
        """Geometric multiplicity: the number of independent eigenvectors."""
        return len(self.chains)


@dataclass(frozen=True)
class Eigenstructure:
    """All eigenspaces of A, in the order of the spectrum."""

    spectrum: Spectrum
    eigenspaces: tuple[Eigenspace, ...]
    left_eigenspaces: tuple[Eigenspace, ...]

    @property
    def eigenvalues(self) -> list[sp.Expr]:
        """The diagonal of J."""
        return [space.root.value for space in self.eigenspaces for _ in range(space.algebraic)]

    @property
    def diagonalizable(self) -> bool:
        """Whether there are n independent eigenvectors."""
        return all(space.geometric == space.algebraic for space in self.eigenspaces)

    @cached_property
    def right(self) -> sp.ImmutableMatrix:
        """V (n×n): the chains as columns, A V = V J."""
        return sp.ImmutableMatrix(sp.Matrix.hstack(*(v for s in self.eigenspaces for chain in s.chains for v in chain)))

    @cached_property
    def right_inverse(self) -> sp.ImmutableMatrix:
        """V⁻¹ (n×n)."""
        rows = [d.T for s in self.eigenspaces for chain in s.dual for d in chain]
        return sp.ImmutableMatrix(sp.Matrix.vstack(*rows))

    @cached_property
    def left_inverse(self) -> sp.ImmutableMatrix:
        """M⁻¹ (n×n)."""
        columns = [d for s in self.left_eigenspaces for chain in s.dual for d in reversed(chain)]
        return sp.ImmutableMatrix(sp.Matrix.hstack(*columns))

    @cached_property
    def jordan_form(self) -> sp.ImmutableMatrix:
        """J (n×n): the eigenvalues on the diagonal, a one above it inside each chain."""
        return self.of_blocks(lambda value, distance: value if distance == 0 else sp.Integer(int(distance == 1)))

    def of_blocks(self, entry: Callable[[sp.Expr, int], sp.Expr]) -> sp.ImmutableMatrix:
        """The matrix of upper triangular blocks, one a chain, with entry(λ, d) on the d-th diagonal above the main."""
        blocks = []
        for space in self.eigenspaces:
            for chain in space.chains:
                row = [entry(space.root.value, distance) for distance in range(len(chain))]
                blocks.append(sp.Matrix(len(row), len(row), lambda i, j, row=row: row[j - i] if j >= i else 0))
        return sp.ImmutableMatrix(sp.diag(*blocks))

    @cached_property
    def left(self) -> sp.ImmutableMatrix:
        """M (n×n): rows with M A = J M; the last row of a chain is a left eigenvector."""
        rows = [v.T for s in self.left_eigenspaces for chain in s.chains for v in reversed(chain)]
        return sp.ImmutableMatrix(sp.Matrix.vstack(*rows))


@lru_cache(maxsize=64)
def eigenstructure(A: sp.ImmutableMatrix) -> Eigenstructure:
    """The eigenstructure of A (n×n). The chains of Aᵀ, turned round, are the left chains of A."""
    found = spectrum(A)
    right: list[Eigenspace] = []
    left: list[Eigenspace] = []
    for factor in found.factors:
        V, W = _basis(A, factor), _basis(sp.ImmutableMatrix(A.T), factor)
        right += _at_roots(factor, V, _dual(V, W))
        left += _at_roots(factor, W, _dual(W, V))
    return Eigenstructure(found, tuple(right), tuple(left))


@dataclass(frozen=True)
class _Basis:
    """Chains over L, the nullities of the powers of A − xI, and the row reduction of xI − A."""

    chains: list[list[Vector]]
    nullities: tuple[int, ...]
    reduction: RowReduction


def _basis(A: sp.ImmutableMatrix, factor: Factor) -> _Basis:
    pencil = _pencil(A, factor.modulus)
    reduction = row_reduce(pencil)
    return _Basis(*_chains(pencil, reduction, factor.multiplicity), reduction)


def _dual(basis: _Basis, other: _Basis) -> list[list[Vector]]:
    """Rows D with D V = I, as many for each chain: D = (Wᵀ V)⁻¹ Wᵀ for chains V and chains W of the transpose."""
    V, W = ([v for chain in each.chains for v in chain] for each in (basis, other))
    one = _one((V[0],))
    zero = one - one
    augmented = tuple(
        (*(_times((w,), v)[0] for v in V), *(one if i == j else zero for j in range(len(W)))) for i, w in enumerate(W)
    )
    inverted = [row[len(V) :] for row in row_reduce(augmented).reduced]
    columns = list(zip(*W, strict=True))
    rows = iter([tuple(_times((row,), column)[0] for column in columns) for row in inverted])
    return [list(islice(rows, len(chain))) for chain in basis.chains]


def _at_roots(factor: Factor, basis: _Basis, dual: list[list[Vector]]) -> list[Eigenspace]:
    def columns(chains: list[list[Vector]], root: Root) -> tuple[Chain, ...]:
        return tuple(
            tuple(sp.ImmutableMatrix([[element_at(c, root)] for c in vector]) for vector in chain) for chain in chains
        )

    return [
        Eigenspace(
            root=root,
            chains=columns(basis.chains, root),
            nullities=basis.nullities,
            over_L=basis.reduction if factor.degree < 3 else None,
            dual=columns(dual, root),
        )
        for root in factor.roots
    ]


def _pencil(A: sp.ImmutableMatrix, p: Modulus) -> Rows:
    """The matrix xI − A over L."""
    M, K = domain_matrix(A, real=False), p.domain
    d = p.degree
    x = [-p.low[0]] if d == 1 else [K.zero, K.one, *[K.zero] * (d - 2)]

    def entry(i: int, j: int, a: Any) -> Algebraic:
        constant = [-K.convert(a, M.domain), *[K.zero] * (d - 1)]
        return Algebraic([c + y for c, y in zip(constant, x, strict=True)] if i == j else constant, p)

    return tuple(tuple(entry(i, j, a) for j, a in enumerate(row)) for i, row in enumerate(M.to_list()))


def _chains(pencil: Rows, reduction: RowReduction, multiplicity: int) -> tuple[list[list[Vector]], tuple[int, ...]]:
    """Chains of N = A − xI = −pencil, the longest first, and the nullities of the powers of N."""
    one = _one(pencil)
    kernels = [null_space(reduction, one)]
    if len(kernels[0]) == multiplicity:
        return [[cleared(v)] for v in kernels[0]], (multiplicity,)
    N = tuple(tuple(-a for a in row) for row in pencil)
    power = N
    while len(kernels[-1]) < multiplicity:
        power = _product(power, N)
        kernels.append(null_space(row_reduce(power), one))
    return _build(N, kernels), tuple(len(kernel) for kernel in kernels)


def _build(N: Rows, kernels: list[list[Vector]]) -> list[list[Vector]]:
    """From the largest power down, start a chain at each vector that the longer chains do not reach."""
    chains: list[list[Vector]] = []  # from the top vector down to the eigenvector
    for level in range(len(kernels), 0, -1):
        below = kernels[level - 2] if level > 1 else []
        reached = [chain[len(chain) - level] for chain in chains if len(chain) >= level]
        for candidate in kernels[level - 1]:
            if _independent([*below, *reached, candidate]):
                top = cleared(candidate)
                chain = [top]
                for _ in range(level - 1):
                    chain.append(_times(N, chain[-1]))
                chains.append(chain)
                reached.append(top)
    return [without_common_factor(list(reversed(chain))) for chain in chains]


def _independent(vectors: Sequence[Vector]) -> bool:
    return len(row_reduce(tuple(vectors)).pivots) == len(vectors)


def _times(N: Rows, v: Vector) -> Vector:
    return tuple(reduce(lambda a, b: a + b, (n * c for n, c in zip(row, v, strict=True))) for row in N)


def _product(left: Rows, right: Rows) -> Rows:
    columns = list(zip(*right, strict=True))
    return tuple(tuple(_times((row,), column)[0] for column in columns) for row in left)


def _one(rows: Rows) -> Algebraic:
    p = rows[0][0].modulus
    return Algebraic([p.domain.one, *[p.domain.zero] * (p.degree - 1)], p)
