"""Pole placement for one input, exact: the linear equations for the gain, canonical coordinates, the controllable part.

Everything is about a pair (A, b), A n×n and b n×1, and k (1×n) in u = −k x. With χ(s) = sⁿ + a₁sⁿ⁻¹ + … + aₙ and
adj(sI − A) = Σ Nⱼ sⁿ⁻¹⁻ʲ, det(sI − A + bk) = χ(s) + k adj(sI − A) b, so the coefficient of sⁿ⁻¹⁻ʲ is aⱼ₊₁ + k Nⱼ b.
Coefficients of the desired polynomial may be any expressions (decimals, logarithms, symbols): the gain is affine in
them, and only A and b need exact arithmetic.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import reduce
from itertools import pairwise, product

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.faddeev import faddeev_leverrier
from solver.exact.fields import collected, domain_matrix, expression
from solver.exact.matrices import inverse, multiply, powers
from solver.exact.pole_placement import controllability_matrix
from solver.exact.row_reduction import row_reduce
from solver.exact.spectrum import spectrum

Coefficients = tuple[sp.Expr, ...]


def tidy(value: sp.Expr) -> sp.Expr:
    """Return an expression multiplied out, or factored where it holds symbols (and no decimals)."""
    return sp.expand(value) if value.has(sp.Float) else collected(value)


def monic(roots: Iterable[sp.Expr]) -> Coefficients:
    """Return 1, c₁, …, cₙ of Π(x − root), highest power first; conjugate roots give real coefficients."""
    coefficients: list[sp.Expr] = [sp.Integer(1)]
    for root in roots:
        shifted = [*coefficients, sp.Integer(0)]
        coefficients = [shifted[0]] + [sp.expand(c - root * previous) for previous, c in pairwise(shifted)]
    return tuple(_real_part_of_decimals(c) for c in coefficients)


def _real_part_of_decimals(value: sp.Expr) -> sp.Expr:
    """Drop the imaginary rounding that conjugate decimals leave behind."""
    return sp.re(value) if value.has(sp.Float) and not value.free_symbols else value


def polynomial_in(x: sp.Symbol, coefficients: Sequence[sp.Expr]) -> sp.Expr:
    """Σ cᵢ xⁿ⁻ⁱ."""
    n = len(coefficients) - 1
    return sp.Add(*(c * x ** (n - i) for i, c in enumerate(coefficients)))


def polynomial_of_matrix(A: sp.ImmutableMatrix, coefficients: Sequence[sp.Expr]) -> sp.ImmutableMatrix:
    """Σ cᵢ Aⁿ⁻ⁱ (A square of any size)."""
    degree = len(coefficients) - 1
    total = sp.zeros(A.rows)
    for c, power in zip(coefficients, reversed(powers(A, degree + 1)), strict=True):
        total += c * power
    return sp.ImmutableMatrix(total.applyfunc(tidy))


def divided(coefficients: Sequence[sp.Expr], divisor: Sequence[sp.Expr]) -> Coefficients:
    """Return the quotient of a polynomial by a monic one that divides it (coefficients, highest power first)."""
    rest, quotient = list(coefficients), []
    while len(rest) >= len(divisor):
        lead = rest.pop(0)
        quotient.append(lead)
        for i, c in enumerate(divisor[1:]):
            rest[i] = tidy(rest[i] - lead * c)
    return tuple(quotient)


def gain_equations(A: sp.ImmutableMatrix, b: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """Return the n×n matrix with the rows (Nⱼ b)ᵀ: the coefficient of sⁿ⁻¹⁻ʲ in det(sI − A + bk) is aⱼ₊₁ + row·kᵀ."""
    rows = [multiply(N, b).T for N in faddeev_leverrier(A).adjugate_coefficients]
    return sp.ImmutableMatrix(sp.Matrix.vstack(*map(sp.Matrix, rows)))


def toeplitz(coefficients: Sequence[sp.Expr]) -> sp.ImmutableMatrix:
    """Return W (n×n), upper triangular with 1, a₁, …, aₙ₋₁ in its first row: the matrix of Bass and Gura."""
    n = len(coefficients) - 1
    return sp.ImmutableMatrix(n, n, lambda i, j: coefficients[j - i] if j >= i else 0)


def companion_rows(A: sp.ImmutableMatrix, b: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """Return P (n×n) with the rows q, qA, …, qAⁿ⁻¹, q the last row of [b, Ab, …, Aⁿ⁻¹b]⁻¹.

    ξ = P x brings the pair to controllable canonical form (coefficients in the last row). Raises ZeroDivisionError.
    """
    q = inverse(controllability_matrix(A, b)).row(A.rows - 1)
    rows = [sp.ImmutableMatrix(q)]
    for _ in range(A.rows - 1):
        rows.append(multiply(rows[-1], A))
    return sp.ImmutableMatrix(sp.Matrix.vstack(*map(sp.Matrix, rows)))


def combine(row: Sequence[sp.Expr], M: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """Return row · M (1×columns) for a row of any expressions, each entry tidied."""
    product_ = sp.Matrix([list(row)]) * M
    return sp.ImmutableMatrix(product_.applyfunc(tidy))


@dataclass(frozen=True)
class Solution:
    """All solutions of M v = r: `values` in terms of the free unknowns, `free` their positions, `residue` ≠ 0 if none.

    `conditions` are the independent equations that are left, each as an expression that is zero.
    """

    values: tuple[sp.Expr, ...]
    free: tuple[int, ...]
    residue: tuple[sp.Expr, ...]
    conditions: tuple[sp.Expr, ...]


def solve_affine(M: sp.ImmutableMatrix, right: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> Solution:
    """Solve M v = r (M p×q over a field, r of any expressions) for the unknowns v by row reduction of [M, I]."""
    width = M.cols
    matrix = domain_matrix(sp.Matrix.hstack(M, sp.eye(M.rows)))
    K = matrix.domain
    reduction = row_reduce(tuple(tuple(row) for row in matrix.to_list()))
    values: list[sp.Expr] = list(unknowns)
    residue: list[sp.Expr] = []
    conditions: list[sp.Expr] = []
    for row in reduction.reduced:
        entries = [expression(K, c) if c else sp.Integer(0) for c in row]
        value = tidy(sp.Add(*(c * r for c, r in zip(entries[width:], right, strict=True))))
        pivot = next((j for j in range(width) if entries[j] != 0), None)
        if pivot is None:
            residue.append(value)
            continue
        others = [entries[j] * unknowns[j] for j in range(pivot + 1, width)]
        conditions.append(tidy(sp.Add(unknowns[pivot], *others, -value)))
        values[pivot] = tidy(sp.Add(value, *(-each for each in others)))
    pivots = {j for j in reduction.pivots if j < width}
    left = tuple(r for r in residue if not _vanishes(r))
    return Solution(tuple(values), tuple(j for j in range(width) if j not in pivots), left, tuple(conditions))


def _vanishes(value: sp.Expr) -> bool:
    if not value.has(sp.Float):
        return bool(value == 0)
    return not value.free_symbols and abs(value) < sp.Float("1e-18")


def affine(expressions: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> tuple[sp.ImmutableMatrix, list[sp.Expr]]:
    """Return M and c with expressions = M · unknowns + c; the expressions are affine in the unknowns."""
    M = sp.ImmutableMatrix(len(expressions), len(unknowns), lambda i, j: tidy(sp.diff(expressions[i], unknowns[j])))
    nothing = dict.fromkeys(unknowns, sp.Integer(0))
    return M, [tidy(each.subs(nothing)) for each in expressions]


def loop_coefficients(
    A: sp.ImmutableMatrix, b: sp.ImmutableMatrix, row: sp.ImmutableMatrix, unknowns: Sequence[sp.Symbol]
) -> Coefficients:
    """Return the coefficients of det(xI − A + b k), the row k affine in the unknowns."""
    moved = gain_equations(A, b) * row.T
    chi = faddeev_leverrier(A).coefficients
    return (
        sp.Integer(1),
        *(_collected(a + m, unknowns) for a, m in zip(chi[1:], moved.flat(), strict=True)),
    )


def _collected(value: sp.Expr, unknowns: Sequence[sp.Symbol]) -> sp.Expr:
    """Return c₀ + Σ cᵢ kᵢ with tidied coefficients."""
    M, (constant,) = affine([sp.expand(value)], unknowns)
    return sp.Add(constant, *(c * k for c, k in zip(M.flat(), unknowns, strict=True)))


def fixed_factor(
    A: sp.ImmutableMatrix, b: sp.ImmutableMatrix, row: sp.ImmutableMatrix, unknowns: Sequence[sp.Symbol]
) -> Coefficients:
    """Return the coefficients of the monic factor of det(xI − A + b k) that no values of the unknowns in k move.

    The determinant is p₀ + Σ θᵢ pᵢ with the unknowns θ; the factor is the greatest common divisor of p₀, p₁, ….
    """
    M, constant = affine(loop_coefficients(A, b, row, unknowns), unknowns)
    matrix = domain_matrix(sp.Matrix([constant, *M.T.tolist()]))
    x = sp.Dummy("x")
    polynomials = [sp.Poly.from_list(line, x, domain=matrix.domain) for line in matrix.to_list()]
    common = reduce(sp.gcd, polynomials).monic()
    return tuple(expression(common.domain, c) for c in common.rep.to_list())


def roots_of(coefficients: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Return the roots of a monic polynomial with multiplicity, as `spectrum` finds them."""
    n = len(coefficients) - 1
    if n == 0:
        return []
    companion = sp.ImmutableMatrix(
        n, n, lambda i, j: -coefficients[n - j] if i == n - 1 else sp.Integer(int(j == i + 1))
    )
    return [root.value for root in spectrum(companion).roots for _ in range(root.multiplicity)]


