"""Matrices of polynomials over the field K of their coefficients: rows of `Poly`, minors and the gcds of minors."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import domain_matrix, expression
from solver.exact.linear_algebra.integers import small_integer_roots
from solver.exact.representation.polynomials import expanded, factored_form, in_lowest_terms

Rows = tuple[tuple[sp.Poly, ...], ...]


@lru_cache(maxsize=64)
def polynomial_rows(M: sp.ImmutableMatrix, x: sp.Symbol) -> Rows:
    """The matrix (p×m, entries polynomials in x) over the smallest field of its coefficients; raises NotExact."""
    listed = [sp.Poly(entry, x).all_coeffs() for entry in M.flat()]
    flat = domain_matrix(sp.Matrix([[c for coefficients in listed for c in coefficients]]))
    supply = iter(flat.to_list_flat())
    found = [sp.Poly([next(supply) for _ in coefficients], x, domain=flat.domain) for coefficients in listed]
    return tuple(tuple(found[i : i + M.cols]) for i in range(0, len(found), M.cols))


def matrix_of_rows(rows: Sequence[Sequence[sp.Poly]]) -> sp.ImmutableMatrix:
    """The matrix of expressions, each entry by falling powers."""
    return sp.ImmutableMatrix([[by_powers(p) for p in row] for row in rows])


def by_powers(p: sp.Poly) -> sp.Expr:
    """The polynomial by falling powers; parameters below bars over their common denominator."""
    return in_lowest_terms(p, p.one, ()) if p.domain.is_Composite else expanded(p)


def minors(rows: Rows, k: int) -> Iterator[sp.Poly]:
    """The k×k minors, rows before columns."""
    for of_rows in combinations(range(len(rows)), k):
        for of_columns in combinations(range(len(rows[0])), k):
            yield _determinant(rows, of_rows, of_columns)


def _determinant(rows: Rows, of_rows: tuple[int, ...], of_columns: tuple[int, ...]) -> sp.Poly:
    """The minor of these rows and columns, by Laplace along its first row."""
    first, *rest = of_rows
    if not rest:
        return rows[first][of_columns[0]]
    found = rows[0][0].zero
    for at, j in enumerate(of_columns):
        if not rows[first][j].is_zero:
            others = of_columns[:at] + of_columns[at + 1 :]
            term = rows[first][j] * _determinant(rows, tuple(rest), others)
            found = found - term if at % 2 else found + term
    return found


def determinantal_divisors(M: sp.ImmutableMatrix, x: sp.Symbol) -> tuple[sp.Poly, ...]:
    """d₁, d₂, …, d_r of a polynomial matrix of rank r: d_k is the monic gcd of its k×k minors; raises NotExact."""
    return divisors_of(polynomial_rows(M, x))


def divisors_of(rows: Rows) -> tuple[sp.Poly, ...]:
    """The monic gcds of the minors of each order up to the rank."""
    found: list[sp.Poly] = []
    for k in range(1, min(len(rows), len(rows[0])) + 1):
        d = rows[0][0].zero
        for minor in minors(rows, k):
            d = common_divisor(d, minor)
            if not d.is_zero and d.degree() == 0:
                break
        if d.is_zero:
            break
        found.append(d.monic())
    return tuple(found)


def in_parameters(K: Any) -> bool:
    """Whether K is a field of quotients of polynomials with rational coefficients."""
    return bool(K.is_FractionField and (K.domain.is_QQ or K.domain.is_ZZ))


def common_divisor(p: sp.Poly, q: sp.Poly) -> sp.Poly:
    """The greatest common divisor up to a factor from K; with parameters that of polynomials in these too."""
    K = p.domain
    if p.is_zero or q.is_zero or not in_parameters(K):
        return p.gcd(q)
    names = [sp.Dummy() for _ in K.symbols]
    whole = [_without_denominators(each, names) for each in (p, q)]
    found = whole[0].gcd(whole[1])
    back = dict(zip(names, K.field.gens, strict=True))
    terms: dict[int, Any] = {}
    for (power, *powers), c in found.terms():
        value = K.convert(c, found.domain)
        for name, exponent in zip(names, powers, strict=True):
            value = value * back[name] ** exponent
        terms[power] = terms.get(power, K.zero) + value
    return sp.Poly.from_dict({(power,): value for power, value in terms.items()}, p.gen, domain=K)


def _without_denominators(p: sp.Poly, names: list[sp.Dummy]) -> sp.Poly:
    """The polynomial in its variable and the parameters, times the common denominator of its coefficients."""
    K = p.domain
    R = K.get_ring()
    below = K.one
    for c in p.rep.to_list():
        below = K.convert(R.lcm(R.convert(below, K), K.denom(c)), R)
    terms = {}
    for (power,), c in zip(p.monoms(), (c for c in p.rep.to_list() if c), strict=True):
        for powers, number in dict(R.convert(c * below, K)).items():
            terms[(power, *powers)] = sp.QQ.convert(number, R.domain)
    return sp.Poly.from_dict(terms, p.gen, *names, domain=sp.QQ)


@dataclass(frozen=True, slots=True)
class MinorOf:
    """A minor of a polynomial matrix: its rows and columns (counted from 1), what it is taken of, its factors."""

    rows: tuple[int, ...]
    columns: tuple[int, ...]
    matrix: sp.ImmutableMatrix
    value: sp.Expr


def minors_in_factors(M: sp.ImmutableMatrix, x: sp.Symbol, k: int) -> tuple[MinorOf, ...]:
    """The k×k minors of a polynomial matrix, rows before columns; raises NotExact."""
    rows = polynomial_rows(M, x)
    return tuple(
        MinorOf(
            tuple(i + 1 for i in of_rows),
            tuple(j + 1 for j in of_columns),
            sp.ImmutableMatrix(M.extract(list(of_rows), list(of_columns))),
            in_factors(_determinant(rows, of_rows, of_columns)),
        )
        for of_rows in combinations(range(M.rows), k)
        for of_columns in combinations(range(M.cols), k)
    )


def in_factors(p: sp.Poly) -> sp.Expr:
    """The polynomial as its leading coefficient times monic irreducible factors."""
    if p.is_zero or p.degree() == 0:
        return expanded(p)
    found, K = p.monic(), p.domain
    roots, rest = small_integer_roots(found.rep.to_list()) if K.is_QQ else ([], found.rep.to_list())
    factors = [(sp.Poly([K.one, K(-root)], p.gen, domain=K), roots.count(root)) for root in dict.fromkeys(roots)]
    if len(rest) > 1:
        listed = sp.Poly(rest, p.gen, domain=K).factor_list()[1]
        factors += [(factor.set_domain(K).monic(), multiplicity) for factor, multiplicity in listed]
    if not K.is_Composite:
        return expression(K, p.rep.LC()) * factored_form(factors)
    shown = [(expanded(factor) if factor.degree() == 1 else by_powers(factor), m) for factor, m in factors]
    return expression(K, p.rep.LC()) * sp.Mul(*(sp.Pow(factor, m) for factor, m in shown))


def size_of(p: sp.Poly) -> tuple[Any, ...]:
    """How long a polynomial is to write: by its parameters, then by its figures."""
    K, coefficients = p.domain, p.rep.to_list()
    if K.is_QQ:
        return 0, sum(len(str(c.numerator)) + 2 * len(str(c.denominator)) - 2 for c in coefficients if c)
    if K.is_FractionField:
        terms = [len(K.numer(c)) + 2 * len(K.denom(c)) - 2 for c in coefficients if c]
        plain = all(K.numer(c).is_ground and K.denom(c).is_ground for c in coefficients)
        return int(not plain), sum(terms)
    return 0, sum(len(str(a)) for c in coefficients for a in (c.to_list() if K.is_Algebraic else [c]))
