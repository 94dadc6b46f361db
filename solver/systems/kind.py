"""What a kind of system declares: the keys it is given by, how they are read, an example, what it is.

A kind is one file of this folder. It holds the frozen exact object that a problem is about, and one `Kind` for each
way of giving it in a file; nothing lists the kinds by hand. Its words under "Given" are the macro `given` of
`templates/wording/systems/<kind>.md.jinja`. The file must be importable without sympy, like the declaration of a task.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Poly, Symbol

    from solver.systems.ends import End


@dataclass(frozen=True, slots=True)
class Value:
    """A number or an expression, or words."""


@dataclass(frozen=True, slots=True)
class Values:
    """A value or a list of values."""


@dataclass(frozen=True, slots=True)
class Matrix:
    """A list of rows, a flat list or a single value."""


@dataclass(frozen=True, slots=True)
class Fraction:
    """A quotient of polynomials in any of its spellings."""


@dataclass(frozen=True, slots=True)
class Gain:
    """A matrix, or the answer of an earlier part, `{from: part}`."""


@dataclass(frozen=True, slots=True)
class ModelName:
    """The name of a model of the library."""


@dataclass(frozen=True, slots=True)
class AtEnd:
    """A value, the word free, or `{on: curve}`."""


@dataclass(frozen=True, slots=True)
class Component:
    """The name of a resistor or a capacitor, R1, C_2, or one with its value, `{R: 5000}`, `{C: 1e-6}`."""


@dataclass(frozen=True, slots=True)
class OneOrMore:
    """An item that is a mapping, or a list of such items."""

    item: Keyed


@dataclass(frozen=True, slots=True)
class ListOf:
    """A list of one item at least."""

    item: Shape


@dataclass(frozen=True, slots=True)
class MappingTo:
    """Keys of the user's choice with values of one shape."""

    value: Shape


@dataclass(frozen=True, slots=True)
class Keyed:
    """A mapping with keys of its own; `name` is the key under which it stands, or its list does."""

    name: str
    keys: tuple[Key, ...]


Shape = (
    Value | Values | Matrix | Fraction | Gain | ModelName | AtEnd | Component | OneOrMore | ListOf | MappingTo | Keyed
)
"""What may stand under a key, before it is known what the values mean."""


@dataclass(frozen=True, slots=True)
class Key:
    """A key of a kind: its name, what may stand there, what it means, and whether it can't be left out."""

    name: str
    shape: Shape
    doc: str
    required: bool = False


