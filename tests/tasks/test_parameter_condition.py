"""Parameters that cost controllability or observability: one input, several, none, all; corruptions; refusals."""

import pytest
import sympy as sp

from solver.derivation import Status
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system

a, b = sp.symbols("alpha b", real=True)
NOTE = system([[2, a - 1], [0, 2]], B=[1, a], C=[[1, a]])  # lecture note, 2.6 example 6


def values(plant, **options):
    result = ask("parameter_condition", plant, property=options.pop("property", "uncontrollable"), **options)
    assert result.status is Status.VERIFIED, result.reason
    return result.answers["values"]


def test_zeros_of_the_determinant():
    result = ask("parameter_condition", NOTE, property="uncontrollable", parameter=("alpha",))
    assert [step.kind for step in result.steps] == ["matrix", "determinant", "roots"]
    assert sp.expand(result.steps[1].claims["factored"].right - a**2 * (1 - a)) == 0
    assert result.answers["values"] == [0, 1]


def test_common_zeros_of_the_minors_of_several_inputs():
    plant = system([[2, a - 3], [0, 2]], B=[[1, 1], [0, a**2 - 2]], C=[[1, 0]])
    assert values(plant) == [-sp.sqrt(2), sp.sqrt(2)]
    plant = system([[0, 0], [0, 0]], B=[[a, 1, 0], [0, a - 1, a * (a - 1)]], C=[[1, 0]])
    assert values(plant) == [0, 1]


def test_unobservable():
    plant = system([[2, a - 1], [0, 2]], B=[1, 1], C=[[a - 3, 1]])
    assert values(plant, property="unobservable") == [1, 3]


def test_no_value_and_every_value():
    assert values(system([[0, 1], [-2, -3]], B=[0, a**2 + 1], C=[[1, 0]])) == []
    assert values(system([[a, 0], [0, a]], B=[1, 1], C=[[1, 0]])) == sp.S.Reals


def test_other_parameters_are_general():
    assert values(system([[a, 1], [0, b]], B=[b, 1], C=[[1, 0]]), parameter=("alpha",)) == [sp.factor((b**2 - 1) / b)]


def test_assumptions_exclude_values():
    p = sp.Symbol("p", positive=True)
    assert values(system([[2, p - 1], [0, 2]], B=[1, p], C=[[1, 0]])) == [1]


def test_roots_in_decimals():
    found = values(system([[0, 0], [0, 1]], B=[1, a**3 + a + 1], C=[[1, 0]]))
    assert len(found) == 1
    assert abs(found[0] + sp.Float("0.682327803828019")) < 1e-14
    plant = system([[0, 0], [0, 1]], B=[1, a**3 + a + 1], C=[[1, 0]])
    wrong = [sp.Float("-0.68233780382802", 15)]
    assert rejected("parameter_condition", plant, {"values": wrong}, property="uncontrollable")


@pytest.mark.parametrize("wrong", [[], [0], [1], [0, 1, 2], [0, -1], sp.S.Reals])
def test_corrupted_values_are_rejected(wrong):
    listed = [sp.Integer(value) for value in wrong] if isinstance(wrong, list) else wrong
    assert rejected("parameter_condition", NOTE, {"values": listed}, property="uncontrollable")
    assert not rejected("parameter_condition", NOTE, {"values": [sp.Integer(1), sp.Integer(0)]})


def test_questions_without_a_parameter_are_refused():
    task = catalogue()["parameter_condition"]
    assert list(task.refused(system([[1]], B=[1]), {}))
    assert list(task.refused(NOTE, {"parameter": ("beta",)}))
    ((option, reason),) = task.refused(system([[a]], B=[1]), {"property": "unobservable"})
    assert option == "property"
    assert "C" in str(reason)
    assert list(task.refused(system([[a]], B=[b]), {}))
    assert list(task.refused(NOTE, {"parameter": ("alpha",)})) == []
