"""What is done to matrices in the text of an answer: factors, sums, products, calls such as transpose(…)."""

from __future__ import annotations

import re
from collections.abc import Callable

from solver.classroom.reading.brackets import matching, split
from solver.classroom.reading.grids import (
    SPECIAL,
    each_called,
    entrywise,
    multiplied,
    special_matrix,
    summed,
    times,
    transposed,
)
from solver.classroom.reading.programs import inside_transposition
from solver.problem.nodes import Node, SequenceNode

_TUPLE = re.compile(r"(?<![\w.)\]}])\(|(?<=\))\s*\((?=[^()]*;)")
_LISTED = re.compile(r"\[[^\[\]]*(?:[,;]|\d\s+[-+\d])[^\[\]]*\]")
_MOTION = re.compile(r"(?:\d*\s*[eE]\s*[\^⁻ᵗ]|exp|sin|cos|[tk]\b)")
_ENTRYWISE = re.compile(
    r"(\[[^.*∘⊙]*\](?:\.?')?|\[.*?\](?:\.?')?)\s*(?:\.\*|∘|⊙)\s*(\[.*\](?:\.?'|\^T|\.T)?)", re.DOTALL
)
_ENDING = re.compile(
    r"(.*?(?:[\d)]\s*|\w\s+))[*·×]?\s*((?:[A-Za-z_]\w*\.)?(?:diag|eye|zeros|ones|identity)\s*\([^()]*\))", re.DOTALL
)
_RAISED = re.compile(r"([\^_])\{([^{}]*)\}")
_NAMED = re.compile(r"(?:[A-Za-z_]\w*\.)?(?:diag|eye|zeros|ones|identity)\s*\(")
_NUMBER = re.compile(r"^(\d+(?:\.\d+)?(?:\s*/\s*\d+)?)\s*[*·×]?\s*(?=\[|[a-z]+\()")
_DIVISOR = re.compile(r"/\s*\d+")
MOST_FACTORS = 6
NEAR = 40
"""Characters before a sign that are looked at."""
_PART = re.compile(r"(?:\w+\.)*(Re|re|real|Im|im|imag)\s*[(\[]")
_TRANSPOSE = re.compile(r"(?:\.?['’′]|\^\(?\s*T\s*\)?|ᵀ|\^%T|\.T|\^⊤|\^\\top)\s*$")

_TURNED = re.compile(r"(?:\.?['’′]|\^\(?\s*T\s*\)?|ᵀ|\^%T|\.T|\^⊤)(?!\w)")

Read = Callable[[str], Node]
"""Reads a piece of the text."""


def transposition(text: str, read: Read) -> Node | None:
    """Return the matrix that is transposed, transpose([1 2]) or [1 2]'; None of any other text."""
    inside = inside_transposition(text)
    found_behind = inside is None and len(split(text, ",")) < 2 and _TRANSPOSE.search(text)
    if found_behind:
        inside = text[: found_behind.start()]
    if inside is not None and found_behind and _is_last(with_square_brackets(inside)):
        return None  # the last term of a sum, or the last factor
    whole = read(inside) if inside is not None else None
    return transposed(whole) if isinstance(whole, SequenceNode) else None


def _is_last(text: str) -> bool:
    """Whether what stands behind a text belongs to the last of its terms or factors only."""
    return bool(terms_of(text)[0] or _ENTRYWISE.fullmatch(text) or factors_of(text))


