"""The parser: tokens to a syntax tree, by recursive descent with a bound on depth. Needs no algebra.

    sum     = [sign] product { sign product }             sign: + - ±
    product = factor { ("*" | "/" | nothing) factor }     "nothing" only before a name or "(", never after "/"
    factor  = [sign] power
    power   = atom [ "^" factor | superscript ]           x^2^3 is x^(2^3), -x^2 is -(x^2)
    atom    = number | name | function "(" sum ")" | signal primes [ "(" sum ")" ] | "(" sum ")"

What an engineer could read in two ways is refused, and both ways are named.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from solver.problem.expressions.errors import ExpressionError
from solver.problem.expressions.names import Names
from solver.problem.expressions.notation import FUNCTIONS, MAX_DEPTH, MAX_PRIMES
from solver.problem.expressions.syntax import Call, Name, Node, Number, Power, Product, Signal, Sum
from solver.problem.expressions.tokens import Kind, Token, exact_number, tokenize
from solver.problem.expressions.vocabulary import check_name, refuse_call, refuse_prime

_SIGNS = ("+", "-", "±")


def parse(text: str, names: Names, *, alternatives: bool = False) -> Node:
    """Return the syntax tree of an expression; only with `alternatives` may it hold a ±, and one at most."""
    parser = _Parser(text, names, alternatives)
    node = parser.sum()
    parser.expect_end("an equation stands where an expression is expected")
    return node


def parse_sides(text: str, names: Names) -> tuple[Node, Node]:
    """Return the syntax trees of the two sides of an equation."""
    parser = _Parser(text, names, alternatives=False)
    left = parser.sum()
    if not parser.sees("="):
        parser.expect_end("")
        raise ExpressionError("an equation is expected: the sign = is missing", len(text), 1, f"{text.strip()} = 0")
    equals = parser.take()
    if parser.sees("="):
        raise ExpressionError("one sign = is enough", equals.at, 2, "=")
    right = parser.sum()
    parser.expect_end("an equation has one sign =")
    return left, right


class _Parser:
    """The tokens of a text and how far they have been read."""

    def __init__(self, text: str, names: Names, alternatives: bool) -> None:
        self.text = text
        self.names = names
        self.tokens = tokenize(text)
        self.position = 0
        self.depth = 0
        self.alternatives = alternatives

    # Reading tokens

    @property
    def token(self) -> Token:
        return self.tokens[self.position]

    @property
    def last(self) -> Token:
        return self.tokens[self.position - 1]

    def take(self) -> Token:
        self.position += 1
        return self.last

    def sees(self, *signs: str) -> bool:
        return self.token.kind is Kind.OPERATOR and self.token.text in signs

    def sees_adjacent(self, *signs: str) -> bool:
        """Whether one of the signs follows without a space."""
        return self.sees(*signs) and self.token.at == self.last.end

    def written(self, node: Node) -> str:
        return self.text[node.at : node.end]

    def nested(self, rule: Callable[[], Node]) -> Node:
        """Apply a rule one level deeper."""
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise ExpressionError(f"the expression is nested deeper than {MAX_DEPTH} levels", self.token.at)
        node = rule()
        self.depth -= 1
        return node

    def expect_end(self, if_equation: str) -> None:
        """Raise an error unless all tokens are read."""
        token = self.token
        if token.kind is Kind.END:
            return
        length = token.end - token.at
        if self.sees("="):
            raise ExpressionError(if_equation, token.at, length)
        if self.sees(")"):
            raise ExpressionError("this ) closes no (", token.at, length)
        if self.sees(","):
            raise self.stray_comma()
        if self.sees("'"):
            raise ExpressionError("a prime is expected right after the name of a function of time", token.at, length)
        raise ExpressionError(f"{token.text} is not expected here", token.at, length)

    def stray_comma(self) -> ExpressionError:
        """The error for a comma, which in this place may be meant as a decimal point."""
        before, comma, after = self.tokens[max(0, self.position - 1)], self.token, self.tokens[self.position + 1]
        if before.kind is after.kind is Kind.NUMBER:
            suggestion = f"{before.text}.{after.text}"
            return ExpressionError(
                "numbers are written with a decimal point", before.at, after.end - before.at, suggestion
            )
        return ExpressionError("a comma is not expected here", comma.at)

    # The rules

    def sum(self) -> Node:
        start = self.token.at
        terms: list[tuple[str, Node]] = []
        sign = self.sign() if self.sees(*_SIGNS) else "+"
        signed = sign != "+"
        while True:
            terms.append((sign, self.product()))
            if not self.sees(*_SIGNS):
                break
            sign = self.sign()
        if len(terms) == 1 and not signed:
            return terms[0][1]
        return Sum(start, self.last.end, tuple(terms))

    def sign(self) -> str:
        """Take the sign of a term."""
        token = self.take()
        if token.text == "±":
            self.plus_minus(token)
        if token.text in "+-" and self.sees_adjacent("-", "+") and self.token.text != token.text:
            message = f"unclear: {token.text}{self.token.text} may be one sign or two"
            raise ExpressionError(message, token.at, 2, f"± or {token.text}({self.token.text}...)")
        return token.text

    def plus_minus(self, token: Token) -> None:
        if not self.alternatives:
            raise ExpressionError("± stands for two values, and is read only in lists of poles", token.at)
        if any(each.text == "±" for each in self.tokens[: self.position - 1]):
            raise ExpressionError("one ± is the most an expression may hold", token.at)

    def product(self) -> Node:
        start = self.token.at
        factors: list[tuple[str, Node]] = [("*", self.factor())]
        while True:
            if self.sees("*", "/"):
                operator = self.take().text
                factors.append((operator, self.factor()))
            elif self.token.kind is Kind.NAME or self.sees("("):
                if factors[-1][0] == "/":
                    raise self.product_after_division(start, factors[-1][1])
                self.refuse_unclear_exponent(factors[-1][1])
                factors.append(("*", self.factor()))
            elif self.token.kind is Kind.NUMBER:
                raise self.missing_operator(factors[-1][1])
            else:
                break
        if len(factors) == 1:
            return factors[0][1]
        return Product(start, self.last.end, tuple(factors))

    def product_after_division(self, start: int, divisor: Node) -> ExpressionError:
        """The error for 1/2x."""
        before, following = self.text[start : divisor.at].rstrip().removesuffix("/").rstrip(), self.factor()
        by, then = self.written(divisor), self.written(following)
        message = "unclear: a product without a sign follows a division"
        suggestion = f"{before}/({by}*{then}) or ({before}/{by})*{then}"
        return ExpressionError(message, divisor.at, following.end - divisor.at, suggestion)

    def missing_operator(self, before: Node) -> ExpressionError:
        """The error for 10 000 and for x 2."""
        number = self.token
        written = self.written(before)
        joined = f"{written}{number.text} or " if isinstance(before, Number) else ""
        length = number.end - before.at
        return ExpressionError(
            "an operator is missing before this number", number.at, length - (number.at - before.at),
            f"{joined}{written}*{number.text}",
        )  # fmt: skip

    def refuse_unclear_exponent(self, before: Node) -> None:
        """Refuse e^-2t, e^2t and x^n(t), where the exponent may end before or after what follows."""
        if not isinstance(before, Power) or self.last.kind is Kind.SUPERSCRIPT or self.last.text == ")":
            return
        natural = isinstance(before.base, Name) and before.base.name == "e" and not self.names.declares("e")
        number, signed = isinstance(before.exponent, Number), isinstance(before.exponent, Sum)
        if signed or (natural and number) or (isinstance(before.exponent, Name) and self.sees_adjacent("(")):
            base, exponent = self.written(before.base), self.written(before.exponent)
            following = self.factor()
            then = self.written(following)
            raise ExpressionError(
                "unclear: where does the exponent end?", before.at, following.end - before.at,
                f"{base}^({exponent}*{then}) or {base}^({exponent})*{then}",
            )  # fmt: skip

    def factor(self) -> Node:
        if not self.sees(*_SIGNS):
            return self.power()
        sign = self.take()
        if sign.text == "±":
            raise ExpressionError("± is expected between two terms or before the first", sign.at)
        operand = self.nested(self.factor)
        return Sum(sign.at, operand.end, ((sign.text, operand),))

    def power(self) -> Node:
        base = self.atom()
        if self.token.kind is Kind.SUPERSCRIPT:
            token = self.take()
            exponent: Node = Number(token.at, token.end, exact_number(token))
            if self.sees("^") or self.token.kind is Kind.SUPERSCRIPT:
                raise ExpressionError(
                    "unclear: two exponents", token.at, self.token.end - token.at, "x^(2^3) or (x^2)^3"
                )
        elif self.sees("^"):
            self.take()
            exponent = self.nested(self.factor)
        else:
            return base
        return Power(base.at, self.last.end, base, exponent)

    def atom(self) -> Node:
        token = self.token
        if token.kind is Kind.NUMBER:
            self.take()
            return Number(token.at, token.end, exact_number(token))
        if token.kind is Kind.NAME:
            return self.name()
        if self.sees("("):
            return self.group()
        raise self.operand_missing()

    def operand_missing(self) -> ExpressionError:
        token = self.token
        length = token.end - token.at
        if self.position and self.last.text == "(" and self.sees(")"):
            return ExpressionError("an expression is expected between ( and )", self.last.at, token.end - self.last.at)
        if self.position and self.last.kind is Kind.OPERATOR:
            return ExpressionError(f"a number, a name or ( is expected after {self.last.text}", token.at, length)
        if self.sees("'", ",") or token.kind is Kind.SUPERSCRIPT:
            return ExpressionError(f"a number, a name or ( is expected before {token.text}", token.at, length)
        return ExpressionError("an expression is expected: a number, a name or (", token.at, length)

    def group(self) -> Node:
        """( sum ): the node inside, with the place of the brackets."""
        opening = self.take()
        inside = self.nested(self.sum)
        if self.sees(","):
            raise self.stray_comma()
        if not self.sees(")"):
            if self.token.kind is not Kind.END:
                self.expect_end("an equation has its sign = outside brackets")
            raise ExpressionError("this ( is not closed: ) is expected", opening.at, 1, f"{self.text.rstrip()})")
        return replace(inside, at=opening.at, end=self.take().end)

    def name(self) -> Node:
        token = self.take()
        primes = 0
        while self.sees_adjacent("'") or (primes and self.sees("'") and self.token.at == self.last.at):
            self.take()
            primes += 1
        if token.text in self.names.functions:
            return self.signal(token, primes)
        if primes:
            raise refuse_prime(token, self.names, self.last.end)
        if token.text in FUNCTIONS and not self.names.declares(token.text):
            if self.sees("("):
                return self.call(token)
            if token.text != "delta":  # without an argument it is the Greek letter
                raise self.argument_missing(token)
        check_name(token, self.names)
        if self.sees_adjacent("("):
            refuse_call(token, self.names, self.tokens[self.position + 1 : self.position + 3])
        return Name(token.at, token.end, token.text)

    def signal(self, token: Token, primes: int) -> Node:
        """A function of time: x, x'', x(k+2)."""
        if primes > MAX_PRIMES:
            raise ExpressionError(f"a derivative has at most {MAX_PRIMES} primes", token.at, self.last.end - token.at)
        argument = self.group() if self.sees_adjacent("(") else None
        return Signal(token.at, self.last.end, token.text, primes, argument)

    def call(self, token: Token) -> Node:
        if self.tokens[self.position + 1].text == ")":
            self.take()
            self.take()
            raise ExpressionError(
                f"{token.text} needs an argument", token.at, self.last.end - token.at, f"{token.text}(x)"
            )
        argument = self.argument(token)
        return Call(token.at, self.last.end, FUNCTIONS[token.text], argument)

    def argument(self, token: Token) -> Node:
        try:
            return self.group()
        except ExpressionError as error:
            if error.message.startswith("a comma"):
                suggestion = "log(x)/log(10)" if token.text in ("log", "ln") else f"{token.text}(x)"
                raise ExpressionError(f"{token.text} takes one argument", error.at, 1, suggestion) from None
            raise

    def argument_missing(self, token: Token) -> ExpressionError:
        """The error for sin x and for sin^2(x)."""
        power = self.sees("^") or self.token.kind is Kind.SUPERSCRIPT
        suggestion = f"{token.text}(...)^2" if power else f"{token.text}(...)"
        message = f"{token.text} is a function: its argument is expected in brackets"
        return ExpressionError(message, token.at, token.end - token.at, suggestion)
