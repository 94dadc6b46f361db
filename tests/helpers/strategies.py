"""Random systems with a chosen Jordan structure, for hypothesis."""

from dataclasses import dataclass

import sympy as sp
from hypothesis import strategies as st

from solver.systems import StateSpace

eigenvalues = st.sampled_from([sp.Rational(p, q) for p in range(-4, 3) for q in (1, 2)])


def real_block(sigma: sp.Rational, omega: sp.Rational, size: int) -> sp.Matrix:
    """The real Jordan block of the pair σ ± jω, of multiplicity `size`."""
    block = sp.zeros(2 * size)
    for i in range(size):
        block[2 * i : 2 * i + 2, 2 * i : 2 * i + 2] = sp.Matrix([[sigma, omega], [-omega, sigma]])
        if i:
            block[2 * i - 2 : 2 * i, 2 * i : 2 * i + 2] = sp.eye(2)
    return block


def jordan_block(value: sp.Rational, size: int) -> sp.Matrix:
    """The upper Jordan block of a real eigenvalue."""
    return sp.Matrix(size, size, lambda i, j: value if i == j else int(j == i + 1))


@st.composite
def unimodular(draw: st.DrawFn, n: int) -> sp.Matrix:
    """An integer matrix of determinant 1, as a product of a lower and an upper triangular one."""
    entries = st.integers(-1, 1)
    lower = sp.Matrix(n, n, lambda i, j: 1 if i == j else (draw(entries) if i > j else 0))
    upper = sp.Matrix(n, n, lambda i, j: 1 if i == j else (draw(entries) if i < j else 0))
    return lower * upper


@st.composite
def systems(draw: st.DrawFn, largest: int = 6, *, defective: bool = True) -> sp.ImmutableMatrix:
    """A rational matrix n×n, 1 ≤ n ≤ `largest`, made from Jordan blocks (real ones for conjugate pairs)."""
    n = draw(st.integers(1, largest))
    blocks: list[sp.Matrix] = []
    left = n
    while left:
        size = draw(st.integers(1, min(left, 3))) if defective else 1
        if left >= 2 * size and draw(st.booleans()):
            omega = draw(st.sampled_from([sp.Integer(1), sp.Integer(2), sp.Rational(1, 2)]))
            blocks.append(real_block(draw(eigenvalues), omega, size))
        else:
            blocks.append(jordan_block(draw(eigenvalues), size))
        left -= blocks[-1].rows
    T = draw(unimodular(n))
    return sp.ImmutableMatrix(T * sp.diag(*blocks) * T.inv())


@dataclass(frozen=True)
class Block:
    """One Jordan block of what was made: the eigenvalue σ + jω (with its conjugate), its size, and who is in touch."""

    sigma: sp.Rational
    omega: sp.Rational
    size: int
    reached: bool = True
    seen: bool = True

    @property
    def order(self) -> int:
        """How many states it takes."""
        return self.size * (2 if self.omega else 1)

    @property
    def matrix(self) -> sp.Matrix:
        """The block itself, real."""
        return real_block(self.sigma, self.omega, self.size) if self.omega else jordan_block(self.sigma, self.size)

    def decays(self, discrete: bool) -> bool:
        """Whether its motion dies out."""
        return bool(self.sigma**2 + self.omega**2 < 1) if discrete else bool(self.sigma < 0)


@dataclass(frozen=True)
class Made:
    """A system and the blocks it was made of: what is true of it without any computation."""

    system: StateSpace
    blocks: tuple[Block, ...]


STABLE = [sp.Rational(-p, q) for p in range(1, 5) for q in (1, 2)]
INSIDE = [sp.Rational(p, 6) for p in range(-5, 6)]


