"""Functions without brackets, as students write them: cos 2t, sqrt 3, exp -t, sin^2(t). Rules of the grammar.

The argument is a sign, then the numbers and names up to the next sign, function or power of e; under a root stands one
of them. What may also belong to it is a matter of doubt.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from solver.problem.expressions import refusals
from solver.problem.expressions.cursor import Cursor
from solver.problem.expressions.doubts import Decide, Doubt
from solver.problem.expressions.names import Names
from solver.problem.expressions.notation import FUNCTIONS
from solver.problem.expressions.syntax import Call, Node, Number, Power, Product, Sum
from solver.problem.expressions.tokens import Kind, Token, exact_number

UNITS = ("j", "i", "I")
"""The imaginary unit, which nobody writes under a root without brackets: sqrt 3 j."""


class Parser(Protocol):
    """What of the parser is needed here."""

    cursor: Cursor
    names: Names

    def nested(self, rule: Callable[[], Node]) -> Node:
        """Apply a rule one level deeper."""

    def group(self, function: Token | None = None) -> Node:
        """Read ( sum )."""

    def atom(self) -> Node:
        """Read a number, a name or a group."""

    def raised(self, base: Node) -> Node:
        """Read the exponent of a base, if it has one."""


def bare_call(parser: Parser, token: Token, decide: Decide) -> Node:
    """Read what follows a function that has no bracket after it. Raises ExpressionError."""
    cursor, function = parser.cursor, FUNCTIONS[token.text]
    power = _power_of_function(parser, token)
    bare = not cursor.sees("(")
    argument = parser.nested(lambda: _argument(parser, function, decide)) if bare else parser.group(token)
    call = Call(token.at, cursor.last.end, function, argument)
    return call if power is None else Power(token.at, cursor.last.end, call, power)


def _power_of_function(parser: Parser, token: Token) -> Number | None:
    """Read the ^2 of sin^2(t); sin^-1, the inverse function to some and the reciprocal to others, is refused."""
    cursor = parser.cursor
    if not cursor.sees("^") and not cursor.sees_kind(Kind.SUPERSCRIPT):
        return None
    if cursor.sees("^"):
        cursor.take()
    sign = cursor.take()
    power = exact_number(sign) if sign.kind in (Kind.NUMBER, Kind.SUPERSCRIPT) else 0
    if power <= 0:
        raise refusals.argument_missing(cursor, token)
    return Number(sign.at, sign.end, exact_number(sign))


def _argument(parser: Parser, function: str, decide: Decide) -> Node:
    cursor, start = parser.cursor, parser.cursor.token.at
    if cursor.sees("+", "-"):
        sign = cursor.take()
        operand = parser.nested(lambda: _argument(parser, function, decide))
        return Sum(sign.at, operand.end, ((sign.text, operand),))
    if function == "sqrt":
        factors = _under_root(parser, decide)
    else:
        factors = [("*", _factor(parser, decide))]
        while _has_root(parser) or (_goes_on(parser) and (not cursor.sees("(") or decide(Doubt.ARGUMENT))):
            factors.append(("*", _factor(parser, decide)))
        while cursor.sees("/", "*") and decide(Doubt.ARGUMENT):
            factors.append((cursor.take().text, _factor(parser, decide)))
    return factors[0][1] if len(factors) == 1 else Product(start, cursor.last.end, tuple(factors))


def _under_root(parser: Parser, decide: Decide) -> list[tuple[str, Node]]:
    factors = [("*", _factor(parser, decide))]
    while _goes_on(parser) and parser.cursor.token.text not in UNITS and decide(Doubt.ROOT):
        factors.append(("*", _factor(parser, decide)))
    return factors


def _factor(parser: Parser, decide: Decide) -> Node:
    """Read a number, a name or a group; a power after it may be one of the function's value."""
    base = parser.atom()
    squared = parser.cursor.sees("^") or parser.cursor.sees_kind(Kind.SUPERSCRIPT)
    return parser.raised(base) if squared and decide(Doubt.ARGUMENT) else base


def _goes_on(parser: Parser) -> bool:
    """Whether a name or ( follows that is no power of e and no function."""
    token, names = parser.cursor.token, parser.names
    if parser.cursor.sees("("):
        return True
    natural = token.text == "e" and names.is_constant("e")
    function = token.text in FUNCTIONS and not names.declares(token.text)
    return token.kind is Kind.NAME and not natural and not function


def _has_root(parser: Parser) -> bool:
    """Whether a root follows a number, as in cos 5√3 t: nobody multiplies the cosine of a number by a root."""
    token, last = parser.cursor.token, parser.cursor.last
    return token.text == "sqrt" and not parser.names.declares("sqrt") and last.kind is Kind.NUMBER
