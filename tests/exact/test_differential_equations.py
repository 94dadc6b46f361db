"""Differential equations: what the kernels find solves them, as sympy's own differentiation and dsolve say."""

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.variations.constant_coefficients import fundamental_system, trials
from solver.exact.variations.euler_cauchy import euler_cauchy, powers_of_time, trials_in_powers
from solver.exact.variations.integrating_factors import integrating_factor
from solver.exact.variations.linear_forms import LinearForm, factors_that_vanish, highest_jet, linear_form
from solver.exact.variations.separated import rate_of, separated, with_square
from solver.exact.variations.table_of_integrals import integrated, table_integral

t = sp.Symbol("t")
x, x1, x2, x3, x4 = JETS = [sp.Symbol(name, real=True) for name in ("x", "x_dot", "x_ddot", "x_dddot", "x_d4")]
a, w = sp.Symbol("a", positive=True), sp.Symbol("w", positive=True)
C1, C2 = sp.Symbol("C1", real=True), sp.Symbol("C2", real=True)
AT = {t: sp.Rational(7, 5), a: sp.Rational(3, 7), w: sp.Rational(5, 3), C1: sp.Rational(4, 5), C2: sp.Rational(9, 4)}


def vanishes(value, at=AT):
    return abs(sp.N(value.subs(at), 30)) < 1e-20


def put_in(form, function):
    return form.of([sp.diff(function, t, i) for i in range(form.order + 1)])


EQUATIONS = [
    -2 * x - 2 * x2,
    x2 - x - t * sp.exp(t) - 3,
    x2 + w**2 * x - sp.cos(a * t),
    x2 + w**2 * x - sp.cos(w * t),
    x2 + 2 * x1 + 2 * x - t**2 * sp.exp(-t) * sp.sin(t) - 1,
    x4 + 2 * x2 + x - t * sp.cos(t),
    x3 - x1 - t,
    x2 - 2 * a * x1 + a**2 * x - sp.exp(a * t),
    x4 + x - sp.sin(2 * t) * sp.exp(t),
    x2 - x - sp.cosh(2 * t),
]


@pytest.mark.parametrize("equation", EQUATIONS, ids=str)
def test_fundamental_systems_and_trial_functions_solve_the_equation(equation):
    form = linear_form(equation, JETS)
    found = fundamental_system(form.coefficients, t)
    assert len(found.functions) == form.order
    assert all(vanishes(put_in(form, f)) for f in found.functions)
    parts = trials(form, t)
    assert all(vanishes(put_in(form, each.solution) - each.right) for each in parts)
    assert vanishes(sp.Add(*(each.right for each in parts)) - form.right)
    for each in parts:
        for order in range(1, form.order + 1):
            assert vanishes(each.derivative(order, t) - sp.diff(each.function, t, order), AT | letters(each))


def letters(trial):
    return {letter: sp.Rational(i + 2, 7) for i, letter in enumerate(trial.letters)}


@settings(max_examples=25, deadline=None)
@given(
    real=st.lists(st.integers(-3, 3), max_size=3),
    pairs=st.lists(st.tuples(st.integers(-2, 2), st.integers(1, 3)), max_size=1),
    power=st.integers(0, 2),
    exponent=st.integers(-2, 2),
    angle=st.integers(0, 3),
)
def test_any_equation_with_constant_coefficients_is_solved(real, pairs, power, exponent, angle):
    """Repeated roots and resonance come about by chance."""
    z = sp.Dummy("z")
    p = sp.Mul(*(z - root for root in real), *((z - s) ** 2 + v**2 for s, v in pairs))
    n = len(real) + 2 * len(pairs)
    if n == 0:
        return
    coefficients = tuple(reversed(sp.Poly(p, z).all_coeffs()))
    right = t**power * sp.exp(exponent * t) * sp.cos(angle * t)
    form = LinearForm(coefficients, right)
    functions = fundamental_system(coefficients, t).functions
    wronskian = sp.Matrix(n, n, lambda i, j: sp.diff(functions[j], t, i).subs(t, 0))
    assert wronskian.det() != 0
    (trial,) = trials(form, t)
    assert vanishes(put_in(form, trial.solution) - right)


def test_the_general_solution_is_that_of_dsolve():
    f = sp.Function("f")
    form = linear_form(x2 + 3 * x1 + 2 * x - sp.exp(-t), JETS)
    theirs = sp.dsolve(f(t).diff(t, 2) + 3 * f(t).diff(t) + 2 * f(t) - sp.exp(-t), f(t)).rhs
    ours = trials(form, t)[0].solution
    difference = sp.expand(theirs - ours)
    theirs_at = {symbol: sp.Rational(2, 3) for symbol in theirs.free_symbols - {t}}
    assert vanishes(put_in(form, difference), AT | theirs_at)
    assert {sp.exp(-t), sp.exp(-2 * t)} == set(fundamental_system(form.coefficients, t).functions)


