"""Lead and lag compensators: textbooks, generated loops, what cannot be, corruptions, other right compensators."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Answers, CheckStatus, Status
from solver.engine import given_of, solve_problem
from solver.problem.model import Part
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue
from tests.helpers.asking import ask
from tests.helpers.tried import tried
from tests.tasks.test_model_matching import plant

s = sp.Symbol("s")
r = sp.Rational
OGATA_LEAD = plant(sp.Integer(4), s * (s + 2))
OGATA_LAG = plant(sp.Integer(1), s * (s + 1) * (s / 2 + 1))
VALVE = plant(sp.Integer(40), (s + 2) * (s + 5))
TRIPLE = plant(sp.Integer(1), s**2 * (s + 1))
BODE, LOCUS = "frequency_response", "root_locus"


def judged(task, G, answers, method=BODE, **options):
    """The statuses of the checks of some answers."""
    declared = catalogue()[task]
    given = given_of(Part("a", task, (method,), G, options), method, {})
    return {check.status for check in declared.verify(given, Answers(**answers))}


def margin_of(C, G):
    """Crossover and phase margin by samples and bisection."""
    value = sp.lambdify(s, C * G.matrix[0, 0], "numpy")
    grid = np.geomspace(1e-4, 1e4, 200_001)
    size = np.abs(value(1j * grid))
    [at] = np.nonzero((size[:-1] > 1) & (size[1:] <= 1))[0]
    return grid[at], 180 + np.degrees(np.unwrap(np.angle(value(1j * grid))))[at]


def test_ogatas_lead():
    result = ask("lead_compensator", OGATA_LEAD, velocity_constant=sp.Integer(20), phase_margin=sp.Integer(50))
    assert result.status is Status.VERIFIED, result.reason
    assert [step.kind for step in result.steps] == [
        "gain", "margins", "attempts", "section", "controller", "check", "closed_loop",
    ]  # fmt: skip
    answers = result.answers
    assert answers["K"] == 10
    assert float(answers["alpha"]) == pytest.approx(0.24, rel=0.02)  # Ogata, example 7-26: 0.24, 0.227
    assert float(answers["T"]) == pytest.approx(0.227, rel=0.02)
    omega, margin = margin_of(answers["controller"], OGATA_LEAD)
    assert float(answers["gain_crossover"]) == pytest.approx(omega, rel=1e-3)
    assert float(answers["phase_margin"]) == pytest.approx(margin, abs=0.05)
    assert margin >= 50


def test_ogatas_lag():
    result = ask("lag_compensator", OGATA_LAG, velocity_constant=sp.Integer(5), phase_margin=sp.Integer(40))
    assert result.status is Status.VERIFIED, result.reason
    answers = result.answers
    assert answers["K"] == 5
    assert answers["alpha"] > 1
    _, margin = margin_of(answers["controller"], OGATA_LAG)
    assert margin >= 40
    own = 5 * (10 * s + 1) / (100 * s + 1)  # Ogata, example 7-27
    given = {"velocity_constant": sp.Integer(5), "phase_margin": sp.Integer(40)}
    assert judged("lag_compensator", OGATA_LAG, {"controller": own}, **given) == {CheckStatus.PASSED}


def test_the_valve_of_the_exam():
    result = ask("lead_compensator", VALVE, error=r(1, 50), phase_margin=sp.Integer(45))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["K"] == r(49, 4)
    assert result.answers["error"] == r(1, 50)
    assert result.answers["gain_crossover"] > 20


def test_one_section_cannot_cross_where_the_gain_is_too_large():
    asked = {"error": r(1, 50), "phase_margin": sp.Integer(45), "crossover": sp.Integer(20)}
    result = ask("lead_compensator", VALVE, **asked)
    assert result.status is Status.UNSOLVED
    assert "makes it larger" in str(result.reason)


@pytest.mark.parametrize(
    ("task", "G", "asked", "why"),
    [
        ("lead", TRIPLE, {"acceleration_constant": 1, "phase_margin": 40}, "stays below"),
        ("lag", TRIPLE, {"acceleration_constant": 1, "phase_margin": 40}, "takes phase"),
        ("lead", VALVE, {"velocity_constant": 1, "phase_margin": 40}, "too few integrators"),
        ("lead", VALVE, {"error": r(1, 2), "phase_margin": 40}, "No section is needed"),
        ("lead", plant(sp.Integer(1), s**3), {"phase_margin": 60, "crossover": 1}, "less than"),
        ("lag", OGATA_LAG, {"velocity_constant": 5, "phase_margin": 40, "crossover": 2}, "makes it smaller"),
        ("lag", OGATA_LAG, {"velocity_constant": 5, "phase_margin": 40, "crossover": r(3, 2)}, "takes phase"),
        ("lead", plant(sp.Symbol("a"), s + 1), {"error": r(1, 50), "phase_margin": 45}, "in numbers"),
    ],
)
def test_what_cannot_be_is_said(task, G, asked, why):
    result = ask(f"{task}_compensator", G, **{name: sp.sympify(value) for name, value in asked.items()})
    assert result.status is Status.UNSOLVED
    assert why in str(result.reason)


@tried(8)
@given(st.integers(1, 6), st.integers(1, 9), st.integers(2, 40), st.integers(30, 55))
def test_generated_loops_get_their_margin(a, b, constant, wanted):
    G = plant(sp.Integer(b), s * (s + a))
    result = ask("lead_compensator", G, velocity_constant=sp.Integer(constant), phase_margin=sp.Integer(wanted))
    assert result.status is Status.VERIFIED or "No section" in str(result.reason), result.reason
    if result.status is Status.VERIFIED:
        C = result.answers["controller"]
        _, margin = margin_of(C, G)
        assert margin >= wanted - 0.01
        assert sp.limit(s * C * G.matrix[0, 0], s, 0) == constant


@tried(6)
@given(st.integers(1, 4), st.integers(4, 9), st.integers(2, 30))
def test_a_crossover_is_met(a, b, crossover):
    G = plant(sp.Integer(b), (s + a) * (s + b))
    asked = {"phase_margin": sp.Integer(60), "crossover": sp.Integer(crossover)}
    result = ask("lead_compensator", G, **asked)
    if result.status is Status.VERIFIED:
        omega, margin = margin_of(result.answers["controller"], G)
        assert omega == pytest.approx(crossover, rel=2e-3)
        assert margin >= 59.9
    else:
        assert "No lead section is needed" in str(result.reason)


def test_the_phase_before_is_the_sum_of_its_angles_and_180_degrees_short_of_the_margin():
    result = ask("lag_compensator", OGATA_LAG, velocity_constant=sp.Integer(5), phase_margin=sp.Integer(40))
    (told,) = (step.values for step in result.steps if step.kind == "margins")
    assert told["margin"] < 0
    assert told["phase"] == told["margin"] - 180
    assert told["phase"] == pytest.approx(sp.Add(*(each.power * each.degrees for each in told["angles"])), abs=1e-9)


def test_a_lag_section_for_a_crossover_is_told_before_it_is_rounded():
    asked = {"velocity_constant": sp.Integer(5), "phase_margin": sp.Integer(40), "crossover": r(1, 2)}
    result = ask("lag_compensator", OGATA_LAG, **asked)
    assert result.status is Status.VERIFIED, result.reason
    step = next(step for step in result.steps if step.kind == "crossing").values
    a, exactly = float(step["a"]), float(step["exactly"])
    assert a == pytest.approx(float(result.answers["T"]) / 2)
    size = 5 * abs(1 / (0.5j * (1 + 0.5j) * (1 + 0.25j)))
    assert size * abs((1 + 1j * a) / (1 + 1j * exactly * a)) == pytest.approx(1)
    assert float(step["alpha"]) == pytest.approx(exactly, rel=2e-2)


def test_a_dead_time_takes_phase():
    text = """
