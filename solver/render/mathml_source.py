r"""LaTeX as it may be drawn in HTML: checked, and rewritten into what latex2mathml understands.

latex2mathml prints what it does not know, loses table rows that end in an empty cell, and knows neither
`aligned` nor lines in arrays. So nothing reaches it that was not read here first: only commands of the list,
balanced braces, `&` and `\\` inside environments only. What it has no word for (a line, a left bar) travels
through it as a private-use character, which `mathml_tree` turns into the right element afterwards.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator

from latex2mathml.commands import CONVERSION_MAP, FUNCTIONS
from latex2mathml.symbols_parser import convert_symbol


class MathError(ValueError):
    """The formula cannot be drawn; the message says why, in words."""


LONGEST = 60_000
"""Characters of a formula; a 12 × 12 matrix of long entries has about 20,000."""

DEEPEST = 60
"""Levels of braces and environments; latex2mathml is recursive."""

# Marks that pass through latex2mathml as letters.
LEFT_BAR, RIGHT_BAR, LEFT_DOUBLE_BAR, RIGHT_DOUBLE_BAR = "\ue000", "\ue001", "\ue002", "\ue003"
HORIZONTAL_LINE, DISPLAY_STYLE = "\ue010", "\ue011"
VERTICAL_LINE = "\ue100"  # … and the following: a line before column 0, 1, 2, …

BARS = {r"\lvert": LEFT_BAR, r"\rvert": RIGHT_BAR, r"\lVert": LEFT_DOUBLE_BAR, r"\rVert": RIGHT_DOUBLE_BAR}

DELIMITERS = {
    **{character: character for character in "()[]|/."},
    **{r"\{": "{", r"\}": "}", r"\lbrace": "{", r"\rbrace": "}", r"\lbrack": "[", r"\rbrack": "]"},
    **{r"\lvert": "|", r"\rvert": "|", r"\vert": "|", r"\|": "‖", r"\lVert": "‖", r"\rVert": "‖", r"\Vert": "‖"},
    **{r"\langle": "⟨", r"\rangle": "⟩", r"\lfloor": "⌊", r"\rfloor": "⌋", r"\lceil": "⌈", r"\rceil": "⌉"},
}
FENCED = {r"\left", r"\middle", r"\right"}
BIG = {rf"\{size}{side}" for size in ("big", "Big", "bigg", "Bigg") for side in ("", "l", "m", "r")}

TEXTS = {r"\text", r"\textrm", r"\textup", r"\textnormal", r"\textbf", r"\textit", r"\mbox"}
FONTS = {
    rf"\{name}"
    for name in "mathrm mathbf mathit mathsf mathtt mathbb mathcal mathscr mathfrak boldsymbol bm mathnormal".split()
}
STRUCTURES = {
    rf"\{name}"
    for name in (
        "frac dfrac tfrac cfrac binom sqrt overset underset stackrel boxed phantom hphantom vphantom "
        "displaystyle textstyle limits nolimits underbrace overbrace overline underline xrightarrow xleftarrow "
        "dot ddot dddot hat tilde bar vec check breve acute grave widehat widetilde overrightarrow "
        "quad qquad enspace thinspace space bmod pmod lim max min sup inf limsup liminf det gcd Pr"
    ).split()
}
ESCAPES = {"\\" + character for character in "{}|%_&#$ ,:;!>"}
COMMANDS = FONTS | STRUCTURES | ESCAPES | set(FUNCTIONS)

SPELLED = {r"\sim": "∼", r"\iff": r"\Leftrightarrow", r"\implies": r"\Rightarrow", r"\thinspace": r"\,"}
r"""Rewritten, since latex2mathml draws something else: `\sim` as a tilde, long arrows as letters."""

MATRICES = {"matrix", "pmatrix", "bmatrix", "Bmatrix", "vmatrix", "Vmatrix", "smallmatrix", "cases"}
ENVIRONMENTS = {
    **{name: name for name in (*MATRICES, "array")},
    **dict.fromkeys(("aligned", "align", "align*", "split"), "split"),
    **dict.fromkeys(("gathered", "gather", "gather*"), "matrix"),
    "dcases": "cases",
}
IN_DISPLAY_STYLE = {"gathered", "gather", "gather*", "dcases"}

TOKEN = re.compile(
    r"""\\(?:begin|end)\s*\{[A-Za-z]+\*?\}     # an environment
      | \\operatorname\s*\*?\s*\{[A-Za-z ]+\}
      | \\\\(?:\s*\[\s*-?[\d.]+\s*[a-z]{2}\s*\])?  # a new line, perhaps with a gap
      | \\[A-Za-z]+
      | \\.
      | \s+
      | .""",
    re.VERBOSE | re.DOTALL,
)
COLUMNS = re.compile(r"\s*\{([lcr|\s]*)\}")
UNIT = re.compile(r"(?<=\d)\s*(?=in|mm|cm|pt|em|ex|pc|bp|dd|cc|sp|mu)")


def normalised(latex: str) -> str:
    """Return the formula in latex2mathml's own dialect, with marks; raises MathError for what is not known."""
    _check_characters(latex)
    return "".join(_rewritten(latex))


