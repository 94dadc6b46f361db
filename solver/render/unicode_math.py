"""LaTeX of our dialect as text: two-dimensional for display (`drawn`), on one line within a sentence (`flat`)."""

from __future__ import annotations

import re

from solver.render.boxes import Box, beside, enclosed, text_box
from solver.render.unicode_layout import MATRICES, Atom, accented, fraction_of, spaced, tabular, with_scripts
from solver.render.unicode_symbols import (
    ACCENTS,
    BINARY,
    BLACKBOARD,
    DELIMITERS,
    OPERATORS,
    RELATIONS,
    SCRIPT,
    SPACES,
    SUPERSCRIPTS,
    SYMBOLS,
)

TOKEN = re.compile(r"\\[A-Za-z]+\*?|\\.|\d+(?:\.\d+)?|[^\s\\]", re.DOTALL)
TEXT = re.compile(r"\\(?:text(?:bf|rm|it)?|mbox)\s*\{([^{}]*)\}")
UPRIGHT = {
    *(r"\mathrm", r"\mathbf", r"\mathit", r"\mathsf", r"\mathtt", r"\boldsymbol", r"\bm", r"\operatorname"),
    *(r"\text", r"\textbf", r"\textrm", r"\textit", r"\mbox", r"\operatorname*"),
}
FRACTIONS = {r"\frac", r"\dfrac", r"\tfrac", r"\cfrac"}
ALPHABETS = {r"\mathcal": SCRIPT, r"\mathscr": SCRIPT, r"\mathbb": BLACKBOARD}
INVISIBLE = {
    *(r"\displaystyle", r"\textstyle", r"\hline", r"\limits", r"\nolimits", r"\big", r"\Big", r"\bigg", r"\Bigg"),
    *(r"\bigl", r"\bigr", r"\Bigl", r"\Bigr"),
}
CLOSING_TOKENS = {"&", "\\\\", r"\right", r"\middle", r"\end", "}"}
OPENING = {each: DELIMITERS.get(each, each) for each in ("(", "[", r"\{", r"\lvert", r"\langle")}
CLOSING = {each: DELIMITERS.get(each, each) for each in (")", "]", r"\}", r"\rvert", r"\rangle")}
KINDS = (
    *((OPERATORS, "operator"), (BINARY, "binary"), (RELATIONS, "relation"), (OPENING, "opening"), (CLOSING, "closing")),
    ({",": ",", ";": ";"}, "comma"),
)
DEEPEST = 60


def drawn(latex: str) -> list[str]:
    """Return the lines of a formula drawn in two dimensions; the source where it is not of our dialect."""
    return [line.rstrip() for line in _box(latex, display=True).lines]


def flat(latex: str) -> str:
    """Return a formula on one line: `a/b`, `[1, 2; 3, 4]`; the source where it is not of our dialect."""
    return _box(latex, display=False).flat.strip()


def _box(latex: str, *, display: bool) -> Box:
    try:
        return _Reader(_tokens(latex)).sequence((), display)
    except _Unreadable:
        return text_box(" ".join(latex.split()))


def _tokens(latex: str) -> list[str]:
    r"""Return the tokens; the content of \text{…} is one token, since spaces count in it."""
    tokens: list[str] = []
    position = 0
    for match in TEXT.finditer(latex):
        tokens += [*TOKEN.findall(latex[position : match.start()]), r"\text", "{", match[1], "}"]
        position = match.end()
    return tokens + TOKEN.findall(latex[position:])


class _Unreadable(Exception):  # noqa: N818 - leads to the source being shown as it is
    """The formula is not of the dialect."""


