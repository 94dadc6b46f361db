"""Choices of roots: the ways in which a factor of an even polynomial may contribute to a spectral factor.

Each real root, or conjugate pair of roots, may be taken in the left or in the right half plane (flipped), so one of
multiplicity m contributes in m + 1 ways. Polynomials are over K, or over a tower of square roots over K.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import reduce
from itertools import product
from typing import Any

import mpmath
import sympy as sp

from solver.exact.linear_algebra.fields import NotExact, expression
from solver.exact.linear_algebra.signs import possible_signs
from solver.exact.optimal.square_roots import Nested, RootTower, root_of, without_sign

DIGITS = 30
"""Digits of decimals in results."""

WORKING_DIGITS = 120

Coefficients = list[Nested]
"""A polynomial over a tower, highest power first."""

Builder = Callable[[RootTower], Coefficients]


class OnTheAxis(Exception):  # noqa: N818 - a finding
    """χ has roots on the imaginary axis: those of `factor`, a polynomial over K."""

    def __init__(self, factor: sp.Poly) -> None:
        super().__init__(str(factor))
        self.factor = factor


@dataclass(frozen=True)
class Choice:
    """One way in which a group of roots contributes to p: `flips` of its roots are in the right half plane.

    `exact` gives the polynomial over a tower (None: there is no readable form); `roots` are mpmath numbers (none where
    K has parameters); `spelled` are the roots as expressions where they have readable ones. `real` says whether the
    polynomial is real for all admissible parameters; None if `radicand` must be positive for that.
    """

    flips: int
    exact: Builder | None
    roots: tuple[Any, ...]
    spelled: tuple[sp.Expr, ...] = ()
    radicand: sp.Expr | None = None


def mirrored(q: sp.Poly) -> sp.Poly:
    """(−1)^d q(−s), monic."""
    d, coefficients = q.degree(), coefficients_of(q)
    flipped = [c if i % 2 == 0 else -c for i, c in enumerate(coefficients)]
    return sp.Poly(flipped, *q.gens, domain=q.domain) if d else q


def coefficients_of(q: sp.Poly) -> list[Any]:
    """Elements of K, highest power first."""
    return list(q.rep.to_list())


def require_numbers(q: sp.Poly) -> None:
    """Raise NotExact for a factor with parameters."""
    if q.domain.is_Composite:
        raise NotExact("optimal/factor_with_parameters", degree=q.degree())


def roots_in_decimals(q: sp.Poly) -> list[Any]:
    """The roots as mpmath numbers, the real ones without imaginary part."""
    with mpmath.workdps(WORKING_DIGITS):
        coefficients = [mpmath.mpmathify(sp.N(c, WORKING_DIGITS)) for c in q.all_coeffs()]
        found = mpmath.polyroots(coefficients, maxsteps=2000, extraprec=6 * WORKING_DIGITS)
        near = mpmath.mpf(10) ** -(WORKING_DIGITS // 2)
        return [mpmath.mpc(z.real, 0) if abs(z.imag) < near * (1 + abs(z)) else mpmath.mpc(z) for z in found]


def sign(K: Any, c: Any) -> int:
    """The sign of an element of K; raises NotExact where parameters leave it open."""
    value = expression(K, c)
    if value == 0:
        return 0
    if not value.free_symbols:
        return 1 if sp.N(value, 30) > 0 else -1
    for form in (sp.factor(value), sp.expand(value)):
        if form.is_positive is not None and form.is_zero is False:
            return 1 if form.is_positive else -1
        if form.is_nonnegative or form.is_nonpositive:
            return 1 if form.is_nonnegative else -1
    if len(signs := possible_signs(value)) == 1:
        return next(iter(signs))
    raise NotExact("optimal/sign_in_the_solution", value=without_sign(sp.factor(value)))


def known_negative(K: Any, c: Any) -> bool:
    """Whether an element of K is negative for all admissible parameters."""
    try:
        return sign(K, c) < 0
    except NotExact:
        return False


def decimal(K: Any, value: sp.Expr) -> Any:
    """A number as mpmath has it; zero, which nobody uses, where K has parameters."""
    return mpmath.mpf(0) if K.is_Composite else mpmath.mpmathify(sp.N(value, WORKING_DIGITS))


def divided(alpha: Any, m: int, k: int) -> tuple[Any, ...]:
    """The root −α of multiplicity m, with k of them flipped to α."""
    return (-alpha,) * (m - k) + (alpha,) * k


def linear_powers(tower: RootTower, alpha: Nested, m: int, k: int) -> list[tuple[Coefficients, int]]:
    """(s + α)^{m−k} (s − α)ᵏ as polynomials and their powers."""
    one = tower.constant(tower.K.one)
    return [([one, alpha], m - k), ([one, tower.negative(alpha)], k)]


def linear_choices(q: sp.Poly, m: int) -> tuple[Choice, ...]:
    """(s + α)^{m−k} (s − α)ᵏ for q = s + α with α > 0 in K."""
    K = q.domain
    alpha = expression(K, coefficients_of(q)[1])
    value = decimal(K, alpha)
    return tuple(
        Choice(k, mixture(q, m - k, k), () if K.is_Composite else divided(value, m, k), divided(alpha, m, k))
        for k in range(m + 1)
    )


def conjugate_choices(q: sp.Poly, m: int, stable: list[Any]) -> tuple[Choice, ...]:
    """q(s)^{m−k} q(−s)ᵏ for a Hurwitz quadratic, its pair of roots flipped as a whole; `stable` are its decimals."""
    return tuple(
        Choice(
            2 * k,
            mixture(q, m - k, k),
            (*stable * (m - k), *(-z for z in stable * k)),
            () if k else spelled_pair(q) * m,
        )
        for k in range(m + 1)
    )


def surd_choices(q: sp.Poly, m: int) -> tuple[Choice, ...]:
    """The choices of a quadratic with two real roots −b/2 ± √(b²/4 − c), taken one by one."""
    K, (_, b, c) = q.domain, coefficients_of(q)
    square = b * b / K(4) - c
    opposite = sign(K, c) < 0
    root, middle = root_of(K, square), expression(K, b) / 2
    sizes = [root - middle, root + middle] if opposite else [middle + root, middle - root]
    values = [decimal(K, size) for size in sizes]

    def elements(tower: RootTower) -> list[Nested]:
        delta, mean = tower.square_root((square,)), (b / K(2),)
        if opposite:
            return [tower.add(delta, tower.negative(mean)), tower.add(delta, mean)]
        return [tower.add(mean, delta), tower.add(mean, tower.negative(delta))]

    def factor(flips: tuple[int, ...]) -> Builder:
        def build(tower: RootTower) -> Coefficients:
            parts: list[tuple[Coefficients, int]] = []
            for alpha, k in zip(elements(tower), flips, strict=True):
                parts += linear_powers(tower, alpha, m, k)
            return power_product(tower, parts)

        return build

    def taken(alphas: Sequence[Any], flips: tuple[int, ...]) -> tuple[Any, ...]:
        return tuple(z for alpha, k in zip(alphas, flips, strict=True) for z in divided(alpha, m, k))

    return tuple(
        Choice(sum(flips), factor(flips), () if K.is_Composite else taken(values, flips), taken(sizes, flips))
        for flips in sorted(product(range(m + 1), repeat=2), key=sum)
    )


def spelled_pair(q: sp.Poly) -> tuple[sp.Expr, ...]:
    """The roots −b/2 ± √(b²/4 − c) of a quadratic."""
    _, b, c = coefficients_of(q)
    return roots_of_quadratic(RootTower(q.domain), (b,), (c,))


def roots_of_quadratic(tower: RootTower, b: Nested, c: Nested) -> tuple[sp.Expr, ...]:
    """The roots −b/2 ± √(b²/4 − c) of s² + b s + c, the root in the tower where its sign is known."""
    K, half = tower.K, tower.K.one / tower.K(2)
    middle, square = tower.scale(-half, b), tower.add(tower.multiply(b, b), tower.scale(K(-4), c))
    opposite, real = tower.negative(square), tower.is_positive(square)
    if real:
        delta = tower.scale(half, tower.square_root(square))
        return tuple(tower.expression(tower.add(middle, each)) for each in (tower.negative(delta), delta))
    if real is False and tower.is_positive(opposite):
        shift = sp.I * tower.expression(tower.scale(half, tower.square_root(opposite)))
    else:
        shift = tower.root_as_written(square) / 2
    return tuple(tower.expression(middle) + each for each in (shift, -shift))


def decimal_choices(stable: Sequence[Any], m: int) -> tuple[Choice, ...]:
    """All choices for roots known by their decimals: each real one, each conjugate pair, flipped 0 … m times."""
    atoms = [[z] for z in stable if z.imag == 0] + [[z, z.conjugate()] for z in stable if z.imag > 0]
    choices = []
    for flips in product(range(m + 1), repeat=len(atoms)):
        roots = [
            sign * z
            for atom, k in zip(atoms, flips, strict=True)
            for z in atom
            for sign in (*(1,) * (m - k), *(-1,) * k)
        ]
        flipped = sum(k * len(atom) for atom, k in zip(atoms, flips, strict=True))
        choices.append(Choice(flipped, None, tuple(roots)))
    return tuple(sorted(choices, key=lambda choice: choice.flips))


def mixture(q: sp.Poly, straight: int, flipped: int) -> Builder:
    """q(s)^straight q(−s)^flipped over K."""

    def build(tower: RootTower) -> Coefficients:
        lifted = [[tower.constant(c) for c in coefficients_of(each)] for each in (q, mirrored(q))]
        return power_product(tower, [(lifted[0], straight), (lifted[1], flipped)])

    return build


def power_product(tower: RootTower, parts: Sequence[tuple[Coefficients, int]]) -> Coefficients:
    """Return the product of powers of polynomials over the tower."""
    repeated = [polynomial for polynomial, power in parts for _ in range(power)]
    return reduce(lambda p, q: _times(tower, p, q), repeated, [tower.constant(tower.K.one)])


def _times(tower: RootTower, p: Coefficients, q: Coefficients) -> Coefficients:
    result: Coefficients = [tower.constant(tower.K.zero)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            result[i + j] = tower.add(result[i + j], tower.multiply(a, b))
    return result
