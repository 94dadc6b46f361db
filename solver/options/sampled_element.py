"""What stands in a sampled loop beside the plant: a quotient in z, or one in s that acts between the samples."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from solver.options.loop_element import LoopElement
from solver.problem.nodes import Node, ScalarNode

if TYPE_CHECKING:
    from solver.problem.context import Context

IN_S = re.compile(r"(?<![A-Za-z_])s(?![A-Za-z0-9_])")
"""The variable s as it stands in a text."""


@dataclass(frozen=True, slots=True)
class SampledElement(LoopElement):
    """A quotient of polynomials in z, proper or not; where `analog`, one in s that has no sampler before it."""

    analog: bool = False

    @property
    def words(self) -> str:
        """What is written, in words."""
        return ("unity, none, " if self.switched else "") + "an expression in z" + (" or in s" if self.analog else "")

    def read(self, node: Node, name: str, context: Context) -> Any:
        """Return the element, None where there is none."""
        text = node.text if isinstance(node, ScalarNode) else ""
        in_s = self.analog and IN_S.search(text) is not None
        return LoopElement.read(self, node, name, context if in_s else replace(context, discrete=True))
