"""Laplace transforms by linearity, the table and rules: shifts, powers of time, impulses."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Claim, Derivation, Given, Options, Step, Task, option
from solver.derivation.registry import Refusal
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import transforms as judges
from solver.options.expression import Expression
from solver.stated.algebra import total
from solver.tasks.transforms.back_transform import Names
from solver.tasks.transforms.forward import transformed
from solver.tasks.transforms.transform_mistakes import name_mistakes_of_images
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import StateSpace


@dataclass(frozen=True, kw_only=True)
class LaplaceOptions(Options):
    """The function."""

    f: Expr = option(
        Expression(("t",)), "the function of t ≥ 0, with step(t − T) and delta(t − T) where it has them", required=True
    )


laplace_transform: Task[StateSpace, LaplaceOptions] = Task(
    "laplace_transform",
    title="Laplace transform",
    doc="The transform of a function of t ≥ 0 by a table and rules; no system is needed.",
    needs=(),
    options=LaplaceOptions,
    example={"f": '"t exp(-2t) + step(t - 1)"'},
    answers=[AnswerName("F", "F", "the transform", principal=True, earned=("by_rules", "late", "table", "impulse"))],
)

RULES = ("linearity", "constant", "power", "exponential", "cos", "sin", "cosh", "sinh", "damping", "derivative",
         "delay", "impulse", "sifting")  # fmt: skip
"""The lines of the table of rules, in the order in which it has them."""


@laplace_transform.refusal
def no_rational_transform(_system: Any, options: LaplaceOptions) -> Iterable[Refusal]:
    """A function whose transform is not rational but for dead times."""
    try:
        exact.transform_pieces(options.f, sp.Symbol("t"))
    except exact.NotExact as failure:
        yield "f", _of_a_function(failure.reason)


def _of_a_function(reason: Reason) -> Reason:
    """A reason that speaks of an input, as one that speaks of a function."""
    if reason.kind == "signals/not_real":
        return Reason("transforms/function_not_real", reason.values)
    if reason.kind == "signals/no_rational_transform":
        return Reason("transforms/no_rule", reason.values)
    return reason


@laplace_transform.method(source="Nise, Control Systems Engineering, §2.2", time="continuous")
def by_rules(given: Given[StateSpace, LaplaceOptions]) -> Derivation[Answers]:
    """Each term by the table, derivatives for powers of t, shifts for e^{at} and for what begins later."""
    names = Names("F", "f", sp.Symbol("s"), sp.Symbol("t"))
    f, t, s = given.options.f, names.t, names.s
    pieces = exact.transform_pieces(f, t)
    used = yield from transformed(f, pieces, names)
    F = exact.transform_of_pieces(pieces, t, s)
    parts = [exact.late_image(each.delay, each.image(t, s), s) for each in pieces]
    count = sum(len(each.terms) + (each.impulse != 0) for each in pieces)
    yield Step("sum", unclaimed="the terms added", image=total(*parts), single=count == 1,
               late=len(pieces) == 1 and pieces[0].delay != 0 and pieces[0].impulse == 0, nothing=not pieces,
               growth=exact.abscissa_of(pieces), **names.told)  # fmt: skip
    yield Step("rules", unclaimed="general rules", detail="full", used=[each for each in RULES if each in used])
    return Answers(F=F)


@laplace_transform.verification("F")
def is_the_integral(given: Given[StateSpace, LaplaceOptions], answers: Answers) -> Iterable[Check]:
    """∫ f e^{−st} dt by quadrature, impulses for themselves, at random complex s."""
    f, s, t = given.options.f, sp.Symbol("s"), sp.Symbol("t")
    label = r"$F(s) = \int_{0^-}^{\infty} f(t)\,e^{-st}\,dt$"
    try:
        yield numeric.check_claim(Claim(answers["F"], judges.transform_of(f, t, s)), label)
    except numeric.NotEvaluable as refusal:
        yield Check.skipped(label, "Gauss–Legendre quadrature", refusal.reason)


name_mistakes_of_images(laplace_transform)
