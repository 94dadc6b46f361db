"""How large an expression gets when it is multiplied out, judged on its syntax tree. Needs no algebra.

The builder multiplies nothing out, but those who use the expression do, and so does sympy when it is asked for the
sign or the real part of the argument of a function. So the whole is bounded as a quotient of polynomials, and
arguments of functions more closely.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from solver.problem.expressions.errors import ExpressionError
from solver.problem.expressions.names import Names
from solver.problem.expressions.syntax import Call, Name, Node, Number, Power, Product, Signal, Sum

MAX_DEGREE = 64
MAX_TERMS = 5000
MAX_INNER_DEGREE = 6
MAX_INNER_TERMS = 40
MAX_HYPERBOLIC_DEGREE = 2
HYPERBOLIC = frozenset({"sinh", "cosh", "tanh"})  # sympy splits their arguments into real and imaginary parts
MAX_NESTING = 3
MAX_CALLS = 40

Atoms = frozenset[str]


@dataclass(frozen=True, slots=True)
class Polynomial:
    """A polynomial of at most this total degree and number of terms."""

    degree: int = 0
    terms: int = 1

    def over(self, atoms: Atoms) -> Polynomial:
        """The same, with no more terms than a polynomial of its degree in so many unknowns can have."""
        if self.terms <= 2:
            return self
        return Polynomial(self.degree, min(self.terms, math.comb(self.degree + len(atoms), len(atoms))))


ONE = Polynomial()


@dataclass(frozen=True, slots=True)
class Shape:
    """A quotient of polynomials in the `atoms`: symbols, irrational constants, and functions.

    `nesting` is the number of functions within each other.
    """

    above: Polynomial = ONE
    below: Polynomial = ONE
    atoms: Atoms = frozenset()
    nesting: int = 0

    @property
    def degree(self) -> int:
        """The larger of the degrees of numerator and denominator."""
        return max(self.above.degree, self.below.degree)

    @property
    def terms(self) -> int:
        """The larger of the numbers of terms of numerator and denominator."""
        return max(self.above.terms, self.below.terms)


def atom(name: str, nesting: int = 0) -> Shape:
    """Return the shape of a symbol or a function's value."""
    return Shape(Polynomial(1), ONE, frozenset({name}), nesting)


def check_shape(node: Node, names: Names) -> None:
    """Raise ExpressionError, with the place, if the expression is too large to be worked with."""
    _Shapes(names).shape(node)