class _Reader:
    """Reads tokens from left to right; `display` says whether what is read may be drawn on several lines."""

    def __init__(self, tokens: list[str]) -> None:
        self.tokens = tokens
        self.position = 0
        self.depth = 0

    def peek(self) -> str:
        return self.tokens[self.position] if self.position < len(self.tokens) else ""

    def take(self) -> str:
        if self.position >= len(self.tokens):
            raise _Unreadable
        self.position += 1
        return self.tokens[self.position - 1]

    def expect(self, token: str) -> None:
        if self.take() != token:
            raise _Unreadable

    def sequence(self, ends: tuple[str, ...], display: bool) -> Box:
        """Read up to one of some tokens (not taken) or to the end."""
        self.depth += 1
        if self.depth > DEEPEST:
            raise _Unreadable
        atoms: list[Atom] = []
        while self.position < len(self.tokens) and self.peek() not in ends:
            atom = self.atom(display)
            if atom is not None:
                atoms.append(self.scripts(atom, display))
        self.depth -= 1
        return beside(spaced(atoms))

    def group(self, closing: str, display: bool) -> Box:
        """Read from an opening token to the closing one."""
        self.take()
        box = self.sequence((closing,), display)
        self.expect(closing)
        return box

    def argument(self, display: bool) -> Box:
        """Read one argument: a group in braces or a single token."""
        if self.peek() == "{":
            return self.group("}", display)
        atom = self.atom(display)
        return atom.box if atom else text_box("")

    def atom(self, display: bool) -> Atom | None:
        """Read one piece without its scripts; None for what draws nothing."""
        token = self.peek()
        if token == "{":
            return Atom(self.group("}", display))
        if token in {"^", "_"}:  # a script of nothing
            return Atom(text_box(""))
        self.take()
        if token in FRACTIONS:
            return Atom(fraction_of(self.argument(display), self.argument(display), display), "fraction")
        if token == r"\left":
            return Atom(self.delimited(display), "closing")
        if token == r"\begin":
            return Atom(self.environment(display))
        return self.letter(token) if token in ALPHABETS or token in UPRIGHT else self.other(token, display)

    def letter(self, token: str) -> Atom:
        """Read what stands in another alphabet or upright."""
        if token.startswith(r"\text") or token == r"\mbox":
            self.expect("{")
            text = "" if self.peek() == "}" else self.take()
            self.expect("}")
            return Atom(text_box(text), "text")
        text = self.argument(False).flat
        if token in ALPHABETS:
            return Atom(text_box("".join(ALPHABETS[token].get(letter, letter) for letter in text)))
        kind = "operator" if token.startswith(r"\operatorname") else "word" if len(text) > 1 else "ordinary"
        return Atom(text_box(text), kind)

    def other(self, token: str, display: bool) -> Atom | None:
        """Read a root, an accent, a space, or a token that stands for itself."""
        if token == r"\sqrt":
            return self.root(display)
        if token in ACCENTS:
            return Atom(accented(self.argument(display), ACCENTS[token]))
        if token == r"\xrightarrow":
            return Atom(text_box(f"──{self.argument(False).flat}──→"), "relation")
        if token in SPACES:
            return Atom(text_box(SPACES[token]), "space") if SPACES[token] else None
        return _simple(token)

    def scripts(self, base: Atom, display: bool) -> Atom:
        """Read the sub- and superscript after an atom."""
        scripts: dict[str, Box] = {}
        while self.peek() in {"^", "_", "'"}:
            mark = self.take()
            if mark == "'":
                base = Atom(beside([base.box, text_box("′")]), base.kind)
            else:
                scripts[mark] = self.argument(False)
        return with_scripts(base, scripts, display) if scripts else base

    def root(self, display: bool) -> Atom:
        index = self.group("]", False).flat if self.peek() == "[" else ""
        sign = text_box("".join(SUPERSCRIPTS.get(letter, letter) for letter in index) + "√")
        content = self.argument(display)
        if content.height > 1 or (len(content.flat) > 1 and not content.flat.isalnum()):
            content = enclosed(content, "(", ")")
        return Atom(beside([sign, content]))

    def delimited(self, display: bool) -> Box:
        left = self.delimiter()
        parts = [self.sequence((r"\right", r"\middle"), display)]
        while self.peek() == r"\middle":
            self.take()
            parts += [text_box(f" {self.delimiter()} "), self.sequence((r"\right", r"\middle"), display)]
        self.expect(r"\right")
        return enclosed(beside(parts), left, self.delimiter())

    def delimiter(self) -> str:
        token = self.take()
        return DELIMITERS.get(token, token)

    def environment(self, display: bool) -> Box:
        name = self.name()
        if name not in MATRICES:
            raise _Unreadable
        columns = self.name() if name == "array" else ""
        rules: list[int] = []
        rows = self.rows(display, rules)
        if self.name() != name:
            raise _Unreadable
        return tabular(name, columns, rows, display, rules)

    def name(self) -> str:
        """Read a name in braces."""
        self.expect("{")
        name = ""
        while self.peek() != "}":
            name += self.take()
        self.expect("}")
        return name

    def rows(self, display: bool, rules: list[int]) -> list[list[Box]]:
        r"""Read cells up to \end, which is taken; all rows get the same number of cells. `rules` get the \hline."""
        rows: list[list[Box]] = [[]]
        end = ""
        while end != r"\end":
            if not rows[-1] and self.peek() == r"\hline":
                rules.append(len(rows) - 1)
            rows[-1].append(self.sequence(("&", "\\\\", r"\end"), display))
            end = self.take()
            if end == "\\\\":
                rows.append([])
        if len(rows) > 1 and len(rows[-1]) == 1 and not rows[-1][0].flat.strip():
            rows.pop()
        width = max(len(row) for row in rows)
        return [row + [text_box("")] * (width - len(row)) for row in rows]


def _simple(token: str) -> Atom | None:
    """Return the atom of a single token; None if it draws nothing."""
    for table, kind in KINDS:
        if token in table:
            return Atom(text_box(table[token]), kind)
    if token in INVISIBLE:
        return None
    if token in CLOSING_TOKENS:
        raise _Unreadable
    kind = "word" if len(token) > 1 and token[0].isalpha() else "ordinary"
    return Atom(text_box(SYMBOLS.get(token, token.lstrip("\\"))), kind)
