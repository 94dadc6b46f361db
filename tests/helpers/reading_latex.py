"""Reads our LaTeX back as a number: the meaning of a printed formula, found by other means than the printer's.

A recursive-descent reader of the dialect: sums, products by juxtaposition, powers, fractions, roots, functions.
"""

import cmath
import re

TOKEN = re.compile(r"\\left|\\right|\\[A-Za-z]+(?:_(?:\w|\{\w+\}))?|\d+(?:\.\d+)?|[A-Za-z](?:_(?:\w|\{\w+\}))?|\S")
FUNCTIONS = {r"\cos": cmath.cos, r"\sin": cmath.sin, r"\ln": cmath.log, r"\cosh": cmath.cosh, r"\sinh": cmath.sinh}
STOPS = {"", "+", "-", ")", "}", "]", r"\right"}


def value_of(latex, point):
    """The number that a printed formula stands for; `point` gives the symbols as they are printed."""
    reader = Reader(TOKEN.findall(latex), point)
    value = reader.sum()
    assert reader.peek() == "", f"{latex}: {reader.tokens[reader.index :]} is left"
    return value


class Reader:
    def __init__(self, tokens, point):
        self.tokens, self.index, self.point = tokens, 0, point

    def peek(self):
        return self.tokens[self.index] if self.index < len(self.tokens) else ""

    def take(self, expected=None):
        token = self.peek()
        assert expected in (None, token), (token, expected, self.tokens)
        self.index += 1
        return token

    def sum(self):
        negative = self.peek() == "-" and bool(self.take())
        value = -self.product() if negative else self.product()
        while self.peek() in {"+", "-"}:
            value = value + self.product() if self.take() == "+" else value - self.product()
        return value

    def product(self):
        value = self.power()
        while self.peek() not in STOPS:
            if self.peek() == "/":
                self.take()
                value /= self.power()
            else:
                if self.peek() == r"\cdot":
                    self.take()
                value *= self.power()
        return value

    def power(self):
        token = self.peek()
        if token in FUNCTIONS:
            self.take()
            exponent = self.exponent() if self.peek() == "^" else 1
            return FUNCTIONS[token](self.atom()) ** exponent
        base = self.atom()
        if self.peek() != "^":
            return base
        exponent = self.exponent()
        return cmath.exp(exponent) if token == "e" else base**exponent

    def exponent(self):
        self.take("^")
        return self.group("{", "}")

    def group(self, opening, closing):
        self.take(opening)
        value = self.sum()
        self.take(closing)
        return value

    def atom(self):
        token = self.take()
        if token == r"\left":
            self.take("(")
            value = self.sum()
            self.take(r"\right")
            self.take(")")
            return value
        if token == "(":
            self.index -= 1
            return self.group("(", ")")
        if token in {r"\frac", r"\dfrac"}:
            above = self.group("{", "}")
            return above / self.group("{", "}")
        if token == r"\sqrt":
            degree = self.group("[", "]") if self.peek() == "[" else 2
            return self.group("{", "}") ** (1 / degree)
        if token[0].isdigit():
            return float(token)
        constants = {"j": 1j, "e": cmath.e, r"\pi": cmath.pi}
        return constants[token] if token in constants else self.point[token]
