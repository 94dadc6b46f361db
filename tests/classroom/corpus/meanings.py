"""What a typed answer means, in numbers: nested lists of expressions, words, conditions.

A decimal stands for all numbers that are rounded to it, so it is an unknown within half a unit of its last digit.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from tests.hunt.asked import parsed

DECIMAL = re.compile(r"\d+\.\d*(?:e[+-]?\d+)?|\d+e[+-]?\d+")


class ImpossibleError(Exception):
    """The value cannot be an answer at all: another shape, another kind, a letter that nobody gave."""


Box = tuple[np.ndarray, np.ndarray]
"""The decimals as they are written, and half a unit of the last digit of each."""


@dataclass
class Meaning:
    """A value as numbers, once its decimals and the letters of the question have theirs."""

    raw: Any
    decimals: np.ndarray
    letters: dict[str, complex]

    @property
    def word(self) -> str:
        """The value where it is a word, a verdict or a condition."""
        return str(self.raw)

    @property
    def words(self) -> list[str]:
        """The conditions any of which is to hold."""
        return self.raw if isinstance(self.raw, list) else [self.raw]

    def __call__(self, **more: complex) -> np.ndarray:
        """The numbers, in the shape of the lists; `more` names s, t, k and other letters."""
        counter = iter(range(len(self.decimals)))
        return np.array(self._evaluated(self.raw, counter, self.letters | more), dtype=complex)

    def _evaluated(self, raw: Any, counter: Iterator[int], values: dict[str, complex]) -> Any:
        if isinstance(raw, list):
            return [self._evaluated(each, counter, values) for each in raw]
        known = {}

        def named(_: re.Match[str]) -> str:
            known[name] = self.decimals[i] if (name := f"decimal{(i := next(counter))}") else None
            return f"({name})"

        return _function(DECIMAL.sub(named, raw), tuple(sorted(known | values)))(**known, **values)


def box(raw: Any) -> Box:
    """All decimals in a value, in the order in which they stand."""
    found = [text for each in _texts(raw) for text in DECIMAL.findall(each)]
    return np.array([float(text) for text in found]), np.array([half_unit(text) for text in found])


def half_unit(text: str) -> float:
    """Half a unit of the last digit of a decimal: 0.005 of 2.45, 5e-5 of 1.2e-3."""
    mantissa, _, exponent = text.partition("e")
    places = len(mantissa.partition(".")[2])
    return 0.5 * 10.0 ** (int(exponent or 0) - places)


def _texts(raw: Any) -> Iterator[str]:
    if isinstance(raw, list):
        for each in raw:
            yield from _texts(each)
    else:
        yield raw


_KNOWN: dict[tuple[str, tuple[str, ...]], Any] = {}


def _function(text: str, names: tuple[str, ...]) -> Any:
    """The expression as a function of its names."""
    if (text, names) not in _KNOWN:
        expression = parsed(text)
        if unknown := {str(each) for each in expression.free_symbols} - set(names):
            raise ImpossibleError(f"unknown letters {unknown}")
        if expression.has(sp.zoo, sp.oo, sp.nan):
            raise ImpossibleError("infinite")
        _KNOWN[text, names] = sp.lambdify([sp.Symbol(name) for name in names], expression, "numpy")
    return _KNOWN[text, names]
