"""Poles in z: numbers, pairs, any period, corruptions, marking, refusals."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Status
from solver.problem.systems import NOTHING
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import marked, verdict

z = sp.Symbol("z")
T = sp.Symbol("T", positive=True)
PAIR = (-2 + 3 * sp.I, -2 - 3 * sp.I)


def test_the_steps():
    steps = ask("pole_mapping", NOTHING, poles=PAIR, sample_time=T).steps
    assert [step.kind for step in steps] == ["mapped", "factors", "polynomial"]


def test_a_pair_for_any_period():
    found = ask("pole_mapping", NOTHING, poles=PAIR, sample_time=T)
    assert found.status is Status.VERIFIED
    assert found.answers["polynomial"] == z**2 - 2 * sp.exp(-2 * T) * sp.cos(3 * T) * z + sp.exp(-4 * T)


@settings(max_examples=10, deadline=None)
@given(st.lists(st.tuples(st.integers(-4, 2), st.integers(0, 5)), min_size=1, max_size=3), st.sampled_from([1, 3, 10]))
def test_random_poles_are_exponentials(places, parts):
    poles = [p for a, b in places for p in ((a + b * sp.I, a - b * sp.I) if b else (sp.Integer(a),))]
    found = ask("pole_mapping", NOTHING, poles=tuple(poles), sample_time=sp.Rational(1, parts))
    assert found.status is Status.VERIFIED, found.reason
    wanted = np.exp(np.array([complex(p) for p in poles]) / parts)
    assert np.allclose([complex(p) for p in found.answers["poles"]], wanted)
    ours = np.array([float(c) for c in sp.Poly(found.answers["polynomial"], z).all_coeffs()])
    assert np.allclose(ours, np.poly(wanted).real, atol=1e-9)


def test_a_pair_that_is_sampled_twice_a_turn_becomes_a_double_pole():
    found = ask("pole_mapping", NOTHING, poles=(sp.I, -sp.I), sample_time=sp.pi)
    assert found.status is Status.VERIFIED
    assert (found.answers["poles"], found.answers["polynomial"]) == ([-1, -1], z**2 + 2 * z + 1)


def test_corrupted_answers_are_rejected():
    options = {"poles": (sp.Integer(-1), *PAIR), "sample_time": T}
    found = ask("pole_mapping", NOTHING, **options).answers
    assert not rejected("pole_mapping", NOTHING, found, **options)
    for corrupted in (
        {"poles": [sp.exp(T), *found["poles"][1:]]},
        {"poles": found["poles"][1:]},
        {"polynomial": found["polynomial"] + z},
        {"polynomial": found["polynomial"].subs(T, 2 * T)},
    ):
        assert rejected("pole_mapping", NOTHING, corrupted, **options)


MARKED = "find:\n  a: {task: pole_mapping, poles: [-1, -2], sample_time: 1/2}\n"


@pytest.mark.parametrize(
    ("name", "value", "mistake"),
    [
        ("poles", "[e^-1, e^-2]", "period_left_out"),
        ("poles", "[-1, -2]", "not_mapped"),
        ("polynomial", "z^2 + 3z + 2", "not_mapped"),
    ],
)
def test_mistakes_are_named(name, value, mistake):
    found = verdict(MARKED, "a", name, value)
    assert (found.verdict, found.mistake) == ("wrong", mistake)


def test_a_polynomial_may_follow_from_wrong_poles():
    found = marked(MARKED, "answers: {a: {poles: [0.5, 0.25], polynomial: z^2 - 0.75z + 0.125}}")["a"].answers
    assert found["poles"].verdict == "wrong"
    assert (found["polynomial"].verdict, found["polynomial"].follows) == ("correct", True)
    assert verdict(MARKED, "a", "poles", "[0.607, 0.368]").verdict == "correct"


def test_a_period_is_needed():
    ((_, reason),) = catalogue()["pole_mapping"].refused(NOTHING, {"poles": (sp.Integer(-1),)})
    assert "the sampling period is not given" in str(reason)


def test_a_pole_without_its_conjugate_has_no_real_polynomial():
    result = ask("pole_mapping", NOTHING, poles=(sp.I,), sample_time=T)
    assert "no conjugate" in str(result.reason)