class System(Protocol):
    """What the exact object of any kind can be asked."""

    @property
    def kind(self) -> str:
        """The name of the kind that words it."""

    @property
    def discrete(self) -> bool:
        """Whether time is discrete."""

    @property
    def sample_time(self) -> Expr | None:
        """The sampling period, where one is given."""

    @property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols, sorted by name."""

    @property
    def provides(self) -> frozenset[str]:
        """What a task can ask of it as it stands: "A", "B", "C", "D", "initial_state", "transfer_function" ..."""

    @property
    def described(self) -> str:
        """What it is given by, in words, for messages."""

    def size(self, of: str) -> int | None:
        """Return the number of states "n", inputs "m" or outputs "p", if it is known."""

    def names(self, of: str) -> tuple[str, ...]:
        """Return the names of its "state"s, "input"s or "output"s, if it gives them."""


class Quotient(Protocol):
    """A quotient of polynomials as given."""

    @property
    def numerator(self) -> Poly:
        """The polynomial above, as given."""

    @property
    def denominator(self) -> Poly:
        """The polynomial below, as given."""

    @property
    def delay(self) -> Expr:
        """The T of a factor e^{−T s} beside the quotient, zero without."""

    @property
    def written(self) -> tuple[Expr, Expr] | None:
        """What stands above and below in the factors given, None where they are multiplied out."""

    def cancelled(self) -> Expr:
        """Return the quotient without common factors."""


class Reader(Protocol):
    """What a kind reads its keys with; faults are kept at their places until `conclude` raises all of them."""

    discrete: bool
    sample_time: Expr | None
    timed: bool
    """Whether the time t may stand in formulas by itself."""

    def gives(self, key: str) -> bool:
        """Whether the key is there."""

    def is_zero(self, key: str) -> bool:
        """Whether a single 0 stands under the key."""

    def matrix(
        self, key: str, flat: str = "", shape: tuple[int | None, int | None] = (None, None), like: str = ""
    ) -> ImmutableMatrix | None:
        """Return the matrix of that shape, None if it is absent or wrong; `like` says whose rows and columns it has."""

    def names(self, key: str, number: int | None = None) -> tuple[str, ...]:
        """Return the names under the key; there must be `number` of them if that is known."""

    def quotient(self, key: str) -> Quotient | None:
        """Return the proper quotient of polynomials under the key, None if it is wrong."""

    def polynomial(self, key: str) -> Sequence[Expr]:
        """Return the coefficients of a polynomial, the highest power first; none if it is wrong."""

    def polynomials(self, key: str) -> Sequence[Sequence[Sequence[Expr]]]:
        """Return the coefficients of a matrix of polynomials, row by row, the highest power first."""

    def quotients(self, key: str, *, delayed: bool = False) -> Sequence[Sequence[Quotient]]:
        """Return a matrix of proper quotients of polynomials; `delayed` says that they may have a factor e^{−Ts}."""

    def branches(self, key: str) -> Sequence[tuple[str, str, Expr]]:
        """Return the branches [from, to, gain] of a graph; those that cannot be read are missing, and told."""

    def node_name(self, key: str) -> str:
        """Return the name of a node of a graph; "" if it is wrong."""

    def complain_branch(self, key: str, item: int, message: str) -> None:
        """Keep a fault at a branch."""

    def dynamic_names(self, key: str) -> Sequence[str]:
        """Return the names that occur with a derivative (discrete: at a sample), in the order of the file."""

    def jets(self, key: str) -> tuple[tuple[str, int], ...]:
        """Return functions of time with the orders of their derivatives."""

    def relations(self, key: str, functions: Sequence[str]) -> tuple[tuple[tuple[Expr, Expr], ...], dict[Any, Any]]:
        """Return the sides of each equation, and the derivatives that occur by their symbols."""

    def written(self, key: str, functions: Sequence[str]) -> tuple[tuple[tuple[Expr, ...], ...], ...]:
        """Return the terms of the sides of each equation, in the order of the text; of equations that can be read."""

    def formulas(self, key: str, functions: Sequence[str]) -> tuple[tuple[Expr, ...], dict[Any, Any]]:
        """Return expressions in functions of time, and the derivatives that occur by their symbols."""

    def initial(self, key: str, functions: Sequence[str]) -> dict[tuple[str, int], Expr]:
        """Return the values of derivatives at the beginning."""

    def ends(self, key: str, orders: Mapping[str, int], *, free_time: bool) -> dict[tuple[str, int], tuple[End, ...]]:
        """Return what is asked at both ends of functions and their derivatives: values, free, or a curve."""

    def assumed(self, functions: Sequence[str]) -> dict[str, Any]:
        """Return the symbols of those functions of time of which more is assumed than that they are real, by name."""

    def earlier_part(self, key: str) -> tuple[str, tuple[str, ...]]:
        """Return an earlier part and the names of its answers, "" if it is wrong; its time is the system's."""

    def named_model(self, key: str) -> Any:
        """Return the system of the model of the library that is named; None if it is wrong."""

    def gain(self, key: str) -> Any:
        """Return a matrix, or the part and the answer it is taken from; None if it is absent or wrong."""

    @property
    def keys(self) -> Mapping[str, str]:
        """The plain spelling of each key that is there, in the order of the file: theta for θ."""

    def within(self, key: str) -> Reader:
        """Return what reads the mapping under a key, an empty one if it is absent; its faults are kept here too."""

    def each(self, key: str) -> Sequence[Reader]:
        """Return what reads each mapping of the list under a key; a mapping by itself is a list of one."""

    def component(self, key: str) -> tuple[str, str, Expr] | None:
        """Return the letter of a component, R or C, its name, "" where it has none, and its value; None if wrong."""

    def value(self, key: str) -> Expr | None:
        """Return the expression under the key, None if it is absent or wrong."""

    def complain(
        self, key: str, message: str, *, at_key: bool = False, item: int | None = None, like: Sequence[str] = ()
    ) -> None:
        """Keep a fault at the value of the key, at one item of it, or at the key itself; one `like` it is suggested."""

    def texts(self, key: str) -> Sequence[str]:
        """Return the texts of a list as they are written."""

    def value_inside(self, key: str, item: int, at: int, length: int | None = None) -> Expr | None:
        """Return the expression that stands in the text of an item from a place on; None if it is wrong."""

    def complain_inside(self, key: str, item: int, span: tuple[int, int], message: str, suggestion: str = "") -> None:
        """Keep a fault within the text of an item: where it begins, and its length."""

    def conclude(self) -> None:
        """Raise everything that is wrong, if anything is."""


@dataclass(frozen=True, slots=True)
class Kind:
    """One way of giving a system: the first of its keys tells it. `example` are lines of a file, with `{x}` for s or z.

    `read` returns the object; it may leave out what cannot be read, once `conclude` has not raised.
    """

    name: str
    doc: str
    keys: tuple[Key, ...]
    read: Callable[[Reader], Any]
    example: Sequence[tuple[str, str]]

    @property
    def tells(self) -> str:
        """The key that tells the kind."""
        return self.keys[0].name


CHANNELS = (Key("inputs", Values(), "names of the inputs"), Key("outputs", Values(), "names of the outputs"))
"""Keys of all kinds whose inputs and outputs can be named."""