@dataclass(frozen=True)
class ControllablePart:
    """Coordinates x = T ξ in which A is [[A_c, *], [0, A_u]] and B is [[B_c], [0]]; `order` r is the size of A_c.

    The first r columns of T are columns of the controllability matrix, the others the unit vectors of the coordinates
    `free`; so the entries of K = [K_c, κ] T⁻¹ at these places are those of κ.
    """

    T: sp.ImmutableMatrix
    inverse: sp.ImmutableMatrix
    A: sp.ImmutableMatrix
    B: sp.ImmutableMatrix
    order: int
    free: tuple[int, ...]

    @property
    def A_c(self) -> sp.ImmutableMatrix:
        """The controllable block (r×r)."""
        return self.A[: self.order, : self.order]

    @property
    def B_c(self) -> sp.ImmutableMatrix:
        """The input of the controllable block (r×m)."""
        return self.B[: self.order, :]

    @property
    def A_u(self) -> sp.ImmutableMatrix:
        """The block that the input does not reach (n−r × n−r)."""
        return self.A[self.order :, self.order :]


def controllable_part(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix) -> ControllablePart:
    """Decompose (A, B), for general parameters; r may be 0 or n."""
    n = A.rows
    matrix = domain_matrix(controllability_matrix(A, B))
    columns = _pivots(matrix)
    basis = controllability_matrix(A, B)[:, list(columns)]
    rows = _pivots(domain_matrix(basis).transpose()) if columns else ()
    free = tuple(i for i in range(n) if i not in rows)
    units = sp.eye(n)[:, list(free)]
    T = sp.ImmutableMatrix(sp.Matrix.hstack(sp.Matrix(basis), units))
    back = inverse(T)
    return ControllablePart(T, back, multiply(multiply(back, A), T), multiply(back, B), len(columns), free)


