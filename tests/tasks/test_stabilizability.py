"""Stabilizability and detectability: hidden modes that decay, stay or grow; corruptions; parameters."""

import pytest
import sympy as sp

from solver.derivation import Status
from tests.helpers.asking import ask, rejected, system

NOTE = system([[1, 0, 0], [1, -1, 1], [0, 0, -2]], B=[1, 1, 0], C=[[1, 0, 0]])  # lecture note, 2.6 example 3


def test_the_notes_example():
    result = ask("stabilizability", NOTE)
    assert result.status is Status.VERIFIED
    assert result.answers == {"stabilizable": True, "hidden_modes": [-2]}
    result = ask("detectability", NOTE)
    assert result.answers == {"detectable": True, "hidden_modes": [-2, -1]}
    assert result.steps[-1].kind == "decay"


@pytest.mark.parametrize(("value", "stabilizable"), [(-1, True), (0, False), (1, False), (sp.Rational(-1, 100), True)])
def test_zero_is_not_a_stable_hidden_mode(value, stabilizable):
    result = ask("stabilizability", system([[value, 0], [0, 3]], B=[0, 1], C=[[1, 1]]))
    assert result.status is Status.VERIFIED
    assert result.answers == {"stabilizable": stabilizable, "hidden_modes": [value]}


@pytest.mark.parametrize(("value", "detectable"), [(sp.Rational(1, 2), True), (-2, False), (-1, False), (0, True)])
def test_in_discrete_time_the_unit_circle_decides(value, detectable):
    result = ask("detectability", system([[value, 1], [0, 3]], B=[0, 1], C=[[0, 1]], discrete=True))
    assert result.status is Status.VERIFIED
    assert result.answers == {"detectable": detectable, "hidden_modes": [value]}


def test_hidden_pairs_on_and_beside_the_imaginary_axis():
    for sigma, holds in ((-1, True), (0, False)):
        A = sp.diag(sp.Matrix([[sigma, 2], [-2, sigma]]), 1)
        result = ask("stabilizability", system(A, B=[0, 0, 1], C=[[1, 0, 1]]))
        assert result.status is Status.VERIFIED
        assert result.answers["stabilizable"] is holds


def test_parameters_decide_or_are_asked_for():
    for assumption, holds in (("positive", True), ("negative", False)):
        a = sp.Symbol("a", **{assumption: True})
        result = ask("stabilizability", system([[-a, 0], [0, 1]], B=[0, 1], C=[[1, 1]]))
        assert result.status is Status.VERIFIED
        assert result.answers["stabilizable"] is holds
    a = sp.Symbol("a", real=True)
    result = ask("stabilizability", system([[-a, 0], [0, 1]], B=[0, 1], C=[[1, 1]]))
    assert result.status is Status.UNSOLVED
    assert "depends on the parameters" in str(result.reason)


def test_corrupted_answers_are_rejected_one_by_one():
    assert not rejected("stabilizability", NOTE, {"stabilizable": True})
    assert rejected("stabilizability", NOTE, {"stabilizable": False})
    for wrong in ([], [sp.Integer(2)], [sp.Integer(-2)] * 2):
        assert rejected("stabilizability", NOTE, {"hidden_modes": wrong})
    assert not rejected("detectability", NOTE, {"hidden_modes": [sp.Integer(-1), sp.Integer(-2)]})
    assert rejected("detectability", NOTE, {"detectable": False})
