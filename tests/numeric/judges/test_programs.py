"""The judge of programs: a right one is right however it is patched, each wrong number of it is seen."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from sympy import Float, Integer, Rational, log, sin, symbols

from solver.numeric.judges import analog as judges
from solver.numeric.judges.analog.netlists import netlist_of
from solver.numeric.judges.analog.posed import Posed
from solver.numeric.judges.analog.programs import Run, half_unit
from solver.numeric.judges.modelling.equations import Question
from solver.patches import Element, Program
from tests.helpers.programs import ONE, TEN, scaled_oscillator, spoiled

x, x_dot, x_ddot, u = symbols("x x_dot x_ddot u", real=True)
JETS = {x: ("x", 0), x_dot: ("x", 1), x_ddot: ("x", 2), u: ("u", 0)}
OSCILLATOR = judges.Asked(
    Question([x_ddot + 8 * x_dot + 25 * x - 500], [x], JETS, ["x"], [], []),
    {("x", 0): Integer(40), ("x", 1): Integer(150)}, {}, {"x": x, "x_dot": x_dot}, ["x"], ONE, TEN,
    {"x": Integer(50), "x_dot": Integer(250)},
)  # fmt: skip
GROWTH = judges.Asked(
    Question([x_dot - x], [x], JETS, ["x"], [], []), {("x", 0): ONE}, {}, {"x": x}, ["x"], ONE, TEN, {"x": TEN}
)
NEAR = 1e-6


def wrong(asked, program):
    """How far a program is from what is asked, rounding allowed for."""
    fitted = judges.within_digits(asked, program)
    gaps = [gap for _, gap in judges.readout_gaps(asked, fitted)]
    return max([*gaps, judges.freed_gap(asked, fitted) or 0.0])


def test_the_program_of_the_course_is_right():
    assert wrong(OSCILLATOR, scaled_oscillator()) < 1e-12
    assert judges.overload_of(OSCILLATOR, scaled_oscillator()) is None
    assert judges.expected_overload(OSCILLATOR) is None


@pytest.mark.parametrize(("what", "program"), list(spoiled(scaled_oscillator())))
def test_each_wrong_number_is_seen(what, program):
    assert wrong(OSCILLATOR, program) > NEAR, what


def test_both_motions_are_scipys():
    run = Run(Posed(OSCILLATOR), netlist_of(scaled_oscillator()))
    times = run.posed.grid.times
    rates = lambda _, z: [z[1], 500 - 8 * z[1] - 25 * z[0]]  # noqa: E731
    wanted = solve_ivp(rates, (0, times[-1]), [40, 150], t_eval=times, rtol=1e-10, atol=1e-9).y[0]
    assert np.allclose(run.wanted("x"), wanted, atol=1e-5)
    assert np.allclose(run.read("x"), wanted, atol=1e-5)


def test_an_oscillator_of_other_signs_is_right_too():
    program = scaled_oscillator()
    turned = {"A1": -8, "A2": 6}
    elements = tuple(
        replace(each, initial=Integer(turned[each.id])) if each.id in turned
        else replace(each, value=-each.value) if each.kind == "source" else each
        for each in program.elements
    )  # fmt: skip
    readout = {name: (of, -factor) for name, (of, factor) in program.readout.items()}
    assert wrong(OSCILLATOR, replace(program, elements=elements, readout=readout)) < 1e-12


def test_time_scaling_slows_the_integrators_and_not_their_start():
    asked = replace(OSCILLATOR, time_scale=TEN)
    program = scaled_oscillator()
    slow = tuple(
        replace(each, inputs=tuple((name, ONE) for name, _ in each.inputs)) if each.kind == "integrator" else each
        for each in program.elements
    )
    right = replace(program, elements=slow)
    assert wrong(asked, right) < 1e-12
    started = tuple(replace(each, initial=each.initial / 10) if each.kind == "integrator" else each for each in slow)
    assert wrong(asked, replace(right, elements=started)) > 0.1


def test_settings_are_judged_within_their_digits():
    def with_setting(setting):
        third = Question([x_dot + Rational(2, 3) * x], [x], JETS, ["x"], [], [])
        asked = replace(GROWTH, question=third)
        elements = (
            Element("P1", "pot", (("A1", ONE),), setting=setting),
            Element("A1", "integrator", (("P1", ONE),), initial=ONE),
        )
        return wrong(asked, Program(TEN, elements, {"x": ("A1", ONE)}))

    assert with_setting(Rational(2, 3)) < 1e-12
    assert with_setting(Rational("0.667")) < NEAR
    assert with_setting(Rational("0.6667")) < NEAR
    assert with_setting(Rational("0.668")) > 1e-4
    assert with_setting(Rational("0.6665")) > 1e-5
    assert with_setting(Rational("0.7")) > 1e-2


def test_a_decimal_of_few_digits_is_exact():
    values = ["0.5", "0.667", "-8", "6.67", "2/3", "0.6667"]
    found = [half_unit(Rational(each)) for each in values]
    assert found == [None, Rational(1, 2000), None, Rational(1, 200), None, Rational(1, 20000)]


def test_overload_is_seen_when_the_equations_reach_the_maximum():
    elements = (Element("A1", "integrator", (("A2", ONE),), initial=ONE), Element("A2", "inverter", (("A1", ONE),)))
    program = Program(TEN, elements, {"x": ("A1", ONE)})
    assert wrong(GROWTH, program) < 1e-12
    _, time = judges.overload_of(GROWTH, program)
    assert time == pytest.approx(np.log(10), rel=1e-3)
    assert judges.expected_overload(GROWTH) == pytest.approx(np.log(10), rel=1e-3)
    assert judges.overload_residual(GROWTH, log(10)) < 1e-12
    assert judges.overload_residual(GROWTH, Float("2.2")) > 0.05
    assert judges.overload_residual(GROWTH, Float("2.4")) > 0.05


def test_an_input_may_be_made_by_integrators_or_be_any():
    tau, t = symbols("tau t")
    driven = Question([x_dot + x - u], [x], JETS, ["x"], ["u"], [])
    asked = judges.Asked(driven, {}, {"u": sin(2 * t)}, {"x": x}, ["x"], ONE, TEN, {})
    by_source = Program(
        TEN,
        (
            Element("U1", "source", value=10 * sin(2 * tau)),
            Element("P1", "pot", (("U1", ONE),), setting=Rational(1, 10)),
            Element("A1", "integrator", (("P1", ONE), ("A1", ONE)), initial=Integer(0)),
        ),
        {"x": ("A1", Integer(-1))},
    )
    by_integrators = Program(
        TEN,
        (
            Element("A1", "integrator", (("A2", ONE), ("A1", ONE)), initial=Integer(0)),
            Element("A2", "integrator", (("A3", ONE), ("A3", ONE)), initial=Integer(0)),
            Element("A3", "integrator", (("A4", ONE), ("A4", ONE)), initial=Integer(-1)),
            Element("A4", "inverter", (("A2", ONE),)),
        ),
        {"x": ("A1", Integer(-1))},
    )
    assert wrong(asked, by_source) < 1e-9
    assert wrong(asked, by_integrators) < NEAR
    by_name = replace(by_source, elements=(Element("U1", "source", value=u), by_source.elements[2]))
    fed = replace(by_name.elements[1], inputs=(("U1", ONE), ("A1", ONE)))
    any_input = replace(asked, inputs={"u": None})
    assert wrong(any_input, replace(by_name, elements=(by_name.elements[0], fed))) < 1e-12
    assert wrong(any_input, by_source) > 0.1


def test_a_missing_variable_is_infinitely_far():
    program = scaled_oscillator()
    assert wrong(OSCILLATOR, replace(program, readout={"x_dot": program.readout["x_dot"]})) == np.inf
    assert wrong(OSCILLATOR, replace(program, readout={**program.readout, "v": ("A1", ONE)})) == np.inf
