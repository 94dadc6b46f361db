"""What was submitted: a value, and what its decimals may stand for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import sympy as sp


class Decimal(NamedTuple):
    """A decimal as it was written: its value, half a unit of its last digit, and how many digits are significant."""

    number: sp.Rational
    half_unit: sp.Rational
    digits: int


@dataclass(frozen=True)
class Submitted:
    """A value as sympy has it (`value`), the same with a symbol for each decimal (`form`), and what these were.

    `typed` is what was written, on one line; `respelt` tells that it is read as something it does not literally say.
    `others` are what else it may mean: at most one of all readings can count. Of vectors, `eigenvalues` are those that
    they are told to belong to, in their order.
    """

    value: Any
    form: Any
    decimals: Mapping[sp.Symbol, Decimal] = field(default_factory=dict)
    typed: str = ""
    respelt: bool = False
    others: tuple[Submitted, ...] = ()
    eigenvalues: Submitted | None = None

    def with_digits(self, least: int) -> Submitted:
        """Return it with the decimals of fewer significant digits as the exact numbers that they are."""
        coarse = {
            symbol: decimal.number
            for symbol, decimal in self.decimals.items()
            if decimal.digits < least and not self._is_of_a_table(symbol, least)
        }
        if not coarse:
            return self
        kept = {symbol: decimal for symbol, decimal in self.decimals.items() if symbol not in coarse}
        return replace(self, form=replaced(self.form, coarse), decimals=kept)

    def _is_of_a_table(self, symbol: sp.Symbol, least: int) -> bool:
        """Whether a decimal is an entry, rounded to as many places as another one of more digits: [1.09, -0.09]."""
        form: Any = self.form
        entries = form.flat() if isinstance(form, sp.MatrixBase) else form if isinstance(form, list | tuple) else []
        own = self.decimals[symbol]
        alike = [
            decimal
            for each, decimal in self.decimals.items()
            if decimal.half_unit == own.half_unit and decimal.digits > least and _stands_in(each, entries)
        ]
        return bool(alike and own.digits and _stands_in(symbol, entries))


def replaced(value: Any, numbers: Mapping[sp.Symbol, Any]) -> Any:
    """Return a value with numbers in place of symbols, in whatever it is made of."""
    if isinstance(value, Mapping):
        return {name: replaced(each, numbers) for name, each in value.items()}
    if isinstance(value, list | tuple):
        return [replaced(each, numbers) for each in value]
    return value.xreplace(numbers) if isinstance(value, sp.Basic) else value


def _stands_in(symbol: sp.Symbol, entries: Sequence[Any]) -> bool:
    return any(each in (symbol, -symbol) for each in entries)
