"""f(A) for any function that is analytic at the eigenvalues: f(A) = Σ_λ Σ_j Z_j f^{(j−1)}(λ)/(j−1)!.

The Z_j are the residues of the resolvent. Polynomials and rational functions need no eigenvalue: they are reduced
modulo the characteristic polynomial, so that irreducible factors of any degree stay exact.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from math import factorial

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.functions.closed_forms import exponential, interpolation_coefficients, power
from solver.exact.functions.fractions import highest_power, residue_at
from solver.exact.functions.interpolation import Condition, interpolation
from solver.exact.functions.remainders import LOW, reduced
from solver.exact.functions.residues import FactorResidues, interpolation_residues, residues_at, resolvent_residues
from solver.exact.functions.scalar_functions import ScalarFunction, at_root, multiplied_out
from solver.exact.linear_algebra.fields import NotExact, collected
from solver.exact.linear_algebra.radicals import complex_parts
from solver.exact.linear_algebra.spectrum import Factor, irreducible_factors, is_lower, spectrum
from solver.matrices import entries

MOST_DIGITS_SHOWN = 9
"""Digits of a power of an eigenvalue that stands in a condition for the coefficients."""


@dataclass(frozen=True)
class FunctionOfMatrix:
    """f(A) = Σ αᵢ Aⁱ (i < n), with the conditions at the eigenvalues that fix the αᵢ.

    There are no conditions where the αᵢ are those of the remainder modulo χ, since the eigenvalues are no help.
    """

    value: sp.ImmutableMatrix
    coefficients: tuple[sp.Expr, ...]
    conditions: tuple[Condition, ...]


@lru_cache(maxsize=64)
def matrix_function(A: sp.ImmutableMatrix, f: ScalarFunction) -> FunctionOfMatrix:
    """f(A) (n×n); raises NotExact where f is not defined on the spectrum of A."""
    if not asks_for_roots(A, f):
        return FunctionOfMatrix(*reduced(A, f), ())
    conditions = tuple(conditions_for(A, f))
    if (k := f.power_exponent) is not None:
        alpha = interpolation_coefficients(A, k, discrete=True)
        return FunctionOfMatrix(power(A, k).matrix, alpha, conditions)
    if f.rational is not None:
        return FunctionOfMatrix(*reduced(A, f), conditions)
    t = sp.Symbol("t")
    is_exponential = f.expression == sp.exp(f.variable * t)
    value = exponential(A, t).matrix if is_exponential else _summed(resolvent_residues(A), f, A.shape)
    residues = interpolation_residues(A) if _multiplicities_hold(A, f) else _minimal_interpolation(A)
    size = sum(each.factor.degree * each.factor.multiplicity for each in residues)
    alpha = tuple(_summed(residues, f, (size, 1)).flat())
    return FunctionOfMatrix(value, alpha, conditions)


def _minimal_interpolation(A: sp.ImmutableMatrix) -> tuple[FactorResidues, ...]:
    """The residues of the images of αᵢ for the minimal polynomial, which asks for no more derivatives than needed."""
    x = sp.Dummy("x")
    factors = [Factor(each.factor.modulus, highest_power(each), each.factor.roots) for each in resolvent_residues(A)]
    K = factors[0].modulus.domain
    minimal = sp.Poly(1, x, domain=K)
    for factor in factors:
        minimal *= sp.Poly([K.one, *reversed(factor.modulus.low)], x, domain=K) ** factor.multiplicity
    coefficients = minimal.rep.to_list()
    m = len(coefficients) - 1
    numerator = [
        DomainMatrix([[coefficients[m - 1 - i - p] if p <= m - 1 - i else K.zero] for i in range(m)], (m, 1), K)
        for p in range(m)
    ]
    return tuple(residues_at(numerator, coefficients[::-1], factor) for factor in factors)


def asks_for_roots(A: sp.ImmutableMatrix, f: ScalarFunction) -> bool:
    """Whether f(A) needs the eigenvalues of A, or f, of a low power at least, has short values at them."""
    if f.rational is None:
        return True
    x = f.variable
    degree = max(sp.degree(part, x) for part in f.rational)
    linear = all(p.degree() == 1 for p, _ in irreducible_factors(A))
    if degree > LOW:
        return linear and all(_short_power(root.value, degree) for root in spectrum(A).roots)
    if linear:
        return True
    return not A.free_symbols and all(root.kind != "decimal" for root in spectrum(A).roots)


def _short_power(value: sp.Expr, degree: int) -> bool:
    """Whether a power of an eigenvalue is a number that a page can show: of 0, 1 and −1 all are."""
    return isinstance(value, sp.Rational) and max(abs(value.p), value.q) ** degree < 10**MOST_DIGITS_SHOWN


def _multiplicities_hold(A: sp.ImmutableMatrix, f: ScalarFunction) -> bool:
    """Whether f has as many derivatives as the multiplicities ask for; if not, the chains may still ask for fewer."""
    try:
        for root in spectrum(A).roots:
            for order in range(root.multiplicity):
                f.at(root.value, order)
    except NotExact:
        return False
    return True


def conditions_for(A: sp.ImmutableMatrix, f: ScalarFunction) -> Iterator[Condition]:
    """f^{(i)}(λ) = dⁱ/dλⁱ Σ αⱼ λʲ, i less than the multiplicity; those that do not exist are left out."""
    found = spectrum(A)
    if f.power_exponent is not None:
        yield from interpolation(found, f.power_exponent, discrete=True)
        return
    orders = {each.factor: highest_power(each) for each in resolvent_residues(A)}
    n = A.rows if _multiplicities_hold(A, f) else sum(each.degree * order for each, order in orders.items())
    for factor in found.factors:
        for root in factor.roots:
            paired = root.kind in ("complex", "decimal") and root.shift != 0
            if paired and is_lower(root):
                continue
            for i in range(root.multiplicity):
                row = [sp.expand(sp.ff(p, i) * root.value ** (p - i)) if p >= i else sp.Integer(0) for p in range(n)]
                try:
                    real, imaginary = at_root(f, root, i)
                except NotExact:
                    if i < orders[factor]:
                        raise
                    break  # the eigenvectors are complete, so this derivative is not needed
                if imaginary is None:
                    yield Condition(tuple(row), real)
                else:
                    parts = [complex_parts(c) for c in row]
                    yield Condition(tuple(each for each, _ in parts), real)
                    yield Condition(tuple(each for _, each in parts), imaginary)


def _summed(residues: Iterable[FactorResidues], f: ScalarFunction, shape: tuple[int, int]) -> sp.ImmutableMatrix:
    """Σ Z_j f^{(j−1)}(λ)/(j−1)! over all roots; a conjugate pair gives 2(X u − Y v)."""
    terms: list[list[sp.Expr]] = [[] for _ in range(shape[0] * shape[1])]
    for each in residues:
        for j in range(1, highest_power(each) + 1):
            for root in each.factor.roots:
                paired = root.kind in ("complex", "decimal") and root.shift != 0
                if paired and is_lower(root):
                    continue
                Z = residue_at(each.residues[j - 1], root, shape)
                real, imaginary = at_root(f, root, j - 1)
                if imaginary is None:
                    _add(terms, Z, real / factorial(j - 1))
                else:
                    parts = [complex_parts(entry) for entry in Z.flat()]
                    X, Y = (sp.ImmutableMatrix(*shape, list(each)) for each in zip(*parts, strict=True))
                    _add(terms, X, 2 * real / factorial(j - 1))
                    _add(terms, Y, -2 * imaginary / factorial(j - 1))
    return sp.ImmutableMatrix(*shape, [_tidied(sp.Add(*each)) for each in terms])


def _add(terms: list[list[sp.Expr]], Z: sp.ImmutableMatrix, value: sp.Expr) -> None:
    """Add Z times a number, or a function of t, to the terms of each entry, multiplied out."""
    parts = sp.Add.make_args(multiplied_out(value))
    for place, entry in zip(terms, entries(Z), strict=True):
        if entry.is_Rational:
            place.extend(entry * part for part in parts if entry)
        else:
            place.extend(sp.Add.make_args(multiplied_out(entry * value)))


def _tidied(entry: sp.Expr) -> sp.Expr:
    """Nested roots of numbers taken apart where they can be; parameters factored."""
    if entry.free_symbols - {sp.Symbol("t")}:
        return collected(entry) if entry.is_rational_function(*entry.free_symbols) else entry
    nested = any(each.base.has(sp.Pow) for each in entry.atoms(sp.Pow) if each.exp == sp.S.Half)
    found: sp.Expr = multiplied_out(sp.sqrtdenest(entry)) if nested else entry
    return found
