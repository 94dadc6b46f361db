r"""Formulas as trees: what stands where, as on paper, without saying what it means.

A node is known by what it is drawn as: `Fraction` may be a quotient or a derivative, `Row` a sum or a product. Commands
stand in it as LaTeX spells them (`\lambda`, `\le`, `\dfrac`), so that a tree can be written down again. A `Row` that is
an argument or a script is written in braces, any other node there without: `x_{1}` and `x_1` are two trees.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass, field
from typing import Any, ClassVar, Generic, TypeVar

T = TypeVar("T")


class Node:
    """A part of a formula."""

    __slots__ = ()
    __match_args__: ClassVar[tuple[str, ...]] = ()

    def accept(self, visitor: Visitor[T]) -> T:
        """Return what the visitor makes of this node; each kind calls its own method of the visitor."""
        raise NotImplementedError


@dataclass(frozen=True, slots=True)
class Number(Node):
    """Digits, perhaps with a decimal point: `36`, `0.25`. A sign is an operator before it."""

    digits: str

    def accept(self, visitor: Visitor[T]) -> T:
        return visitor.number(self)


@dataclass(frozen=True, slots=True)
class Symbol(Node):
    r"""A letter or what is set like one: `x`, `\lambda`, `\infty`, `\ell`."""

    name: str

    def accept(self, visitor: Visitor[T]) -> T:
        return visitor.symbol(self)


@dataclass(frozen=True, slots=True)
class Operator(Node):
    r"""A sign between or before operands: `+`, `=`, `\le`, `\sum`, `,`; a bracket or bar that has no partner."""

    sign: str

    def accept(self, visitor: Visitor[T]) -> T:
        return visitor.operator(self)


@dataclass(frozen=True, slots=True)
class Function(Node):
    r"""The name of a function: `\sin`, `\det`, `\lim`; `named` tells that it is spelled `\operatorname{adj}`."""

    name: str
    named: bool = False

    def accept(self, visitor: Visitor[T]) -> T:
        return visitor.function(self)


@dataclass(frozen=True, slots=True)
class Text(Node):
    r"""Words: `\text{and}`, `\textbf{if}`."""

    words: str
    command: str = r"\text"

    def accept(self, visitor: Visitor[T]) -> T:
        return visitor.text(self)


@dataclass(frozen=True, slots=True)
class Space(Node):
    r"""A gap (`\,`, `\quad`), or a change of size from here on (`\displaystyle`)."""

    command: str

    def accept(self, visitor: Visitor[T]) -> T:
        return visitor.space(self)


@dataclass(slots=True, eq=False)
class Shared(Node):
    """A node that formulas share: it keeps what those visitors have `made` of it who ask for that.

    Nobody changes it, nor is it frozen: to make it so would take twice as long, and a page is made of many hundreds.
    """

    made: dict[Any, Any] = field(default_factory=dict, init=False, compare=False, repr=False)

    def accept(self, visitor: Visitor[T]) -> T:
        if not visitor.keeps:
            return self.visited(visitor)
        found: T | None = self.made.get(visitor)
        if found is None:
            found = self.made[visitor] = self.visited(visitor)
        return found

    def visited(self, visitor: Visitor[T]) -> T:
        """Return what the visitor makes of this node now."""
        raise NotImplementedError


@dataclass(slots=True, unsafe_hash=True)
class Row(Shared):
    """What stands side by side. A row within a row is a group in braces."""

    items: tuple[Node, ...] = ()

    def visited(self, visitor: Visitor[T]) -> T:
        return visitor.row(self)


@dataclass(slots=True, unsafe_hash=True)
class Fraction(Shared):
    r"""One above another: `\frac`, `\dfrac`, `\tfrac` with a bar, `\binom` in parentheses."""

    above: Node
    below: Node
    command: str = r"\frac"

    def visited(self, visitor: Visitor[T]) -> T:
        return visitor.fraction(self)


@dataclass(frozen=True, slots=True)
class Root(Node):
    """A root, the second where there is no index."""

    radicand: Node
    index: Row | None = None

    def accept(self, visitor: Visitor[T]) -> T:
        return visitor.root(self)


@dataclass(slots=True, unsafe_hash=True)
class Scripts(Shared):
    """A base with an index below, an exponent above, or primes (then without an exponent)."""

    base: Node
    below: Node | None = None
    above: Node | None = None
    primes: int = 0

    def visited(self, visitor: Visitor[T]) -> T:
        return visitor.scripts(self)


@dataclass(frozen=True, slots=True)
class Fenced(Node):
    r"""What stands between brackets; `tall` ones are as high as it (`\left( \right)`), and may be "." for none."""

    left: str
    body: Row
    right: str
    tall: bool = False

    def accept(self, visitor: Visitor[T]) -> T:
        return visitor.fenced(self)


@dataclass(slots=True, unsafe_hash=True)
class Table(Shared):
    r"""Rows of cells: a matrix, `cases`, `aligned`, or an `array` with its `columns` ("cc|c").

    A line stands above each of the rows `rules`, counted from 0.
    """

    environment: str
    rows: tuple[tuple[Row, ...], ...]
    columns: str = ""
    rules: tuple[int, ...] = ()

    def visited(self, visitor: Visitor[T]) -> T:
        return visitor.table(self)


@dataclass(frozen=True, slots=True)
class Accent(Node):
    r"""A mark above or below: `\dot`, `\hat`, `\overline`, `\underline`."""

    command: str
    body: Node

    def accept(self, visitor: Visitor[T]) -> T:
        return visitor.accent(self)


@dataclass(frozen=True, slots=True)
class Stacked(Node):
    r"""A small mark above or below a base: `\overset`, `\underset`."""

    command: str
    mark: Node
    base: Node

    def accept(self, visitor: Visitor[T]) -> T:
        return visitor.stacked(self)


@dataclass(frozen=True, slots=True)
class Styled(Node):
    r"""What is set in another alphabet (`\mathrm`, `\mathcal`) or in a frame (`\boxed`)."""

    command: str
    body: Node

    def accept(self, visitor: Visitor[T]) -> T:
        return visitor.styled(self)


class Visitor(ABC, Generic[T]):
    """Makes something of a tree; one method for each kind of node, so that none can be forgotten.

    Where it `keeps`, nodes that are shared remember what it made: it is one of few, and always makes the same.
    """

    keeps: ClassVar[bool] = False

    @abstractmethod
    def number(self, node: Number) -> T: ...
    @abstractmethod
    def symbol(self, node: Symbol) -> T: ...
    @abstractmethod
    def operator(self, node: Operator) -> T: ...
    @abstractmethod
    def function(self, node: Function) -> T: ...
    @abstractmethod
    def text(self, node: Text) -> T: ...
    @abstractmethod
    def space(self, node: Space) -> T: ...
    @abstractmethod
    def row(self, node: Row) -> T: ...
    @abstractmethod
    def fraction(self, node: Fraction) -> T: ...
    @abstractmethod
    def root(self, node: Root) -> T: ...
    @abstractmethod
    def scripts(self, node: Scripts) -> T: ...
    @abstractmethod
    def fenced(self, node: Fenced) -> T: ...
    @abstractmethod
    def table(self, node: Table) -> T: ...
    @abstractmethod
    def accent(self, node: Accent) -> T: ...
    @abstractmethod
    def stacked(self, node: Stacked) -> T: ...
    @abstractmethod
    def styled(self, node: Styled) -> T: ...
