"""The errors of the grammar: what was expected, and what may have been meant. Each function returns the error."""

from __future__ import annotations

from solver.problem.expressions.cursor import Cursor
from solver.problem.expressions.errors import ExpressionError
from solver.problem.expressions.syntax import Node, Number, Power
from solver.problem.expressions.tokens import Kind, Token


def _across(message: str, at: int, end: int, suggestion: str = "") -> ExpressionError:
    return ExpressionError(message, at, end - at, suggestion)


def unexpected(cursor: Cursor, if_equation: str) -> ExpressionError:
    """The next token cannot stand there; `if_equation` is the message where it is =."""
    token = cursor.token
    if cursor.sees(","):
        return stray_comma(cursor)
    messages = {
        "=": if_equation,
        ")": "this ) closes no (",
        "'": "a prime is expected right after the name of a function of time",
    }
    return _across(messages.get(token.text, f"{token.text} is not expected here"), token.at, token.end)


def operand_missing(cursor: Cursor) -> ExpressionError:
    """A number, a name or ( had to come next."""
    token, operand = cursor.token, "a number, a name or ("
    if cursor.position and cursor.last.text == "(" and cursor.sees(")"):
        return _across("an expression is expected between ( and )", cursor.last.at, token.end)
    if cursor.position and cursor.last.kind is Kind.OPERATOR:
        return _across(f"{operand} is expected after {cursor.last.text}", token.at, token.end)
    if token.kind is Kind.END:
        return _across(f"an expression is expected: {operand}", token.at, token.end)
    return _across(f"{operand} is expected before {token.text}", token.at, token.end)


def not_closed(cursor: Cursor, opening: Token) -> ExpressionError:
    """A ( has no )."""
    if cursor.token.kind is Kind.END:
        return ExpressionError("this ( is not closed: ) is expected", opening.at, 1, f"{cursor.text.rstrip()})")
    return unexpected(cursor, "an equation has its sign = outside brackets")


def stray_comma(cursor: Cursor) -> ExpressionError:
    """A comma, which between digits is meant as a decimal point."""
    comma, following = cursor.token, cursor.after(1)[0]
    if cursor.position and cursor.last.kind is following.kind is Kind.NUMBER:
        suggestion = f"{cursor.last.text}.{following.text}"
        return _across("numbers are written with a decimal point", cursor.last.at, following.end, suggestion)
    return _across("a comma is not expected here", comma.at, comma.end)


def two_signs(cursor: Cursor, first: Token) -> ExpressionError:
    """+-2, which may be meant as ±2."""
    message = f"unclear: {first.text}{cursor.token.text} may be one sign or two"
    return _across(message, first.at, cursor.token.end, f"± or {first.text}({cursor.token.text}...)")


def product_after_division(cursor: Cursor, start: int, divisor: Node, following: Node) -> ExpressionError:
    """1/2x, where x may be above or below."""
    before = cursor.text[start : divisor.at].rstrip().removesuffix("/").rstrip()
    by, then = cursor.written(divisor), cursor.written(following)
    message = "unclear: a product without a sign follows a division"
    return _across(message, divisor.at, following.end, f"{before}/({by}*{then}) or ({before}/{by})*{then}")


def unclear_exponent(cursor: Cursor, power: Power, following: Node) -> ExpressionError:
    """e^-2t, where t may be in the exponent or not."""
    base, exponent, then = (cursor.written(node) for node in (power.base, power.exponent, following))
    suggestion = f"{base}^({exponent}*{then}) or {base}^({exponent})*{then}"
    return _across("unclear: where does the exponent end?", power.at, following.end, suggestion)


def operator_missing(cursor: Cursor, before: Node) -> ExpressionError:
    """A number after a number or a name: 10 000, or x 2."""
    number, written = cursor.token, cursor.written(before)
    joined = f"{written}{number.text} or " if isinstance(before, Number) else ""
    message = "an operator is missing before this number"
    return _across(message, number.at, number.end, f"{joined}{written}*{number.text}")


def argument_missing(cursor: Cursor, function: Token) -> ExpressionError:
    """A function without brackets: sin x, or sin^2(x)."""
    power = cursor.sees("^") or cursor.token.kind is Kind.SUPERSCRIPT
    suggestion = f"{function.text}(...)^2" if power else f"{function.text}(...)"
    message = f"{function.text} is a function: its argument is expected in brackets"
    return _across(message, function.at, function.end, suggestion)


def one_argument(cursor: Cursor, function: Token) -> ExpressionError:
    """A function of two arguments: log(x, 10)."""
    suggestion = "log(x)/log(10)" if function.text in ("log", "ln") else f"{function.text}(x)"
    return _across(f"{function.text} takes one argument", cursor.token.at, cursor.token.end, suggestion)
