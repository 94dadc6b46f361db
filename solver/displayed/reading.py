"""What a written formula means: sums, products by juxtaposition, powers, block matrices, functions, transforms.

The tree of `solver.formula` says what stands where; here it is read as mathematics. The grammar is small and closed,
and anything else is refused with the reason.
"""

from __future__ import annotations

import sympy as sp

from solver.displayed.tree import Meaning, Unreadable, name_of
from solver.formula import latex
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
)
from solver.words import Phrase

VALUE = "value"
"""Stands for the printed values in what is read: the operator `value3` is the fourth."""

OPERATIONS = {
    **{name: name for name in ("sin", "cos", "tan", "sinh", "cosh", "exp")},
    **{"ln": "log", "arccos": "acos", "arctan": "atan", "det": "determinant", "tr": "trace", "rank": "rank"},
    **{"adj": "adjugate", "Re": "re", "Im": "im"},
}
_OF_ONE_FACTOR = frozenset({"determinant", "trace", "rank", "adjugate", "re", "im", "exp"})
SIGNS = {"+": "", "-": "minus", r"\pm": "plus_minus", r"\mp": "minus_plus"}
"""Signs between terms, and what the term behind one is."""

PARTIAL = Symbol(r"\partial")
_NAMES = Symbol | Accent | Styled


def read(items: tuple[Node, ...]) -> Meaning:
    """Return what some items side by side mean. Raises Unreadable."""
    return _Reader([item for item in items if not isinstance(item, Space)]).sum()


def _inside(node: Node) -> Meaning:
    return read(node.items if isinstance(node, Row) else (node,))


class _Reader:
    """Goes through the items of one row."""

    def __init__(self, items: list[Node]) -> None:
        self.items = items
        self.at = 0

    def sign(self) -> str:
        """Return the sign that stands next, if it is one; "end" at the end."""
        if self.at >= len(self.items):
            return "end"
        item = self.items[self.at]
        return item.sign if isinstance(item, Operator) else ""

    def sum(self) -> Meaning:
        terms = []
        while True:
            sign = self.sign()
            if sign in SIGNS:
                self.at += 1
            term = self.product()
            terms.append(Meaning(SIGNS[sign], (term,)) if SIGNS.get(sign) else term)
            if self.sign() == "end":
                return terms[0] if len(terms) == 1 else Meaning("sum", tuple(terms))
            if self.sign() not in SIGNS:
                raise Unreadable(Phrase("the sign ${sign}$", sign=self.sign()))

    def product(self, *, of_function: bool = False) -> Meaning:
        factors: list[Meaning] = []
        while (sign := self.sign()) not in (*SIGNS, "end"):
            if sign == r"\cdot":
                self.at += 1
            elif sign == "/":
                self.at += 1
                factors = [Meaning("fraction", (_product(factors), self.factor()))]
            elif of_function and _is_function(self.items[self.at]):
                break
            else:
                factors.append(self.factor())
        return _product(factors)

    def factor(self) -> Meaning:
        """Read one factor: a number, a name and perhaps its argument, brackets, a function, a matrix."""
        item = self.items[self.at]
        self.at += 1
        base = item.base if isinstance(item, Scripts) else item
        if isinstance(base, _NAMES):
            return self.named(item)
        if isinstance(base, Function) and base.name == "lim":
            return self.limit(item)
        if isinstance(base, Function):
            return self.function(base, item.above if isinstance(item, Scripts) else None)
        if isinstance(base, Operator):
            return self.large(base.sign, item)
        meaning = self.bracketed(base)
        return self.with_scripts(meaning, item) if isinstance(item, Scripts) else meaning

    def bracketed(self, node: Node) -> Meaning:
        """Read what holds together: a number, a fraction, brackets, a matrix."""
        if isinstance(node, Row):
            return read(node.items)
        if isinstance(node, Number):
            return Meaning("number", text=sp.Rational(node.digits))
        if isinstance(node, Fraction):
            return _fraction(node)
        if isinstance(node, Root):
            return Meaning("sqrt", (_inside(node.radicand),))
        if isinstance(node, Fenced) and not {node.left, node.right} & {".", r"\{"}:
            inner = read(node.body.items)
            return Meaning("abs", (inner,)) if node.left == "|" else inner
        if isinstance(node, Table) and node.environment in ("bmatrix", "array"):
            return _matrix(node)
        raise Unreadable("a notation that is not evaluated")

    def with_scripts(self, base: Meaning, scripts: Scripts) -> Meaning:
        if scripts.primes:
            raise Unreadable("a prime of a formula")
        if scripts.below is not None:
            items = scripts.below.items if isinstance(scripts.below, Row) else (scripts.below,)
            at = next((i for i, item in enumerate(items) if item == Operator("=")), None)
            if at is None:
                raise Unreadable("an index of a formula")
            base = Meaning("value_at", (base, read(items[:at]), read(items[at + 1 :])))
        return base if scripts.above is None else _power(base, scripts.above)

    def named(self, item: Node) -> Meaning:
        r"""Read a name with its index and primes, its argument (`\Phi(t)`: an `apply`) and its exponent: `x(0)^{T}`."""
        text, above = name_of(item), item.above if isinstance(item, Scripts) else None
        if text in (r"\mathcal{L}", r"\mathcal{Z}"):
            return self.transform(text)
        if above == Row((Operator("*"),)) or above == Operator("*"):
            text, above = f"{text}^{{*}}", None
        name = Meaning("name", text=text)
        follows = self.items[self.at] if self.at < len(self.items) else None
        if above is not None:
            return _power(name, above)
        if isinstance(follows, Scripts) and _is_number_in_brackets(follows.base):
            self.at += 1
            return self.with_scripts(Meaning("apply", (name, _inside(follows.base)), text), follows)
        if not (isinstance(follows, Fenced) and follows.left == "("):
            return name
        self.at += 1
        if Operator(",") in follows.body.items:
            return Meaning("name", text=f"{text}({_names_of(follows.body.items)})")
        return Meaning("apply", (name, read(follows.body.items)), text)

    def transform(self, letter: str) -> Meaning:
        follows = self.items[self.at] if self.at < len(self.items) else None
        if not isinstance(follows, Fenced):
            raise Unreadable("a transform of nothing")
        self.at += 1
        return Meaning("inverse_laplace" if "L" in letter else "inverse_z", (read(follows.body.items),))

    def function(self, function: Function, above: Node | None) -> Meaning:
        if function.named and function.name.startswith(VALUE):
            value = Meaning("value", text=int(function.name.removeprefix(VALUE)))
            return value if above is None else _power(value, above)
        if function.name not in OPERATIONS:
            raise Unreadable(Phrase("the function {name}", name=function.name))
        name = OPERATIONS[function.name]
        if self.sign() == "end":
            raise Unreadable("a function of nothing")
        follows = self.items[self.at]
        whole = name in _OF_ONE_FACTOR or isinstance(follows, Fenced)
        applied = Meaning(name, (self.factor() if whole else self.product(of_function=True),))
        return applied if above is None else _power(applied, above)

    def limit(self, item: Node) -> Meaning:
        """Read the limit of what follows, up to the next sign of a sum."""
        below = item.below.items if isinstance(item, Scripts) and isinstance(item.below, Row) else ()
        if len(below) < 3 or below[1] != Operator(r"\to"):
            raise Unreadable("a limit without its variable")
        return Meaning("limit", (self.product(), read(below[:1]), read(below[2:])))

    def large(self, sign: str, item: Node) -> Meaning:
        if sign == "|":
            end = next((i for i in range(self.at, len(self.items)) if self.items[i] == Operator("|")), None)
            if end is None:
                raise Unreadable("a bar without a partner")
            inner = read(tuple(self.items[self.at : end]))
            self.at = end + 1
            return Meaning("abs", (inner,))
        if sign not in (r"\int", r"\sum") or not isinstance(item, Scripts) or None in (item.below, item.above):
            raise Unreadable("an ellipsis" if sign.endswith("dots") else Phrase("the sign ${sign}$", sign=sign))
        body = self.items[self.at :]
        self.at = len(self.items)
        if sign == r"\sum":
            items = item.below.items if isinstance(item.below, Row) else ()
            parts = (read(tuple(body)), read(items[:1]), read(items[2:]), _inside(_some(item.above)))
            return Meaning("summation", parts)
        if len(body) < 3 or body[-2] != Symbol("d"):
            raise Unreadable("an integral without its variable")
        limits = _inside(_some(item.below)), _inside(_some(item.above))
        return Meaning("integral", (read(tuple(body[:-2])), read((body[-1],)), *limits))


