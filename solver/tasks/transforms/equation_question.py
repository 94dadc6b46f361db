"""What is asked of differential equations: the operators, the inputs as functions of time, the values at 0−."""

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
from solver.tasks.transforms.back_transform import Names
from solver.words import formula

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import Equations

CAPITALS = {"gamma", "delta", "theta", "lamda", "lambda", "xi", "pi", "sigma", "phi", "psi", "omega"}
"""Greek letters whose capitals are no Latin ones."""


@dataclass(frozen=True, kw_only=True)
class DifferentialOptions(Options):
    """What acts, and how it begins."""

    input: Mapping[str, Any] | None = option(
        InputFunctions(), "the inputs as functions of t ≥ 0, zero before: {u: exp(-t)}"
    )
    initial: Mapping[tuple[str, int], Any] | None = option(
        InitialValues(), 'values at 0−, as {x: 1, "x\'": 0}; else those of the system, zero where none are given'
    )


@dataclass(frozen=True)
class Question:
    """The equations with what acts on them; `initial` are the values at 0− by unknown and order of the derivative."""

    model: Equations
    inputs: Mapping[str, Expr]
    initial: Mapping[tuple[str, int], Expr]

    @staticmethod
    def of(given: Given[Equations, DifferentialOptions]) -> Question:
        """The question of a part."""
        options = given.options
        initial = given.system.initial if options.initial is None else options.initial
        return Question(given.system, options.input or {}, initial)

    @property
    def s(self) -> Symbol:
        """The variable of the transforms."""
        return sp.Symbol("s")

    @property
    def t(self) -> Symbol:
        """The time."""
        return sp.Symbol("t")

    @cached_property
    def equations(self) -> list[Expr]:
        """The equations as expressions that are zero."""
        return [left - right for left, right in self.model.sides]

    @cached_property
    def operators(self) -> exact.Operators:
        """P(D) x = Q(D) u + c; raises NotExact where the equations are not linear, or do not fix the unknowns."""
        model = self.model
        return exact.operators_of(self.equations, model.jets, model.unknowns, model.inputs, self.s)

    @cached_property
    def pieces(self) -> dict[str, tuple[exact.TransformPiece, ...]]:
        """What begins in each input, time by time."""
        return {name: exact.transform_pieces(self.inputs[name], self.t) for name in self.model.inputs}

    @cached_property
    def images(self) -> tuple[Expr, ...]:
        """The transforms of the inputs."""
        return tuple(exact.transform_of_pieces(self.pieces[name], self.t, self.s) for name in self.model.inputs)

    @cached_property
    def right(self) -> Any:
        """Q U + c/s + I, a column."""
        return self.operators.right_side(self.images, self.initial)

    @cached_property
    def solved(self) -> tuple[Expr, tuple[Expr, ...]]:
        """det P, and the numerators over it."""
        found: tuple[Expr, tuple[Expr, ...]] = exact.images_of_unknowns(self.operators, self.right)
        return found

    @cached_property
    def terms(self) -> dict[str, tuple[exact.DelayedImage, ...]]:
        """The transform of each unknown, its terms by dead times."""
        whole, parts = self.solved
        return {
            name: exact.read_image(part / whole, self.s) for name, part in zip(self.model.unknowns, parts, strict=True)
        }

    def image(self, name: str) -> Expr:
        """The transform of an unknown as it is shown: a fraction for each dead time."""
        parts = (exact.late_image(each.delay, each.image.whole, self.s) for each in self.terms[name])
        return sp.Add(*parts)

    def names(self, name: str) -> Names:
        """What an unknown or input and its transform are called."""
        shown = formula(self.model.symbol((name, 0)))
        return Names(formula(capital(name)), shown, self.s, self.t)

    def capital(self, name: str) -> Symbol:
        """The symbol of the transform of an unknown or input."""
        return capital(name)


def capital(name: str) -> Symbol:
    """Return the symbol of the transform of a function of time: X for x, with a hat where there is no capital."""
    base, *rest = name.split("_", 1)
    letter = base.rstrip("0123456789")
    known = letter in CAPITALS or (len(letter) == 1 and letter.islower())
    large = letter.capitalize() + base[len(letter) :] if known else f"{base}hat"
    return sp.Symbol("_".join([large.replace("Lamda", "Lambda"), *rest]))