class _Shapes:
    """Shapes of the parts of one expression; each rule raises an error where a limit is passed."""

    def __init__(self, names: Names) -> None:
        self.names = names
        self.calls = 0

    def shape(self, node: Node) -> Shape:
        result = _RULES[type(node)](self, node)
        if result.degree > MAX_DEGREE:
            raise _error(f"the degree is more than {MAX_DEGREE}", node)
        if result.terms > MAX_TERMS:
            raise _error(f"multiplied out, this may have more than {MAX_TERMS} terms", node)
        return result

    def number(self, _: Number) -> Shape:
        return Shape()

    def name(self, node: Name) -> Shape:
        value = self.names.variables.get(node.name, self.names.values.get(node.name))
        return Shape() if value is not None and value.is_Rational else atom(node.name)

    def signal(self, node: Signal) -> Shape:
        if node.argument is None:
            return atom(node.name + "'" * node.order)
        return self.inner(node.argument, node, "argument")

    def call(self, node: Call) -> Shape:
        degree = MAX_HYPERBOLIC_DEGREE if node.function in HYPERBOLIC else MAX_INNER_DEGREE
        return self.inner(node.argument, node, "argument", degree)

    def sum(self, node: Sum) -> Shape:
        shapes = [self.shape(term) for _, term in node.terms]
        atoms = _atoms(shapes)
        below = _product([shape.below for shape in shapes], atoms)
        degree = max(shape.above.degree - shape.below.degree for shape in shapes) + below.degree
        terms = sum(shape.above.terms * (below.terms // shape.below.terms) for shape in shapes)
        return Shape(Polynomial(degree, terms).over(atoms), below, atoms, _nesting(shapes))

    def product(self, node: Product) -> Shape:
        shapes = [(operator, self.shape(factor)) for operator, factor in node.factors]
        every = [shape for _, shape in shapes]
        atoms = _atoms(every)
        above = _product([shape.above if operator == "*" else shape.below for operator, shape in shapes], atoms)
        below = _product([shape.below if operator == "*" else shape.above for operator, shape in shapes], atoms)
        return Shape(above, below, atoms, _nesting(every))

    def power(self, node: Power) -> Shape:
        n = _whole(node.exponent)
        natural = isinstance(node.base, Name) and node.base.name == "e" and self.names.is_constant("e")
        if n is None or natural:
            return self.other_power(node)
        base = self.shape(node.base)
        if abs(n) > MAX_DEGREE and self.names.is_matrix(node.base):
            whole = Polynomial(MAX_DEGREE)  # by itself, in sums with other powers
            return Shape(*((whole, ONE) if n >= 0 else (ONE, whole)), base.atoms)
        above, below = (_power(part, abs(n)).over(base.atoms) for part in (base.above, base.below))
        return Shape(*((above, below) if n >= 0 else (below, above)), base.atoms, base.nesting)

    def other_power(self, node: Power) -> Shape:
        """A root, or a power with symbols in its exponent."""
        exponent = self.inner(node.exponent, node, "exponent")
        base = self.inner(node.base, node, "base")
        return max(base, exponent, key=lambda shape: shape.nesting)

    def inner(self, inside: Node, node: Node, what: str, degree: int = MAX_INNER_DEGREE) -> Shape:
        """The shape of a function's value; `inside` is its argument, of at most this degree."""
        shape = self.shape(inside)
        if shape.degree > degree or shape.terms > MAX_INNER_TERMS:
            raise _error(f"the {what} is too long here: its degree is at most {degree}", inside)
        self.calls += 1
        if self.calls > MAX_CALLS:
            raise _error(f"the expression has more than {MAX_CALLS} functions and roots", node)
        if shape.nesting >= MAX_NESTING:
            raise _error(f"more than {MAX_NESTING} functions stand within each other", node)
        root_of_number = not shape.atoms and _is_root(node)
        return atom(f"#{inside.at}", 0 if root_of_number else shape.nesting + 1)


def _whole(node: Node) -> int | None:
    """The exponent, if it is written as a whole number."""
    if isinstance(node, Number):
        return int(node.value) if node.value.denominator == 1 else None
    if isinstance(node, Sum) and len(node.terms) == 1 and node.terms[0][0] in "+-":
        sign, term = node.terms[0]
        n = _whole(term)
        return n if n is None or sign == "+" else -n
    return None


def _is_root(node: Node) -> bool:
    return isinstance(node, Power) or (isinstance(node, Call) and node.function == "sqrt")


def _atoms(shapes: Sequence[Shape]) -> Atoms:
    return frozenset().union(*(shape.atoms for shape in shapes))


def _nesting(shapes: Sequence[Shape]) -> int:
    return max(shape.nesting for shape in shapes)


def _product(parts: Sequence[Polynomial], atoms: Atoms) -> Polynomial:
    """The product of polynomials."""
    return Polynomial(sum(part.degree for part in parts), math.prod(part.terms for part in parts)).over(atoms)


def _power(part: Polynomial, n: int) -> Polynomial:
    """The n-th power of a polynomial; n is bounded elsewhere."""
    n = min(n, MAX_DEGREE)
    return Polynomial(part.degree * n, math.comb(part.terms + n - 1, n))


def _error(message: str, node: Node) -> ExpressionError:
    return ExpressionError(message, node.at, node.end - node.at)


_RULES: dict[type[Node], Callable[[_Shapes, Any], Shape]] = {
    Number: _Shapes.number,
    Name: _Shapes.name,
    Signal: _Shapes.signal,
    Sum: _Shapes.sum,
    Product: _Shapes.product,
    Power: _Shapes.power,
    Call: _Shapes.call,
}
