"""What is asked of difference equations: the rows, the inputs as sequences, and the values that they begin with."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from solver.derivation import Given, Options, option
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.options.initial_values import InitialValues
from solver.options.input_functions import InputFunctions
from solver.options.integer import Integer
from solver.tasks.transforms.back_transform import Names
from solver.tasks.transforms.equation_question import capital
from solver.words import formula

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import Equations

USUAL_TERMS, MOST_TERMS = 6, 40


@dataclass(frozen=True, kw_only=True)
class DifferenceOptions(Options):
    """What acts, and how it begins."""

    input: Mapping[str, Any] | None = option(
        InputFunctions(), "the inputs as sequences, zero before k = 0: {u: (1/2)^k}"
    )
    initial: Mapping[tuple[str, int], Any] | None = option(
        InitialValues(), 'values to begin with, as {"y(0)": 0, "y(1)": 1} or {"y(-1)": 2}; else those of the system'
    )
    terms: int = option(Integer(1, MOST_TERMS), "how many values, from k = 0 on", default=USUAL_TERMS)


@dataclass(frozen=True)
class Question:
    """The equations with what acts on them; `initial` are the values given, by unknown and sample (none: from rest)."""

    model: Equations
    inputs: Mapping[str, Expr]
    initial: Mapping[tuple[str, int], Expr]
    terms: int = USUAL_TERMS

    @staticmethod
    def of(given: Given[Equations, DifferenceOptions]) -> Question:
        """The question of a part."""
        options = given.options
        initial = given.system.initial if options.initial is None else options.initial
        return Question(given.system, options.input or {}, initial, options.terms)

    @property
    def z(self) -> Symbol:
        """The variable of the transforms."""
        return sp.Symbol("z")

    @property
    def k(self) -> Symbol:
        """The number of the sample."""
        return sp.Symbol("k")

    @property
    def at_rest(self) -> bool:
        """Whether no values are given, so that all are zero before k = 0."""
        return not self.initial

    @cached_property
    def equations(self) -> list[Expr]:
        """The equations as expressions that are zero."""
        return [left - right for left, right in self.model.sides]

    @cached_property
    def written(self) -> exact.SampleOperators:
        """The rows as they are given; raises NotExact where they are not linear, or do not fix the unknowns."""
        model = self.model
        return exact.sample_operators_of(self.equations, model.jets, model.unknowns, model.inputs, self.k)

    @cached_property
    def moved(self) -> int | None:
        """By how many samples the equations are moved to go on from the values given; None where they cannot."""
        if self.at_rest:
            return -max(high for _, high in self.written.spans.values())
        return exact.window_of(self.written, self.initial)

    @cached_property
    def operators(self) -> exact.SampleOperators:
        """The rows as they hold from k = 0 on; from rest, as they are given."""
        return self.written if self.at_rest else self.written.later(self.moved or 0)

    @cached_property
    def start(self) -> dict[tuple[str, int], Expr]:
        """The values that the recursion begins with; what is not given is zero."""
        spans = self.written.later(self.moved or 0).spans
        needed = [(name, m) for name, (low, high) in spans.items() for m in range(low, high)]
        return {jet: self.initial.get(jet, sp.S.Zero) for jet in needed}

    @cached_property
    def pieces(self) -> dict[str, tuple[exact.TransformPiece, ...]]:
        """What begins in each input, sample by sample."""
        return {name: exact.sequence_pieces(self.inputs[name], self.k) for name in self.model.inputs}

    @cached_property
    def rests(self) -> tuple[tuple[exact.TransformPiece, ...], ...]:
        """What is left of each row without unknowns and inputs, a sequence."""
        return tuple(exact.sequence_pieces(row.rest, self.k) for row in self.operators.rows)

    def image_of(self, pieces: tuple[exact.TransformPiece, ...]) -> Expr:
        """The transform of a sequence."""
        found: Expr = exact.sequence_transform(pieces, self.k, self.z)
        return found

    def first_of_inputs(self) -> dict[tuple[str, int], Expr]:
        """The first values of the inputs, which a shift forward leaves out."""
        most = max((p for row in self.operators.rows for _, p in row.inputs), default=0)
        return {
            (name, m): exact.value_of_pieces(self.pieces[name], self.k, m)
            for name in self.model.inputs
            for m in range(max(most, 0))
        }

    @cached_property
    def started(self) -> Any:
        """What the values at the start add on the right of each row; nothing from rest."""
        if self.at_rest:
            return sp.ImmutableMatrix(sp.zeros(len(self.operators.rows), 1))
        return exact.start_of(self.operators, self.z, self.start, self.first_of_inputs())

    def forced(self, i: int) -> dict[tuple[str, int], Expr]:
        """The transforms of the inputs in a row, with their shifts and coefficients."""
        row = self.operators.rows[i]
        return {(x, p): c * self.z**p * self.image_of(self.pieces[x]) for (x, p), c in row.inputs.items()}

    @cached_property
    def terms_by_delay(self) -> dict[int, list[Expr]]:
        """The right sides of the rows, with what begins at each sample apart, without its factor z⁻ⁿ."""
        count = len(self.operators.rows)
        found: dict[int, list[Expr]] = {0: list(self.started)}
        for i, row in enumerate(self.operators.rows):
            given = [(c * self.z**p, self.pieces[x]) for (x, p), c in row.inputs.items()]
            for factor, pieces in [*given, (sp.S.One, self.rests[i])]:
                for piece in pieces:
                    side = found.setdefault(int(piece.delay), [sp.S.Zero] * count)
                    side[i] += factor * piece.image(self.k, self.z)
        return found

    @cached_property
    def cleared(self) -> tuple[Any, Expr, tuple[int, ...]]:
        """adj P and det P in positive powers of z, and the powers by which the rows are multiplied."""
        found: tuple[Any, Expr, tuple[int, ...]] = exact.cleared_adjugate(self.operators, self.z)
        return found

    @cached_property
    def images(self) -> dict[str, Expr]:
        """The transform of each unknown, a term for each sample at which something begins."""
        adjugate, whole, powers = self.cleared
        found: dict[str, Expr] = dict.fromkeys(self.model.unknowns, sp.S.Zero)
        for delay, side in self.terms_by_delay.items():
            right = [self.z**p * r for p, r in zip(powers, side, strict=True)]
            for j, name in enumerate(self.model.unknowns):
                above = sp.Add(*(a * r for a, r in zip(adjugate.row(j), right, strict=True)))
                if sp.cancel(above) != 0:
                    image = exact.sequence_image(above / whole, self.z)
                    found[name] += exact.moved_image(sp.Integer(delay), image.whole, self.z)
        return found

    def names(self, name: str) -> Names:
        """What an unknown or input and its transform are called."""
        shown = formula(sp.Symbol(name, real=True))
        return Names(formula(capital(name)), shown, self.z, self.k)
