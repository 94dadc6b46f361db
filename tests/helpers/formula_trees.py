"""Random trees of formulas, as the reader would return them, for hypothesis."""

from __future__ import annotations

import string

from hypothesis import strategies as st

from solver.formula import latex
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
from solver.formula.reader import Reader


def anew(formula: str) -> Row:
    """Return the tree of a formula as it is read, whether it was written before or not; raises MathProblem."""
    return Reader(formula).row("")


def _rows(parts: st.SearchStrategy[Node]) -> st.SearchStrategy[Row]:
    """Rows whose digits do not run together."""
    return st.lists(parts, max_size=4).map(_apart).map(Row)


def _apart(items: list[Node]) -> tuple[Node, ...]:
    kept: list[Node] = []
    for item in items:
        digits = (Number, Space) if kept and isinstance(kept[-1], Number) else ()
        if not isinstance(item, digits) and not (isinstance(item, Scripts) and isinstance(item.base, digits)):
            kept.append(item)
    return tuple(kept)


LEAVES = st.one_of(
    st.builds(Number, st.sampled_from(["0", "36", "0.25"])),
    st.builds(Symbol, st.sampled_from(sorted(v.SYMBOLS - v.GREEK_LETTERS.keys()))),
    st.builds(Operator, st.sampled_from(sorted((v.OPERATORS - v.BRACKETS) - {"."}))),
    st.builds(Function, st.sampled_from(sorted(name[1:] for name in v.FUNCTIONS))),
    st.builds(Function, st.sampled_from(["adj", "rank"]), st.just(True)),
    st.builds(Text, st.text(string.ascii_letters + " ,", max_size=5), st.sampled_from([r"\text", r"\textbf"])),
    st.builds(Space, st.sampled_from(sorted(v.SPACES))),
)


def _structures(parts: st.SearchStrategy[Node]) -> st.SearchStrategy[Node]:
    rows = _rows(parts)
    bases = parts.filter(lambda node: not isinstance(node, Scripts | Space | Number))
    lines = st.integers(1, 2).flatmap(lambda n: st.lists(st.tuples(*[rows] * n), min_size=1, max_size=2))
    return st.one_of(
        rows,
        st.builds(Fraction, rows, rows, st.sampled_from(sorted(v.FRACTIONS))),
        st.builds(Root, rows, st.none() | rows.filter(lambda row: "]" not in latex(row))),
        st.builds(Scripts, bases, rows, st.none() | rows),
        st.builds(Scripts, bases, st.none(), st.none(), st.integers(1, 3)),
        st.builds(lambda body, tall: Fenced("(", body, ")", tall), rows, st.booleans()),
        st.builds(lambda body: Fenced(r"\{", body, r"\rvert", tall=True), rows),
        st.builds(Accent, st.sampled_from(sorted(v.ACCENTS)), rows),
        st.builds(Stacked, st.sampled_from(sorted(v.STACKS)), rows, rows),
        st.builds(Styled, st.sampled_from(sorted(v.ALPHABETS)), rows),
        st.builds(Table, st.sampled_from(["bmatrix", "cases", "aligned"]), lines.map(tuple).filter(_last_is_kept)),
        st.builds(Table, st.just("array"), lines.map(tuple).filter(_last_is_kept), st.just("c|c"), st.just((0, 1))),
    )


def _last_is_kept(rows: tuple[tuple[Row, ...], ...]) -> bool:
    """Whether the last row is not one empty cell, which would end the table without it."""
    return rows[-1] != (Row(),)


TREES = _rows(st.recursive(LEAVES, _structures, max_leaves=12)).filter(lambda row: latex(row).strip() != "")
