"""Inverse Laplace transforms by partial fractions, by residues and by convolution; dead times, impulses."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Claim, Derivation, Given, Options, Task, option
from solver.derivation.registry import Refusal
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import transforms as judges
from solver.options.expression import Expression
from solver.tasks.transforms.back_transform import (
    Names,
    by_partial_fractions,
    multiple_of_earlier,
    put_together,
    split_by_delays,
)
from solver.tasks.transforms.by_convolution import with_convolution
from solver.tasks.transforms.by_residues import with_residues
from solver.tasks.transforms.transform_mistakes import name_mistakes_of_functions

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import StateSpace

    Way = Callable[[exact.RationalImage, Names], Derivation[tuple[Expr, Expr]]]


@dataclass(frozen=True, kw_only=True)
class InverseLaplaceOptions(Options):
    """The image."""

    F: Expr = option(Expression(("s",)), "the image in s, rational, or a sum of such times e^{−Ts}", required=True)


inverse_laplace_transform: Task[StateSpace, InverseLaplaceOptions] = Task(
    "inverse_laplace_transform",
    title="Inverse Laplace transform",
    doc="The function of t ≥ 0 with a given image; no system is needed.",
    needs=(),
    options=InverseLaplaceOptions,
    example={"F": '"1/(s^2 + 3s + 2)"'},
    answers=[
        AnswerName("f", "f", "the function of $t \\ge 0$",
                   principal=True, earned=("partial_fractions", "delays", "divided")),
        AnswerName("partial_fractions", "F", "the image as a sum of partial fractions"),
    ],
)  # fmt: skip


@inverse_laplace_transform.refusal
def no_such_image(_system: Any, options: InverseLaplaceOptions) -> Iterable[Refusal]:
    """An image that is not rational but for dead times."""
    try:
        exact.read_image(options.F, sp.Symbol("s"))
    except exact.NotExact as failure:
        yield "F", failure.reason


@inverse_laplace_transform.method(
    "partial_fractions", title="Partial fractions", source="Ogata, Modern Control Engineering, §2–5", time="continuous"
)
def with_partial_fractions(given: Given[StateSpace, InverseLaplaceOptions]) -> Derivation[Answers]:
    """F as a sum of fractions that a table of transforms has, each coefficient found by itself."""
    return (yield from _transformed_back(given, by_partial_fractions))


@inverse_laplace_transform.method(
    "residues", title="Residues", source="Churchill, Operational Mathematics, §67", time="continuous"
)
def by_residues(given: Given[StateSpace, InverseLaplaceOptions]) -> Derivation[Answers]:
    """The sum of the residues of F(s) e^{st}, of repeated poles by derivatives."""
    return (yield from _transformed_back(given, with_residues))


@inverse_laplace_transform.method(
    "convolution", title="Convolution", source="Nise, Control Systems Engineering, §2.2", time="continuous"
)
def by_convolution(given: Given[StateSpace, InverseLaplaceOptions]) -> Derivation[Answers]:
    """F = F₁ F₂ with both in the table; f is the integral of f₁(τ) f₂(t − τ)."""
    return (yield from _transformed_back(given, with_convolution))


def _transformed_back(given: Given[StateSpace, InverseLaplaceOptions], way: Way) -> Derivation[Answers]:
    """What belongs to each dead time transformed back by itself, shifted and added."""
    F, names = given.options.F, Names("F", "f", sp.Symbol("s"), sp.Symbol("t"))
    terms = exact.read_image(F, names.s)
    if len(terms) == 1 and terms[0].delay == 0:
        f, fractions = yield from way(terms[0].image, names)
        return Answers(f=f, partial_fractions=fractions)
    yield from split_by_delays(terms, F, names)
    found: list[tuple[Expr, Expr]] = []
    for number, each in enumerate(terms, 1):
        ratios = ((exact.ratio_of_images(each.image, terms[i].image), i) for i in range(number - 1))
        factor, before = next((pair for pair in ratios if pair[0] is not None), (None, 0))
        if factor is None:
            found.append((yield from way(each.image, names.part(number))))
            continue
        function = sp.expand(factor * found[before][0])
        yield from multiple_of_earlier(number, factor, before + 1, function, names)
        found.append((function, sp.expand(factor * found[before][1])))
    f = yield from put_together(terms, [each for each, _ in found], names)
    whole = sp.Add(*(sp.exp(-each.delay * names.s) * own for each, (_, own) in zip(terms, found, strict=True)))
    return Answers(f=f, partial_fractions=whole)


@inverse_laplace_transform.verification("f")
def has_the_image(given: Given[StateSpace, InverseLaplaceOptions], answers: Answers) -> Iterable[Check]:
    """∫ f e^{−st} dt by quadrature is F at random s; f between its jumps is the contour integral of F."""
    F, f, s, t = given.options.F, answers["f"], sp.Symbol("s"), sp.Symbol("t")
    try:
        yield numeric.check_claim(Claim(judges.transform_of(f, t, s), F), r"$\mathcal{L}\{f(t)\} = F(s)$")
        for left, right in judges.values_in_time(F, s, f, t):
            yield numeric.check_claim(Claim(left, right), r"$f(t) = \mathcal{L}^{-1}\{F(s)\}$")
    except numeric.NotEvaluable as refusal:
        yield Check.skipped("the transform of $f$", "Gauss–Legendre quadrature", refusal.reason)


@inverse_laplace_transform.verification("partial_fractions")
def adds_up_to_the_image(given: Given[StateSpace, InverseLaplaceOptions], answers: Answers) -> Iterable[Check]:
    """The sum is F at random s, and each of its terms has one pole or a pair, to a power."""
    total = answers["partial_fractions"]
    yield numeric.check_claim(Claim(total, given.options.F), "the partial fractions add up to $F(s)$")
    yield Check.that("each term is a partial fraction", "sympy.factor_list", judges.are_partial(total, sp.Symbol("s")))


name_mistakes_of_functions(inverse_laplace_transform)
