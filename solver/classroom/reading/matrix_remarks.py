"""Matrices with what is told beside them: remarks behind them, their entries by name, equations they are found by."""

from __future__ import annotations

import re

import sympy as sp

from solver.classroom.reading.brackets import cells, enclosed, split
from solver.problem.expressions.notation import FUNCTIONS
from solver.symbols import POLYNOMIAL, TIME

_REMARK = re.compile(r"(?<=[\])])\s*,?\s*(?:\(([^()\d=<>]*)\)|(?:%|#|//)\s*([^\d=<>]*))\s*\.?$")
_REASON = re.compile(
    r"(?<=[\])])\s*[,;.:]?\s*\(?\b(?:check|proof|test|probe|kontrolle|since|because|as|denn|weil|da)\b(?!\s*\w*\s*(?:\[|$)).*$",
    re.IGNORECASE | re.DOTALL,
)
_DENIES = re.compile(
    r"\b(?:not|no|nicht|kein\w*|or|oder|wrong|false|falsch|instead|statt\w*|but|aber)\b|\?", re.IGNORECASE
)
_CHANGES = re.compile(
    r"\b(?:not|no|nicht|kein\w*|or|oder|maybe|vielleicht|wrong|false|falsch|transpos\w*|negativ\w*|minus|times|mal)\b|[?\[\]]",
    re.IGNORECASE,
)
_NAMED = re.compile(
    r"^(\s*[^\W\d]\w*\s*=\s*)[\[(]\s*([^\W\d]\w*(?:[\s,;]+[^\W\d]\w*)*)\s*[\])](?:\^T|'|ᵀ)?"
    r"\s*[,;:]?\s*(?:with|mit|where|wobei)?\s*[:,]?\s*(?=[^\W\d]\w*\s*=)"
)
_ENTRY = re.compile(r"\s*([^\W\d]\w*)\s*=\s*([^=]*\S)\s*")
_PIECES = re.compile(r"\s*[,;\n]\s*|\s+(?:and|und)\s+")
_PRODUCT = re.compile(
    r"\s*((?:A\s*(?:\^?\s*[({]?\d[)}]?|[²³⁴])?)?)\s*[*·]?\s*[Bb]\s*=\s*([(\[].*[)\]])(?:\^T|'|ᵀ)?\s*", re.DOTALL
)
_POWERS = str.maketrans("²³⁴", "234")
_CONCLUDED = re.compile(r"^.*(?:→|->|⇒|=>|⟹)\s*(?=[^\W\d]\w*\s*=)", re.DOTALL)
_WITH = re.compile(r"\s*,?\s*\b(?:with|where|mit|wobei)\b\s*|\s*:\s+")
_GIVEN = re.compile(r"\s*([^\W\d]\w*(?:\s*\^\s*[({]?-1[)}]?)?)\s*=\s*(\[.*\])\s*", re.DOTALL)
_LETTERS = re.compile(
    r"\s*[,;:|]?\s*(?:with |mit |for |für )?(?:[a-zα-ω]_?\d?[,\s]+)*[a-zα-ω]_?\d?\s*"
    r"(?:∈|\bin\b)\s*(?:R|ℝ|IR)\s*(\}?)\s*\.?$"
)
_FACTOR = re.compile(r"(?<![\w)\]])([a-zα-ω]_?[1-9₁-₉]?)\s*[*·]?\s*(?=[(\[][^()\[\]]*[,;\s])")
_NAME = re.compile(r"^\s*[xv]\s*=\s*")
_STAR = re.compile(r"(?<=[\s;,\[])[*⋆∗](?=[\s;,\]])")
_AS_ABOVE = ("sym", "sym.", "symm.", "symmetric", "symmetrisch")
_RATE = re.compile(r"^\s*(?:x_dot|ẋ|x['′]|dx/dt|x(?:_?\{?k\s*\+\s*1\}?|\(k\s*\+\s*1\))|y)\s*(?:\(t\))?\s*=\s*")
_OF_STATES = re.compile(r"(?<=[\])])\s*[*·]?\s*x(?:\([tk]\)|_k)?\s*$")
_OF_INPUTS = re.compile(r"(?<=[\])])\s*[*·]?\s*u(?:\([tk]\)|_k)?\s*$")
_BLOCK = re.compile(r"(?<!\w)J_?([1-6])\s*\(([^(),;]*)\)")
_ON_DIAGONAL = re.compile(
    r"^\s*([^()\[\]]*?)\s*,?\s+(?:on|auf)\s+(?:the|der)\s+(?:main\s+)?(?:haupt)?diagonal(?:en|e)?\s*\.?$", re.IGNORECASE
)
_BETWEEN = re.compile(r"\s*[,;\n]\s*")
_ITS_NAME = re.compile(r"\\?[^\W\d]\w*\s*(?:\([tk]\))?")
_WORDS = re.compile(r"[^\W\d]\w*")
_OF_MOTION = POLYNOMIAL | TIME | {"e", "j", "pi", "π", *FUNCTIONS}
"""Words that may stand in a value, and name nothing else."""


def without_remark(text: str) -> str:
    """Return a matrix without what is said of it behind it, [10 4] (Ackermann), [10 4] since 2 + k1 = 12; else ""."""
    if (reason := _REASON.search(text)) and not _DENIES.search(reason[0]):
        return text[: reason.start()]
    found = _REMARK.search(text)
    said = (found[1] or found[2] or "") if found else ""
    return text[: found.start()] if found and said.strip() and not _CHANGES.search(said) else ""


