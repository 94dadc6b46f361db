"""The order in which a person writes terms and factors.

Polynomials by falling power (in t, as series are, by rising power); partial fractions and exponentials by decay, the
slowest first; cos before sin; terms with parameters before numbers; the real part before the imaginary one; a leading
minus only where it can't be helped (or would upset a polynomial).
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import lru_cache
from operator import attrgetter
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from solver.render.symbols import VARIED, natural
from solver.symbols import POLYNOMIAL, TIME

OPERATORS = (sp.Integral, sp.Derivative)


def ordered_terms(terms: Iterable[Any]) -> list[Any]:
    """Return the terms of a sum in the order of a person; derivatives and integrals of signals come last."""
    listed = list(terms)
    acted_on = [term for term in listed if any(isinstance(each, OPERATORS) for each in sp.Mul.make_args(term))]
    if not acted_on:
        return _ordered(listed)
    others = [term for term in listed if term not in acted_on]
    rest, last = _ordered(others) if others else [], _by_signal(acted_on)
    return [*last, *rest] if rest and is_negative(rest[0]) and not is_negative(last[0]) else [*rest, *last]


def _ordered(terms: list[Any]) -> list[Any]:
    ranks = sorted(((_rank(term), term) for term in terms), key=lambda pair: pair[0].key)
    polynomial = all(rank.polynomial for rank, _ in ranks)
    if polynomial and any(rank.time_degree > 1 for rank, _ in ranks):
        return [term for rank, term in sorted(ranks, key=lambda pair: pair[0].time_degree)]
    ordered = [term for _, term in ranks]
    if len(ordered) == 2 and any(rank.growth for rank, _ in ranks) and all(map(is_number, ordered)):
        return _positive_first(ordered) if not all(map(is_negative, ordered)) else ordered
    if not is_negative(ordered[0]) or all(map(is_number, ordered)):
        return _real_first(ranks)
    if all(is_negative(term) for term in ordered) or any(rank.imaginary for rank, _ in ranks):
        return _real_first(ranks)
    if len(ordered) > 2 and polynomial:
        if any(rank.main_degree for rank, _ in ranks) or is_negative(ordered[-1]):
            return ordered
        ordered = [term for rank, term in sorted(ranks, key=lambda pair: pair[0].degree)]
    return _positive_first(ordered)


def _by_signal(terms: list[Any]) -> list[Any]:
    """Return terms with integrals or derivatives of signals in the order of these, a positive one in front."""
    names = {term: min(str(each.func) for each in term.atoms(AppliedUndef)) if term.atoms(AppliedUndef) else ""
             for term in terms}  # fmt: skip
    ordered = sorted(terms, key=lambda term: natural(names[term]))
    if is_negative(ordered[0]) and not all(map(is_negative, ordered)):
        return sorted(ordered, key=is_negative)
    return ordered


def _real_first(ranks: list[tuple[_Rank, Any]]) -> list[Any]:
    """Return the terms with the imaginary ones last: σ + jω, for numbers and for letters; of polynomials each power."""
    if all(rank.imaginary for rank, _ in ranks):
        return [term for _, term in ranks]
    return [term for rank, term in sorted(ranks, key=lambda pair: (pair[0].key[:3], pair[0].imaginary))]


def _positive_first(ordered: list[Any]) -> list[Any]:
    """Return the terms with the first positive one in front."""
    first = next(i for i, term in enumerate(ordered) if not is_negative(term))
    return [ordered[first], *ordered[:first], *ordered[first + 1 :]]


@lru_cache(maxsize=4096)
def is_number(expression: Any) -> bool:
    """Whether it has no symbols: sympy looks through all of it each time, and a sum is put in order by many looks."""
    return bool(expression.is_number)


def is_negative(term: Any) -> bool:
    """Whether the term is written with a minus: its coefficient is negative, or each part of it, as in -(1 + √5) x."""
    coefficient, rest = term.as_coeff_Mul()
    sums = [factor for factor in sp.Mul.make_args(rest) if factor.is_Add and rest.is_Mul and is_number(factor)]
    flips = sum(all(is_negative(part) for part in each.args) for each in sums)
    return below_zero(coefficient) != bool(flips % 2)


def below_zero(number: Any) -> bool:
    """Whether a number is negative; sympy's own property deduces all it can of each new number, at some cost."""
    return bool(number.p < 0) if number.is_Rational else bool(number.is_negative)


