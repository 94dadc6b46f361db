"""The left half plane taken to the unit disc, z = (1 + s)/(1 − s): polynomials over a tower, and roots as written."""

from __future__ import annotations

from functools import lru_cache

import sympy as sp

from solver.exact.linear_algebra.fields import expression
from solver.exact.linear_algebra.signs import is_positive
from solver.exact.optimal.root_choices import Coefficients, coefficients_of, mirrored, roots_of_quadratic
from solver.exact.optimal.spectral_factor import Group, groups_of
from solver.exact.optimal.square_roots import RootTower


def in_z(tower: RootTower, p: Coefficients) -> Coefficients:
    """The monic multiple of (z + 1)ⁿ p((z − 1)/(z + 1)) for p of degree n with p(1) ≠ 0."""
    n = len(p) - 1
    found: Coefficients = [tower.constant(tower.K.zero)] * (n + 1)
    for i, c in enumerate(p):
        for j, number in enumerate(_products(n - i, i)):
            found[j] = tower.add(found[j], tower.scale(tower.K(number), c))
    by = tower.inverse(found[0])
    return [tower.multiply(by, c) for c in found]


@lru_cache(maxsize=256)
def _products(minus: int, plus: int) -> tuple[int, ...]:
    """The coefficients of (z − 1)^minus (z + 1)^plus, highest power first."""
    found = [1]
    for shift in (*(-1,) * minus, *(1,) * plus):
        found = [a + shift * b for a, b in zip([*found, 0], [0, *found], strict=True)]
    return tuple(found)


def factor_in_z(q: sp.Poly) -> sp.Poly:
    """The factor of the pencil that goes with an irreducible factor of the Hamiltonian matrix, monic over K."""
    tower = RootTower(q.domain, shortest=True)
    coefficients = in_z(tower, [tower.constant(c) for c in coefficients_of(q)])
    return sp.Poly([c[0] for c in coefficients], *q.gens, domain=q.domain)


def in_the_disc(s: object) -> object:
    """(1 + s)/(1 − s) for a number of mpmath."""
    return (1 + s) / (1 - s)  # type: ignore[operator]


def roots_in_z(group: Group) -> tuple[sp.Expr, ...]:
    """The stable roots of a group as expressions, each as often as it counts; none where they have no readable form."""
    q = group.factor
    pairs = [(q, 1)] if group.even else [(q, 1), (mirrored(q), 1)]
    (single,) = groups_of(pairs)
    choice = single.choices[0]
    if choice.exact is None or not choice.spelled:
        return ()
    tower = RootTower(q.domain, shortest=True)
    p = in_z(tower, choice.exact(tower))
    if len(p) == 2:
        return (tower.expression(tower.negative(p[1])),) * group.multiplicity
    found = _by_sums(q) if group.even and any(p[2][1:]) else ()
    return (found or roots_of_quadratic(tower, p[1], p[2])) * group.multiplicity


def _by_sums(q: sp.Poly) -> tuple[sp.Expr, ...]:
    """The roots in the disc of an even quartic by w = z + 1/z, where both values of w are real; else none."""
    K = q.domain
    tower = RootTower(K, shortest=True)
    _, b, c = (each[0] for each in in_z(tower, [tower.constant(each) for each in coefficients_of(q)])[:3])
    mean, square = -b / K(2), b * b / K(4) - c + K(2)
    if not is_positive(expression(K, square)):
        return ()
    delta = tower.square_root((square,))
    found = []
    for w in (tower.add((mean,), delta), tower.add((mean,), tower.negative(delta))):
        half = tower.scale(K.one / K(2), w)
        rest = tower.add(tower.multiply(half, half), (-K.one,))
        side = tower.is_positive(half)
        if side is None or not tower.is_positive(rest):
            return ()
        root = sp.sqrt(tower.expression(rest))
        found.append(tower.expression(half) + (-root if side else root))
    return tuple(found)
