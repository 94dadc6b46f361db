"""The two sides of an equality, and those of some entries of it.

With many digits an entry is dear: where doubles leave a few open, only these are evaluated.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any, NamedTuple

import sympy as sp
from sympy.matrices.matrixbase import MatrixBase

from solver.matrices import entries
from solver.numeric.evaluation.arithmetic import Arithmetic
from solver.numeric.evaluation.environment import Environment, Point
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.stated import about
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import Entries
from solver.stated import Stated


class Sides(NamedTuple):
    """An equality, and where it is evaluated; `at` returns the environment of some points."""

    left: Any
    right: Any
    at: Callable[[Sequence[Point], Arithmetic], Environment] = Environment.at

    def values(self, points: Sequence[Point], arithmetic: Arithmetic) -> tuple[Value, Value]:
        """Return the values of both sides at some points; raises Undefined or NotEvaluable."""
        environment = self.at(points, arithmetic)
        return value_of(self.left, environment), value_of(self.right, environment)

    def of_entries(self, chosen: Iterable[int], count: int) -> Sides | None:
        """Return the sides of some of the entries of matrices with `count` entries, numbered row by row.

        None where a side does not say what each entry is by itself.
        """
        left, right = (_column(side, list(chosen), count) for side in (self.left, self.right))
        return None if left is None or right is None else self._replace(left=left, right=right)


ARITHMETIC = frozenset({"total", "difference", "product", "quotient"})
"""Operations that do no more with their operands than evaluate them; others look into matrices."""


def _column(formula: Any, chosen: Sequence[int], count: int, form: Callable[..., Any] = Entries) -> Any:
    """Return the chosen entries of a formula as a column; None where they can't be told by themselves.

    Matrices become of a `form` that is made of entries and a shape.
    """
    if isinstance(formula, MatrixBase):
        each = entries(formula)
        return form([each[k] for k in chosen], (len(chosen), 1)) if len(each) == count else None
    if not isinstance(formula, Stated) or not about(formula.operation, "ENTRYWISE"):
        return None
    form = form if formula.operation in ARITHMETIC else _matrix
    operands = list(formula.operands)
    matrices = [i for i, each in enumerate(operands) if not _is_scalar(each)]
    if formula.operation == "product" and len(matrices) > 1:
        first = operands[matrices[0]]
        if not isinstance(first, MatrixBase) or first.rows != count:  # else the product is a column
            return None
        rows = [entry for k in chosen for entry in entries(first)[k * first.cols : (k + 1) * first.cols]]
        operands[matrices[0]] = form(rows, (len(chosen), first.cols))
    else:
        for i in matrices:
            operands[i] = _column(operands[i], chosen, count, form)
    return None if any(each is None for each in operands) else Stated(formula.operation, tuple(operands))


def _matrix(each: Sequence[Any], shape: tuple[int, int]) -> Any:
    return sp.ImmutableMatrix(*shape, each)


def _is_scalar(formula: Any) -> bool:
    """Whether a formula is no matrix for sure."""
    if isinstance(formula, Stated):
        return bool(about(formula.operation, "ENTRYWISE")) and all(map(_is_scalar, formula.operands))
    return isinstance(formula, sp.Expr | int) and not isinstance(formula, MatrixBase)
