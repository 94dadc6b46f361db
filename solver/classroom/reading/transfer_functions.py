"""Transfer functions as other programs write them: tf([1], [1 3 2]), zpk, num and den, with a dead time.

Coefficients stand with the highest power first, as in MATLAB and numpy.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from solver.classroom.reading.brackets import are_numbers, by_spaces, enclosed, matching, split
from solver.classroom.reading.polynomials import MAX_DEGREE

_FRACTION = re.compile(r"(?:\b\w+\.)*\b(tf|TransferFunction)\s*\(")
_MODEL = re.compile(r"(?:\b\w+\.)*\bTransferFunctionModel\s*[\[(]")
_COEFFICIENTS = re.compile(r"(?:\b\w+\.)*\b(?:poly2sym|polyval|poly1d)\s*\(")
_ASCENDING = re.compile(r"\s*(?:\w+\.)*Polynomial\s*\(\s*\[([^\[\]]*)\]\s*(?:,[^()\[\]]*)?\)\s*")
"""Polynomials of numpy and of Julia, with the lowest power first."""
_ZPK = re.compile(r"(?:\b\w+\.)*\b(?:zpk|ZerosPolesGain)\s*\(")
_PID = re.compile(r"^\s*pid(std)?\s*\(([^()]*)\)\s*$")
_NUM_AND_DEN = re.compile(
    r"^\s*(?:\[\s*(?:num|b)\s*[,\s]\s*(?:den|a)\s*\]\s*=\s*(?:\w+\.)*ss2tf\s*\([^()]*\)\s*[:;,]?\s*)?"
    r"(?P<above>num\w*|b|z[äa]e?hler)\s*[=:]\s*(?P<num>[^=]*?)\s*[,;\n]\s*"
    r"(?:den\w*|(?<=[,;\s])a|nenner)\s*[=:]\s*(?P<den>[^=]*?)\s*;?\s*$",
    re.IGNORECASE,
)
_ZEROS_POLES_AND_GAIN = re.compile(
    r"^\s*(?:z|zeros|nullstellen?)\s*[=:]\s*([^=]*?)\s*[,;\n]\s*(?:p|poles?|pole|polstellen)\s*[=:]\s*([^=]*?)\s*[,;\n]\s*"
    r"(?:k|gain|verstärkung)\s*[=:]\s*([^=,;]*?)\s*;?\s*$",
    re.IGNORECASE,
)
_DELAYED = re.compile(r"^\s*(?:\w+\.)*(?:tf|zpk)\s*\(")
_DELAY = re.compile(r"""\s*['"](?:Input|Output|IO)Delay['"]\s*""")
_ROOTS = re.compile(r"(?:\b\w+\.)*\bpoly\s*\((?=\s*\[)")
_CONVOLVED = re.compile(r"\s*(?:\w+\.)*(?:conv|convolve|polymul)\s*\((.*)\)\s*", re.DOTALL)
_POLYNOMIAL = re.compile(r"^\s*(?:\w+\.)*(?:Pure)?Poly\s*\(([^,]*)(?:,.*)?\)\s*$", re.DOTALL)
_SAMPLE_TIME = re.compile(r"\s*(?:(?:dt|Ts?)\s*=\s*)?(?:-1|[\d./eE-]*[1-9][\d./eE-]*|True|Ts?)\s*")
_BAR = re.compile(r"^((?:(?!-{3})[^─—=])*[^-─—=\s])\s*(?:-{3,}|[─—]{2,})\s*([^-─—=\s](?:(?!-{3})[^─—=])*)$", re.DOTALL)
"""A quotient as MATLAB prints it, with a bar of signs between its lines."""
MAX_CONVOLVED = 400


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
        text = f"tf({_in_brackets(found['num'])}, {_in_brackets(found['den'])})"
    if found := _ZEROS_POLES_AND_GAIN.match(text):
        text = f"zpk({_in_brackets(found[1])}, {_in_brackets(found[2])}, {found[3]})"
    if variable == "s" and _DELAYED.match(text):
        text = _with_delay(text)
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


def _in_brackets(text: str) -> str:
    """Numbers with nothing but spaces between them in brackets, as a program prints them; any other text as it is."""
    numbers = by_spaces(text.strip())
    return f"[{text.strip()}]" if len(numbers) > 1 and are_numbers(numbers) else text.strip()


def _with_delay(text: str) -> str:
    """tf(3, [1 4], 'InputDelay', 2) as a product with the dead time; any other text as it is."""
    start = text.index("(")
    *kept, name, delay = split(text[start + 1 : matching(text, start)], ",") if text.count(",") > 2 else ["", "", ""]
    if not _DELAY.fullmatch(name) or matching(text, start) < len(text.rstrip()) - 1:
        return text
    return f"{text[:start]}({','.join(kept)})*e^(-({delay.strip()})*s)"


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
    entries = [entry.replace("±", sign) for entry in entries for sign in ("+-" if "±" in entry else "+")]
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
