"""Step responses: formulas and the response itself, textbook values, edge cases, corruptions, marking."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import example, given
from hypothesis import strategies as st
from scipy import signal

from solver.derivation import Answers, CheckStatus, Given, Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected
from tests.helpers.fractions_of_polynomials import plant, s
from tests.helpers.marked import verdict
from tests.helpers.tried import tried

TASK = "step_specifications"
R = sp.Rational
NAMES = ("rise_time", "peak_time", "overshoot", "settling_time", "final_value")


def solved(G, more="", outside=""):
    text = f'system: {{transfer_function: "{G}"}}\nfind: {{a: {{task: {TASK}{more}}}}}\n{outside}'
    return solve_problem(read_problem(Source("file.yaml", text), catalogue())).parts[0]


def test_the_formulas_of_second_order():
    """Ogata, Modern Control Engineering, example 5-1: ζ = 0.6, ω_n = 5 give 0.55 s, 0.785 s, 9.5 %, 1.33 s."""
    result = solved("25/(s^2 + 6s + 25)")
    assert result.status is Status.VERIFIED
    assert [step.kind for step in result.steps] == ["standard", "rise", "peak", "overshoot", "settling", "marked"]
    answers = result.answers
    assert answers["peak_time"] == sp.pi / 4
    assert answers["overshoot"] == sp.exp(-3 * sp.pi / 4)
    assert answers["settling_time"] == R(4, 3)
    assert float(answers["rise_time"]) == pytest.approx(0.5536, abs=1e-4)
    assert solved("25/(s^2 + 6s + 25)", ", settling_band: 5%").answers["settling_time"] == 1


def test_parameters_by_the_formulas():
    result = solved(
        "omega^2/(s^2 + 2zeta omega s + omega^2)",
        outside='assume: {omega: positive}\nconditions: ["0 < zeta < 1"]',
    )
    assert result.status is Status.VERIFIED
    assert {x.name for x in result.answers["overshoot"].free_symbols} == {"zeta"}
    open_damping = solved("K/(s^2 + 2s + K)", outside="assume: {K: positive}")
    assert open_damping.status is Status.UNSOLVED
    assert "between 0 and 1" in str(open_damping.reason)


@pytest.mark.parametrize(
    ("G", "method", "says"),
    [
        ("1/((s + 1)(s + 2))", "formulas", "real poles"),
        ("1/(s + 1)^2", "formulas", "real poles"),
        ("1/(s + 1)", "formulas", "1 pole"),
        ("(s + 1)/(s^2 + s + 1)", "formulas", "1 zero"),
        ("1/(s^2 + 4)", "formulas", "does not settle"),
        ("1/(s^2 - s + 4)", "formulas", "does not settle"),
        ("1/(s(s + 1))", "response", "not settle"),
        ("1/(s - 1)", "response", "not settle"),
        ("s/(s + 1)", "response", "returns to zero"),
        ("K/(s + 1)", "response", "value"),
    ],
)
def test_where_there_are_none(G, method, says):
    result = solved(G, f", method: {method}")
    assert result.status is Status.UNSOLVED
    assert says in str(result.reason)


def test_the_response_of_second_order_agrees_with_the_formulas():
    result = solved("25/(s^2 + 6s + 25)", ", method: response")
    assert result.status is Status.VERIFIED
    answers = result.answers
    assert answers["peak_time"] == sp.pi / 4
    assert float(answers["overshoot"]) == pytest.approx(np.exp(-3 * np.pi / 4), rel=1e-12)
    assert float(answers["settling_time"]) == pytest.approx(1.18860, abs=1e-5)


def test_one_mode_gives_logarithms():
    result = solved("5/(2s + 1)", ", method: response")
    assert result.status is Status.VERIFIED
    assert "peak_time" not in result.answers
    assert result.answers["overshoot"] == 0
    assert result.answers["settling_time"] == 2 * sp.log(50)
    assert sp.N(result.answers["rise_time"] - 2 * sp.log(9), 20) == pytest.approx(0, abs=1e-15)
    rise = next(step for step in result.steps if step.kind == "rise")
    assert rise.values["never"]
    assert not next(
        s for s in solved("5/(2s + 1)", ", method: response, rise: 10-90").steps if s.kind == "rise"
    ).values["never"]


def test_initial_undershoot_and_a_jump():
    result = solved("(1 - s)/((s + 1)(s + 2))", ", method: response")
    under = next(step for step in result.steps if step.kind == "no_peak").values["under"]
    assert float(under.time) == pytest.approx(np.log(1.5), rel=1e-12)
    assert float(under.share) == pytest.approx(-1 / 3, rel=1e-12)
    jump = solved("(2s + 1)/(s + 1)", ", method: response").answers
    assert (jump["peak_time"], jump["overshoot"], jump["rise_time"]) == (0, 1, 0)
    assert jump["settling_time"] == sp.log(50)


def test_a_constant_and_a_dead_time():
    answers = solved("7", ", method: response").answers
    assert [answers.get(name) for name in NAMES] == [0, None, 0, 0, 7]
    late = solved("25exp(-2s)/(s^2 + 6s + 25)", ", method: response")
    assert late.status is Status.VERIFIED
    assert late.answers["peak_time"] == sp.pi / 4 + 2
    assert float(late.answers["rise_time"]) == pytest.approx(0.5536, abs=1e-4)
    assert solved("25exp(-2s)/(s^2 + 6s + 25)").answers["settling_time"] == R(10, 3)


def test_a_tiny_overshoot_is_found():
    """ζ = 0.99: e^{−πζ/√(1−ζ²)} = 2.66e-10."""
    answers = solved("1/(s^2 + 1.98s + 1)", ", method: response").answers
    assert float(answers["overshoot"]) == pytest.approx(
        float(sp.exp(-sp.pi * R(99, 100) / sp.sqrt(1 - R(99, 100) ** 2))), rel=1e-9
    )


def test_a_negative_gain_and_a_closed_loop():
    answers = solved("-3/(s^2 + s + 1)", ", method: response").answers
    assert answers["final_value"] == -3
    assert float(answers["overshoot"]) == pytest.approx(0.16303, abs=1e-5)
    loop = solved("1/(s(s + 4))", ", controller: 8, feedback: unity")
    assert loop.status is Status.VERIFIED
    assert loop.answers["overshoot"] == sp.exp(-sp.pi)


ROOTS = st.one_of(
    st.integers(1, 6).map(lambda a: s + a),
    st.tuples(st.integers(1, 4), st.integers(1, 6)).map(lambda p: (s + p[0]) ** 2 + p[1] ** 2),
)


@tried(12)
@given(st.lists(ROOTS, min_size=1, max_size=2), st.integers(-4, 6), st.sampled_from(["2%", "5%"]))
@example([s + 2, (s + 1) ** 2 + 4], 2, "2%")  # samples of two modes beside the peak, both after it
def test_simulations_show_the_same(factors, zero, band):
    bottom = sp.Poly(sp.expand(sp.Mul(*factors)), s)
    top = sp.Poly(zero * s + 6 if bottom.degree() > 1 else 6, s)
    result = ask(
        TASK,
        plant(top.as_expr(), bottom.as_expr()),
        "response",
        settling_band=band,
        rise="10-90",
        overshoot_in="fraction",
    )
    assert result.status is Status.VERIFIED, result.reason
    answers = {name: float(value) for name, value in result.answers.items()}
    t = np.linspace(0, max(12, 3 * answers["settling_time"]), 60001)
    _, y = signal.step(([float(c) for c in top.all_coeffs()], [float(c) for c in bottom.all_coeffs()]), T=t)
    share = y / answers["final_value"]
    step = 3 * (t[1] - t[0])
    assert max(0, share.max() - 1) == pytest.approx(answers["overshoot"], abs=1e-4)
    outside = np.nonzero(abs(share - 1) > (0.05 if band == "5%" else 0.02))[0]
    assert (t[outside[-1]] if len(outside) else 0) == pytest.approx(answers["settling_time"], abs=step)
    rise = t[np.argmax(share >= 0.9)] - t[np.argmax(share >= 0.1)]
    assert rise == pytest.approx(answers["rise_time"], abs=2 * step)


G = plant(25, s**2 + 6 * s + 25)
CHANGES = [lambda v: 2 * v, lambda v: v * R(10001, 10000), lambda v: -v, lambda v: v / 2]


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("method", ["formulas", "response"])
def test_each_answer_alone_is_accepted_and_each_corruption_rejected(name, method):
    declared = catalogue()[TASK]
    options = {"settling_band": "2%", "rise": "0-100", "overshoot_in": "fraction"}
    answer = ask(TASK, G, method, **options).answers[name]

    def wrong(value):
        asked = Given(G, declared.given(G, options).options, method)
        checks = list(declared.verify(asked, Answers(**{name: value})))
        return any(check.status is CheckStatus.FAILED for check in checks)

    assert not wrong(answer)
    for change in CHANGES:
        assert wrong(change(answer))


def test_a_peak_where_there_is_none_is_rejected():
    assert rejected(
        TASK, plant(1, s + 1), {"peak_time": sp.Integer(3)}, settling_band="2%", rise="10-90", overshoot_in="fraction"
    )


PROBLEM = """
system: {transfer_function: "25/(s^2 + 6s + 25)"}
find:
  a: step_specifications
  b:
    task: step_specifications
    settling_band: 2%
    rise: 0-100
    system: {transfer_function: "30/(s^2 + 7s + 30)"}
  c:
    task: step_specifications
    system: {transfer_function: "25/(s^2 + 4s + 25)"}
  d:
    task: step_specifications
    method: response
    settling_band: 2%
    system: {transfer_function: "9/(s^2 + 3s + 9)"}