def test_what_has_no_usable_roots_or_trial_function_is_refused():
    with pytest.raises(NotExact):
        fundamental_system((-a, sp.Integer(0), sp.Integer(0), sp.Integer(1)), t)
    with pytest.raises(NotExact):
        trials(linear_form(x2 + x - 1 / t, JETS), t)


def test_factors_without_zeros_are_left_out():
    assert factors_that_vanish(x2 / (1 + x1**2) ** sp.Rational(3, 2), JETS) == (x2,)
    assert linear_form(x * x2 + x1, JETS) is None
    assert highest_jet(x3 + x, JETS) == 3


@pytest.mark.parametrize(
    "equation",
    [
        t**2 * x2 + t * x1 - x,
        t**2 * x2 - 2 * x - t**2 - sp.log(t) / t,
        (t + 1) ** 2 * x2 + 2 * (t + 1) * x1 + x / 4,
        t**2 * x2 + t * x1 + x - t,
        t**2 * x2 - 3 * t * x1 + 4 * x - t**2 * sp.log(t),
        t**3 * x3 + t * x1 - x,
        t**2 * x2 + t * x1 - a**2 * x,
    ],
    ids=str,
)
def test_euler_cauchy_equations(equation):
    form = linear_form(equation, JETS)
    found = euler_cauchy(form, t)
    functions = powers_of_time(found).functions
    assert len(functions) == form.order
    assert all(vanishes(put_in(form, f)) for f in functions)
    parts = trials_in_powers(found, t)
    assert vanishes(sp.Add(*(put_in(form, each.solution) for each in parts)) - form.right)


def test_other_coefficients_are_no_euler_cauchy_equation():
    assert euler_cauchy(linear_form(x2 + t * x, JETS), t) is None
    assert euler_cauchy(linear_form(x2 + x, JETS), t) is None


@pytest.mark.parametrize("equation", [x1 + 2 * t * x - t, x1 - x / t - t**2, x1 + x / (1 + t) - 1], ids=str)
def test_integrating_factors(equation):
    form = linear_form(equation, JETS)
    found = integrating_factor(form, t)
    assert vanishes(put_in(form, (found.integral + C1) / found.factor) - form.right)


@pytest.mark.parametrize(
    ("equation", "branches"),
    [
        (x / sp.sqrt(1 + x1**2) - C1, 1),
        (1 / (x * sp.sqrt(1 + x1**2)) - C1, 2),
        (t * x1 / sp.sqrt(1 + x1**2) - C1, 1),
        ((1 + x**2) / x1**2 - C1, 1),
        (x * x1 - C1, 2),
        (sp.sqrt(x) / sp.sqrt(1 + x1**2) - C1, 1),
        (x1 / (t * sp.sqrt(1 + x1**2)) - C1, 1),
        (x**2 * x1**2 + C1, 2),
        (x1 * sp.sqrt(x) - C1, 1),
    ],
    ids=str,
)
def test_separated_variables(equation, branches):
    rate = rate_of(equation, x1)
    rate, _ = with_square(rate, [C1]) or (rate, None)
    found = separated(rate, x, t, C2)
    assert len(found.functions) == branches
    for function in found.functions:
        assert vanishes(sp.diff(function, t) ** rate.power - rate.value.subs(x, function))


def test_a_cycloid_has_no_formula_in_time():
    rate = rate_of(1 / sp.sqrt(x * (1 + x1**2)) - C1, x1)
    assert separated(rate, x, t, C2) is None


@pytest.mark.parametrize(
    "f",
    [1 / t, 1 / (1 + t**2), 1 / (t**2 - 1), t / (t**2 + 4), 1 / sp.sqrt(9 - t**2), 1 / sp.sqrt(t**2 + a**2),
     t / sp.sqrt(4 - t**2), sp.sqrt(2 * t + 1), 1 / (3 * t + 1) ** 2, 1 / sp.cos(t) ** 2, sp.log(t),
     1 / (t * (t + 1) ** 2), t**3 / (1 + t), t * sp.exp(t**2), t * sp.exp(-t) + 1 / t, (t + 3) / (t**2 + 2 * t + 5)],
    ids=str,
)  # fmt: skip
def test_the_table_of_integrals(f):
    assert vanishes(sp.diff(table_integral(f, t), t) - f)


def test_what_the_table_does_not_have_is_told():
    assert table_integral(sp.exp(t**2), t) is None
    assert integrated(1 / (1 + t**4), t, 1) is None
    assert integrated(sp.S.Zero, t, 2) == (0, 0)
