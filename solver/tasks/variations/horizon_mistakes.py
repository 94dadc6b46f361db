"""Usual mistakes with finite horizons: the end forgotten, the recursion one step off, the steady gain taken."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks import mistakes
from solver.tasks.variations.horizon_question import HorizonOptions, HorizonQuestion

if TYPE_CHECKING:
    from solver.derivation import Task
    from solver.systems import System
    from solver.tasks.needed import WithInput

WITHOUT_END = Slip("without_terminal_weight", "the weight of the final state is forgotten: $P(T) = S$")
STEADY = Slip("steady", "it is the limit of a long horizon; over a finite one it depends on the time")
FORWARD = Slip("forward", "it runs forward from $t = 0$; the end fixes $P$, so it runs back from $T$")
REVERSED_ORDER = Slip("order", "the list stands in the order of the recursion; it is asked for from $k = 0$ on")
ONE_STEP_OFF = Slip("one_step_off", "the gains are made with $P_{k}$; they are those of $P_{k+1}$")
NOT_HALVED = Slip("not_halved", "the factor before the integral is forgotten")
WITHOUT_R = Slip("without_weight", "the weight $R^{-1}$ is forgotten")


def register(task: Task[WithInput, HorizonOptions]) -> None:
    """Register what goes wrong with regulators over a finite horizon."""
    task.mistaken_question(WITHOUT_END)(without_terminal_weight)
    task.mistaken_question(WITHOUT_R)(without_weight)
    task.mistake(mistakes.GAIN_ADDED, "K")(reversed_sign)
    task.mistake(STEADY, "P", "K")(of_a_long_horizon)
    task.mistake(FORWARD, "P", "K")(run_forward)
    task.mistake(REVERSED_ORDER, "P", "K")(in_reversed_order)
    task.mistake(ONE_STEP_OFF, "K")(one_step_off)
    task.mistake(NOT_HALVED, "cost")(whole_cost)


def without_terminal_weight(system: System, options: HorizonOptions) -> tuple[System, HorizonOptions] | None:
    """The question with S = 0."""
    S = options.terminal_weight
    return None if S is None or not any(S.flat()) else (system, replace(options, terminal_weight=None))


def without_weight(system: System, options: HorizonOptions) -> tuple[System, HorizonOptions] | None:
    """The question with R = I."""
    R = options.R
    return None if R is None or sp.eye(R.rows) == R else (system, replace(options, R=None))


def reversed_sign(wrong: Attempt[WithInput, HorizonOptions]) -> Iterable[Any]:
    """−K."""
    ours = wrong.ours
    yield [-each for each in ours] if isinstance(ours, list) else -ours


def of_a_long_horizon(wrong: Attempt[WithInput, HorizonOptions]) -> Iterable[Any]:
    """P∞, and the gain that it gives."""
    limit = wrong.answers.get("P_infinite")
    if limit is None or wrong.given.options.steps is not None:
        return
    asked = HorizonQuestion.of(wrong.given)
    if wrong.name == "P":
        yield limit
    else:
        yield sp.ImmutableMatrix(asked.restored(exact.weighted_transpose(asked.B, asked.R)) * limit)


def run_forward(wrong: Attempt[WithInput, HorizonOptions]) -> Iterable[Any]:
    """The functions of T − t taken for those of t."""
    t, T = sp.Symbol("t"), wrong.given.options.final_time
    if T is not None and hasattr(wrong.ours, "xreplace"):
        yield sp.ImmutableMatrix(wrong.ours.xreplace({t: T - t}))


def in_reversed_order(wrong: Attempt[WithInput, HorizonOptions]) -> Iterable[Any]:
    """P_N, …, P₀ for P₀, …, P_N."""
    if isinstance(wrong.ours, list):
        yield wrong.ours[::-1]


def one_step_off(wrong: Attempt[WithInput, HorizonOptions]) -> Iterable[Any]:
    """(R + BᵀP_kB)⁻¹BᵀP_kA for each k."""
    if not isinstance(wrong.ours, list):
        return
    asked = HorizonQuestion.of(wrong.given)
    found = exact.riccati_recursion(asked.A, asked.B, asked.Q, asked.R, asked.S, len(wrong.ours))
    earlier = exact.riccati_recursion(asked.A, asked.B, asked.Q, asked.R, found.P[0], 1)
    yield [asked.restored(each) for each in (earlier.K[0], *found.K[:-1])]


def whole_cost(wrong: Attempt[WithInput, HorizonOptions]) -> Iterable[Any]:
    """The cost without the factor before it."""
    yield wrong.ours / HorizonQuestion.of(wrong.given).factor
