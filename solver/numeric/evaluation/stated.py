"""Evaluation of formulas as stated (`solver.stated`): each operation by the module of its name in `operations`.

Such a module has `evaluate(environment, *operands)`, and as far as they apply to it

- `ORACLE`, the name of its algorithm for the table of checks, and how telling it is;
- `SAMPLED`, where it evaluates its operands at many points;
- `ENTRYWISE`, where each entry of the result is what it makes of the same entry of the one matrix among its operands
  (sums: of all of them; products of several: of a row of the first and the others);
- `poles(operands, s, point)` and `zeros(operands, s, point)`: arrays that hold the poles (zeros) in s, perhaps more;
- `reach(environment, *operands)`: up to which value, at each point, doubles can take a symbol;
- `admitted(points, *operands)`: the points, moved to where the operation has a value.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from importlib import import_module
from types import ModuleType
from typing import Any, NamedTuple

from solver.numeric.evaluation import operations
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import NoRule, Value
from solver.numeric.evaluation.walk import rule
from solver.stated import Stated
from solver.words import Phrase


class Oracle(NamedTuple):
    """Names an algorithm. Of several that take part in a check the one of the highest `weight` is named."""

    weight: int
    name: str


@cache
def _module_of(operation: str) -> ModuleType:
    full_name = f"{operations.__name__}.{operation}"
    try:
        return import_module(full_name)
    except ModuleNotFoundError as missing:
        if missing.name != full_name:
            raise
        raise NoRule(Phrase("the operation {operation}", operation=operation)) from missing


@cache
def about(operation: str, aspect: str) -> Any:
    """Return what the module of an operation says under a name; None if it says nothing."""
    return getattr(_module_of(operation), aspect, None)


@rule(Stated)
def _stated(formula: Stated, environment: Environment) -> Value:
    evaluate: Callable[..., Value] = about(formula.operation, "evaluate")
    return evaluate(environment, *formula.operands)
