"""Other texts for a value that cannot be read as it stands, or has another shape than is asked for.

Nothing that is read already comes here, so no value loses the reading that it has.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

import sympy as sp

from solver.classroom.reading.brackets import split
from solver.classroom.reading.control_laws import coefficients_of, gain_of, law_of
from solver.classroom.reading.expected import Expected
from solver.classroom.reading.latex import NotReadableError, is_latex, translated
from solver.classroom.reading.likeness import is_of_time
from solver.classroom.reading.piecewise import as_steps, with_first_value
from solver.classroom.reading.remarks import behind_equation, of_equation, without_region, without_transformed
from solver.classroom.reading.sentences import concluded, with_true_signs, without_words

_NUMBERED = re.compile(r"^\s*p_?([1-9₁-₉])\s*=\s*([^=]+)$", re.IGNORECASE)
_SUBSCRIPTS = str.maketrans("₁₂₃₄₅₆₇₈₉", "123456789")
_FACTOR = re.compile(
    r"(?:(?<=[=,;])|^|(?<=\band))\s*(?:[αβγμσtsrabcdk]|lambda|alpha|beta)_?[1-9₁-₉]?\s*[*·]?\s*(?=[(\[]|\\begin)"
)
_HIDDEN = (
    re.compile(r"\s+(?:is|are|ist|sind) (?:uncontrollable|not controllable|nicht steuerbar|hidden)\s*\.?$"),
    re.compile(r"\s+(?:is|are|ist|sind) (?:unobservable|not observable|nicht beobachtbar|hidden)\s*\.?$"),
)
_LOST = re.compile(
    r"^\s*(?:it is |the (?:system|pair|plant) is |das system ist )?"
    r"(?:not (?:completely )?(?:controllable|observable)|uncontrollable|unobservable|nicht (?:steuerbar|beobachtbar))"
    r"\s+(?:exactly )?(?:for|if|when|iff|für|wenn)\s+",
    re.IGNORECASE,
)
_SETS = re.compile(r"\}\s*(?:∪|\bund\b|\band\b|,)\s*\{")
_THEN = re.compile(r"\s*(?:→|->|,?\s+(?:then|dann|danach)\b)\s*")
_IDENTITY = re.compile(r"(?<![\w.)\]])I(?:_?\d)?(?=\s*(?:[-+−]\s*\S|\)|$))")
_IDENTITY_FIRST = re.compile(r"(?<![\w.)\]])I\s*[*·]?\s*((?:cos|sin)\s*\([^()]*\))")
_ONLY = re.compile(r"\s*,?\s+\(?(?:only|nur)\)?\s*\.?\s*$")
_OR = re.compile(r"\s+(?:or|oder)\s+")
_EACH = re.compile(
    r"^([^:=]*?)[,:]?\s+\(?(?:each|both|jeweils|beide)\s+(?:(?:with|of|mit)\s+)?(?:(?:algebraic\s+)?(?:multiplicity|mult\.|"
    r"vielfachheit)\s*(\d)|double|twice|doppelt)\)?\s*\.?$",
    re.IGNORECASE,
)
_VECTOR_OF = re.compile(r"^\s*[xv]\s*=\s*(?=\S*\s*[(\[])")


_TWO = re.compile(r"±|\\pm")
_BOTH = re.compile(r"^\s*v_?\{?1\s*[,/]\s*2\}?\s*=\s*")
_MULTIPLICITY = re.compile(
    r",\s*((?:alg\w*\.?\s*)?(?:mult\w*\.?|vielfachheit|vfh\.?)\s*(?:=|of)?\s*\d)(?=\s*(?:[,;.]|$))", re.IGNORECASE
)
_GEOMETRIC = re.compile(r",\s*geom\w*\.?\s*(?:mult\w*\.?|vielfachheit|vfh\.?)\s*(?:=|of)?\s*\d(?=\s*\))", re.IGNORECASE)
_CONJUGATE = re.compile(
    r"\s*(?:,|\+|\band\b|\bund\b|\bplus\b)\s*(?:its |the |das |ihre?\w* |\()?\s*"
    r"(?:(?:complex |komplex )?conj(?:ugates?|\.)?"
    r"|(?:komplex )?konjugierte?s?|c\.\s?c\.|cc|k\.\s?k\.)\)?\s*\.?\s*$",
    re.IGNORECASE,
)
_IMAGINARY = re.compile(r"^(.*?)([-+−])(\s*(?:[ij][^-+−,;]*|[^-+−,;]*[ij]))$")


_CONSTANTS_FIRST = re.compile(r"^[^:]*:\s*(?=[^\W\d]\w*(?:\([tk]\))?\s*=)")
"""C1 = 5, C2 = -3: before the solution."""
_ANGLES_OF_ALL = re.compile(r"^[^,;]*\(\s*(?:2\s*[kqnlm]|[kqnlm]\s*·?\s*360)[^,;=:]*[=:]\s*(?=[^=]*$)")
"""180°(2k + 1)/3 = before the angles that it gives."""


def with_conjugates(text: str) -> str:
    """Return -1 ± 2j for -1 + 2j and its conjugate; "" of any other text."""
    found = _CONJUGATE.search(text)
    parts = _IMAGINARY.match(text[: found.start()].strip()) if found else None
    return f"{parts[1]}±{parts[3]}" if parts else ""


def other_texts(text: str, ours: Any, expected: Expected) -> Iterator[str]:
    """Yield what a text may say otherwise; each is still to be read, and to have the shape of ours."""
    if "for all" in text:
        return
    if is_of_time(ours, expected.name) and not isinstance(ours, sp.MatrixBase) and (steps := as_steps(text)):
        yield steps
    if is_latex(text):
        try:
            text = translated(text)
        except NotReadableError:
            return
        yield text
    for other in _others(text, ours, expected):
        if other and other != text:
            yield other


def _others(text: str, ours: Any, expected: Expected) -> Iterator[str]:
    yield of_equation(text)
    yield without_region(without_transformed(text, expected.name))
    if isinstance(ours, list | sp.Set):
        yield from _of_lists(text, ours, expected)
    if is_of_time(ours, expected.name) or expected.name in ("f", "y"):
        yield with_first_value(text)
    if expected.name == "solution":
        yield _CONSTANTS_FIRST.sub("", text)
    if expected.name == "coefficients":
        yield coefficients_of(text)
    if expected.name == "K":
        yield gain_of(text)
    if expected.name == "u":
        yield law_of(text)
    if isinstance(ours, sp.MatrixBase):
        yield from _of_matrices(text, ours, expected)
    if expected.name.endswith("_modes"):
        yield _HIDDEN[expected.name.startswith("un") and "obs" in expected.name].sub("", text)
    if expected.name == "values":
        yield _LOST.sub("", text)
    if isinstance(ours, list) and "{" in text:
        yield _SETS.sub(", ", text)
    yield _ONLY.sub("", text)
    yield with_true_signs(text)
    yield concluded(text)
    yield without_words(text, expected.name, count=expected.count)


def _of_lists(text: str, ours: Any, expected: Expected) -> Iterator[str]:
    if expected.unit == "°":
        yield _ANGLES_OF_ALL.sub("", text)
    yield behind_equation(text)
    yield with_conjugates(text)
    yield _GEOMETRIC.sub("", _MULTIPLICITY.sub(r" (\1)", text))
    yield _EACH.sub(_each_so_often, text)
    yield _THEN.sub(", ", text)
    if isinstance(ours, list) and ours and isinstance(ours[0], Mapping):
        yield _OR.sub(", ", text)


def _of_matrices(text: str, ours: sp.MatrixBase, expected: Expected) -> Iterator[str]:
    if expected.vectors or expected.name.endswith("_space"):
        yield _FACTOR.sub(" ", _VECTOR_OF.sub("", text))
        if _TWO.search(text):  # v_1,2 = [1; -1 ± 2j]
            bare = _BOTH.sub("", text)
            yield f"{_TWO.sub('+', bare)}, {_TWO.sub('-', bare)}"
    if 1 in ours.shape:
        yield _alike(text, ours.rows * ours.cols)
    if ours.rows == ours.cols:
        yield _symmetric(text, ours.rows)
        yield _IDENTITY.sub(f"eye({ours.rows})", _IDENTITY_FIRST.sub(r"\1 I", text))


def _each_so_often(found: re.Match[str]) -> str:
    """-1 (double), -2 (double) of {-1, -2} each with multiplicity 2."""
    times = found[2] or "2"
    items = re.split(r"\s*(?:[,;]|\band\b|\bund\b)\s*", found[1].strip(" {}[]"))
    return ", ".join(f"{item} (multiplicity {times})" for item in items)


def _alike(text: str, count: int) -> str:
    """The entries of k1 = k2 = 2, where each has its number."""
    *names, value = [each.strip() for each in text.translate(_SUBSCRIPTS).split("=")]
    found = [re.fullmatch(r"[A-Za-z]_?(\d)", name) for name in names]
    numbers = sorted(int(match[1]) for match in found if match)
    whole = len(names) > 1 and numbers == list(range(1, count + 1)) and len(found) == count and "," not in value
    return f"[{', '.join([value] * count)}]" if whole else ""


def _symmetric(text: str, size: int) -> str:
    """The matrix of p1 = …, p2 = …, p3 = …, which stand for its entries on and above the diagonal, row by row."""
    pieces = split(text.translate(_SUBSCRIPTS).strip(), re.compile(r"\s*[,;\n]\s*"))
    found = [_NUMBERED.match(piece) for piece in pieces]
    named = {int(match[1]): match[2].strip() for match in found if match}
    places = [(i, j) for i in range(size) for j in range(i, size)]
    if len(named) != len(pieces) or sorted(named) != list(range(1, len(places) + 1)) or size < 2:
        return ""
    entries = {place: named[k] for k, place in enumerate(places, 1)}
    rows = [", ".join(entries[min(i, j), max(i, j)] for j in range(size)) for i in range(size)]
    return f"[{'; '.join(rows)}]"
