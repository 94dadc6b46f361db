"""What expressions mean: a table of readings, each with the exact sympy object it stands for."""

import pytest
import sympy as sp

from solver.problem.expressions import (
    Names,
    canonical_name,
    parse_alternatives,
    parse_equation,
    parse_expression,
    uses_decimal,
)

s, t = sp.symbols("s t")
a, b, c, x, y, n = (sp.Symbol(name, real=True) for name in "abcxyn")
q = sp.Function("q")(t)
Q = sp.Rational

READINGS = [
    # numbers are exact
    ("0.75", Q(3, 4)),
    (".5", Q(1, 2)),
    ("3/4", Q(3, 4)),
    ("1e-3", Q(1, 1000)),
    ("2.5E2", sp.Integer(250)),
    ("0.1 + 0.2", Q(3, 10)),
    ("1e30", sp.Integer(10) ** 30),
    ("2e3t", 2000 * t),
    ("2e", 2 * sp.E),
    # precedence
    ("-x^2", -(x**2)),
    ("(-x)^2", x**2),
    ("2^-1", Q(1, 2)),
    ("x^2^3", x**8),
    ("(x^2)^3", x**6),
    ("x**2", x**2),
    ("a/b/c", a / b / c),
    ("a/b*c", a * c / b),
    ("a - b - c", a - b - c),
    ("-a*b", -a * b),
    ("2*-3", sp.Integer(-6)),
    ("2 - -3", sp.Integer(5)),
    ("--x", x),
    ("+x", x),
    ("2^-x^2", sp.Pow(2, -(x**2))),
    # implicit products
    ("2s", 2 * s),
    ("3(s+1)", 3 * (s + 1)),
    ("t(t - 1)", t * (t - 1)),
    ("2(t - 1)", 2 * (t - 1)),
    ("(s+1)(s+2)", (s + 1) * (s + 2)),
    ("k_1 x", sp.Symbol("k_1", real=True) * x),
    ("2 sqrt(3) t", 2 * sp.sqrt(3) * t),
    ("x(s+1)^2", x * (s + 1) ** 2),
    ("x^2y", x**2 * y),
    ("x^2(s+1)", x**2 * (s + 1)),
    ("2x/3", 2 * x / 3),
    ("2x/(3y)", 2 * x / (3 * y)),
    ("e^(-t) cos(2t)", sp.exp(-t) * sp.cos(2 * t)),
    ("e^t cos(t)", sp.exp(t) * sp.cos(t)),
    ("t exp(-t)sin(t)", t * sp.exp(-t) * sp.sin(t)),
    ("pi(s+1)", sp.pi * (s + 1)),
    # functions and constants
    ("sqrt(8)", 2 * sp.sqrt(2)),
    ("ln(x)", sp.log(x)),
    ("log(x)", sp.log(x)),
    ("exp(-0.5t)", sp.exp(-t / 2)),
    ("e^(-0.5t)", sp.exp(-t / 2)),
    ("asin(1) + acos(x) + atan(x)", sp.pi / 2 + sp.acos(x) + sp.atan(x)),
    ("sinh(x) + cosh(x) + tanh(x)", sp.sinh(x) + sp.cosh(x) + sp.tanh(x)),
    ("abs(-3 + 4j)", sp.Integer(5)),
    ("abs(x)", sp.Abs(x)),
    ("abs(sin(t))", sp.Abs(sp.sin(t), evaluate=False)),
    ("step(t - 1)", sp.Heaviside(t - 1)),
    ("delta(t)", sp.DiracDelta(t)),
    ("delta x", sp.Symbol("delta", real=True) * x),
    ("2 + 3j", 2 + 3 * sp.I),
    ("j^2", sp.Integer(-1)),
    ("2i", 2 * sp.Symbol("i", real=True)),
    ("exp(j pi)", sp.Integer(-1)),
    ("inf", sp.oo),
    ("-inf", -sp.oo),
    ("e^(-pi*0.6/sqrt(1 - 0.6^2))", sp.exp(-3 * sp.pi / 4)),
    ("cos(0) + exp(0)", sp.Integer(2)),
    ("sin(100log(x))", sp.sin(100 * sp.log(x))),
    ("exp(20x)^5", sp.exp(100 * x)),
    # what is small beside what it is made of
    ("exp(2000delta(3))", sp.Integer(1)),
    ("exp(2000step(-3))", sp.Integer(1)),
    ("exp(2000step(0))", sp.exp(1000)),
    ("sqrt(18446744073709551615)", sp.sqrt(2**64 - 1)),
    ("(2^64)^31 * 2^62", sp.Integer(2) ** 2046),
    # other spellings
    ("−3·x²", -3 * x**2),
    ("2×3", sp.Integer(6)),
    ("x⁻¹", 1 / x),
    ("x¹²", x**12),
    ("x\n + y", x + y),
    ("π/2", sp.pi / 2),
    ("ωt", sp.Symbol("omega", real=True) * t),
    ("2ζω_n s", 2 * sp.Symbol("zeta", real=True) * sp.Symbol("omega_n", real=True) * s),
    ("lambda + λ", 2 * sp.Symbol("lamda", real=True)),
    ("lambda_1", sp.Symbol("lamda_1", real=True)),
    ("k_θ", sp.Symbol("k_theta", real=True)),
    ("µ - μ", sp.Integer(0)),
    # nothing is multiplied out
    ("(s+1)(s+2)(s+3)", (s + 1) * (s + 2) * (s + 3)),
    ("(s+1)^64", (s + 1) ** 64),
]


