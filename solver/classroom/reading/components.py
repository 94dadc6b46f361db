"""Values of components beside signals, in the units of circuits: 47 kΩ, 4k7, 100n, 1 µF; and what stands for them.

A letter behind digits is no name of the problem there, and means a power of ten.
"""

from __future__ import annotations

import re
from collections.abc import Callable

_POWERS = {"G": 9, "M": 6, "k": 3, "K": 3, "": 0, "R": 0, "m": -3, "µ": -6, "μ": -6, "u": -6, "n": -9, "p": -12}
_UNITS = r"(?:Ω|Ω|ohms?\b|Ohms?\b|[FV]\b(?!\s*\()|Farads?\b|farads?\b|\\Omega\b)"
_MIDDLE = re.compile(rf"(?<![\w.])(\d+)([GMkKRµμunp])(\d+)(?:\s*{_UNITS})?(?![\w(])")
_VALUE = re.compile(rf"(?<![\w.])(\d+(?:\.\d+)?(?:e[-+]?\d+)?)(?:\s*([GMkKmµμunp]?)\s*{_UNITS}|([GMkKµμunp]))(?![\w(])")


def in_numbers(text: str, is_name: Callable[[str], bool]) -> str:
    """Return a text with numbers in place of values of components; `is_name` tells the names of the problem."""

    def middle(found: re.Match[str]) -> str:
        return found[0] if is_name(found[2]) else f"({found[1]}.{found[3]}*10^({_POWERS[found[2]]}))"

    def value(found: re.Match[str]) -> str:
        prefix = found[2] or found[3] or ""
        if found[3] and is_name(prefix):
            return found[0]
        return f"({found[1]}*10^({_POWERS[prefix]}))" if prefix else found[1]

    return _VALUE.sub(value, _MIDDLE.sub(middle, text))
