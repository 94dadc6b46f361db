"""A problem as read: exact, validated, frozen."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from solver.problem.labels import labels_of
from solver.symbols import COURSE
from solver.words import ENGLISH

if TYPE_CHECKING:
    import sympy as sp

    from solver.problem.family import Family
    from solver.problem.images import Image
    from solver.problem.nodes import Place
    from solver.problem.source import Source
    from solver.systems import System


@dataclass(frozen=True, slots=True)
class Display:
    """How numbers are shown. `mode` is "typed" (decimals where decimals were typed), "exact", "decimal" or "both".

    `digits` is the number of significant digits of decimals; `decimals_typed` tells that what is shown holds decimals.
    `language` and `notation` are those of the words and symbols around them.
    """

    mode: str = "typed"
    digits: int = 5
    decimals_typed: bool = False
    language: str = ENGLISH
    notation: str = COURSE


@dataclass(frozen=True, slots=True)
class Reference:
    """`{from: b, answer: K}`: the answer `answer` of the earlier part `part` (of its first method).

    `item` is the number, from 1, of the one that is meant where the answer is a list.
    """

    part: str
    answer: str
    item: int = 0


@dataclass(frozen=True, slots=True)
class Chain:
    """A condition on parameters as it was written, `0 < zeta < 1`: its sides and the signs between them."""

    sides: tuple[sp.Expr, ...]
    signs: tuple[str, ...]
    place: Place = field(compare=False)


@dataclass(frozen=True, slots=True)
class Show:
    """What a paper shows: what is given about the system, the name of the method, the literature."""

    system: bool = True
    method: bool = True
    source: bool = True


DIGITS = 2
"""Significant digits that a student's decimal must have where nothing is said."""


RULES = ("entries", "none", "named")


@dataclass(frozen=True, slots=True)
class Partial:
    """What a wrong answer can still earn.

    `rule` is "entries" (in proportion to what is right), "none", or "named" (a mistake of the name costs so many marks;
    where `costs` is None, half of those of the answer).
    """

    rule: str = "entries"
    costs: Mapping[str, sp.Rational] | None = None


@dataclass(frozen=True, slots=True)
class Part:
    """One question: a task by its methods, with validated options; `system` is the part's own or the problem's.

    `marks` is what the part carries; `answer_marks` how they are split over its answers, where the file says so.
    `asked` are the answers that the file asks for, none where it does not say; a decimal must have `digits` significant
    ones to be judged, and may have a comma where `decimal_comma` says so. `partial` says what wrong answers can earn,
    where anything is said of them. `show` is what a paper shows of it. `conventions` has the other usual
    values of options that the file does not give, by option and as typed; `written` are the keys that it does give.
    `symbols` and `parameters` are those of a part that has its own, `assumed` what its own `assume` says of symbols,
    `conditions` all that hold in it. `decimals_typed` tells that its question holds decimals. `places` tells where its
    task, its options and the conditions stand in the file.
    """

    id: str
    task: str
    methods: tuple[str, ...]
    system: System
    options: Mapping[str, Any] = field(default_factory=dict)
    prompt: str = ""
    marks: sp.Rational | None = None
    own_system: bool = False
    answer_marks: Mapping[str, sp.Rational] = field(default_factory=dict)
    written: frozenset[str] = frozenset()
    symbols: Mapping[str, sp.Symbol] = field(default_factory=dict)
    parameters: Mapping[str, Any] = field(default_factory=dict)
    assumed: Mapping[str, tuple[sp.Symbol, ...]] = field(default_factory=dict)
    conditions: tuple[Chain, ...] = ()
    asked: tuple[str, ...] = ()
    digits: int = DIGITS
    partial: Mapping[str, Partial] = field(default_factory=dict)
    decimal_comma: bool = False
    show: Show = Show()
    conventions: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    decimals_typed: bool = False
    places: Mapping[str, Place] = field(default_factory=dict, compare=False)

    @property
    def names_methods(self) -> bool:
        """Whether a paper may name its methods: the file asks for them, and shows them."""
        return "method" in self.written and self.show.method

    @property
    def sources(self) -> tuple[str, ...]:
        """The earlier parts whose answers it goes on with."""
        from solver.systems import EarlierPart  # noqa: PLC0415 - the command line knows problems before it needs systems

        values = [*self.options.values(), getattr(self.system, "gain", None)]
        parts = [each.part for each in values if isinstance(each, Reference)]
        return tuple(dict.fromkeys([*([self.system.part] if isinstance(self.system, EarlierPart) else []), *parts]))


@dataclass(frozen=True, slots=True)
class Problem:
    """A problem file as read. `system` is None where every part brings its own.

    `assumed` has the symbols of which something is assumed, by the word for it. `file` is the text it was read from,
    `images` are those of its texts by their addresses. `family` tells the other members where it has some.
    """

    name: str
    title: str
    parts: tuple[Part, ...]
    system: System | None = None
    source: str = ""
    statement: str = ""
    display: Display = Display()
    parameters: Mapping[str, Any] = field(default_factory=dict)
    symbols: Mapping[str, sp.Symbol] = field(default_factory=dict)
    assumed: Mapping[str, tuple[sp.Symbol, ...]] = field(default_factory=dict)
    conditions: tuple[Chain, ...] = ()
    show: Show = Show()
    images: Mapping[str, Image] = field(default_factory=dict, repr=False)
    family: Family | None = field(default=None, repr=False)
    file: Source | None = field(default=None, compare=False)

    @property
    def solutions(self) -> int:
        """How many solutions are asked for: of each part one by each of its methods."""
        return sum(len(part.methods) for part in self.parts)

    @property
    def labels(self) -> Mapping[str, str]:
        """The names of the parts as they are printed."""
        return labels_of([part.id for part in self.parts])
