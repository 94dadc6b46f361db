"""Modules that are imported at their first use.

`solve --help`, `solve tasks` and `solve schema` read the declarations of all tasks but compute nothing, so a task
file must be importable without sympy. It says `from solver.lazy import exact, sympy as sp` and uses the names as
it would use the modules.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sized
from contextlib import contextmanager
from dataclasses import dataclass
from functools import wraps
from importlib import import_module
from inspect import isfunction
from typing import TYPE_CHECKING, Any

from solver.startup import LazyModule


@dataclass(frozen=True, slots=True)
class Call:
    """A call of a kernel by a task: for which step it was made, counted from 1, and what it found."""

    kernel: str
    arguments: tuple[Any, ...]
    named: Mapping[str, Any]
    result: Any
    step: int


class Kernels(LazyModule):
    """The kernels as the tasks see them: their calls can be noted."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self._note: Callable[..., None] | None = None

    def __getattr__(self, attribute: str) -> Any:
        value = super().__getattr__(attribute)
        if isfunction(value):
            value = self._noting(attribute, value)
            setattr(self, attribute, value)
        return value

    def _noting(self, name: str, kernel: Callable[..., Any]) -> Callable[..., Any]:
        module = import_module(self._name)

        @wraps(kernel)
        def called(*arguments: Any, **named: Any) -> Any:
            result = getattr(module, name)(*arguments, **named)
            if self._note is not None:
                self._note(name, arguments, named, result)
            return result

        return called


@contextmanager
def noted_calls(steps: Sized) -> Iterator[list[Call]]:
    """Note the calls of kernels that are made within it; `steps` are those that there are so far."""
    calls: list[Call] = []

    def note(kernel: str, arguments: tuple[Any, ...], named: Mapping[str, Any], result: Any) -> None:
        calls.append(Call(kernel, arguments, named, result, len(steps) + 1))

    before, _KERNELS._note = _KERNELS._note, note
    try:
        yield calls
    finally:
        _KERNELS._note = before


@contextmanager
def unnoted_calls() -> Iterator[None]:
    """Note no calls of kernels within it: what is kept from one question to the next is not to depend on the order."""
    before, _KERNELS._note = _KERNELS._note, None
    try:
        yield
    finally:
        _KERNELS._note = before


_KERNELS = Kernels("solver.exact")

if TYPE_CHECKING:
    import sympy

    from solver import conditions, exact, numeric, systems
else:
    sympy = LazyModule("sympy")
    exact = _KERNELS
    numeric = LazyModule("solver.numeric")
    systems = LazyModule("solver.systems")
    conditions = LazyModule("solver.conditions")

__all__ = ["Call", "conditions", "exact", "noted_calls", "numeric", "sympy", "systems", "unnoted_calls"]
