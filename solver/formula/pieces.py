"""Putting strings of LaTeX side by side: parentheses where needed, no more, and signs that merge."""

from __future__ import annotations

import re
from collections.abc import Sequence

_TALL = re.compile(r"\\frac|\\begin|\\int|\\left|\\sum|\\sqrt\{\\frac")
_STRUCTURE = re.compile(r"\\(?:begin|left|right|end)\b|\\[{}]|[{}()\[\]]| (?:[+-]|\\pm|\\otimes|\\ast|\\approx|=) ")
_OPENING = {"{", "(", "[", r"\left", r"\begin", r"\{"}
_ATOM = re.compile(r"(?:\\[A-Za-z]+|[A-Za-z]|[0-9.]+|\\mathrm\{\w+\})(?:_(?:\w|\\[a-z]+|\{[^{}]*(?:\{\w+\})?\}))?\Z")
_ENDS_IN_WORD = re.compile(r"\\[A-Za-z]+\Z")
_ENDS_IN_NUMBER = re.compile(r"(?:(?<![A-Za-z_^\d.])[\d.]+|\^\{[^{}]*\})\Z")


def parenthesized(tex: str) -> str:
    """Put parentheses around, as high as what they hold."""
    return rf"\left({tex}\right)" if _TALL.search(tex) else f"({tex})"


def is_sum(tex: str) -> bool:
    """Whether a formula must stand in parentheses as a factor: it has a sign outside of all brackets."""
    if tex.startswith("-"):
        return True
    if " " not in tex:
        return False
    depth = skip = 0
    for match in _STRUCTURE.finditer(tex):
        piece = match[0]
        if skip:
            skip -= 1
        elif piece in {r"\begin", r"\end"}:
            depth += 1 if piece == r"\begin" else -1
            skip = 2  # the braces of its name
        elif piece in {r"\left", r"\right"}:
            depth += 1 if piece == r"\left" else -1
            skip = 0 if tex[match.end() : match.end() + 1] in {".", "|", "\\"} else 1
        elif piece[0] == " ":
            if depth == 0:
                return True
        else:
            depth += 1 if piece in _OPENING else -1
    return False


def as_factor(tex: str) -> str:
    """Return the formula as it stands in a product."""
    return parenthesized(tex) if is_sum(tex) else tex


def as_base(tex: str) -> str:
    """Return the formula as it stands under an exponent."""
    return tex if _ATOM.match(tex) or _is_matrix(tex) else parenthesized(tex)


def _is_matrix(tex: str) -> bool:
    return tex.startswith(r"\begin{bmatrix}") and tex.find(r"\end{bmatrix}") == len(tex) - len(r"\end{bmatrix}")


def joined(factors: Sequence[str]) -> str:
    """Write factors side by side, with a dot only where two numbers meet and a space only where TeX needs one."""
    result = ""
    for factor in factors:
        fraction_after_number = factor.startswith(r"\frac") and _ENDS_IN_NUMBER.search(result)
        if result and (factor[:1].isdigit() or fraction_after_number):
            result += r" \cdot "
        elif _ENDS_IN_WORD.search(result) and factor[:1].isalpha():
            result += " "
        elif (result.endswith("}") and factor.startswith(r"\mathrm")) or (_upright(result) and factor[:1].isalpha()):
            result += r"\,"
        result += factor
    return result


def _upright(tex: str) -> bool:
    return tex.endswith("}") and tex.rfind(r"\mathrm{") == tex.rfind("{") - len(r"\mathrm") >= 0


def summed(terms: Sequence[str]) -> str:
    """Write terms with their signs merged: `a`, `-b` give `a - b`."""
    result = ""
    for term in terms:
        if not result:
            result = term
        elif term.startswith("-"):
            result += f" - {term[1:].lstrip()}"
        else:
            result += f" + {term}"
    return result or "0"
