"""For which parameters Smith's form is another than in general."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from solver.exact.linear_algebra.fields import NotExact, expression, vanishing_factors
from solver.exact.linear_algebra.special_values import special_values
from solver.exact.multivariable.polynomial_matrices import matrix_of_rows
from solver.exact.multivariable.smith import SmithForm, smith_form

FEW = 3
"""Up to so many parameters it is tried whether the form really changes."""


def changed_where(form: SmithForm) -> tuple[sp.Expr, ...]:
    """Factors, in one of whose zeros the form may be another: of the coefficients by which was divided.

    Wherever none of these is zero the operations can be done as they stand. A factor is left out where the form with
    it zero is found to be the general one.
    """
    M, x = matrix_of_rows(form.rows), form.variable
    found = _factors(form)
    if len(M.free_symbols - {x}) > FEW:
        return found
    return tuple(factor for factor in found if not _is_the_same(form, M, factor, found))


def _factors(form: SmithForm) -> tuple[sp.Expr, ...]:
    K = form.rows[0][0].domain
    return tuple(dict.fromkeys(factor for lead in form.leads for factor in vanishing_factors(expression(K, lead))))


def _is_the_same(form: SmithForm, M: sp.ImmutableMatrix, factor: sp.Expr, others: Sequence[sp.Expr]) -> bool:
    """Whether the form at a zero of the factor is the general one with the zero put in."""
    for a, value in special_values(factor):
        there = M.xreplace({a: value}).applyfunc(sp.cancel)
        if there.has(sp.nan, sp.zoo):
            continue
        try:
            special = smith_form(sp.ImmutableMatrix(there), form.variable)
        except NotExact:
            continue
        put_in = [sp.cancel(e.subs(a, value)) for e in form.invariant_factors]
        if any(sp.cancel(e - f) != 0 for e, f in zip(put_in, special.invariant_factors, strict=True)):
            return False
        left = [other.subs(a, value) for other in others if other != factor]
        known = {each for other in left for each in vanishing_factors(sp.cancel(other))}
        return all(each in known for each in changed_where(special))
    return False


def common_roots_where(p: sp.Poly, q: sp.Poly) -> tuple[sp.Expr, ...]:
    """Factors, in whose zeros two polynomials without common factors have a common root: those of the resultant."""
    if not (p.degree() > 0 and q.degree() > 0):
        return ()
    found = expression(p.domain, p.domain.convert(p.resultant(q)))
    return tuple(vanishing_factors(found))