@pytest.mark.parametrize(("text", "meaning"), READINGS)
def test_an_expression_means_what_an_engineer_reads(text, meaning):
    assert parse_expression(text, Names(variables={"s": s, "t": t})) == meaning


def test_declared_symbols_keep_their_assumptions():
    positive = sp.Symbol("a", positive=True)
    assert parse_expression("sqrt(a^2)", Names(symbols={"a": positive})) == positive


def test_undeclared_names_are_real_symbols():
    assert parse_expression("v", Names()).is_real


def test_values_stand_in_for_their_names():
    assert parse_expression("k/m", Names(values={"k": sp.Integer(20), "m": Q(1, 2)})) == 40


def test_a_declared_name_wins_over_a_constant():
    e = sp.Symbol("e", real=True)
    names = Names(symbols={"e": e}, values={"j": sp.Integer(7)})
    assert parse_expression("e^2 + j", names) == e**2 + 7
    assert parse_expression("e^2x", names) == e**2 * x


def test_plus_minus_stands_for_two_values():
    assert parse_alternatives("-3 ± 2j", Names()) == (-3 + 2 * sp.I, -3 - 2 * sp.I)
    assert parse_alternatives("±2j", Names()) == (2 * sp.I, -2 * sp.I)
    assert parse_alternatives("2(1 \u00b1 j)", Names()) == (2 + 2 * sp.I, 2 - 2 * sp.I)
    assert parse_alternatives("-3", Names()) == (-3,)


def test_primes_are_time_derivatives():
    names = Names(functions={"q": q}, variables={"t": t})
    assert parse_equation("m q'' + d q' + c q = 0", names)[0] == (
        sp.Symbol("m", real=True) * q.diff(t, 2) + sp.Symbol("d", real=True) * q.diff(t) + c * q
    )
    assert parse_expression("q'^2/2", names) == q.diff(t) ** 2 / 2
    assert parse_expression("q″ + q’", names) == q.diff(t, 2) + q.diff(t)
    assert parse_expression("q(t) + q'(t)", names) == q + q.diff(t)
    assert parse_expression("sin(q)", names) == sp.sin(q)


def test_functions_of_time_may_be_shifted():
    k = sp.Symbol("k")
    f, u = sp.Function("f"), sp.Function("u")
    names = Names(variables={"k": k}, functions={"f": f(k), "u": u(k)})
    assert parse_equation("f(k+2) - 0.5f(k+1) = u", names) == (f(k + 2) - f(k + 1) / 2, u(k))


def test_decimals_are_noticed():
    assert uses_decimal("s + 0.75")
    assert uses_decimal("1e-3")
    assert not uses_decimal("3/4 s^2 + 10")


@pytest.mark.parametrize(
    ("written", "plain"), [("ω_n", "omega_n"), ("lambda", "lamda"), ("λ1", "lambda1"), ("x_1", "x_1"), ("Ω", "Omega")]
)
def test_names_have_one_plain_spelling(written, plain):
    assert canonical_name(written) == plain


def test_a_long_sum_is_read():
    text = " + ".join(f"0.{i}1 a_{i}" for i in range(100))
    assert len(parse_expression(text, Names()).args) == 100


def test_a_transfer_function_of_a_course_is_read():
    text = "(2s^3+5s^2+3s+1)/(4s^4+2s^2+3s+6)"
    expected = (2 * s**3 + 5 * s**2 + 3 * s + 1) / (4 * s**4 + 2 * s**2 + 3 * s + 6)
    assert parse_expression(text, Names(variables={"s": s})) == expected
