"""Every error says where, what was expected, and what may be written instead."""

import subprocess
import sys

import pytest
import sympy as sp

from solver.problem.expressions import (
    ExpressionError,
    Names,
    canonical_name,
    parse_alternatives,
    parse_equation,
    parse_expression,
)

t, s = sp.symbols("t s")
NAMES = Names(
    symbols={name: sp.Symbol(name, real=True) for name in ("x", "y", "m", "omega")},
    variables={"s": s, "t": t},
    values={"two": sp.Integer(2), "delta_0": sp.Rational(1, 2)},
    functions={"theta": sp.Function("theta")(t)},
)

ERRORS = [
    # text, offset, length, part of the message, suggestion
    ("", 0, 1, "an expression is expected", ""),
    ("  ", 2, 1, "an expression is expected", ""),
    ("2 +", 3, 1, "expected after +", ""),
    ("2 * / 3", 4, 1, "expected after *", ""),
    ("^2", 0, 1, "expected before ^", ""),
    ("()", 0, 2, "between ( and )", ""),
    ("(s + 1", 0, 1, "is not closed", "(s + 1)"),
    ("s + 1)", 5, 1, "closes no (", ""),
    ("x = 1", 2, 1, "an equation stands where", ""),
    ("(x = 1)", 3, 1, "outside brackets", ""),
    # ambiguous products, divisions, exponents, signs
    ("1/2x", 2, 2, "unclear", "1/(2*x) or (1/2)*x"),
    ("1/2(s+1)", 2, 6, "unclear", "1/(2*(s+1)) or (1/2)*(s+1)"),
    ("1/s x", 2, 3, "unclear", "1/(s*x) or (1/s)*x"),
    ("(s+1)/(s+2)(s+3)", 6, 10, "unclear", "(s+1)/((s+2)*(s+3)) or ((s+1)/(s+2))*(s+3)"),
    ("e^-2t", 0, 5, "where does the exponent end", "e^(-2*t) or e^(-2)*t"),
    ("3e^2t", 1, 4, "where does the exponent end", "e^(2*t) or e^(2)*t"),
    ("s^-1x", 0, 5, "where does the exponent end", "s^(-1*x) or s^(-1)*x"),
    ("x^y(s+1)", 0, 8, "where does the exponent end", "x^(y*(s+1)) or x^(y)*(s+1)"),
    ("x²^3", 1, 2, "two exponents", "x^(2^3) or (x^2)^3"),
    ("-3 +-2j", 3, 2, "one sign or two", "± or +(-...)"),
    ("-3 ± 2j", 3, 1, "only in lists of poles", ""),
    ("10 000", 3, 3, "an operator is missing", "10000 or 10*000"),
    ("x 2", 2, 1, "an operator is missing", "x*2"),
    ("0,75", 0, 4, "decimal point", "0.75"),
    ("5.", 1, 1, "after the decimal point", "5 or 5.0"),
    ("1.2.3", 3, 1, "after the decimal point", "1.2 or 1.2.0"),
    # names
    ("xy", 0, 2, "may be a product", "x*y"),
    ("2 + momegat", 4, 7, "may be a product", "m*omega*t"),
    ("exp(-at)", 5, 2, "may be a product", "a*t"),
    ("1/(Ts + 1)", 3, 2, "may be a product", "T*s"),
    ("oo", 0, 2, "no name of a symbol", "inf"),
    ("lambda2 + if", 10, 2, "reserved word", "if_1"),
    ("_x", 0, 1, "has no meaning", "a letter before the underscore, as in k_1"),
    ("a__b", 1, 1, "after the underscore", "a_1"),
    ("x_ + 1", 1, 1, "after the underscore", "x_1"),
    ("δx", 0, 2, "one name or a product", "delta_x or delta*x"),
    ("x" * 41, 0, 41, "at most 40 characters", ""),
    # functions
    ("sin x", 0, 3, "expected in brackets", "sin(...)"),
    ("sin^2(x)", 0, 3, "expected in brackets", "sin(...)^2"),
    ("sin()", 3, 2, "between ( and )", ""),
    ("sinn(x)", 0, 4, "unknown function sinn", "sin"),
    ("arctan(x)", 0, 6, "unknown function", "atan"),
    ("Heaviside(t)", 0, 9, "unknown function", "step"),
    ("foo(x)", 0, 3, "unknown function", "foo*(...)"),
    ("sigma(t-1)", 0, 5, "unknown function", "step(...) or sigma*(...)"),
    ("eps(t)", 0, 3, "unknown function", "step(...) or eps*(...)"),
    ("sigma(x)", 0, 5, "unknown function", "sigma*(...)"),
    ("log(x, 10)", 5, 1, "log takes one argument", "log(x)/log(10)"),
    ("u(t)", 0, 1, "not a function of t here", "step(t) or u*t"),
    ("u(t-1) - u(t-4)", 0, 1, "not a function of t here", "step(t-1) or u*(t-1)"),
    ("x - 2 x(t + m)", 6, 1, "not a function of t here", "x*(t + m)"),
    ("1(t)", 0, 1, "1 is not a function of t here", "step(t) or 1*t"),
    ("3 u(-t)", 2, 1, "not a function of t here", "step(-t) or u*(-t)"),
    ("u (2 - (t - m))", 0, 1, "not a function of t here", "step(2 - (t - m)) or u*(2 - (t - m))"),
    ("1 (t)", 0, 1, "1 is not a function of t here", "step(t) or 1*t"),
    ("y(2t)", 0, 1, "not a function of t here", "y*(2t)"),
    ("2 - 1(t-2)", 4, 1, "1 is not a function of t here", "step(t-2) or 1*(t-2)"),
    ("x(t)", 0, 1, "not a function of t here", "x*t"),
    ("step(2 + j)", 4, 7, "expected to be real", ""),
    # primes
    ("2x'", 1, 2, "not a function of time", ""),
    ("theeta'", 0, 7, "not a function of time", "theta'"),
    ("theta'(0)", 0, 9, "a derivative is a function of t", "theta'"),
    ("theta'''''''''", 0, 14, "at most 8 primes", ""),
    ("(theta)'", 7, 1, "right after the name", ""),
    # characters
    ("[1, 2]", 0, 1, "the character [", "( )"),
    ("2 + √2", 4, 1, "U+221A", "sqrt(...)"),
    ("x!", 1, 1, "the character !", "the number itself"),
    ("|x|", 0, 1, "the character |", "abs(...)"),
    ("x.y", 1, 1, "the character .", "a digit before or after the point, as in 0.5"),
    ("x\u202e+1", 1, 1, "invisible character (U+202E)", ""),
    ("x\u200b+1", 1, 1, "invisible character (U+200B)", ""),
    ("x\x00", 1, 1, "invisible character (U+0000)", ""),
    ("х + 1", 0, 1, "U+0445, cyrillic small letter ha", ""),
    ("٣", 0, 1, "U+0663", ""),
    # without a value
    ("1/0", 2, 1, "division by zero", ""),
    ("1/(x - x)", 2, 7, "division by zero", ""),
    ("x/(two - 2)", 2, 9, "division by zero", ""),
    ("3 + 0^-1", 4, 4, "division by zero", ""),
    ("0^0", 0, 3, "0^0 has no value", ""),
    ("log(0)", 3, 3, "log(0) has no value", ""),
    ("inv(0)", 3, 3, "division by zero", ""),
    ("2 tan(pi/2)", 2, 9, "no value", ""),
    ("inf - inf", 0, 9, "no value", ""),
    ("exp(-inf)", 3, 6, "cannot be bounded", ""),
    ("sin(inf)", 3, 5, "cannot be bounded", ""),
    # limits
    ("x^65", 2, 2, "exponents go from -64 to 64", ""),
    ("9^9^9", 2, 3, "exponents go from -64 to 64", ""),
    ("2^(100x)", 2, 6, "exponents go from -64 to 64", ""),
    ("(x^10)^7", 0, 8, "the degree is more than 64", ""),
    ("1 + (1234567890123^50)^2", 4, 20, "more than 2048 bits", ""),
    ("sqrt(1e25)", 4, 6, "under a root", ""),
    ("sqrt(2^64)", 4, 6, "under a root", ""),
    ("(2^64)^31 * 2^63", 0, 16, "more than 2048 bits", ""),
    ("exp(2000step(1/2))", 3, 15, "too large", ""),
    ("1e31", 0, 4, "powers of ten", ""),
    ("1" * 41, 0, 41, "at most 40 digits", ""),
    ("exp(exp(10))", 3, 9, "too large", ""),
    ("exp(1000 log(x))", 3, 13, "an exponential of a logarithm", ""),
    ("(a+b+c+d)^40", 0, 12, "more than 5000 terms", ""),
    ("sin(x^7)", 3, 5, "at most 6", ""),
    ("sin(cos(sin(cos(x))))", 0, 21, "more than 3 functions", ""),
    ("(" * 41 + "x" + ")" * 41, 41, 1, "deeper than 40", ""),
    ("+".join("x" * 400), 600, 1, "more than 600", ""),
    (" " * 2001, 2000, 1, "longer than 2000", ""),
]


