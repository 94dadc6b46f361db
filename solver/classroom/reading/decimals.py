"""Decimals of a text: each stands for every number that rounds to it, so it has a symbol of its own."""

from __future__ import annotations

import re

import sympy as sp

from solver.classroom.submitted import Decimal
from solver.problem.expressions.tokens import Kind, is_decimal, tokenize

_WHOLE = re.compile(r"\s*[-+−±∓]?\s*(?:\d{1,3}\s*[-+−]\s*)*[1-9]\d{0,2}\s*")


def decimals_of(text: str, count: int, *, whole: bool = False) -> dict[int, tuple[sp.Symbol, Decimal]]:
    """Return a symbol for the decimal at each place of a text, and what it stands for; `count` numbers the first.

    With `whole` a number without a point is rounded as well, 52 of degrees or what is left of 180 - 128.
    """
    decimals = [token for token in tokenize(text) if is_decimal(token)]
    if whole and _WHOLE.fullmatch(text):
        decimals = [token for token in tokenize(text) if token.kind is Kind.NUMBER][-1:]
    return {
        token.at: (sp.Dummy(f"d_{count + i}", real=True), decimal_of(token.text)) for i, token in enumerate(decimals)
    }


def decimal_of(text: str) -> Decimal:
    """Return what a decimal stands for: 0.67 is known to 1/200 and has two digits, 1.5e3 to 50; 0.0 has none."""
    mantissa, _, exponent = text.lower().partition("e")
    places = len(mantissa.partition(".")[2])
    half_unit = sp.Rational(1, 2) * sp.Rational(10) ** (int(exponent or 0) - places)
    return Decimal(sp.Rational(text), half_unit, len(mantissa.replace(".", "").lstrip("0")))
