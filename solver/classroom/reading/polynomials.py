"""Polynomials and transfer functions as other programs write them: coefficients, equations, tf([1], [1 3 2]).

Coefficients stand with the highest power first, as in MATLAB and numpy.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import sympy as sp

from solver.classroom.reading.brackets import are_numbers, by_spaces, matching, split
from solver.symbols import POLYNOMIAL

_FRACTION = re.compile(r"(?:\b\w+\.)*\b(tf|TransferFunction)\s*\(")
_ZPK = re.compile(r"(?:\b\w+\.)*\bzpk\s*\(")
_POLYNOMIAL = re.compile(r"^\s*(?:\w+\.)*(?:Pure)?Poly\s*\(([^,]*)(?:,.*)?\)\s*$", re.DOTALL)
_LIST = re.compile(r"\[|(?:\w+\.)*(?:poly1d|array|Matrix)\(|\\begin")
_ZERO = re.compile(r"^\s*\+?0(?:\.0*)?\s*$")
MAX_DEGREE = 40


def variable_of(ours: Any) -> sp.Symbol | None:
    """Return the variable of a polynomial in s, z or λ, None for anything else."""
    if not isinstance(ours, sp.Expr) or isinstance(ours, sp.MatrixBase):
        return None
    found = [symbol for symbol in ours.free_symbols if isinstance(symbol, sp.Symbol) and symbol.name in POLYNOMIAL]
    return found[0] if len(found) == 1 and ours.is_polynomial(found[0]) else None


def holds_coefficients(text: str) -> bool:
    """Whether a text is a list: in brackets, or with commas, or numbers with spaces between."""
    bare = text.strip()
    pieces = by_spaces(bare)
    listed = len(split(bare, ",")) > 1 or (len(pieces) > 1 and are_numbers(pieces))
    return listed or _LIST.match(bare) is not None


def of_coefficients(coefficients: Sequence[Any], variable: sp.Symbol) -> Any:
    """Return the polynomial of coefficients, the highest power first."""
    highest = len(coefficients) - 1
    return sp.Add(*(each * variable ** (highest - i) for i, each in enumerate(coefficients)))


def one_side(text: str) -> str:
    """Return p of the equation p = 0, any other text as it is."""
    sides = text.split("=")
    if len(sides) == 2 and _ZERO.match(sides[1]) and not _ZERO.match(sides[0]):
        return sides[0]
    return sides[1] if len(sides) == 2 and _ZERO.match(sides[0]) else text


def in_variable(read: tuple[Any, Any], variable: sp.Symbol, known: set[sp.Symbol]) -> tuple[Any, Any]:
    """Return a polynomial and its form in our variable, where they are written in another one that nobody knows."""
    value = read[0]
    own = value.free_symbols - known
    if variable in value.free_symbols or len(own) != 1 or not value.is_polynomial(*own):
        return read
    renamed = dict.fromkeys(own, variable)
    return value.xreplace(renamed), read[1].xreplace(renamed)


def with_quotients(text: str, variable: str) -> str:
    """Return a text with tf([1], [1 3 2]), zpk([], [-1 -2], 1) as quotients, Poly(p, s) as p; other calls stay."""
    if found := _POLYNOMIAL.match(text):
        return found[1]
    text = _with_roots(text, variable)
    while found := _FRACTION.search(text):
        end = matching(text, found.end() - 1)
        arguments = split(text[found.end() : end], ",")
        if len(arguments) < 2:
            return text
        above, below = (_polynomial(each, variable) for each in arguments[:2])
        if not above or not below:
            return text
        text = f"{text[: found.start()]}(({above})/({below})){text[end + 1 :]}"
    return text


def _with_roots(text: str, variable: str) -> str:
    """A text with zpk(zeros, poles, gain) as a quotient of factors."""
    while found := _ZPK.search(text):
        end = matching(text, found.end() - 1)
        arguments = split(text[found.end() : end], ",")
        if len(arguments) < 3:
            return text
        above, below = (_factors(each, variable) for each in arguments[:2])
        if max(len(above), len(below)) > MAX_DEGREE:
            return text
        quotient = f"(({arguments[2]})*{'*'.join(['1', *above])}/({'*'.join(['1', *below])}))"
        text = f"{text[: found.start()]}{quotient}{text[end + 1 :]}"
    return text


def _factors(text: str, variable: str) -> list[str]:
    """The factors of the roots in brackets, or of one root."""
    inside = text.strip().removeprefix("[").removesuffix("]").strip()
    entries = split(inside, ",") if "," in inside else by_spaces(inside)
    return [f"({variable}-({entry.strip()}))" for entry in entries if entry.strip()]


def _polynomial(text: str, variable: str) -> str:
    """A polynomial of its coefficients in brackets; nothing where there are too many of them."""
    text = text.strip()
    if not text.startswith("["):
        return text
    inside = text[1:-1]
    entries = split(inside, ",") if "," in inside else by_spaces(inside)
    highest = len(entries) - 1
    if highest > MAX_DEGREE:
        return ""
    return " + ".join(f"({entry.strip()})*{variable}^{highest - i}" for i, entry in enumerate(entries))
