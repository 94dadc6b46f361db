"""What is said of a response beside y(t): second-order names, where the slope is zero, steady states, intervals."""

import control
import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.signal import freqresp, lti

import solver
from solver.derivation import CheckStatus, Claim, Status
from solver.exact import by_intervals
from solver.numeric import check_claim
from tests.helpers.asking import ask, system
from tests.helpers.fractions_of_polynomials import plant, s, z
from tests.helpers.tried import tried

t, k = sp.symbols("t k")


def respond(G, u, **options):
    result = ask("response", G, kind="zero_state", input=(sp.sympify(u),), **options)
    assert result.status is Status.VERIFIED, result.reason
    return result


def step_of(result, kind):
    return next((step for step in result.steps if step.kind == kind), None)


PAIRS = st.tuples(st.integers(1, 4), st.integers(1, 5), st.integers(1, 3))


@tried(8)
@given(PAIRS, st.sampled_from([1, 2, -3]))
def test_the_names_of_a_step_response_are_those_that_control_measures(made, height):
    sigma, omega, gain = made
    bottom = s**2 + 2 * sigma * s + sigma**2 + omega**2
    form = step_of(respond(plant(gain, bottom), height), "second_order").values["form"]
    frequencies, ratios, _ = control.damp(control.tf([gain], [1, 2 * sigma, sigma**2 + omega**2]), doprint=False)
    assert np.isclose(float(form.omega_n), frequencies[0])
    assert np.isclose(float(form.zeta), ratios[0])
    assert form.damping == "underdamped"
    times = np.linspace(0, max(8 / sigma, 2 * np.pi / omega), 40001)
    info = control.step_info(control.tf([gain], [1, 2 * sigma, sigma**2 + omega**2]), T=times)
    assert np.isclose(float(form.peak_time), info["PeakTime"], atol=1e-3)
    assert np.isclose(100 * float(form.overshoot), info["Overshoot"], atol=1e-3)


@pytest.mark.parametrize(
    ("bottom", "damping"),
    [
        (s**2 + 6 * s + 25, "underdamped"),
        (s**2 + 6 * s + 9, "critically damped"),
        (s**2 + 6 * s + 8, "overdamped"),
        (s**2 + 4, "undamped"),
        (2 * s**2 + sp.Rational(1, 2) * s + 3, "underdamped"),
    ],
)
def test_the_damping_is_named(bottom, damping):
    assert step_of(respond(plant(4, bottom), 1), "second_order").values["form"].damping == damping


def test_a_state_equation_with_such_an_output_is_named_too():
    pair = system([[0, 1], [-25, -6]], B=[0, 1], C=[[50, 0]])
    form = step_of(respond(pair, 1), "second_order").values["form"]
    assert (form.gain, form.omega_n, form.zeta) == (2, 5, sp.Rational(3, 5))


def test_with_parameters_the_damping_stays_open():
    m, d, c = sp.symbols("m d c", positive=True)
    form = step_of(respond(plant(1, m * s**2 + d * s + c), 1), "second_order").values["form"]
    assert form.damping == ""
    at = {m: 2, d: 1, c: 8}
    assert (form.omega_n.subs(at), form.zeta.subs(at)) == (2, sp.Rational(1, 8))


SYMBOLS = """title: t
assume: {omega_0: positive}
conditions: ["0 < zeta < 1"]
system: {transfer_function: "omega_0^2/(s^2 + 2 zeta omega_0 s + omega_0^2)"}
find: {a: {task: response, kind: zero_state, input: step(t)}}
"""


def test_with_symbols_the_quantities_have_the_form_of_their_formulas():
    page = solver.solve(SYMBOLS).markdown(detail="full")
    assert r"\sqrt{1 - \zeta^{2}} = \omega_0\sqrt{1 - \zeta^{2}}" in page.replace(r"\xi", r"\zeta")
    assert r"= \frac{\pi}{\omega_0\sqrt{1 - \zeta^{2}}}" in page
    assert r"= e^{-\pi\zeta/(\sqrt{1 - \zeta^{2}})}" in page


