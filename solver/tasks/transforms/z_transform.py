"""z-transforms of sequences by linearity, a table and rules, and of sampled functions by their partial fractions."""

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
from solver.tasks.sample_times import sample_time_of, sample_time_option, sample_time_refusals
from solver.tasks.transforms.back_transform import Names
from solver.tasks.transforms.forward import transformed
from solver.tasks.transforms.sampled_image import samples_transformed, terms_to_sample
from solver.tasks.transforms.sequence_mistakes import name_mistakes_of_z_images
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import StateSpace


@dataclass(frozen=True, kw_only=True)
class ZTransformOptions(Options):
    """The sequence, or the image of the function that is sampled."""

    f: Expr | None = option(
        Expression(("k",)), "the sequence, k ≥ 0, with step(k − n) and delta(k − n) where it has them"
    )
    F: Expr | None = option(Expression(("s",)), "in place of it the image in s of a function that is sampled")
    sample_time: Expr | None = sample_time_option()


z_transform: Task[StateSpace, ZTransformOptions] = Task(
    "z_transform",
    title="z-transform",
    doc="The transform of a sequence f(k), k ≥ 0, or of the samples f(kT) of a function with a given image in s.",
    needs=(),
    options=ZTransformOptions,
    example={"f": '"k (1/2)^k + step(k - 2)"'},
    answers=[
        AnswerName("F", "F(z)", "the transform", principal=True,
                   earned=("by_rules", "late", "table", "impulse", "sampled", "together")),
    ],
    sampled=True,
)  # fmt: skip

RULES = ("linearity", "impulse", "constant", "power", "square", "exponential", "cos", "sin", "cosh", "sinh",
         "damping", "derivative", "delay", "sifting")  # fmt: skip
"""The lines of the table of rules, in the order in which it has them."""


@z_transform.refusal
def no_such_sequence(system: Any, options: ZTransformOptions) -> Iterable[Refusal]:
    """Neither a sequence nor an image, or both; one whose transform is not rational; no sampling period."""
    if (options.f is None) == (options.F is None):
        yield "", Reason("transforms/sequence_or_image", {"both": options.f is not None})
        return
    image: Any = options.F
    try:
        if options.f is not None:
            exact.sequence_pieces(options.f, sp.Symbol("k"))
            return
        missing = list(sample_time_refusals(system, options))
        yield from missing
        if not missing:
            T = options.sample_time if options.sample_time is not None else system.sample_time
            terms_to_sample(image, T)
    except exact.NotExact as failure:
        yield "F" if options.f is None else "f", _of_a_sequence(failure.reason)


def _of_a_sequence(reason: Reason) -> Reason:
    """A reason that speaks of an input, as one that speaks of a sequence."""
    if reason.kind == "signals/not_real":
        return Reason("transforms/sequence_not_real", reason.values)
    if reason.kind == "signals/no_rational_transform":
        return Reason("transforms/no_rule_for_sequence", reason.values)
    return reason


@z_transform.method(source="Ogata, Discrete-Time Control Systems, §2–3")
def by_rules(given: Given[StateSpace, ZTransformOptions]) -> Derivation[Answers]:
    """Each term by the table, −z d/dz for powers of k, scaling for aᵏ, z⁻ⁿ for what begins later."""
    names = Names("F", "f", sp.Symbol("z"), sp.Symbol("k"))
    image, f = given.options.F, given.options.f
    if image is not None:
        F, used = yield from samples_transformed(image, sample_time_of(given), names)
    else:
        F, used = yield from _of_sequence(f if f is not None else sp.S.Zero, names)
    yield Step("rules", unclaimed="general rules", detail="full", used=[each for each in RULES if each in used])
    return Answers(F=F)


def _of_sequence(f: Expr, names: Names) -> Derivation[tuple[Expr, set[str]]]:
    """The transform of a sequence, with the rules that it took."""
    k, z = names.t, names.s
    values = exact.finite_values(f, k)
    if values is not None:
        F = sp.Add(*(value * z**-n for n, value in enumerate(values)))
        yield Step("finite", unclaimed="values of the sequence", values=list(values), image=F, **names.told)
        return F, {"impulse"} | ({"linearity"} if sum(value != 0 for value in values) > 1 else set())
    pieces = exact.sequence_pieces(f, k)
    used = yield from transformed(f, pieces, names)
    F = exact.sequence_transform(pieces, k, z)
    parts = [exact.moved_image(each.delay, each.image(k, z), z) for each in pieces]
    count = sum(len(each.terms) + (each.impulse != 0) for each in pieces)
    yield Step("sum", unclaimed="the terms added", image=total(*parts), single=count == 1,
               late=len(pieces) == 1 and pieces[0].delay != 0 and pieces[0].impulse == 0, nothing=not pieces,
               radius=exact.radius_of(pieces), **names.told)  # fmt: skip
    return F, used


@z_transform.verification("F")
def is_the_series(given: Given[StateSpace, ZTransformOptions], answers: Answers) -> Iterable[Check]:
    """Σ f(k) z⁻ᵏ at large |z|; of a sampled function the samples, by contour integrals in s and in z."""
    options, F, z = given.options, answers["F"], sp.Symbol("z")
    if options.f is not None:
        label = r"$F(z) = \sum_{k=0}^{\infty} f(k)\,z^{-k}$"
        yield numeric.check_claim(Claim(F, judges.series_of(options.f, sp.Symbol("k"), z)), label)
        return
    try:
        for sample, wanted, step in judges.sampled_values(options.F, sp.Symbol("s"), sample_time_of(given), F, z):
            label = Phrase("the sample $f({k}\\,T)$ by contour integrals in $z$ and in $s$", k=step)
            yield numeric.check_claim(Claim(sample, wanted), label)
    except numeric.NotEvaluable as refusal:
        yield Check.skipped("the samples", "contour integral", refusal.reason)


name_mistakes_of_z_images(z_transform)
