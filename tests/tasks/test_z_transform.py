"""z-transforms of sequences and sampled functions: steps, answers against series, corruptions, refusals, marking."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.signal import cont2discrete

from solver.derivation import Answers, CheckStatus, Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.marked import verdict

Z, K, S = sp.symbols("z k s")
T = sp.Symbol("T", positive=True)


def text(f="", more="", **options):
    given_ = [f'f: "{f}"'] if f else []
    given_ += [f'{name}: "{value}"' for name, value in options.items()]
    return f"find:\n  a: {{task: z_transform, {', '.join(given_)}{more}}}\n"


def asked(f="", more="", **options):
    return solve_problem(read_problem(Source("file.yaml", text(f, more, **options)), catalogue())).parts[0]


def image(f="", more="", **options):
    result = asked(f, more, **options)
    assert result.status is Status.VERIFIED, result.reason
    assert not [check for check in result.checks if check.status is CheckStatus.SKIPPED]
    return result.answers["F"]


def rejected(wrong, f="", **options):
    task = catalogue()["z_transform"]
    part = read_problem(Source("file.yaml", text(f, **options)), catalogue()).parts[0]
    checks = list(task.verify(task.given(part.system, part.options), Answers(F=wrong)))
    return any(check.status is CheckStatus.FAILED for check in checks)


def same(F, G, **values):
    point = {sp.Symbol(name, real=True): value for name, value in values.items()} | {T: 0.3}
    differences = [sp.N((F - G).subs(point).subs(Z, z)) for z in (2.7, 3 + 1j)]
    return max(map(abs, differences)) < 1e-12


a = sp.Symbol("a", real=True)
TEXTBOOK = {
    "1": Z / (Z - 1),
    "k": Z / (Z - 1) ** 2,
    "k^2": Z * (Z + 1) / (Z - 1) ** 3,
    "a^k": Z / (Z - a),
    "k a^k": a * Z / (Z - a) ** 2,
    "cos(pi k/3)": Z * (Z - sp.S.Half) / (Z**2 - Z + 1),
    "(1/2)^k sin(pi k/2)": 2 * Z / (4 * Z**2 + 1),
    "step(k - 4)": Z**-3 / (Z - 1),
    "delta(k) + 3delta(k - 2)": 1 + 3 * Z**-2,
    "step(k) - step(k - 3)": 1 + 1 / Z + Z**-2,
    "a^(k-1) step(k - 1)": 1 / (Z - a),
    "(k + 1) a^k": Z**2 / (Z - a) ** 2,
    "(1 + (-1)^k)/2": Z**2 / (Z**2 - 1),
    "exp(-2k)": Z / (Z - sp.exp(-2)),
    "(-1/2)^k*step(2 - k) + 1": 1 - 1 / (2 * Z) + 1 / (4 * Z**2) + Z / (Z - 1),
}


@pytest.mark.parametrize("f", TEXTBOOK)
def test_pairs_of_the_textbooks(f):
    assert same(image(f), TEXTBOOK[f], a=0.4)


def test_powers_of_k_are_derivatives():
    result = asked("k^4 2^k".replace(" 2", "*2"))
    rules = next(each for each in result.steps if each.kind == "by_rules")
    assert [rule for rule, _, _ in rules.values["lines"]] == ["table", "derivative", "derivative", "damping"]
    series = sum(sp.Float(n**4 * 2**n) * 7.0**-n for n in range(80))
    assert abs(sp.N(result.answers["F"].subs(Z, 7)) - series) < 1e-9


def test_what_begins_later_is_written_in_the_time_since():
    result = asked("k^2 step(k - 2)")
    assert [each.kind for each in result.steps][:2] == ["moved", "table"]
    assert "delay" in result.steps[-1].values["used"]


def test_a_sequence_that_ends_is_written_out():
    result = asked("k (step(k) - step(k - 4))")
    assert result.steps[0].values["values"] == [0, 1, 2, 3, 0]
    assert result.answers["F"] == 1 / Z + 2 / Z**2 + 3 / Z**3


SAMPLED = {
    "1/(s + 1)": Z / (Z - sp.exp(-T)),
    "1/s^2": T * Z / (Z - 1) ** 2,
    "1/(s(s + 1))": Z * (1 - sp.exp(-T)) / ((Z - 1) * (Z - sp.exp(-T))),
    "1/(s + 1)^2": T * Z * sp.exp(-T) / (Z - sp.exp(-T)) ** 2,
    "2/(s^2 + 4)": Z * sp.sin(2 * T) / (Z**2 - 2 * Z * sp.cos(2 * T) + 1),
    "exp(-2 T s)/s": Z**-1 / (Z - 1),
    "exp(-T s/2)/(s + 1)": sp.exp(-T / 2) / (Z - sp.exp(-T)),
}


@pytest.mark.parametrize("F", SAMPLED)
def test_sampled_functions_of_the_textbooks(F):
    more = ", assume: {T: positive}" if "T" in F else ""
    assert same(image(F=F, sample_time="T", more=more), SAMPLED[F])


def test_exponentials_over_parameters_are_sampled():
    found = image(F="1/((s + 2)^2 (s + a))", sample_time="1/10", more=", assume: {a: positive}")
    f = sp.inverse_laplace_transform(1 / ((S + 2) ** 2 * (S + 3)), S, sp.Symbol("t", positive=True))
    series = sum(sp.N(f.subs(sp.Symbol("t", positive=True), sp.Rational(i, 10))) * 2.0**-i for i in range(90))
    assert abs(sp.N(found.subs({sp.Symbol("a", positive=True): 3, Z: 2})) - series) < 1e-9


def test_the_partial_fractions_are_shown():
    kinds = [each.kind for each in asked(F="1/(s(s + 1))", sample_time="T").steps]
    fractions = ["form", "covered_up", "partial_fractions"]
    assert kinds == [*fractions, "pairs", "back", "sampled", "table", "together", "rules"]


@settings(max_examples=5, deadline=None)
@given(
    st.lists(
        st.sampled_from(["s", "(s + 1)", "(s + 2)^2", "(s^2 + 2s + 5)", "(s^2 + 9)"]),
        min_size=1,
        max_size=2,
        unique=True,
    ),
    st.sampled_from(["1/10", "1/2", "1"]),
)
def test_sampled_images_are_impulse_invariant(below, period):
    """scipy's impulse-invariant discretization, which is T times the transform of the samples."""
    F = f"(s + 3)/({' '.join(below)})" if len(below) > 1 or "^" in below[0] else f"3/({below[0]})"
    found = image(F=F, sample_time=period)
    G = read_problem(Source("f", text(F=F, sample_time=period)), catalogue()).parts[0].options["F"]
    above, under = (sp.Poly(side, S) for side in sp.fraction(sp.cancel(G)))
    dt = float(sp.Rational(period))
    samples = cont2discrete(
        ([float(c) for c in above.all_coeffs()], [float(c) for c in under.all_coeffs()]), dt, "impulse"
    )
    z = 2.3 + 0.7j
    wanted = np.polyval(samples[0].flatten(), z) / np.polyval(samples[1], z) / dt
    assert abs(complex(sp.N(found.subs(Z, z))) - wanted) < 1e-8 * (1 + abs(wanted))


