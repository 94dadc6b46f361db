"""Poles: complex numbers in conjugate pairs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from solver.derivation.options import VALUES, OptionKind, Schema
from solver.problem.nodes import Node

if TYPE_CHECKING:
    from sympy import Expr

    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class Poles(OptionKind["tuple[Expr, ...]"]):
    """A list of complex numbers closed under conjugation, read as a tuple; "-3 ± 2j" stands for two."""

    referable: ClassVar[bool] = True

    @property
    def words(self) -> str:
        """What is written, in words."""
        return 'a list of poles, "-3 ± 2j" for a pair'

    @property
    def schema(self) -> Schema:
        """A value or a list of values."""
        return VALUES

    @property
    def example(self) -> str:
        """A pair."""
        return '["-3 ± 2j"]'

    def read(self, node: Node, name: str, context: Context) -> tuple[Expr, ...]:  # noqa: ARG002 - the place says it
        """Return the poles in the order given."""
        return context.conjugate_list(node)
