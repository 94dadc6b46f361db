"""Answers with a row or an item too many or too few, one number off by one, a wrong sign, yes for no: all are wrong."""

import pytest
import sympy as sp

from solver.derivation import Status
from solver.engine import given_of
from solver.problem.model import Part
from solver.tasks import catalogue
from tests.helpers.asking import ask, example_options, rejected, system

PLANTS = {
    "one input": system([[0, 1], [-2, -3]], B=[[0], [1]], C=[[1, 0]]),
    "two inputs": system([[0, 1], [-2, -3]], B=[[1, 0], [0, 1]], C=[[1, 0], [0, 1]]),
    "hidden modes": system([[-1, 0], [0, -2]], B=[[1], [0]], C=[[0, 1]]),
    "discrete": system([[0, 1], [-6, -5]], B=[[0], [1]], C=[[1, 0]], discrete=True),
}
WEIGHED = {"R": sp.ImmutableMatrix(sp.eye(2))}
ELSEWHERE = {
    "jury",
    "routh_hurwitz",
    "equilibrium_points",
    "root_locus",
    "sensitivity",
    "steady_state_error",
    "second_order_parameters",
}
"""What works on a system of another kind, judged in a test of its own."""
OF_ANY_ORDER = {("model_matching", "one input"), ("realization", "two inputs")}
"""A matrix alone does not tell the order: it is not judged."""
OF_ANY_SCALE = {"equations"}
"""Expressions that are zero."""
CASES = [
    pytest.param(task, name, method, id=f"{task}-{method}-{name}")
    for name, plant in PLANTS.items()
    for task, declared in catalogue().items()
    for method in declared.methods_for(plant.discrete)
    if task not in ELSEWHERE and (task, name) not in OF_ANY_ORDER
    if not list(declared.refused(plant, example_options(task)))
]


def misshapen(value):
    """Values of another shape, each with what is wrong with it; other truth values and counts."""
    if isinstance(value, bool | int):
        yield "another", not value if isinstance(value, bool) else value + 1
    elif isinstance(value, sp.MatrixBase):
        yield "a row too many", value.col_join(sp.zeros(1, value.cols))
        yield "a column too many", value.row_join(sp.zeros(value.rows, 1))
        if value.rows:
            yield "a row too few", value[:-1, :]
        if value.cols:
            yield "a column too few", value[:, :-1]
    elif isinstance(value, list) and value:
        yield "an item too few", value[:-1]


def changed(value):
    """Values with one number off by one, or of the other sign."""
    if isinstance(value, sp.MatrixBase):
        for i in {0, len(value) - 1} if len(value) else ():
            entries = value.as_mutable()
            entries[i] += 1
            yield "one off", sp.ImmutableMatrix(entries)
        if not value.is_zero_matrix:
            yield "negative", -value
    elif isinstance(value, list | tuple):
        for i, item in enumerate(value):
            yield from ((what, type(value)([*value[:i], wrong, *value[i + 1 :]])) for what, wrong in changed(item))
    elif isinstance(value, sp.Expr) and value.is_finite is not False:
        yield "one off", value + 1
        if value != 0:
            yield "negative", -value


@pytest.mark.parametrize(("task", "name", "method"), CASES)
def test_an_answer_of_another_shape_or_with_another_number_is_rejected(task, name, method):
    plant, options = PLANTS[name], example_options(task)
    if name == "two inputs" and "R" in options:
        options = {**options, **WEIGHED}
    result = ask(task, plant, method, **options)
    if result.status is not Status.VERIFIED:
        return
    declared = catalogue()[task]
    if "open_loop" in declared.needs:
        plant = given_of(Part("a", task, (method,), plant, options), method, {}).system
    for answer, value in result.answers.items():
        for what, wrong in misshapen(value):
            assert rejected(task, plant, {answer: wrong}, **options), (answer, what, wrong)
        if declared.answers[answer].is_free(declared.given(plant, options, method)):
            continue
        for what, wrong in changed(value):
            if what == "one off" or answer not in OF_ANY_SCALE:
                assert rejected(task, plant, {answer: wrong}, **options), (answer, what, wrong)
