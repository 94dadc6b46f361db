"""Texts made to do harm, or made at random: the outcome is an expression or an ExpressionError, and nothing is run."""

import os
import subprocess
import sys

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.problem.expressions import (
    ExpressionError,
    Names,
    canonical_name,
    parse_alternatives,
    parse_equation,
    parse_expression,
    uses_decimal,
)
from tests.helpers.tried import tried

NAMES = Names(
    symbols={"x": sp.Symbol("x", real=True), "c": sp.Symbol("c", complex=True)},
    variables={"s": sp.Symbol("s"), "t": sp.Symbol("t")},
    values={"g": sp.Rational(981, 100), "r": sp.sqrt(5)},
    functions={"q": sp.Function("q")(sp.Symbol("t"))},
)

CODE = [
    '__import__("os").getcwd()',
    "__import__('os').system('true')",
    "().__class__.__base__.__subclasses__()",
    'open("/etc/hostname").read()',
    "open(x)",
    "(lambda: 1)()",
    "lambda x: x",
    "f'{x}'",
    "sin(\"__import__('os').getpid()\")",
    "x.subs(x,2)",
    "(x**2).diff(x)",
    "exec(x)",
    "eval(x)",
    "getattr(x, y)",
    "[x for x in y]",
    "{x: y}",
    "x if y else z",
    "x := 2",
    "x; y",
    "`x`",
    "$(true)",
    "#x",
    "\\input{x}",
    "globals()",
    "Symbol(x)",
    "sympify(x)",
    "Matrix(2)",
    "x\r\nimport os",
]
COST = [
    "9**9**9",
    "9^9^9",
    "(1/3)**(10**8)",
    "factorial(10**7)",
    "10000000!",
    "1e999999999",
    'Float("1",10**7)',
    "x**2**2**2**2**2**2",
    "binomial(10**7, 10**6)",
    "fibonacci(10**8)",
    "gamma(10**7)",
    "bernoulli(10**6)",
    "N(pi,10**6)",
    "expand((x+y+z)**500)",
    "integrate(x)",
    "zeros(20000,20000)",
    "(" * 500,
    "(" * 300 + "x" + ")" * 300,
    "-" * 500 + "x",
    "2^" * 200 + "2",
    "sin(" * 100 + "x" + ")" * 100,
    "+".join(["x"] * 900),
    "1" * 2000,
    "x" * 2000,
    "(" * 5000,
    "-" * 5000 + "x",
    "+".join(["x"] * 20000),
    "(99^60)^64",
    "*".join(["99^60"] * 100),
    "((((x+1)^60)^60)^60)^60",
    "(x+y+z+1)^60",
    "2^(10^9 x)",
    "2^(10^6 r)",
    "exp(10^9 log(2))",
    "exp(log(2) 10^6 - 693147)",
    "e^(10^9 log(x))",
    "exp(10^9 x)^(log(2)/x)",
    "exp(10^9 log(x) log(2)/log(x))",
    "exp(log(2) log(exp(10^9 x))/x)",
    "exp(log(2) log(exp(900))^3)",
    "exp(log(2) sin(asin(10^9 x))/x)",
    "exp(1000000 log(g))",
    "exp(exp(exp(9)))",
    "sin(exp(exp(100)))",
    "step(exp(exp(10^30)))",
    "exp(1/(cos(1e-30) - 1))",
    "exp(exp(1e-20/(cos(1e-10) - 1 + 5e-21)))",
    "exp(60 log(123456789012345678901234567890))",
    "(123456789123456789123456789^60)^(1/2)",
    "sqrt(1234567891234567891234567891)",
    "abs((x + j)(x + 2j)(x + 3j) c t s (s+1) (s+2) (s+3) (s+4))",
    "cosh(t^64)",
    "tanh((sqrt(x) - s/3 - x^2)^-3)",
    "+".join(["sin(x)"] * 41),
    "+".join(f"1/(s+{i})" for i in range(70)),
]


