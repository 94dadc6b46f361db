"""Polynomials as other programs write them: coefficients, equations, other letters.

Coefficients stand with the highest power first, as in MATLAB and numpy.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import sympy as sp

from solver.classroom.reading.brackets import are_numbers, by_spaces, split
from solver.classroom.reading.names import symbols_of
from solver.symbols import POLYNOMIAL

_LIST = re.compile(r"\[|(?:\w+\.)*(?:poly1d|array|Matrix)\(|\\begin")
_RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹"
_POWER = re.compile(rf"(?<![^\W\d_])(?:\\?lambda|[szpxλ])\s*(?:(?:\^|\*\*)\s*\{{?(\d{{1,2}})|([{_RAISED}]))")
_ZERO = re.compile(r"^\s*\+?0(?:\.0*)?\s*$")
_NAMED = re.compile(r"\s*([A-Za-zα])_?\{?(\d)\}?\s*=\s*([^=]+)")
_BETWEEN = re.compile(r"\s*[,;\n]\s*|\s+(?:and|und)\s+")
_BELOW = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_ONE = re.compile(r"1(?:\.0*)?")
_GAIN = re.compile(r"[klghn]_?\d{1,2}", re.IGNORECASE)
MAX_DEGREE = 40
USUAL_LETTERS = frozenset({"p", "lamda", "x", "q"})
"""Letters in which transfer functions are written where the problem has another one."""


def variable_of(ours: Any) -> sp.Symbol | None:
    """Return the variable of a polynomial in s, z or λ, None for anything else."""
    if not isinstance(ours, sp.Expr) or isinstance(ours, sp.MatrixBase):
        return None
    found = [symbol for symbol in ours.free_symbols if isinstance(symbol, sp.Symbol) and symbol.name in POLYNOMIAL]
    return found[0] if len(found) == 1 and ours.is_polynomial(found[0]) else None


def holds_coefficients(text: str) -> bool:
    """Whether a text is a list: in brackets, or with commas, or numbers with spaces between."""
    bare = text.strip()
    pieces = by_spaces(bare)
    listed = len(split(bare, ",")) > 1 or (len(pieces) > 1 and are_numbers(pieces))
    return listed or _LIST.match(bare) is not None


def of_coefficients(coefficients: Sequence[Any], variable: sp.Symbol) -> Any:
    """Return the polynomial of coefficients, the highest power first."""
    highest = len(coefficients) - 1
    return sp.Add(*(each * variable ** (highest - i) for i, each in enumerate(coefficients)))


def one_side(text: str) -> str:
    """Return p of p = 0, and p - q of p = q where q is of lower degree; any other text as it is."""
    sides = text.split("=")
    if len(sides) == 2 and _ZERO.match(sides[1]) and not _ZERO.match(sides[0]):
        return sides[0]
    if len(sides) == 2 and _highest(sides[0]) > max(_highest(sides[1]), 1):  # s^2 = -3 s - 2
        return f"{sides[0]} - ({sides[1]})"
    return sides[1] if len(sides) == 2 and _ZERO.match(sides[0]) else text


def compares(ours: Any, found: Sequence[Any], known: set[sp.Symbol]) -> bool:
    """Whether a side of an equation is a polynomial of the degree of ours whose coefficients hold gains to be found."""
    variable = variable_of(ours)
    if variable is None or not found:
        return False
    value = found[0].value
    gains = symbols_of(value) - known - {variable}
    if not gains or not all(_GAIN.fullmatch(each.name) for each in gains) or not value.is_polynomial(variable):
        return False
    return bool(sp.degree(value, variable) == sp.degree(ours, variable))


def of_named_coefficients(text: str) -> str:
    """Return [1, a1, a0] of a1 = 5, a0 = 6, which stand before the powers of their indices; "" of any other text."""
    found = [_NAMED.fullmatch(each) for each in split(text.translate(_BELOW).strip(" {}[]()."), _BETWEEN)]
    named = {int(each[2]): each[3].strip() for each in found if each}
    letters = {each[1] for each in found if each}
    if len(named) < len(found) or len(letters) != 1 or len(named) < 2 or sorted(named) != list(range(len(named))):
        return ""
    highest = len(named) - 1
    leading = [] if _ONE.fullmatch(named[highest]) else ["1"]
    return f"[{', '.join([*leading, *(named[each] for each in range(highest, -1, -1))])}]"


def with_leading_one(value: Any, variable: sp.Symbol) -> Any:
    """Return p for the side -p of an equation -p = 0; any other value as it is."""
    if not isinstance(value, sp.Expr) or not value.is_polynomial(variable):
        return value
    return -value if sp.Poly(value, variable).LC() == -1 else value


def _highest(text: str) -> int:
    """The highest power of a variable in a text; 0 where none is raised to one."""
    powers = [found[1] or str(_RAISED.index(found[2])) for found in _POWER.finditer(text)]
    return max((int(each) for each in powers), default=0)


def with_positive_powers(read: tuple[Any, Any], variable: sp.Symbol, degree: int) -> tuple[Any, Any]:
    """Return z² + a z + b for 1 + a z⁻¹ + b z⁻², a polynomial of this degree; any other value as it is."""
    value, below = read[0], sp.Dummy()
    if variable.name != "z" or value.is_polynomial(variable):
        return read
    inverse = value.xreplace({variable: 1 / below})
    if not inverse.is_polynomial(below) or sp.Poly(inverse, below).degree() > degree:
        return read
    value, form = (sp.expand(each * variable**degree) for each in read)
    return value, form


def in_variable(read: tuple[Any, Any], variable: sp.Symbol, known: set[sp.Symbol]) -> tuple[Any, Any]:
    """Return a polynomial and its form in our variable, where they are written in another one that nobody knows."""
    value = read[0]
    own = value.free_symbols - known
    if variable in value.free_symbols or len(own) != 1 or not value.is_polynomial(*own):
        return read
    renamed = dict.fromkeys(own, variable)
    return value.xreplace(renamed), read[1].xreplace(renamed)


def in_usual_letter(read: tuple[Any, Any], ours: Any, known: set[sp.Symbol]) -> tuple[Any, Any]:
    """Return a transfer function and its form in our variable, where they are written in p, or another usual letter.

    A sequence in k may be written in n.
    """
    sampled = {each.name for each in ours.free_symbols} & {*POLYNOMIAL, "k", "t"} == {"k"}
    wanted, usual = ({"k"}, {"n"}) if sampled else (POLYNOMIAL, USUAL_LETTERS)
    variables = [each for each in ours.free_symbols if each.name in wanted]
    own = [each for each in read[0].free_symbols - known if each.name in usual]
    if len(variables) != 1 or len(own) != 1 or variables[0] in read[0].free_symbols:
        return read
    renamed = {own[0]: variables[0]}
    return read[0].xreplace(renamed), read[1].xreplace(renamed)
