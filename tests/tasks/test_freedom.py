"""When an answer is one of many: by counting inputs, outputs and the modes that they meet."""

from types import SimpleNamespace

import pytest
import sympy as sp

from solver.tasks import freedom
from tests.helpers.asking import system

FULL, ONE = [[1, 0], [0, 1]], [0, 1]
A, DIAGONAL = [[0, 1], [-2, -3]], [[-1, 0], [0, -2]]


def asked(plant, **options):
    """What a predicate looks at: the plant and the options."""
    return SimpleNamespace(system=plant, options=SimpleNamespace(**options))


@pytest.mark.parametrize(
    ("plant", "gain", "observer"),
    [
        (system(A, B=ONE, C=[[1, 0]]), False, False),
        (system(A, B=FULL, C=[[1, 0]]), True, False),
        (system(A, B=ONE, C=FULL), False, True),
        (system(DIAGONAL, B=ONE, C=[[1, 1]]), True, False),
        (system(DIAGONAL, B=[1, 1], C=[[1, 0]]), False, True),
        (system(A), False, False),
        (system(A, B=ONE), False, False),
        (system(A, C=[[1, 0]]), False, False),
    ],
)
def test_gains_are_free_with_several_channels_or_hidden_modes(plant, gain, observer):
    assert freedom.gain_is_free(asked(plant)) is gain
    assert freedom.observer_gain_is_free(asked(plant)) is observer
    assert freedom.one_of_the_gains_is_free(asked(plant)) is (gain or observer)
    assert freedom.several_inputs(asked(plant)) is (plant.B is not None and plant.B.cols == 2)


@pytest.mark.parametrize(
    ("plant", "poles", "free"),
    [
        (system(A, B=FULL, C=[[1, 0]]), (), True),
        (system(A, B=FULL, C=FULL), (), False),
        (system(A, B=FULL, C=FULL), (sp.Integer(-1),), True),
        (system(A, B=ONE, C=[[1, 0]]), (sp.Integer(-1),), False),
        (system(A, B=FULL), (), False),
        (system(A, C=[[1, 0]]), (), False),
    ],
)
def test_a_reference_gain_is_free_with_inputs_left_over_or_a_free_feedback(plant, poles, free):
    assert freedom.reference_gain_is_free(asked(plant, poles=poles)) is free


@pytest.mark.parametrize(
    ("C", "measured", "combined", "free"),
    [
        ([[1, 0]], (), False, False),
        ([[1, 1]], (), True, True),
        ([[1, 2]], ("x1",), False, False),
        ([[1, 0]], ("x1", "x2"), False, True),
        ([[2, 0]], (), False, False),
    ],
)
def test_an_observer_of_reduced_order_is_free_with_free_coordinates_or_several_outputs(C, measured, combined, free):
    given = asked(system(A, B=ONE, C=C), measured=measured)
    assert freedom.measured_by_combinations(given) is combined
    assert freedom.reduced_gain_is_free(given) is free


@pytest.mark.parametrize(
    ("function", "root"), [("sqrt(A)", True), ("A**(1/2)", True), ("A**5", False), ("exp(A)", False)]
)
def test_a_root_is_one_of_several(function, root):
    assert freedom.a_root_is_asked_for(asked(system(A), function=function)) is root
