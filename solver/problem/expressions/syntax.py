"""The syntax tree of an expression. Every node knows its place in the text: from `at` to before `end`."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True, slots=True)
class Node:
    """A part of an expression."""

    at: int
    end: int


@dataclass(frozen=True, slots=True)
class Number(Node):
    """A number, exactly as written; `place` is where it stands in the text, -1 where it is part of something."""

    value: Fraction
    place: int = -1


@dataclass(frozen=True, slots=True)
class Name(Node):
    """A symbol, a variable or a constant."""

    name: str


@dataclass(frozen=True, slots=True)
class Signal(Node):
    """A function of time: x, its derivative x'' (`order` 2), or x(k+2), where `argument` is what stands in brackets."""

    name: str
    order: int
    argument: Node | None


@dataclass(frozen=True, slots=True)
class Call(Node):
    """One of the functions of the notation; an impulse may be a derivative, δ'(t) (`order` 1)."""

    function: str
    argument: Node
    order: int = 0


@dataclass(frozen=True, slots=True)
class Sum(Node):
    """Terms with their signs, "+", "-" or "±"; also a single term with a sign."""

    terms: tuple[tuple[str, Node], ...]


@dataclass(frozen=True, slots=True)
class Product(Node):
    """Factors with their operators, "*" or "/", read from the left: a/b*c is (a/b)*c."""

    factors: tuple[tuple[str, Node], ...]


@dataclass(frozen=True, slots=True)
class Power(Node):
    """A base to an exponent."""

    base: Node
    exponent: Node
