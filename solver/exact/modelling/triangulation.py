"""Polynomials made triangular by a lexicographic Gröbner basis, within bounds."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp
from sympy.polys.groebnertools import groebner
from sympy.polys.orderings import lex
from sympy.polys.rings import ring

MAX_DEGREE = 12
MAX_BEZOUT = 200
"""A bound on the number of solutions of the polynomials that are triangulated."""


def triangulated(polynomials: Sequence[Any], unknowns: Sequence[Any]) -> list[Any] | None:
    """Return a lexicographic Gröbner basis, the simplest polynomial first; None where that may take too long."""
    parameters = sorted({s for p in polynomials for s in p.free_symbols} - set(unknowns), key=str)
    inside = {a for p in polynomials for a in p.atoms(sp.Float, sp.Function, sp.Pow)}
    others = {a for a in inside if not a.is_Pow or not a.exp.is_Integer}
    if others or len(parameters) > 4:
        return None
    K: Any = sp.QQ.frac_field(*parameters) if parameters else sp.QQ
    R, *_ = ring(list(unknowns), K, lex)
    try:
        elements = [R.from_expr(sp.expand(p)) for p in polynomials]
    except (ValueError, sp.CoercionFailed):
        return None
    degrees = [max(map(sum, p.monoms())) for p in elements]
    bound = 1
    for degree in degrees:
        bound *= degree
    if max(degrees) > MAX_DEGREE or bound > (12 if parameters else MAX_BEZOUT):
        return None
    basis = groebner(elements, R)
    return [sp.expand(p.primitive()[1].as_expr() if not parameters else p.as_expr()) for p in reversed(basis)]
