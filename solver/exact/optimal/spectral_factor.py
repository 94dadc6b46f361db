"""Spectral factors: real p with p(s) p(−s) = (−1)ⁿ χ(s) for an even χ without roots on the imaginary axis.

χ is factored over K. A factor q with q(−s) = ± q(s), or a pair q(s), q(−s), contributes to p in several ways: each of
its real roots, or conjugate pairs of roots, may be taken in the left or in the right half plane (flipped), with
multiplicity m in m + 1 ways. The Hurwitz factor takes all in the left.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

import mpmath
import sympy as sp

from solver.exact.linear_algebra.fields import expression
from solver.exact.linear_algebra.signs import is_positive
from solver.exact.optimal.even_factors import biquadratic_choices, near_the_axis, quadratic_choices
from solver.exact.optimal.root_choices import (
    WORKING_DIGITS,
    Choice,
    Coefficients,
    OnTheAxis,
    coefficients_of,
    conjugate_choices,
    decimal_choices,
    linear_choices,
    mirrored,
    mixture,
    power_product,
    require_numbers,
    roots_in_decimals,
    sign,
    surd_choices,
)
from solver.exact.optimal.square_roots import RootTower, TooDeep


@dataclass(frozen=True)
class Group:
    """A factor q of χ of multiplicity m, or a pair q(s), q(−s), with its choices: the Hurwitz one first."""

    factor: sp.Poly
    even: bool
    multiplicity: int
    choices: tuple[Choice, ...]

    @property
    def size(self) -> int:
        """How many roots of p come from it."""
        whole = self.factor.degree() * self.multiplicity
        return whole // 2 if self.even else whole


def groups_of(factors: Sequence[tuple[sp.Poly, int]]) -> list[Group]:
    """Return the groups of the irreducible factors of χ. Raises OnTheAxis, NotExact."""
    with mpmath.workdps(WORKING_DIGITS):  # all arithmetic on roots, signs included, rounds to this
        return _groups_of(list(factors))


def _groups_of(left: list[tuple[sp.Poly, int]]) -> list[Group]:
    found: list[Group] = []
    while left:
        q, m = left.pop(0)
        image = mirrored(q)
        if q == image:
            if q.degree() % 2:  # q = s
                raise OnTheAxis(q)
            found.append(Group(q, True, m, _even_choices(q, m)))
        else:
            left = [(other, power) for other, power in left if other != image]
            found.append(_pair_group(q, image, m))
    return sorted(found, key=lambda group: (group.factor.degree(), str(group.factor.as_expr())))


def _even_choices(q: sp.Poly, m: int) -> tuple[Choice, ...]:
    """The choices of a factor with q(−s) = q(s)."""
    if q.degree() == 2:
        return quadratic_choices(q, m)
    if q.degree() == 4:
        return biquadratic_choices(q, m)
    require_numbers(q)
    roots = roots_in_decimals(q)
    if any(map(near_the_axis, roots)):
        raise OnTheAxis(q)
    return decimal_choices([z for z in roots if z.real < 0], m)


def _pair_group(q: sp.Poly, image: sp.Poly, m: int) -> Group:
    """The choices of a pair q(s), q(−s), named by the one that has more of its roots in the left half plane."""
    if q.degree() == 1:
        q = image if sign(q.domain, coefficients_of(q)[1]) < 0 else q
        return Group(q, False, m, linear_choices(q, m))
    if q.domain.is_Composite:
        return _parametric_pair(q, image, m)
    roots = roots_in_decimals(q)
    if 2 * sum(1 for z in roots if z.real < 0) < len(roots):
        q, roots = image, [-z for z in roots]
    stable = [z if z.real < 0 else -z for z in roots]
    if q.degree() == 2:
        real = roots[0].imag == 0
        return Group(q, False, m, surd_choices(q, m) if real else conjugate_choices(q, m, stable))
    choices = decimal_choices(stable, m)
    if all(z.real < 0 for z in roots):  # none or all flipped: a polynomial over K
        first, *others, last = choices
        first, last = Choice(0, mixture(q, m, 0), first.roots), Choice(last.flips, mixture(q, 0, m), last.roots)
        choices = (first, *others, last)
    return Group(q, False, m, choices)


def _parametric_pair(q: sp.Poly, image: sp.Poly, m: int) -> Group:
    """A pair of quadratics with parameters: a conjugate pair of roots, or two real ones of the same sign."""
    if q.degree() > 2:
        require_numbers(q)
    K, (_, b, c) = q.domain, coefficients_of(q)
    if sign(K, c) < 0:
        return Group(q, False, m, surd_choices(q, m))
    if sign(K, b) < 0:
        q = image
    choices = conjugate_choices(q, m, [])
    discriminant = sp.factor(expression(K, b * b / K(4) - c))
    if m > 1 or is_positive(-discriminant):
        return Group(q, False, m, choices)
    needs = None if is_positive(discriminant) else discriminant
    mixed = (Choice(x.flips, x.exact, (), x.spelled, needs) for x in surd_choices(q, m)[1:-1])
    return Group(q, False, m, (choices[0], *mixed, choices[1]))


def combinations(groups: Sequence[Group], fixed: Sequence[bool]) -> Iterator[tuple[Choice, ...]]:
    """Yield one choice a group, the Hurwitz factor first, by number of flips; groups that are fixed stay Hurwitz."""
    options = [group.choices[:1] if keep else group.choices for group, keep in zip(groups, fixed, strict=True)]
    yield from sorted(product(*options), key=lambda choices: sum(choice.flips for choice in choices))


def exact_polynomial(
    K: Any, choices: Sequence[Choice], *, shortest: bool = False
) -> tuple[RootTower, Coefficients] | None:
    """Return p over a tower of its own; None where a choice has no exact form, or too many roots would nest."""
    tower = RootTower(K, shortest=shortest)
    try:
        parts = [(choice.exact(tower), 1) for choice in choices if choice.exact is not None]
    except TooDeep:
        return None
    return (tower, power_product(tower, parts)) if len(parts) == len(choices) else None


def decimal_polynomial(choices: Sequence[Choice]) -> list[Any]:
    """Return the coefficients of p as mpmath numbers of many digits, highest power first."""
    with mpmath.workdps(WORKING_DIGITS):
        coefficients = [mpmath.mpf(1)]
        for z in (z for choice in choices for z in choice.roots):
            coefficients = [a - z * b for a, b in zip([*coefficients, 0], [0, *coefficients], strict=True)]
        return [mpmath.re(c) for c in coefficients]
