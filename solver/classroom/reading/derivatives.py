"""Derivatives and variations as they are written elsewhere, by the names that the problem has for them."""

from __future__ import annotations

import re
from collections.abc import Mapping

from solver.classroom.reading.brackets import matching
from solver.problem.expressions import Names
from solver.problem.expressions.notation import FUNCTIONS, GREEK

_QUOTIENT = re.compile(
    r"(?<!\w)d(?:\s*(?P<above>\^\(?2\)?|²)\s*|\s+(?!d\w)|)(?P<x>[^\W\d_]\w*)\s*/\s*d\s*(?:t|τ|tau)(?:\^\(?2\)?|²)?(?!\w)"
    r"|(?<!\w)diff\(\s*(?P<y>[^\W\d_]\w*)(?:\(t\))?\s*,\s*t\s*(?:,\s*(?P<twice>2|t))?\s*\)"
)
"""d²x/dt², and diff(x, t, 2) of programs."""
_OF_SUM = re.compile(r"(?<!\w)(?:\(d\)|d)\s*/\s*(?:\(d\s*t\)|d\s*t)\s*[*·]?\s*\(")
_TERM = re.compile(r"\s*(?P<factor>[-+−]?[^'′″’]*?)(?P<x>[^\W\d_]\w*)(?P<primes>['′″’]+)\s*")
_SUMMAND = re.compile(r"[-+−]?[^-+−]+")
_PRIMES = re.compile(r"([^\W\d_]\w*)(['′″’]+)")
_SIGNAL = re.compile(r"(?<![^\W\d])([^\W\d_]\w*)\(\s*[tk]\s*\)")
_INDEX = re.compile(r"(?<=[^\W\d_])(?=\d)")
_NAMES = re.compile(r"[^\W\d_]\w*")
_VARIATION = re.compile(r"(?:δ|(?<![A-Za-z_])delta[ _*])\s*([^\W\d_](?:\w*\d)?(?:_d?dot)?)(?![^\W_])")
_DOTTED = re.compile(r"([^\W\d_])((?:_d*dot)?)")
_ENDINGS = {1: "_dot", 2: "_ddot", 3: "_dddot"}


def with_variations(text: str, names: Names) -> str:
    """Return δx as dx, where the problem has this variation of x."""

    def variation(found: re.Match[str]) -> str:
        return f" d{found[1]}" if f"d{found[1]}" in names.symbols else found[0]

    return _VARIATION.sub(variation, text)


def with_derivatives(text: str, names: Names) -> str:
    """Return x' and x'' as x_dot and x_ddot, where the problem has these; d²x/dt² as x_ddot; x1(t) as x1.

    mx'' is m x'', and d/dt(m x') is it too where m is no function of time.
    """

    def derivative(found: re.Match[str]) -> str:
        order = found[2].count("'") + found[2].count("′") + 2 * found[2].count("″") + found[2].count("’")
        ending = _ENDINGS.get(order, "")
        if alone := only_entry(found[1] + ending, names.symbols):
            return f" {alone} "
        for at in range(len(found[1])):
            name = _known(_latin(found[1][at:]) + ending, names)
            if name in names.symbols:
                return f" {found[1][:at]} {name}" if at or name != found[1] + ending else name
        return found[0]

    def quotient(found: re.Match[str]) -> str:
        name = _latin(found["x"] or found["y"]) + ("_ddot" if found["above"] or found["twice"] else "_dot")
        meant = only_entry(name, names.symbols) or _known(name, names)
        return f"({meant})" if meant in names.symbols else found[0]

    def signal(found: re.Match[str]) -> str:
        known = {_latin(found[1]), found[1].replace("_", "")} & {*names.symbols}
        return found[1] if known and _latin(found[1]) not in FUNCTIONS else found[0]

    text = _QUOTIENT.sub(quotient, _of_sums(text, names))
    return _SIGNAL.sub(signal, _PRIMES.sub(derivative, text))


def _known(name: str, names: Names) -> str:
    """A name as the problem has it, with or without a sign before its index: x1_dot for x_1_dot; else as it is."""
    spellings = (name, name.replace("_", "", 1), _INDEX.sub("_", name, count=1))
    return next((each for each in spellings if each in names.symbols), name)


def only_entry(name: str, known: Mapping[str, object]) -> str:
    """Return p11 of P or p, the only entry of a 1×1 matrix, p11_dot of P_dot; "" of any other name."""
    found = _DOTTED.fullmatch(name)
    if found is None:
        return ""
    letter = found[1].lower()
    entry = f"{letter}11{found[2]}"
    return entry if entry in known and f"{letter}12" not in known and found[1] not in known else ""


def _of_sums(text: str, names: Names) -> str:
    """A text with d/dt(m x' + a y') as m x'' + a y'', where m and a are no functions of time."""
    at = 0
    while found := _OF_SUM.search(text, at):
        end = matching(text, found.end() - 1)
        inside = text[found.end() : end]
        terms = [_TERM.fullmatch(each) for each in _SUMMAND.findall(inside)]
        words = [_latin(word) for each in terms if each for word in _NAMES.findall(each["factor"])]
        moving = any(f"{word}_dot" in names.symbols for word in words)
        if terms and all(terms) and not moving:
            whole = "".join(f"{each['factor']}{each['x']}{each['primes']}'" for each in terms if each)
            text = f"{text[: found.start()]}({whole}){text[end + 1 :]}"
        at = found.start() + 1
    return text


def _latin(name: str) -> str:
    """A name with its Greek letters by their names."""
    return "".join(GREEK.get(sign, sign) for sign in name)
