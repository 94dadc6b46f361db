"""Polynomials and transfer functions as other programs write them: coefficients, equations, tf([1], [1 3 2]).

Coefficients stand with the highest power first, as in MATLAB and numpy.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import sympy as sp

from solver.classroom.reading.brackets import are_numbers, by_spaces, enclosed, matching, split
from solver.classroom.reading.names import symbols_of
from solver.symbols import POLYNOMIAL

_FRACTION = re.compile(r"(?:\b\w+\.)*\b(tf|TransferFunction)\s*\(")
_MODEL = re.compile(r"(?:\b\w+\.)*\bTransferFunctionModel\s*[\[(]")
_COEFFICIENTS = re.compile(r"(?:\b\w+\.)*\b(?:poly2sym|polyval|poly1d)\s*\(")
_ASCENDING = re.compile(r"\s*(?:\w+\.)*Polynomial\s*\(\s*\[([^\[\]]*)\]\s*(?:,[^()\[\]]*)?\)\s*")
"""Polynomials of numpy and of Julia, with the lowest power first."""
_ZPK = re.compile(r"(?:\b\w+\.)*\bzpk\s*\(")
_PID = re.compile(r"^\s*pid(std)?\s*\(([^()]*)\)\s*$")
_NUM_AND_DEN = re.compile(r"^\s*num\w*\s*[=:]\s*([^=]*?)\s*[,;]\s*den\w*\s*[=:]\s*([^=]*)$", re.IGNORECASE)
_ROOTS = re.compile(r"(?:\b\w+\.)*\bpoly\s*\((?=\s*\[)")
_CONVOLVED = re.compile(r"\s*(?:\w+\.)*(?:conv|convolve|polymul)\s*\((.*)\)\s*", re.DOTALL)
_POLYNOMIAL = re.compile(r"^\s*(?:\w+\.)*(?:Pure)?Poly\s*\(([^,]*)(?:,.*)?\)\s*$", re.DOTALL)
_LIST = re.compile(r"\[|(?:\w+\.)*(?:poly1d|array|Matrix)\(|\\begin")
_SAMPLE_TIME = re.compile(r"\s*(?:(?:dt|Ts?)\s*=\s*)?(?:-1|[\d./eE-]*[1-9][\d./eE-]*|True|Ts?)\s*")
_BAR = re.compile(r"^((?:(?!-{3})[^─—=])*[^-─—=\s])\s*(?:-{3,}|[─—]{2,})\s*([^-─—=\s](?:(?!-{3})[^─—=])*)$", re.DOTALL)
"""A quotient as MATLAB prints it, with a bar of signs between its lines."""
_RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹"
_POWER = re.compile(rf"(?<![^\W\d_])(?:\\?lambda|[szpxλ])\s*(?:(?:\^|\*\*)\s*\{{?(\d{{1,2}})|([{_RAISED}]))")
_ZERO = re.compile(r"^\s*\+?0(?:\.0*)?\s*$")
_NAMED = re.compile(r"\s*([A-Za-zα])_?\{?(\d)\}?\s*=\s*([^=]+)")
_BETWEEN = re.compile(r"\s*[,;\n]\s*|\s+(?:and|und)\s+")
_BELOW = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_ONE = re.compile(r"1(?:\.0*)?")
_GAIN = re.compile(r"[klghn]_?\d{1,2}", re.IGNORECASE)
MAX_DEGREE = 40
MAX_CONVOLVED = 400
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


def with_quotients(text: str, variable: str) -> str:
    """Return a text with tf([1], [1 3 2]), zpk([], [-1 -2], 1) as quotients, Poly(p, s) as p; other calls stay."""
    if found := _POLYNOMIAL.match(text):
        return found[1]
    if _CONVOLVED.fullmatch(text):
        return _polynomial(text, variable) or text
    if found := _ASCENDING.fullmatch(text):
        text = f"poly2sym([{', '.join(split(found[1], ',')[::-1])}])"
    text = _with_controllers(_BAR.sub(r"(\1)/(\2)", text), variable)
    if found := _NUM_AND_DEN.match(text):
        text = f"tf({found[1]}, {found[2]})"
    text = _with_roots_only(text, variable)
    text = _with_coefficients(_with_models(_with_roots(text, variable)), variable)
    while found := _FRACTION.search(text):
        end = matching(text, found.end() - 1)
        arguments = split(text[found.end() : end], ",")
        if len(arguments) < 2 or _is_sampled(arguments[2:], variable):
            return text
        above, below = (_polynomial(each, variable) for each in arguments[:2])
        if not above or not below:
            return text
        text = f"{text[: found.start()]}(({above})/({below})){text[end + 1 :]}"
    return text


def _with_controllers(text: str, variable: str) -> str:
    """MATLAB's pid(K_p, K_i, K_d) and pidstd(K_p, T_i, T_d) in s as sums; any other text as it is."""
    found = _PID.match(text)
    terms = [f"({each.strip()})" for each in split(found[2], ",")] if found else []
    if found is None or variable != "s" or not 0 < len(terms) < 4 or any("=" in each for each in terms):
        return text
    standard = bool(found[1])
    shapes = ("1", "1/({}*s)", "{}*s") if standard else ("{}", "{}/s", "{}*s")
    whole = " + ".join(shape.format(term) for shape, term in zip(shapes, terms, strict=False))
    return f"{terms[0]}*({whole})" if standard else whole


