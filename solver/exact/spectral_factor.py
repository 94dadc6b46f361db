"""Spectral factors: real p with p(s) p(−s) = (−1)ⁿ χ(s) for an even χ without roots on the imaginary axis.

χ is factored over K. A factor q with q(−s) = ± q(s), or a pair q(s), q(−s), contributes to p in several ways: each of
its real roots, or conjugate pairs of roots, may be taken in the left or in the right half plane (flipped), with
multiplicity m in m + 1 ways. The Hurwitz factor takes all in the left.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import reduce
from itertools import product
from typing import Any

import mpmath
import sympy as sp

from solver.exact.fields import NotExact, expression
from solver.exact.square_roots import Nested, RootTower, TooDeep, without_sign

DIGITS = 30
"""Digits of decimals in results."""

WORKING_DIGITS = 120

Coefficients = list[Nested]
"""A polynomial over a tower, highest power first."""


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
    exact: Callable[[RootTower], Coefficients] | None
    roots: tuple[Any, ...]
    spelled: tuple[sp.Expr, ...] = ()
    radicand: sp.Expr | None = None


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
        mirrored = _mirrored(q)
        if q == mirrored:
            if q.degree() % 2:  # q = s
                raise OnTheAxis(q)
            found.append(_even_group(q, m))
        else:
            left = [(other, power) for other, power in left if other != mirrored]
            found.append(_pair_group(q, mirrored, m))
    return sorted(found, key=lambda group: (group.factor.degree(), str(group.factor.as_expr())))


def _mirrored(q: sp.Poly) -> sp.Poly:
    """(−1)^d q(−s), monic."""
    d, coefficients = q.degree(), q.rep.to_list()
    flipped = [c if i % 2 == 0 else -c for i, c in enumerate(coefficients)]
    return sp.Poly(flipped, *q.gens, domain=q.domain) if d else q


def _coefficients(q: sp.Poly) -> list[Any]:
    """Elements of K, highest power first."""
    return list(q.rep.to_list())


def _even_group(q: sp.Poly, m: int) -> Group:
    K, c = q.domain, _coefficients(q)
    if q.degree() == 2:
        return Group(q, True, m, _real_root_choices(K, -c[2], m))
    if q.degree() == 4:
        return Group(q, True, m, _biquadratic_choices(q, K, c[2], c[4], m))
    _require_numbers(q)
    roots = _roots(q)
    if any(mpmath.mpf(10) ** -DIGITS * (1 + abs(z)) > abs(z.real) for z in roots):
        raise OnTheAxis(q)
    return Group(q, True, m, _decimal_choices([z for z in roots if z.real < 0], m))


def _require_numbers(q: sp.Poly) -> None:
    if q.domain.is_Composite:
        raise NotExact(
            "The characteristic polynomial of the Hamiltonian matrix has a factor of degree "
            f"{q.degree()} with parameters in it, whose roots have no usable form. Give the parameters values."
        )


def _roots(q: sp.Poly) -> list[Any]:
    with mpmath.workdps(WORKING_DIGITS):
        coefficients = [mpmath.mpmathify(sp.N(c, WORKING_DIGITS)) for c in q.all_coeffs()]
        found = mpmath.polyroots(coefficients, maxsteps=2000, extraprec=6 * WORKING_DIGITS)
        near = mpmath.mpf(10) ** -(WORKING_DIGITS // 2)
        return [mpmath.mpc(z.real, 0) if abs(z.imag) < near * (1 + abs(z)) else mpmath.mpc(z) for z in found]


def _sign(K: Any, c: Any) -> int:
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
    raise NotExact(
        f"The solution depends on the sign of ${sp.latex(without_sign(sp.factor(value)))}$. "
        "Say under `assume` whether the parameters are positive or negative."
    )


def _real_root_choices(K: Any, square: Any, m: int) -> tuple[Choice, ...]:
    """(s + α)^{m−k} (s − α)ᵏ for an even factor s² − α²."""
    numeric = not K.is_Composite
    if (numeric and _sign(K, square) < 0) or (not numeric and _known_negative(K, square)):
        raise OnTheAxis(sp.Poly([K.one, K.zero, -square], sp.Symbol("s"), domain=K))
    alpha = sp.sqrt(expression(K, square))
    value = mpmath.mpf(0)
    if numeric:
        with mpmath.workdps(WORKING_DIGITS):
            value = mpmath.sqrt(mpmath.mpmathify(sp.N(expression(K, square), WORKING_DIGITS)))

    def factor(k: int) -> Callable[[RootTower], Coefficients]:
        def build(tower: RootTower) -> Coefficients:
            root = tower.square_root((square,))
            one = tower.constant(K.one)
            return power_product(tower, [([one, root], m - k), ([one, tower.negative(root)], k)])

        return build

    return tuple(
        Choice(
            k, factor(k), ((-value,) * (m - k) + (value,) * k) if numeric else (), (-alpha,) * (m - k) + (alpha,) * k
        )
        for k in range(m + 1)
    )


def _known_negative(K: Any, c: Any) -> bool:
    try:
        return _sign(K, c) < 0
    except NotExact:
        return False


def _biquadratic_choices(q: sp.Poly, K: Any, e: Any, f: Any, m: int) -> tuple[Choice, ...]:
    """s⁴ + e s² + f = (s² + b s + c)(s² − b s + c) with c = ±√f and b = ±√(2c − e)."""
    numbers = not K.is_Composite
    roots = _roots(q) if numbers else []
    if numbers and any(abs(z.real) < mpmath.mpf(10) ** -DIGITS * (1 + abs(z)) for z in roots):
        raise OnTheAxis(q)
    if not numbers and (_known_negative(K, f)):
        raise OnTheAxis(q)
    stable = [z for z in roots if z.real < 0]
    all_real = numbers and all(z.imag == 0 for z in roots)
    if m > 1 and all_real:
        return _decimal_choices(stable, m)

    def factor(c_sign: int, b_sign: int) -> Callable[[RootTower], Coefficients]:
        def build(tower: RootTower) -> Coefficients:
            c = tower.scale(K(c_sign), tower.square_root((f,)))
            b = tower.scale(K(b_sign), tower.square_root(tower.add(tower.scale(K(2), c), (-e,))))
            return [tower.constant(K.one), b, c]

        return build

    def mixed(k: int) -> Callable[[RootTower], Coefficients]:
        def build(tower: RootTower) -> Coefficients:
            return power_product(tower, [(factor(1, 1)(tower), m - k), (factor(1, -1)(tower), k)])

        return build

    spelled = _spelled_roots(expression(K, e), expression(K, f))
    choices = [
        Choice(2 * k, mixed(k), (*stable * (m - k), *(-z for z in stable * k)), spelled * m if k == 0 else ())
        for k in range(m + 1)
    ]
    radicand = None if numbers else _second_radicand(K, e, f)
    if m == 1 and (all_real or not numbers) and radicand is not False:
        needs = None if radicand is True or numbers else radicand
        for b_sign in (1, -1):
            split = sorted(stable, key=lambda z: z.real)
            taken = ((split[0], -split[1]) if b_sign > 0 else (-split[0], split[1])) if numbers else ()
            choices.insert(-1, Choice(1, factor(-1, b_sign), taken, (), needs))
    return tuple(choices)


def _second_radicand(K: Any, e: Any, f: Any) -> Any:
    """−2√f − e, which must be positive for real roots: True or False where that is known, else the expression."""
    radicand = -2 * sp.sqrt(expression(K, f)) - expression(K, e)
    if radicand.is_positive or radicand.is_negative:
        return bool(radicand.is_positive)
    discriminant = sp.factor(expression(K, e * e - K(4) * f))
    if discriminant.is_negative or expression(K, e).is_nonnegative:
        return False
    return sp.factor(expression(K, -e)) - 2 * sp.sqrt(sp.factor(expression(K, f)))


def _spelled_roots(e: sp.Expr, f: sp.Expr) -> tuple[sp.Expr, ...]:
    """The stable roots of s⁴ + e s² + f: −½√(2√f − e) ± ½√(−2√f − e)."""
    root = sp.sqrt(f)
    half, delta = sp.sqrt(sp.expand(2 * root - e)) / 2, sp.expand(-2 * root - e)
    if not delta.free_symbols and sp.N(delta) < 0:
        omega = sp.sqrt(sp.expand(-delta)) / 2
        return (-half + sp.I * omega, -half - sp.I * omega)
    if delta.is_negative:
        return (-half + sp.I * sp.sqrt(-delta) / 2, -half - sp.I * sp.sqrt(-delta) / 2)
    return (-half - sp.sqrt(delta) / 2, -half + sp.sqrt(delta) / 2)


def _pair_group(q: sp.Poly, mirrored: sp.Poly, m: int) -> Group:
    """The choices of a pair q(s), q(−s)."""
    K, c = q.domain, _coefficients(q)
    if q.degree() == 1:
        if _sign(K, c[1]) < 0:
            q, c = mirrored, _coefficients(mirrored)
        alpha = expression(K, c[1])
        value = mpmath.mpmathify(sp.N(alpha, WORKING_DIGITS)) if not K.is_Composite else mpmath.mpf(0)
        return Group(q, False, m, tuple(
            Choice(k, _mixture(q, m - k, k), ((-value,) * (m - k) + (value,) * k) if not K.is_Composite else (),
                   (-alpha,) * (m - k) + (alpha,) * k)
            for k in range(m + 1)
        ))  # fmt: skip
    if K.is_Composite:
        return _parametric_pair(q, mirrored, m)
    roots = _roots(q)
    in_left = sum(1 for z in roots if z.real < 0)
    if in_left < len(roots) - in_left:
        q, mirrored, roots = mirrored, q, [-z for z in roots]
    stable = [z if z.real < 0 else -z for z in roots]
    one_sided = all(z.real < 0 for z in roots)
    if q.degree() == 2 and roots[0].imag != 0:
        value = _spelled_pair(q) * m
        listed = (
            Choice(2 * k, _mixture(q, m - k, k), (*stable * (m - k), *(-z for z in stable * k)), () if k else value)
            for k in range(m + 1)
        )
        return Group(q, False, m, tuple(listed))
    choices = _decimal_choices(stable, m)
    if q.degree() == 2:
        return Group(q, False, m, _surd_choices(q, m))
    if one_sided:
        first, last = choices[0], choices[-1]
        choices = (
            Choice(first.flips, _mixture(q, m, 0), first.roots),
            *choices[1:-1],
            Choice(last.flips, _mixture(q, 0, m), last.roots),
        )
    return Group(q, False, m, choices)


def _parametric_pair(q: sp.Poly, mirrored: sp.Poly, m: int) -> Group:
    """A pair of quadratics with parameters: a conjugate pair of roots, or two real ones of the same sign."""
    if q.degree() > 2:
        _require_numbers(q)
    K, c = q.domain, _coefficients(q)
    if _sign(K, c[2]) < 0:
        return Group(q, False, m, _surd_choices(q, m))
    if _sign(K, c[1]) < 0:
        q, c = mirrored, _coefficients(mirrored)
    discriminant = sp.factor(expression(K, c[1] * c[1] / K(4) - c[2]))
    choices = [Choice(2 * k, _mixture(q, m - k, k), (), _spelled_pair(q) * m if not k else ()) for k in range(m + 1)]
    if not discriminant.is_negative:
        surds = _surd_choices(q, m)
        needs = None if discriminant.is_positive else discriminant
        mixed = [Choice(x.flips, x.exact, (), x.spelled, needs) for x in surds[1:-1] if x.exact]
        choices = [choices[0], *mixed, *choices[1:]] if m == 1 else choices
    return Group(q, False, m, tuple(choices))


def _mixture(q: sp.Poly, straight: int, flipped: int) -> Callable[[RootTower], Coefficients]:
    """q(s)^straight q(−s)^flipped over K."""

    def build(tower: RootTower) -> Coefficients:
        lifted = [[tower.constant(c) for c in _coefficients(each)] for each in (q, _mirrored(q))]
        return power_product(tower, [(lifted[0], straight), (lifted[1], flipped)])

    return build


def _spelled_pair(q: sp.Poly) -> tuple[sp.Expr, ...]:
    _, b, c = (expression(q.domain, each) for each in _coefficients(q))
    square = sp.factor(b**2 / 4 - c)
    if square.is_negative:
        omega = sp.sqrt(-square)
        return (-b / 2 + sp.I * omega, -b / 2 - sp.I * omega)
    delta = sp.sqrt(square)
    return (-b / 2 - delta, -b / 2 + delta)


def _surd_choices(q: sp.Poly, m: int) -> tuple[Choice, ...]:
    """The choices of a quadratic with two real roots −b/2 ± √(b²/4 − c), taken one by one."""
    K, (_, b, c) = q.domain, _coefficients(q)
    half = K.one / K(2)
    square = b * b / K(4) - c
    negative_product = _sign(K, c) < 0
    root = sp.sqrt(expression(K, square))
    middle = expression(K, b) / 2
    sizes = [root - middle, root + middle] if negative_product else [middle + root, middle - root]
    numbers = not K.is_Composite
    values = [mpmath.mpmathify(sp.N(size, WORKING_DIGITS)) for size in sizes] if numbers else [mpmath.mpf(0)] * 2

    def elements(tower: RootTower) -> list[Nested]:
        delta, mean = tower.square_root((square,)), (b * half,)
        if negative_product:
            return [tower.add(delta, tower.negative(mean)), tower.add(delta, mean)]
        return [tower.add(mean, delta), tower.add(mean, tower.negative(delta))]

    def factor(flips: tuple[int, ...]) -> Callable[[RootTower], Coefficients]:
        def build(tower: RootTower) -> Coefficients:
            one = tower.constant(K.one)
            parts: list[tuple[Coefficients, int]] = []
            for alpha, k in zip(elements(tower), flips, strict=True):
                parts += [([one, alpha], m - k), ([one, tower.negative(alpha)], k)]
            return power_product(tower, parts)

        return build

    return tuple(
        Choice(
            sum(flips),
            factor(flips),
            tuple(z for x, k in zip(values, flips, strict=True) for z in (*(-x,) * (m - k), *(x,) * k))
            if numbers
            else (),
            tuple(z for x, k in zip(sizes, flips, strict=True) for z in (*(-x,) * (m - k), *(x,) * k)),
        )
        for flips in sorted(product(range(m + 1), repeat=2), key=sum)
    )


def _decimal_choices(stable: Sequence[Any], m: int) -> tuple[Choice, ...]:
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


def combinations(groups: Sequence[Group], fixed: Sequence[bool]) -> Iterator[tuple[Choice, ...]]:
    """Yield one choice a group, the Hurwitz factor first, by number of flips; groups that are fixed stay Hurwitz."""
    options = [group.choices[:1] if keep else group.choices for group, keep in zip(groups, fixed, strict=True)]
    yield from sorted(product(*options), key=lambda choices: sum(choice.flips for choice in choices))


def exact_polynomial(K: Any, choices: Sequence[Choice]) -> tuple[RootTower, Coefficients] | None:
    """Return p over a tower of its own; None where a choice has no exact form, or too many roots would nest."""
    tower = RootTower(K)
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
