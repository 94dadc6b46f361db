"""Time constants of discrete systems, and their DC gains and pole-zero forms: numpy's roots, corruptions, marking."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected
from tests.helpers.fractions_of_polynomials import plant, z
from tests.helpers.marked import verdict
from tests.helpers.tried import tried

R = sp.Rational


def solved(task, G, more="", sample_time="", outside=""):
    kept = f", sample_time: {sample_time}" if sample_time else ""
    text = f'system: {{time: discrete{kept}, transfer_function: "{G}"}}\nfind: {{a: {{task: {task}{more}}}}}\n{outside}'
    return solve_problem(read_problem(Source("file.yaml", text), catalogue())).parts[0]


def test_the_slowest_is_nearest_to_the_circle():
    result = solved("time_constants", "1/((2z - 1)(4z + 3)z^2)", "", "1/10")
    assert result.status is Status.VERIFIED
    assert result.answers["time_constants"] == [-R(1, 10) / sp.log(R(3, 4)), R(1, 10) / sp.log(2), 0, 0]
    assert [step.kind for step in result.steps] == ["poles", "constants", "slowest"]


def test_pairs_symbols_and_no_sampling_period():
    T = sp.Symbol("T", positive=True)
    pair = solved("time_constants", "z/(8z^2 - 8z + 4)", "", "T").answers["time_constants"]
    assert [sp.simplify(each.subs(each.free_symbols.pop(), T) - 2 * T / sp.log(2)) for each in pair] == [0, 0]
    assert solved("time_constants", "1/(2z - 1)").answers["time_constants"] == [1 / sp.log(2)]
    held = solved("time_constants", "1/(z - exp(-a T))", "", "T", "assume: {a: positive}").answers["time_constants"]
    assert str(held) == "[1/a]"


def test_what_does_not_decay_has_none():
    result = solved("time_constants", "1/((z - 2)(3z - 1))", "", "2")
    assert result.answers["time_constants"] == [2 / sp.log(3)]
    assert result.steps[-1].values["others"] == [2]
    none = solved("time_constants", "1/(z^2 + 1)")
    assert none.status is Status.UNSOLVED
    assert "unit circle" in str(none.reason)


@tried(12)
@given(st.lists(st.integers(-7, 7), min_size=1, max_size=3), st.integers(1, 9))
def test_numpy_finds_the_same(eighths, gain):
    bottom = sp.expand(sp.Mul(*(8 * z - p for p in eighths)))
    result = ask("time_constants", plant(gain, bottom, discrete=True))
    assert result.status is Status.VERIFIED, result.reason
    sizes = abs(np.array(eighths) / 8)
    wanted = sorted((-1 / np.log(size) if size else 0 for size in sizes), reverse=True)
    assert np.allclose([float(each) for each in result.answers["time_constants"]], wanted)


def test_corrupted_answers_are_rejected():
    G = plant(2 * z + 1, sp.expand((2 * z - 1) * (4 * z + 3) * z), discrete=True)
    right = ask("time_constants", G).answers["time_constants"]
    assert not rejected("time_constants", G, {"time_constants": right})
    for wrong in (right[:2], [*right[:2], right[1]], [2 * each for each in right], [right[0], right[0], right[2]]):
        assert rejected("time_constants", G, {"time_constants": wrong})
    assert not rejected("dc_gain", G, {"dc_gain": R(3, 7)})
    for gain in (R(3, 7) + R(1, 10**9), -R(3, 7), sp.oo, sp.S.Zero):
        assert rejected("dc_gain", G, {"dc_gain": gain})
    integrating = plant(1, sp.expand((z - 1) ** 3), discrete=True)
    assert not rejected("dc_gain", integrating, {"dc_gain": sp.oo})
    assert rejected("dc_gain", integrating, {"dc_gain": -sp.oo})
    assert rejected("dc_gain", integrating, {"dc_gain": sp.S.One})
    for name, value in (("gain", R(1, 2)), ("zeros", [R(1, 2)]), ("poles", [R(1, 2), -R(3, 4)])):
        assert rejected("pole_zero_form", G, {name: value})


@pytest.mark.parametrize(
    ("G", "gain"),
    [("(3z + 1)/(4z^2 - 2z + 1)", R(4, 3)), ("(z + 1)/((z - 1)(2z - 1))", sp.oo), ("2/(z + 3)", R(1, 2))],
)
def test_dc_gains(G, gain):
    result = solved("dc_gain", G)
    assert result.status is Status.VERIFIED
    assert result.answers["dc_gain"] == gain


def test_pole_zero_forms():
    result = solved("pole_zero_form", "(3z^2 - 3z/2)/(4z^3 - 2z^2 + z)")
    assert result.status is Status.VERIFIED
    answers = result.answers
    assert (answers["gain"], answers["zeros"]) == (R(3, 4), [R(1, 2)])
    assert [sp.expand(p * sp.conjugate(p)) for p in answers["poles"]] == [R(1, 4), R(1, 4)]


PAPER = """\
system: {time: discrete, sample_time: 3/10, transfer_function: "(z + 2)/(4(z - 1/4)(z - 1/2))"}
find: {a: dc_gain, b: {task: pole_zero_form}, c: time_constants}
"""


@pytest.mark.parametrize(
    ("part", "name", "value", "verdict_", "named"),
    [
        ("a", "dc_gain", "2", "correct", ""),
        ("a", "dc_gain", "1/2", "wrong", "are exchanged"),
        ("b", "gain", "0.25", "correct", ""),
        ("b", "poles", "[-1/4, -1/2]", "wrong", "signs are turned"),
        ("c", "time_constants", "[0.433, 0.216]", "correct", ""),
        ("c", "time_constants", "[1.443, 0.721]", "wrong", "counted in samples"),
        ("c", "time_constants", "[2, 4]", "wrong", "poles in $s$"),
    ],
)
def test_marking(part, name, value, verdict_, named):
    found = verdict(PAPER, part, name, value)
    assert found.verdict == verdict_, found.reason
    assert named in str(found.reason)


def test_a_real_pole_with_a_parameter_is_shown_by_its_absolute_value():
    a = sp.Symbol("a", positive=True)
    result = solved("time_constants", "1/(z + a)", "", "", 'conditions: ["0 < a < 1"]')
    assert result.status is Status.VERIFIED, result.reason
    (found,) = result.answers["time_constants"]
    (given,) = found.free_symbols
    assert found.subs(given, a) == -1 / sp.log(a)
