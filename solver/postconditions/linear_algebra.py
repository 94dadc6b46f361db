"""Spectra and linear equations."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.lazy import numeric
from solver.stated import Stated
from solver.stated.algebra import difference, power, product, total
from solver.stated.calculus import value_at
from solver.stated.matrices import determinant, rank


def of_spectrum(found: Any, A: Any) -> Iterator[Claim]:
    """det(xI − A) = Π (x − λᵢ)^mᵢ; each root is σ + δ or σ + jω, and those of a factor make it up."""
    x = sp.Symbol("lamda")
    yield Claim(determinant(pencil(A, x)), factors(found.roots, x))
    yield Claim(determinant(pencil(A, x)), product(*(x - value for value in found.eigenvalues)))
    for root in found.roots:
        yield root_claim(root)
    for factor in found.factors:
        yield from factor_claims(factor)


def of_characteristic_factors(found: Any, A: Any) -> Iterator[Claim]:
    """det(xI − A) = Π p^m; the roots of a factor make it up, if it has some, as one of degree one or two must."""
    x = sp.Symbol("lamda")
    whole = product(*(power(factor.polynomial(x), factor.multiplicity) for factor in found))
    yield Claim(determinant(pencil(A, x)), whole)
    for factor in found:
        if factor.roots or factor.degree < 3:
            yield from factor_claims(factor)


def root_claim(root: Any) -> Claim:
    """σ + δ, or σ + jω."""
    shift = root.shift * sp.I if root.value.has(sp.I) else root.shift
    return Claim(total(root.sigma, shift), root.value)


def of_multiply(found: Any, A: Any, B: Any) -> Iterator[Claim]:
    """The product."""
    yield Claim(product(A, B), found)


def of_determinant(found: Any, A: Any) -> Iterator[Claim]:
    """The determinant."""
    yield Claim(determinant(A), found)


def of_inverse(found: Any, A: Any) -> Iterator[Claim]:
    """A X = I."""
    yield Claim(product(A, found), sp.ImmutableMatrix(sp.eye(A.rows)), "the inverse")


def pencil(A: Any, x: Any) -> Stated:
    """The matrix xI − A as stated."""
    return difference(product(x, sp.ImmutableMatrix(sp.eye(A.rows))), A)


def factors(roots: Iterable[Any], x: Any) -> Stated:
    """Π (x − λᵢ)^mᵢ as stated."""
    return product(*(power(x - root.value, root.multiplicity) for root in roots))


def of_solve_affine(found: Any, M: Any, right: Sequence[Any], unknowns: Sequence[Any]) -> Iterator[Claim | Check]:
    """M v = r for the values, whatever the free unknowns are; as many are free as the rank leaves."""
    free = [unknowns[j] for j in found.free if 0 <= j < len(unknowns)]
    values = sp.ImmutableMatrix(found.values)
    if not found.residue:
        yield Claim(product(M, values), sp.ImmutableMatrix(list(right)))
    yield Claim(rank(M), sp.Integer(M.cols - len(found.free)))
    own = all(found.values[unknowns.index(x)] == x for x in free)
    yield Check.that("the free unknowns", "counted", own and len(free) == len(found.free))


def of_taylor(found: Sequence[Any], function: Any, t: Any, terms: int) -> Iterator[Claim]:
    """The derivatives at zero, over factorials; terms that are zero may be left out."""
    slopes = [function]
    for _ in range(terms - 1):
        slopes.append(sp.diff(slopes[-1], t))
    at_zero = [value_at(slope, t, sp.Integer(0)) for slope in slopes]
    yield Claim(total(*(product(at, t**i / sp.factorial(i)) for i, at in enumerate(at_zero))), total(*found))


def factor_claims(factor: Any) -> Iterator[Claim]:
    """An irreducible factor is the product of its roots' own."""
    x = sp.Symbol("lamda")
    yield Claim(factor.polynomial(x), product(*(x - root.value for root in factor.roots)))
    for root in factor.roots:
        yield root_claim(root)
        yield Claim(sp.Integer(root.multiplicity), sp.Integer(factor.multiplicity))


def of_is_singular(found: bool, M: Any) -> Iterator[Check]:
    """The rank tells."""
    yield Check.that("singular, or not", "numpy.linalg.svd", (numeric.rank(M) < M.rows) == bool(found))


def of_tidy(found: Any, value: Any) -> Iterator[Claim]:
    """The same value."""
    if found != value:
        yield Claim(value, found)


def of_affine(found: Any, expressions: Sequence[Any], unknowns: Sequence[Any]) -> Iterator[Claim]:
    """M v + c is what was taken apart."""
    M, constant = found
    taken = total(product(M, sp.ImmutableMatrix(list(unknowns))), sp.ImmutableMatrix(list(constant)))
    yield Claim(taken, sp.ImmutableMatrix(list(expressions)))


def of_without_bars(found: Any, value: Any) -> Iterator[Claim]:
    """The same value, where the conditions hold."""
    if found != value:
        yield Claim(value, found)


def of_complex_parts(found: Any, value: Any) -> Iterator[Claim]:
    """Re λ + j Im λ."""
    real, imaginary = found
    yield Claim(total(real, product(sp.I, imaginary)), value)
