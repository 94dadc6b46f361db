"""Decoupling by state feedback: relative degrees, the decoupling matrix, the law, and the motion that it hides.

Output i is differentiated until inputs act on it: y_i^(r) = c_i Aʳ x + e_i u with e_i = c_i A^{r−1} B. With the rows
e_i in B*, u = −K x + F v decouples if and only if B* has an inverse (Falb and Wolovich, IEEE Trans. Automatic Control
12, 1967): F = B*⁻¹ and the rows of B* K are c_i αᵢ(A), where αᵢ is the polynomial wanted of channel i.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.constants import common_factors_below
from solver.exact.linear_algebra.fields import domain_matrix, matrix_of
from solver.exact.linear_algebra.matrices import determinant, inverse, multiply
from solver.exact.structure.rank_conditions import rank_conditions
from solver.exact.structure.ranks import null_basis

Coefficients = Sequence[sp.Expr]
"""Those of a monic polynomial, the highest power first."""


@dataclass(frozen=True)
class Channel:
    """One output: `rows` are c, cA, …, cAʳ (1×n each), `reached` c B, …, cA^{r−1}B (1×m each), the last one not zero.

    `degree` is r, zero where the row of D is not (then `entry` is that row and nothing is reached); None where no
    input acts on the output, and then the rows end with cA^{n−1} and all that is reached is zero.
    """

    degree: int | None
    rows: tuple[sp.ImmutableMatrix, ...]
    reached: tuple[sp.ImmutableMatrix, ...]
    entry: sp.ImmutableMatrix

    @property
    def last(self) -> sp.ImmutableMatrix:
        """The row cAʳ."""
        return self.rows[-1]


@dataclass(frozen=True)
class Interaction:
    """The channels of a plant, and B* with the rows of the inputs that act on them (p×m)."""

    channels: tuple[Channel, ...]

    @property
    def degrees(self) -> tuple[int | None, ...]:
        """The relative degrees."""
        return tuple(channel.degree for channel in self.channels)

    @property
    def acts(self) -> bool:
        """Whether inputs act on every output."""
        return None not in self.degrees

    @cached_property
    def matrix(self) -> sp.ImmutableMatrix:
        """The decoupling matrix B*, with rows of zeros for outputs that no input acts on."""
        return sp.ImmutableMatrix(sp.Matrix.vstack(*(sp.Matrix(channel.entry) for channel in self.channels)))

    @cached_property
    def determinant(self) -> sp.Expr:
        """Det B*."""
        return tidy(determinant(self.matrix))

    @cached_property
    def derivatives(self) -> sp.ImmutableMatrix:
        """The rows c Aᵏ with k < r of all channels: y, y', …, y^(r−1) as functions of x (Σr×n)."""
        rows = [sp.Matrix(row) for channel in self.channels for row in channel.rows[: channel.degree or 0]]
        return sp.ImmutableMatrix(sp.Matrix.vstack(*rows) if rows else sp.zeros(0, self.channels[0].last.cols))


@lru_cache(maxsize=64)
def interaction(
    A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, C: sp.ImmutableMatrix, D: sp.ImmutableMatrix
) -> Interaction:
    """Differentiate each output of A n×n, B n×m, C p×n, D p×m until an input acts on it; raises NotExact."""
    n, m = A.rows, B.cols
    whole = domain_matrix(sp.Matrix(sp.BlockMatrix([[A, B], [C, D]]).as_explicit()))
    rows, K = whole.to_list(), whole.domain
    a = DomainMatrix([row[:n] for row in rows[:n]], (n, n), K)
    b = DomainMatrix([row[n:] for row in rows[:n]], (n, m), K)
    return Interaction(tuple(_channel(a, b, row) for row in rows[n:]))


def _channel(a: DomainMatrix, b: DomainMatrix, row: list[object]) -> Channel:
    """The channel of an output, whose row of C and D is given."""
    n = a.shape[0]
    c, d = (DomainMatrix([part], (1, len(part)), a.domain) for part in (row[:n], row[n:]))
    if any(d.to_list_flat()):
        return Channel(0, (_row(c),), (), _row(d))
    rows, reached = [c], [c * b]
    while not any(reached[-1].to_list_flat()) and len(reached) < n:
        rows.append(rows[-1] * a)
        reached.append(rows[-1] * b)
    acts = any(reached[-1].to_list_flat())
    if acts:
        rows.append(rows[-1] * a)
    return Channel(len(reached) if acts else None, _shown(rows), _shown(reached), _row(reached[-1]))


