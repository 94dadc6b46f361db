"""Square roots of expressions with parameters, as a person writes them, and the signs of what is below the root."""

from __future__ import annotations

from typing import Any

import sympy as sp

from solver.conditions import conditions_of
from solver.exact.linear_algebra.fields import collected, in_sines
from solver.exact.linear_algebra.signs import possible_signs

LARGEST_MULTIPLE = 20
"""Beyond, cos(n arccos c) is shorter than its value."""

LARGEST_RADICAND = 10**12
"""Larger integers below a root are not factored."""


def square_root(radicand: sp.Expr) -> sp.Expr:
    """√radicand with squares taken out, as a person writes it: √12 = 2√3, √(4k/m) = 2√(k/m)."""
    if radicand.is_Rational or not radicand.free_symbols:
        return sp.sqrt(in_sines(radicand))
    number, rest = sp.factor(in_sines(radicand)).as_coeff_Mul()
    turned = -1 if number.is_negative else 1
    outside, inside = sp.sqrt(turned * number), sp.Integer(turned)
    for factor, exponent in rest.as_powers_dict().items():
        whole = exponent // 2 if exponent.is_Integer else 0
        size = (
            -factor if whole % 2 and conditions_of(factor.free_symbols) and possible_signs(factor) == {-1} else factor
        )
        outside *= size**whole
        inside *= factor ** (exponent - 2 * whole)
    return outside * sp.sqrt(_shorter(inside))


def _shorter(inside: sp.Expr) -> sp.Expr:
    """The product with its sums multiplied out where that has fewer terms: (ξ − 1)(ξ + 1) = ξ² − 1."""
    sums, others = sp.sift(sp.Mul.make_args(inside), lambda factor: factor.is_Add, binary=True)
    expanded = sp.expand(sp.Mul(*sums))
    shorter = len(sums) > 1 and len(sp.Add.make_args(expanded)) < sum(len(each.args) for each in sums)
    return sp.Mul(*others) * expanded if shorter else inside


def over_rational(number: sp.Expr) -> sp.Expr:
    """The number, multiplied out, with a rational denominator; roots in it are those of integers.

    Prime by prime the fraction is extended by its denominator with √p turned to −√p. What else stands below is left to
    sympy's radsimp, whose search for a rational value of each denominator takes a hundred times as long.
    """
    above, below = (sp.expand(part) for part in sp.fraction(number))
    roots = [each for each in below.atoms(sp.Pow) if each.exp == sp.S.Half and _is_small(each.base)]
    if not below.xreplace(dict.fromkeys(roots, sp.S.One)).is_Rational:
        return sp.expand(sp.radsimp(number))
    for prime in sorted({p for root in roots for p in sp.factorint(root.base)}):
        turned = {root: -root for root in below.atoms(sp.Pow) if root.base % prime == 0}
        conjugate = below.xreplace(turned)
        above, below = sp.expand(above * conjugate), sp.expand(below * conjugate)
    return sp.expand(above / below)


def _is_small(radicand: sp.Expr) -> bool:
    """Whether the factors of an integer are found at once."""
    return bool(radicand.is_Integer and radicand.is_positive and radicand < LARGEST_RADICAND)


def complex_parts(x: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Re x and Im x; roots of what is known not to be negative are real."""
    powers: list[Any] = list(x.atoms(sp.Pow))
    roots = [p for p in powers if p.exp.is_Rational and p.exp.q == 2 and p.base.free_symbols]
    known = {p: sp.Dummy("r", real=True) for p in roots if -1 not in possible_signs(p.base)}
    real, imaginary = sp.expand(x.xreplace(known)).as_real_imag()
    back = {dummy: p for p, dummy in known.items()}
    return real.xreplace(back), imaginary.xreplace(back)


def without_bars(value: Any) -> Any:
    """An expression or matrix with x or −x in place of |x|, where conditions decide."""
    found = {}
    for each in value.atoms(sp.Abs):
        signs = possible_signs(each.args[0]) if conditions_of(each.free_symbols) else frozenset()
        if len(signs) == 1 or signs == {0, 1}:
            found[each] = each.args[0] * (-1 if -1 in signs else 1)
    return value.xreplace(found) if found else value


def multiple_angles(value: sp.Expr) -> sp.Expr:
    """The value with cos(n arccos c) and sin(n arccos c), n an integer and c a number, by Chebyshev's polynomials."""
    found = {}
    for wave in value.atoms(sp.cos, sp.sin):
        n, angle = wave.args[0].as_coeff_Mul()
        if n.is_Integer and abs(n) <= LARGEST_MULTIPLE and isinstance(angle, sp.acos) and angle.args[0].is_number:
            c, size = angle.args[0], int(abs(n))
            if isinstance(wave, sp.cos):
                found[wave] = sp.expand(sp.chebyshevt(size, c))
            else:
                found[wave] = sp.expand(sp.sign(n) * sp.chebyshevu(size - 1, c) * sp.sqrt(sp.expand(1 - c**2)))
    return value.xreplace(found)


def over_root(value: sp.Expr) -> sp.Expr:
    """A product in the form shown, with ζ/√(1 − ζ²) in place of ζ√(1 − ζ²)/(1 − ζ²)."""
    roots = [each for each in value.atoms(sp.Pow) if each.exp == sp.Rational(1, 2) and each.free_symbols]
    if len(roots) != 1 or not conditions_of(value.free_symbols):
        return collected(value)
    (root,) = roots
    ratio = sp.factor(value / root)
    if not ratio.is_rational_function():
        return collected(value)
    below = sp.factor(ratio * root.base)
    shorter = sp.count_ops(below) < sp.count_ops(ratio)
    return below / root if shorter else ratio * root


def complex_root(radicand: sp.Expr) -> sp.Expr | None:
    """√radicand with Re √ ≥ 0 for a number, real or not; None where parameters leave its sign open."""
    negative = None if radicand.has(sp.I) else is_negative(radicand)
    if negative is not None:
        return sp.I * square_root(-radicand) if negative else square_root(radicand)
    if radicand.free_symbols:
        return None
    a, b = sp.expand(radicand).as_real_imag()
    r = sp.sqrt(sp.expand(a**2 + b**2))
    real, imaginary = (sp.sqrtdenest(sp.sqrt(sp.expand((r + sign * a) / 2))) for sign in (1, -1))
    return real + sp.sign(b) * sp.I * imaginary


def is_negative(radicand: sp.Expr) -> bool | None:
    """Whether the radicand is negative (for general parameters); None where what is known does not decide."""
    factored = sp.factor(in_sines(radicand)) if radicand.free_symbols else radicand
    if factored.is_nonpositive:
        return True
    if factored.is_nonnegative:
        return False
    signs = possible_signs(factored)
    return True if 1 not in signs else False if -1 not in signs else None