title: A dead time
system: {transfer_function: exp(-0.1s)/(s(s+1))}
find:
  a: {task: lead_compensator, phase_margin: 45, velocity_constant: 2}
"""
    solution = solve_problem(read_problem(Source("x.yaml", text), catalogue()))
    assert solution.status is Status.VERIFIED, solution.parts[0].reason


ASKED = [
    ("lead_compensator", OGATA_LEAD, {"velocity_constant": sp.Integer(20), "phase_margin": sp.Integer(50)}),
    ("lag_compensator", OGATA_LAG, {"velocity_constant": sp.Integer(5), "phase_margin": sp.Integer(40)}),
    ("lead_compensator", VALVE, {"error": r(1, 50), "phase_margin": sp.Integer(45), "crossover": sp.Integer(30)}),
]  # fmt: skip


@pytest.mark.parametrize(("task", "G", "asked"), ASKED)
def test_corruptions_are_rejected(task, G, asked):
    answers = ask(task, G, **asked).answers
    C, T, alpha = answers["controller"], answers["T"], answers["alpha"]
    assert judged(task, G, answers, **asked) == {CheckStatus.PASSED}
    assert judged(task, G, {"controller": C}, **asked) == {CheckStatus.PASSED}
    wrong = [
        1 / C,
        C / 2,
        -C,
        C.subs(s, s / 9),
        C + s,
        sp.Integer(10),
        (T * s + 1) * answers["K"],
        C * C,
    ]
    for each in wrong:
        assert CheckStatus.FAILED in judged(task, G, {"controller": each}, **asked), each
    for name in ("K", "T", "alpha", "phase_margin", "gain_crossover", *(["error"] if "error" in answers else [])):
        for changed in (2 * answers[name], answers[name] + r(1, 1000), 1 / answers[name]):
            assert CheckStatus.FAILED in judged(task, G, {"controller": C, name: changed}, **asked), name
    swapped = {"K": answers["K"], "T": T, "alpha": 1 / alpha}
    assert CheckStatus.FAILED in judged(task, G, swapped, **asked)


def test_the_least_gain_can_be_judged_alone():
    _, G, asked = ASKED[0]
    assert judged("lead_compensator", G, {"K": sp.Integer(10)}, **asked) == {CheckStatus.PASSED}
    assert judged("lead_compensator", G, {"K": sp.Integer(20)}, **asked) == {CheckStatus.FAILED}
    assert judged("lead_compensator", G, {"T": r(1, 4)}, **asked) == {CheckStatus.SKIPPED}


@pytest.mark.parametrize(
    ("options", "place"),
    [
        ({"error": r(1, 50), "velocity_constant": sp.Integer(2), "phase_margin": sp.Integer(45)}, "velocity_constant"),
        ({"error": sp.Integer(2), "phase_margin": sp.Integer(45)}, "error"),
        ({"error": r(1, 50), "phase_margin": sp.Integer(190)}, "phase_margin"),
        ({"phase_margin": sp.Integer(45), "crossover": sp.Integer(-1)}, "crossover"),
        ({"poles": (sp.Integer(-1), sp.Integer(-2))}, "poles"),
    ],
)
def test_specifications_that_mean_nothing_are_refused(options, place):
    assert [where for where, _ in catalogue()["lead_compensator"].refused(VALVE, options)] == [place]


def test_ogatas_lead_by_the_root_locus():
    poles = (-2 + 2 * sp.sqrt(3) * sp.I, -2 - 2 * sp.sqrt(3) * sp.I)
    result = ask("lead_compensator", OGATA_LEAD, LOCUS, poles=poles)
    assert result.status is Status.VERIFIED, result.reason
    assert [step.kind for step in result.steps][:3] == ["angle", "bisector", "magnitude"]
    answers = result.answers
    assert float(1 / answers["T"]) == pytest.approx(2.9, rel=0.02)  # Ogata, example 6-6: zero -2.9, pole -5.4
    assert float(1 / (answers["alpha"] * answers["T"])) == pytest.approx(5.4, rel=0.02)
    ogata = r(468, 100) * (s + r(29, 10)) / (s + r(54, 10))
    assert judged("lead_compensator", OGATA_LEAD, {"controller": ogata}, LOCUS, poles=poles) == {CheckStatus.PASSED}
    for wrong in (ogata / 2, 1 / ogata, sp.Integer(3), ogata.subs(s, 2 * s)):
        statuses = judged("lead_compensator", OGATA_LEAD, {"controller": wrong}, LOCUS, poles=poles)
        assert CheckStatus.FAILED in statuses, wrong


def test_ogatas_lag_by_the_root_locus():
    G = plant(r(106, 100), s * (s + 1) * (s + 2))
    asked = {"velocity_constant": sp.Integer(5), "poles": tuple(r(-33, 100) + k * r(58, 100) * sp.I for k in (1, -1))}
    result = ask("lag_compensator", G, LOCUS, **asked)
    assert result.status is Status.VERIFIED, result.reason
    C = result.answers["controller"]
    assert sp.limit(s * C * G.matrix[0, 0], s, 0) == 5
    ogata = r(9656, 10000) * (s + r(1, 20)) / (s + r(1, 200)) * r(104, 100)  # example 6-7, with the constant met
    assert judged("lag_compensator", G, {"controller": ogata}, LOCUS, **asked) == {CheckStatus.PASSED}


@tried(8)
@given(st.integers(1, 4), st.integers(1, 5), st.integers(1, 6))
def test_a_pole_asked_for_is_a_pole(a, sigma, omega):
    G = plant(sp.Integer(3), s * (s + a))
    poles = (-sigma + omega * sp.I, -sigma - omega * sp.I)
    result = ask("lead_compensator", G, LOCUS, poles=poles)
    if result.status is not Status.VERIFIED:
        assert any(word in str(result.reason) for word in ("No lead section", "turns the other way")), result.reason
        return
    numerator, denominator = sp.fraction(sp.together(result.answers["controller"] * G.matrix[0, 0]))
    roots = np.roots([float(c) for c in sp.Poly(numerator + denominator, s).all_coeffs()])
    assert min(abs(roots - complex(poles[0]))) < 0.01 * abs(complex(poles[0]))


def test_both_sections_by_the_bode_diagram():
    G = plant(sp.Integer(1), s * (s + 1) * (s + 2))
    asked = {"velocity_constant": sp.Integer(10), "phase_margin": sp.Integer(50)}
    result = ask("lead_lag_compensator", G, **asked)
    assert result.status is Status.VERIFIED, result.reason
    answers = result.answers
    assert answers["K"] == 20
    assert answers["alpha"][0] < 1 < answers["alpha"][1]
    _, margin = margin_of(answers["controller"], G)
    assert margin >= 50 - 0.05
    ogata = 20 * (r(10, 7) * s + 1) * (r(100, 15) * s + 1) / ((r(1, 7) * s + 1) * (r(1000, 15) * s + 1))  # 7-28
    assert judged("lead_lag_compensator", G, {"controller": ogata}, **asked) == {CheckStatus.PASSED}
    C = answers["controller"]
    assert judged("lead_lag_compensator", G, answers, **asked) == {CheckStatus.PASSED}
    for wrong in (1 / C, C / 2, C.subs(s, s / 9), C * C, 20 * (s + 1) / (s / 9 + 1)):
        assert CheckStatus.FAILED in judged("lead_lag_compensator", G, {"controller": wrong}, **asked), wrong
    for name in ("T", "alpha"):
        turned = {"controller": C, name: answers[name][::-1]}
        assert CheckStatus.FAILED in judged("lead_lag_compensator", G, turned, **asked), name


def test_both_sections_with_a_large_margin_have_a_lower_crossover():
    """At −180° a lead section alone would have to turn by 91°; where the phase of the plant is less, it need not."""
    G = plant(sp.Integer(1), s * (s + 1) * (s + 2) * (s + 3))
    result = ask("lead_lag_compensator", G, velocity_constant=sp.Integer(50), phase_margin=sp.Integer(85))
    assert result.status is Status.VERIFIED, result.reason
    omega, margin = margin_of(result.answers["controller"], G)
    assert omega < 1
    assert margin >= 85
    asked = {"velocity_constant": sp.Integer(50), "phase_margin": sp.Integer(85), "crossover": sp.Integer(1)}
    refused = ask("lead_lag_compensator", G, **asked)
    assert "less than $90" in str(refused.reason)


def test_both_sections_by_the_root_locus():
    G = plant(sp.Integer(4), s * (s + r(1, 2)))
    asked = {"velocity_constant": sp.Integer(80), "poles": tuple(r(-5, 2) + k * r(433, 100) * sp.I for k in (1, -1))}
    result = ask("lead_lag_compensator", G, LOCUS, **asked)
    assert result.status is Status.VERIFIED, result.reason
    assert sp.limit(s * result.answers["controller"] * G.matrix[0, 0], s, 0) == 80


@pytest.mark.parametrize(
    ("task", "G", "asked", "why"),
    [
        ("lead", TRIPLE, {"poles": (-1 + 3 * sp.I, -1 - 3 * sp.I)}, "less than the angle"),
        ("lead", OGATA_LEAD, {"poles": (-1 + 2 * sp.I, -1 - 2 * sp.I)}, "lies on the root locus"),
        ("lead_lag", OGATA_LEAD, {"poles": (-1 + 2 * sp.I, -1 - 2 * sp.I), "velocity_constant": r(9)}, "a lag section"),
        ("lead", plant(sp.Integer(-1), s**3 + s), {"poles": (-2 + 3 * sp.I, -2 - 3 * sp.I)}, "is not stable"),
        ("lag", OGATA_LEAD, {"poles": (-3 + 2 * sp.I, -3 - 2 * sp.I), "velocity_constant": sp.Integer(5)}, "not near"),
        ("lag", OGATA_LEAD, {"poles": (-1 + 2 * sp.I, -1 - 2 * sp.I), "velocity_constant": sp.Integer(1)}, "is needed"),
        ("lead", OGATA_LEAD, {"poles": (-2 + 3 * sp.I, -2 - 3 * sp.I), "velocity_constant": r(90)}, "lead-lag"),
    ],
)  # fmt: skip
def test_poles_that_cannot_be_are_said(task, G, asked, why):
    result = ask(f"{task}_compensator", G, LOCUS, **asked)
    assert result.status is Status.UNSOLVED
    assert why in str(result.reason)
