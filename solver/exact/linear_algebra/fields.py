"""Fields that the entries of a matrix live in, and polynomials over them modulo an irreducible one.

Notation: K is the field of the entries (QQ, QQ(parameters), QQ<√d>, …); p is irreducible and monic over K;
L = K[x]/(p) is the field got by adjoining a root x of p. An element of L is the list of its coefficients over K,
lowest power first. So one exact computation serves all conjugate roots of p at once.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.assembly import linear_combination, powers
from solver.exact.linear_algebra.constants import constant_form, number_multiplied_in
from solver.exact.linear_algebra.generators import dependent_exponentials, generators_in, half_angles
from solver.exact.linear_algebra.integers import are_rational, over_rationals
from solver.exact.linear_algebra.signs import is_not_zero
from solver.matrices import entries
from solver.words import Told

Element = Any
"""An element of a field: of K (a sympy domain element) or of L (an `Algebraic`)."""


class NotExact(Told):
    """The algebra has no exact form for this; the reason says why. Like Unsolved: nothing went wrong."""


def domain_matrix(M: sp.MatrixBase, *, real: bool = True) -> DomainMatrix:
    """Return M over the smallest field K found for its entries; raises NotExact if there is none.

    Entries must be real, where it is not said that they need not. Sines and cosines of an angle θ are written as
    rational functions of tan(θ/2), so that sin² + cos² = 1 holds in K; a root √a is a generator whose square is a.
    """
    if are_rational(flat := entries(M)):
        return over_rationals(flat, M.shape)
    if real and M.has(sp.I):
        raise NotExact("linear_algebra/not_real")
    try:
        written = half_angles(M)
    except ValueError as failure:
        raise NotExact("linear_algebra/not_numbers") from failure
    matrix = DomainMatrix.from_Matrix(written, extension=True).to_field().to_dense()
    if matrix.domain.is_EXRAW or matrix.domain.is_EX or dependent_exponentials(written):
        matrix = _over_surds_and_parameters(written)
    if not matrix.domain.is_Exact:
        raise NotExact("linear_algebra/not_numbers")
    return matrix


def side_by_side(*matrices: sp.MatrixBase, real: bool = True) -> tuple[DomainMatrix, ...]:
    """The matrices over one field, found for the entries of all of them; raises NotExact.

    Fields found one by one may take a and √a for independent of each other.
    """
    found = [domain_matrix(M, real=real) for M in matrices]
    if any(_has_roots(each.domain) for each in found):
        flat = sp.Matrix([[entry for M in matrices for entry in M.flat()]])
        whole = domain_matrix(flat, real=real)
        entries, K, start = whole.to_list_flat(), whole.domain, 0
        for at, M in enumerate(matrices):
            rows = [entries[start + i * M.cols : start + (i + 1) * M.cols] for i in range(M.rows)]
            found[at], start = DomainMatrix(rows, M.shape, K), start + M.rows * M.cols
        return tuple(found)
    return tuple(found[0].unify(*found[1:]))


def _has_roots(K: Any) -> bool:
    """Whether a generator of K is a root of a parameter, or another function of some."""
    return bool(K.is_Composite) and any(not symbol.is_Symbol for symbol in K.symbols)


def _over_surds_and_parameters(M: sp.MatrixBase) -> DomainMatrix:
    """M over QQ<√d, …>(parameters, roots of them, tangents, exponentials), which sympy does not find by itself."""
    try:
        M, generators = generators_in(M)
    except ValueError as failure:
        raise NotExact("linear_algebra/mixed") from failure
    surds = sorted(
        (power for power in M.atoms(sp.Pow) if power.base.is_Rational and power.exp == sp.Rational(1, 2)), key=str
    )
    surds += [sp.I] * M.has(sp.I)
    own = {*generators}
    try:
        numbers = sp.QQ.algebraic_field(*surds) if surds else sp.QQ
        plain: list[Any] = [x for x in sorted(M.free_symbols, key=str) if x not in own]
        K = numbers.frac_field(*plain, *generators)
        named = numbers.frac_field(*plain, *generators.values())
        rows = [[_renamed(K.from_sympy(sp.expand(M[i, j])), named) for j in range(M.cols)] for i in range(M.rows)]
    except (sp.CoercionFailed, ValueError, NotImplementedError) as failure:
        raise NotExact("linear_algebra/mixed") from failure
    return DomainMatrix(rows, M.shape, named)


def _renamed(element: Any, K: Any) -> Any:
    """The same quotient of polynomials in the generators of K."""
    above, below = (K.field.ring.from_dict(dict(part)) for part in (element.numer, element.denom))
    return K.field.raw_new(above, below)


@lru_cache(maxsize=64)
def is_real_field(K: Any) -> bool:
    """Whether K has no imaginary unit in it."""
    try:
        (K.domain if K.is_Composite else K).from_sympy(sp.I)
    except sp.CoercionFailed:
        return True
    return False


def expression(K: Any, element: Element) -> sp.Expr:
    """The element of K as an expression, with sines and cosines in place of half-angle tangents."""
    found: sp.Expr = K.to_sympy(element)
    if not K.is_Composite:
        return found
    return constant_form(found) if sp.E in K.symbols and not found.free_symbols else whole_angles(found)


def in_powers(coefficients: Sequence[Any], K: Any, x: sp.Symbol) -> sp.Expr:
    """The polynomial with these coefficients in K, the highest power first, as an expression in x."""
    of_x = powers(x, len(coefficients))
    terms = [(expression(K, c), power) for c, power in zip(coefficients, of_x, strict=True) if c]
    return linear_combination(terms) if K.is_QQ else sp.Add(*(c * power for c, power in terms))


def whole_angles(found: sp.Expr) -> sp.Expr:
    """The expression with cos θ and sin θ in place of tan(θ/2)."""
    for tangent in found.atoms(sp.tan):
        found = _whole_angle(found, tangent)
    return found


def expressions(matrix: DomainMatrix) -> list[sp.Expr]:
    """The entries of a matrix over K as expressions, row by row."""
    K = matrix.domain
    return [expression(K, c) if c else sp.Integer(0) for c in matrix.to_list_flat()]


def matrix_of(matrix: DomainMatrix) -> sp.ImmutableMatrix:
    """A matrix over K as a matrix of expressions."""
    if matrix.domain.is_QQ:  # which sympy would find out for itself
        return sp.ImmutableMatrix._fromrep(matrix.to_sparse())
    return sp.ImmutableMatrix(*matrix.shape, expressions(matrix))


def _whole_angle(found: sp.Expr, tangent: Any) -> sp.Expr:
    """A rational function of tan(θ/2) in cos θ and sin θ."""
    angle = 2 * tangent.args[0]
    return trigonometric(found.xreplace({tangent: sp.sin(angle) / (1 + sp.cos(angle))}), angle)


def trigonometric(found: sp.Expr, angle: sp.Expr) -> sp.Expr:
    """A rational function of cos θ and sin θ as P(cos θ) + Q(cos θ) sin θ, by sin² = 1 − cos².

    Where Q has the denominator 1 − cos² θ, 1/sin θ stands in place of sin θ/(1 − cos² θ).
    """
    c, s = sp.Dummy("c"), sp.Dummy("s")
    numerator, denominator = sp.fraction(sp.together(found.xreplace({sp.cos(angle): c, sp.sin(angle): s})))
    a, b = _linear_in(denominator, s, c)
    p, q = _linear_in(numerator * (a - b * s), s, c)
    denominator = a**2 - b**2 * (1 - c**2)
    odd = sp.cancel(q / denominator)
    below, rest = sp.div(sp.denom(odd), 1 - c**2, c)
    odd = odd * s if rest != 0 or below == 0 else sp.cancel(sp.numer(odd) / below) / s
    return sp.expand((sp.cancel(p / denominator) + odd).xreplace({c: sp.cos(angle), s: sp.sin(angle)}))


def collected(found: sp.Expr) -> sp.Expr:
    """The expression in the form shown: numbers multiplied out, parameters factored, sines and cosines reduced."""
    if not found.free_symbols:
        return constant_form(found)
    angles = {f.args[0] for f in found.atoms(sp.sin, sp.cos)}
    for angle in angles:
        found = trigonometric(found, angle)
    return found if angles else number_multiplied_in(sp.factor(found))


def _linear_in(polynomial: sp.Expr, s: sp.Symbol, c: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    """The polynomial as a + b s, by s² = 1 − c²."""
    a, b = sp.Integer(0), sp.Integer(0)
    for (power,), coefficient in sp.Poly(polynomial, s).terms():
        reduced = coefficient * (1 - c**2) ** (power // 2)
        a, b = (a, b + reduced) if power % 2 else (a + reduced, b)
    return sp.expand(a), sp.expand(b)


def in_sines(radicand: sp.Expr) -> sp.Expr:
    """The expression with cos² = 1 − sin², which turns cos²θ − 1 into a square."""
    squares = {f**2: 1 - sp.sin(f.args[0]) ** 2 for f in radicand.atoms(sp.cos)}
    return sp.expand(radicand).subs(squares) if squares else radicand


def vanishing_factors(value: sp.Expr) -> list[sp.Expr]:
    """The factors of the numerator that contain parameters and are not known to differ from zero."""
    if not value.free_symbols:
        return []
    factors = sp.factor(sp.numer(sp.together(in_sines(whole_angles(value))))).as_powers_dict()
    return [factor for factor in factors if factor.free_symbols and not is_not_zero(factor)]


@dataclass(frozen=True, slots=True)
class Modulus:
    """The monic irreducible p = x^d + c_{d−1} x^{d−1} + … + c_0 over K; `low` lists c_0 … c_{d−1}."""

    low: tuple[Element, ...]
    domain: Any

    @property
    def degree(self) -> int:
        """The degree d of p."""
        return len(self.low)

    def reduce(self, coefficients: Sequence[Any]) -> list[Any]:
        """Return a polynomial (low first; coefficients in K or matrices over K) modulo p, as d coefficients."""
        rest, d = list(coefficients), self.degree
        for top in range(len(rest) - 1, d - 1, -1):
            lead = rest.pop()
            for i, c in enumerate(self.low):
                if c:
                    rest[top - d + i] = rest[top - d + i] - lead * c
        return rest + [rest[0] * self.domain.zero] * (d - len(rest)) if rest else [self.domain.zero] * d


class Algebraic:
    """An element of L = K[x]/(p), with the arithmetic of a field."""

    __slots__ = ("coefficients", "modulus")

    def __init__(self, coefficients: Iterable[Element], modulus: Modulus) -> None:
        self.coefficients = tuple(coefficients)
        self.modulus = modulus

    def __bool__(self) -> bool:
        return any(self.coefficients)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Algebraic) and self.coefficients == other.coefficients

    def __hash__(self) -> int:
        return hash(self.coefficients)

    def __neg__(self) -> Algebraic:
        return Algebraic((-c for c in self.coefficients), self.modulus)

    def __add__(self, other: Algebraic) -> Algebraic:
        return Algebraic((a + b for a, b in zip(self.coefficients, other.coefficients, strict=True)), self.modulus)

    def __sub__(self, other: Algebraic) -> Algebraic:
        return Algebraic((a - b for a, b in zip(self.coefficients, other.coefficients, strict=True)), self.modulus)

    def __mul__(self, other: Algebraic | int) -> Algebraic:
        a, p = self.coefficients, self.modulus
        if isinstance(other, int):
            return self if other == 1 else Algebraic((c * other for c in a), p)
        b = other.coefficients
        if len(a) == 1:
            return Algebraic((a[0] * b[0],), p)
        long = [p.domain.zero] * (2 * len(a) - 1)
        for i, left in enumerate(a):
            if left:
                for j, right in enumerate(b):
                    long[i + j] += left * right
        return Algebraic(p.reduce(long), p)

    def __truediv__(self, other: Algebraic) -> Algebraic:
        return self * other.inverse()

    def __pow__(self, exponent: int) -> Algebraic:
        result = self
        for _ in range(exponent - 1):
            result = result * self
        return result

    def inverse(self) -> Algebraic:
        """1/a, by solving a·b = 1 for the coefficients of b; raises ZeroDivisionError for a = 0."""
        if not self:
            raise ZeroDivisionError("inverse of zero")
        d, K = self.modulus.degree, self.modulus.domain
        if d == 1:
            return Algebraic((K.one / self.coefficients[0],), self.modulus)
        if d == 2:  # 1/(a + bx) = (a − b c₁ − b x)/N, with the norm N = a² − a b c₁ + b² c₀
            (a, b), (c0, c1) = self.coefficients, self.modulus.low
            norm = a * a - a * b * c1 + b * b * c0
            return Algebraic(((a - b * c1) / norm, -b / norm), self.modulus)
        basis = [Algebraic([K.one if i == j else K.zero for i in range(d)], self.modulus) for j in range(d)]
        columns = [(self * e).coefficients for e in basis]
        system = DomainMatrix([[columns[j][i] for j in range(d)] for i in range(d)], (d, d), K)
        unit = DomainMatrix([[K.one if i == 0 else K.zero] for i in range(d)], (d, 1), K)
        solution = system.lu_solve(unit).to_list_flat()
        return Algebraic(solution, self.modulus)
