"""Sensitivities: textbook results, random loops against differences, corruptions, marking, bad inputs."""

from __future__ import annotations

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Status
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import TransferFunction
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict
from tests.tasks.test_steady_state_error import open_loop

s, K, a, h = sp.symbols("s K a h", real=True)
s = sp.Symbol("s")
ONE = sp.Integer(1)


def plant(G):
    top, bottom = (sp.Poly(each, s).as_expr() for each in sp.fraction(sp.together(G)))
    return TransferFunction(sp.ImmutableMatrix([[sp.cancel(G)]]), ((top,),), ((bottom,),), s)


@pytest.mark.parametrize(
    ("G", "options", "wanted"),
    [
        (K / (s * (s + a)), {"feedback": ONE}, s * (s + a) / (s**2 + a * s + K)),
        (K / (s * (s + a)), {"feedback": ONE, "parameter": "K"}, s * (s + a) / (s**2 + a * s + K)),
        (K / (s * (s + a)), {"feedback": ONE, "parameter": "a"}, -a * s / (s**2 + a * s + K)),
        (K / (s * (s + a)), {"feedback": h, "parameter": "h"}, -K * h / (s**2 + a * s + K * h)),
        (K / (s * (s + a)), {"parameter": "K"}, ONE),
        (K / (s + 1), {"parameter": "K", "controller": 1 / s, "feedback": ONE}, s * (s + 1) / (s**2 + s + K)),
    ],
)
def test_results_of_the_textbooks(G, options, wanted):
    result = ask("sensitivity", plant(G), **options)
    assert result.status is Status.VERIFIED
    assert sp.cancel(result.answers["S"] - wanted) == 0


def test_the_steps():
    steps = ask("sensitivity", plant(K / (s * (s + a))), feedback=ONE, parameter="a").steps
    assert [step.kind for step in steps] == ["open_loop", "transfer", "derivative", "relative", "by_the_plant"]


@settings(max_examples=10)
@given(st.integers(1, 5), st.integers(-3, 3), st.integers(0, 2))
def test_random_loops_change_as_differences_say(gain, zero, power):
    G = K * (s - zero) / ((s + K) ** power * (s**2 + gain * s + 2))
    S = ask("sensitivity", plant(G), feedback=ONE, parameter="K").answers["S"]
    T = (G / (1 + G)).subs(s, sp.Rational(7, 5) + 2 * sp.I)
    here, step = sp.Rational(6, 5), sp.Rational(1, 10**12)
    slope = (T.subs(K, here + step) - T.subs(K, here - step)) / (2 * step)
    wanted = complex((slope * here / T.subs(K, here)).evalf(40))
    found = complex(S.subs({s: sp.Rational(7, 5) + 2 * sp.I, K: here}).evalf(20))
    assert found == pytest.approx(wanted)


def test_corrupted_answers_are_rejected():
    loop = open_loop(plant(K / (s * (s + a))))
    for options in ({"feedback": ONE}, {"feedback": ONE, "parameter": "K"}, {"feedback": ONE, "parameter": "a"}):
        S = ask("sensitivity", plant(K / (s * (s + a))), **options).answers["S"]
        assert not rejected("sensitivity", loop, {"S": S}, **options)
        for wrong in (-S, 1 - S, S * (1 + sp.Rational(1, 10**9)), sp.S.Zero):
            assert rejected("sensitivity", loop, {"S": wrong}, **options)


PAPER = """\
system: {transfer_function: K/(s(s + 2))}
assume: {K: positive}
find:
  a: {task: sensitivity, feedback: unity}
  b: {task: sensitivity, feedback: unity, parameter: K}
"""


@pytest.mark.parametrize(
    ("part", "value", "said"),
    [
        ("a", "(s^2 + 2s)/(s^2 + 2s + K)", ""),
        ("a", "K/(s^2 + 2s + K)", "complementary"),
        ("a", "1 + K/(s^2 + 2s)", "its inverse"),
        ("b", "(s^2 + 2s)/(s^2 + 2s + K)^2", "derivative alone"),
        ("b", "s(s + 2)/(s(s + 2) + K)", ""),
    ],
)
def test_marking(part, value, said):
    found = verdict(PAPER, part, "S", f'"{value}"')
    assert found.verdict == ("wrong" if said else "correct")
    assert said in str(found.reason)


def test_a_parameter_that_is_none_is_refused_at_its_place():
    with pytest.raises(InputError) as caught:
        read_problem(Source("a.yaml", PAPER.replace("parameter: K", "parameter: k1")), catalogue())
    assert "no parameter" in str(caught.value)
    assert "^" in str(caught.value)
