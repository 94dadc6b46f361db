"""Answers that a page shows together as equations: A, B, C and D as ẋ = … x + … u, y = … x + … u."""

from __future__ import annotations

from dataclasses import dataclass, replace

from solver.notation import spelled

Term = tuple[str, str]
"""An answer, with a minus before it where it is subtracted, and the LaTeX of what it acts on; "" for one."""


@dataclass(frozen=True, slots=True)
class Equation:
    """`left` = the sum of the terms; with `motion` the left side is the derivative, or the next value."""

    left: str
    terms: tuple[Term, ...]
    motion: bool = False

    def spelled(self, notation: str) -> Equation:
        """Return the equation in the symbols of a notation."""
        terms = tuple((name, spelled(on, notation)) for name, on in self.terms)
        return replace(self, left=spelled(self.left, notation), terms=terms)


@dataclass(frozen=True, slots=True)
class AnswerEquations:
    """Equations with their meaning; a page shows them `instead` of these answers, beside all others."""

    doc: str
    lines: tuple[Equation, ...]
    instead: tuple[str, ...] = ()

    @property
    def answers(self) -> tuple[str, ...]:
        """The names of the answers in it."""
        return tuple(dict.fromkeys(name.removeprefix("-") for line in self.lines for name, _ in line.terms if name))


def state_equations(x: str = "x", answers: str = "ABCD") -> AnswerEquations:
    """Return the equations of a system with the answers A, B, C and D, or some of them, whose state is called `x`."""
    terms = {name: (name, on) for name, on in (("A", x), ("B", "u"), ("C", x), ("D", "u")) if name in answers}
    motion, output = (tuple(terms[name] for name in pair if name in terms) for pair in ("AB", "CD"))
    lines = Equation(x, motion, motion=True), Equation("y", output)
    return AnswerEquations("the state equations", lines, tuple(answers))


def state_functions() -> AnswerEquations:
    """Return the equations of a system with the answers f and h: x' = f, y = h."""
    lines = Equation("x", (("f", ""),), motion=True), Equation("y", (("h", ""),))
    return AnswerEquations("the state equations", lines, ("f", "h"))


def control_law(*terms: Term) -> AnswerEquations:
    """Return u = the sum of the terms, beside the gains themselves."""
    return AnswerEquations("the control law", (Equation("u", terms),))