def _check_characters(latex: str) -> None:
    if len(latex) > LONGEST:
        raise MathError(f"the formula is longer than {LONGEST} characters")
    if "&#" in latex:
        raise MathError("a character reference (&#) in a formula")
    for character in set(latex):
        if unicodedata.category(character)[0] == "C" and character not in "\n\t":
            raise MathError(f"the character U+{ord(character):04X} in a formula")


def _rewritten(latex: str) -> Iterator[str]:
    """Yield the tokens of the formula, rewritten, and keep account of what is open."""
    opened: list[str] = []
    position = 0
    cell_is_empty = False
    while match := TOKEN.match(latex, position):
        token, position = match[0], match.end()
        if cell_is_empty and _is_environment(token, "end"):
            yield "{}"  # else latex2mathml loses the whole row
        cell_is_empty = token == "&" or (cell_is_empty and token.isspace())
        _keep_account(token, opened)
        if token in TEXTS:
            content, position = _argument(latex, position)
            yield from _text(token, content)
        elif _is_environment(token, "begin"):
            beginning, position = _begin(token, latex, position)
            yield beginning
        elif _is_environment(token, "end"):
            yield rf"\end{{{ENVIRONMENTS[_environment(token)]}}}"
        elif token in FENCED or token in BIG:
            delimiter, position = _delimiter(token, latex, position)
            yield token + delimiter
        elif token == r"\mathrm" and latex[position : position + 1] == "{":
            content, position = _argument(latex, position)
            yield token + "{{" + "".join(_rewritten(content)) + "}}"  # latex2mathml forgets a lone upright letter
        else:
            yield _plain(token, latex, position)
    if opened:
        raise MathError(f"{opened[-1]} is not closed")


def _keep_account(token: str, opened: list[str]) -> None:
    """Push what the token opens, pop what it closes."""
    if token == "{" or token == r"\left":
        opened.append(token)
    elif _is_environment(token, "begin"):
        opened.append(_environment(token))
    elif token == "}":
        _close("{", token, opened)
    elif token == r"\right":
        _close(r"\left", token, opened)
    elif _is_environment(token, "end"):
        _close(_environment(token), token, opened)
    elif (token == "&" or token.startswith(r"\\") or token == r"\hline") and (
        not opened or opened[-1] not in ENVIRONMENTS
    ):
        raise MathError(f"{token} outside a matrix or an aligned block")
    elif token == r"\middle" and (not opened or opened[-1] != r"\left"):
        raise MathError(r"\middle without \left")
    if len(opened) > DEEPEST:
        raise MathError(f"the formula is nested more than {DEEPEST} levels deep")


def _close(expected: str, token: str, opened: list[str]) -> None:
    if not opened or opened.pop() != expected:
        raise MathError(f"{token} closes nothing that is open")


def _is_environment(token: str, end: str) -> bool:
    return token.startswith("\\" + end) and token[-1] == "}"


def _environment(token: str) -> str:
    name = token[token.index("{") + 1 : -1]
    if name not in ENVIRONMENTS:
        raise MathError(f"the environment {name} is not known")
    return name


def _begin(token: str, latex: str, position: int) -> tuple[str, int]:
    """Return the beginning of an environment with its marks, and where its content starts."""
    name = _environment(token)
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


def _delimiter(token: str, latex: str, position: int) -> tuple[str, int]:
    r"""Return what follows \left, \right, \middle or \big, as a character where latex2mathml wants one."""
    match = TOKEN.match(latex, position)
    while match and match[0].isspace():
        match = TOKEN.match(latex, match.end())
    if match is None or match[0] not in DELIMITERS:
        raise MathError(f"{token} needs a bracket or a bar after it")
    delimiter = match[0]
    if token in BIG:
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


def _plain(token: str, latex: str, position: int) -> str:
    """Return any other token as latex2mathml is to see it."""
    if token in "$#%":
        raise MathError(f"{token} in a formula; write \\{token}")
    if token.startswith("\\\\"):
        return r"\\"
    if token == r"\hline":
        return "{" + HORIZONTAL_LINE + "}"
    if token in BARS:
        return BARS[token]
    if token in SPELLED:
        return SPELLED[token] + " "
    if token[0].isdigit() and UNIT.match(latex, position):
        return token + "{}"  # 2 ex is a product here, not a length
    if token[0] == "\\" and not _is_known(token):
        raise MathError(f"the command {token} is not known")
    return token


def _is_known(command: str) -> bool:
    """Whether the command is of our list, an environment, an operator's name, or the name of a character."""
    if command in COMMANDS or command.startswith(r"\operatorname") and command[-1] == "}":
        return True
    code = convert_symbol(command)
    return (
        code is not None and command not in CONVERSION_MAP and unicodedata.category(chr(int(code, 16)))[0] not in "CMZ"
    )
