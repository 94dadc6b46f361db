"""The output of an amplifier told by its only input: V_o/V_1 = -10, V_o = -R2/R1 V_i = -10 V_i."""

from __future__ import annotations

import re
from collections.abc import Sequence

_OUTPUT = r"[vVuU]_?\{?(?:o|out|a|2)\}?(?:\s*\([ts]\))?"
_INPUT = r"[vVuU]_?\{?(?:i|in|e|1)\}?(?:\s*\([ts]\))?"
_CHAIN = re.compile(rf"\s*({_OUTPUT})\s*=\s*([^=]+)\s*=\s*([^=]+)")
_RATIO = re.compile(rf"\s*{_OUTPUT}\s*/\s*{_INPUT}\s*=\s*(?:[^=]*=\s*)?([^=]+)")
_OTHER = re.compile(r"(?<![A-Za-z0-9_])[vVuU]_?\{?(?:in|i|e)\}?(?![A-Za-z0-9_])")
_RESISTORS = re.compile(r"[A-Za-z]")


def told_by_input(text: str, names: Sequence[str]) -> str:
    """Return the output as a multiple of the only one of `names`; a text of several inputs as it is.

    Of a chain the last side counts, where the ones before it are formulas in resistors.
    """
    if len(names) != 1:
        return text
    (own,) = names
    if found := _RATIO.fullmatch(text):
        return f"({found[1].strip()})*{own}"
    if (found := _CHAIN.fullmatch(text)) and _RESISTORS.search(_OTHER.sub("", found[2])):
        text = f"{found[1]} = {found[3]}"
    return _OTHER.sub(own, text)