@settings(max_examples=6, deadline=None)
@given(
    st.integers(0, 3),
    st.sampled_from(["", "*2^k", "*(-1/3)^k", "*a^k"]),
    st.sampled_from(["", "*cos(pi k/4)", "*sin(k)"]),
    st.sampled_from(["", "*step(k - 2)", "*(step(k - 1) - step(k - 5))"]),
)
def test_generated_sequences_against_their_series(power, growth, wave, begins):
    f = f"k^{power}{growth}{wave}{begins}" if power else f"3{growth}{wave}{begins}"
    found = image(f)
    given_ = read_problem(Source("f", text(f)), catalogue()).parts[0].options["f"].subs(a, sp.Rational(1, 2))

    def value(n):
        steps = given_.replace(sp.Heaviside, lambda x, *_: sp.Integer(int(bool(x.subs(K, n) >= 0))))
        return complex(sp.N(steps.subs(K, n)))

    series = sum(value(n) * 6.0**-n for n in range(90))
    assert abs(complex(sp.N(found.subs(a, sp.Rational(1, 2)).subs(Z, 6))) - series) < 1e-9 * (1 + abs(series))


@pytest.mark.parametrize(
    ("f", "wrong"),
    [
        ("a^k", Z / (Z - 1 / a)),
        ("k", Z / (Z - 1) ** 2 * sp.Rational(1001, 1000)),
        ("step(k - 2)", Z / (Z - 1)),
        ("cos(k)", Z * sp.sin(1) / (Z**2 - 2 * Z * sp.cos(1) + 1)),
        ("2^k", 1 / (Z - 2)),
    ],
)
def test_corrupted_transforms_are_rejected(f, wrong):
    assert rejected(wrong, f)
    assert not rejected(image(f), f)


