"""For which values of its parameters a matrix has a lower rank than in general.

The rank falls below r where all r×r minors vanish together. Before minors are formed, rows and columns with a
constant pivot are eliminated, which leaves the ideal of the minors as it is and the matrix small. With one parameter
the greatest common divisor of the minors comes from Euclid's algorithm on rows and columns, without minors.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache, reduce
from itertools import combinations, islice
from math import comb
from typing import Any

import sympy as sp
from sympy.polys.groebnertools import groebner
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.fields import NotExact, domain_matrix, expression, in_sines
from solver.exact.linear_algebra.spectrum import Root, roots_of

MOST_MINORS = 3000
"""A matrix with more minors than this is given up."""

PolyRows = list[list[Any]]


@lru_cache(maxsize=64)
def rank_conditions(M: sp.ImmutableMatrix) -> tuple[sp.Basic, ...]:
    """Conditions on the real parameters of M under any of which its rank is lower than the generic one.

    Each is Eq(f, 0), or Eq(x, c) for a parameter x and a number c, or And of several such equations. Raises NotExact
    where there are too many minors.
    """
    D = domain_matrix(M)
    rows = _polynomials(D)
    if not rows:
        return ()
    generic = int(D.rank())
    r, rows = _without_constants(rows, generic)
    found = _at_half_turns(M, generic)
    if r == 0:
        return tuple(found)
    R = rows[0][0].ring
    if R.ngens == 1:
        divisor, rest = _diagonal_product(rows), []
    else:
        minors = [minor for minor in _minors(rows, r) if minor]
        divisor = reduce(lambda f, g: f.gcd(g), minors)
        rest = [minor.exquo(divisor) for minor in minors]
    found += [_vanishes(f, D.domain) for f, _ in divisor.factor_list()[1] if _can_vanish(f, D.domain)]
    if rest and not any(minor.is_ground for minor in rest):
        found += [sp.And(*(_vanishes(f, D.domain) for f in case)) for case in _cases(rest, D.domain)]
    undefined = _undefined(D)
    return tuple(condition for condition in dict.fromkeys(found) if not condition.atoms(sp.Eq) & undefined)


def _undefined(D: DomainMatrix) -> set[sp.Basic]:
    """The equations under which a denominator of M is zero, so that there is no M to speak of."""
    K: Any = D.domain
    R = K.field.ring.clone(domain=K.field.ring.domain.get_field())
    denominators = {a.denom.set_ring(R) for row in D.to_list() for a in row}
    return {_vanishes(f, K) for below in denominators for f, _ in below.factor_list()[1]}


def _at_half_turns(M: sp.ImmutableMatrix, generic: int) -> list[sp.Basic]:
    """The conditions cos θ = −1, where tan(θ/2) has no value and the polynomials in it say nothing."""
    angles = sorted({f.args[0] for f in M.atoms(sp.sin, sp.cos)}, key=sp.default_sort_key)
    turned = [(angle, M.xreplace({sp.cos(angle): sp.Integer(-1), sp.sin(angle): sp.Integer(0)})) for angle in angles]
    return [sp.Eq(sp.cos(angle) + 1, 0) for angle, N in turned if domain_matrix(N).rank() < generic]


def _polynomials(D: DomainMatrix) -> PolyRows:
    """The rows with denominators cleared, over the ring of polynomials in the parameters; none without parameters."""
    K: Any = D.domain
    if not K.is_FractionField:
        return []
    R = K.field.ring.clone(domain=K.field.ring.domain.get_field())
    found = []
    for row in D.to_list():
        pairs = [(a.numer.set_ring(R), a.denom.set_ring(R)) for a in row]
        denominator = reduce(lambda f, g: f.lcm(g), (below for _, below in pairs), R.one)
        found.append([above * denominator.exquo(below) for above, below in pairs])
    return found


def _without_constants(rows: PolyRows, r: int) -> tuple[int, PolyRows]:
    """Eliminate with constant pivots: the (r − 1)-minors of what is left have the ideal that the r-minors had."""
    while True:
        place = next(((i, j) for i, row in enumerate(rows) for j, a in enumerate(row) if a and a.is_ground), None)
        if place is None or r == 0:
            return r, _distinct(rows)
        i, j = place
        top = rows[i]
        K = top[j].ring.domain
        unit = K.one / top[j].LC
        rows = [
            [a - row[j] * b * unit for c, (a, b) in enumerate(zip(row, top, strict=True)) if c != j]
            for k, row in enumerate(rows)
            if k != i
        ]
        r -= 1


def _distinct(rows: PolyRows) -> PolyRows:
    """Without zero rows and columns, and equal ones once."""
    rows = [list(row) for row in dict.fromkeys(map(tuple, rows)) if any(row)]
    columns = [column for column in dict.fromkeys(zip(*rows, strict=True)) if any(column)]
    return [list(row) for row in zip(*columns, strict=True)]


def _diagonal_product(rows: PolyRows) -> Any:
    """Product of the diagonal that Euclid's algorithm on rows and columns leaves: the gcd of the largest minors."""
    R = rows[0][0].ring
    product = R.one
    while rows and any(any(row) for row in rows):
        rows, pivot = _cleared_corner(rows)
        product = product * pivot
    return product.monic()


