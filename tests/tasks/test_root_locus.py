"""Root loci: textbook values, steps, numpy's roots on fine gains, corruptions, refusals, marking."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Status
from solver.derivation.conversion import converted
from solver.engine import yield_into
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import Polynomial, StateSpace, TransferFunction
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected

s, K = sp.Symbol("s"), sp.Symbol("K", real=True)


def loop(numerator, denominator):
    N, D = sp.expand(numerator), sp.expand(denominator)
    return TransferFunction(sp.ImmutableMatrix([[sp.cancel(N / D)]]), ((N,),), ((D,),), s)


def polynomial(p):
    return Polynomial(tuple(sp.Poly(p, s).all_coeffs()), s)


def equation(system):
    """What the task works on."""
    return yield_into([], converted(system, ("characteristic_equation",)))


OGATA = loop(1, s * (s + 1) * (s + 2))


def test_the_classic_locus_of_three_poles():
    result = ask("root_locus", OGATA)
    answers = result.answers
    assert result.status is Status.VERIFIED
    assert answers["real_axis_segments"] == [sp.Interval(-sp.oo, -2), sp.Interval(-1, 0)]
    assert answers["asymptote_angles"] == [60, 180, -60]
    assert answers["centroid"] == -1
    assert answers["breakaway_points"] == [-1 + sp.sqrt(3) / 3]
    assert answers["breakaway_gains"] == [2 * sp.sqrt(3) / 9]
    assert answers["imaginary_axis_crossings"] == [sp.sqrt(2) * sp.I, -sp.sqrt(2) * sp.I]
    assert answers["critical_gains"] == [6]
    assert answers["departure_angles"] == answers["arrival_angles"] == []


def test_factors_that_were_given_are_not_sought():
    typed = (sp.S.One, s * (s + 1) * (s + 2))
    told = {}
    for name, plant in (("given", replace(OGATA, written=typed)), ("found", OGATA)):
        result = ask("root_locus", plant)
        assert result.status is Status.VERIFIED
        (told[name],) = (step for step in result.steps if step.kind == "poles_zeros")
    assert set(told["found"].claims) == {"D"}
    assert not told["given"].claims
    assert told["given"].values["poles"] == told["found"].values["poles"]


def test_the_steps_follow_the_rules():
    kinds = [step.kind for step in ask("root_locus", OGATA).steps]
    assert kinds == [
        "gain", "poles_zeros", "branches", "segments", "asymptotes", "turning", "gains", "parts", "crossings", "ranges",
        "sketch",
    ]  # fmt: skip
    told = {step.kind: step.values for step in ask("root_locus", OGATA).steps}
    assert [row["why"] for row in told["gains"]["rows"]] == ["negative", ""]
    assert told["ranges"]["ranges"] == [(0, 6, 0, 0), (6, sp.oo, 2, 0)]


@pytest.mark.parametrize(
    ("numerator", "denominator", "points", "gains"),
    [
        (1, s * (s + 4) * (s**2 + 4 * s + 20), [-2, -2 + 2.449490j, -2 - 2.449490j], [64, 100, 100]),  # Ogata A-6-4
        (1, s * (s + 4) * (s**2 + 4 * s + 8), [-2], [16]),  # four branches meet
        (s + 2, s**2 + 2 * s + 3, [-3.732051], [5.464102]),  # Ogata, example 6-2
        (s + sp.Rational(2, 5), s**2 * (s + sp.Rational(18, 5)), [-1.2, 0], [4.32, 0]),  # Ogata A-6-6: three meet
        ((s - 3) * (s - 5), (s + 1) * (s + 2), [-1.452978, 3.816614], [0.008623, 28.991378]),  # Nise, example 8.2
        (-(s - 1), (s + 1) * (s + 2), [-1.449490, 3.449490], [0.101021, 9.898979]),
    ],
)
def test_where_branches_meet(numerator, denominator, points, gains):
    result = ask("root_locus", loop(numerator, denominator))
    assert result.status is Status.VERIFIED
    assert np.allclose([complex(each) for each in result.answers["breakaway_points"]], points, atol=1e-5)
    assert np.allclose([complex(each) for each in result.answers["breakaway_gains"]], gains, atol=2e-5)


def test_angles_at_complex_poles_and_zeros():
    answers = ask("root_locus", loop(s + 2, s**2 + 2 * s + 3)).answers
    assert abs(answers["departure_angles"][0] - 144.735610317245) < 1e-12
    answers = ask("root_locus", loop(1, (s**2 + 2 * s + 2) ** 2)).answers
    assert answers["departure_angles"] == [0, 180]
    assert answers["breakaway_gains"] == [0, 0]
    assert ask("root_locus", loop(s**2 - 2 * s + 2, s**2 + 3 * s + 2)).answers["arrival_angles"] == [135]


def test_a_loop_that_is_stable_between_two_gains():
    result = ask("root_locus", loop(s + 1, s * (s - 1) * (s**2 + 4 * s + 16)))
    assert np.allclose([float(each) for each in result.answers["critical_gains"]], [23.315342, 35.684658])
    (ranges,) = (step.values["ranges"] for step in result.steps if step.kind == "ranges")
    assert [outside for _, _, outside, _ in ranges] == [2, 0, 2]


def test_a_negative_gain_is_the_locus_of_zero_degrees():
    answers = ask("root_locus", loop(-1, s * (s + 1) * (s + 2))).answers
    assert answers["asymptote_angles"] == [0, 120, -120]
    assert answers["real_axis_segments"] == [sp.Interval(-2, -1), sp.Interval(0, sp.oo)]


def test_a_branch_through_infinity():
    result = ask("root_locus", loop(1 - s, 1 + s))
    assert result.status is Status.VERIFIED
    assert result.answers["real_axis_segments"] == [sp.Interval(-sp.oo, -1), sp.Interval(1, sp.oo)]
    assert result.answers["asymptote_angles"] == []
    (told,) = (step.values for step in result.steps if step.kind == "branches")
    assert told["infinity"] == 1


def test_branches_along_the_imaginary_axis_are_no_crossings():
    result = ask("root_locus", loop(1, s**2 * (s**2 + 4)))
    assert result.status is Status.VERIFIED
    assert result.answers["critical_gains"] == result.answers["imaginary_axis_crossings"] == []
    (ranges,) = (step.values["ranges"] for step in result.steps if step.kind == "ranges")
    assert ranges == [(0, 4, 0, 4), (4, sp.oo, 2, 0)]


def test_branches_that_reach_the_axis_at_the_origin_and_go_along_it():
    result = ask("root_locus", loop(1, s**2 - 1))
    assert result.status is Status.VERIFIED
    assert (result.answers["imaginary_axis_crossings"], result.answers["critical_gains"]) == ([0], [1])


def test_a_common_factor_stays_a_pole_of_the_loop():
    result = ask("root_locus", loop(s - 1, (s - 1) * (s + 2) * (s + 3)))
    assert [step.kind for step in result.steps][:2] == ["gain", "common"]
    (told,) = (step.values for step in result.steps if step.kind == "ranges")
    assert told["ranges"] == [(0, sp.oo, 1, 0)]
    assert told["conditions"] == []


def test_a_parameter_that_is_no_gain():
    a = sp.Symbol("a", real=True)
    result = ask("root_locus", polynomial(s**3 + (2 + a) * s**2 + 3 * s + 4 * a))
    assert result.steps[0].kind == "affine"
    assert result.answers["critical_gains"] == [6]
    plant = StateSpace(sp.ImmutableMatrix([[0, 1], [-K, -3]]))
    assert ask("root_locus", plant).answers["breakaway_gains"] == [sp.Rational(9, 4)]


def test_the_loop_is_that_of_all_that_runs_round():
    result = ask("root_locus", loop(1, s * (s + 1)), controller=K, feedback=1 / (s + 2))
    assert result.answers == ask("root_locus", OGATA).answers


@pytest.mark.parametrize(
    ("system", "options", "said"),
    [
        (polynomial(s**2 + K * s + K**2), {}, "enters"),
        (polynomial(s**2 + s + 1), {}, "no parameter"),
        (loop(3, sp.Integer(1)), {}, "no locus"),
        (loop(K, s * (s + sp.Symbol("p", real=True))), {}, "has no value"),
        (polynomial(K * s**3 + s + 1), {}, "higher"),
    ],
)
def test_what_has_no_locus_is_said(system, options, said):
    result = ask("root_locus", system, **options)
    assert result.status is Status.UNSOLVED
    assert said in str(result.reason)


roots = st.lists(
    st.one_of(
        st.integers(-4, 2).map(lambda a: s - a),
        st.tuples(st.integers(-3, 1), st.integers(1, 4)).map(lambda pair: sp.expand((s - pair[0]) ** 2 + pair[1] ** 2)),
    ),
    min_size=1,
    max_size=3,
)


@settings(max_examples=12)
@given(st.lists(st.integers(-4, 2).map(lambda a: s - a), max_size=2), roots, st.sampled_from([1, 2, -1]))
def test_any_locus_is_verified_and_stable_where_numpy_says(zeros, poles, lead):
    N, D = lead * sp.prod(zeros), sp.prod(poles)
    if sp.degree(N, s) > sp.degree(D, s) or sp.cancel(D / N).is_number:
        return
    result = ask("root_locus", loop(N, D))
    assert result.status is Status.VERIFIED
    p = sp.Poly(sp.expand(D + K * N), s)
    (told,) = (step.values for step in result.steps if step.kind == "ranges")
    for low, high, outside, on in told["ranges"]:
        gain = float(low) + 0.41 * ((float(high) if high != sp.oo else float(low) + 3) - float(low))
        values = np.roots([complex(c.subs(K, gain)) for c in p.all_coeffs()])
        assert sum(values.real > 1e-5) == outside
        assert sum(abs(values.real) < 1e-5) == on


RIGHT = {
    "real_axis_segments": [sp.Interval(-4, 0)],
    "asymptote_angles": [45, 135, 225, 315],
    "centroid": sp.Integer(-2),
    "breakaway_points": [-2, -2 + sp.sqrt(6) * sp.I, -2 - sp.sqrt(6) * sp.I],
    "breakaway_gains": [sp.Integer(64), sp.Integer(100), sp.Integer(100)],
    "imaginary_axis_crossings": [sp.sqrt(10) * sp.I, -sp.sqrt(10) * sp.I],
    "critical_gains": [sp.Integer(260)],
    "departure_angles": [sp.Integer(270)],
    "arrival_angles": [],
}
FOURTH = loop(1, s * (s + 4) * (s**2 + 4 * s + 20))


@pytest.mark.parametrize("name", list(RIGHT))
def test_right_answers_in_other_forms_are_accepted(name):
    assert not rejected("root_locus", equation(FOURTH), {name: RIGHT[name]})


@pytest.mark.parametrize(
    ("name", "wrong"),
    [
        ("real_axis_segments", [sp.Interval(-4, 1)]),
        ("real_axis_segments", [sp.Interval(-sp.oo, -4)]),
        ("real_axis_segments", []),
        ("real_axis_segments", [sp.Interval(-4, 0), sp.Interval(1, 2)]),
        ("asymptote_angles", [0, 90, 180, 270]),
        ("asymptote_angles", [45, 135, 225]),
        ("asymptote_angles", [45, 135, 225, 405]),
        ("centroid", sp.Integer(2)),
        ("centroid", sp.Rational(-8, 3)),
        ("breakaway_points", [-2]),
        ("breakaway_points", [-2, -2 + sp.sqrt(6) * sp.I, -2 - sp.sqrt(6) * sp.I, sp.Integer(1)]),
        ("breakaway_points", [-2, -2 + sp.sqrt(5) * sp.I, -2 - sp.sqrt(5) * sp.I]),
        ("breakaway_gains", [sp.Integer(64), sp.Integer(101), sp.Integer(100)]),
        ("breakaway_gains", [sp.Integer(-64), sp.Integer(100), sp.Integer(100)]),
        ("imaginary_axis_crossings", [3 * sp.I, -3 * sp.I]),
        ("imaginary_axis_crossings", []),
        ("imaginary_axis_crossings", [1 + sp.sqrt(10) * sp.I, 1 - sp.sqrt(10) * sp.I]),
        ("critical_gains", [sp.Integer(26)]),
        ("critical_gains", [sp.Integer(0), sp.Integer(260)]),
        ("departure_angles", [sp.Integer(90)]),
        ("departure_angles", []),
        ("arrival_angles", [sp.Integer(90)]),
    ],
)
def test_corrupted_answers_are_rejected(name, wrong):
    assert rejected("root_locus", equation(FOURTH), {name: wrong})


def test_gains_in_another_order_than_the_points_are_rejected():
    wrong = {"breakaway_points": RIGHT["breakaway_points"], "breakaway_gains": RIGHT["breakaway_gains"][::-1]}
    assert rejected("root_locus", equation(FOURTH), wrong)


def test_multiple_poles_may_be_left_out_of_the_meeting_points():
    plant = loop(s + 1, s**2 * (s + 9))
    for points, gains in (([-3, 0], [27, 0]), ([-3], [27])):
        answers = {"breakaway_points": list(map(sp.Integer, points)), "breakaway_gains": list(map(sp.Integer, gains))}
        assert not rejected("root_locus", equation(plant), answers)


@pytest.mark.parametrize(
    ("parameter", "said"),
    [("k_p", "'k_p' is no parameter of the system"), ("3", "a name is expected"), ("s", "variable of the Laplace")],
)
def test_a_wrong_name_of_the_parameter_is_refused_at_its_place(parameter, said):
    text = f"""
title: Names
system: {{transfer_function: K/(s(s + 1)(s + 2))}}
find:
  a: {{task: root_locus, parameter: {parameter}}}
"""
    with pytest.raises(InputError) as fault:
        read_problem(Source("names.yaml", text), catalogue())
    assert said in str(fault.value)
    assert "names.yaml:5:" in str(fault.value)


def test_the_gain_before_a_loop_without_parameters_may_have_a_name():
    result = ask("root_locus", OGATA, parameter="k_p")
    assert result.status is Status.VERIFIED
    assert result.answers["critical_gains"] == [6]
