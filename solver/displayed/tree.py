"""What written formulas are read into: sums, products, names; and the one spelling of a name."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from solver.formula import latex
from solver.formula.nodes import Node, Scripts


class Unreadable(ValueError):  # noqa: N818 - a refusal with its reason, in words
    """A written formula is not one that can be evaluated; the reason, a text or phrase, says what stands in the way."""

    def __init__(self, reason: str) -> None:
        super().__init__(reason)
        self.reason = reason


@dataclass(frozen=True, slots=True)
class Meaning:
    """A formula: what it is (`kind`), its parts, and the text of a name or the value of a number."""

    kind: str
    parts: tuple[Meaning, ...] = ()
    text: Any = ""


def name_of(item: Node) -> str:
    r"""Return a name in one spelling: K_f and K_{f} are the same. Raises Unreadable for what is no name."""
    if not isinstance(item, Scripts):
        text = latex(item).replace(" ", "")
        if text.endswith("dots"):
            raise Unreadable("an ellipsis")
        return text
    text = name_of(item.base) + "'" * item.primes
    if item.below is None:
        return text
    index = latex(item.below).replace(" ", "")
    return text + "_" + (index if index.startswith("{") else f"{{{index}}}")


def key_of(meaning: Meaning) -> str:
    r"""Return the name of f(x): `x(0)`, `\Phi(t)`."""
    argument = meaning.parts[1]
    return f"{meaning.text}({argument.text})" if argument.kind in ("name", "number") else ""
