"""How the pieces of a formula stand together on a terminal: spaces, fractions, scripts, matrices."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

from solver.formula.terminal.boxes import Box, beside, enclosed, fraction, grid, scripted, stacked, text_box
from solver.formula.terminal.characters import SUBSCRIPTS, SUPERSCRIPTS

FENCES = {"bmatrix": "[]", "pmatrix": "()", "vmatrix": "||", "Vmatrix": "‖‖", "Bmatrix": "{}", "cases": "{."}
"""What stands left and right of a table."""

LIMITS = {"Σ", "Π", "lim"}
"""Their scripts stand above and below in display."""

ONE_NAME = r"(?:\d[\d.]*|[^\W\d_](?:_[a-z\d]+)?)[\u2080-\u209c\u1d62-\u1d6a]*"
"""A number or a letter, with its indices: what needs no parentheses below a root."""

ONE_FACTOR = rf"√?{ONE_NAME}[\u2070-\u209c\u00b2\u00b3\u00b9\u1d2c-\u1d6a]*"
"""The same with exponents, perhaps below a root: what needs no parentheses after a slash."""

FACTORS = {"ordinary", "word", "operator", "opening", "closing", "fraction"}
BEFORE_SIGNS = {"", "binary", "sign", "relation", "opening", "comma", "operator", "label"}
KINDS = (*FACTORS, "binary", "sign", "relation", "comma", "text", "label", "space")
BLANK = text_box(" ")


class Atom(NamedTuple):
    """A piece of a formula: its box and its kind, which decides the spaces around it."""

    box: Box
    kind: str = "ordinary"  # binary, relation, opening, closing, operator, comma, word, text, label, fraction, space


def spaced(atoms: Sequence[Atom]) -> list[Box]:
    """Return the boxes with the spaces that the kinds ask for between them."""
    boxes: list[Box] = []
    before = visible = ""
    height = 0
    for index, atom in enumerate(atoms):
        box, kind = atom
        if kind == "binary" and visible in BEFORE_SIGNS:
            kind = "sign"
        if kind == "fraction" and box.height == 1:
            after = atoms[index + 1].kind if index + 1 < len(atoms) else ""
            if after in FACTORS or before in FACTORS:
                box = enclosed(box, "(", ")")
        pair, tall = (before, kind), max(height, box.height) > 1
        if pair in _APART or (tall and pair in _BESIDE_FRACTIONS):
            boxes.append(BLANK)
        boxes.append(box)
        before, visible, height = kind, visible if kind == "space" else kind, box.height
    return boxes


def _is_apart(before: str, kind: str) -> bool:
    """Whether a space stands between two atoms."""
    if not before or "space" in (before, kind) or before == "sign":
        return False
    if {before, kind} & {"binary", "relation"} or before == "comma":
        return kind != "comma"
    if kind == "operator":
        return before in {"ordinary", "word", "closing", "fraction", "operator"}
    if before in {"operator", "word"}:
        return kind in {"ordinary", "word", "fraction"}
    return kind == "word" and before in {"ordinary", "closing", "fraction"}


_APART = frozenset(pair for pair in product(KINDS, KINDS) if _is_apart(*pair))
_BESIDE_FRACTIONS = frozenset(pair for pair in product(FACTORS, FACTORS) if "fraction" in pair)


def fraction_of(above: Box, below: Box, display: bool) -> Box:
    """Return a fraction: with a bar for display, but numbers and fractions in a line of text as a/b."""
    simple = above.height == below.height == 1 and above.flat.isdigit() and below.flat.isdigit()
    if display and not simple:
        return fraction(above, below)
    return text_box(f"{_as_operand(above.flat)}/{_as_operand(below.flat, below=True)}")


def _as_operand(text: str, below: bool = False) -> str:
    """Return the text, in parentheses unless it is one factor."""
    simple = re.fullmatch(ONE_FACTOR if below else r"-?[\w.√⁰¹²³⁴-⁹₀-₉ⁿ⁻ᵗ]+", text) is not None
    whole = text.startswith("(") and text.find(")") == len(text) - 1
    return text if simple or whole else f"({text})"


def accented(box: Box, mark: str) -> Box:
    """Put a combining mark on a letter, or after anything longer."""
    text = box.flat
    if box.height > 1 or len(text) != 1:
        return beside([enclosed(box, "(", ")"), text_box(mark)]) if box.height > 1 else text_box(text + mark)
    return text_box(unicodedata.normalize("NFC", text + mark))


def with_scripts(atom: Atom, scripts: dict[str, Box], display: bool) -> Atom:
    """Return an atom with scripts: as small letters where Unicode has them, else raised, or `^(…)` in a line."""
    base, kind = atom.box, "ordinary" if atom.kind == "fraction" else atom.kind
    if display and base.flat in LIMITS:
        above, below = scripts.get("^", text_box("")), scripts.get("_", text_box(""))
        return Atom(stacked([above, base, below], above.height), "operator")
    tables = {"^": SUPERSCRIPTS, "_": SUBSCRIPTS}
    left: dict[str, Box] = {}
    for mark in ("_", "^"):
        if mark not in scripts:
            continue
        text = scripts[mark].flat.replace(" ", "")
        if base.height == 1 and scripts[mark].height == 1 and text and all(c in tables[mark] for c in text):
            base = beside([base, text_box("".join(tables[mark][c] for c in text))])
        else:
            left[mark] = scripts[mark]
    if not left:
        return Atom(base, kind)
    if display and "^" in left:
        return Atom(scripted(base, left["^"], left.get("_")), kind)
    linear = [text_box(mark + _script(mark, box.flat)) for mark, box in left.items()]
    return Atom(beside([base, *linear]), "word" if kind == "ordinary" else kind)


def _script(mark: str, text: str) -> str:
    """Return a script as it stands in a line: `K_co`, `e^(λt)`."""
    return text if len(text) == 1 or (mark == "_" and text.isalnum()) else f"({text})"


def _on_one_line(row: Sequence[Box], *, goes_on: bool) -> str:
    """Return a row of an aligned block with what separates it from the one before, which it may go on with."""
    text = " ".join(" ".join(box.flat for box in row).split())
    if not goes_on:
        return f"; {text}"
    return " " + re.sub(r"^([+−])(?=\S)", r"\1 ", text)


def tabular(name: str, columns: str, rows: list[list[Box]], display: bool, rules: Sequence[int] = ()) -> Box:
    """Lay out a matrix or an aligned block; a line stands before each of the rows `rules` (from 0)."""
    left, right = tuple(FENCES.get(name, ".."))
    count = len(rows[0])
    if not display and name == "aligned":
        lines = [_on_one_line(row, goes_on=number > 0 and not row[0].flat.strip()) for number, row in enumerate(rows)]
        return text_box("".join(lines).removeprefix("; "))
    if not display:
        inside = "; ".join(", ".join(box.flat.strip() for box in row) for row in rows)
        return text_box(f"{left.strip('.')}{inside}{right.strip('.')}")
    if name == "aligned":
        rows = [[beside([box, text_box(" ")]) if j % 2 == 0 else box for j, box in enumerate(row)] for row in rows]
        aligns = "".join("rl"[j % 2] for j in range(count))
        return grid(rows, aligns, ["", *(["", "  "] * count)[: count - 1]])
    letters = "".join(c for c in columns if c in "lcr")
    default = "l" if name == "cases" else "c"
    aligns = (letters + default * count)[:count]
    bars = _bars(columns)
    gaps = ["", *(" │ " if j in bars else "  " for j in range(1, count))]
    body = grid(rows, aligns, gaps, rules)
    if left + right != ".." and name != "cases":
        body = beside([_blank(body), body, _blank(body)]) if count > 1 or body.height > 1 else body
    return enclosed(body, left, right)


def _bars(columns: str) -> list[int]:
    """Return before which columns of "cc|c" a bar stands."""
    return [len(columns[:index].replace("|", "")) for index, c in enumerate(columns) if c == "|"]


def _blank(box: Box) -> Box:
    return Box((" ",) * box.height, box.baseline)
