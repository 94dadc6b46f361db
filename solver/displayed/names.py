"""What the names on a page stand for: one name has one value."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

CONSTANTS: Mapping[str, Any] = {
    **{"j": sp.I, "e": sp.E, r"\pi": sp.pi, r"\infty": sp.oo},
    r"\mathbf{1}()": (sp.Heaviside(sp.Symbol("t")), sp.Symbol("t")),
}
"""What names stand for everywhere, the unit step among them: a function with its variable."""

VARIABLES: Mapping[str, Any] = {
    **{name: sp.Symbol(name) for name in ("s", "z", "t", "k")},
    r"\lambda": sp.Symbol("lamda"),
}
"""Names that stand for themselves where the page gives them no value."""


@dataclass
class Names:
    """The values of names: those that hold for the whole part (given, or answers), and those displayed so far.

    A name of the part may have two values, what is given and the answer (A of a plant and of its minimal realization).
    """

    fixed: dict[str, list[Any]] = field(default_factory=dict)
    found: dict[str, Any] = field(default_factory=dict)
    bound: set[str] = field(default_factory=set)
    changed: set[str] = field(default_factory=set)

    def value(self, name: str) -> Any:
        """Return what a name stands for; None if that is not known."""
        if name in self.found:
            return self.found[name]
        if name in self.fixed:
            return self.fixed[name][0]
        return CONSTANTS.get(name)

    def is_free(self, name: str) -> bool:
        """Whether a display may give the name a value: it has none of the part, and none was displayed before."""
        return not (name == "I" or any(name in table for table in (self.bound, self.fixed, CONSTANTS)))

    def bind(self, name: str, value: Any) -> None:
        """Let a name stand for a value until a step says that it stands for another one."""
        self.found[name] = value
        self.bound.add(name)

    def forget(self, name: str) -> None:
        """Let a name stand for nothing: another value is to be shown."""
        self.bound.discard(name)
        for known in (self.found, self.fixed):
            known.pop(name, None)
            known.pop(f"{name.partition('(')[0]}()", None)
