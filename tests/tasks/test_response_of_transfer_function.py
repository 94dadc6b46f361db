"""Responses asked of transfer functions: Y = G U and back, without states, against scipy and python-control."""

import control
import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.signal import dlti, dstep, lti, step

import solver
from solver.derivation import Status
from tests.helpers.asking import ask, rejected
from tests.helpers.fractions_of_polynomials import plant, s, z
from tests.helpers.tried import tried

t, k = sp.symbols("t k")
METHODS = ("laplace", "convolution")


def respond(G, u, method="", **options):
    inputs = tuple(map(sp.sympify, u if isinstance(u, list) else [u]))
    return ask("response", G, method, kind="zero_state", input=inputs, **options)


def matrix(rows, *, discrete=False):
    return plant(*([sp.fraction(sp.together(entry)) for entry in row] for row in rows), discrete=discrete)


@pytest.mark.parametrize("method", METHODS)
def test_no_states_are_invented(method):
    result = respond(plant(942, s**2 + 12 * s + 962), 1, method)
    assert result.status is Status.VERIFIED, result.reason
    assert "x" not in result.answers
    kinds = [step.kind for step in result.steps]
    assert not {"realized", "adjugate", "transition", "output"} & set(kinds)
    first = "transformed_output" if method == "laplace" else "convolution_formula"
    assert kinds[0] == first


def test_an_initial_state_is_that_of_the_realization():
    result = ask(
        "response", plant(1, s + 1), kind="complete", input=(sp.Integer(1),), initial_state=sp.ImmutableMatrix([3])
    )
    assert result.status is Status.VERIFIED, result.reason
    assert sp.expand(result.answers["x"][0] - 1 - 2 * sp.exp(-t)) == 0
    assert result.steps[0].kind == "realized"


TOPS = st.lists(st.integers(-3, 3), min_size=1, max_size=3)
POLES = st.lists(st.integers(1, 5), min_size=1, max_size=3)
PAIRS = st.tuples(st.integers(1, 3), st.integers(1, 4))


@tried(12)
@given(POLES, st.lists(PAIRS, max_size=1), TOPS, st.sampled_from(METHODS))
def test_step_responses_are_scipys(poles, pairs, top, method):
    bottom = np.poly([*(-p for p in poles), *(complex(-a, b) for a, b in pairs), *(complex(-a, -b) for a, b in pairs)])
    bottom = [round(c.real) for c in np.atleast_1d(bottom)]
    top = top[: len(bottom)]
    if not any(top):
        return
    G = plant(sp.Poly(top, s).as_expr(), sp.Poly(bottom, s).as_expr())
    result = respond(G, 1, method)
    assert result.status is Status.VERIFIED, result.reason
    times = np.linspace(0, 3, 31)
    _, y = step(lti(top, bottom), T=times)
    found = [complex(result.answers["y"].subs(t, sp.Float(time, 30)).evalf(25)).real for time in times[1:]]
    assert np.allclose(found, y[1:], atol=1e-8)


@tried(8)
@given(
    st.lists(st.sampled_from([sp.Rational(1, 2), sp.Rational(-1, 3), 0, 1]), min_size=1, max_size=3),
    st.lists(st.integers(-2, 2), min_size=1, max_size=2),
    st.sampled_from(["z_transform", "convolution"]),
)
def test_step_responses_in_discrete_time_are_scipys(poles, top, method):
    bottom = sp.prod([z - p for p in poles])
    if not any(top) or len(top) > len(poles) + 1:
        return
    G = matrix([[sp.Poly(top, z).as_expr() / bottom]], discrete=True)
    result = respond(G, 1, method)
    assert result.status is Status.VERIFIED, result.reason
    coefficients = [float(c) for c in sp.Poly(bottom, z).all_coeffs()]
    _, (y,) = dstep(dlti([float(c) for c in top], coefficients), n=9)
    found = [float(result.answers["y"].subs(k, i).doit()) for i in range(9)]
    assert np.allclose(found, y[:, 0])


