"""Nested square roots: the tower of fields K ⊂ K(g₁) ⊂ K(g₁, g₂) ⊂ …, each gᵢ the root of an element of the one below.

An element is a tuple of 2ʳ elements of K, r the number of roots adjoined so far: the coefficient of Π gᵢ over the bits
of its index. A root is adjoined only where there is none in the tower already, so every level is a field.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import reduce
from operator import mul
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import NotExact, expression
from solver.exact.linear_algebra.signs import possible_signs
from solver.exact.optimal.field_roots import common_factors, known_square, root_in

Nested = tuple[Any, ...]
"""An element of the tower."""

DEEPEST = 4
"""Roots that a tower may have: beyond, nobody reads the result."""


class TooDeep(Exception):  # noqa: N818 - a refusal within the kernels
    """More nested roots than a person would write."""


class RootTower:
    """The tower over K. Elements made before a root was adjoined stay valid: missing coefficients are zero."""

    def __init__(self, K: Any, *, shortest: bool = False) -> None:
        self.K = K
        self.shortest = shortest
        self.squares: list[Nested] = []
        self.roots: list[sp.Expr] = []

    def constant(self, c: Any) -> Nested:
        """An element of K."""
        return (c,)

    def add(self, a: Nested, b: Nested) -> Nested:
        """a + b."""
        a, b = self._same(a, b)
        return tuple(x + y for x, y in zip(a, b, strict=True))

    def negative(self, a: Nested) -> Nested:
        """−a."""
        return tuple(-x for x in a)

    def scale(self, c: Any, a: Nested) -> Nested:
        """c a with c in K."""
        return tuple(c * x for x in a)

    def multiply(self, a: Nested, b: Nested) -> Nested:
        """a b, by gᵢ² = its square."""
        a, b = self._same(a, b)
        if len(a) == 1:
            return (a[0] * b[0],)
        (a0, a1), (b0, b1) = _halves(a), _halves(b)
        below = self.multiply(a0, b0)
        if any(a1) and any(b1):
            below = self.add(below, self.multiply(self.multiply(a1, b1), self._square_for(a)))
        above = self.add(self.multiply(a0, b1), self.multiply(a1, b0))
        return self._joined(below, above, len(a))

    def inverse(self, a: Nested) -> Nested:
        """1/a = (a₀ − a₁ g)/(a₀² − a₁² g²); raises ZeroDivisionError for zero."""
        if len(a) == 1:
            if not a[0]:
                raise ZeroDivisionError("inverse of zero")
            return (self.K.one / a[0],)
        a0, a1 = _halves(a)
        if not any(a1):
            return self.inverse(a0)
        norm = self.add(self.multiply(a0, a0), self.negative(self.multiply(self.multiply(a1, a1), self._square_for(a))))
        by = self.inverse(norm)
        return self._joined(self.multiply(a0, by), self.multiply(self.negative(a1), by), len(a))

    def square_root(self, a: Nested) -> Nested:
        """The positive root of an element that is positive; it is adjoined if the tower has none.

        Raises TooDeep, and NotExact where parameters leave the sign of the root open.
        """
        a = _trimmed(a)
        found = self._root(a)
        if found is not None:
            return self._positive(found)
        outside, inside = self._reduced(a)
        by = next(self._shorter(a, inside), None) if self.shortest else None
        if by is not None:
            outside, inside = self._reduced(self.multiply(a, self.multiply(by, by)))
        if len(self.roots) == DEEPEST:
            raise TooDeep
        level = len(self.squares)
        self.roots.append(sp.sqrt(self._factored(inside)))
        self.squares.append(self._padded(inside, 2**level))
        root = (*(self.K.zero for _ in range(2**level)), outside, *(self.K.zero for _ in range(2**level - 1)))
        return root if by is None else self.multiply(root, self.inverse(by))

    def _shorter(self, a: Nested, inside: Nested) -> Iterator[Nested]:
        """Roots g of the tower for which √a is written better as √(a g²)/g than with what is `inside` otherwise."""
        length = self._length(inside)
        for level, square in enumerate(self.squares):
            g = (*(self.K.zero for _ in range(2**level)), self.K.one, *(self.K.zero for _ in range(2**level - 1)))
            if not any(square[1:]) and self._length(self._reduced(self.multiply(a, square))[1]) < length:
                yield g

    def _length(self, inside: Nested) -> int:
        """How long a radicand is, where numbers count by their size."""
        if self.K.is_QQ:
            return int(max(abs(x) for x in inside))
        return len(str(self._factored(inside)))

    def expression(self, a: Nested) -> sp.Expr:
        """The element as an expression: a sum of products of roots."""
        terms = []
        for index, c in enumerate(a):
            if c:
                roots = [root for bit, root in enumerate(self.roots) if index >> bit & 1]
                terms.append(sp.Mul(expression(self.K, c), *roots))
        return sp.Add(*terms)

    def root_as_written(self, a: Nested) -> sp.Expr:
        """The root of an element of unknown sign, not adjoined."""
        outside, inside = self._reduced(_trimmed(a))
        return expression(self.K, outside) * sp.sqrt(self._factored(inside))

    def is_positive(self, a: Nested) -> bool | None:
        """Whether the value is positive; None where parameters leave it open (zero counts as not positive)."""
        if not any(a):
            return False
        value = self.expression(a)
        if not value.free_symbols:
            return bool(sp.N(value, 30) > 0)
        terms = [c for c in a if c]
        if len(terms) == 1:  # a multiple of a product of roots, which are positive
            return sign_known(expression(self.K, terms[0]))
        return sign_known(value)

    def _positive(self, a: Nested) -> Nested:
        positive = self.is_positive(a)
        if positive is None:
            opposite = self.is_positive(self.negative(a))
            if opposite:
                return self.negative(a)
            raise NotExact("optimal/sign_in_the_result", value=without_sign(sp.factor(self.expression(a))))
        return a if positive else self.negative(a)

    def _root(self, a: Nested) -> Nested | None:
        """A square root within the tower (of either sign), or None."""
        if not any(a):
            return (self.K.zero,)
        if len(a) == 1:
            root = root_in(self.K, a[0])
            if root is not None:
                return (root,)
            return self._root_above(a, 1)
        u, v = _halves(a)
        square = self._square_for(a)
        norm = self.add(self.multiply(u, u), self.negative(self.multiply(self.multiply(v, v), square)))
        w = self._root_at(norm, len(u))
        if w is not None:
            for each in (w, self.negative(w)):
                x = self._root_at(self.scale(self.K.one / self.K(2), self.add(u, each)), len(u))
                if x is not None and any(x):
                    y = self.multiply(v, self.inverse(self.scale(self.K(2), x)))
                    return self._joined(x, y, len(a))
        return self._root_above(a, len(a))

    def _root_at(self, a: Nested, size: int) -> Nested | None:
        """A root among the elements of a lower level, of `size` coefficients."""
        a = _trimmed(a)
        if len(a) > size:
            return None
        lower = RootTower(self.K)
        level = size.bit_length() - 1
        lower.squares, lower.roots = self.squares[:level], self.roots[:level]
        return lower._root(a)

    def _root_above(self, a: Nested, size: int) -> Nested | None:
        """A root that is a multiple of a generator not in a itself: √a = x gᵢ with x² = a/gᵢ²."""
        for level in range(size.bit_length() - 1, len(self.squares)):
            if len(_trimmed(self.squares[level])) > max(size, 1):
                continue
            x = self._root_at(self.multiply(a, self.inverse(_trimmed(self.squares[level]))), 2**level)
            if x is not None:
                return self._joined((self.K.zero,), x, 2 ** (level + 1))
        return None

    def _reduced(self, a: Nested) -> tuple[Any, Nested]:
        """Return c in K and b with √a = c √b, b without denominators and square factors where that can be seen."""
        outside = known_square(self.K, [x for x in a if x])
        return outside, tuple(x / outside**2 for x in a)

    def _factored(self, a: Nested) -> sp.Expr:
        """The element as an expression, with common factors that are known to be positive before a sum."""
        _, powers = common_factors(self.K, [x for x in a if x])
        factor = reduce(mul, (self.K(each) ** power for each, power in powers), self.K.one)
        return sp.Mul(*(each.as_expr() ** power for each, power in powers)) * self.expression(
            tuple(x / factor for x in a)
        )

    def _square_for(self, a: Nested) -> Nested:
        """The square of the last generator in an element of this length."""
        return self.squares[len(a).bit_length() - 2]

    def _padded(self, a: Nested, size: int) -> Nested:
        return a + tuple(self.K.zero for _ in range(size - len(a)))

    def _same(self, a: Nested, b: Nested) -> tuple[Nested, Nested]:
        size = max(len(a), len(b))
        return self._padded(a, size), self._padded(b, size)

    def _joined(self, below: Nested, above: Nested, size: int) -> Nested:
        return self._padded(below, size // 2) + self._padded(above, size // 2)


def root_of(K: Any, square: Any) -> sp.Expr:
    """The positive root of an element of K, squares taken out where signs are known."""
    tower = RootTower(K)
    return tower.expression(tower.square_root((square,)))


def sign_known(value: sp.Expr) -> bool | None:
    """Whether a value with parameters is positive; None where their signs leave it open."""
    for form in (sp.factor(value), sp.expand(value)):
        if form.is_positive is not None:
            return bool(form.is_positive)
    signs = possible_signs(value)
    return signs == {1} if len(signs) == 1 or 1 not in signs else None


def without_sign(value: sp.Expr) -> sp.Expr:
    """The value or its opposite, the one that is written without a minus."""
    return -value if value.could_extract_minus_sign() else value


def _halves(a: Nested) -> tuple[Nested, Nested]:
    return a[: len(a) // 2], a[len(a) // 2 :]


def _trimmed(a: Nested) -> Nested:
    """The element with as few coefficients as it needs."""
    while len(a) > 1 and not any(_halves(a)[1]):
        a = _halves(a)[0]
    return a