def combined(node: Node, text: str, read: Read) -> Node | None:
    """Return a matrix by its name, of parts, a sum, a product, or one with factors; None of any other text.

    Raises Fault where a number is added to one.
    """
    text = _RAISED.sub(r"\1(\2)", text)  # e^{-t} [1 2; 3 4]
    if (found := SPECIAL.fullmatch(text)) and matching(text, found.start(2) - 1) == len(text) - 1:
        listed = read(f"[{found[2]}]")
        return special_matrix(found[1], listed) if isinstance(listed, SequenceNode) else None
    if (found := _PART.match(text)) and matching(text, found.end() - 1) == len(text) - 1:
        whole = read(text[found.end() : -1])
        return each_called(found[1], whole) if isinstance(whole, SequenceNode) else None
    if "(" in text and len(terms_of(with_square_brackets(text))[0]) > 1:
        text = with_square_brackets(text)
    if adds_a_number(text):
        raise node.fault("a number cannot be added to a matrix")
    terms, signs = terms_of(text)
    return summed([read(term) for term in terms], signs) if terms else _product(text, read)


def _product(text: str, read: Read) -> Node | None:
    """A product of two matrices, or of a matrix and numbers."""
    if (bracketed := _factor_of_sum(text)) is not None:
        return times(read(bracketed[1]), bracketed[0], "")
    if found := _ENTRYWISE.fullmatch(text):
        return entrywise(read(found[1]), read(found[2]))
    if pair := factors_of(text):
        product = multiplied(read(pair[1]), read(pair[2]))
        return times(product, pair[0], "") if product else None
    if (ending := _ENDING.fullmatch(text)) and not _is_sum(ending[1]):
        return times(read(ending[2]), ending[1], "")
    factors = scaled(text) or scaled(with_square_brackets(text))
    return times(read(factors[1]), factors[0], factors[2]) if factors else None


def _factor_of_sum(text: str) -> tuple[str, str] | None:
    """The factor and the sum of e^(-t) (cos(2t) eye(2) + sin(2t) [1 2; 3 4]); None of any other text."""
    starts = [at for at, sign in enumerate(text) if sign == "(" and matching(text, at) == len(text) - 1]
    if not starts or not text.endswith(")") or not text[: starts[0]].strip():
        return None
    factor, inside = text[: starts[0]].strip().rstrip("*·×").strip(), text[starts[0] + 1 : -1]
    matrices = any(_LISTED.search(term) or _NAMED.search(term) for term in terms_of(inside)[0])
    bare = not any(sign in factor for sign in "[]{},;=") and factor[-1:] not in ("/", "^") and not _is_sum(factor)
    return (factor, inside) if matrices and bare and not factor[-1:].isalpha() else None


def scaled(text: str) -> tuple[str, str, str] | None:
    """Return the factors before and after the one matrix of a text, 1/2 [1 2] or [1 2]/2; None where there are none."""
    start = next((at for at in _outside(text) if text[at] == "["), -1)
    if start < 0:
        return None
    end = matching(text, start)
    turned = _TURNED.match(text, end + 1)
    end = turned.end() - 1 if turned else end
    before, after = text[:start].strip().rstrip("*·×").strip(), text[end + 1 :].strip()
    bare = not any(sign in before + after for sign in "[]{},;=")
    called = text[:start][-1:].isascii() and text[:start][-1:].isalpha()  # Sin[t] of Mathematica
    if not bare or called or not (before or after) or end == len(text) or before[-1:] in ("/", "^"):
        return None
    after = f"*{after}" if _MOTION.match(after) else after
    if (after and after[0] not in "*/") or _is_sum(before) or _is_sum(after):
        return None  # of 2 + 4 [3 1] only 4 is a factor
    return before, text[start : end + 1], after


def with_square_brackets(text: str) -> str:
    """Return a text with the brackets of its lists as square ones: -(1, 2), {1, 2}/4, but not f(1, 2)."""
    for at in _outside(text):
        if text[at] == "{":
            end = matching(text, at)
            return f"{text[:at]}[{text[at + 1 : end]}]{text[end + 1 :]}"
    at = 0
    while found := _TUPLE.search(text, at):
        end = matching(text, found.end() - 1)
        inside = text[found.end() : end]
        if end < len(text) and (len(split(inside, ",")) > 1 or len(split(inside, ";")) > 1):
            text = f"{text[: found.end() - 1]}[{inside}]{text[end + 1 :]}"
        at = found.end()
    return text


