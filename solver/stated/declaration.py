"""What a formula as stated is, and what an operation declares of itself."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from types import MappingProxyType
from typing import Any

from solver.formula.nodes import Row

Show = Callable[[Any], Row]
"""Prints an operand: an expression, a matrix, a number or a further formula."""

Printer = Callable[..., Row]
"""Prints an operation from a `Show` and its operands."""


@dataclass(frozen=True, slots=True)
class Stated:
    """An operation and its operands, not carried out.

    Operands are sympy expressions or matrices, numbers, or further formulas.
    """

    operation: str
    operands: tuple[Any, ...]


@dataclass(frozen=True, slots=True)
class Binding:
    """Which operand is a variable that the operation binds, and within which operands it does."""

    variable: int
    within: tuple[int, ...] = (0,)


@dataclass(frozen=True, slots=True)
class Operation:
    """What is declared of an operation.

    `state` makes the formula, `printer` prints it. In the operands `whole` symbols stand for whole numbers.
    """

    state: Callable[..., Stated]
    printer: Printer
    binding: Binding | None = None
    whole: tuple[int, ...] = ()

    @property
    def name(self) -> str:
        """The name of the operation: that of the function which states it."""
        return self.state.__name__


_DECLARED: dict[str, Operation] = {}


def operation(
    state: Callable[..., Stated], *, binding: Binding | None = None, whole: tuple[int, ...] = ()
) -> Callable[[Printer], Printer]:
    """Declare an operation; decorates the function that prints it."""

    def declare(printer: Printer) -> Printer:
        declared = Operation(state, printer, binding, whole)
        _DECLARED[declared.name] = declared
        return printer

    return declare


def operation_named(name: str) -> Operation:
    """Return the declaration of an operation. Raises KeyError if there is none of that name."""
    return _DECLARED[name] if name in _DECLARED else every_operation()[name]


@cache
def every_operation() -> Mapping[str, Operation]:
    """Return all operations by name: those of all modules of this folder."""
    package = import_module("solver.stated")
    for module in iter_modules(package.__path__):
        import_module(f"{package.__name__}.{module.name}")
    return MappingProxyType(_DECLARED)