@dataclass(slots=True)
class _Rank:
    """What decides the place of a term in a sum."""

    accelerations: float = 0
    velocities: float = 0
    main_degree: float = 0
    fraction: int = 0
    rate: float = 0.0
    rate_name: str = ""
    multiplicity: float = 0
    time_degree: float = 0
    degree: float = 0
    names: list[Any] = field(default_factory=list)
    frequency: float = 0.0
    function: int = 0
    growth: float = 0.0
    number: int = 0
    imaginary: bool = False

    @property
    def key(self) -> tuple[Any, ...]:
        return (
            -self.accelerations,
            -self.velocities,
            0 if self.fraction else -self.main_degree,
            self.fraction,
            self.rate_name != "",
            -self.rate,
            self.rate_name,
            self.multiplicity,
            -self.main_degree,
            -self.time_degree,
            -self.degree,
            sorted(self.names),
            self.frequency,
            self.function,
            -self.growth,
            self.number,
        )

    @property
    def polynomial(self) -> bool:
        return not (self.fraction or self.rate or self.rate_name or self.function)


_FUNCTIONS = {"cos": 1, "sin": 2}
_MASS = re.compile(r"[mM](_\w+|\d+)?")
_VELOCITY = re.compile(r"_(dot|ddot|dddot|d\d+)$")


def _rank(term: Any) -> _Rank:
    rank = _Rank()
    for factor in sp.Mul.make_args(term):
        _add_factor(rank, factor)
    return rank


def _add_factor(rank: _Rank, factor: Any) -> None:
    if factor.is_Number:
        return
    if factor is sp.I:
        rank.number, rank.imaginary = 2, True
    elif factor is sp.E or (isinstance(factor, sp.exp) and factor.args[0].is_Rational):
        rank.growth += 1.0 if factor is sp.E else float(factor.args[0])
    elif isinstance(factor, sp.exp):
        _add_rate(rank, *_linear(factor.args[0]))
    elif is_number(factor):
        rank.number = max(rank.number, 2 if factor.has(sp.I) else 1)
    elif factor.is_Symbol:
        _add_symbol(rank, factor, 1)
    elif factor.is_Pow:
        _add_power(rank, factor.base, factor.exp)
    elif factor.is_Function:
        rank.function = max(rank.function, _FUNCTIONS.get(type(factor).__name__, 3))
        if type(factor).__name__ in _FUNCTIONS:
            rank.frequency = abs(_linear(factor.args[0])[0])


def _add_symbol(rank: _Rank, symbol: Any, power: float) -> None:
    if symbol.name in POLYNOMIAL:
        rank.main_degree += power
    elif symbol.name == "t":
        rank.time_degree += power
    else:
        if derived := _VELOCITY.search(symbol.name):
            rank.velocities += power
            rank.accelerations += power * (derived[1] != "dot")
        rank.degree += power
        rank.names += [natural(symbol.name)] * max(1, math.floor(power))


def _add_power(rank: _Rank, base: Any, exponent: Any) -> None:
    if not exponent.is_Rational:
        _add_rate(rank, *_logarithmic_rate(base, exponent))
    elif base.is_Symbol and (exponent.p > 0 or base.name not in POLYNOMIAL):
        _add_symbol(rank, base, float(exponent))
    elif exponent.p < 0:
        rank.fraction = 1
        rank.multiplicity -= float(exponent)
        _add_rate(rank, *_mean_root(base))
    elif base.is_Add:  # (s + 2)² + 9
        rank.main_degree += float(exponent) * any(symbol.name in POLYNOMIAL for symbol in base.free_symbols)
    else:
        _add_factor(rank, base)