def _shown(rows: list[DomainMatrix]) -> tuple[sp.ImmutableMatrix, ...]:
    return tuple(map(_row, rows))


def _row(row: DomainMatrix) -> sp.ImmutableMatrix:
    return sp.ImmutableMatrix(matrix_of(row).applyfunc(tidy))


@dataclass(frozen=True)
class DecouplingLaw:
    """u = −K x + F v (K, F m×n, m×m), and the rows c αᵢ(A) of B* K (m×n)."""

    K: sp.ImmutableMatrix
    F: sp.ImmutableMatrix
    rows: sp.ImmutableMatrix


def decoupling_law(found: Interaction, polynomials: Sequence[Coefficients]) -> DecouplingLaw:
    """The law that gives channel i the polynomial αᵢ, of its relative degree; B* has an inverse."""
    rows = [_combined(channel, wanted) for channel, wanted in zip(found.channels, polynomials, strict=True)]
    M = sp.ImmutableMatrix(sp.Matrix.vstack(*rows))
    F = sp.ImmutableMatrix(inverse(found.matrix).applyfunc(_written))
    return DecouplingLaw(sp.ImmutableMatrix(multiply(F, M).applyfunc(_written)), F, M)


def _combined(channel: Channel, wanted: Coefficients) -> sp.Matrix:
    """The row c α(A) from c, cA, …, cAʳ."""
    rows = zip(reversed(channel.rows), wanted, strict=True)
    total = sp.zeros(1, channel.last.cols)
    for row, coefficient in rows:
        total += coefficient * sp.Matrix(row)
    return total.applyfunc(tidy)


def _written(value: sp.Expr) -> sp.Expr:
    return common_factors_below(tidy(value))


@dataclass(frozen=True)
class HiddenMotion:
    """Columns N (n×k) of the states whose motion the outputs do not show under the law, and H: (A − BK) N = N H."""

    N: sp.ImmutableMatrix
    H: sp.ImmutableMatrix


def hidden_motion(found: Interaction, loop: sp.ImmutableMatrix) -> HiddenMotion | None:
    """What the outputs do not show of the decoupled loop A − BK (n×n); None where they show everything."""
    Q, n = found.derivatives, loop.rows
    N = null_basis(Q) if Q.rows else sp.ImmutableMatrix(sp.eye(n))
    k = N.cols
    if not k:
        return None
    own = [next(i for i in range(n) if N[i, j] != 0 and sum(e != 0 for e in N.row(i)) == 1) for j in range(k)]
    moved = multiply(loop, N)
    H = sp.ImmutableMatrix(k, k, lambda i, j: tidy(sp.cancel(moved[own[i], j] / N[own[i], i])))
    return HiddenMotion(N, H)


def interaction_conditions(found: Interaction) -> tuple[sp.Basic, ...]:
    """Conditions on parameters under which relative degrees are others, or B* has no inverse; raises NotExact.

    Where det B* is zero for all parameters it stays so as long as no row of B* vanishes.
    """
    if found.determinant != 0:
        return rank_conditions(found.matrix)
    acting = [sp.Matrix(channel.entry) for channel in found.channels if channel.degree is not None]
    return rank_conditions(sp.ImmutableMatrix(sp.diag(*acting))) if acting else ()


def dynamically_decouplable(
    A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, C: sp.ImmutableMatrix, D: sp.ImmutableMatrix
) -> bool:
    """Whether det G is not zero for all s, so that a compensator with states of its own decouples (m outputs).

    det [sI − A, −B; C, D] has at most the degree n in s: it is zero if it is at n + 1 points. Raises NotExact.
    """
    n, m = A.rows, B.cols
    whole = domain_matrix(sp.Matrix(sp.BlockMatrix([[-A, -B], [C, D]]).as_explicit()))
    K = whole.domain
    for s in range(1, n + 2):
        shift = [[K(s) if i == j and i < n else K.zero for j in range(n + m)] for i in range(n + m)]
        if (whole + DomainMatrix(shift, whole.shape, K)).rank() == n + m:
            return True
    return False