@pytest.fixture(scope="module")
def events():
    """What Python itself reports of code compiled or run, files opened, processes started: while `on` is set."""
    seen = {"on": False, "events": []}
    watched = ("exec", "compile", "open", "os.", "subprocess.", "socket.", "import", "ctypes.", "shutil.", "pty.")

    def hook(event, arguments):
        if seen["on"] and event.startswith(watched):
            seen["events"].append((event, arguments))

    sys.addaudithook(hook)  # a hook cannot be taken off again; it does nothing while `on` is not set
    return seen


def refused(text):
    """Whether the text is refused by every way of reading it."""
    outcomes = []
    for read in (parse_expression, parse_alternatives, parse_equation):
        try:
            read(text, NAMES)
        except ExpressionError:
            outcomes.append(True)
        else:
            outcomes.append(False)
    return all(outcomes)


def test_the_watch_sees_what_is_run(events):
    events["on"] = True
    eval("1 + 1")  # noqa: S307 - what the watch must see
    events["on"] = False
    assert any(event == "exec" for event, _ in events["events"])
    events["events"].clear()


@pytest.mark.parametrize("text", CODE)
def test_code_is_refused_and_never_run(text, events, monkeypatch):
    for module, name in ((os, "system"), (os, "popen"), (subprocess, "Popen")):
        monkeypatch.setattr(module, name, lambda *_, **__: pytest.fail("a command was run"))
    events["events"].clear()
    events["on"] = True
    was_refused = refused(text)
    events["on"] = False
    assert was_refused
    assert events["events"] == []


@pytest.mark.parametrize("text", COST, ids=lambda text: text[:40])
def test_costly_texts_are_refused_before_any_algebra(text, monkeypatch):
    monkeypatch.setattr("solver.problem.expressions.build", lambda *_: pytest.fail("the algebra was reached"))
    assert refused(text)


@pytest.mark.parametrize("text", ["cos(pi/10007)", "tan(pi/257)", "(1 + 2j)^64", "2^(1/10007)", "sqrt(999999999989)"])
def test_hard_looking_texts_that_cost_little_are_read(text):
    assert parse_expression(text, NAMES).is_number


def outcome(read, text):
    """What is read, or None where the text is refused with a place inside it."""
    try:
        return read(text)
    except ExpressionError as caught:
        error = caught
    assert 0 <= error.at <= len(text)
    assert 1 <= error.length <= max(1, len(text) - error.at)
    assert error.message
    return None


READERS = [
    lambda text: parse_expression(text, NAMES),
    lambda text: parse_expression(text, Names(open=False)),
    lambda text: parse_alternatives(text, NAMES),
    lambda text: parse_equation(text, NAMES),
    uses_decimal,
    canonical_name,
]
PIECES = st.sampled_from(
    [
        *("2", "3", "0.75", "1e30", "64", "1/3", "999999999989", "x", "y", "s", "t", "c", "g", "r", "q", "q'"),
        *("pi", "e", "j", "inf", "lambda", "ω", "_1", ".", "e-", "(", "(", "(", ")", ")", ")", "+", "-", "*", "/"),
        *("^", "^", "±", "=", ",", " ", "²", "'", "sqrt(", "exp(", "log(", "sin(", "tan(", "acos(", "atan("),
        *("cosh(", "abs(", "step(", "delta("),
    ]
)


@tried(300)
@given(st.text(max_size=60))
def test_random_characters_give_an_expression_or_an_error(text):
    for read in READERS:
        outcome(read, text)


@tried(500)
@given(st.lists(PIECES, max_size=25).map("".join))
def test_random_pieces_give_an_expression_or_an_error(text):
    for read in READERS:
        outcome(read, text)


@tried(300)
@given(st.lists(PIECES, max_size=20).map("".join))
def test_whatever_is_read_is_exact_and_has_a_value(text):
    expression = outcome(lambda each: parse_expression(each, NAMES), text)
    if expression is not None:
        assert not expression.has(sp.Float, sp.nan, sp.zoo)
        numbers = [abs(part.p).bit_length() + part.q.bit_length() for part in expression.atoms(sp.Rational)]
        assert max(numbers, default=0) <= 2048