def _add_rate(rank: _Rank, rate: float, name: str) -> None:
    rank.rate += rate
    rank.rate_name += name


@lru_cache(maxsize=4096)
def _linear(argument: Any) -> tuple[float, str]:
    """Return the real part of c of an argument c t, and the name of a c with parameters."""
    number, rest = argument.as_coeff_Mul()
    if rest.is_Symbol and rest.name in TIME:  # as nearly always, where `coeff` takes long
        return _real(number)
    time = _first_named(argument, TIME)
    return _real(argument.coeff(time)) if time is not None else (0.0, "")


@lru_cache(maxsize=4096)
def _logarithmic_rate(base: Any, exponent: Any) -> tuple[float, str]:
    """Return ln |b| c of a power b^(c k)."""
    growth, name = _linear(exponent)
    modulus = abs(complex(base)) if base.is_number else 0.0
    if name or not modulus:
        return 0.0, name or str(base)
    return growth * math.log(modulus), ""


@lru_cache(maxsize=4096)
def _mean_root(base: Any) -> tuple[float, str]:
    """Return the mean of the roots of a denominator in s or z: the real part, for a linear factor or a pair."""
    variable = _first_named(base, POLYNOMIAL)
    if variable is None:
        return 0.0, ""
    number, rest = base.as_coeff_Add()
    if rest == variable:  # nearly always
        return _real(-number)
    if variable not in (rest := base - variable).free_symbols:
        return _real(-rest)
    if not base.is_polynomial(variable):
        return 0.0, ""
    poly = sp.Poly(base, variable)
    if not poly.degree():
        return 0.0, ""
    return _real(-poly.coeff_monomial(variable ** (poly.degree() - 1)) / (poly.degree() * poly.LC()))


def _first_named(expression: Any, names: frozenset[str]) -> Any | None:
    """Return of the symbols that have one of the names the first by name, t of t and τ; None where there is none."""
    return min((each for each in expression.free_symbols if each.name in names), key=attrgetter("name"), default=None)


def _real(number: Any) -> tuple[float, str]:
    if number.is_Rational:
        return float(number), ""
    if number.is_number:
        return complex(number).real, ""
    return 0.0, str(number)


@lru_cache(maxsize=4096)
def has_variable(expression: Any) -> bool:
    """Whether it depends on s, z, λ or t, not on parameters alone."""
    return any(symbol.name in POLYNOMIAL or symbol.name == "t" for symbol in expression.free_symbols)


_TRANSFORM = re.compile(r"[UVXY](?:_[a-z]{1,3})?\d*")
"""Transforms of signals, of which nothing is assumed: they stand behind s."""


def factor_rank(base: Any) -> tuple[Any, ...]:
    """Return a key that puts the factors of a product in order: parameters, s, t, powers, sums, e^…, cos, sin.

    Of the parameters masses come first (m g l), and velocities behind sums: (m_1 + m_2) ẋ; variations come last.
    """
    if base.is_Symbol:
        if VARIED.fullmatch(base.name):
            return (7, natural(base.name))
        place = 2 if base.name in POLYNOMIAL else 3 if base.name == "t" else 1.5 if _VELOCITY.search(base.name) else 0
        if _TRANSFORM.fullmatch(base.name) and base.is_real is None:
            place = 3.5
        return (place, not _MASS.fullmatch(base.name), natural(base.name))
    if base.is_Add:
        return (4, (-_mean_root(base)[0],)) if has_variable(base) else (1, ())
    if isinstance(base, sp.exp) or base.is_number or base.is_Pow:
        return (5, ())
    return (6, ((_FUNCTIONS.get(type(base).__name__, 3), 0, ""),))