@st.composite
def blocks_of(draw: st.DrawFn, n: int, *, discrete: bool, stable: bool, hidden: bool) -> tuple[Block, ...]:
    """Jordan blocks of n states together; some not reached by an input or not seen in an output, if `hidden`."""
    sigmas = st.sampled_from(INSIDE if discrete and stable else STABLE) if stable else eigenvalues
    omegas = st.sampled_from([sp.Rational(p, 2) for p in (1, 2, 4)])
    made: list[Block] = []
    left = n
    while left:
        size = draw(st.sampled_from([s for s in (1, 1, 1, 2, 3) if s <= left]))
        omega = draw(omegas) if left >= 2 * size and draw(st.booleans()) else sp.S.Zero
        if discrete and stable:
            omega = min(omega, sp.Rational(1, 2))
        reached, seen = (draw(st.integers(0, 4)) > 0, draw(st.integers(0, 4)) > 0) if hidden else (True, True)
        made.append(Block(draw(sigmas), omega, size, reached, seen))
        left -= made[-1].order
    return tuple(made)


@st.composite
def plants(
    draw: st.DrawFn,
    largest: int = 6,
    *,
    smallest: int = 1,
    discrete: bool | None = False,
    stable: bool = False,
    hidden: bool = True,
    inputs: int = 3,
    outputs: int = 3,
    through: bool = True,
) -> Made:
    """A system of Jordan blocks in integer coordinates, with up to so many inputs and outputs, D only if `through`."""
    if discrete is None:
        discrete = draw(st.booleans())
    n, m, p = draw(st.integers(smallest, largest)), draw(st.integers(1, inputs)), draw(st.integers(1, outputs))
    blocks = draw(blocks_of(n, discrete=discrete, stable=stable, hidden=hidden))
    reached = [block.reached for block in blocks for _ in range(block.order)]
    seen = [block.seen for block in blocks for _ in range(block.order)]
    entries = st.integers(-2, 2)
    B = sp.Matrix(n, m, lambda i, _: draw(entries) if reached[i] else 0)
    C = sp.Matrix(p, n, lambda _, j: draw(entries) if seen[j] else 0)
    D = sp.Matrix(p, m, lambda *_: draw(entries)) if through and draw(st.booleans()) else sp.zeros(p, m)
    T = draw(unimodular(n))
    inverse = T.inv()
    A = T * sp.diag(*(block.matrix for block in blocks)) * inverse
    exact = [sp.ImmutableMatrix(M) for M in (A, T * B, C * inverse, D)]
    return Made(StateSpace(*exact, discrete=discrete), blocks)


@st.composite
def plain_plants(
    draw: st.DrawFn, largest: int = 4, *, smallest: int = 1, discrete: bool = False, inputs: int = 2, outputs: int = 2
) -> StateSpace:
    """A system of small integers, with whatever eigenvalues that gives: mostly irrational, complex, of any degree."""
    n, m, p = draw(st.integers(smallest, largest)), draw(st.integers(1, inputs)), draw(st.integers(1, outputs))
    entries = st.integers(-3, 3)
    shapes = [(n, n), (n, m), (p, n), (p, m)]
    exact = [sp.ImmutableMatrix(rows, columns, lambda *_: draw(entries)) for rows, columns in shapes]
    return StateSpace(*exact, discrete=discrete)


DECAYING = [sp.Rational(-p, 2) for p in range(1, 11)]
WELL_INSIDE = [sp.Rational(p, 6) for p in range(-4, 5)]


@st.composite
def poles_of(draw: st.DrawFn, count: int, discrete: bool = False) -> tuple[sp.Expr, ...]:
    """So many poles where motions decay, complex ones in pairs, any of them several times."""
    found = []
    while len(found) < count:
        sigma = draw(st.sampled_from(WELL_INSIDE if discrete else DECAYING))
        if count - len(found) >= 2 and draw(st.booleans()):
            omega = draw(st.sampled_from([sp.Rational(1, 2), sp.Rational(1, 3)] if discrete else [1, 2, 3]))
            found += [sigma + sp.I * omega, sigma - sp.I * omega]
        else:
            found.append(sigma)
    return tuple(map(sp.sympify, found))
