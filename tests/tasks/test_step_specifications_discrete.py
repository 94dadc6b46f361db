"""Step responses at samples: hand-worked values, the recursion in fractions, edge cases, corruptions, marking."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy import signal

from solver.derivation import Answers, CheckStatus, Given, Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.marked import verdict
from tests.helpers.tried import tried

TASK = "step_specifications"
R = sp.Rational
NAMES = ("rise_time", "peak_time", "overshoot", "settling_time", "final_value")


def solved(G, more="", sample_time=""):
    kept = f", sample_time: {sample_time}" if sample_time else ""
    text = f'system: {{time: discrete{kept}, transfer_function: "{G}"}}\nfind: {{a: {{task: {TASK}{more}}}}}\n'
    return solve_problem(read_problem(Source("file.yaml", text), catalogue())).parts[0]


def test_one_pole():
    """Y = 1 − (1/2)^k: 10 % at k = 1, 90 % at 4, within 2 % from 6 on."""
    result = solved("1/(2z - 1)")
    assert result.status is Status.VERIFIED
    assert [result.answers.get(name) for name in NAMES] == [3, None, 0, 6, 1]
    kinds = [step.kind for step in result.steps]
    assert kinds[-6:] == ["final", "samples", "no_peak", "rise", "settling", "marked"]
    timed = solved("1/(2z - 1)", ", settling_band: 5%", "1/5").answers
    assert [timed.get(name) for name in NAMES] == [R(3, 5), None, 0, 1, 1]
    assert str(solved("1/(2z - 1)", sample_time="T").answers["settling_time"]) == "6*T"


def test_overshoot_of_a_pair():
    """Samples 0, 0.2, 0.66, 1.148, 1.4724, 1.54592, 1.395... by hand."""
    result = solved("0.2(z + 0.9)/(z^2 - 1.4z + 0.78)", "", "0.1")
    assert result.status is Status.VERIFIED
    assert result.answers["peak_time"] == R(1, 2)
    assert result.answers["overshoot"] == R(54592, 100000)
    assert result.answers["rise_time"] == R(3, 10)
    assert result.answers["settling_time"] == 3
    settling = next(step for step in result.steps if step.kind == "settling")
    assert (settling.values["within"], settling.values["outside"][0]) == (32, 29)


def test_a_final_value_reached_in_finite_time():
    answers = solved("(z + 1)/(2z^3)", "", "2").answers
    assert [answers.get(name) for name in NAMES] == [6, None, 0, 6, 1]
    through = solved("(z + 1)/(2z)").answers
    assert [through.get(name) for name in NAMES] == [1, None, 0, 1, 1]
    constant = solved("7").answers
    assert [constant.get(name) for name in NAMES] == [0, None, 0, 0, 7]


def test_an_alternating_response_and_an_undershoot():
    answers = solved("3/(2z + 1)").answers
    assert [answers.get(name) for name in NAMES] == [1, 1, R(1, 2), 6, 2 * R(1, 2)]
    wrong_way = solved("(2 - z)/(4z^2 - 2z)")
    below = next(step for step in wrong_way.steps if step.kind == "no_peak").values["below"]
    assert below == (1, -R(1, 4))
    negative = solved("-1/(2z - 1)").answers
    assert [negative.get(name) for name in NAMES] == [3, None, 0, 6, -1]


def test_poles_of_one_size():
    """Y = 1 − 4^{−⌊k/2⌋}… of z² = 1/4 never reaches its final value; with alternating signs it does."""
    never = solved("3/(4z^2 - 1)").answers
    assert never.get("peak_time") is None
    assert never["final_value"] == 1
    assert solved("(4z + 3)/(8z^3 - 1)").answers["final_value"] == 1
    turning = solved("5/(4z^2 + 1)").answers
    assert turning["overshoot"] == R(1, 4)
    assert turning["peak_time"] == 2


@pytest.mark.parametrize(
    ("G", "more", "says"),
    [
        ("1/(z - 1)", "", "inside the unit circle"),
        ("1/(z + 2)", "", "inside the unit circle"),
        ("(z - 1)/(2z - 1)", "", "returns to zero"),
        ("K/(2z - 1)", "", "value"),
        ("1/(z - 0.9999999)", "", "slowly"),
    ],
)
def test_where_there_are_none(G, more, says):
    result = solved(G, more)
    assert result.status is Status.UNSOLVED
    assert says in str(result.reason)


def test_the_formulas_are_of_continuous_time():
    with pytest.raises(InputError) as caught:
        solved("1/(2z - 1)", ", method: formulas")
    assert "not for systems in discrete time" in str(caught.value)


POLES = st.one_of(
    st.sampled_from([-3, -2, -1, 1, 2, 3]).map(lambda p: [-Fraction(p, 4)]),
    st.tuples(st.integers(-2, 3), st.integers(1, 2)).map(
        lambda p: [-Fraction(p[0], 2), Fraction(p[0] ** 2 + p[1] ** 2, 16)]
    ),
)


def looked_through(b, a, band, whole, samples=400):
    """Each quantity from its definition, by the recursion in fractions; None where the samples do not tell."""
    b = [Fraction(0)] * (len(a) - len(b)) + b
    final = sum(b) / sum(a)
    y = []
    for k in range(samples):
        y.append(sum(b[: k + 1]) - sum(a[j] * y[k - j] for j in range(1, min(len(a), k + 1))))
        y[k] = y[k] if k < 60 else y[k].limit_denominator(10**15)
    shares = [each / final for each in y]
    outside = [k for k in range(samples) if abs(shares[k] - 1) > band]
    reached = next((k for k in range(60) if shares[k] >= 1), None)
    first = [next(k for k in range(samples) if shares[k] >= level) for level in (Fraction(1, 10), Fraction(9, 10))]
    best = max(shares[:60])
    return {
        "final_value": final,
        "settling_time": outside[-1] + 1 if outside else 0,
        "rise_time": reached if whole and reached is not None else first[1] - first[0],
        "overshoot": max(best - 1, Fraction(0)),
        "peak_time": shares.index(best) if best > 1 else None,
    }


@pytest.mark.parametrize("whole", [False, True])
def test_every_other_sample_may_be_the_final_value_itself(whole):
    """The modes 2⁻ᵏ and (−2)⁻ᵏ cancel in every other sample."""
    result = solved("(2z - 1/2)/(z^2 - 1/4)", f", settling_band: 2%, rise: {'0-100' if whole else '10-90'}")
    assert result.status is Status.VERIFIED, result.reason
    a, b = [Fraction(1), Fraction(0), Fraction(-1, 4)], [Fraction(2), Fraction(-1, 2)]
    for name, value in looked_through(b, a, Fraction(2, 100), whole).items():
        assert (value is None) == (name not in result.answers), name
        assert value is None or float(result.answers[name]) == pytest.approx(float(value)), name


@tried(25)
@given(st.lists(POLES, min_size=1, max_size=2), st.integers(-3, 3), st.sampled_from(["2%", "5%"]), st.booleans())
def test_the_samples_show_the_same(factors, zero, band, whole):
    a = [Fraction(1)]
    for factor in factors:
        a = [Fraction(c).limit_denominator(10**6) for c in np.polymul(a, [Fraction(1), *factor])]
    z = sp.Symbol("z")
    top = 2 * z - R(zero, 2) if zero != 4 else sp.Integer(2)
    b = [Fraction(2), -Fraction(zero, 2)]
    if max(abs(np.roots([float(c) for c in a]))) > 0.95 or sum(b) == 0:
        return
    bottom = sum(R(c.numerator, c.denominator) * z ** (len(a) - 1 - i) for i, c in enumerate(a))
    result = solved(
        f"({top})/({bottom})".replace("**", "^"), f", settling_band: {band}, rise: {'0-100' if whole else '10-90'}"
    )
    assert result.status is Status.VERIFIED, result.reason
    wanted = looked_through(b, a, Fraction(5 if band == "5%" else 2, 100), whole)
    for name, value in wanted.items():
        assert (value is None) == (name not in result.answers), name
        if value is not None:
            assert float(result.answers[name]) == pytest.approx(float(value), rel=1e-9, abs=1e-12), name


def test_the_simulation_of_scipy_shows_the_same():
    """A response with decimals that are no fractions: e^{−1}, as a hold makes it."""
    result = solved("(z exp(-1) + 1 - 2exp(-1))/(z^2 - z + 1 - exp(-1))", "", "1")
    assert result.status is Status.VERIFIED
    q = np.exp(-1)
    _, y = signal.dstep(([q, 1 - 2 * q], [1, -1, 1 - q], 1), n=60)
    y = np.ravel(y[0])
    assert float(result.answers["overshoot"]) == pytest.approx(max(y) - 1, rel=1e-12)
    assert result.answers["peak_time"] == int(np.argmax(y))
    assert result.answers["settling_time"] == np.nonzero(abs(y - 1) > 0.02)[0][-1] + 1


def failing(G, name, value, sample_time="", **options):
    """Whether the verification rejects a value of one answer."""
    task = catalogue()[TASK]
    filled = {"settling_band": "2%", "rise": "0-100", "overshoot_in": "fraction", **options}
    given = task.given(system_of(G, sample_time), filled, "response")
    checks = list(task.verify(Given(given.system, given.options, "response"), Answers(**{name: value})))
    return any(check.status is CheckStatus.FAILED for check in checks)


def system_of(G, sample_time):
    kept = f", sample_time: {sample_time}" if sample_time else ""
    text = f'system: {{time: discrete{kept}, transfer_function: "{G}"}}\nfind: {{a: {TASK}}}\n'
    return read_problem(Source("file.yaml", text), catalogue()).parts[0].system


@pytest.mark.parametrize("sample_time", ["", "0.1"])
def test_corrupted_answers_are_rejected(sample_time):
    G = "0.2(z + 0.9)/(z^2 - 1.4z + 0.78)"
    right = solved(G, "", sample_time).answers
    unit = R(1, 10) if sample_time else 1
    for name in NAMES:
        assert not failing(G, name, right[name], sample_time)
        off = unit if name.endswith("time") else R(1, 10**6)
        assert failing(G, name, right[name] + off, sample_time), name
        assert failing(G, name, right[name] - off, sample_time), name
    assert failing("1/(2z - 1)", "peak_time", sp.Integer(3))


PAPER = """\
system: {time: discrete, sample_time: 3/10, transfer_function: "3/(4z^2 - 3z + 2)"}
find: {a: {task: step_specifications}}
"""


@pytest.mark.parametrize(
    ("name", "value", "verdict_", "named"),
    [
        ("final_value", "1", "correct", ""),
        ("final_value", "1.5", "wrong", "first sample"),
        ("settling_time", "3.3", "correct", ""),
        ("peak_time", "1.2", "correct", ""),
        ("overshoot", "1.359375", "wrong", "value at the peak"),
    ],
)
def test_marking(name, value, verdict_, named):
    found = verdict(PAPER, "a", name, value)
    assert found.verdict == verdict_, (found.reason, solved("3/(4z^2 - 3z + 2)", "", "3/10").answers)
    assert named in str(found.reason)
