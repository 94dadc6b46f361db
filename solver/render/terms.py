"""A product taken apart the way it is written: sign, number, numerator, denominator, functions of time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import lcm
from typing import Any

import sympy as sp

from solver.render.order import below_zero, factor_rank, has_variable, is_number

Factor = tuple[Any, Any]
"""A base and its exponent."""


@dataclass(slots=True)
class Term:
    """A product ± c · j · (numbers) · (numerator)/(denominator) · (functions).

    `number` is c ≥ 0, rational or a Float; `roots` and `roots_below` are further constants such as √3 and π above and
    below the fraction bar; `functions` are the factors written after the fraction: e^{-2t}, cos t.
    """

    negative: bool = False
    number: Any = sp.S.One
    imaginary: bool = False
    roots: list[Factor] = field(default_factory=list)
    roots_below: list[Factor] = field(default_factory=list)
    above: list[Factor] = field(default_factory=list)
    below: list[Factor] = field(default_factory=list)
    functions: list[Factor] = field(default_factory=list)


def split(product: Any) -> Term:
    """Take a product apart. Its value is unchanged; the factors of each group are in the order of writing."""
    term = Term()
    number: sp.Expr = sp.S.One
    imaginary = 0
    for factor in sp.Mul.make_args(product):
        if factor.is_Number:
            number = factor if number is sp.S.One else number * factor
        elif factor.is_Symbol:
            term.above.append((factor, sp.S.One))
        elif factor is sp.I:
            imaginary += 1
        elif is_number(factor):
            number = number * _place_constant(term, factor)
        else:
            _place(term, *_base_and_exponent(factor))
    if imaginary > 1:
        number = number * (-1) ** (imaginary // 2)
    term.imaginary = imaginary % 2 == 1
    term.negative = below_zero(number)
    term.number = abs(number) if term.negative else number
    _arrange(term)
    return term


def _base_and_exponent(factor: Any) -> Factor:
    return (factor.base, factor.exp) if factor.is_Pow else (factor, sp.S.One)


def _place_constant(term: Term, constant: Any) -> Any:
    """Put a constant above or below; return the rational factor taken out of a sum of roots: (1 + √5)/2 gives 1/2."""
    base, exponent = _base_and_exponent(constant)
    if exponent.is_Rational and exponent.p < 0:
        term.roots_below.append((base, -exponent))
        return sp.S.One
    if exponent is sp.S.One and base.is_Add:
        factor, base = _without_denominator(base)
        term.roots.append((base, exponent))
        return factor
    term.roots.append((base, exponent))
    return sp.S.One


def _without_denominator(constant: Any) -> Factor:
    """Return a rational factor and the rest of a real constant sum; the rest has no denominators, and a plus in it."""
    if constant.has(sp.I, sp.Float):
        return sp.S.One, constant
    parts = [part.as_coeff_Mul() for part in constant.args]
    denominator = lcm(*(coefficient.q for coefficient, _ in parts))
    sign = -1 if all(coefficient < 0 for coefficient, _ in parts) else 1
    if denominator == 1 and sign == 1:
        return sp.S.One, constant
    whole = sp.Add(*(coefficient * denominator * sign * rest for coefficient, rest in parts))
    return sp.Rational(sign, denominator), whole


def common_fraction(constant: Any) -> Any | None:
    """Return (1 + √5)/2 as an unevaluated product of 1/2 and 1 + √5; None if the terms have different denominators."""
    if constant.has(sp.I, sp.Float):
        return None
    denominators = {part.as_coeff_Mul()[0].q for part in constant.args}
    if denominators == {1} or len(denominators) > 1:
        return None
    factor, whole = _without_denominator(constant)
    return sp.Mul(factor, whole, evaluate=False)


def constants_together(terms: list[Any]) -> list[Any]:
    """Return the terms of a sum with its numbers as one fraction, where a sum with powers of e stands below a line."""
    numbers = [term for term in terms if is_number(term)]
    if len(numbers) < 2 or not any(_has_powers_below(each) for each in numbers):
        return terms
    whole = sp.cancel(sp.together(sp.Add(*numbers)))
    return [*(term for term in terms if not is_number(term)), whole]


def _has_powers_below(number: Any) -> bool:
    """Whether a sum with powers of e stands below a fraction line."""
    return number.has(sp.exp, sp.E) and any(each.base.is_Add and each.exp.is_negative for each in number.atoms(sp.Pow))


def _place(term: Term, base: Any, exponent: Any) -> None:
    if exponent.is_Rational and exponent.p < 0:
        term.below.append((base, -exponent))
    elif base.is_Function or isinstance(base, sp.Integral | sp.Derivative) or not exponent.is_number:
        term.functions.append(_as_growth(base, exponent))
    else:
        term.above.append((base, exponent))


def _as_growth(base: Any, exponent: Any) -> Factor:
    """Return (1/2)^k for what sympy keeps as 2^(-k), and (√2/2)^k for 2^(-k/2)."""
    coefficient, rest = exponent.as_coeff_Mul()
    if base.is_Integer and base > 1 and coefficient is not sp.S.One and rest.is_Symbol:
        return base**coefficient, rest
    return base, exponent


def _arrange(term: Term) -> None:
    """Sort the groups; functions stay in the numerator unless the denominator has only parameters."""
    for group in (term.above, term.below, term.functions):
        if len(group) > 1:
            group.sort(key=lambda factor: factor_rank(factor[0]))
    term.roots.sort(key=lambda factor: factor[0].is_Add)
    if any(has_variable(base) or base.has(sp.Function) for base, _ in term.below):
        term.above, term.functions = term.above + term.functions, []


def join_roots(term: Term, *, constants: bool) -> None:
    """Write roots of one index as one, √q √r as √(qr) and √q/√r as √(q/r), where sympy keeps them apart.

    Only roots of what cannot be negative; of numbers only with others beside them, and only if `constants`.
    """
    indices = {exponent.q for group in (term.above, term.below) for base, exponent in group if _is_root(base, exponent)}
    for index in sorted(indices):
        groups = (term.above, term.below) + ((term.roots, term.roots_below) if constants else ())
        roots = [[factor for factor in group if _is_root(*factor, index)] for group in groups]
        if sum(map(len, roots)) > 1:
            _join(term, index, groups, roots)


def _is_root(base: Any, exponent: Any, index: int = 0) -> bool:
    """Whether a factor is a root that may be joined; of this index, if one is named."""
    of_index = exponent.is_Rational and exponent.q > 1 and index in (0, exponent.q)
    return bool(of_index and base.is_nonnegative and (base.is_Integer or not base.is_number))


def _join(term: Term, index: int, groups: Sequence[list[Factor]], roots: Sequence[list[Factor]]) -> None:
    """Put one root in the place of several; whole powers of what stood below it or above it stay outside."""
    first = min((term.above.index(factor) for factor in roots[0]), default=0)
    within = [sp.Mul(*(base ** (exponent.p % index) for base, exponent in each)) for each in roots]
    whole = [[(base, sp.Integer(exponent.p // index)) for base, exponent in each] for each in roots]
    for group, joined in zip(groups, roots, strict=True):
        group[:] = [factor for factor in group if factor not in joined]
    numerators, denominators = sp.Mul(*within[0::2]), sp.Mul(*within[1::2])
    side, radicand = (term.below, denominators) if numerators == 1 else (term.above, numerators / denominators)
    place = first if side is term.above else 0
    side.insert(place, (radicand, sp.Rational(1, index)))
    for outside, factors in zip((term.above, term.below) * 2, whole, strict=False):
        outside[place:place] = [factor for factor in factors if factor[1] > 0]


def like_terms_added(terms: list[Any]) -> list[Any]:
    """Add the constants of terms that differ in these only: e^t/2 + √5 e^t has one coefficient in decimals.

    Coefficients with roots become Floats, so that their sign is known when the terms are put in order. Constants in
    exponents are no difference: e^t + e^{t + 2} is 8.3891 e^t; where nothing is added they stay, as in e^{−(t − 2)}.
    """
    alike: dict[Any, list[tuple[Any, Any, Any]]] = {}
    for term in terms:
        constant, rest = term.as_independent(*term.free_symbols, as_Add=False)
        shift, plain = _without_shift(rest)
        alike.setdefault(plain, []).append((constant, rest, sp.exp(shift)))
    added: list[tuple[Any, Any]] = []
    for plain, found in alike.items():
        if len({rest for _, rest, _ in found}) == 1:
            added.append((sp.Add(*(constant for constant, _, _ in found)), found[0][1]))
        else:
            added.append((sp.Add(*(constant * growth for constant, _, growth in found)), plain))
    return [(constant if constant.is_Rational else evaluated(constant)) * rest for constant, rest in added]


def _without_shift(rest: Any) -> tuple[Any, Any]:
    """The real c of a factor e^{c + …} and the product without e^c; zero and the product itself where there is none."""
    for factor in rest.atoms(sp.exp) if rest.has(sp.exp) else ():
        exponent = factor.args[0]
        shift, varying = exponent.as_independent(*exponent.free_symbols, as_Add=True)
        if varying != 0 and shift != 0 and shift.is_real and factor in sp.Mul.make_args(rest):
            others = (each for each in sp.Mul.make_args(rest) if each != factor)
            return shift, sp.Mul(sp.exp(varying), *others)
    return sp.S.Zero, rest


def multiplied_in(product: Any) -> Any | None:
    """A number times a sum as one sum, where fewer terms are left when those that are alike are added; else None."""
    number, rest = product.as_independent(*product.free_symbols, as_Add=False)
    if not rest.is_Add or not rest.has(sp.exp):
        return None
    added = like_terms_added([number * term for term in rest.args])
    return sp.Add(*added) if len(added) < len(rest.args) else None


def evaluated(constant: Any) -> Any:
    """Return a constant as a Float, or as a sum of Floats with j."""
    return constant.evalf(30, chop=True)
