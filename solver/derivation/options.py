"""The options of a task: a frozen dataclass whose fields say what a file may write and what it means.

A task declares `poles: tuple[Expr, ...] | None = option(Poles(), "poles of the closed loop")` and reads
`given.options.poles`. The kinds of option stand in `solver/options`, one file each; nothing here knows them.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, fields, replace
from typing import TYPE_CHECKING, Any, ClassVar, Generic, Literal, Self, TypeVar, overload

if TYPE_CHECKING:
    from solver.problem.context import Context
    from solver.problem.nodes import Node
    from solver.systems import System
    from solver.words import Reason

T = TypeVar("T")
Schema = dict[str, Any]
VALUE: Schema = {"type": ["number", "string"]}
VALUES: Schema = {"$ref": "#/$defs/Values"}
"""One value, and one or several, as the schema of problem files writes them."""
Typed = str | int | bool | list[Any]
"""A value as it is typed in a file."""


class OptionKind(ABC, Generic[T]):
    """A kind of option: reads a node of the file as a value of type T, and says how it is written."""

    referable: ClassVar[bool] = False
    """Whether the value can be the answer of an earlier part, `{from: part}`."""
    item: ClassVar[str] = ""
    """The key beside `from` that says which one of a list of answers it is, from 1."""

    @property
    def implied(self) -> Typed | None:
        """What is meant where nothing is said, as it is typed."""
        return None

    @property
    @abstractmethod
    def words(self) -> str:
        """What is written, in words."""

    @property
    @abstractmethod
    def schema(self) -> Schema:
        """The JSON Schema of what is written."""

    @property
    @abstractmethod
    def example(self) -> str:
        """A value as it is written in a file, which suits a plant of two states, one input and one output."""

    @abstractmethod
    def read(self, node: Node, name: str, context: Context) -> T:
        """Return the value of the option `name`; raises Fault at the node."""

    def misfit(self, name: str, value: T, system: System) -> Reason | None:  # noqa: ARG002 - most fit any system
        """Return why a value that was read before the system was known does not fit it, None if it does."""
        return None


class ImpliedKind(OptionKind[T]):
    """A kind with a value of its own where nothing is said."""


@dataclass(frozen=True, slots=True)
class Way:
    """How a question is solved with an option that leaves the methods no say: the title of that way and its source."""

    title: str
    source: str


@dataclass(frozen=True, slots=True)
class Option:
    """An option of a task: its name, what it takes, what it means; `methods` it belongs to (empty: all).

    `default` is as it is typed in a file. `answer` is the answer that `{from: part}` takes (empty: the one of the
    option's own name). One with a `loop` changes the system before the
    task sees it; `loop` is the lemma whose wording says so in the question. `way` is what pages name in place of the
    method where the option is given. `conventions` are usual values, as typed, by which an answer is right too where
    the file gives none. `needs` are what the system must provide where the option is given, beside the task's own.
    `titles` are the titles of the question by values that the file gives.
    """

    name: str
    kind: OptionKind[Any]
    doc: str
    default: Typed | None = None
    required: bool = False
    methods: tuple[str, ...] = ()
    answer: str = ""
    loop: str = ""
    way: Way | None = None
    conventions: tuple[Typed, ...] = ()
    needs: tuple[str, ...] = ()
    titles: Mapping[str, str] = field(default_factory=dict, hash=False)


@overload
def option(kind: OptionKind[T], doc: str, *, required: Literal[True], methods: tuple[str, ...] = ()) -> T: ...
@overload
def option(kind: OptionKind[T], doc: str, *, default: Typed, methods: tuple[str, ...] = (), loop: str = "") -> T: ...
@overload
def option(
    kind: ImpliedKind[T],
    doc: str,
    *,
    methods: tuple[str, ...] = (),
    conventions: tuple[Typed, ...] = (),
    titles: Mapping[str, str] = ...,
) -> T: ...
@overload
def option(
    kind: OptionKind[T],
    doc: str,
    *,
    methods: tuple[str, ...] = (),
    answer: str = "",
    loop: str = "",
    way: Way | None = None,
    conventions: tuple[Typed, ...] = (),
    needs: tuple[str, ...] = (),
) -> T | None: ...
def option(kind: OptionKind[Any], doc: str, *, default: Typed | None = None, **facts: Any) -> Any:
    """Return the field of an option, whose type follows from how it is declared.

    `required`: the value of the kind, since a file without it is refused. With a `default`, as it would be typed in a
    file, or of a kind that implies one (a flag, a choice): that value where none is given. Else None where none is
    given; then `answer` names the answer of an earlier part that it is usually taken from, `loop` the lemma that closes
    a loop with it, and `way` is what it has done in place of the method. `methods` are those that take the option
    (none: all); `conventions` are other usual values, which a student may follow where the file gives none;
    `needs` is what the system must provide where the option is given; `titles` tell questions apart by a value that
    the file gives.
    """
    default = kind.implied if default is None else default
    declared = Option("", kind, doc, default, **facts)
    return field(default=None if isinstance(default, list) else default, metadata={"option": declared})


@dataclass(frozen=True, kw_only=True)
class Options:
    """The options of a task, read. `later` are those taken from an earlier part, as long as their value is unknown."""

    later: frozenset[str] = frozenset()

    @classmethod
    def declared(cls) -> dict[str, Option]:
        """Return the options by name: the class's own before those it inherits."""
        known = {each.name: each.metadata["option"] for each in fields(cls) if "option" in each.metadata}
        names = dict.fromkeys(name for base in cls.__mro__ for name in vars(base).get("__annotations__", {}))
        return {name: replace(known[name], name=name) for name in names if name in known}

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> Self:
        """Return the options with these values; None stands for one that is not known yet."""
        later = frozenset(name for name, value in values.items() if value is None)
        return cls(later=later, **values)

    def has(self, name: str) -> bool:
        """Whether an option without a default is given, known or not."""
        return name in self.later or getattr(self, name) is not None

    def faults(self, system: System) -> Iterable[tuple[str, Reason]]:  # noqa: ARG002 - for those that must fit it
        """Yield each option that does not fit the system, with what is wrong; options of other tasks have their own."""
        return ()

    def misfits(self, system: System) -> list[tuple[str, Reason]]:
        """Return each option whose value has another shape than its kind asks of it beside the system, and why."""
        given = {name: each.kind for name, each in self.declared().items() if getattr(self, name) is not None}
        found = ((name, kind.misfit(name, getattr(self, name), system)) for name, kind in given.items())
        return [(name, reason) for name, reason in found if reason is not None]

    @property
    def values(self) -> list[Any]:
        """The values that are given."""
        return [value for name in self.declared() if (value := getattr(self, name)) is not None]


__all__ = ["VALUE", "VALUES", "ImpliedKind", "Option", "OptionKind", "Options", "Schema", "Typed", "Way", "option"]
