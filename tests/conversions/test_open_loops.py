"""What runs round a loop, L = C G H, evaluated at complex points by plain arithmetic."""

from __future__ import annotations

import cmath

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import CheckStatus, Unsolved
from solver.derivation.conversion import chain_to, converted
from solver.engine import yield_into
from solver.lazy import numeric
from solver.systems import DeadTime, OpenLoop, OutputFeedback, StateSpace, TransferFunction
from tests.conversions.test_loops import POINT, plant, polynomials, s, value


def open_loop(system):
    steps = []
    return yield_into(steps, converted(system, ("open_loop",))), steps


@settings(max_examples=20)
@given(polynomials, polynomials, st.integers(1, 5), polynomials)
def test_the_open_loop_is_the_product(q, d, gain, k):
    G, C, H = plant(sp.Integer(gain), sp.Poly(q, s).as_expr()), 3 / sp.Poly(d, s).as_expr(), 1 / sp.Poly(k, s).as_expr()
    L, steps = open_loop(OutputFeedback(G, C, H))
    assert value(L.numerator / L.denominator) == pytest.approx(value(C) * value(G.matrix[0, 0]) * value(H))
    assert sp.degree(L.denominator, s) == len(q) + len(d) + len(k) - 3
    assert (L.closed, L.delay) == (True, 0)
    assert [step.kind for step in steps] == ["open_loop"]
    assert all(check.status is CheckStatus.PASSED for check in numeric.check_steps(steps))


def test_nothing_is_cancelled_between_the_factors():
    L, _ = open_loop(OutputFeedback(plant(sp.Integer(1), s - 1), (s - 1) / (s + 2), sp.Integer(1)))
    assert sp.expand(L.denominator - (s - 1) * (s + 2)) == 0


def test_a_dead_time_stands_apart():
    G = DeadTime(plant(sp.Integer(2), s + 1), sp.Rational(1, 2))
    L, _ = open_loop(OutputFeedback(G, 3 / s, None))
    assert (L.delay, L.closed) == (sp.Rational(1, 2), False)
    found = value(L.rational.matrix[0, 0]) * cmath.exp(-POINT / 2)
    assert found == pytest.approx(6 / POINT / (POINT + 1) * cmath.exp(-POINT / 2))


def test_a_transfer_function_alone_is_its_own_open_loop():
    L, steps = open_loop(plant(sp.Integer(2), s + 1))
    assert steps == []
    assert (L.C, L.H, L.closed) == (1, 1, False)
    assert 2 / (s + 1) == L.G


def test_a_plant_in_state_space_is_brought_to_its_transfer_function_first():
    system = StateSpace(*(sp.ImmutableMatrix([[entry]]) for entry in (-1, 2, 1, 0)))
    assert [each.target for each in chain_to(system, ("open_loop",))] == [TransferFunction, OpenLoop]


def test_an_improper_open_loop_is_refused():
    with pytest.raises(Unsolved) as raised:
        open_loop(OutputFeedback(plant(sp.Integer(1), s + 1), s**2, sp.Integer(1)))
    assert raised.value.reason.kind == "conversions/improper_loop"


def test_several_channels_are_refused():
    G = TransferFunction(sp.ImmutableMatrix([[1 / s, 1 / s]]), ((sp.Integer(1),) * 2,), ((s, s),), s)
    with pytest.raises(Unsolved) as raised:
        open_loop(G)
    assert raised.value.reason.kind == "conversions/loop_of_several_channels"
