"""What a worded step displays, as data: chains of equalities with the values that were printed into them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

FIRST_MARK = 0xF0000
"""The first of the characters for private use that stand for values in a written formula."""

STANDS = ":="


@dataclass(frozen=True, slots=True)
class Written:
    """A formula as a template writes it: LaTeX in which the character FIRST_MARK + i stands for the value i."""

    latex: str
    values: tuple[Any, ...] = ()


@dataclass(frozen=True, slots=True)
class Displayed:
    """A display a = b = ... of a step: each side a value (an expression, a matrix, a list, `Stated`) or `Written`.

    The relation STANDS says that a name stands for another value from here on; nothing is shown.
    """

    sides: tuple[Any, ...]
    relation: str = "="
