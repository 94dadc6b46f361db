"""The parser: tokens to a syntax tree, by recursive descent with a bound on depth. Needs no algebra.

    sum     = [sign] product { sign product }             sign: + - ±
    product = factor { ("*" | "/" | nothing) factor }     "nothing" only before a name or "(", never after "/"
    factor  = [sign] power
    power   = atom [ "^" factor | superscript ]           x^2^3 is x^(2^3), -x^2 is -(x^2)
    atom    = number | name | function "(" sum ")" | signal primes [ "(" sum ")" ] | "(" sum ")"

What an engineer could read in two ways is refused, and both ways are named; unless `decide` says which is meant. Only
then a function may stand before its argument without brackets, cos 2t, and a power before it, sin^2(t).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from solver.problem.expressions import refusals
from solver.problem.expressions.bare_arguments import bare_call
from solver.problem.expressions.cursor import Cursor
from solver.problem.expressions.doubts import Decide, Doubt
from solver.problem.expressions.errors import ExpressionError
from solver.problem.expressions.names import Names
from solver.problem.expressions.notation import FUNCTIONS, MAX_DEPTH, MAX_PRIMES, MAX_TOKENS
from solver.problem.expressions.syntax import Call, Name, Node, Number, Power, Product, Signal, Sum
from solver.problem.expressions.tokens import Kind, Token, exact_number
from solver.problem.expressions.vocabulary import check_call, check_late, check_name, prime_refused

_SIGNS = ("+", "-", "±")


def parse(text: str, names: Names, *, alternatives: bool = False, decide: Decide | None = None) -> Node:
    """Return the syntax tree of an expression; only with `alternatives` may it hold a ±, and one at most."""
    parser = _Parser(text, names, alternatives, decide)
    node = parser.sum()
    parser.expect_end("an equation stands where an expression is expected")
    return node


def parse_sides(text: str, names: Names) -> tuple[Node, Node]:
    """Return the syntax trees of the two sides of an equation."""
    parser = _Parser(text, names, alternatives=False)
    left, cursor = parser.sum(), parser.cursor
    if not cursor.sees("="):
        parser.expect_end("")
        raise ExpressionError("an equation is expected: the sign = is missing", len(text), 1, f"{text.strip()} = 0")
    equals = cursor.take()
    if cursor.sees("="):
        raise ExpressionError("one sign = is enough", equals.at, cursor.token.end - equals.at, "=")
    right = parser.sum()
    parser.expect_end("an equation has one sign =")
    return left, right


class _Parser:
    """The rules of the grammar; each reads what it describes and returns its node."""

    def __init__(self, text: str, names: Names, alternatives: bool, decide: Decide | None = None) -> None:
        self.cursor = Cursor(text)
        self.decide = decide
        self.names = names
        self.depth = 0
        self.alternatives = alternatives

    def expect_end(self, if_equation: str) -> None:
        """Raise an error unless all is read."""
        if not self.cursor.sees_kind(Kind.END):
            raise refusals.unexpected(self.cursor, if_equation)

    def nested(self, rule: Callable[[], Node]) -> Node:
        """Apply a rule one level deeper."""
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise ExpressionError(f"the expression is nested deeper than {MAX_DEPTH} levels", self.cursor.token.at)
        node = rule()
        self.depth -= 1
        return node

    def sum(self) -> Node:
        cursor, start = self.cursor, self.cursor.token.at
        sign = self.sign() if cursor.sees(*_SIGNS) else "+"
        terms = [(sign, self.product())]
        while cursor.sees(*_SIGNS):
            sign = self.sign()
            terms.append((sign, self.product()))
        if len(terms) == 1 and terms[0][0] == "+":
            return terms[0][1]
        return Sum(start, cursor.last.end, tuple(terms))

    def sign(self) -> str:
        """Read the sign of a term."""
        token = self.cursor.take()
        if token.text == "±":
            if not self.alternatives:
                raise ExpressionError("± stands for two values, and is read only in lists of poles", token.at)
            self.alternatives = False
        if self.cursor.sees_adjacent(*{"+", "-"} - {token.text}):
            raise refusals.two_signs(self.cursor, token)
        return token.text

    def product(self) -> Node:
        cursor, start = self.cursor, self.cursor.token.at
        factors: list[tuple[str, Node]] = [("*", self.factor())]
        while True:
            operator, before = factors[-1]
            if cursor.sees("*", "/"):
                operator = cursor.take().text
                factors.append((operator, self.factor()))
            elif cursor.sees_kind(Kind.NAME) or cursor.sees("("):
                unclear, tight = self.exponent_is_unclear(before), cursor.token.at == cursor.last.end
                following = self.factor()
                if operator == "/":
                    if self.decide is None:
                        raise refusals.product_after_division(cursor, start, before, following)
                    factors.append(("/" if self.decide(Doubt.PRODUCT) else "*", following))
                elif unclear and isinstance(before, Power):
                    if self.decide is None:
                        raise refusals.unclear_exponent(cursor, before, following)
                    certain = tight and isinstance(following, Name) and _is_e(before.base)
                    if not self.ends_exponent(following) and (certain or self.decide(Doubt.EXPONENT)):
                        factors[-1] = (operator, _with_exponent(before, following))
                    else:
                        factors.append(("*", following))
                else:
                    factors.append(("*", following))
            elif cursor.sees_kind(Kind.NUMBER):
                raise refusals.operator_missing(cursor, before)
            else:
                break
        return factors[0][1] if len(factors) == 1 else Product(start, cursor.last.end, tuple(factors))

    def exponent_is_unclear(self, before: Node) -> bool:
        """Whether what follows may belong to the exponent just read: e^-2t, e^2t, x^n(t)."""
        last = self.cursor.last
        if not isinstance(before, Power) or last.kind is Kind.SUPERSCRIPT or last.text == ")":
            return False
        natural = _is_e(before.base) and self.names.is_constant("e")
        if isinstance(before.exponent, Number):
            return natural
        return isinstance(before.exponent, Sum | Product) or self.cursor.sees_adjacent("(")

    def ends_exponent(self, following: Node) -> bool:
        """Whether a factor is no part of an exponent written without brackets: e^-2 sin(t), e^-2 e^-t."""
        base = following.base if isinstance(following, Power) else following
        return isinstance(base, Call) or (_is_e(base) and self.names.is_constant("e"))

    def factor(self) -> Node:
        if not self.cursor.sees(*_SIGNS):
            return self.power()
        sign = self.cursor.take()
        if sign.text == "±":
            raise ExpressionError("± is expected between two terms or before the first", sign.at)
        operand = self.nested(self.factor)
        return Sum(sign.at, operand.end, ((sign.text, operand),))

    def power(self) -> Node:
        return self.raised(self.atom())

    def raised(self, base: Node) -> Node:
        """Read the exponent of a base, if it has one."""
        cursor = self.cursor
        if cursor.sees_kind(Kind.SUPERSCRIPT):
            token = cursor.take()
            exponent: Node = Number(token.at, token.end, exact_number(token))
            if cursor.sees("^"):
                length = cursor.token.end - token.at
                raise ExpressionError("unclear: two exponents", token.at, length, "x^(2^3) or (x^2)^3")
        elif cursor.sees("^"):
            cursor.take()
            exponent = self.nested(self.factor)
        else:
            return base
        return Power(base.at, cursor.last.end, base, exponent)

    def atom(self) -> Node:
        token = self.cursor.token
        if token.kind is Kind.NUMBER:
            self.cursor.take()
            if token.text in ("1", "1.0") and self.cursor.sees("("):
                self.check_late(token)
            return Number(token.at, token.end, exact_number(token), token.at)
        if token.kind is Kind.NAME:
            return self.name()
        if self.cursor.sees("("):
            return self.group()
        raise refusals.operand_missing(self.cursor)

    def group(self, function: Token | None = None) -> Node:
        """Read ( sum ) and return what is inside, with the place of the brackets; `function` stands before it."""
        cursor = self.cursor
        opening = cursor.take()
        inside = self.nested(self.sum)
        if cursor.sees(",") and function is not None:
            raise refusals.one_argument(cursor, function)
        if not cursor.sees(")"):
            raise refusals.not_closed(cursor, opening)
        return replace(inside, at=opening.at, end=cursor.take().end)

    def name(self) -> Node:
        token = self.cursor.take()
        if token.text in self.names.functions:
            return self.signal(token)
        if self.cursor.sees_adjacent("'"):
            if token.text == "delta" and self.names.impulses and not self.names.declares("delta"):
                return self.call(token, self.primes(token))
            raise prime_refused(token, self.names, self.cursor.token.end)
        if token.text in FUNCTIONS and not self.names.declares(token.text):
            if self.cursor.sees("("):
                return self.call(token)
            if token.text != "delta":  # without an argument it is the Greek letter
                if self.decide is None or token.text in ("step", "inv"):
                    raise refusals.argument_missing(self.cursor, token)
                return bare_call(self, token, self.decide)
        if (at_a_time := self.at_a_time(token)) is not None:
            return at_a_time
        check_name(token, self.names)
        if self.cursor.sees_adjacent("("):
            check_call(token, self.names, self.cursor.after(2))
        if self.cursor.sees("("):
            self.check_late(token)
        return Name(token.at, token.end, token.text)

    def at_a_time(self, token: Token) -> Name | None:
        """Read y(k+1) where a symbol is called so, as the states of a difference equation are."""
        cursor, end = self.cursor, self.cursor.text.find(")", token.end) + 1
        name = "".join(cursor.text[token.at : end].split())
        if not cursor.sees_adjacent("(") or name not in self.names.symbols:
            return None
        while cursor.take().end < end:
            pass
        return Name(token.at, end, name)

    def check_late(self, token: Token) -> None:
        """Refuse u(t - 1) and 1(t) in a problem file; in an answer, a(t - 1) is a product."""
        if self.decide is None:
            check_late(token, self.names, self.cursor.after(MAX_TOKENS), self.cursor.text)

    def signal(self, token: Token) -> Node:
        """Read a function of time: x, x'', x(k+2)."""
        cursor, primes = self.cursor, self.primes(token)
        if not primes and self.is_order():
            primes = self.order()
        argument = self.group(token) if cursor.sees_adjacent("(") else None
        return Signal(token.at, cursor.last.end, token.text, primes, argument)

    def primes(self, token: Token) -> int:
        """Read the primes after a name."""
        cursor, primes = self.cursor, 0
        while cursor.sees_adjacent("'"):
            cursor.take()
            primes += 1
        if primes > MAX_PRIMES:
            raise ExpressionError(f"at most {MAX_PRIMES} primes can be read", token.at, cursor.last.end - token.at)
        return primes

    def is_order(self) -> bool:
        """Whether the order of a derivative follows: x^(4) is the fourth derivative, x^4 a power."""
        if not self.cursor.sees_adjacent("^"):
            return False
        opening, number, closing = [*self.cursor.after(3), *[self.cursor.tokens[-1]] * 3][:3]
        return opening.text == "(" and number.text.isdigit() and closing.text == ")"

    def order(self) -> int:
        """Read ^(4)."""
        digits = [self.cursor.take() for _ in range(4)][2]
        if int(digits.text) > MAX_PRIMES:
            message = f"derivatives are read up to order {MAX_PRIMES}"
            raise ExpressionError(message, digits.at, digits.end - digits.at)
        return int(digits.text)

    def call(self, token: Token, order: int = 0) -> Node:
        if not self.cursor.sees("("):
            raise refusals.argument_missing(self.cursor, token)
        argument = self.group(token)
        return Call(token.at, self.cursor.last.end, FUNCTIONS[token.text], argument, order)


def _is_e(node: Node) -> bool:
    return isinstance(node, Name) and node.name == "e"


def _with_exponent(power: Power, factor: Node) -> Power:
    """Return e^(-2 t) of e^-2 and t."""
    exponent = Product(power.exponent.at, factor.end, (("*", power.exponent), ("*", factor)))
    return replace(power, end=factor.end, exponent=exponent)
