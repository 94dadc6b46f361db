"""Asking the engine one question, as tests do."""

from typing import Any

import numpy as np
import sympy as sp

from solver.derivation import Answers, CheckStatus, PartResult
from solver.engine import solve_part
from solver.problem.model import Part
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.problem.template import new_problem
from solver.systems import StateSpace
from solver.tasks import catalogue

COMPENSATED = {
    "error": sp.Rational(1, 20),
    "phase_margin": sp.Integer(50),
    "poles": (-2 + 2 * sp.I, -2 - 2 * sp.I),
}
EXAMPLE_OPTIONS: dict[str, dict[str, Any]] = {
    "desired_poles": {"damping_ratio": sp.Rational(1, 2), "settling_time": sp.Integer(4)},
    "pole_placement": {"poles": (sp.Integer(-1), sp.Integer(-2))},
    "reference_tracking": {"poles": (sp.Integer(-1), sp.Integer(-2))},
    "servo": {"poles": (sp.Integer(-1), sp.Integer(-2), sp.Integer(-3))},
    "model_matching": {"target": 1 / ((sp.Symbol("s") + 1) * (sp.Symbol("s") + 4))},
    "matrix_function": {"function": sp.Symbol("A") ** 5},
    "similarity_transformation": {"T": sp.ImmutableMatrix([[1, 1], [1, 2]])},
    "lqr": {"R": sp.ImmutableMatrix([[1]])},
    "kalman_filter": {"R": sp.ImmutableMatrix([[1]])},
    "optimal_tracking": {"R": sp.ImmutableMatrix([[1]])},
    "observer": {"poles": (sp.Integer(-4), sp.Integer(-5))},
    "reduced_observer": {"poles": (sp.Integer(-4),)},
    "observer_feedback": {
        "poles": (sp.Integer(-1), sp.Integer(-2)),
        "observer_poles": (sp.Integer(-4), sp.Integer(-5)),
    },
    "steady_state_error": {"reference": sp.Integer(1), "feedback": sp.Integer(1)},
    "pid_tuning": {"controller_type": "PID", "poles": tuple(map(sp.Integer, (-1, -2, -3)))},
    **dict.fromkeys(("lead_compensator", "lag_compensator", "lead_lag_compensator"), COMPENSATED),
    "response": {"kind": "zero_state", "input": (sp.Integer(1),)},
}
"""Options that suit most plants, for tasks that cannot be asked without them; used where all tasks are tried."""


def example_options(task: str) -> dict[str, Any]:
    """Options with which a task can be asked: those above, or those of the file that `solve new` writes."""
    declared = catalogue()[task]
    if task in EXAMPLE_OPTIONS or not any(option.required for option in declared.options.values()):
        return EXAMPLE_OPTIONS.get(task, {})
    return dict(read_problem(Source("new.yaml", new_problem(declared)), catalogue()).parts[0].options)


def system(rows: Any, *, discrete: bool = False, **matrices: Any) -> StateSpace:
    """A system from nested lists or matrices."""
    exact = {name: sp.ImmutableMatrix(M) for name, M in matrices.items()}
    return StateSpace(sp.ImmutableMatrix(rows), discrete=discrete, **exact)


def ask(task: str, plant: StateSpace, method: str = "", **options: Any) -> PartResult:
    """The result of one part by one method (the first that fits, if none is named)."""
    declared = catalogue()[task]
    method = method or declared.methods_for(plant.discrete)[0]
    filled = {
        name: option.default for name, option in declared.options_for(method).items() if option.default is not None
    }
    asked = options or example_options(task)
    return solve_part(Part("a", task, (method,), plant, {**filled, **asked}), {})[0]


def rejected(task: str, plant: StateSpace, answers: dict[str, Any], **options: Any) -> bool:
    """Whether the task's verification finds the answers wrong."""
    declared = catalogue()[task]
    checks = list(declared.verify(declared.given(plant, options), Answers(**answers)))
    return any(check.status is CheckStatus.FAILED for check in checks)


def at(value: sp.MatrixBase, **point: float) -> np.ndarray:
    """A matrix of expressions as floats at a point, by sympy's own evaluation."""
    numbers = {sp.Symbol(name): number for name, number in point.items()}
    return np.array(value.subs(numbers).evalf(30).tolist(), dtype=complex)
