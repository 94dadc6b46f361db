"""Minors of transfer matrices, Rosenbrock's matrix, zeros and their directions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from itertools import combinations
from itertools import product as product_of_sets
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.lazy import numeric
from solver.numeric.judges import multivariable as judges
from solver.numeric.judges import representation
from solver.numeric.judges.stability.regions import is_admissible
from solver.stated.algebra import difference, product
from solver.stated.matrices import determinant, rank

ORACLE = "orthogonal bases (50 digits)"
MOST = 16
"""Of matrices of more entries the minors are not computed."""


def of_rational_minors(found: Any, G: Any) -> Iterator[Claim | Check]:
    """Each minor is its determinant; both polynomials and the rank are those of a realization."""
    for minor in (each for listed in found.orders for each in listed):
        M = sp.ImmutableMatrix(G.matrix.extract(list(minor.rows), list(minor.columns)))
        yield Claim(determinant(M), minor.value)
    plant = _realized(G)
    yield Check.that("the normal rank", ORACLE, judges.normal_rank(plant) == found.rank)
    judged: list[tuple[Any, Any]] = [
        (found.pole_polynomial, judges.pole_polynomial_residual),
        (found.zero_polynomial, judges.zero_polynomial_residual),
    ]
    for p, residual in judged:
        yield numeric.check_residual(
            "a polynomial of poles or zeros", ORACLE, partial(residual, plant, p.as_expr(), G.variable)
        )
    for factor, power, minor in found.pole_powers:
        below = sp.Poly(minor.bottom.as_expr(), G.variable)
        exactly = sp.Poly(factor, G.variable) ** power
        yield Check.that("a power in a denominator", "sympy.rem", below.rem(exactly).is_zero)


def of_rational_determinant(found: Any, G: Any) -> Iterator[Claim]:
    """The determinant."""
    yield Claim(determinant(G.matrix), found)


def of_in_factors(found: Any, p: Any) -> Iterator[Claim]:
    """The polynomial itself."""
    yield Claim(p.as_expr(), found)


def of_parameter_exceptions(found: Sequence[Any], minors: Any) -> Iterator[Check]:
    """At a point of each condition G has other poles, other zeros or another rank than in general."""
    G, x = minors.G, minors.variable
    plant, zeros = _realized(G), minors.zero_polynomial.as_expr()
    for condition in found:
        values = _point_of(condition.lhs - condition.rhs, set(minors.pole_polynomial.as_expr().free_symbols), plant, x)
        if values is None:
            continue
        there, expected = tuple(M.xreplace(values) for M in plant), zeros.xreplace(values)
        changed = (
            expected.has(sp.zoo, sp.nan)
            or representation.order_of_minimal_part(there) != minors.pole_polynomial.degree()
            or judges.normal_rank(there) != minors.rank
            or not judges.zero_polynomial_residual(there, expected, x) < ORDINARY
        )
        yield Check.that("a case of its own", ORACLE, changed)


ORDINARY = 1e-9


def _point_of(factor: Any, known: set[Any], plant: Any, x: Any) -> dict[Any, Any] | None:
    """Values of all parameters at which a factor that is linear in one of them is zero."""
    symbols = sorted(set().union(known, *(M.free_symbols for M in plant)) - {x}, key=str)
    others = {b: sp.Rational(13 + 7 * i, 5 + 3 * i) for i, b in enumerate(symbols)}
    for a in sorted(factor.free_symbols, key=str):
        if sp.degree(factor, a) == 1:
            rest = {b: value for b, value in others.items() if b != a}
            slope, constant = (c.xreplace(rest) for c in sp.Poly(factor, a).all_coeffs())
            if slope != 0:
                return {**rest, a: -constant / slope}
    return None


def of_changed_where(found: Sequence[Any], form: Any) -> Iterator[Check]:
    """Where a coefficient that was divided by is zero, and what the minors share is another, one of them is zero."""
    x, rows = form.variable, [[sp.S.Zero + entry.as_expr() for entry in row] for row in form.rows]
    M, K = sp.ImmutableMatrix(rows), form.rows[0][0].domain
    general = [sp.S.Zero + e for e in form.invariant_factors[: form.rank]]
    leads = sp.Mul(*(sp.numer(sp.together(K.to_sympy(lead))) for lead in form.leads))
    for factor, _ in sp.factor_list(leads)[1] if M.rows * M.cols <= MOST else ():
        values = _point_of(factor, set(), (M,), x) if factor.free_symbols else None
        if values is None or not is_admissible(values):
            continue
        if _shared_by_minors(M.xreplace(values), form.rank, x) != _products([e.xreplace(values) for e in general]):
            told = any(each.xreplace(values) == 0 for each in found)
            yield Check.that("where Smith's form is another", "sympy.gcd", told)


def _shared_by_minors(M: Any, rank: int, x: Any) -> list[Any]:
    """The greatest common divisors of the minors of each order, monic."""
    shared = []
    for k in range(1, rank + 1):
        chosen = product_of_sets(combinations(range(M.rows), k), combinations(range(M.cols), k))
        minors = [sp.expand(M.extract(list(i), list(j)).det(method="berkowitz")) for i, j in chosen]
        divisor = sp.gcd_list(minors)
        shared.append(sp.expand(divisor / sp.LC(divisor, x)) if divisor != 0 else divisor)
    return shared


def _products(factors: Sequence[Any]) -> list[Any]:
    """The products of the first k factors; nothing where one has no value."""
    if any(each.has(sp.zoo, sp.nan) for each in factors):
        return []
    return [sp.expand(sp.Mul(*factors[:k])) for k in range(1, len(factors) + 1)]


def of_zero_directions(found: Any, G: Any, *_: Any) -> Iterator[Check]:
    """G(z) u = 0 at each zero, for as many independent columns as it counts."""
    if not found:
        return
    columns = sp.ImmutableMatrix(sp.Matrix.hstack(*(u for each in found for u in each.columns)))
    values = [each.root.value for each in found for _ in each.columns]
    yield numeric.check_residual(
        "directions of zeros", ORACLE, lambda: judges.directions_residual(_realized(G), columns, values)
    )


def of_system_matrix(found: Any, A: Any, B: Any, C: Any, D: Any, x: Any) -> Iterator[Claim | Check]:
    """P as it is put together, its rank, and what all minors of that order share."""
    n = A.rows
    if n:
        upper = sp.Matrix.hstack(x * sp.eye(n) - A, -B)
        yield Claim(sp.ImmutableMatrix(sp.Matrix.vstack(upper, sp.Matrix.hstack(C, D))), found.matrix)
    yield Claim(rank(found.matrix), sp.Integer(found.rank))
    p = found.zero_polynomial.as_expr()
    yield numeric.check_residual(
        "what the minors share", ORACLE, lambda: judges.zero_polynomial_residual((A, B, C, D), p, x, "invariant")
    )
    if found.square:
        yield Claim(determinant(found.matrix), found.determinant.as_expr())
    elif found.deciding:
        shared = sp.gcd_list([minor.value.as_expr() for minor in found.deciding], x)
        yield Check.that(
            "these minors share no more", "sympy.gcd", sp.degree(shared, x) == found.zero_polynomial.degree()
        )


def of_common_decoupling_polynomial(
    found: Any, A: Any, input_hidden: Any, output_hidden: Any, poles: Any, x: Any
) -> Iterator[Claim]:
    """It makes up det(xI − A) with the poles and what is hidden from one side only."""
    pencil = difference(product(x, sp.ImmutableMatrix(sp.eye(A.rows))), A)
    yield Claim(product(found, determinant(pencil)), product(input_hidden, output_hidden, poles))


def _realized(G: Any) -> Any:
    """G as matrices A, B, C, D; not minimal."""
    return representation.realized(G.numerators, G.denominators, G.variable)


def of_rational_zeros_of_entries(found: Iterable[Any], G: Any) -> Iterator[Claim]:
    """The entries vanish there."""
    for i, j, z in found:
        yield Claim(G.matrix[i, j].xreplace({G.variable: z}), sp.Integer(0))
