"""For which values of one parameter a matrix loses rank, and which of its minors tell them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations, islice
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.fields import NotExact, domain_matrix, expression
from solver.exact.linear_algebra.signs import is_not_zero
from solver.exact.linear_algebra.spectrum import Root, roots_of
from solver.exact.structure.minors import diagonal_product, polynomials_of, without_constants
from solver.exact.structure.rank_conditions import rank_conditions


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
        raise NotExact("structure/not_rational", parameter=parameter.name)
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
    rows = [[over.from_expr(a.as_expr()) for a in row] for row in polynomials_of(D)]
    r, rows = without_constants(rows, D.shape[0])
    g = diagonal_product(rows) if r else over.one
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
    return not is_not_zero(parameter - value)


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
