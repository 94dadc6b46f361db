"""Real and imaginary parts, Re(e^((-1 + 2j)t)), as sums of a formula and its conjugate: all its letters are real."""

from __future__ import annotations

import re
from collections.abc import Callable

import sympy as sp

from solver.classroom.reading.brackets import matching
from solver.problem.expressions import ExpressionError, Names
from solver.problem.expressions.notation import MAX_CHARACTERS
from solver.problem.expressions.tokens import Kind, tokenize
from solver.symbols import COMPLEX

PART = re.compile(r"(?<![A-Za-z_.])(Re|re|real|Real|Im|im|imag)\s*\(")
UNITS = ("i", "j", "I")


def with_real_parts(text: str, names: Names, spelt: Callable[[str], str]) -> str:
    """Return a text with Re(…) and Im(…) as sums, the innermost first; `spelt` gives names as the problem spells them.

    What varies in the complex plane has no such conjugate, and stays as it is.
    """
    end = len(text)
    while found := _last(text, end):
        if names.declares(found[1]):
            end = found.start()
            continue
        close = matching(text, found.end() - 1)
        inside = spelt(text[found.end() : close])
        conjugate = _conjugate(inside, names)
        if conjugate is None or len(text) + 2 * len(inside) > MAX_CHARACTERS:
            return text
        whole = f"(({inside}) + ({conjugate}))/2" if found[1][0] in "Rr" else f"(({inside}) - ({conjugate}))/(2*j)"
        text = f"{text[: found.start()]}({whole}){text[close + 1 :]}"
        end = found.start()
    return text


def _last(text: str, end: int) -> re.Match[str] | None:
    found = None
    for each in PART.finditer(text, 0, end):
        found = each
    return found


def _conjugate(text: str, names: Names) -> str | None:
    """A formula with −j for j; None where a letter of it is complex."""
    try:
        tokens = [token for token in tokenize(text) if token.kind is Kind.NAME]
    except ExpressionError:
        return None
    if names.declares("j") or any(token.text in COMPLEX for token in tokens):
        return None
    pieces, at = [], 0
    for token in tokens:
        if token.text in UNITS and (token.text == "j" or names.variables.get(token.text) == sp.I):
            pieces += [text[at : token.at], "(-j)"]
            at = token.end
    return "".join([*pieces, text[at:]])