@pytest.mark.parametrize(("text", "at", "length", "message", "suggestion"), ERRORS)
def test_an_error_names_place_reason_and_remedy(text, at, length, message, suggestion):
    with pytest.raises(ExpressionError) as caught:
        parse_expression(text, NAMES)
    error = caught.value
    assert message in error.message
    assert (error.at, error.length, error.suggestion) == (at, length, suggestion)
    assert str(error) == error.message


EQUATION_ERRORS = [
    ("theta'", 6, "the sign = is missing", "theta' = 0"),
    ("x == 1", 2, "one sign = is enough", "="),
    ("x = 1 = 2", 6, "one sign =", ""),
    ("x =", 3, "expected after =", ""),
    ("= 0", 0, "expected before =", ""),
    ("x ) = 0", 2, "closes no (", ""),
]


@pytest.mark.parametrize(("text", "at", "message", "suggestion"), EQUATION_ERRORS)
def test_an_equation_has_two_sides(text, at, message, suggestion):
    with pytest.raises(ExpressionError) as caught:
        parse_equation(text, NAMES)
    assert message in caught.value.message
    assert (caught.value.at, caught.value.suggestion) == (at, suggestion)


@pytest.mark.parametrize(("text", "at"), [("1 ± 2 ± 3", 6), ("2*±3", 2), ("±", 1), ("1/(1 ± 1)", 2)])
def test_plus_minus_has_its_place(text, at):
    with pytest.raises(ExpressionError) as caught:
        parse_alternatives(text, NAMES)
    assert caught.value.at == at


def test_unknown_names_are_errors_in_a_closed_vocabulary():
    names = Names(symbols={"omega": sp.Symbol("omega")}, open=False)
    with pytest.raises(ExpressionError) as caught:
        parse_expression("2 + omga", names)
    assert (caught.value.at, caught.value.length, caught.value.suggestion) == (4, 4, "omega")


def test_a_declared_name_of_a_function_is_not_called():
    with pytest.raises(ExpressionError, match="declared as a name"):
        parse_expression("delta(t)", Names(symbols={"delta": sp.Symbol("delta")}))


@pytest.mark.parametrize("text", ["", "2", "a b", "a+1", "a'", "lambda x"])
def test_what_is_not_a_name_is_no_name(text):
    with pytest.raises(ExpressionError):
        canonical_name(text)


def test_errors_need_no_algebra():
    program = """
import sys
from solver.problem.expressions import ExpressionError, Names, parse_expression
try:
    parse_expression("9^9^9", Names())
except ExpressionError:
    assert "sympy" not in sys.modules
else:
    raise AssertionError
"""
    subprocess.run([sys.executable, "-c", program], check=True)
