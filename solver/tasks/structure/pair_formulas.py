"""What follows from the matrix of controllability or observability: determinant, rank, verdict."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from solver.lazy import exact
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from solver.derivation import Given, Task

Found = Mapping[str, Any]


def register(task: Task[Any, Any], matrix: str, verdict: str) -> None:
    """Register the formulas of a task whose answers have these names."""

    @task.consequence("determinant", of=(matrix,))
    def determinant(_given: Given[Any, Any], found: Found) -> Any:
        M = found[matrix]
        return exact.determinant(M) if M.is_square else None

    @task.consequence("rank", of=(matrix,), symbolic=False)
    def rank(_given: Given[Any, Any], found: Found) -> Any:
        return sp.Integer(exact.rank(found[matrix]))

    @task.consequence(verdict, of=("rank",), symbolic=False)
    def full(given: Given[Any, Any], found: Found) -> Any:
        return bool(found["rank"] == given.system.order)

    @task.consequence(verdict, of=("determinant",), symbolic=False)
    def regular(_given: Given[Any, Any], found: Found) -> Any:
        return bool(found["determinant"] != 0)