def _matrix(table: Table) -> Meaning:
    if " ".join(map(latex, table.rows[0])) == r"0 \cdots 0 1":
        return Meaning("unit_row")
    return Meaning("matrix", tuple(Meaning("row", tuple(read(cell.items) for cell in row)) for row in table.rows))


def _fraction(fraction: Fraction) -> Meaning:
    r"""Read a fraction, or a derivative \frac{da}{ds}, \frac{\partial f}{\partial x}."""
    if isinstance(fraction.above, Row) and fraction.above.items[:1] == (PARTIAL,):
        return _partial_derivative(fraction)
    if not latex(fraction.above).lstrip("{").startswith("d"):
        return Meaning("fraction", (_inside(fraction.above), _inside(fraction.below)))
    above, below = (each.items if isinstance(each, Row) else () for each in (fraction.above, fraction.below))
    if len(above) != 2 or len(below) != 2 or below[0] != Symbol("d"):
        raise Unreadable("a derivative")
    return Meaning("derivative", (read(above[1:]), read(below[1:])))


def _partial_derivative(fraction: Fraction) -> Meaning:
    above, below = (each.items if isinstance(each, Row) else () for each in (fraction.above, fraction.below))
    if len(above) < 2 or len(below) < 2 or below[0] != PARTIAL:
        raise Unreadable("a derivative")
    return Meaning("partial_derivative", (read(above[1:]), read(below[1:])))


def _names_of(arguments: tuple[Node, ...]) -> str:
    """Read the arguments of f(x, u), all of them names: the whole is a name too."""
    names = [item for item in arguments if item != Operator(",") and not isinstance(item, Space)]
    if not all(isinstance(item.base if isinstance(item, Scripts) else item, _NAMES) for item in names):
        raise Unreadable("several arguments")
    return ",".join(map(name_of, names))


def _is_number_in_brackets(node: Node) -> bool:
    return isinstance(node, Fenced) and node.left == "(" and [*map(type, node.body.items)] == [Number]


def _is_function(item: Node) -> bool:
    return isinstance(item, Function) and not item.name.startswith(VALUE)


def _some(node: Node | None) -> Node:
    return Row() if node is None else node


def _power(base: Meaning, above: Node) -> Meaning:
    if latex(above) in ("T", "{T}"):
        return Meaning("transpose", (base,))
    return Meaning("power", (base, _inside(above)))


def _product(factors: list[Meaning]) -> Meaning:
    if not factors:
        raise Unreadable("a side that is empty")
    return factors[0] if len(factors) == 1 else Meaning("product", tuple(factors))
