"""Lists and matrices of other programs with our brackets: <<1, 2>|<3, 4>> of Maple, [[1, 2][3, 4]] of calculators.

Only text is changed here; nothing is evaluated.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from solver.classroom.reading.brackets import matching, split

MAX_NESTING = 6
MOST_ARGUMENTS = 2
"""A value, and how many digits or which symbol."""
_ANGLES = str.maketrans("⟨⟩", "<>")
_ADJACENT = re.compile(r"(?<=\])\s*(?=\[)")
_BARRED = re.compile(r"[^|&]*(?:\|[^|&]*|(?:&[^|&]*)+)")
_MADE = re.compile(r"(?:^|(?<=[*+\-/ )]))(?:\w+\.)*(?:[Mm]atrix|array)\((?=\[)")
_WORD = re.compile(r"[\[(]?\s*[■█]\s*\(")
_IDLE = re.compile(
    r"(?:\w+\.)*(?:simplify|Simplify|FullSimplify|expand|Expand|factor|Factor|evalf|N|vpa|sym|double|float|MatrixForm"
    r"|collect|ratsimp|trigsimp|nsimplify|evalm)\s*[(\[]"
)
"""Calls that change the form of a value only."""
_IDLE_BEHIND = re.compile(
    r"(?:\s*//\s*(?:N|MatrixForm|TableForm|Simplify|FullSimplify|Expand|Chop|Together)"
    r"|(?<=[\])])\.(?:tolist|evalf|n|round|simplify|doit|expand|astype|copy|factor|applyfunc)\([^()]*\))+$"
)
"""The same behind a value."""
_BRACES = re.compile(r"\b(diag|blkdiag)\s*\{([^{}]*)\}")
_DIAGONAL = ("DiagonalMatrix", "Diagonal", "blkdiag", "block_diag", "blockdiag")
_OTHER_NAME = re.compile(
    r"(?<![\w.])(?:\w+\.)*(IdentityMatrix|Identity|DiagonalMatrix|Diagonal|blkdiag|block_diag|blockdiag)\s*[\[(]"
)
_TRANSPOSED = re.compile(r"(?:\w+\.)*(?:[Tt]ranspose|ctranspose)\s*[(\[]")
_TRANSPOSED_LIST = re.compile(r"(?:\w+\.)*(?:[Tt]ranspose|ctranspose)\s*\(\s*(\[[^()]*\])\s*\)")

Grid = list[list[str]]


def in_our_brackets(text: str) -> str:
    """Return a text with the matrices of Maple and of calculators in our brackets."""
    text = _with_names(_BRACES.sub(r"\1(\2)", text.translate(_ANGLES)))
    if text.count("<") == text.count(">") > 0 and "=" not in text:
        text = _without_angles(text)
    text = _without_makers(_of_word(_TRANSPOSED_LIST.sub(r"\1'", text)))
    if _BARRED.fullmatch(text):
        text = text.replace("|", ",").replace("&", ",")
    return _ADJACENT.sub(", ", text) if text.startswith("[[") and matching(text, 0) == len(text) - 1 else text


def _with_names(text: str) -> str:
    """A text with IdentityMatrix[2], Diagonal([1, 2]) by the names that MATLAB has for them."""
    at = 0
    while found := _OTHER_NAME.search(text, at):
        end = matching(text, found.end() - 1)
        inside = text[found.end() : end]
        one = inside[:1] in ("[", "{") and matching(inside, 0) == len(inside) - 1
        listed = inside[1:-1] if found[1] in _DIAGONAL and one else inside
        text = f"{text[: found.start()]}{'diag' if found[1] in _DIAGONAL else 'eye'}({listed}){text[end + 1 :]}"
        at = found.start() + 3
    return text


def _without_makers(text: str) -> str:
    """A text with the matrices in np.array([…]) behind a factor as they stand."""
    at = 0
    while not text.startswith(("Matrix", "matrix")) and (found := _MADE.search(text, at)):
        end = matching(text, found.end() - 1)
        inside = text[found.end() : end]
        whole = found.start() == 0 and end == len(text) - 1
        if not whole and end < len(text) and matching(inside, 0) == len(inside) - 1:
            text = f"{text[: found.start()]}{inside}{text[end + 1 :]}"
        at = found.start() + 1
    return text


def _of_word(text: str) -> str:
    """A text with the matrices of Word, [■(1&2@3&4)], in our brackets."""
    while found := _WORD.search(text):
        end = matching(text, found.end() - 1)
        inside = text[found.end() : end].replace("&", ", ").replace("@", "; ")
        closed = matching(text, found.start()) if text[found.start()] in "[(" else end
        text = f"{text[: found.start()]}[{inside}]{text[closed + 1 :]}"
    return text


def inside_idle_call(text: str) -> str | None:
    """Return what stands in simplify(…), or before .evalf(), // N; None where no call changes the form only."""
    return text[: found.start()] if (found := _IDLE_BEHIND.search(text)) else _argument(_IDLE, text)