def _cleared_corner(rows: PolyRows) -> tuple[PolyRows, Any]:
    """Bring an entry of least degree to a row and column otherwise zero; what is left, and the entry."""
    while True:
        entries = ((a.degree(), i, j) for i, row in enumerate(rows) for j, a in enumerate(row) if a)
        _, i, j = min(entries)
        top, pivot = rows[i], rows[i][j]
        for k, row in enumerate(rows):
            if k != i and row[j]:
                quotient = row[j].div(pivot)[0]
                rows[k] = [a - quotient * b for a, b in zip(row, top, strict=True)]
        if any(row[j] for k, row in enumerate(rows) if k != i):
            continue
        rest = [a.rem(pivot) for a in top]  # column operations; below and above the pivot there are zeros
        rest[j] = pivot
        rows[i] = rest
        if not any(a for c, a in enumerate(rest) if c != j):
            return [[a for c, a in enumerate(row) if c != j] for k, row in enumerate(rows) if k != i], pivot


def _minors(rows: PolyRows, r: int) -> Iterator[Any]:
    """All r×r minors; raises NotExact if they are too many."""
    height, width = len(rows), len(rows[0])
    if comb(height, r) * comb(width, r) > MOST_MINORS:
        raise NotExact("There are too many minors to say for which values of the parameters the rank drops.")
    R = rows[0][0].ring
    for chosen in combinations(range(height), r):
        for columns in combinations(range(width), r):
            square = [[rows[i][j] for j in columns] for i in chosen]
            last = DomainMatrix(square, (r, r), R.to_domain()).charpoly()[-1]
            yield -last if r % 2 else last


def _shown(f: Any, K: Any) -> sp.Expr:
    """The polynomial, times a factor that is never zero, as an expression in the parameters, sines and cosines."""
    shown = sp.factor(in_sines(expression(K, K.from_sympy(f.as_expr()))))
    above: sp.Expr = sp.fraction(shown)[0].primitive()[1]
    return -above if above.free_symbols and sp.Poly(above).LC().is_negative else above


def _vanishes(f: Any, K: Any) -> sp.Eq:
    """The equation that says so: solved for the parameter where it is linear with one parameter only."""
    shown = _shown(f, K)
    if len(shown.free_symbols) == 1 and shown.is_polynomial():
        (x,) = shown.free_symbols
        p = sp.Poly(shown, x)
        if p.degree() == 1:
            return sp.Eq(x, -p.nth(0) / p.nth(1), evaluate=False)
    return sp.Eq(shown, 0, evaluate=False)


def _can_vanish(f: Any, K: Any) -> bool:
    """Whether a polynomial can be zero for real parameters that are as assumed; if in doubt, yes."""
    shown = _shown(f, K)
    if not shown.free_symbols or shown.is_nonzero:
        return False
    if len(shown.free_symbols) == 1 and shown.is_polynomial() and f.ring.domain.is_QQ:
        (x,) = shown.free_symbols
        if x.is_complex and x.is_real is None:
            return True
        interval = (0, None) if x.is_positive or x.is_nonnegative else (None, 0) if x.is_negative else (None, None)
        return bool(sp.Poly(shown, x).count_roots(*interval))
    return True


def _cases(equations: Sequence[Any], K: Any, depth: int = 6) -> Iterator[tuple[Any, ...]]:
    """The common zeros of polynomials as systems of irreducible equations: a Gröbner basis, split at its factors."""
    R = equations[0].ring
    basis = groebner(list(dict.fromkeys(equations)), R)
    if any(f.is_ground for f in basis):
        return
    for f in basis:
        factors = [g for g, _ in f.factor_list()[1]]
        if (len(factors) > 1 or factors[0] != f.monic()) and depth:
            for g in factors:
                if _can_vanish(g, K):
                    yield from _cases([*(h for h in basis if h != f), g], K, depth - 1)
            return
    if all(_can_vanish(f, K) for f in basis):
        yield tuple(basis)


