"""Expressions in engineering notation: text to exact sympy objects, safely.

`2 sqrt(3) t`, `3(s+1)/(s^2 + 0.75s + 1)`, `m x'' + d x' + k x = u`, `-3 ± 2j`. The text is cut into tokens, parsed by
a grammar of our own, bounded in cost, and only then built with sympy; nothing is ever evaluated as code. Whatever the
text, the outcome is an expression or an `ExpressionError` with place, reason and suggestion.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager

from solver.lazy import sympy as sp
from solver.problem.expressions.bounds import check_numbers
from solver.problem.expressions.build import build, build_fraction
from solver.problem.expressions.doubts import Decide, Doubt
from solver.problem.expressions.errors import ExpressionError
from solver.problem.expressions.grammar import parse, parse_sides
from solver.problem.expressions.names import Names
from solver.problem.expressions.shape import check_shape
from solver.problem.expressions.syntax import Node
from solver.problem.expressions.tokens import Kind, is_decimal, tokenize

__all__ = [
    "Doubt",
    "ExpressionError",
    "Names",
    "canonical_name",
    "parse_alternatives",
    "parse_equation",
    "parse_expression",
    "parse_fraction",
    "parse_written",
    "uses_decimal",
]


INTEGER = re.compile(r"-?[0-9]{1,15}")


def parse_expression(text: str, names: Names) -> sp.Expr:
    """Return the expression, exact: "0.75" is 3/4. Raises ExpressionError."""
    if INTEGER.fullmatch(text):  # as most entries of matrices are
        return sp.Integer(int(text))
    with _only_expression_errors(text):
        node = parse(text, names)
        _check(node, names)
        return build(node, names)


def parse_alternatives(text: str, names: Names) -> tuple[sp.Expr, ...]:
    """Return the values of an expression that may hold one ±: "-3 ± 2j" has two, + first. Raises ExpressionError."""
    return tuple(value for value, _ in parse_written(text, names, {}))


def parse_written(
    text: str, names: Names, decimals: Mapping[int, sp.Symbol], decide: Decide | None = None
) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
    """Return the values of `parse_alternatives`, each with the form that has symbols for the decimals at some places.

    `decide` settles what has two readings, which is refused without it. Raises ExpressionError.
    """
    with _only_expression_errors(text):
        node = parse(text, names, alternatives=True, decide=decide)
        signs = (1, -1) if "±" in text else (1,)
        for sign in signs:
            _check(node, names, sign)
        values = [build(node, names, sign) for sign in signs]
        forms = [build(node, names, sign, decimals) for sign in signs] if decimals else values
        return tuple(zip(values, forms, strict=True))


def parse_fraction(text: str, names: Names) -> tuple[sp.Expr, sp.Expr]:
    """Return numerator and denominator of a quotient, common factors kept as written. Raises ExpressionError."""
    with _only_expression_errors(text):
        node = parse(text, names)
        _check(node, names)
        build(node, names)  # the value as a whole must exist: 1/(x - x) has none
        return build_fraction(node, names)


def parse_equation(text: str, names: Names) -> tuple[sp.Expr, sp.Expr]:
    """Return the two sides of "m x'' + d x' + k x = u"; `names.functions` says what x is. Raises ExpressionError."""
    with _only_expression_errors(text):
        sides = parse_sides(text, names)
        for side in sides:
            _check(side, names)
        left, right = (build(side, names) for side in sides)
        return left, right


def uses_decimal(text: str) -> bool:
    """Whether a decimal was typed (0.75, 1e-3). Raises ExpressionError if the text cannot be read."""
    return any(is_decimal(token) for token in tokenize(text))


def canonical_name(text: str) -> str:
    """Return the plain spelling of one name: "ω_n" is "omega_n", "lambda" is "lamda". Raises ExpressionError."""
    token, *others = tokenize(text)
    if token.kind is not Kind.NAME or len(others) > 1:
        raise ExpressionError("a name is expected: letters, digits and _", 0, len(text))
    return token.text


def _check(node: Node, names: Names, plus_minus: int = 1) -> None:
    """Raise ExpressionError unless the expression can be built, and worked with, in reasonable time."""
    check_shape(node, names)
    check_numbers(node, names, plus_minus)


@contextmanager
def _only_expression_errors(text: str) -> Iterator[None]:
    """Turn what sympy may raise on a strange expression into an ExpressionError for the whole text."""
    try:
        yield
    except ExpressionError:
        raise
    except Exception as error:  # the boundary: whatever the text, the reader of a file gets a place and a reason
        raise ExpressionError("this expression cannot be evaluated", 0, len(text)) from error
