"""Transforms taken apart: what begins when, the terms of each dead time, values at 0+, products for convolution."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.postconditions.linear_algebra import factor_claims
from solver.stated.limits import limit


def of_read_image(found: Sequence[Any], F: Any, s: Any) -> Iterator[Claim | Check]:
    """The terms with their dead times add up to F; the roots of the denominators."""
    yield Claim(sp.Add(*(sp.exp(-each.delay * s) * each.image.whole for each in found)), F)
    for each in found:
        yield from _of_image(each.image, s)


def of_rational_image(found: Any, F: Any, s: Any) -> Iterator[Claim | Check]:
    """Numerator over denominator is F, and so is what is shown."""
    yield Claim(found.whole, F)
    yield from _of_image(found, s)


def _of_image(image: Any, s: Any) -> Iterator[Claim | Check]:
    yield Claim(image.numerator / image.denominator, image.whole)
    yield Claim(image.polynomial(s) + image.rest(s), image.whole)
    given = sp.fraction(sp.together(image.given))[1]
    cancels = sp.degree(given, s) > sp.degree(image.denominator, s)
    yield Check.that("factors that cancel", "counted", image.cancels == bool(cancels))
    for factor in () if image.proper is None else image.proper.factors:
        yield from factor_claims(factor)
        yield Check.that("roots in conjugate pairs", "compared", _are_in_pairs(factor.roots))
    for each in image.exceptions:
        together = sp.numer(sp.together(sp.discriminant(image.denominator, s)))
        factor = sp.numer(sp.together(each.lhs))
        symbols = [] if factor.has(sp.exp) else sorted(each.free_symbols, key=str)
        meets = each.rhs == 0 and sp.rem(together, factor, *symbols) == 0
        yield Check.that("where poles meet", "discriminant", bool(meets))


def _are_in_pairs(roots: Sequence[Any]) -> bool:
    """Whether the roots are as their parts say, and each complex one has its conjugate among them."""
    values = [each.value for each in roots]
    unreal = [each for each in roots if each.kind in ("complex", "decimal") and each.shift != 0]
    told = all(each.value == each.sigma + sp.I * each.shift for each in unreal)
    return told and all(each.sigma - sp.I * each.shift in values for each in unreal)


def of_covered(found: Sequence[Any], image: Any, x: Any) -> Iterator[Check]:
    """Each pole with fractions of its own, with the order of the highest."""
    orders: dict[Any, int] = {}
    for base, power in _bases(image, x):
        if sp.degree(base, x) == 1:
            orders[base] = max(power, orders.get(base, 0))
    own = {x - each.pole: each.order for each in found}
    whole = own == orders and all(len(each.coefficients) == each.order for each in found)
    yield Check.that("poles covered up", "counted", whole)


def _bases(image: Any, x: Any) -> list[tuple[Any, int]]:
    """What stands below the partial fractions, with its power."""
    below = (term.operands[0].operands[1].as_base_exp() for term in image.partial_fractions(x))
    return [(base, int(power)) for base, power in below]


def of_is_found_otherwise(found: bool, image: Any, s: Any) -> Iterator[Check]:
    """A quadratic to a higher power beside others, or several of them, are to be compared or divided."""
    listed = _bases(image, s)
    quadratics = [(base, power) for base, power in listed if sp.degree(base, s) == 2]
    simple = all(power == 1 for _, power in quadratics)
    numbers = all(sp.discriminant(base, s).is_Rational for base, _ in quadratics)
    easy = not quadratics or len(listed) == 1 or (simple and len(quadratics) == 1)
    if easy or not simple or numbers:
        yield Check.that("how coefficients are found", "counted", found == (easy or (simple and numbers)))


def of_pairs_for(found: Sequence[Any], image: Any, x: Any, time: Any, *, discrete: bool) -> Iterator[Check]:  # noqa: ARG001 - as called
    """Pairs of rational functions and functions of time."""
    rational = all(left.is_rational_function(x) and not left.has(time) and not right.has(x) for left, right in found)
    yield Check.that("pairs of a table", "compared", rational)


def of_poles_of(found: Sequence[Any], image: Any, s: Any) -> Iterator[Check]:
    """As many poles as the denominator has, a pair for two, with a coefficient for each power."""
    listed = sum((2 if each.paired else 1) * each.order for each in found)
    kinds = all(each.paired == (each.root.kind in ("complex", "decimal") and each.root.shift != 0) for each in found)
    whole = all(len(each.coefficients) == each.order for each in found)
    degree = sum(int(sp.degree(base, s)) for base, power in _highest(image, s) for _ in range(power))
    yield Check.that("poles of the image", "counted", listed == degree and kinds and whole)


def _highest(image: Any, s: Any) -> list[tuple[Any, int]]:
    orders: dict[Any, int] = {}
    for base, power in _bases(image, s):
        orders[base] = max(power, orders.get(base, 0))
    return list(orders.items())


def of_ratio_of_images(found: Any, image: Any, other: Any) -> Iterator[Claim]:
    """The multiple of the other image is the image."""
    if found is not None:
        yield Claim(found * other.whole, image.whole)


def of_late_image(found: Any, delay: Any, image: Any, s: Any) -> Iterator[Claim]:
    """The image times e^{−Ts}."""
    yield Claim(found, sp.exp(-delay * s) * image)


def of_transform_pieces(found: Sequence[Any], f: Any, t: Any) -> Iterator[Claim]:
    """What begins at each time adds up to the function, and is the sum of its terms in the time since then."""
    smooth = {sp.Heaviside: lambda *_: sp.S.One, sp.DiracDelta: lambda *_: sp.S.Zero}
    whole = f
    for kind, value in smooth.items():
        whole = whole.replace(kind, value)
    yield Claim(sp.Add(*(each.function for each in found)), whole)
    for each in found:
        yield Claim(each.moved.xreplace({t: t - each.delay}), each.function)
        yield Claim(sp.Add(*(term.factor * term.function(t) for term in each.terms)), each.moved)
        step = sp.Heaviside(t - each.delay)
        if each.delay != 0 and sp.expand(f).has(step):
            yield Claim(sp.expand(f).coeff(step), each.function)
    x = sp.Dummy("x", real=True)
    weights = [_impulse(each, f, t) for each in f.atoms(sp.DiracDelta)]
    told = sp.Add(*(each.impulse * sp.exp(-each.delay * x) for each in found))
    if all(weight is not None for weight in weights):
        yield Claim(sp.Add(*(weight * sp.exp(-at * x) for weight, at in filter(None, weights))), told)


def _impulse(impulse: Any, f: Any, t: Any) -> tuple[Any, Any] | None:
    """The weight of an impulse in a function, and its time; none where steps decide."""
    argument = sp.expand(impulse.args[0])
    slope = argument.coeff(t, 1)
    at, factor = -argument.coeff(t, 0) / slope, sp.expand(f).coeff(impulse)
    if factor.has(sp.Heaviside, sp.DiracDelta) or at.is_nonnegative is not True:
        return None
    return factor.subs(t, at) / sp.Abs(slope), at


def of_abscissa_of(found: Any, pieces: Sequence[Any]) -> Iterator[Check]:
    """No term grows faster, and one as fast."""
    rates = [term.growth + (sp.Abs(term.angle) if "h" in term.wave else 0) for each in pieces for term in each.terms]
    yield Check.that("where the integral converges", "compared", (found is None) == (not rates))
    if rates:
        yield Check.that("where the integral converges", "compared", found == sp.Max(*rates))


def of_values_after(found: Any, image: Any, count: int, s: Any) -> Iterator[Claim | Check]:
    """By the initial value theorem, one value after the other."""
    regular, values = found
    rest = image
    above, below = sp.fraction(sp.together(image))
    proper = image == 0 or sp.degree(sp.cancel(above), s) < sp.degree(below, s)
    yield Check.that("values at the start", "counted", len(values) == count and regular == bool(proper))
    for value in values if regular and not image.free_symbols - {s} else ():
        yield Claim(limit(s * rest, s, sp.oo), value)
        rest = sp.cancel(s * rest - value)


def of_factors_for_convolution(found: Sequence[Any], image: Any, s: Any) -> Iterator[Claim]:  # noqa: ARG001 - as called
    """The factors multiplied are the image."""
    if found:
        yield Claim(sp.Mul(*found), image.whole)


def of_acting_pieces(found: Sequence[Any], inputs: Sequence[Any], t: Any, s: Any) -> Iterator[Claim]:  # noqa: ARG001 - as called
    """What acts from each time on is what begins in each input then."""
    for each in found:
        for j, pieces in enumerate(inputs):
            begun = [piece for piece in pieces if piece.delay == each.delay]
            yield Claim(each.functions[j], sp.Add(*(piece.moved for piece in begun)))
            yield Claim(each.impulses[j], sp.Add(*(piece.impulse for piece in begun)))


def of_impulse_balance(
    found: Sequence[Any], a: Any, b: Any, u: Sequence[Any], impulse: Any, s: Any
) -> Iterator[Claim | Check]:
    """The powers of s in a(s) Σ Δₖ/s^{k+1} and in b(s) times the series of the input, the highest first."""
    n = int(sp.degree(a, s))
    yield Check.that("orders of impulses", "counted", len(found) == n)
    jumps = [sp.Dummy(f"jump{k}", real=True) for k in range(n)]
    left = sp.expand(a * sp.Add(*(x / s ** (k + 1) for k, x in enumerate(jumps))))
    right = sp.expand(b * (impulse + sp.Add(*(value / s ** (k + 1) for k, value in enumerate(u)))))
    for order, each in zip(range(n - 1, -1, -1), found, strict=False):
        yield Claim(sp.Add(*(c * jumps[k] for c, k in each.left)), left.coeff(s, order))
        yield Claim(each.right, right.coeff(s, order))