@pytest.mark.parametrize("method", METHODS)
def test_several_inputs_and_outputs_are_those_of_control(method):
    rows = [[1 / (s + 1), 1 / s], [2 / (s + 3), s / (s + 2)]]
    result = respond(matrix(rows), [1, t], method)
    assert result.status is Status.VERIFIED, result.reason
    tops, bottoms = [[[1], [1]], [[2], [1, 0]]], [[[1, 1], [1, 0]], [[1, 3], [1, 2]]]
    times = np.linspace(0, 2, 201)
    inputs = (np.ones(201), times)
    entries = [[control.tf(*each) for each in zip(*row, strict=True)] for row in zip(tops, bottoms, strict=True)]
    parts = [
        [control.forced_response(G, times, u).outputs[-1] for G, u in zip(row, inputs, strict=True)] for row in entries
    ]
    found = np.array(result.answers["y"].subs(t, 2).evalf(), dtype=float)[:, 0]
    assert np.allclose(found, np.sum(parts, axis=1), atol=1e-6)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("u", [sp.DiracDelta(t), sp.Heaviside(t) - sp.Heaviside(t - 2), sp.exp(-t), sp.Integer(0)])
def test_numerators_of_the_degree_of_the_denominator(method, u):
    result = respond(plant(s + 3, s + 1), u, method)
    assert result.status is Status.VERIFIED, result.reason
    smooth = {
        sp.DiracDelta(t): 2 * np.exp(-1.0),
        sp.exp(-t): np.exp(-1.0) * (1 + 2),
        sp.Integer(0): 0.0,
    }.get(u, 3 - 2 * np.exp(-1.0))
    assert abs(float(result.answers["y"].subs(t, 1)) - smooth) < 1e-12


@pytest.mark.parametrize("G", [plant(3, sp.Integer(1)), matrix([[2, 0], [1, 3]])])
def test_constants_have_no_states_and_need_none(G):
    result = respond(G, [t] * G.matrix.cols)
    assert result.status is Status.VERIFIED, result.reason
    gains = G.matrix * sp.ones(G.matrix.cols, 1)
    assert sp.ImmutableMatrix([result.answers["y"]] if len(gains) == 1 else result.answers["y"]) == gains * t


@pytest.mark.parametrize("spoilt", [lambda y: -y, lambda y: y + sp.Rational(1, 1000), lambda y: y.subs(t, 2 * t)])
def test_corrupted_outputs_are_rejected(spoilt):
    G, asked = plant(2, s**2 + 2 * s + 5), {"kind": "zero_state", "input": (sp.Integer(1),)}
    y = respond(G, 1).answers["y"]
    assert not rejected("response", G, {"y": y}, **asked)
    assert rejected("response", G, {"y": spoilt(y)}, **asked)


def test_poles_that_cancel_are_told_and_not_answered_with():
    result = respond(plant((s - 1) * (s + 2), (s - 1) * (s + 1) * (s + 3)), 1)
    assert result.status is Status.VERIFIED, result.reason
    assert not result.answers["y"].has(sp.exp(t))
    expanded = next(step for step in result.steps if step.kind == "partial_fractions")
    assert [factor.roots[0].value for factor in expanded.values["cancelled"]] == [1]


FILE = "title: t\nsystem: {system}\nfind: {{a: {{task: response, kind: zero_state, input: {u}{more}}}}}\n"


@pytest.mark.parametrize(
    ("system", "u", "more", "says"),
    [
        ("{transfer_function: '(s + 3)/(s + 1)^2'}", "1", "", r"Y(s) = G(s)\,U(s)"),
        ("{transfer_function: 'exp(-T s)/(s + 1)'}", "1", "", r"Y(s) = G_{0}(s)\,U(s)"),
        ("{transfer_function: '1/s^2'}", "1", ", method: convolution", r"\int_{0}^{t}g(t-\tau)\,u(\tau)\,d\tau"),
        ("{transfer_function: '(s + 3)/(s + 1)'}", "t", ", method: convolution", r"G(s) = 1 + \frac{2}{s + 1}"),
        ("{time: discrete, transfer_function: '1/(z - 0.5)'}", "1", "", r"\frac{Y(z)}{z} = G(z)\,\frac{U(z)}{z}"),
        ("{time: discrete, transfer_function: '1/(z - 0.5)'}", "1", ", method: convolution", r"\sum_{i=0}^{k}g(k-i)"),
    ],
)
def test_what_the_page_says(system, u, more, says):
    page = solver.solve(FILE.format(system=system, u=u, more=more))
    text = page.markdown()
    assert page.status == "verified", page.parts[0].reason
    assert says in text
    assert "realization" not in text
