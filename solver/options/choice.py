"""One of some words."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation.options import ImpliedKind, Schema
from solver.problem.nodes import Node, ScalarNode, shown
from solver.problem.source import did_you_mean

if TYPE_CHECKING:
    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class Choice(ImpliedKind[str]):
    """One of some words; the first is meant where the option says nothing else."""

    choices: tuple[str, ...]

    @property
    def implied(self) -> str:
        """The first word."""
        return self.choices[0]

    @property
    def words(self) -> str:
        """What is written, in words."""
        return "one of " + ", ".join(self.choices)

    @property
    def schema(self) -> Schema:
        """One of the words; a word of digits may be written as a number."""
        return {"enum": [*self.choices, *(int(word) for word in self.choices if word.isdigit())]}

    @property
    def example(self) -> str:
        """The first word."""
        return self.choices[0]

    def read(self, node: Node, name: str, context: Context) -> str:  # noqa: ARG002 - a word is a word
        """Return the word."""
        word = node.text if isinstance(node, ScalarNode) else ""
        if word not in self.choices:
            message = f"{name} must be {self.words}, not {shown(node)}"
            raise node.fault(message, suggestion=did_you_mean(word, self.choices) if word else "")
        return word
