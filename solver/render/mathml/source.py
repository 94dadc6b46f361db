r"""LaTeX as it may be drawn in HTML: checked, and rewritten into what latex2mathml understands.

latex2mathml prints what it does not know, loses table rows that end in an empty cell, and knows neither
`aligned` nor lines in arrays. So nothing reaches it that was not read here first: only commands of the list,
balanced braces, `&` and `\\` inside environments only. What it has no word for (a line, a left bar) travels
through it as a private-use character, which `tree` turns into the right element afterwards.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator

from solver.render.mathml.commands import (
    BARS,
    BIG,
    DELIMITERS,
    DISPLAY_STYLE,
    ENVIRONMENTS,
    FENCED,
    HORIZONTAL_LINE,
    IN_DISPLAY_STYLE,
    SPELLED,
    TEXTS,
    VERTICAL_LINE,
    is_known,
)


class MathError(ValueError):
    """The formula cannot be drawn; the message says why, in words."""


LONGEST = 60_000
"""Characters of a formula; a 12 × 12 matrix of long entries has about 20,000."""

DEEPEST = 60
"""Levels of braces and environments; latex2mathml is recursive."""

LEXEME = re.compile(
    r"""\\(?:begin|end)\s*\{[A-Za-z]+\*?\}     # an environment
      | \\operatorname\s*\*?\s*\{[^{}$\\]*\}
      | \\\\(?:\s*\[\s*-?[\d.]+\s*[a-z]{2}\s*\])?  # a new line, perhaps with a gap
      | \\[A-Za-z]+
      | \\.
      | \s+
      | .""",
    re.VERBOSE | re.DOTALL,
)
OPERATOR_NAME = re.compile(r"\\operatorname\*?(\{[A-Za-z ]+\})?")
COLUMNS = re.compile(r"\s*\{([lcr|\s]*)\}")
UNIT = re.compile(r"(?<=\d)\s*(?=in|mm|cm|pt|em|ex|pc|bp|dd|cc|sp|mu)")


def normalised(latex: str) -> str:
    """Return the formula in latex2mathml's own dialect, with marks; raises MathError for what is not known.

    Its characters have been checked.
    """
    return "".join(_rewritten(latex))


def check_characters(latex: str) -> None:
    """Refuse a formula that is too long or holds characters that nobody sees; raises MathError."""
    if len(latex) > LONGEST:
        raise MathError(f"the formula is longer than {LONGEST} characters")
    if "&#" in latex:
        raise MathError("a character reference (&#) in a formula")
    for character in set(latex):
        if unicodedata.category(character)[0] == "C" and character not in "\n\t":
            raise MathError(f"the character U+{ord(character):04X} in a formula")


def _rewritten(latex: str) -> Iterator[str]:
    """Yield the lexemes of the formula, rewritten, and keep account of what is open."""
    opened: list[str] = []
    position = 0
    cell_is_empty = False
    while match := LEXEME.match(latex, position):
        lexeme, position = match[0], match.end()
        if cell_is_empty and _is_environment(lexeme, "end"):
            yield "{}"  # else latex2mathml loses the whole row
        cell_is_empty = lexeme == "&" or (cell_is_empty and lexeme.isspace())
        _keep_account(lexeme, opened)
        if lexeme in TEXTS:
            content, position = _argument(latex, position)
            yield from _text(lexeme, content)
        elif lexeme.startswith(r"\operatorname") and not OPERATOR_NAME.fullmatch(lexeme):
            yield r"\text" + lexeme[lexeme.find("{") :]  # latex2mathml takes letters only
        elif _is_environment(lexeme, "begin"):
            beginning, position = _begin(lexeme, latex, position)
            yield beginning
        elif _is_environment(lexeme, "end"):
            yield rf"\end{{{ENVIRONMENTS[_environment(lexeme)]}}}"
        elif lexeme in FENCED or lexeme in BIG:
            delimiter, position = _delimiter(lexeme, latex, position)
            yield lexeme + delimiter
        elif lexeme == r"\mathrm" and latex[position : position + 1] == "{":
            content, position = _argument(latex, position)
            yield lexeme + "{{" + "".join(_rewritten(content)) + "}}"  # latex2mathml forgets a lone upright letter
        else:
            yield _plain(lexeme, latex, position)
    if opened:
        raise MathError(f"{opened[-1]} is not closed")


def _keep_account(lexeme: str, opened: list[str]) -> None:
    """Push what the lexeme opens, pop what it closes."""
    if lexeme in {"{", r"\left"}:
        opened.append(lexeme)
    elif _is_environment(lexeme, "begin"):
        opened.append(_environment(lexeme))
    elif lexeme == "}":
        _close("{", lexeme, opened)
    elif lexeme == r"\right":
        _close(r"\left", lexeme, opened)
    elif _is_environment(lexeme, "end"):
        _close(_environment(lexeme), lexeme, opened)
    elif (lexeme == "&" or lexeme.startswith(r"\\") or lexeme == r"\hline") and (
        not opened or opened[-1] not in ENVIRONMENTS
    ):
        raise MathError(f"{lexeme} outside a matrix or an aligned block")
    elif lexeme == r"\middle" and (not opened or opened[-1] != r"\left"):
        raise MathError(r"\middle without \left")
    if len(opened) > DEEPEST:
        raise MathError(f"the formula is nested more than {DEEPEST} levels deep")


def _close(expected: str, lexeme: str, opened: list[str]) -> None:
    if not opened or opened.pop() != expected:
        raise MathError(f"{lexeme} closes nothing that is open")


def _is_environment(lexeme: str, end: str) -> bool:
    return lexeme.startswith("\\" + end) and lexeme[-1] == "}"


def _environment(lexeme: str) -> str:
    name = lexeme[lexeme.index("{") + 1 : -1]
    if name not in ENVIRONMENTS:
        raise MathError(f"the environment {name} is not known")
    return name


def _begin(lexeme: str, latex: str, position: int) -> tuple[str, int]:
    """Return the beginning of an environment with its marks, and where its content starts."""
    name = _environment(lexeme)
    marks = DISPLAY_STYLE if name in IN_DISPLAY_STYLE else ""
    columns = ""  # an empty group, else latex2mathml takes a first cell {c} or [1] for columns
    if name == "array":
        match = COLUMNS.match(latex, position)
        if match is None:
            raise MathError("array needs its columns, e.g. {cc|c}")
        position = match.end()
        columns, lines = _columns(match[1])
        marks += lines
    marks = marks and "{" + marks + "}"
    return rf"\begin{{{ENVIRONMENTS[name]}}}{{{columns}}}{marks}", position


def _columns(specification: str) -> tuple[str, str]:
    """Return the letters of "cc|c" and a mark for each bar."""
    columns, lines = "", ""
    for letter in specification:
        if letter == "|":
            lines += chr(ord(VERTICAL_LINE) + len(columns))
        elif not letter.isspace():
            columns += letter
    return columns, lines


def _delimiter(lexeme: str, latex: str, position: int) -> tuple[str, int]:
    r"""Return what follows \left, \right, \middle or \big, as a character where latex2mathml wants one."""
    match = LEXEME.match(latex, position)
    while match and match[0].isspace():
        match = LEXEME.match(latex, match.end())
    if match is None or match[0] not in DELIMITERS:
        raise MathError(f"{lexeme} needs a bracket or a bar after it")
    delimiter = match[0]
    if lexeme in BIG:
        delimiter = DELIMITERS[delimiter]
    return delimiter, match.end()


def _argument(latex: str, position: int) -> tuple[str, int]:
    """Return the content of the braces that open at `position` and where it goes on after them."""
    start = position
    while latex[start : start + 1].isspace():
        start += 1
    if latex[start : start + 1] != "{":
        raise MathError("text needs braces")
    depth = 0
    index = start
    while index < len(latex):
        if latex[index] == "\\":
            index += 1
        elif latex[index] in "{}":
            depth += 1 if latex[index] == "{" else -1
            if depth == 0:
                return latex[start + 1 : index], index + 1
        index += 1
    raise MathError("{ is not closed")


def _text(command: str, content: str) -> Iterator[str]:
    r"""Yield text, and the formulas between dollar signs in it as formulas: latex2mathml has no $ inside \text."""
    command = r"\text" if command == r"\mbox" else command
    for index, piece in enumerate(re.split(r"(?<!\\)\$", content)):
        if index % 2:
            yield "{" + "".join(_rewritten(piece)) + "}"
        elif piece:
            plain = re.sub(r"\\([%_&#$ ])", r"\1", piece)
            if set(plain) & set("\\{}"):
                raise MathError("commands or braces inside text")
            yield f"{command}{{{plain}}}"


def _plain(lexeme: str, latex: str, position: int) -> str:
    """Return any other lexeme as latex2mathml is to see it."""
    if lexeme in "$#%":
        raise MathError(f"{lexeme} in a formula; write \\{lexeme}")
    if lexeme.startswith("\\\\"):
        return r"\\"
    if lexeme == r"\hline":
        return "{" + HORIZONTAL_LINE + "}"
    if lexeme in BARS:
        return BARS[lexeme]
    if lexeme in SPELLED:
        return SPELLED[lexeme] + " "
    if lexeme[0].isdigit() and UNIT.match(latex, position):
        return lexeme + "{}"  # 2 ex is a product here, not a length
    if lexeme[0] == "\\" and not is_known(lexeme):
        raise MathError(f"the command {lexeme} is not known")
    return lexeme
