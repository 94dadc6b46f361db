"""Random expressions, written in the notation, against other people's arithmetic: fractions and mpmath.

A tree is drawn, printed with implicit products and only the brackets it needs, and evaluated directly; the evaluator
shares nothing with the parser or with sympy's building of expressions.
"""

from fractions import Fraction

import mpmath
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st

from solver.problem.expressions import ExpressionError, Names, parse_expression
from tests.helpers.tried import tried

RATIONALS = {"x": Fraction(3, 7), "y": Fraction(-5, 2), "k_1": Fraction(4), "omega": Fraction(1, 9)}
FUNCTIONS = ["sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "abs"]
SUM, PRODUCT, POWER, ATOM = range(4)

numbers = st.one_of(
    st.integers(0, 99).map(str),
    st.tuples(st.integers(0, 9), st.integers(0, 99)).map(lambda pair: f"{pair[0]}.{pair[1]:02d}"),
    st.tuples(st.integers(1, 9), st.integers(-3, 2)).map(lambda pair: f"{pair[0]}e{pair[1]}"),
)
leaves = st.one_of(
    numbers.map(lambda text: ("number", text)), st.sampled_from(sorted(RATIONALS)).map(lambda n: ("name", n))
)


def operations(children):
    return st.one_of(
        st.tuples(st.sampled_from(["+", "-", "*", "implicit", "/"]), children, children),
        st.tuples(st.just("^"), children, st.integers(-3, 3)),
        st.tuples(st.just("neg"), children),
    )


def with_functions(children):
    return st.one_of(operations(children), st.tuples(st.just("call"), st.sampled_from(FUNCTIONS), children))


def level(text_and_level, least):
    """The text, in brackets if it binds less than needed."""
    text, binds = text_and_level
    return text if binds >= least else f"({text})"


def written(tree):
    """The text of a tree, and how strongly its outermost operation binds."""
    kind, *parts = tree
    if kind in ("number", "name"):
        return parts[0], ATOM
    if kind == "call":
        return f"{parts[0]}({written(parts[1])[0]})", ATOM
    if kind == "neg":
        return f"-{level(written(parts[0]), PRODUCT)}", SUM
    if kind == "^":
        exponent = str(parts[1]) if parts[1] >= 0 else f"({parts[1]})"
        return f"{level(written(parts[0]), ATOM)}^{exponent}", POWER
    left, right = (written(part) for part in parts)
    if kind == "+":
        return f"{level(left, SUM)} + {level(right, PRODUCT)}", SUM
    if kind == "-":
        return f"{level(left, SUM)}-{level(right, PRODUCT)}", SUM
    if kind == "implicit":
        first, second = level(left, POWER), level(right, POWER)
        return (f"{first} {second}" if second[0].isalpha() else f"{first} ({second})"), PRODUCT
    # a product after a division needs its sign, so a quotient is read from the left only before an explicit one
    return f"{level(left, POWER)}{kind}{level(right, POWER)}", PRODUCT


def value(tree, number, name, call):
    """The value of a tree, computed from the leaves up."""
    kind, *parts = tree
    if kind == "number":
        return number(parts[0])
    if kind == "name":
        return name(parts[0])
    if kind == "call":
        return call(parts[0], value(parts[1], number, name, call))
    first = value(parts[0], number, name, call)
    if kind == "neg":
        return -first
    if kind == "^":
        if first == 0 and parts[1] <= 0:
            raise ZeroDivisionError
        return first ** parts[1]
    second = value(parts[1], number, name, call)
    return {"+": first + second, "-": first - second}.get(kind) if kind in "+-" else _product(kind, first, second)


def _product(kind, first, second):
    return first / second if kind == "/" else first * second


@tried(400)
@given(st.recursive(leaves, operations, max_leaves=12))
def test_rational_expressions_have_the_value_of_python_fractions(tree):
    text = written(tree)[0]
    names = Names(values={name: sp.Rational(q.numerator, q.denominator) for name, q in RATIONALS.items()})
    try:
        expected = value(tree, Fraction, RATIONALS.__getitem__, None)
    except ZeroDivisionError:
        expected = None
    found, message = None, ""
    try:
        found = parse_expression(text, names)
    except ExpressionError as error:
        message = error.message
    assume("bits" not in message and "exponent" not in message)
    if expected is None:
        assert found is None
    else:
        assert Fraction(int(found.p), int(found.q)) == expected, message


@tried(300)
@given(st.recursive(leaves, operations, max_leaves=10))
def test_symbolic_expressions_have_the_value_of_python_fractions(tree):
    text = written(tree)[0]
    try:
        expected = value(tree, Fraction, RATIONALS.__getitem__, None)
        found = parse_expression(text, Names())
    except (ZeroDivisionError, ExpressionError):
        assume(False)
    at = {sp.Symbol(name, real=True): sp.Rational(q.numerator, q.denominator) for name, q in RATIONALS.items()}
    result = found.xreplace(at)
    assert Fraction(int(result.p), int(result.q)) == expected


def _call(name, argument):
    return (abs if name == "abs" else getattr(mpmath, name))(argument)


@tried(300)
@given(st.recursive(leaves, with_functions, max_leaves=6))
def test_expressions_with_functions_have_the_value_of_mpmath(tree):
    text = written(tree)[0]
    with mpmath.workdps(60):
        try:
            expected = value(
                tree,
                lambda digits: mpmath.mpf(Fraction(digits).numerator) / Fraction(digits).denominator,
                lambda name: mpmath.mpf(RATIONALS[name].numerator) / RATIONALS[name].denominator,
                _call,
            )
            found = parse_expression(text, Names())
        except (ZeroDivisionError, ValueError, OverflowError, ExpressionError):
            assume(False)
        assume(1e-9 < abs(expected) < 1e9)
        at = {sp.Symbol(name, real=True): sp.Rational(q.numerator, q.denominator) for name, q in RATIONALS.items()}
        result = mpmath.mpmathify(sp.N(found.subs(at), 40))
        assert abs(result - expected) <= mpmath.mpf("1e-15") * abs(expected), text
