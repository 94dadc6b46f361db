"""Sums and products whose index goes through a list, whole numbers, or the roots of a polynomial."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from solver.formula.building import as_factor, row, separated
from solver.formula.nodes import Fenced, Operator, Row, Scripts
from solver.stated.declaration import Binding, Printer, Show, Stated, operation


def summation(term: Any, index: Any, lower: Any, upper: Any) -> Stated:
    """Σ T(i) for i from `lower` to `upper`, whole numbers."""
    return Stated("summation", (term, index, lower, upper))


def indexed_product(factor: Any, index: Any, lower: Any, upper: Any) -> Stated:
    """Π F(i) for i from `lower` to `upper`, whole numbers."""
    return Stated("indexed_product", (factor, index, lower, upper))


def sum_over(term: Any, variable: Any, values: Sequence[Any]) -> Stated:
    """Σ T(x) for x in a list: the paths of a graph, the poles of a system."""
    return Stated("sum_over", (term, variable, tuple(values)))


def product_over(factor: Any, variable: Any, values: Sequence[Any]) -> Stated:
    """Π F(x) for x in a list."""
    return Stated("product_over", (factor, variable, tuple(values)))


def sum_over_roots(term: Any, variable: Any, polynomial: Any) -> Stated:
    """Σ T(x) for all roots x of a polynomial in x, each as often as its multiplicity."""
    return Stated("sum_over_roots", (term, variable, polynomial))


def _from_to(sign: str) -> Printer:
    def write(show: Show, operand: Any, index: Any, lower: Any, upper: Any) -> Row:
        limits = Scripts(Operator(sign), row(show(index), "=", show(lower)), show(upper))
        return row(limits, as_factor(show(operand)))

    return write


def _through(sign: str) -> Printer:
    def write(show: Show, operand: Any, variable: Any, values: Sequence[Any]) -> Row:
        listed = Fenced(r"\{", separated(map(show, values), Operator(",")), r"\}", tall=True)
        return row(Scripts(Operator(sign), row(show(variable), r"\in", listed)), as_factor(show(operand)))

    return write


operation(summation, binding=Binding(1), whole=(2, 3))(_from_to(r"\sum"))
operation(indexed_product, binding=Binding(1), whole=(2, 3))(_from_to(r"\prod"))
operation(sum_over, binding=Binding(1))(_through(r"\sum"))
operation(product_over, binding=Binding(1))(_through(r"\prod"))


@operation(sum_over_roots, binding=Binding(1, within=(0, 2)))
def _sum_over_roots(show: Show, term: Any, _variable: Any, polynomial: Any) -> Row:
    return row(Scripts(Operator(r"\sum"), row(show(polynomial), "= 0")), as_factor(show(term)))
