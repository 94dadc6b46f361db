"""For which values of its parameters a matrix has a lower rank than in general.

The rank falls below r where all r×r minors vanish together.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache, reduce
from typing import Any

import sympy as sp
from sympy.polys.groebnertools import groebner
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.fields import domain_matrix, in_sines, whole_angles
from solver.exact.linear_algebra.signs import is_not_zero
from solver.exact.linear_algebra.special_values import special_values
from solver.exact.structure.minors import diagonal_product, minors_of, polynomials_of, without_constants


@lru_cache(maxsize=64)
def rank_conditions(M: sp.ImmutableMatrix) -> tuple[sp.Basic, ...]:
    """Conditions on the real parameters of M under any of which its rank is lower than the generic one.

    Each is Eq(f, 0), or Eq(x, c) for a parameter x and a number c, or And of several such equations. Raises NotExact
    where there are too many minors.
    """
    D = domain_matrix(M)
    rows = polynomials_of(D)
    if not rows:
        return ()
    generic = int(D.rank())
    r, rows = without_constants(rows, generic)
    found = _at_half_turns(M, generic)
    if r == 0:
        return tuple(found)
    R = rows[0][0].ring
    if R.ngens == 1:
        divisor, rest = diagonal_product(rows), []
    else:
        minors = [minor for minor in minors_of(rows, r) if minor]
        divisor = reduce(lambda f, g: f.gcd(g), minors)
        rest = [minor.exquo(divisor) for minor in minors]
    for f, _ in divisor.factor_list()[1]:
        if _can_vanish(f):
            found += _where_it_vanishes(f)
    if rest and not any(minor.is_ground for minor in rest):
        found += [sp.And(*(_vanishes(f) for f in case)) for case in _cases(rest)]
    undefined = _undefined(D)
    return tuple(condition for condition in dict.fromkeys(found) if not condition.atoms(sp.Eq) & undefined)


def _undefined(D: DomainMatrix) -> set[sp.Basic]:
    """The equations under which a denominator of M is zero, so that there is no M to speak of."""
    K: Any = D.domain
    R = K.field.ring.clone(domain=K.field.ring.domain.get_field())
    denominators = {a.denom.set_ring(R) for row in D.to_list() for a in row}
    return {_vanishes(f) for below in denominators for f, _ in below.factor_list()[1]}


def _at_half_turns(M: sp.ImmutableMatrix, generic: int) -> list[sp.Basic]:
    """The conditions cos θ = −1, where tan(θ/2) has no value and the polynomials in it say nothing."""
    angles = sorted({f.args[0] for f in M.atoms(sp.sin, sp.cos)}, key=sp.default_sort_key)
    turned = [(angle, M.xreplace({sp.cos(angle): sp.Integer(-1), sp.sin(angle): sp.Integer(0)})) for angle in angles]
    return [sp.Eq(sp.cos(angle) + 1, 0) for angle, N in turned if domain_matrix(N).rank() < generic]


def _shown(f: Any) -> sp.Expr:
    """The polynomial, times a factor that is never zero, as an expression in the parameters, sines and cosines."""
    shown = sp.factor(in_sines(whole_angles(f.as_expr())))
    above: sp.Expr = sp.fraction(shown)[0].primitive()[1]
    return -above if above.free_symbols and sp.Poly(above).LC().is_negative else above


def _vanishes(f: Any) -> sp.Eq:
    """The equation that says so: solved for the parameter where it is linear with one parameter only."""
    shown = _shown(f)
    if len(shown.free_symbols) == 1:
        (x,) = shown.free_symbols
        exponent, value = _by_exponential(shown) or (shown, sp.Integer(1))
        p = sp.Poly(exponent - sp.log(value), x) if exponent.is_polynomial(x) and value.is_positive else None
        if p and p.degree() == 1:
            return sp.Eq(x, -p.nth(0) / p.nth(1), evaluate=False)
    return sp.Eq(shown, 0, evaluate=False)


def _where_it_vanishes(f: Any) -> list[sp.Basic]:
    """The equations that say so: one for each root of a quadratic polynomial in one parameter, a = √2 and a = −√2."""
    equation = _vanishes(f)
    roots = special_values(equation.lhs) if equation.rhs == 0 and len(equation.free_symbols) == 1 else ()
    return [sp.Eq(x, value, evaluate=False) for x, value in roots] or [equation]


def _can_vanish(f: Any) -> bool:
    """Whether a polynomial can be zero for real parameters that are as assumed; if in doubt, yes."""
    shown = _shown(f)
    if not shown.free_symbols or is_not_zero(shown) or _exponential_is_not(shown):
        return False
    if len(shown.free_symbols) == 1 and shown.is_polynomial() and f.ring.domain.is_QQ:
        (x,) = shown.free_symbols
        if x.is_complex and x.is_real is None:
            return True
        interval = (0, None) if x.is_positive or x.is_nonnegative else (None, 0) if x.is_negative else (None, None)
        return bool(sp.Poly(shown, x).count_roots(*interval))
    return True


def _by_exponential(shown: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """The exponent a and the number v for which u e^a + w with numbers u, w is zero where e^a = v."""
    exponentials = shown.atoms(sp.exp)
    if len(exponentials) != 1:
        return None
    (power,) = exponentials
    E = sp.Dummy("E")
    p = shown.xreplace({power: E})
    if p.free_symbols != {E} or not p.is_polynomial(E) or sp.degree(p, E) != 1:
        return None
    return power.args[0], -p.coeff(E, 0) / p.coeff(E, 1)


def _exponential_is_not(shown: sp.Expr) -> bool:
    """Whether u e^a + w cannot be zero: e^a is positive, and a not everywhere."""
    found = _by_exponential(shown)
    if found is None:
        return False
    exponent, value = found
    return bool(value.is_nonpositive or (value.is_positive and is_not_zero(exponent - sp.log(value))))


def _cases(equations: Sequence[Any], depth: int = 6) -> Iterator[tuple[Any, ...]]:
    """The common zeros of polynomials as systems of irreducible equations: a Gröbner basis, split at its factors."""
    R = equations[0].ring
    basis = groebner(list(dict.fromkeys(equations)), R)
    if any(f.is_ground for f in basis):
        return
    for f in basis:
        factors = [g for g, _ in f.factor_list()[1]]
        if factors[0] != f.monic() and depth:
            for g in factors:
                if _can_vanish(g):
                    yield from _cases([*(h for h in basis if h != f), g], depth - 1)
            return
    if all(_can_vanish(f) for f in basis):
        yield tuple(basis)
