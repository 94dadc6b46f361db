"""The kinds of option a task can take. They say what is allowed; `solver.problem` reads them from a file."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Integer:
    """A whole number within bounds."""

    minimum: int | None = None
    maximum: int | None = None


@dataclass(frozen=True, slots=True)
class Choice:
    """One of some words; the first is the default unless the option says otherwise."""

    words: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Flag:
    """`true` or `false`."""


@dataclass(frozen=True, slots=True)
class Number:
    """An exact number or an expression in parameters; `percent` also allows "14%"."""

    percent: bool = False


@dataclass(frozen=True, slots=True)
class Expression:
    """An expression; `variables` are the names with a meaning of their own in it (`t`, `k`, `s`, `A`)."""

    variables: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class ExpressionList:
    """An expression, or a list of them (one an input, say)."""

    variables: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Poles:
    """A list of complex numbers closed under conjugation; "-3 ± 2j" stands for two."""


@dataclass(frozen=True, slots=True)
class MatrixOf:
    """A matrix. `rows` and `columns` are numbers or the system's "n", "m" (inputs), "p" (outputs); None is any.

    `flat` says what a flat list stands for: "row" or "column".
    """

    rows: int | str | None = None
    columns: int | str | None = None
    flat: str = "row"


@dataclass(frozen=True, slots=True)
class Channel:
    """An input or output by number (from 1) or by name; `of` is "input", "output" or "state"."""

    of: str


@dataclass(frozen=True, slots=True)
class Names:
    """A list of words (parameters, states)."""


@dataclass(frozen=True, slots=True)
class TransferFunctionOption:
    """A transfer function in any of the spellings of a system."""


OptionKind = (
    Integer | Choice | Flag | Number | Expression | ExpressionList | Poles | MatrixOf | Channel | Names
    | TransferFunctionOption
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Option:
    """An option of a task: its name, what it takes, what it means; `methods` it belongs to (empty: all)."""

    name: str
    kind: OptionKind
    doc: str
    default: Any = None
    required: bool = False
    methods: tuple[str, ...] = ()
