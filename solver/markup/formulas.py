r"""Is a formula of our dialect of LaTeX? Only what is listed passes; TeX never sees anything else.

A black list of commands cannot keep a formula from reading files (`^^5cinput`, `\csname`), so this is a white list,
and a small grammar: braces and `\left`/`\right` balance, `&` stands in an environment, every `^`, `_` and `\frac` has
its arguments. So a formula that passes cannot stop TeX either.
"""

from __future__ import annotations

import re
from functools import lru_cache

LONGEST = 50_000
DEEPEST = 40
LONGEST_TEXT = 200

_GREEK = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi psi "
    "omega varepsilon vartheta varpi varrho varsigma varphi Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"
)
_RELATIONS = (
    "le leq ge geq ne neq approx equiv sim simeq cong propto ll gg in notin ni subset subseteq supset supseteq perp "
    "parallel mid to gets rightarrow leftarrow Rightarrow Leftarrow leftrightarrow Leftrightarrow longrightarrow "
    "mapsto implies iff prec succ triangleq"
)
_OPERATORS = (
    "pm mp times div cdot ast star circ bullet oplus ominus otimes cup cap setminus wedge vee land lor neg lnot sum "
    "prod int iint oint partial nabla infty forall exists emptyset varnothing ell hbar Re Im top bot angle "
    "prime dagger ldots cdots vdots ddots dots colon vert Vert lvert rvert lVert rVert langle rangle lfloor rfloor "
    "lceil rceil lbrace rbrace lbrack rbrack backslash"
)
_FUNCTIONS = (
    "sin cos tan cot sec csc arcsin arccos arctan sinh cosh tanh coth exp ln log lg det dim ker max min sup inf "
    "lim deg gcd Pr"
)
_SPACES = "quad qquad enspace thinspace displaystyle textstyle"
_ALONE = " ".join((_GREEK, _RELATIONS, _OPERATORS, _FUNCTIONS, _SPACES))
_FONTS_AND_ACCENTS = (
    "sqrt dot ddot hat tilde bar vec check widehat widetilde overline underline mathrm mathbf mathit mathsf mathtt "
    "mathbb mathcal mathfrak boldsymbol boxed"
)
_FRACTIONS = "frac dfrac tfrac binom overset underset"
_MATRICES = "matrix pmatrix bmatrix Bmatrix vmatrix Vmatrix smallmatrix"
_WITHOUT_ARGUMENT = frozenset(_ALONE.split())
_SYMBOLS = frozenset(",:;! {}|")  # after a backslash
_WITH_ONE = frozenset(_FONTS_AND_ACCENTS.split())
_WITH_TWO = frozenset(_FRACTIONS.split())
_WITH_TEXT = frozenset({"text", "mbox", "textbf", "textit", "textrm", "operatorname"})
_ENVIRONMENTS = {
    **dict.fromkeys(_MATRICES.split(), 30),
    **{"cases": 2, "aligned": 12, "array": 1},
}
"""The environments, with the number of cells that a row may have."""
_DELIMITERS = re.compile(r"[()\[\]|/.]|\\[{}|]|\\(?:l|r)?vert|\\[lr]Vert|\\Vert|\\[lr](?:angle|floor|ceil|brace|brack)")
_COLUMNS = re.compile(r"\{[lcr|]{1,40}\}")
_NAME = re.compile(r"\{([a-z]+|[BV]matrix)\}")
_TEXT = re.compile(r"\{([A-Za-z0-9 .,;:!?()\[\]+*/='-]*)\}")
_TOKEN = re.compile(r"\\(?:[A-Za-z]+|.)|\s+|.", re.DOTALL)
_NUMBER = re.compile(r"[0-9]+")
_PLAIN = re.compile(r"[A-Za-z0-9+\-*/=<>()\[\]|.,;:!?'\s]")
_TYPED = "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΠΣΦΨΩ"
_TYPED_NAMES = (
    "alpha beta gamma delta varepsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon "
    "varphi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega"
)
GREEK_LETTERS = dict(zip(_TYPED, _TYPED_NAMES.split(), strict=True))
"""Greek letters typed as such; they are letters of a formula too."""


class MathProblem(Exception):  # noqa: N818 - a fault of the formula, reported at its place
    """What is wrong with a formula, and at which character of it."""

    def __init__(self, offset: int, message: str) -> None:
        super().__init__(message)
        self.offset = offset
        self.message = message


def check_math(formula: str) -> None:
    """Raise MathProblem if the formula is not of our dialect."""
    problem = find_problem(formula)
    if problem is not None:
        raise MathProblem(*problem)


def find_problem(formula: str) -> tuple[int, str] | None:
    """Return where a formula leaves our dialect, and how; None if it does not.

    One number is as good as another, so a formula is known by the one with other numbers.
    """
    if len(formula) <= LONGEST and _problem_of(_NUMBER.sub("0", formula)) is None:
        return None
    return _problem_of(formula)


@lru_cache(maxsize=8192)
def _problem_of(formula: str) -> tuple[int, str] | None:
    if len(formula) > LONGEST:
        return 0, f"a formula of more than {LONGEST} characters"
    if not formula.strip():
        return 0, "an empty formula"
    try:
        _Reader(_TOKEN.findall(formula)).row("", 0)
    except MathProblem as problem:
        return problem.offset, problem.message
    return None


