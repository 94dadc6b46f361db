"""Putting formulas together: parentheses where needed, no more, and signs that merge.

Rows are what is put together; what stands in them already has the parentheses that it needs.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from solver.formula.nodes import (
    Accent,
    Fenced,
    Fraction,
    Function,
    Node,
    Number,
    Operator,
    Root,
    Row,
    Scripts,
    Space,
    Styled,
    Symbol,
    Table,
    Text,
)
from solver.formula.reading import read
from solver.formula.vocabulary import LARGE

PLUS, MINUS, TIMES = Operator("+"), Operator("-"), Operator(r"\cdot")
THIN_SPACE = Space(r"\,")
DOTS = frozenset((r"\dot", r"\ddot", r"\dddot"))
"""Marks under which a name stays a name: the square of a derivative needs no parentheses."""
_LEAVES = frozenset((Function, Number, Operator, Space, Symbol, Text))
_IN_SUMS = frozenset(("+", "-", r"\pm", r"\otimes", r"\circ", r"\ast", r"\approx", "="))


def row(*parts: Node | str) -> Row:
    """Return parts side by side; of a row what stands in it, of a text (fixed LaTeX) what is read in it."""
    items: list[Node] = []
    for part in parts:
        node = read(part) if isinstance(part, str) else part
        items.extend(node.items if isinstance(node, Row) else (node,))
    return Row(tuple(items))


def separated(rows: Iterable[Row], *between: Node) -> Row:
    """Return rows side by side with something between them."""
    parts = [part for each in rows for part in (*between, each)]
    return row(*parts[len(between) :])


def parenthesized(body: Row) -> Fenced:
    """Put parentheses around, as high as what they hold."""
    return Fenced("(", body, ")", tall=any(map(_is_tall, walk(body))))


def walk(node: Node) -> Iterator[Node]:
    """Yield a node and all that it is made of."""
    left = [node]
    while left:
        each = left.pop()
        yield each
        if type(each) not in _LEAVES:
            left.extend(reversed(_parts(each)))


def _parts(node: Node) -> Sequence[Node]:
    if isinstance(node, Row):
        return node.items
    if isinstance(node, Table):
        return [cell for row in node.rows for cell in row]
    values = [getattr(node, name) for name in node.__match_args__]
    return [value for value in values if isinstance(value, Node)]


def _is_tall(node: Node) -> bool:
    if isinstance(node, Operator):
        return node.sign in LARGE
    return isinstance(node, Fraction | Table) or (isinstance(node, Fenced) and node.tall)


def is_sum(formula: Row) -> bool:
    """Whether a formula must stand in parentheses as a factor: it has a sign outside of all brackets."""
    return any(isinstance(item, Operator) and item.sign in _IN_SUMS for item in formula.items)


def is_negative(formula: Row) -> bool:
    """Whether a formula begins with a minus."""
    return formula.items[:1] == (MINUS,)


def without_sign(formula: Row) -> Row:
    """Return a formula without its first item, the minus."""
    return Row(formula.items[1:])


def as_factor(formula: Row) -> Row:
    """Return the formula as it stands in a product."""
    return Row((parenthesized(formula),)) if is_sum(formula) else formula


def power(base: Row, exponent: Row) -> Row:
    """Write a base, in parentheses unless it is an atom or a matrix, with an exponent."""
    if not (is_atom(base) or is_matrix(base)):
        return Row((Scripts(parenthesized(base), None, exponent),))
    only = base.items[0]
    if isinstance(only, Scripts):
        return Row((Scripts(only.base, only.below, exponent),))
    return Row((Scripts(only, None, exponent),))


def is_atom(formula: Row) -> bool:
    """Whether a formula is one symbol, word or number, perhaps with an index or under dots."""
    if len(formula.items) != 1:
        return False
    only = formula.items[0]
    if isinstance(only, Accent) and only.command in DOTS and isinstance(only.body, Row):
        return is_atom(only.body)
    if isinstance(only, Scripts) and only.above is None and not only.primes:
        only = only.base
    return isinstance(only, Symbol | Number) or (isinstance(only, Styled) and only.command == r"\mathrm")


def is_matrix(formula: Row) -> bool:
    """Whether a formula is a matrix and nothing else."""
    return len(formula.items) == 1 and isinstance(formula.items[0], Table)


def over(above: Row, below: Row) -> Row:
    """Write a fraction."""
    return Row((Fraction(above, below),))


def joined(factors: Sequence[Row]) -> Row:
    """Write factors side by side, with a thin space between words.

    A dot stands only where two numbers meet, between a letter and itself, and before a root with an index, which would
    be taken for an exponent.
    """
    items: list[Node] = []
    for factor in factors:
        if not factor.items:
            continue
        if items:
            items += _between(items[-1], factor)
        items += factor.items
    return Row(tuple(items))


def _between(left: Node, factor: Row) -> tuple[Node, ...]:
    """Return what stands between an item and a factor behind it."""
    first = factor.items[0]
    base = _base_of_power(first)
    twice = type(left) is type(base) and left == base and is_atom(factor if base is first else row(base))
    indexed = isinstance(first, Root) and first.index is not None
    if _numbers_meet(left, first) or indexed or twice:
        return (TIMES,)
    return (THIN_SPACE,) if _words_meet(left, first) else ()


def _base_of_power(node: Node) -> Node:
    """What is raised to a power; the node itself where it is none."""
    return node.base if isinstance(node, Scripts) and node.below is None else node


def _first_base(node: Node, kind: type[Node]) -> bool:
    return isinstance(node.base if isinstance(node, Scripts) else node, kind)


def _ends_in_number(node: Node) -> bool:
    return isinstance(node, Number) or (isinstance(node, Scripts) and node.above is not None)


def _numbers_meet(left: Node, right: Node) -> bool:
    if not isinstance(right, Fraction):
        return _first_base(right, Number)
    return _ends_in_number(left) or (_is_number_over_number(left) and _is_number_over_number(right))


def _is_number_over_number(node: Node) -> bool:
    return isinstance(node, Fraction) and all(isinstance(each, Row | Number) for each in (*walk(node),)[1:])


def _words_meet(left: Node, right: Node) -> bool:
    """Whether an upright word stands beside a letter or behind a brace, where it would not be told apart."""
    if _first_base(right, Styled):
        braces = isinstance(left, Fraction | Root | Styled | Table | Accent)
        return braces or (isinstance(left, Scripts) and isinstance(left.above or left.below, Row))
    return isinstance(left, Styled) and _first_base(right, Symbol)


def summed(terms: Sequence[Row]) -> Row:
    """Write terms with their signs merged: `a`, `-b` give `a - b`."""
    items: list[Node] = []
    for term in terms:
        if items and not is_negative(term):
            items.append(PLUS)
        items.extend(term.items)
    return Row(tuple(items)) if items else Row((Number("0"),))
