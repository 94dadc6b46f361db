"""Inverse z-transforms by the partial fractions of F/z, by residues and by long division; delays, poles at zero."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, CheckStatus, Claim, Derivation, Given, Options, Task, option
from solver.derivation.registry import Refusal
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import transforms as judges
from solver.options.expression import Expression
from solver.options.integer import Integer
from solver.tasks.transforms.back_transform import Names
from solver.tasks.transforms.divided_on_paper import by_long_division
from solver.tasks.transforms.sequence_back import by_fractions_over_z, first_terms, in_powers_of_z, of_image
from solver.tasks.transforms.sequence_mistakes import name_mistakes_of_sequences
from solver.tasks.transforms.sequence_residues import by_residues_in_z
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import StateSpace
    from solver.tasks.transforms.sequence_back import Way

USUAL_TERMS, MOST_TERMS = 6, 40


@dataclass(frozen=True, kw_only=True)
class InverseZOptions(Options):
    """The image."""

    F: Expr = option(Expression(("z",)), "the image in z or in z^-1, rational", required=True)
    terms: int = option(Integer(1, MOST_TERMS), "how many values, from k = 0 on", default=USUAL_TERMS)


inverse_z_transform: Task[StateSpace, InverseZOptions] = Task(
    "inverse_z_transform",
    title="Inverse z-transform",
    doc="The sequence f(k), k ≥ 0, with a given image; no system is needed.",
    needs=(),
    options=InverseZOptions,
    example={"F": '"z/(z^2 - 3z + 2)"'},
    answers=[
        AnswerName("f", "f", "the sequence, $k \\ge 0$", principal=True, optional=True,
                   earned=("partial_fractions", "times_z", "delays", "divide_by_z", "residue")),
        AnswerName("partial_fractions", "F", "the image as a sum of partial fractions, each with its $z$",
                   optional=True),
        AnswerName("values", r"\text{values}", "$f(0), f(1), f(2), \\ldots$",
                   ordered=True, numbered=True, principal=True, earned=("scheme", "first_terms")),
    ],
    sampled=True,
)  # fmt: skip


@inverse_z_transform.refusal
def no_such_image(_system: Any, options: InverseZOptions) -> Iterable[Refusal]:
    """An image that is not rational."""
    try:
        exact.sequence_image(options.F, sp.Symbol("z"))
    except exact.NotExact as failure:
        yield "F", failure.reason


@inverse_z_transform.method(
    "partial_fractions", title="Partial fractions", source="Ogata, Discrete-Time Control Systems, §2–5"
)
def with_partial_fractions(given: Given[StateSpace, InverseZOptions]) -> Derivation[Answers]:
    """F/z as a sum of fractions, each coefficient found by itself; times z the table has them."""
    return (yield from _transformed_back(given, by_fractions_over_z))


@inverse_z_transform.method("residues", title="Residues", source="Ogata, Discrete-Time Control Systems, §2–5")
def by_residues(given: Given[StateSpace, InverseZOptions]) -> Derivation[Answers]:
    """The sum of the residues of F(z) z^{k−1}, those at zero for the few k for which there are any."""
    return (yield from _transformed_back(given, by_residues_in_z))


@inverse_z_transform.method("long_division", title="Long division", source="Ogata, Discrete-Time Control Systems, §2–5")
def on_paper(given: Given[StateSpace, InverseZOptions]) -> Derivation[Answers]:
    """Numerator divided by denominator by falling powers of z: the quotient is the series Σ f(k) z⁻ᵏ."""
    z, F = sp.Symbol("z"), given.options.F
    names = Names("F", "f", z, sp.Symbol("k"))
    image = exact.sequence_image(F, z)
    yield from in_powers_of_z(F, image, names)
    values = yield from by_long_division(image.fraction, given.options.terms, names)
    return Answers(values=list(values))


def _transformed_back(given: Given[StateSpace, InverseZOptions], way: Way) -> Derivation[Answers]:
    """What belongs to each delay transformed back by itself, shifted and added."""
    names = Names("F", "f", sp.Symbol("z"), sp.Symbol("k"))
    F = given.options.F
    values = exact.long_division(exact.sequence_image(F, names.s).fraction, names.s, given.options.terms).values
    f, fractions = yield from of_image(F, way, names)
    yield from first_terms(f, values, names)
    return Answers(f=f, partial_fractions=fractions, values=list(values))


@inverse_z_transform.verification("f")
def has_the_image(given: Given[StateSpace, InverseZOptions], answers: Answers) -> Iterable[Check]:
    """Σ f(k) z⁻ᵏ is F at large |z|; where that cannot be judged, single values are contour integrals of F."""
    F, f, z, k = given.options.F, answers["f"], sp.Symbol("z"), sp.Symbol("k")
    count, first = judges.telling_samples(F, z)
    if first == 0:
        label = r"$\sum_{k=0}^{\infty} f(k)\,z^{-k} = F(z)$"
        series = numeric.check_claim(Claim(judges.series_of(f, k, z), F), label)
        yield series
        if series.status is not CheckStatus.SKIPPED:
            return
    for value, wanted, step in judges.samples_of_image(F, z, f, k, first, count - first):
        label = Phrase("$f({k})$ as a contour integral of $F(z)\\,z^{{k-1}}$", k=step)
        yield numeric.check_claim(Claim(value, wanted), label)


@inverse_z_transform.verification("values")
def are_the_first_values(given: Given[StateSpace, InverseZOptions], answers: Answers) -> Iterable[Check]:
    """Each is a contour integral of F."""
    F, values = given.options.F, list(answers["values"])
    yield Check.that("as many values as asked for", "counted", len(values) >= given.options.terms)
    for step, (value, wanted) in enumerate(
        zip(values, judges.values_of_image(F, sp.Symbol("z"), len(values)), strict=True)
    ):
        label = Phrase("$f({k})$ as a contour integral of $F(z)\\,z^{{k-1}}$", k=step)
        yield numeric.check_claim(Claim(value, wanted), label)


@inverse_z_transform.verification("partial_fractions")
def adds_up_to_the_image(given: Given[StateSpace, InverseZOptions], answers: Answers) -> Iterable[Check]:
    """The sum is F at random z, and each of its terms has one pole or a pair, to a power."""
    total = answers["partial_fractions"]
    yield numeric.check_claim(Claim(total, given.options.F), "the partial fractions add up to $F(z)$")
    holds = judges.are_partial(total, sp.Symbol("z"), sampled=True)
    yield Check.that("each term is a partial fraction", "sympy.factor_list", holds)


name_mistakes_of_sequences(inverse_z_transform)
