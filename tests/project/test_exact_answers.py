"""Exact answers are verified as exact: each number of each, a billionth off or by one in its last digit, is seen."""

from collections.abc import Iterator
from itertools import islice
from typing import Any

import pytest
import sympy as sp

from solver.derivation import Answers, CheckStatus, Status
from solver.engine import given_of
from solver.numeric import holds_decimals
from solver.tasks import catalogue
from tests.helpers.solved import PROBLEMS, by_problem, solution_of

QUICK = ("lqr", "matrix-function")
BESIDE = sp.Rational(10**9 + 1, 10**9)
MOST = 4
"""Changed values of each matrix or list that are tried."""

VARIED = ("increment", "first_variation", "second_variation")
EXTREMAL = ("x", "value", "t_f", "legendre", "conjugate_point")
TRANSFER = ("u", "x", "cost", "costates", "gramian")
HORIZON = ("P", "K", "x", "u", "cost", "P_infinite")
NOT_SEEN = {
    ("eigenstructure", "right_eigenvectors"): "a multiple of an eigenvector is one",
    ("eigenstructure", "left_eigenvectors"): "a multiple of an eigenvector is one",
    ("fundamental_subspaces", "column_space"): "any basis of the space is right",
    ("fundamental_subspaces", "row_space"): "any basis of the space is right",
    ("fundamental_subspaces", "null_space"): "any basis of the space is right",
    ("fundamental_subspaces", "left_null_space"): "any basis of the space is right",
    ("realization", "B"): "it is judged with matrices in decimals, or another scale of a state is right too",
    ("optimal_tracking", "F"): "another state of rest is right too, or it is judged with a gain in decimals",
    ("routh_hurwitz", "array"): "rows with a small ε are compared to six digits",
    ("stability", "array"): "rows with a small ε are compared to six digits",
    ("stability_range", "condition"): "a bound of a few decimals may be a rounded one",
    ("response", "x"): "integrals and derivatives are known to ten digits, an integer may have fifteen",
    **{("linearization", name): "it is judged by differences of the equations, to seven digits" for name in "ABCD"},
    ("linearization", "conditions"): "it is judged by differences of the equations, to seven digits",
    **{("state_space_model", name): "derivatives in doubles are compared by the largest" for name in "ABCD"},
    **{("state_space_model", name): "the equations are solved by Newton's method" for name in ("f", "h", "eliminated")},
    **{
        ("equations_of_motion", name): "the action and the energy are sampled, to eight digits"
        for name in ("kinetic", "potential", "lagrangian", "equations", "M", "C", "gravity")
    },
    ("initial_state", "x0"): "the motion is summed in doubles",
    **{("functional_variation", name): "the functional is varied in doubles" for name in VARIED},
    **{("extremal", name): "it is judged by quadrature and integration in doubles" for name in EXTREMAL},
    **{("minimum_energy_control", name): "it is judged by quadrature in doubles" for name in TRANSFER},
    **{("finite_horizon_lqr", name): "it is judged by integration, and by costs, in doubles" for name in HORIZON},
    ("extremal", "equations"): "a multiple of what is zero is right",
    ("minimum_energy_control", "equations"): "a multiple of what is zero is right",
    ("finite_horizon_lqr", "riccati_equations"): "a multiple of what is zero is right",
    ("analog_program", "overload_time"): "it is judged by a simulation",
    ("response", "y"): "integrals and derivatives are known to ten digits, an integer may have fifteen",
}
"""Answers of which some changes pass, and why."""

LATE = "what varies, or jumps later than at the start, is simulated with ten digits"
NOT_SEEN_IN = dict.fromkeys(
    [
        *((stem, name) for stem in ("dead-time", "delayed-inputs") for name in ("y_peak", "t_peak", "y_final")),
        ("response-discrete", "y_final"),
        *(("responses-by-name", name) for name in ("y_peak", "t_peak")),
    ],
    LATE,
)
NOT_SEEN_IN |= {
    ("ch6-text-qtank-instance", name): "roots of polynomials with integers of twenty digits"
    for name in ("zeros", "zero_directions", "invariant_zeros")
}
NOT_SEEN_IN |= {
    ("routh-two-parameters", "condition"): "a bound that two others imply may be any larger one",
    ("jury", "condition"): "a bound on two parameters is judged at points of their plane",
    **{
        ("appC-final3-pos", name): "a root of an integer of thirty digits"
        for name in ("resonant_peak", "bandwidth", "gain_crossover")
    },
}
"""The same of single problems."""


def beside(value: Any) -> Iterator[Any]:
    """The value with a number in it that is a little wrong."""
    if isinstance(value, bool | str):
        return
    if isinstance(value, int):
        yield value + 1
    elif isinstance(value, sp.MatrixBase):
        items = list(value)
        changed = ([*items[:i], x, *items[i + 1 :]] for i, item in enumerate(items) for x in beside(item))
        yield from (sp.ImmutableMatrix(*value.shape, each) for each in islice(changed, MOST))
    elif isinstance(value, list | tuple):
        longer = ([*value[:i], x, *value[i + 1 :]] for i, item in enumerate(value) for x in islice(beside(item), 2))
        yield from (type(value)(each) for each in islice(longer, MOST))
    elif isinstance(value, dict):
        yield from ({**value, key: x} for key, item in value.items() for x in islice(beside(item), 2))
    elif isinstance(value, sp.core.relational.Relational):
        yield from (value.func(value.lhs, x) for x in beside(value.rhs))
    elif isinstance(value, sp.And | sp.Or):
        parts = value.args
        yield from (value.func(*parts[:i], x, *parts[i + 1 :]) for i, part in enumerate(parts) for x in beside(part))
    elif isinstance(value, sp.Expr) and value != 0 and not value.has(sp.oo):
        yield value * BESIDE
        large = next((each for each in sp.preorder_traversal(value) if each.is_Integer and abs(each) >= 100), None)
        if large is not None:
            yield value.xreplace({large: large + 1})


def seen(task: Any, given: Any, answers: Answers, name: str, value: Any) -> bool:
    checks = task.verify(given, Answers(**{**answers, name: value}))
    return any(check.status is CheckStatus.FAILED for check in checks)


@pytest.mark.parametrize(**by_problem(PROBLEMS, [path for path in PROBLEMS if path.stem in QUICK], of=4))
def test_what_is_a_little_wrong_is_seen(path):
    solution = solution_of(path)
    earlier: dict[str, Any] = {}
    for result in solution.parts:
        earlier.setdefault(result.id, result)
        if result.status is not Status.VERIFIED:
            continue
        (part,) = (part for part in solution.problem.parts if part.id == result.id)
        task, given = catalogue()[part.task], given_of(part, result.method, earlier)
        for name, value in result.answers.items():
            if holds_decimals(value) or (part.task, name) in NOT_SEEN or (path.stem, name) in NOT_SEEN_IN:
                continue
            for wrong in beside(value):
                assert seen(task, given, result.answers, name, wrong), (part.id, part.task, name, wrong)


def test_an_integer_of_ten_digits_is_right_to_the_last():
    (path,) = (path for path in PROBLEMS if path.stem == "matrix-function")
    result = solution_of(path).parts[0]
    F = result.answers["F"]
    assert F[0, 0] == 1743392201
    task = catalogue()["matrix_function"]
    given = given_of(solution_of(path).problem.parts[0], result.method, {})
    for entry in range(4):
        assert seen(
            task, given, result.answers, "F", sp.ImmutableMatrix(2, 2, [x + (i == entry) for i, x in enumerate(F)])
        )