def test_the_overshoot_is_told_as_a_number_too():
    page = solver.solve(FILE.format(G="25/(s^2 + 6s + 25)", u="step(t)")).markdown(detail="key")
    assert r"e^{-3\pi/4} \approx 0.09478" in page  # Ogata, example 5-1: 9.5 % for a damping ratio of 0.6


@pytest.mark.parametrize(
    ("G", "u"),
    [
        (plant(s + 1, s**2 + 2 * s + 5), 1),
        (plant(1, (s + 1) * (s**2 + 2 * s + 5)), 1),
        (plant(1, s**2 - 2 * s + 5), 1),
        (plant(1, s**2 + 2 * s + 5), t),
        (plant(s**2, s**2 + 2 * s + 5), 1),
    ],
)
def test_other_responses_have_no_such_names(G, u):
    assert step_of(respond(G, u), "second_order") is None


ZEROS_OF_SLOPES = [
    (plant(25, s**2 + 6 * s + 25), 1, "pair"),
    (plant(s, s**2 + 6 * s + 25), 1, "pair"),
    (plant(s + 7, s**2 + 2 * s + 5), 1, "pair"),
    (plant(1, (s + 1) * (s + 3)), sp.DiracDelta(t), "modes"),
    (plant(s + 9, (s + 1) * (s + 3)), 1, "modes"),
    (plant(1, (s + 2) ** 2), sp.DiracDelta(t), "repeated"),
    (plant(2, s + 1), t * sp.exp(-t), "repeated"),
    (plant(1, s**2 + 4), 1, "pair"),
    (plant(8, (s + 2) * (s + 4)), sp.exp(-t), "searched"),
]


@pytest.mark.parametrize(("G", "u", "kind"), ZEROS_OF_SLOPES)
def test_the_slope_is_zero_at_the_peak_and_no_sample_is_larger(G, u, kind):
    result = respond(G, u)
    y, at, step = result.answers["y"], result.answers.get("t_peak"), step_of(result, "peak")
    if at is None:
        assert step is None
        return
    assert step.values["flat"].kind == kind
    slope = sp.lambdify(t, step.values["flat"].slope, "numpy")
    times = np.linspace(1e-3, 12, 4001)
    values = sp.lambdify(t, y, "numpy")(times)
    assert np.allclose(np.gradient(values, times)[1:-1], slope(times)[1:-1], atol=1e-3)
    assert abs(slope(float(at))) < 1e-9
    assert np.max(np.abs(values)) <= abs(float(result.answers["y_peak"])) + 1e-9
    if (equation := step.values["flat"].equation) is not None:
        left, right = equation
        assert abs(float(left.subs(t, at)) - float(right)) < 1e-9


@tried(10)
@given(
    st.lists(st.integers(1, 4), min_size=1, max_size=2),
    st.integers(1, 5),
    st.sampled_from([(1, 0), (0, 2), (3, -4), (-1, 1)]),
)
def test_amplitude_and_phase_are_those_of_scipys_frequency_response(poles, omega, parts):
    bottom = sp.expand(sp.prod([s + p for p in poles]))
    a, b = parts
    result = respond(
        plant(s + 6, bottom) if len(poles) > 1 else plant(6, bottom), a * sp.cos(omega * t) + b * sp.sin(omega * t)
    )
    steady = step_of(result, "steady_state").values["steady"]
    top = [1, 6] if len(poles) > 1 else [6]
    _, (theirs,) = freqresp(lti(top, [float(c) for c in sp.Poly(bottom, s).all_coeffs()]), [omega])
    assert np.isclose(float(steady.magnitude), abs(theirs))
    assert np.isclose(np.exp(1j * float(steady.argument)), theirs / abs(theirs))
    late = 40.0
    assert np.isclose(float(result.answers["y"].subs(t, late)), float(steady.output.subs(t, late)), atol=1e-9)
    assert steady.settles


