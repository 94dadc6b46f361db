"""How one answer of a question follows from others, declared with the task: A − BK from K, the cost from P."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from solver.derivation.registry import Given

Formula = Callable[["Given[Any, Any]", Mapping[str, Any]], Any]
"""The value of an answer from those that it follows from, which may be anyone's; None where it does not follow."""


@dataclass(frozen=True, slots=True)
class Consequence:
    """The answer `name` follows from the answers `of` by a formula.

    A `symbolic` formula can be formed with letters for their entries. A `completing` one gives what belongs to the
    others where each of them may follow from the rest (A, B and C of a realization).
    """

    name: str
    of: tuple[str, ...]
    formula: Formula
    symbolic: bool = True
    completing: bool = False
