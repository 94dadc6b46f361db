"""Texts with the symbols of the quantities as a notation spells them. Templates write `{{ sym.Phi }}`."""

from __future__ import annotations

import re

from solver.symbols import NOTATIONS

SYMBOL = r"\sym{"
"""How a phrase of the program names a symbol of the notation: `$A - B\\sym{K}$`."""

_NAMED = re.compile(r"\\sym\{(\w+)\}(?=([A-Za-z])?)")
_COMMAND = re.compile(r"\\[A-Za-z]+\Z")


def spelled(text: str, notation: str) -> str:
    """Return a text with the symbols that it names, spelled as in the notation."""

    def symbol(found: re.Match[str]) -> str:
        shown = NOTATIONS[notation][found[1]]
        return f"{shown} " if found[2] and _COMMAND.search(shown) else shown

    return _NAMED.sub(symbol, text)


def answer_symbol(name: str, declared: str, notation: str) -> str:
    r"""Return the symbol of an answer: what the task declares (with `\sym{K}` for a quantity), or that of its name."""
    return declared or NOTATIONS[notation].get(name, "")
