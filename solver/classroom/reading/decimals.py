"""Decimals of a text: each stands for every number that rounds to it, so it has a symbol of its own."""

from __future__ import annotations

import sympy as sp

from solver.classroom.submitted import Decimal
from solver.problem.expressions.tokens import is_decimal, tokenize


def decimals_of(text: str, count: int) -> dict[int, tuple[sp.Symbol, Decimal]]:
    """Return a symbol for the decimal at each place of a text, and what it stands for; `count` numbers the first."""
    decimals = [token for token in tokenize(text) if is_decimal(token)]
    return {
        token.at: (sp.Dummy(f"d_{count + i}", real=True), decimal_of(token.text)) for i, token in enumerate(decimals)
    }


def decimal_of(text: str) -> Decimal:
    """Return what a decimal stands for: 0.67 is known to 1/200 and has two digits, 1.5e3 to 50; 0.0 has none."""
    mantissa, _, exponent = text.lower().partition("e")
    places = len(mantissa.partition(".")[2])
    half_unit = sp.Rational(1, 2) * sp.Rational(10) ** (int(exponent or 0) - places)
    return Decimal(sp.Rational(text), half_unit, len(mantissa.replace(".", "").lstrip("0")))