@pytest.mark.parametrize(
    ("G", "u", "settles"),
    [
        (plant(1, s - 1), sp.cos(t), False),
        (plant(1, s), sp.sin(t), False),
        (plant(1, s**2 + 4), sp.cos(t), False),
        (plant(1, z - sp.Rational(1, 2), discrete=True), sp.cos(sp.pi * k / 2), True),
        (plant(1, z - 2, discrete=True), sp.cos(sp.pi * k / 3), False),
    ],
)
def test_whether_the_transient_dies_out_is_said(G, u, settles):
    assert step_of(respond(G, u), "steady_state").values["steady"].settles is settles


@pytest.mark.parametrize("u", [sp.cos(2 * t), 1 + sp.cos(t), sp.exp(-t) * sp.cos(t), sp.cos(t) + sp.cos(3 * t)])
def test_a_resonance_and_other_inputs_have_no_steady_state(u):
    assert step_of(respond(plant(1, s**2 + 4) if u == sp.cos(2 * t) else plant(1, s + 1), u), "steady_state") is None


def test_a_wrong_steady_state_is_rejected():
    claims = step_of(respond(plant(50, s**2 + 6 * s + 25), 2 * sp.cos(4 * t)), "steady_state").claims
    for name in ("value", "magnitude", "argument", "forced", "transient"):
        assert check_claim(claims[name], name).status is CheckStatus.PASSED
        spoilt = Claim(claims[name].left, claims[name].right + sp.Rational(1, 1000))
        assert check_claim(spoilt, name).status is CheckStatus.FAILED


def shape(*jumps):
    return sum(c * sp.Heaviside(t - at, evaluate=False) for c, at in jumps)


@pytest.mark.parametrize(
    "u", [shape((1, 0), (-1, 2)), shape((2, 1), (1, 3), (-3, sp.Rational(7, 2))), t * shape((1, 0), (-1, 1))]
)
def test_the_intervals_have_the_values_of_the_whole(u):
    result = respond(plant(s + 3, (s + 1) * (s + 2)), u)
    cases = step_of(result, "intervals").claims["y"].right
    assert not cases.has(sp.Heaviside)
    for time in (0.3, 1.2, 2.5, 3.2, 6.0):
        whole, piece = (complex(each.subs(t, sp.Float(time, 30)).evalf(20)) for each in (result.answers["y"], cases))
        assert abs(whole - piece) < 1e-12


def test_intervals_need_an_order():
    a, b = sp.symbols("a b", positive=True)
    y = shape((1, a), (1, b))
    assert by_intervals(y, [a, b], t, discrete=False) is None
    assert by_intervals(shape((1, a), (1, 2 * a)), [2 * a, a], t, discrete=False).args[1].expr == 1
    assert by_intervals(sp.exp(-t), [sp.S.Zero], t, discrete=False) is None


FILE = (
    "title: t\nsystem: {{transfer_function: '{G}'}}\nfind: {{a: {{task: response, kind: zero_state, input: '{u}'}}}}\n"
)


@pytest.mark.parametrize(
    ("G", "u", "says"),
    [
        ("25/(s^2 + 6s + 25)", "1", "the system is underdamped"),
        ("25/(s^2 + 6s + 25)", "1", r"M_p = e^{-\pi\xi/\sqrt{1 - \xi^{2}}} = e^{-3\pi/4}"),
        ("25/(s^2 + 6s + 25)", "1", r"\sin(4t) = 0"),
        ("9/(s^2 + 6s + 9)", "1", "critically damped"),
        ("8/(s^2 + 6s + 8)", "1", "overdamped"),
        ("1/(s + 1)", "cos(t)", r"y_{\text{ss}}(t) = \frac{\sqrt{2}}{2}\cos\left(t - \frac{\pi}{4}\right)"),
        ("1/(s - 1)", "cos(t)", "does not die out"),
        ("1/(s + 1)", "step(t) - step(t - 2)", r"0 \le t < 2"),
        ("1/(s + 1)", "step(t) - step(t - 2)", r"y_{2}(t) = -y_{1}(t - 2)\,\mathbf{1}(t - 2)"),
    ],
)
def test_what_the_page_says(G, u, says):
    page = solver.solve(FILE.format(G=G, u=u))
    assert page.status == "verified", page.parts[0].reason
    assert says in page.markdown()