class _Reader:
    """Reads a formula from left to right, token by token."""

    def __init__(self, tokens: list[str]) -> None:
        self.tokens = [*tokens, ""]  # "" is the end
        self.index = 0
        self.depth = 0

    def peek(self) -> str:
        return self.tokens[self.index]

    def take(self) -> str:
        piece = self.tokens[self.index]
        self.index += piece != ""
        return piece

    def refuse(self, message: str, index: int | None = None) -> MathProblem:
        before = self.tokens[: self.index if index is None else index]
        return MathProblem(sum(len(piece) for piece in before), message)

    def pattern(self, pattern: re.Pattern[str], expected: str) -> str:
        """Take as many tokens as the pattern matches."""
        match = pattern.match("".join(self.tokens[self.index : self.index + LONGEST_TEXT]))
        if match is None:
            raise self.refuse(f"here {expected} is expected")
        taken = 0
        while taken < match.end():
            taken += len(self.take())
        return match[0]

    def row(self, end: str, columns: int, *, ruled: bool = False) -> str:
        r"""Read up to the token `end` and take it; `columns` is how many cells a row may have (0: no & and \\).

        Where it is `ruled`, rows may begin with \hline.
        """
        self.depth += 1
        if self.depth > DEEPEST:
            raise self.refuse(f"nested more than {DEEPEST} deep")
        scripts = ""  # those that the last atom has
        cells = 1
        self.rule(ruled)
        while (piece := self.peek()) not in {end, ""}:
            if piece in {"&", r"\\"}:
                cells = self.next_cell(piece, cells, columns)
                self.rule(ruled and cells == 1)
                scripts = ""
            elif piece in {"^", "_"}:
                scripts += self.script(scripts)
            elif piece == "'":
                scripts += self.prime(scripts)
            elif piece.isspace():
                self.take()
            else:
                self.atom()
                scripts = ""
        self.depth -= 1
        return self.take()

    def next_cell(self, piece: str, cells: int, columns: int) -> int:
        if not columns:
            raise self.refuse(rf"{piece} outside an environment such as \begin{{bmatrix}}")
        if piece == "&" and cells == columns:
            raise self.refuse(f"a row has more than {columns} cells")
        self.take()
        self.blanks()
        if piece == r"\\" and self.peek() == "[":
            raise self.refuse(r"a row can't begin with [ ; write {[}")
        return cells + 1 if piece == "&" else 1

    def rule(self, allowed: bool) -> None:
        if allowed:
            self.blanks()
            if self.peek() == r"\hline":
                self.take()

    def blanks(self) -> None:
        while self.peek().isspace():
            self.take()

    def script(self, scripts: str) -> str:
        sign = self.take()
        if self.peek() == sign:
            raise self.refuse(f"{sign}{sign} is not allowed", self.index - 1)
        if sign in scripts:
            raise self.refuse(f"a second {sign}; use braces", self.index - 1)
        self.argument(f"{sign} has nothing after it")
        return sign

    def prime(self, scripts: str) -> str:
        if "^" in scripts:
            raise self.refuse("a prime after an exponent")
        while self.peek() == "'":
            self.take()
        return "^"

    def argument(self, missing: str) -> None:
        self.blanks()
        piece = self.peek()
        if piece in {"", "}", "]", "^", "_", "&", "'", r"\\", r"\right", r"\end"}:
            raise self.refuse(missing)
        if piece[0] == "\\" and piece[1:] in _WITH_ONE | _WITH_TWO | _WITH_TEXT | {"left", "begin"}:
            raise self.refuse("put braces around this")
        self.atom()

    def atom(self) -> None:
        start = self.index
        piece = self.take()
        if piece == "{":
            if not self.row("}", 0):
                raise self.refuse("this { is not closed", start)
        elif piece == "}":
            raise self.refuse("this } closes nothing", start)
        elif piece[0] == "\\":
            self.command(piece[1:], start)
        elif not (_PLAIN.fullmatch(piece) or piece in GREEK_LETTERS):
            raise self.refuse(f"the character {piece!r} is not allowed in a formula", start)

    def command(self, name: str, start: int) -> None:
        if name in _WITHOUT_ARGUMENT or (name and name in _SYMBOLS):
            return
        if name in _WITH_ONE:
            if name == "sqrt" and self.peek() == "[" and self.take() and not self.row("]", 0):
                raise self.refuse("the [ of this root is not closed", start)
            self.argument(f"\\{name} needs an argument")
        elif name in _WITH_TWO:
            self.argument(f"\\{name} needs two arguments")
            self.argument(f"\\{name} needs two arguments")
        elif name in _WITH_TEXT:
            self.pattern(_TEXT, "plain text in braces")
        elif name == "left":
            self.fenced(start)
        elif name == "begin":
            self.environment(start)
        elif name in {"right", "end"}:
            raise self.refuse(f"\\{name} without its beginning", start)
        else:
            raise self.refuse(f"\\{name} is not known in formulas here", start)

    def fenced(self, start: int) -> None:
        self.pattern(_DELIMITERS, "a bracket")
        if not self.row(r"\right", 0):
            raise self.refuse(r"this \left has no \right", start)
        self.pattern(_DELIMITERS, "a bracket")

    def environment(self, start: int) -> None:
        name = self.pattern(_NAME, "the name of an environment")[1:-1]
        if name not in _ENVIRONMENTS:
            raise self.refuse(f"the environment {name} is not known in formulas here", start)
        columns = _ENVIRONMENTS[name]
        if name == "array":
            columns = len(self.pattern(_COLUMNS, "the columns, as in {cc|c},").replace("|", "")) - 2
        if not self.row(r"\end", columns, ruled=name == "array") or self.pattern(_NAME, "its name")[1:-1] != name:
            raise self.refuse(f"this \\begin{{{name}}} has no \\end{{{name}}}", start)
