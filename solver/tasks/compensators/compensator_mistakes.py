"""What goes wrong where compensators are designed, and what follows from what."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Given, Slip, Task
from solver.lazy import sympy as sp
from solver.numeric.judges import compensators as judges

if TYPE_CHECKING:
    from solver.tasks.compensators.specifications import CompensatorOptions

DECIBELS = Slip("decibels", "the gain is in decibels; K is a ratio")
UPSIDE_DOWN = Slip("alpha_upside_down", r"$\alpha$ is upside down: this is $1/\alpha$")

Designed = Attempt[Any, "CompensatorOptions"]


def register(task: Task[Any, CompensatorOptions]) -> None:
    """Register the usual mistakes of a task, and which answers follow from others."""
    task.mistake(DECIBELS, "K")(in_decibels)
    task.mistake(UPSIDE_DOWN, "alpha")(upside_down)
    task.consequence("controller", of=("K", "T", "alpha"), symbolic=False)(controller_of)


def in_decibels(wrong: Designed) -> Iterable[Any]:
    """20 log₁₀ K."""
    if wrong.ours.is_positive and wrong.ours != 1:
        yield sp.N(20 * sp.log(wrong.ours, 10), 30)


def upside_down(wrong: Designed) -> Iterable[Any]:
    """1/α."""
    yield [1 / each for each in wrong.ours] if isinstance(wrong.ours, list) else 1 / wrong.ours


def controller_of(_given: Given[Any, CompensatorOptions], found: Mapping[str, Any]) -> Any:
    """K Π (T s + 1)/(α T s + 1)."""
    return judges.controller_from(found["K"], found["T"], found["alpha"], sp.Symbol("s"))