"""


@pytest.mark.parametrize(
    ("part", "name", "value", "says"),
    [
        ("a", "overshoot", "0.0948", ""),
        ("a", "overshoot", "9.48 %", ""),
        ("a", "overshoot", "9.48", ""),
        ("a", "overshoot", "1.0948", "value at the peak"),
        ("a", "peak_time", "pi/4", ""),
        ("a", "peak_time", "0.6283", "damped frequency"),
        ("a", "peak_time", "1.571", "half of it"),
        ("a", "settling_time", "1.333", ""),
        ("a", "settling_time", "1.000", ""),
        ("b", "settling_time", "0.857", "another band"),
        ("d", "settling_time", "8/3", "formula of second order"),
        ("d", "settling_time", "2", "another band"),
        ("a", "rise_time", "0.5536", ""),
        ("a", "rise_time", "0.3708", ""),
        ("b", "rise_time", "0.3708", " "),
        ("c", "overshoot", "0.01516", "wrong coefficient"),  # twice the damping ratio, 0.8
        ("c", "peak_time", "1.0472", "wrong coefficient"),
        ("c", "rise_time", "0.8327", "wrong coefficient"),
        ("c", "settling_time", "0.750", "wrong coefficient"),
    ],
)
def test_marking(part, name, value, says):
    found = verdict(PROBLEM, part, name, value)
    assert (found.verdict.value == "correct") is not says, found.reason
    assert says.strip() in str(found.reason)


def test_a_band_that_is_none_is_refused_in_its_place():
    text = "system: {transfer_function: 1/(s + 1)}\nfind: {a: {task: step_specifications, settling_band: 3%}}\n"
    with pytest.raises(InputError, match="2%, 5%"):
        read_problem(Source("file.yaml", text), catalogue())


@pytest.mark.parametrize(
    ("G", "marked"),
    [
        ("25/(s^2 + 6s + 25)", ["peak_time", "rise_time", "settling_time"]),
        ("2/(s^2 + 3s + 2)", ["settling_time"]),
        ("(3s + 1)/(s + 1)", ["settling_time"]),  # the largest value is that at the start
    ],
)
def test_the_figure_marks_the_peak_where_there_is_one_on_the_way(G, marked):
    result = solved(G, ", method: response")
    (figure,) = (figure for step in result.steps for figure in step.figures if step.kind == "marked")
    labels = [str(curve.label) for curve in figure.curves]
    assert [label for label in labels if label.startswith(r"\sym")] == [rf"\sym{{{name}}}" for name in marked]
    if "peak_time" in marked:
        top = result.answers["final_value"] * (1 + result.answers["overshoot"])
        assert (figure.marks[0].x, figure.marks[0].y) == (result.answers["peak_time"], top)
