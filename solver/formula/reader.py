r"""The grammar of formulas: tokens of LaTeX become nodes, from left to right."""

from __future__ import annotations

import re

from solver.formula import vocabulary as v
from solver.formula.nodes import (
    Accent,
    Fenced,
    Fraction,
    Function,
    Node,
    Number,
    Operator,
    Root,
    Row,
    Scripts,
    Space,
    Stacked,
    Styled,
    Symbol,
    Table,
    Text,
)

DEEPEST = 40
LONGEST_TEXT = 200

_TOKEN = re.compile(r"\\(?:[A-Za-z]+|.)|[0-9]+(?:\.[0-9]+)?|\s+|.", re.DOTALL)
_LEAVES: dict[str, Node] = {
    **{name: Symbol(name) for name in v.SYMBOLS - v.GREEK_LETTERS.keys()},
    **{letter: Symbol(f"\\{name}") for letter, name in v.GREEK_LETTERS.items()},
    **{sign: Operator(sign) for sign in v.OPERATORS},
    **{name: Function(name[1:]) for name in v.FUNCTIONS},
    **{command: Space(command) for command in v.SPACES},
}
_CLOSES = {closing: opening for opening, closing in v.PAIRS.items()}
_NO_ARGUMENT = frozenset({"", "}", "]", "^", "_", "&", "'", r"\\", r"\right", r"\end"})


class MathProblem(Exception):  # noqa: N818 - a fault of the formula, reported at its place
    """What is wrong with a formula, and at which character of it."""

    def __init__(self, offset: int, message: str) -> None:
        super().__init__(message)
        self.offset = offset
        self.message = message


