"""Parameters that cost controllability or observability: one input, several, none, all; corruptions; refusals."""

import numpy as np
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
    assert [step.kind for step in result.steps] == ["matrix", "determinant", "roots", "lost"]
    assert sp.expand(result.steps[1].claims["factored"].right - a**2 * (1 - a)) == 0
    assert result.answers["values"] == [0, 1]


def test_the_mode_that_is_lost_is_named_for_each_value():
    """With A = diag(-1, a) and B = (1, a + 2) the input loses a mode where the two are equal, and where b₂ is zero."""
    plant = system([[-1, 0], [0, a]], B=[1, a + 2], C=[[1, 0]])
    result = ask("parameter_condition", plant, property="uncontrollable")
    (lost,) = (step for step in result.steps if step.kind == "lost")
    assert set(lost.values["found"]) == {(-1, -1), (-2, -2)}
    for (value, mode), claim in zip(lost.values["found"], lost.claims.values(), strict=True):
        A, B = (np.array(M.subs(a, value).tolist(), dtype=float) for M in (plant.A, plant.B))
        assert np.linalg.matrix_rank(np.hstack([float(mode) * np.eye(2) - A, B])) == claim.right == 1


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


T, w = sp.Symbol("T", real=True), sp.Symbol("w", positive=True)
n = sp.Symbol("n", integer=True)
ROTATION = [[sp.cos(T), sp.sin(T)], [-sp.sin(T), sp.cos(T)]]
SAMPLED = system(ROTATION, B=[1 - sp.cos(T), sp.sin(T)], discrete=True)


def test_sampling_periods_that_cost_controllability_are_multiples():
    assert values(SAMPLED) == [n * sp.pi]
    oscillator = [[sp.cos(w * T), sp.sin(w * T) / w], [-w * sp.sin(w * T), sp.cos(w * T)]]
    driven = system(oscillator, B=[(1 - sp.cos(w * T)) / w**2, sp.sin(w * T) / w], discrete=True)
    assert values(driven, parameter=("T",)) == [n * sp.pi / w]
    seen = system(ROTATION, B=[1, 0], C=[[1, 0]], discrete=True)
    assert values(seen, property="unobservable") == [n * sp.pi]


@pytest.mark.parametrize(
    ("entry", "expected"),
    [
        (2 * sp.cos(T) - 1, [2 * n * sp.pi - sp.pi / 3, 2 * n * sp.pi + sp.pi / 3]),
        (sp.cos(T), [n * sp.pi + sp.pi / 2]),
        (sp.sin(2 * T), [n * sp.pi / 2]),
        (sp.sin(3 * T) - sp.sin(T), None),
        (1 - sp.cos(T), [2 * n * sp.pi]),
        (2 + sp.cos(T), []),
        (2 * sp.cos(T) - sp.sin(T), None),
    ],
)
def test_zeros_of_sines_and_cosines(entry, expected):
    found = values(system([[1, 0], [0, 2]], B=[1, entry], discrete=True))
    assert expected is None or found == expected
    for value in found:
        assert all(abs(sp.N(entry.subs(T, value.subs(n, k)))) < 1e-12 for k in range(-3, 4))


@pytest.mark.parametrize("wrong", [[], [2 * n * sp.pi], [n * sp.pi / 2], [sp.Integer(0)], [n * sp.pi + 1]])
def test_wrong_multiples_are_rejected(wrong):
    assert rejected("parameter_condition", SAMPLED, {"values": wrong}, property="uncontrollable")
    assert not rejected("parameter_condition", SAMPLED, {"values": [2 * n * sp.pi, sp.pi * (2 * n + 1)]})


def test_angles_that_do_not_belong_together_are_refused_in_words():
    plant = system([[1, 0], [0, 2]], B=[1, sp.cos(T) - sp.cos(sp.sqrt(2) * T)], discrete=True)
    result = ask("parameter_condition", plant, property="uncontrollable")
    assert result.status is Status.UNSOLVED
    assert "multiples" in str(result.reason)


def test_two_parameters_at_once_by_conditions_on_them():
    plant = system([[a, 1], [0, b]], B=[b, 1])
    result = ask("parameter_condition", plant, property="uncontrollable", parameter=("alpha", "b"))
    assert result.status is Status.VERIFIED, result.reason
    assert [step.kind for step in result.steps] == ["matrix", "determinant", "conditions"]
    (condition,) = result.answers["values"]
    assert sp.expand((condition.lhs - condition.rhs) ** 2 - (a * b - b**2 + 1) ** 2) == 0


def test_two_parameters_and_several_inputs_with_another_that_is_general():
    c = sp.Symbol("c", real=True)
    plant = system([[a, 0], [0, b]], B=[[c, 1], [1, a]])
    found = values(plant, parameter=("alpha", "b"))
    assert [condition.free_symbols for condition in found] == [{a, b, c}]
    wanted = {"property": "uncontrollable", "parameter": ("alpha", "b")}
    assert not rejected("parameter_condition", plant, {"values": found}, **wanted)
    for wrong in ([], [sp.Eq(a, b)], [sp.Eq(b * c, 1)], [*found, sp.Eq(a, 1)]):
        assert rejected("parameter_condition", plant, {"values": wrong}, **wanted)


def test_no_values_of_two_parameters():
    plant = system([[1, 0], [0, 2]], B=[1, a**2 + b**2 + 1])
    assert values(plant, parameter=("alpha", "b")) == []


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
    assert list(task.refused(NOTE, {"parameter": ("alpha", "beta")}))
    ((option, reason),) = task.refused(system([[a]], B=[1]), {"property": "unobservable"})
    assert option == "property"
    assert "C" in str(reason)
    assert list(task.refused(system([[a]], B=[b]), {}))
    assert list(task.refused(NOTE, {"parameter": ("alpha",)})) == []