def inside_transposition(text: str) -> str | None:
    """Return the matrix in transpose(…); None of anything else."""
    return _argument(_TRANSPOSED, text)


def _argument(call: re.Pattern[str], text: str) -> str | None:
    """The first argument of a call that is the whole text."""
    found = call.match(text)
    if found is None or matching(text, found.end() - 1) != len(text) - 1:
        return None
    arguments = split(text[found.end() : -1], ",")
    return arguments[0] if 0 < len(arguments) <= MOST_ARGUMENTS else None


def _without_angles(text: str) -> str:
    """A text with each <…> as rows in brackets; as it is where one is not closed."""
    pieces, at = [], 0
    while (start := text.find("<", at)) >= 0:
        end = _closing(text, start)
        grid = _grid(text[start + 1 : end], 0)
        if end == len(text) or grid is None:
            return text
        pieces += [text[at:start], f"[{'; '.join(', '.join(row) for row in grid)}]"]
        at = end + 1
    return "".join([*pieces, text[at:]])


def _closing(text: str, start: int) -> int:
    depth = 0
    for at in range(start, len(text)):
        depth += (text[at] == "<") - (text[at] == ">")
        if depth == 0:
            return at
    return len(text)


def _grid(text: str, depth: int) -> Grid | None:
    """The entries of what stands in angles: | puts side by side, a comma one below the other; with ; it separates."""
    if depth > MAX_NESTING:
        return None
    lines = _pieces(text, ";")
    if len(lines) > 1:
        return [[entry.strip() for entry in _pieces(line, ",")] for line in lines]
    sign = "|" if len(_pieces(text, "|")) > 1 else ","
    blocks = [_block(piece.strip(), depth) for piece in _pieces(text, sign)]
    found = [block for block in blocks if block is not None]
    if len(found) < len(blocks) or (sign == "|" and _holds_commas(found)):  # <1, 2|3, 4>
        return None
    if sign == ",":
        return [row for block in found for row in block]
    if len({len(block) for block in found}) != 1:
        return None
    return [[entry for row in rows for entry in row] for rows in zip(*found, strict=True)]


def _holds_commas(blocks: Sequence[Grid]) -> bool:
    return any("," in entry for block in blocks for row in block for entry in row)


def _block(text: str, depth: int) -> Grid | None:
    if text.startswith("<") and _closing(text, 0) == len(text) - 1:
        return _grid(text[1:-1], depth + 1)
    return [[text]] if text and "<" not in text else None


def _pieces(text: str, sign: str) -> list[str]:
    """The pieces between separators outside of angles and brackets."""
    return [piece.translate(_AS_ANGLES) for piece in split(text.translate(_AS_BRACES), sign)]


_AS_BRACES, _AS_ANGLES = str.maketrans("<>{}", "{}⟦⟧"), str.maketrans("{}⟦⟧", "<>{}")
"""Angles as brackets that are kept apart while a text is cut."""