@dataclass(frozen=True)
class CriticalValues:
    """Values of one parameter for which a matrix loses rank.

    `divisor` is the gcd of its largest minors as a polynomial in the parameter (zero where the rank is deficient
    for every value), `values` its admissible roots, `left_out` those that are complex or that assumptions exclude;
    `others` are conditions on the other parameters alone under which every value will do.
    """

    divisor: sp.Expr
    values: tuple[sp.Expr, ...]
    left_out: tuple[sp.Expr, ...]
    others: tuple[sp.Basic, ...]


@lru_cache(maxsize=64)
def critical_values(M: sp.ImmutableMatrix, parameter: sp.Symbol) -> CriticalValues:
    """The values of the parameter for which M (n×k, k ≥ n) has a rank below n. Other parameters are general.

    Raises NotExact if M is no rational function of the parameter, or a root has no usable form.
    """
    D = domain_matrix(M)
    if D.rank() < M.rows:
        return CriticalValues(sp.Integer(0), (), (), ())
    if parameter not in M.free_symbols:
        return CriticalValues(sp.Integer(1), (), (), ())
    K: Any = D.domain
    if not K.is_FractionField or parameter not in K.symbols:
        raise NotExact(f"The matrix is not a rational function of ${parameter.name}$.")
    divisor, others = _divisor_in(D, parameter)
    roots: list[Root] = []
    for p, multiplicity in divisor.factor_list()[1]:
        roots += roots_of(p, multiplicity)
    admissible = [root.value for root in roots if _admits(parameter, root)]
    if all(value.is_real and not value.free_symbols for value in admissible):
        admissible.sort(key=sp.N)
    left_out = [root.value for root in roots if root.value not in admissible]
    shown = sp.factor(divisor.as_expr())
    return CriticalValues(shown, tuple(admissible), tuple(left_out), others)


def _divisor_in(D: DomainMatrix, parameter: sp.Symbol) -> tuple[sp.Poly, tuple[sp.Basic, ...]]:
    """The gcd of the minors as a polynomial in the parameter over the field of the others."""
    field: Any = D.domain
    R = field.field.ring
    rest = [symbol for symbol in R.symbols if symbol != parameter]
    K = R.domain.frac_field(*rest) if rest else R.domain.get_field()
    over = K.poly_ring(parameter).ring
    rows = [[over.from_expr(a.as_expr()) for a in row] for row in _polynomials(D)]
    r, rows = _without_constants(rows, D.shape[0])
    g = _diagonal_product(rows) if r else over.one
    others: tuple[sp.Basic, ...] = ()
    if rest:
        full = [c for c in rank_conditions(sp.ImmutableMatrix(D.to_Matrix())) if parameter not in c.free_symbols]
        others = tuple(full)
    return sp.Poly(g.as_expr(), parameter, domain=K), others


def _admits(parameter: sp.Symbol, root: Root) -> bool:
    """Whether the parameter may take the value: not a complex one unless it is complex, nor one assumed away."""
    value = root.value
    if value.has(sp.I):
        return bool(parameter.is_complex and parameter.is_real is None)
    for assumption in ("positive", "negative", "nonzero", "nonnegative", "nonpositive", "integer"):
        if getattr(parameter, f"is_{assumption}") and getattr(value, f"is_{assumption}") is False:
            return False
    return True


def telling_minors(M: sp.ImmutableMatrix, parameter: sp.Symbol, most: int = 200) -> list[tuple[list[int], sp.Expr]]:
    """Some n×n minors of M (n×k) whose greatest common divisor is that of all: their columns and values.

    Empty if no such choice is found among the first `most`; zero minors are left out. M has rank n.
    """
    D = domain_matrix(M)
    wanted, _ = _divisor_in(D, parameter)
    running: sp.Poly | None = None
    chosen: list[tuple[list[int], sp.Expr]] = []
    for columns in islice(combinations(range(M.cols), M.rows), most):
        value = expression(D.domain, D.extract(list(range(M.rows)), list(columns)).det())
        above = sp.Poly(sp.fraction(sp.together(value))[0], parameter, domain=wanted.domain)
        if above.is_zero:
            continue
        common = above if running is None else sp.gcd(running, above)
        if running is None or common.degree() < running.degree():
            running = common
            chosen.append((list(columns), sp.factor(value)))
        if running.degree() == wanted.degree():
            return chosen
    return []