def test_corrupted_transforms_of_samples_are_rejected():
    assert rejected(Z / (Z - sp.exp(-1)), F="1/(s + 1)", sample_time="1/2")
    assert not rejected(Z / (Z - sp.exp(-sp.S.Half)), F="1/(s + 1)", sample_time="1/2")
    assert rejected(1 / (Z - sp.exp(-sp.S.Half)), F="1/(s + 1)", sample_time="1/2")


@pytest.mark.parametrize(
    ("question", "says"),
    [
        ({"f": "1/k"}, "follows from no rule"),
        ({"f": "j^k"}, "must be real"),
        ({"f": "step(k - 1/2)"}, "whole number of samples"),
        ({"F": "1/(s + 1)"}, "ampl"),
        ({"F": "s/(s + 1)", "sample_time": "1"}, "impulse"),
        ({"F": "exp(-b s)/s", "sample_time": "1", "more": ", assume: {b: positive}"}, "number of periods"),
        ({"f": "k", "F": "1/s", "sample_time": "1"}, "not both"),
        ({"sample_time": "1"}, "Nothing is given"),
    ],
)
def test_other_questions_are_refused_at_their_place(question, says):
    with pytest.raises(InputError) as raised:
        asked(**question)
    assert says in str(raised.value)
    assert "file.yaml:2" in str(raised.value)


@pytest.mark.parametrize(
    ("f", "form"),
    [
        ("k a^k", "a z^-1/(1 - a z^-1)^2"),
        ("2^k", "1/(1 - 2/z)"),
        ("2^k", "F(z) = z/(z - 2)"),
        ("step(k - 2)", "z^-2/(1 - z^-1)"),
        ("step(k - 2)", "z^(-2) z/(z - 1)"),
    ],
)
def test_forms_in_z_and_in_its_inverse_are_right(f, form):
    assert verdict(text(f), "a", "F", f'"{form}"').verdict == "correct"


@pytest.mark.parametrize(
    ("question", "wrong", "says"),
    [
        ({"f": "2^k"}, "z/(z - 1/2)", "base is inverted"),
        ({"f": "2^k"}, "1/(z - 2)", "factor $z$"),
        ({"f": "k*2^k"}, "z^2/((z - 1)^2 (z - 2))", "product"),
        ({"f": "cos(k)"}, "z sin(1)/(z^2 - 2z cos(1) + 1)", "sine and cosine"),
        ({"f": "2^k step(k - 2)"}, "z^(-2)*z/(z - 2)", "time since"),
        ({"f": "step(k - 2)"}, "z/(z - 1)", "delay is forgotten"),
        ({"f": "step(k - 2)"}, "z^2 z/(z - 1)", "wrong sign"),
        ({"F": "1/(s + 1)", "sample_time": "1/2"}, "z/(z - exp(-1))", "period"),
        ({"F": "1/(s + 2)", "sample_time": "1/2"}, "1/(z + 2)", "in place of $s$"),
        ({"F": "1/((s + 1)(s + 2))", "sample_time": "1"}, "z^2/((z - exp(-1))(z - exp(-2)))", "product"),
    ],
)
def test_usual_mistakes_are_named(question, wrong, says):
    found = verdict(text(**question), "a", "F", f'"{wrong}"')
    assert found.verdict == "wrong"
    assert says in str(found.reason)
