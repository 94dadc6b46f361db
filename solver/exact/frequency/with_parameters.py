"""A quotient of polynomials with parameters on the imaginary axis, factor by factor: sizes, angles, Bode's form.

What depends on a sign that is not known raises NotExact, which names what must be assumed.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import sympy as sp

from solver.exact.frequency.bode_forms import PER_POWER, BodeForm, Corner
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.stability.inequalities import sign_of, signed_factors


@dataclass(frozen=True)
class FactorOnAxis:
    """A factor of N (`power` > 0) or D (`power` < 0): a + jb at jω, its size, its angle in (−180, 180] degrees."""

    factor: sp.Expr
    power: int
    value: sp.Expr
    size: sp.Expr
    degrees: sp.Expr

    @property
    def shown(self) -> bool:
        """Whether there is something to find: a positive number is its own size, and turns nothing."""
        return self.size != self.factor


@dataclass(frozen=True)
class ParametricFactors:
    """N/D as `number` times ∏ f^m; `factors` holds f, by its coefficients (highest power first), and m.

    f(0) is positive where its sign is known, s itself is a factor.
    """

    number: sp.Expr
    factors: tuple[tuple[tuple[sp.Expr, ...], int], ...]
    s: sp.Symbol

    def at(self, omega: sp.Expr) -> list[FactorOnAxis]:
        """The number, if it is not 1, and each factor at jω, ω > 0. Raises NotExact where a sign must be known."""
        rows = []
        if self.number != 1:
            degrees = sp.S.Zero if decided_sign(self.number) > 0 else sp.Integer(180)
            rows.append(FactorOnAxis(self.number, 1, self.number, _positive(self.number), degrees))
        for coefficients, m in self.factors:
            real, imaginary = _parts(coefficients, omega)
            rows.append(FactorOnAxis(_expression(coefficients, self.s), m, real + sp.I * imaginary,
                                     _size(real, imaginary), _degrees(real, imaginary)))  # fmt: skip
        return rows


def parametric_factors(numerator: sp.Expr, denominator: sp.Expr, s: sp.Symbol) -> ParametricFactors:
    """Return N/D in factors over the rational numbers and the parameters, what is common cancelled.

    Raises NotExact where N is zero, or coefficients are no rational functions of the parameters.
    """
    above, below = sp.fraction(sp.cancel(sp.together(numerator / denominator)))
    if above == 0:
        raise NotExact("frequency/nothing_passes")
    symbols = sorted((above.free_symbols | below.free_symbols) - {s}, key=str)
    try:
        polynomials = [sp.Poly(p, s, *symbols, domain=sp.QQ) for p in (above, below)]
    except (sp.PolynomialError, sp.CoercionFailed):
        raise NotExact("frequency/parameters", names=symbols) from None
    number, found = sp.S.One, []
    for p, sign in zip(polynomials, (1, -1), strict=True):
        constant, factors = p.factor_list()
        number *= constant**sign
        for factor, m in factors:
            listed = sp.Poly(factor.as_expr(), s).all_coeffs()
            if len(listed) == 1:
                number *= listed[0] ** (sign * m)
                continue
            if listed != [1, 0] and sign_of(_lowest(listed)) == -1:
                listed = [sp.expand(-c) for c in listed]
                number *= (-1) ** m
            found.append((tuple(listed), sign * m))
    return ParametricFactors(number, tuple(found), s)


def parametric_bode_form(L: ParametricFactors) -> BodeForm:
    """Return Bode's form, its corners not in order yet, without slopes; raises NotExact where roots are not known."""
    gain, power = L.number, 0
    corners: list[Corner] = []
    for coefficients, m in L.factors:
        if coefficients[-1] == 0:
            power += m
            continue
        gain *= coefficients[-1] ** m
        corners += _corners(coefficients, m, L.s)
    return BodeForm(sp.factor(gain), power, tuple(corners), ())


def with_corners_in_order(form: BodeForm) -> BodeForm:
    """Return the form with rising corners and the slopes; raises NotExact where parameters leave the order open."""
    corners = _rising(form.corners)
    slopes = [PER_POWER * form.power]
    for place in dict.fromkeys(each.omega for each in corners):
        slopes.append(slopes[-1] + sum(each.change for each in corners if each.omega == place))
    return replace(form, corners=tuple(corners), slopes=tuple(slopes))


def decided_sign(x: sp.Expr) -> int:
    """The sign of x for all values of the parameters; raises NotExact where it is not the same for all, or zero."""
    found = sign_of(x)
    if not found:
        raise NotExact("frequency/sign_not_known", what=_undecided(x))
    return found


def _undecided(x: sp.Expr) -> sp.Expr:
    """The factors of x whose sign is not known, as polynomials; x itself where there are none."""
    if not x.is_rational_function():
        return x
    factors = [factor for factor, exponent in signed_factors(x) if exponent % 2 and sign_of(factor) is None]
    return sp.Mul(*factors) if factors else x


