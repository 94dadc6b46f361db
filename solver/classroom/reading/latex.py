r"""LaTeX as plain text in our notation: \frac{1}{2}e^{-t}, \begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix}, \sqrt{3}.

Only text is changed: what comes out is read by our own parser with its bounds. The readers of LaTeX that are kept
(`sympy.parsing.latex`, latex2sympy2) build expressions of sympy from a text without any bound, and none reads names as
the problem declares them; pylatexenc gives a tree of macros, to which the same table would have to be added.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from solver.problem.expressions.notation import FUNCTIONS, GREEK_NAMES

MAX_NESTING = 30
_TOKEN = re.compile(r"\\begin\{[a-zA-Z]+\*?\}|\\end\{[a-zA-Z]+\*?\}|\\[a-zA-Z]+|\\.|[{}^_&]|[^\\{}^_&]", re.DOTALL)
_SPACED = re.compile(r"(\\\\)\[\s*-?[\d.]+\s*(?:pt|em|ex|mm|cm|\\baselineskip)\s*\]")
_FACTOR = re.compile(r"(?<![A-Za-z\\])([a-z])(\d+\^)")  # k3^{k-1}
_COMMA = re.compile(r"(?<=\d)\{,\}(?=\d)(?!\d{3}(?!\d))")
"""A decimal comma, 0{,}2; 10{,}000 may be a number of thousands."""
_OVER = re.compile(r"\{([^{}]*)\\over(?![a-z])([^{}]*)\}")
_WHOLE_OVER = re.compile(r"^\{?([^{}=]*)\\over(?![a-z])([^{}=]*?)\}?$")
_MATRICES = {"matrix", "pmatrix", "bmatrix", "Bmatrix", "vmatrix", "smallmatrix", "array"}
_OF_TEX = {"matrix", "pmatrix", "mqty", "pmqty", "bmqty", "vmqty", "smqty", "Bmqty"}
"""Commands for matrices, of plain TeX and of the package physics, with the entries in brackets behind them."""
_LINES = {"aligned", "align", "equation", "gather", "gathered", "split", "cases"}
_SIGNS = {
    **{"cdot": "*", "times": "*", "ast": "*", "div": "/", "pm": "±", "mp": "±", "infty": " inf ", "imath": " i "},
    **{
        "jmath": " j ",
        "Re": " Re ",
        "Im": " Im ",
        "angle": "∠",
        "cup": " ∪ ",
        "leq": "<=",
        "le": "<=",
        "geq": ">=",
        "ge": ">=",
        "lt": "<",
        "gt": ">",
        "neq": "!=",
        "ne": "!=",
    },
    **{"land": " and ", "wedge": " and ", "lor": " or ", "vee": " or ", "lbrack": "[", "rbrack": "]", "lbrace": "{"},
    **{"rbrace": "}", "prime": "'", "in": " ∈ ", "mid": "|", "vert": "|", "lvert": "|", "rvert": "|", "colon": ":"},
    **{"approx": "≈", "coloneqq": "=", "emptyset": "∅", "varnothing": "∅", "top": "T", "intercal": "T"},
    **{"backslash": " ", "degree": "°", "to": " to ", "e": " e ", "varepsilon": " epsilon ", "vartheta": " theta "},
    **{"Re": " Re ", "Im": " Im ", "angle": "∠", "cup": " ∪ "},
    **{"varphi": " phi ", "lambda": " lamda "},
}
_NOTHING = {"left", "right", "bigl", "bigr", "Bigl", "Bigr", "big", "Big", "bigg", "Bigg", "biggl", "biggr",
            "displaystyle", "textstyle", "limits", "nolimits", "hline", "quad", "qquad", "hfill", "middle"}  # fmt: skip
_CONTENT = {"mathrm", "text", "textrm", "mathbf", "mathit", "mathsf", "operatorname", "boldsymbol", "bm", "mathcal",
            "mbox", "bar", "tilde", "overline", "boxed", "underline", "mathbb", "vec", "textbf", "textit"}  # fmt: skip
_DROPPED = {"phantom", "hphantom", "vphantom", "hspace", "vspace", "mspace", "label", "tag", "color", "cline", "rule"}
"""Commands whose argument is not seen."""
_DERIVATIVES = {"dot": "_dot", "ddot": "_ddot", "dddot": "_dddot"}
_NAMES = {"arcsin": " asin ", "arccos": " acos ", "arctan": " atan "}
_WORDS = {
    **dict.fromkeys(_NOTHING, " "),
    **{name: f" {name} " for name in (*FUNCTIONS, *GREEK_NAMES)},
    **_SIGNS,
    **_NAMES,
}
"""Commands without arguments and what they stand for."""
_DEGREES = re.compile(r"\s*\^\s*(?:\{\s*\\circ\s*\}|\\circ(?![a-z]))")


class NotReadableError(Exception):
    """A text is no LaTeX, or holds a command that is not read."""


def is_latex(text: str) -> bool:
    """Whether a text holds what only LaTeX has."""
    return "\\" in text or "$" in text


def plainly(text: str) -> str:
    """Return a text without LaTeX, as it is where that cannot be read."""
    try:
        return translated(text) if is_latex(text) else text
    except NotReadableError:
        return text


def translated(text: str) -> str:
    """Return LaTeX in plain notation: matrices as [a, b; c, d], fractions in brackets. Raises NotReadableError."""
    text = _WHOLE_OVER.sub(r"\\frac{\1}{\2}", _OVER.sub(r"\\frac{\1}{\2}", text))
    text = _FACTOR.sub(r"\1 \2", _SPACED.sub(r"\1", text))
    text = _COMMA.sub(".", text).replace("{,}", ",")
    text = _DEGREES.sub("°", text)
    tokens = _TOKEN.findall(text.replace("$", " ").replace("~", " "))
    found = re.sub(r"[ \t]+", " ", _Translator(tokens).until(lambda _: False)).strip()
    return re.sub(r"(?<=\w) (?=')", "", found)


class _Translator:
    """Goes through the tokens; each method returns the text of what it read."""

    def __init__(self, tokens: list[str]) -> None:
        self.tokens = tokens
        self.at = 0
        self.depth = 0

    def take(self) -> str:
        if self.at == len(self.tokens):
            raise NotReadableError("this LaTeX ends too early")
        self.at += 1
        return self.tokens[self.at - 1]

    def nested(self, read: Callable[[], str]) -> str:
        """Read one level deeper."""
        self.depth += 1
        if self.depth > MAX_NESTING:
            raise NotReadableError(f"this LaTeX is nested deeper than {MAX_NESTING} levels")
        found = read()
        self.depth -= 1
        return found

    def peek(self) -> str:
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def until(self, closes: Callable[[str], bool]) -> str:
        """Read up to a token that closes, which is taken too, or to the end."""
        pieces = []
        while self.at < len(self.tokens):
            token = self.take()
            if closes(token):
                break
            pieces.append(self.token(token))
        return "".join(pieces)

    def inside(self) -> str:
        """Read up to the }."""
        return self.nested(lambda: self.until(lambda each: each == "}"))

    def token(self, token: str) -> str:
        """Return the text of what begins with a token."""
        begins: dict[str, Callable[[], str]] = {"{": self.group, "^": self.power, "_": self.index}
        if token in begins:
            return begins[token]()
        if token.startswith("\\begin"):
            return self.environment(token[7:-1])
        if token.startswith("\\") and token[1:2].isalpha():
            return self.command(token[1:])
        if token.startswith("\\"):
            return {"\\\\": ";", "\\{": "{", "\\}": "}", "\\%": "%", "\\|": "|"}.get(token, " ")
        return "" if token == "&" else token

    def argument(self) -> str:
        """Read {...}, a command, or one sign."""
        while self.peek().isspace():
            self.take()
        token = self.take()
        return self.inside() if token == "{" else self.nested(lambda: self.token(token))

    def group(self) -> str:
        return f"({self.inside()})"

    def index(self) -> str:
        letters = re.sub(r"[^A-Za-z0-9]", "", self.argument())
        return f"_{letters} "

    def power(self) -> str:
        exponent = self.argument().strip()
        if exponent in ("T", "'"):
            return "'"
        return f"^{exponent}" if exponent.isdigit() else f"^({exponent})"

    def command(self, name: str) -> str:
        """Return the text of a command with its arguments."""
        if name in ("frac", "dfrac", "tfrac", "cfrac"):
            above, below = self.argument(), self.argument()
            return f"(({above})/({below}))"
        if name in ("binom", "dbinom", "tbinom"):
            return f"[{self.argument()}; {self.argument()}]"
        if name == "sqrt":
            return self.root()
        if name in _DERIVATIVES:
            return f" {self.argument().strip()}{self.following_index()}{_DERIVATIVES[name]} "
        return self.of_argument(name)

    def of_argument(self, name: str) -> str:
        """Return what a command makes of the one argument that counts; of a command without arguments, its sign."""
        if name in _OF_TEX:
            return self.nested(self.matrix_of_tex)
        if name in _DROPPED:
            return " " * bool(self.argument())
        if name == "textcolor":
            self.argument()
        return self.argument() if name in _CONTENT or name == "textcolor" else self.word(name)

    def following_index(self) -> str:
        """Read the index of x behind the one that has dots."""
        if self.peek() != "_":
            return ""
        self.take()
        return self.index().strip()

    def word(self, name: str) -> str:
        """Return what a command without arguments stands for, without the space after it where an index follows."""
        if name not in _WORDS:
            raise NotReadableError(f"the LaTeX command \\{name[:40]} is not read")
        return _WORDS[name].rstrip() if self.peek() == "_" else _WORDS[name]

    def root(self) -> str:
        degree = ""
        if self.peek() == "[":
            self.take()
            degree = self.nested(lambda: self.until(lambda each: each == "]"))
        inside = self.argument()
        return f"({inside})^(1/({degree}))" if degree else f"sqrt({inside})"

    def environment(self, name: str) -> str:
        """Read a matrix as [a, b; c, d], lines as they stand."""
        kind, end = name.rstrip("*").replace("NiceMatrix", "matrix"), f"\\end{{{name}}}"
        if kind not in _MATRICES | _LINES:
            raise NotReadableError(f"the LaTeX environment {name[:40]} is not read")
        if kind not in _LINES and self.peek() == "[":  # where the entries stand in their columns
            self.until(lambda each: each == "]")
        if kind == "array" and self.peek() == "{":
            self.argument()
        if kind in _LINES:
            return self.nested(lambda: self.until(lambda each: each == end))
        return self.nested(lambda: self.matrix(end))

    def matrix_of_tex(self) -> str:
        """Read the matrix in the brackets behind a command; raises NotReadableError where their end is not clear."""
        while self.peek().isspace():
            self.take()
        end = {"{": "}", "[": "]", "(": ")"}.get(opening := self.take() if self.peek() else "")
        following = self.tokens[self.at :]
        if end is None or (end != "}" and opening in following[: following.index(end) if end in following else 0]):
            raise NotReadableError("the entries of a LaTeX matrix are expected in braces")
        return self.matrix(end)

    def matrix(self, end: str) -> str:
        cells, last = [""], [""]
        rows: list[list[str]] = []
        while last[0] != end:
            if self.at == len(self.tokens):
                raise NotReadableError(f"{end} is missing")
            cell = self.until(lambda each: self.ends_cell(each, end, last))
            cells[-1] = cell.strip()
            if last[0] == "&":
                cells.append("")
            else:
                rows.append(cells)
                cells = [""]
        filled = [row for row in rows if any(row)]
        return f"[{'; '.join(', '.join(row) for row in filled)}]"

    def ends_cell(self, token: str, end: str, last: list[str]) -> bool:
        """Whether a token ends a cell; `last` keeps it."""
        if token not in ("&", "\\\\", "\\cr", end):
            last[0] = ""
            return False
        last[0] = token
        return True
