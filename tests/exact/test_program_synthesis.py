"""Programs from machine equations: signs by trying all of them, coefficients put together again, overload in time."""

from itertools import product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import E, Heaviside, Integer, Rational, cos, exp, log, sin, sqrt, symbols

from solver.exact.analog.overload import first_overload
from solver.exact.analog.signs import SignedRow, carried_signs
from solver.exact.analog.synthesis import NoBound, TooLarge, bound, synthesized
from solver.lazy import exact
from solver.patches import faults_of
from solver.postconditions.programs import of_synthesized

GAINS = [Integer(1), Integer(10)]
TEN = Integer(10)
x, v, y, z, u, w, t = symbols("x v y z u w t")


def program_of(rates, initial=None, sums=None, inputs=None, gains=GAINS):
    """The program of equations whose variables are volts."""
    own = exact.machine_equations(rates, initial or [Integer(0)] * len(rates), sums or {}, inputs or {})
    read = {str(each): (each, Integer(1)) for each in own.variables}
    return own, read, synthesized(own, read, gains, TEN)


def holds(own, read, found, gains=GAINS):
    """Whether what must hold of a program holds: its netlist put together again is the equations."""
    for each in of_synthesized(found, own, read, gains, TEN):
        right = each.status == "passed" if hasattr(each, "status") else (each.left - each.right).expand() == 0
        if not right:
            return False
    return True


def least_by_trying(rows, inputs):
    """The fewest amplifiers beside those of the rows: all signs, and for each row inverters or a summer of its own."""
    names = [row.variable for row in rows]
    best = None
    for signs in product((1, -1), repeat=len(rows)):
        carried = dict(zip(names, signs, strict=True)) | dict.fromkeys(inputs, 1)
        wrong = [{s for s, c in row.terms.items() if carried[row.variable] * carried[s] * c > 0} for row in rows]
        for summed in product((False, True), repeat=len(rows)):
            if any(use and not row.collects for use, row in zip(summed, rows, strict=True)):
                continue
            inverted = set().union(*(each for each, use in zip(wrong, summed, strict=True) if not use))
            count = len(inverted) + sum(summed)
            best = count if best is None else min(best, count)
    return best


@settings(max_examples=60, deadline=None)
@given(st.data())
def test_signs_are_as_good_as_trying_all_of_them(data):
    n, inputs = data.draw(st.integers(1, 4)), [u, w]
    names = symbols(f"x1:{n + 1}")
    rows = [
        SignedRow(
            name,
            {s: c for s in [*names, *inputs] if (c := data.draw(st.sampled_from([0, 1, -1])))},
            data.draw(st.booleans()),
        )
        for name in names
    ]
    found = carried_signs(rows)
    assert found.exhaustive
    assert found.added == least_by_trying(rows, inputs)


@settings(max_examples=25, deadline=None)
@given(st.lists(st.fractions(-12, 12, max_denominator=8), min_size=12, max_size=12))
def test_the_netlist_put_together_is_the_equations(numbers):
    a = [Rational(each.numerator, each.denominator) for each in numbers]
    rates = {x: a[0] * x + a[1] * v + a[2] * z, v: a[3] * x + a[4] * v + a[5] * u, z: a[6] * v + a[7] * z + a[8]}
    own, read, found = program_of(
        rates, a[9:12] if max(map(abs, a[9:12])) <= 10 else None, {y: x - 2 * z + u}, {u: None}
    )
    assert holds(own, read, found)
    assert not list(faults_of(found.program, GAINS))


def test_an_oscillator_takes_one_inverter_and_a_decay_none():
    assert len(program_of({x: v, v: -x})[2].inverters) == 1
    assert not program_of({x: -x})[2].inverters
    assert len(program_of({x: x})[2].inverters) == 1


def test_a_sum_takes_its_wrong_terms_through_one_summer():
    a, b, c, d = symbols("v1:5")
    _, _, found = program_of({}, [], {y: -a - 10 * b + c + 10 * d}, dict.fromkeys([a, b, c, d]))
    kinds = [each.kind for each in found.program.elements if each.is_amplifier]
    assert kinds == ["summer", "summer"]
    assert not found.program.potentiometers