def _pivots(matrix: DomainMatrix) -> tuple[int, ...]:
    return tuple(matrix.rref()[1])


def lifted_gain(
    part: ControllablePart, k_c: sp.ImmutableMatrix, unknowns: Sequence[sp.Symbol]
) -> tuple[sp.ImmutableMatrix, tuple[sp.Symbol, ...]]:
    """Return k = [k_c, κ] T⁻¹ (1×n) with the unknowns of the coordinates `free` for κ, and these unknowns."""
    free = tuple(unknowns[j] for j in part.free)
    return combine([*k_c.flat(), *free], part.inverse), free


def reachable_order(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix) -> int:
    """Return the rank of the controllability matrix (for general parameters)."""
    return int(domain_matrix(controllability_matrix(A, B)).rank())


@dataclass(frozen=True)
class Direction:
    """One input in place of several, u = −K₀ x + g v: (A − B K₀, B g) reaches all that (A, B) does.

    `preliminary` is K₀ (m×n), None where none is needed; g is m×1.
    """

    g: sp.ImmutableMatrix
    preliminary: sp.ImmutableMatrix | None


def direction(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix) -> Direction | None:
    """Find the simplest g, and if A has several eigenvectors for one movable eigenvalue a K₀; None if none was found.

    Almost every K₀ and g do (Heymann 1968); simple ones are tried first.
    """
    order = reachable_order(A, B)
    for K0 in _preliminary_gains(B.cols, A.rows):
        loop = A if K0 is None else sp.ImmutableMatrix(A - B * K0)
        for g in _directions(B.cols):
            if reachable_order(loop, sp.ImmutableMatrix(B * g)) == order:
                return Direction(g, K0)
    return None


def _directions(m: int) -> list[sp.ImmutableMatrix]:
    """Single inputs first, then sums of inputs, then combinations in general position."""
    units = [sp.ImmutableMatrix(m, 1, lambda i, _j, c=c: int(i == c)) for c in range(m)]
    sums = [sp.ImmutableMatrix(m, 1, list(signs)) for signs in product((1, -1), repeat=m) if m > 1 and signs[0] == 1]
    general = [sp.ImmutableMatrix(m, 1, lambda i, _j, t=t: t**i) for t in (2, 3, -3, 5, 7)]
    return (units + sums[:8] + general) if m > 1 else units


def _preliminary_gains(m: int, n: int) -> Iterable[sp.ImmutableMatrix | None]:
    """None, gains of one entry, chains from state to input, and small numbers in general position."""
    yield None
    for i, j in product(range(m), range(n)):
        yield sp.ImmutableMatrix(m, n, lambda a, b, i=i, j=j: int((a, b) == (i, j)))
    for shift in range(1, n):
        yield sp.ImmutableMatrix(m, n, lambda a, b, shift=shift: -int(a == (b + shift) % n))
    for seed in range(1, 6):
        yield sp.ImmutableMatrix(m, n, lambda a, b, seed=seed: (seed * (3 * a + 1) * (b + 2) ** 2 + a * b) % 7 - 3)