def of_products(text: str) -> str:
    """Return the columns of B = (0, 1), AB = (1, -3), beside each other; "" of any other text."""
    found = [_PRODUCT.fullmatch(piece) for piece in split(text, _BETWEEN)]
    powers = [each[1].translate(_POWERS) if each else "" for each in found]
    wanted = ["", "A", *(f"A{k}" for k in range(2, len(found)))][: len(found)]
    if len(found) < 2 or not all(found) or [re.sub(r"[\^{}()\s]", "", each) for each in powers] != wanted:
        return ""
    return f"np.column_stack(({', '.join(f'[{each[2][1:-1]}]' for each in found if each)}))"


def with_entries(text: str) -> str:
    """Return K = [14, 4] of K = [k1 k2] with k1 = 14, k2 = 4; "" of any other text."""
    found = _NAMED.match(text)
    given = [_ENTRY.fullmatch(each) for each in split(text[found.end() :].strip(" ."), _PIECES)] if found else []
    values = {each[1]: each[2] for each in given if each}
    names = re.split(r"[\s,;]+", found[2].strip()) if found else []
    if found is None or len(values) != len(given) or set(values) != set(names) or len(names) != len(values):
        return ""
    return f"{found[1]}[{', '.join(values[name] for name in names)}]"


def entries_concluded(text: str) -> str:
    """Return k1 = 14, k2 = 4 of 6 + k1 = 20 → k1 = 14; 5 + k2 = 9 → k2 = 4; "" of any other text."""
    pieces = split(text, _BETWEEN)
    found = [_CONCLUDED.match(piece) for piece in pieces]
    if len(pieces) < 2 or not all(found):
        return ""
    return ", ".join(piece[match.end() :] for piece, match in zip(pieces, found, strict=True) if match)


def entries_behind_names(text: str) -> str:
    """Return x2 = 2t of x1 = t^2, x2 = x1' = 2t, for each entry what stands at the end of its chain; else ""."""
    pieces = split(text, _PIECES)
    chains = [[each.strip() for each in piece.split("=")] for piece in pieces]
    between = [side for chain in chains for side in chain[1:-1]]
    named = all(_ITS_NAME.fullmatch(chain[0]) and all(chain) for chain in chains if len(chain) > 1)
    others = all({*_WORDS.findall(side)} - _OF_MOTION for side in between)
    if not between or not named or not others or any(len(chain) < 2 for chain in chains):
        return ""
    return ", ".join(f"{chain[0]} = {chain[-1]}" for chain in chains)


def with_matrices(text: str) -> str:
    """Return [1 2; 3 4]/s of R/s with R = [1 2; 3 4]; "" of any other text."""
    formula, *rest = split(text, _WITH) or [""]
    given = [_GIVEN.fullmatch(each) for piece in rest for each in split(piece, _BETWEEN)]
    if not given or not all(given):
        return ""
    for each in sorted(filter(None, given), key=lambda found: -len(found[1])):  # T^-1 before T
        name, value = each.groups()
        whole = re.compile(rf"(?<![\w\\]){re.escape(name)}(?!\w)")
        if not whole.search(formula):
            return ""
        formula = value.join(whole.split(formula))
    return formula


def mirrored(text: str, ours: sp.MatrixBase) -> str:
    """Return a symmetric matrix with its entries in place of *, or "sym.", below its diagonal; "" of any other text."""
    label, sign, behind = text.rpartition("=")
    inside = _STAR.sub("sym", behind.strip())
    if not enclosed(inside) or not any(each in inside for each in _AS_ABOVE):
        return ""
    grid = cells(inside)
    if [len(line) for line in grid] != [ours.cols] * ours.rows:
        return ""
    whole = [
        [grid[j][i] if j < i and each in _AS_ABOVE else each for j, each in enumerate(line)]
        for i, line in enumerate(grid)
    ]
    return f"{label}{sign}[{'; '.join(', '.join(line) for line in whole)}]"


def of_letters(text: str) -> str:
    """Return s*(1, 2) + t*(3, 4) of x = s (1, 2) + t (3, 4), s, t ∈ R."""
    return _FACTOR.sub(r"\1*", _NAME.sub("", _LETTERS.sub(r"\1", text)))


def of_states(text: str) -> str:
    """Return the matrix of x' = [0 1; -2 -3] x, or of [1 0] x; "" of any other text."""
    return _OF_STATES.sub("", _RATE.sub("", text)) if _OF_STATES.search(text) else ""


def of_inputs(text: str) -> str:
    """Return the matrix of [0; 1] u; "" of any other text."""
    return _OF_INPUTS.sub("", text)


def with_blocks(text: str) -> str:
    """Return [3, 1; 0, 3] for the Jordan block J_2(3), and blocks with ⊕ between them on a diagonal."""
    text = _ON_DIAGONAL.sub(r"diag(\1)", text)
    blocks = [each.strip() for each in _BLOCK.sub(_block, text).split("⊕")]
    return f"diag({', '.join(blocks)})" if len(blocks) > 1 else blocks[0]


def _block(found: re.Match[str]) -> str:
    size, value = int(found[1]), found[2]
    lines = [", ".join(value if j == i else "1" if j == i + 1 else "0" for j in range(size)) for i in range(size)]
    return f"[{'; '.join(lines)}]"