def _lowest(coefficients: Sequence[sp.Expr]) -> sp.Expr:
    """f(0), or for f without one the leading coefficient."""
    return coefficients[-1] if coefficients[-1] != 0 else coefficients[0]


def _expression(coefficients: Sequence[sp.Expr], s: sp.Symbol) -> sp.Expr:
    return sp.Add(*(c * s**i for i, c in enumerate(reversed(coefficients))))


def _parts(coefficients: Sequence[sp.Expr], omega: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Real and imaginary part of f(jω)."""
    parts = [sp.S.Zero, sp.S.Zero]
    for i, c in enumerate(reversed(coefficients)):
        parts[i % 2] += (-1) ** (i // 2) * sp.cancel(c * omega**i)
    real, imaginary = (min(part, sp.cancel(part), key=sp.count_ops) for part in parts)
    return real, imaginary


def _positive(x: sp.Expr) -> sp.Expr:
    """|x| of a quantity whose sign is known."""
    return x if decided_sign(x) > 0 else -x


def _size(real: sp.Expr, imaginary: sp.Expr) -> sp.Expr:
    """√(a² + b²), ω and what is known to be positive taken from below the root."""
    if real == 0 and imaginary == 0:
        return sp.S.Zero
    if real == 0 or imaginary == 0:
        return sp.Abs(real + imaginary) if sign_of(real + imaginary) is None else _positive(real + imaginary)
    square = sp.cancel(real**2 + imaginary**2)
    if len(square.free_symbols) == 0 or square.is_Mul or square.is_Pow:
        return sp.sqrt(square)
    common = sp.factor_terms(square)
    if common.is_Mul:
        return sp.sqrt(common)
    return sp.sqrt(real**2 + imaginary**2)


def _degrees(real: sp.Expr, imaginary: sp.Expr) -> sp.Expr:
    """The angle of a + jb, in (−180, 180]: an arctangent where the signs tell the quadrant, else atan2."""
    half_turn = sp.Integer(180)
    side, height = sign_of(real), sign_of(imaginary)
    if side == 0 and height == 0:
        return sp.S.Zero
    if imaginary == 0 and side:
        return sp.S.Zero if side > 0 else half_turn
    if real == 0 and height:
        return sp.Integer(90 * height)
    if side == 1:
        return half_turn * sp.atan(sp.cancel(imaginary / real)) / sp.pi
    if side == -1 and height:
        return half_turn * sp.atan(sp.cancel(imaginary / real)) / sp.pi + height * half_turn
    return half_turn * sp.atan2(imaginary, real) / sp.pi


def _corners(coefficients: Sequence[sp.Expr], m: int, s: sp.Symbol) -> Iterator[Corner]:
    """The corners of a factor of first order, of a pair, or of two real roots."""
    if len(coefficients) == 2:
        a, b = coefficients
        ratio = sp.cancel(a / b)
        size = ratio * decided_sign(sp.cancel(a * b))
        yield Corner(sp.cancel(1 / size), 1 + ratio * s, m, None)
        return
    if len(coefficients) > 3:
        raise NotExact("frequency/factor_with_parameters", p=_expression(coefficients, s))
    a, b, c = coefficients
    square = sp.cancel(c / a)
    if b == 0 and decided_sign(square) > 0:
        omega = sp.sqrt(square)
        yield Corner(omega, 1 + s**2 / square, m, sp.S.Zero)
        return
    under = sp.factor(b**2 - 4 * a * c)
    if decided_sign(under) < 0:
        omega = sp.sqrt(square)
        yield Corner(omega, 1 + sp.cancel(b / c) * s + s**2 / square, m, sp.cancel(b / (2 * a)) / omega)
        return
    for sign in (1, -1):
        root = (-b + sign * sp.sqrt(under)) / (2 * a)
        yield Corner(_positive(root), 1 - s / root, m, None)


def _rising(corners: Sequence[Corner]) -> list[Corner]:
    """Corners in order, zeros before poles, equal ones with one formula."""
    listed: list[Corner] = []
    for each in corners:
        same = (other.omega for other in listed if sp.factor(each.omega**2 - other.omega**2) == 0)
        one = replace(each, omega=next(same, each.omega))
        place = next((i for i, other in enumerate(listed) if _comes_before(one, other)), len(listed))
        listed.insert(place, one)
    return listed


def _comes_before(one: Corner, other: Corner) -> bool:
    if one.omega == other.omega:
        return one.power > other.power
    sign = sign_of(sp.factor(one.omega**2 - other.omega**2)) or sign_of(sp.cancel(one.omega - other.omega))
    if not sign:
        raise NotExact("frequency/order_of_corners", one=one.omega, other=other.omega)
    return sign < 0


__all__ = [
    "FactorOnAxis",
    "ParametricFactors",
    "decided_sign",
    "parametric_bode_form",
    "parametric_factors",
    "with_corners_in_order",
]