def _is_sampled(more: Sequence[str], variable: str) -> bool:
    """Whether a sample time stands behind what makes up a transfer function in s: tf(1, [1 2], 0.1)."""
    return variable == "s" and any(_SAMPLE_TIME.fullmatch(each) for each in more)


def _with_models(text: str) -> str:
    """A text with TransferFunctionModel[{{{1}}, s + 1}, s] as the quotient."""
    while found := _MODEL.search(text):
        end = matching(text, found.end() - 1)
        first = (split(text[found.end() : end], ",") or [""])[0].strip()
        inside = first[1:-1] if enclosed(first, "{}") else first
        pieces = [f"({_without_braces(each)})" for each in split(inside, ",")]
        if len(pieces) not in (1, 2):
            return text
        text = f"{text[: found.start()]}({'/'.join(pieces)}){text[end + 1 :]}"
    return text


def _without_braces(text: str) -> str:
    text = text.strip()
    while enclosed(text, "{}"):
        text = text[1:-1].strip()
    return text


def _with_coefficients(text: str, variable: str) -> str:
    """A text with poly2sym([1 3 2]) as the polynomial."""
    while found := _COEFFICIENTS.search(text):
        end = matching(text, found.end() - 1)
        first = (split(text[found.end() : end], ",") or [""])[0].strip()
        polynomial = _polynomial(first, variable) if first.startswith("[") else ""
        if not polynomial:
            return text
        text = f"{text[: found.start()]}({polynomial}){text[end + 1 :]}"
    return text


def _with_roots(text: str, variable: str) -> str:
    """A text with zpk(zeros, poles, gain) as a quotient of factors."""
    while found := _ZPK.search(text):
        end = matching(text, found.end() - 1)
        arguments = split(text[found.end() : end], ",")
        if len(arguments) < 3 or _is_sampled(arguments[3:], variable):
            return text
        above, below = (_factors(each, variable) for each in arguments[:2])
        if max(len(above), len(below)) > MAX_DEGREE:
            return text
        quotient = f"(({arguments[2]})*{'*'.join(['1', *above])}/({'*'.join(['1', *below])}))"
        text = f"{text[: found.start()]}{quotient}{text[end + 1 :]}"
    return text


def _with_roots_only(text: str, variable: str) -> str:
    """A text with poly([-1 -2]) as the product of factors."""
    while found := _ROOTS.search(text):
        end = matching(text, found.end() - 1)
        factors = _factors(text[found.end() : end], variable)
        if not factors or len(factors) > MAX_DEGREE:
            return text
        text = f"{text[: found.start()]}({'*'.join(factors)}){text[end + 1 :]}"
    return text


def _factors(text: str, variable: str) -> list[str]:
    """The factors of the roots in brackets, or of one root."""
    inside = text.strip().removeprefix("[").removesuffix("]").replace(";", ",").strip()
    entries = split(inside, ",") if "," in inside else by_spaces(inside)
    return [f"({variable}-({entry.strip()}))" for entry in entries if entry.strip()]


def _polynomial(text: str, variable: str) -> str:
    """A polynomial of its coefficients in brackets; nothing where there are too many of them."""
    text = text.strip()
    if (found := _CONVOLVED.fullmatch(text)) and len(text) <= MAX_CONVOLVED:
        factors = [_polynomial(each, variable) for each in split(found[1], ",")]
        return "*".join(f"({each})" for each in factors) if all(factors) else ""
    if not text.startswith("["):
        return text
    inside = text[1:-1]
    entries = split(inside, ",") if "," in inside else by_spaces(inside)
    highest = len(entries) - 1
    if highest > MAX_DEGREE:
        return ""
    return " + ".join(f"({entry.strip()})*{variable}^{highest - i}" for i, entry in enumerate(entries))
