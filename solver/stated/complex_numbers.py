"""Parts, absolute value and direction of complex numbers; norms of vectors and matrices."""

from __future__ import annotations

from typing import Any, Literal

from solver.formula.building import parenthesized, row
from solver.formula.nodes import Accent, Fenced, Row, Scripts
from solver.stated.declaration import Printer, Show, Stated, operation

NormKind = Literal["2", "1", "oo", "F"]


def real_part(value: Any) -> Stated:
    """Re x, entry by entry."""
    return Stated("real_part", (value,))


def imaginary_part(value: Any) -> Stated:
    """Im x, entry by entry."""
    return Stated("imaginary_part", (value,))


def conjugate(value: Any) -> Stated:
    """The conjugate of x, entry by entry."""
    return Stated("conjugate", (value,))


def absolute(value: Any) -> Stated:
    """|x| of a scalar."""
    return Stated("absolute", (value,))


def argument(value: Any) -> Stated:
    """arg x of a scalar, in radians: −π < arg x ≤ π."""
    return Stated("argument", (value,))


def phase(value: Any) -> Stated:
    """The angle of a scalar in degrees: −180° < ∠x ≤ 180°; its value is the number of degrees."""
    return Stated("phase", (value,))


def arctangent(value: Any) -> Stated:
    """arctan x of a real scalar in degrees, −90° < arctan x < 90°; its value is the number of degrees."""
    return Stated("arctangent", (value,))


def norm(value: Any, kind: NormKind = "2") -> Stated:
    """‖x‖ of a vector or matrix: its largest gain from vector norm to vector norm (1, 2, ∞), or Frobenius' norm."""
    return Stated("norm", (value, kind))


def _before(operator: str) -> Printer:
    def write(show: Show, value: Any) -> Row:
        return row(operator, parenthesized(show(value)))

    return write


operation(real_part)(_before(r"\operatorname{Re}"))
operation(imaginary_part)(_before(r"\operatorname{Im}"))
operation(argument)(_before(r"\operatorname{arg}"))
operation(phase)(_before(r"\angle"))
operation(arctangent)(_before(r"\arctan"))


@operation(conjugate)
def _conjugate(show: Show, value: Any) -> Row:
    return row(Accent(r"\overline", show(value)))


@operation(absolute)
def _absolute(show: Show, value: Any) -> Row:
    return row(Fenced("|", show(value), "|", tall=True))


@operation(norm)
def _norm(show: Show, value: Any, kind: NormKind) -> Row:
    bars = Fenced(r"\|", show(value), r"\|", tall=True)
    return row(bars if kind == "2" else Scripts(bars, row(r"\infty" if kind == "oo" else kind)))
