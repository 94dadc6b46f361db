"""Formulas as typst, one of the visitors of the tree. The document that holds a formula begins with `PRELUDE`."""

from __future__ import annotations

from solver.formula.nodes import Node, Row, Table
from solver.formula.typst.writer import IN_LINE, WRITER

PRELUDE = """\
#let framed(body) = box(stroke: 0.5pt, inset: (x: 0.4em, y: 0.4em), { set par(leading: 0pt); math.equation(body) })
#let roomy(body) = box(inset: (y: 0.55em), math.equation(body))
#set math.mat(row-gap: 0.55em, column-gap: 0.9em)
"""
"""A frame and room, which typst's formulas do not have, and how far apart the cells of matrices stand."""


def typst(node: Node, *, in_line: bool = False) -> str:
    """Return a tree as typst's formula, without dollar signs; equations alone in it as the lines of a display."""
    match node:
        case Row((Table("aligned") as table,)) if not in_line:
            return WRITER.equations(table)
    return node.accept(IN_LINE if in_line else WRITER)
