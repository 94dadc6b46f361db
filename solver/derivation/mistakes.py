"""The usual mistakes of a task, declared with it: values they lead to, or the question they change."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from solver.derivation.options import Options

if TYPE_CHECKING:
    from solver.derivation.registry import Given
    from solver.words import Reason

S_co = TypeVar("S_co", covariant=True)
O_co = TypeVar("O_co", bound=Options, covariant=True)


@dataclass(frozen=True, slots=True)
class Attempt(Generic[S_co, O_co]):
    """A wrong value of the answer `name`: what is given, our answers, and what was submitted for the part."""

    given: Given[S_co, O_co]
    name: str
    answers: Mapping[str, Any]
    submitted: Mapping[str, Any] = field(default_factory=dict)

    @property
    def ours(self) -> Any:
        """Our value."""
        return self.answers[self.name]

    @property
    def value(self) -> Any:
        """The wrong value."""
        return self.submitted[self.name]


@dataclass(frozen=True, slots=True)
class Slip:
    """What goes wrong: the name by which a problem says what it costs, and the words of a sheet (Markdown)."""

    name: str
    words: str


@dataclass(frozen=True, slots=True)
class Mistake:
    """What goes wrong, the answers where it happens, and the values that it leads to."""

    slip: Slip
    answers: tuple[str, ...]
    values: Callable[[Attempt[Any, Any]], Iterable[Any]]


@dataclass(frozen=True, slots=True)
class Meaning:
    """What a wrong value of some answers would mean: a reason, None where it tells nothing."""

    answers: tuple[str, ...]
    of: Callable[[Attempt[Any, Any]], Reason | None]


@dataclass(frozen=True, slots=True)
class MistakenQuestion:
    """What goes wrong, and the question (system, options) that is answered by it, if any."""

    slip: Slip
    change: Callable[[Any, Any], tuple[Any, Any] | None]
