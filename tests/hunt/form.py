"""The form of an answer: what a person would not write, seen in the value of the JSON and in what is printed."""

import re
from collections.abc import Iterator
from math import gcd
from typing import Any

import sympy as sp

from tests.hunt.solved import Solved

PRINTED = {
    r"1\.0 ?\\cdot": "1.0 times",
    r"- ?-": "two signs",
    r"\+ ?-": "plus minus",
    r"- ?\\left\(- ?[^()]*\\right\)(?!\^)": "minus of a negative",
    r"\.\d*0{6}": "zeros after the point",
    r"\\frac\{[^{}]*\}\{1\}": "a denominator 1",
}
LARGE = 10**6


def ugly(one: Solved) -> Iterator[str]:
    """What is wrong with the form of the answers."""
    decimals_typed = re.search(r"\d\.\d", str(one.question.options) + str(one.question.system)) is not None
    decimals = decimals_typed or any(re.search(r"\d\.\d", answer.value) for answer in one.work.answers)
    powers = re.search(r"A\^\d\d", str(one.question.options)) is not None  # of which the numbers are large
    for answer in one.work.answers:
        if re.search(r"\d\.\d", answer.tex) and not decimals:
            yield f"{answer.name}: exact, but shown in decimals: {answer.tex}"
        for pattern, said in PRINTED.items():
            if re.search(pattern, answer.tex):
                yield f"{answer.name}: {said} in {answer.tex}"
    for name, value in one.values.items():
        for entry in entries_of(value):
            yield from (f"{name}: {said} in {entry}" for said in of_entry(entry, decimals_typed or powers))


def entries_of(value: Any) -> Iterator[sp.Expr]:
    """All expressions in an answer."""
    if isinstance(value, sp.MatrixBase | list | tuple):
        for each in value:
            yield from entries_of(each)
    elif isinstance(value, dict):
        yield from entries_of(list(value.values()))
    elif isinstance(value, sp.core.relational.Relational):
        yield from entries_of(list(value.args))
    elif isinstance(value, sp.Expr):
        yield value


def of_entry(entry: sp.Expr, large_numbers: bool) -> Iterator[str]:
    """What a person would write otherwise in one expression."""
    if entry.has(sp.atan2):
        yield "atan2"
    for f in entry.atoms(sp.sin, sp.cos):
        if f.is_number and f.has(sp.acos, sp.asin, sp.atan):
            yield "a trigonometric function of an inverse one"
    for each in entry.atoms(sp.Pow):
        if each.exp == sp.Rational(1, 2) and each.is_number and sp.sqrtdenest(each) != each:
            yield "nested roots that denest"
        if each.exp == sp.Rational(1, 2) and each.base.is_Add and sp.factor(each.base).is_Pow:
            yield "the root of a square"
        if each.exp == -1 and each.base.is_Add and each.base.free_symbols and sp.factor(each.base).is_Pow:
            yield "a square below, multiplied out"
    for product in entry.atoms(sp.Mul):
        bases = [factor.as_base_exp()[0] for factor in product.args]
        if any(base.free_symbols and bases.count(base) > 1 for base in bases):
            yield "a power in two parts"
    large = [abs(n.p) for n in entry.atoms(sp.Integer)] + [n.q for n in entry.atoms(sp.Rational)]
    if not large_numbers and max(large, default=0) > LARGE:
        yield "large integers"
    yield from uncancelled(entry)
    if any(abs(each - round(each)) < 1e-12 * abs(each) for each in entry.atoms(sp.Float) if abs(each) > 0.5):
        yield "a whole number as a decimal"
    yield from uncollected(entry)


def uncancelled(entry: sp.Expr) -> Iterator[str]:
    """Common factors of numerator and denominator, of a rational function."""
    if entry.atoms(sp.Function) or not entry.free_symbols or entry.has(sp.Float):
        return
    top, bottom = sp.fraction(entry)
    if bottom.free_symbols and entry.is_rational_function():
        common = sp.gcd(sp.expand(top), sp.expand(bottom))
        if common.free_symbols:
            yield f"an uncancelled factor {common}"
        contents = [sp.Poly(sp.expand(part)).content() for part in (top, bottom) if part.free_symbols]
        if len(contents) == 2 and all(c.is_Integer for c in contents) and gcd(*map(int, contents)) > 1:
            yield "an uncancelled number"


def uncollected(entry: sp.Expr) -> Iterator[str]:
    """Several terms of one function of time with numbers as their factors."""
    t = {sp.Symbol("t"), sp.Symbol("k")} & entry.free_symbols
    if not entry.is_Add or not t:
        return
    moving = [term.as_independent(*t, as_Add=False)[1] for term in entry.args]
    numbers = [term.as_independent(*t, as_Add=False)[0] for term in entry.args]
    for i, each in enumerate(moving):
        if each != 1 and each in moving[:i] and numbers[i].is_number:
            yield f"several terms of {each}"
            return