def factors_of(text: str) -> tuple[str, str, str] | None:
    """Return what stands before the first of several matrices side by side, it and the rest; None of anything else."""
    named = _NAMED.match(text)
    start = 0 if named else text.find("[")
    middle = matching(text, named.end() - 1 if named else start) if start >= 0 else len(text)
    middle = turned.end() - 1 if (turned := _TURNED.match(text, middle + 1)) else middle
    following = text[middle + 1 :].lstrip().lstrip("*·×.@").lstrip()
    if not _are_matrices(following):
        return None
    before = text[:start].strip().rstrip("*·×").strip()
    if number := _NUMBER.match(following):  # A * 1/5 * B
        before, following = f"{before}*{number[1]}" if before else number[1], following[number.end() :]
    return None if _is_sum(before) or before[-1:] in ("/", "^") else (before, text[start : middle + 1], following)


def _are_matrices(text: str) -> bool:
    """Whether a text is a matrix or several of them side by side, of which some may be diag(…)."""
    for _ in range(MOST_FACTORS):
        text = _NUMBER.sub("", text, count=1)
        found = _NAMED.match(text)
        if not found and not text.startswith("["):
            return False
        rest = _TURNED.sub("", text[matching(text, found.end() - 1 if found else 0) + 1 :].strip(), count=1)
        rest = rest.strip()
        if not rest or _DIVISOR.fullmatch(rest):
            return True
        text = rest.lstrip("*·×.@").lstrip()
    return False


def adds_a_number(text: str) -> bool:
    """Whether a number is added to a matrix: 2 + [3, 1]."""
    signs = [at for at in _outside_all(text) if text[at] in "+-−" and _joins_terms(text, at)]
    terms = [text[a:b] for a, b in zip([0, *signs], [*signs, len(text)], strict=True)]
    matrices = [(_LISTED.search(term) or _NAMED.search(term)) is not None for term in terms]
    return len(terms) > 1 and any(matrices) and not all(matrices)


def terms_of(text: str) -> tuple[list[str], list[str]]:
    """Return the terms of a sum in each of which a matrix stands, and their signs; nothing of anything else."""
    terms, signs, start = [], [], 0
    depth = 0
    for at, sign in enumerate(text):
        depth += (sign in "([{") - (sign in ")]}")
        if depth == 0 and sign in "+-−" and _joins_terms(text, at):
            terms.append(text[start:at])
            start = at
    terms = [term.strip() for term in [*terms, text[start:]]]
    signs = ["-" if term[:1] in "-−" else "" for term in terms]
    bare = [term.lstrip("+-−").strip() for term in terms]
    matrices = all(term.endswith("]") or "[" in term or _NAMED.search(term) for term in bare)
    return (bare, signs) if len(bare) > 1 and matrices else ([], [])


def _is_sum(text: str) -> bool:
    """Whether a text has a sign between two terms: 2 + 4, but not -4, e^-t, 2*-3, 1e-3."""
    return any(text[at] in "+-−±" and _joins_terms(text, at) for at in _outside(text))


def _joins_terms(text: str, at: int) -> bool:
    """Whether a sign stands between two terms; not at the beginning, after an operator, or in 1e-3."""
    before = text[max(0, at - NEAR) : at].rstrip()
    exponent = before[-1:] in ("e", "E") and before[-2:-1].isdigit()
    return bool(before) and before[-1] not in "*/^·×(,=" and not exponent


def _outside(text: str) -> list[int]:
    """The places of a text that stand in no round bracket."""
    places, at = [], 0
    while at < len(text):
        if text[at] == "(":
            at = matching(text, at)
        else:
            places.append(at)
        at += 1
    return places


def _outside_all(text: str) -> list[int]:
    """The places of a text that stand in no bracket."""
    places, at = [], 0
    while at < len(text):
        if text[at] in "([{":
            at = matching(text, at)
        else:
            places.append(at)
        at += 1
    return places
