"""The pair (A, B), or (A, C) as the dual pair (Aᵀ, Cᵀ): one derivation serves controllability and observability."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.arithmetic.products import is_worked_out, rows_times_columns
from solver.derivation import Claim
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.stated import Stated


@dataclass(frozen=True)
class Pair:
    """A n×n with B n×m (dual: with C p×n), as the plant has them. `discrete` tells the kind of time."""

    A: ImmutableMatrix
    other: ImmutableMatrix
    dual: bool
    discrete: bool = False

    @property
    def n(self) -> int:
        """The number of states."""
        return int(self.A.rows)

    @property
    def width(self) -> int:
        """The number of inputs (outputs)."""
        return int(self.other.rows if self.dual else self.other.cols)

    @property
    def F(self) -> ImmutableMatrix:
        """A, or Aᵀ for the dual pair."""
        return self.turned(self.A)

    @property
    def G(self) -> ImmutableMatrix:
        """B, or Cᵀ for the dual pair."""
        return self.turned(self.other)

    def turned(self, M: Any) -> Any:
        """M as it stands in a question of controllability, or its transpose for the dual; it turns back, too."""
        return sp.ImmutableMatrix(M.T) if self.dual else M

    @property
    def matrix(self) -> ImmutableMatrix:
        """[B, AB, …, Aⁿ⁻¹B] (n×nm), dual: [C; CA; …; CAⁿ⁻¹] (np×n)."""
        found: ImmutableMatrix = self.turned(exact.controllability_matrix(self.F, self.G))
        return found

    @property
    def blocks(self) -> list[ImmutableMatrix]:
        """B, AB, … (dual: C, CA, …), one after another."""
        whole = self.turned(self.matrix)
        return [self.turned(sp.ImmutableMatrix(whole[:, i : i + self.width])) for i in range(0, whole.cols, self.width)]

    @property
    def block_claims(self) -> dict[str, Claim]:
        """Each block is A times the one before it (dual: the one before it times A); none for one state."""
        blocks = self.blocks
        products = (product(block, self.A) if self.dual else product(self.A, block) for block in blocks)
        named = enumerate(zip(products, blocks[1:], self.names[1:], strict=False), 1)
        return {f"block{i}": Claim(stated, block, f"${name}$") for i, (stated, block, name) in named}

    @property
    def block_entries(self) -> list[Stated | str]:
        """The entries of these products as rows times columns; "" where they need no more than a look."""
        factors = [(block, self.A) if self.dual else (self.A, block) for block in self.blocks[:-1]]
        return [rows_times_columns(*each) if is_worked_out(*each) else "" for each in factors]

    @property
    def names(self) -> list[str]:
        """The blocks by their names in LaTeX."""
        powers = ["", *("A" if i == 1 else f"A^{{{i}}}" for i in range(1, self.n))]
        return [f"C{power}" if self.dual else f"{power}B" for power in powers]

    @property
    def parameters(self) -> frozenset[Any]:
        """The parameters in A and B (A and C)."""
        return frozenset(self.A.free_symbols | self.other.free_symbols)


def controllability_pair(plant: Any) -> Pair:
    """(A, B) of the plant, which has a B."""
    return Pair(plant.A, plant.B, dual=False, discrete=plant.discrete)


def observability_pair(plant: Any) -> Pair:
    """(A, C) of the plant, which has a C, as the dual pair."""
    return Pair(plant.A, plant.C, dual=True, discrete=plant.discrete)