def test_a_long_chain_is_searched_by_single_changes():
    names = symbols("x1:13")
    rates = dict(zip(names, [*names[1:], -names[0]], strict=True))
    own, read, found = program_of(rates)
    assert not found.signs.exhaustive
    assert found.signs.added <= 1
    assert holds(own, read, found)


@pytest.mark.parametrize(
    ("coefficient", "wires"),
    [("1/2", [(1, "1/2")]), ("1", [(1, "1")]), ("5", [(10, "1/2")]), ("10", [(10, "1")]),
     ("25", [(10, "1"), (10, "1"), (10, "1/2")]), ("10.5", [(10, "1"), (1, "1/2")]), ("30", [(10, "1")] * 3)],
)  # fmt: skip
def test_a_coefficient_is_gains_times_settings(coefficient, wires):
    _, _, found = program_of({x: -Rational(coefficient) * x})
    assert [(each.gain, each.setting) for each in found.wires] == [(g, Rational(s)) for g, s in wires]


def test_a_coefficient_may_be_too_large():
    with pytest.raises(TooLarge) as case:
        program_of({x: -31 * x})
    assert (case.value.coefficient, case.value.most) == (31, 10)


def test_sources_are_as_large_as_the_reference_lets_them_be():
    _, _, found = program_of({x: -x + 3 * sin(2 * t) + 4}, inputs={})
    values = {each.value for each in found.program.of_kind("source")}
    assert {abs(each) for each in values if not each.free_symbols} == {10}
    assert sorted(found.program.potentiometers.values()) == [Rational(3, 10), Rational(2, 5)]


@pytest.mark.parametrize(
    ("function", "most"),
    [(sin(t), 1), (exp(-2 * t), 1), (exp(-t) * cos(3 * t), 1), (t * exp(-t), 1 / E), (Heaviside(t - 2), 1),
     (exp(1 - t), E), (t**2 * exp(-t) * sin(t), (2 / E) ** 2)],
)  # fmt: skip
def test_functions_are_bounded_by_their_factors(function, most):
    assert (bound(function) - most).simplify() == 0


@pytest.mark.parametrize("function", [t, exp(t), t * sin(t), 1 / (1 + t)])
def test_what_has_no_bound_that_is_seen_is_refused(function):
    with pytest.raises(NoBound):
        bound(function)


@pytest.mark.parametrize(
    ("rates", "initial", "maxima", "time"),
    [
        ({x: x}, [1], {x: 10}, log(10)),
        ({x: -x + 50}, [0], {x: 30}, log(Rational(5, 2))),
        ({x: v, v: Integer(2)}, [0, 0], {x: 9}, 3),
        ({x: v, v: -4 * x}, [0, 2], {x: sqrt(2) / 2, v: 9}, None),
    ],
)
def test_overload_is_when_the_size_is_first_exceeded(rates, initial, maxima, time):
    own = exact.machine_equations(rates, list(map(Integer, initial)), {}, {})
    found = first_overload(own, {each: Integer(1) * size for each, size in maxima.items()})
    assert found is not None
    if time is not None:
        assert found[1] == time
    else:
        assert float(found[1]) == pytest.approx(3.141592653589793 / 8, abs=1e-15)


def test_a_size_that_is_only_reached_is_no_overload():
    own = exact.machine_equations({x: -x + 50}, [Integer(0)], {}, {})
    assert first_overload(own, {x: Integer(50)}) is None
    own = exact.machine_equations({x: v, v: -x}, [Integer(0), Integer(1)], {}, {})
    assert first_overload(own, {x: Integer(1), v: Integer(1)}) is None


def test_a_resonance_leaves_its_range_after_some_turns():
    own = exact.machine_equations({x: v, v: -4 * x + u}, [Integer(0)] * 2, {}, {u: sin(2 * t)})
    variable, time, motion = first_overload(own, {x: Integer(3), v: Integer(9)})
    assert variable == x
    assert float(abs(motion.subs(t, time))) == pytest.approx(3, abs=1e-14)
    assert all(abs(float(motion.subs(t, Rational(i, 20)))) <= 3 for i in range(int(20 * time)))