class Reader:
    """Reads a formula, token by token."""

    def __init__(self, formula: str) -> None:
        self.tokens = [*_TOKEN.findall(formula), ""]  # "" is the end
        self.index = 0
        self.depth = 0

    def refuse(self, message: str, index: int | None = None) -> MathProblem:
        before = self.tokens[: self.index if index is None else index]
        return MathProblem(sum(len(piece) for piece in before), message)

    def match(self, pattern: re.Pattern[str], expected: str) -> str:
        """Take as many tokens as the pattern matches, and return its group."""
        match = pattern.match("".join(self.tokens[self.index : self.index + LONGEST_TEXT]))
        if match is None:
            raise self.refuse(f"here {expected} is expected")
        taken = 0
        while taken < match.end():
            taken += len(self.tokens[self.index])
            self.index += 1
        return match[1]

    def blanks(self) -> None:
        while self.tokens[self.index].isspace():
            self.index += 1

    def deeper(self) -> None:
        self.depth += 1
        if self.depth > DEEPEST:
            raise self.refuse(f"nested more than {DEEPEST} deep")

    def row(self, *ends: str) -> Row:
        """Read up to one of the tokens `ends`, or to the end of the formula, and leave it there."""
        self.deeper()
        items: list[Node] = []
        outer: list[tuple[str, list[Node]]] = []  # brackets that are open, each with what stood before it
        tokens = self.tokens
        while (piece := tokens[self.index]) not in ends and piece:
            leaf = _LEAVES.get(piece)
            if leaf is None:
                self.structure(piece, items)
                continue
            self.index += 1
            if piece in v.PAIRS:
                outer.append((piece, items))
                items = []
                self.deeper()
            elif outer and _CLOSES.get(piece) == outer[-1][0]:
                opening, before = outer.pop()
                before.append(Fenced(opening, Row(tuple(items)), piece))
                items = before
                self.depth -= 1
            else:
                items.append(leaf)
        for opening, before in reversed(outer):  # brackets without a partner, as in [0, 1)
            items = [*before, Operator(opening), *items]
        self.depth -= 1 + len(outer)
        return Row(tuple(items))

    def structure(self, piece: str, items: list[Node]) -> None:
        """Read what is no leaf, and put it behind the items, or at the last of them."""
        if piece in {"^", "_"}:
            self.script(items, piece)
        elif piece == "'":
            self.primes(items)
        elif piece.isspace():
            self.index += 1
        else:
            items.append(self.atom())

    def script(self, items: list[Node], sign: str) -> None:
        start = self.index
        self.index += 1
        if self.tokens[self.index] == sign:
            raise self.refuse(f"{sign}{sign} is not allowed", start)
        open_ = _scripts(items)
        if (open_.below if sign == "_" else open_.above or open_.primes or None) is not None:
            raise self.refuse(f"a second {sign}; use braces", start)
        argument = self.argument(f"{sign} has nothing after it")
        below, above = (argument, open_.above) if sign == "_" else (open_.below, argument)
        items.append(Scripts(open_.base, below, above, open_.primes))

    def primes(self, items: list[Node]) -> None:
        open_ = _scripts(items)
        if open_.above is not None or open_.primes:
            raise self.refuse("a prime after an exponent")
        start = self.index
        while self.tokens[self.index] == "'":
            self.index += 1
        items.append(Scripts(open_.base, open_.below, None, self.index - start))

    def argument(self, missing: str) -> Node:
        self.blanks()
        piece = self.tokens[self.index]
        if piece in _NO_ARGUMENT:
            raise self.refuse(missing)
        if piece in v.TAKES_ARGUMENT:
            raise self.refuse("put braces around this")
        leaf = _LEAVES.get(piece)
        if leaf is not None:
            self.index += 1
            return leaf
        if len(piece) > 1 and piece[0].isdigit():  # TeX takes one digit
            self.tokens[self.index - 1] += piece[0]
            self.tokens[self.index] = piece[1:]
            return Number(piece[0])
        return self.atom()

    def atom(self) -> Node:
        """Read a number, a group in braces or a command with its arguments."""
        start = self.index
        piece = self.tokens[start]
        self.index += 1
        if piece[0].isdigit() and piece.isascii():
            return Number(piece)
        if piece == "{":
            return self.closed("}", "this { is not closed", start)
        if piece == "}":
            raise self.refuse("this } closes nothing", start)
        if piece in {"&", r"\\"}:
            raise self.refuse(rf"{piece} outside an environment such as \begin{{bmatrix}}", start)
        if piece[0] == "\\":
            return self.command(piece, start)
        if piece[0] == ".":  # what is left of 1.5 when TeX takes one digit
            self.tokens[start - 1] += piece[0]
            self.tokens[start] = piece[1:]
            self.index = start
            return Operator(".")
        raise self.refuse(f"the character {piece!r} is not allowed in a formula", start)

    def closed(self, end: str, missing: str, start: int) -> Row:
        """Read a row and its end."""
        row = self.row(end)
        if self.tokens[self.index] != end:
            raise self.refuse(missing, start)
        self.index += 1
        return row

    def command(self, piece: str, start: int) -> Node:
        needs = f"{piece} needs an argument"
        if piece in v.TEXTS:
            words = self.match(v.WORDS, "plain text in braces")
            return Function(words, named=True) if piece == r"\operatorname" else Text(words, piece)
        if piece in v.ACCENTS:
            return Accent(piece, self.argument(needs))
        if piece in v.ALPHABETS:
            return Styled(piece, self.argument(needs))
        if piece in v.FRACTIONS | v.STACKS:
            needs = f"{piece} needs two arguments"
            first, second = self.argument(needs), self.argument(needs)
            return Fraction(first, second, piece) if piece in v.FRACTIONS else Stacked(piece, first, second)
        return self.enclosing(piece, start)

    def enclosing(self, piece: str, start: int) -> Node:
        """Read a command that has something between two ends."""
        if piece == r"\sqrt":
            index = None
            if self.tokens[self.index] == "[":
                self.index += 1
                index = self.closed("]", "the [ of this root is not closed", start)
            return Root(self.argument(r"\sqrt needs an argument"), index)
        if piece == r"\left":
            left = self.delimiter()
            body = self.closed(r"\right", r"this \left has no \right", start)
            return Fenced(left, body, self.delimiter(), tall=True)
        if piece == r"\begin":
            return self.environment(start)
        known = piece in {r"\right", r"\end"}
        raise self.refuse(f"{piece} {'without its beginning' if known else 'is not known in formulas here'}", start)

    def delimiter(self) -> str:
        piece = self.tokens[self.index]
        if piece not in v.DELIMITERS:
            raise self.refuse("here a bracket is expected")
        self.index += 1
        return piece

    def environment(self, start: int) -> Table:
        name = self.match(v.ENVIRONMENT, "the name of an environment")
        if name not in v.ENVIRONMENTS:
            raise self.refuse(f"the environment {name} is not known in formulas here", start)
        columns = self.match(v.COLUMNS, "the columns, as in {cc|c},") if name == "array" else ""
        most = len(columns.replace("|", "")) if columns else v.ENVIRONMENTS[name]
        rows: list[list[Row]] = []
        rules: list[int] = []
        end = r"\\"
        while end == r"\\":
            self.beginning(len(rows), rules if columns else None)
            rows.append([])
            end = "&"
            while end == "&":
                if len(rows[-1]) == most:
                    raise self.refuse(f"a row has more than {most} cells", self.index - 1)
                rows[-1].append(self.row("&", r"\\", r"\end"))
                end = self.tokens[self.index]
                self.index += 1
        if end != r"\end" or self.match(v.ENVIRONMENT, "its name") != name:
            raise self.refuse(f"this \\begin{{{name}}} has no \\end{{{name}}}", start)
        if len(rows) > 1 and rows[-1] == [Row()]:
            rows.pop()
        return Table(name, tuple(map(tuple, rows)), columns, tuple(rules))

    def beginning(self, row: int, rules: list[int] | None) -> None:
        r"""Read what may stand before a row: \hline, where there are `rules`."""
        self.blanks()
        if row and self.tokens[self.index] == "[":
            raise self.refuse("a row can't begin with [ ; write {[}")
        if rules is not None and self.tokens[self.index] == r"\hline":
            rules.append(row)
            self.index += 1


def _scripts(items: list[Node]) -> Scripts:
    """Take the last item, to put scripts at it; nothing is a base too."""
    if not items or isinstance(items[-1], Space):
        return Scripts(Row())
    last = items.pop()
    return last if isinstance(last, Scripts) else Scripts(last)
