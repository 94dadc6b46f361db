"""Inputs, outputs and states by number or name."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation.options import OptionKind, Schema
from solver.problem.nodes import Node, scalar
from solver.problem.source import did_you_mean

if TYPE_CHECKING:
    from solver.problem.context import Context

SIZES = {"input": "m", "output": "p", "state": "n"}


@dataclass(frozen=True, slots=True)
class Channel(OptionKind[int]):
    """An input or output by number (from 1) or by name, read as an index from 0; `of` is "input", "output", "state"."""

    of: str

    @property
    def words(self) -> str:
        """What is written, in words."""
        return f"{'a' if self.of == 'state' else 'an'} {self.of} by number from 1 or by name"

    @property
    def schema(self) -> Schema:
        """A number from 1, or a name."""
        return {"anyOf": [{"type": "integer", "minimum": 1}, {"type": "string"}]}

    @property
    def example(self) -> str:
        """The first."""
        return "1"

    def read(self, node: Node, name: str, context: Context) -> int:
        """Return the index, from 0."""
        word = scalar(node).text
        names = context.names(self.of)
        if word in names:
            return names.index(word)
        number = context.size(SIZES[self.of])
        if not re.fullmatch(r"[0-9]{1,3}", word):
            known = f"its name ({', '.join(names)}) or its number from 1" if names else "its number from 1"
            raise node.fault(f"{name} must be an {self.of} by {known}", suggestion=did_you_mean(word, names))
        if int(word) < 1 or (number is not None and int(word) > number):
            count = "there is no such" if number is None else f"there are {number} of them, so it is not a number of an"
            raise node.fault(f"{name}: {count} {self.of}")
        return int(word) - 1
