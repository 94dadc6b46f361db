"""Poles of a sampled motion, z = e^{sT}."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.arithmetic.factors import one_after_the_other
from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Claim,
    Derivation,
    Given,
    Options,
    Refusal,
    Slip,
    Step,
    Task,
    option,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import digital as judges
from solver.options.poles import Poles
from solver.stated.algebra import difference, exponential, product
from solver.tasks.design.mapped_poles import mapped_poles
from solver.tasks.digital import digital_mistakes
from solver.tasks.sample_times import sample_time_of, sample_time_option, sample_time_refusals
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import StateSpace, System


@dataclass(frozen=True, kw_only=True)
class PoleMappingOptions(Options):
    """Poles in s, and the sampling period."""

    poles: tuple[Expr, ...] = option(Poles(), "the poles in s", required=True)
    sample_time: Expr | None = sample_time_option()


pole_mapping: Task[StateSpace, PoleMappingOptions] = Task(
    "pole_mapping",
    title="Poles in the z-plane",
    doc="Where z = e^{sT} takes poles in s, and the polynomial that has them; no system is needed.",
    needs=(),
    options=PoleMappingOptions,
    example={"poles": "[-1 ± 2j]", "sample_time": "T"},
    answers=[
        AnswerName("poles", "z_i", "the poles in z, in the order of those in s", principal=True, numbered=True,
                   earned=("mapped",)),
        AnswerName("polynomial", "p(z)", "the monic polynomial in z that has them", principal=True,
                   earned=("factors", "polynomial")),
    ],
)  # fmt: skip
ORACLE = "mpmath.exp (40 digits)"


@pole_mapping.refusal
def has_a_period(system: System, options: PoleMappingOptions) -> Iterable[Refusal]:
    """The period is given."""
    yield from sample_time_refusals(system, options)


@pole_mapping.method(source="Franklin, Powell, Workman, Digital Control of Dynamic Systems, §4.2.3")
def by_the_exponential(given: Given[StateSpace, PoleMappingOptions]) -> Derivation[Answers]:
    """z = e^{sT} of each pole, conjugates together in a quadratic factor, and all factors multiplied out."""
    z, T, poles = sp.Symbol("z"), sample_time_of(given), given.options.poles
    found = yield from mapped_poles(poles, T)
    factors = exact.factors_in_z(poles, T)
    yield _factors(poles, found, factors, T)
    polynomial = exact.product_in_z(factors, z)
    shown = [each.base.polynomial(z) for each in factors for _ in range(each.multiplicity)]
    yield Step(
        "polynomial",
        claims={"p": Claim(product(*shown), polynomial, Phrase("the polynomial"))},
        steps=one_after_the_other(z, [sp.Poly(each, z).all_coeffs() for each in shown]),
        factors=product(*shown),
        several=len(shown) > 1,
        polynomial=polynomial,
    )
    return Answers(poles=found, polynomial=polynomial)


def _factors(poles: Sequence[Expr], found: Sequence[Expr], factors: Sequence[exact.MappedRoot], T: Expr) -> Step:
    """The quadratic factors of the pairs, and where the poles lie."""
    z = sp.Symbol("z")
    claims = {}
    for i, each in enumerate((each for each in factors if each.pair), 1):
        ends = (exponential(product(root, T)) for root in (each.root, each.mirror))
        stated = product(*(difference(z, end) for end in ends))
        claims[f"pair{i}"] = Claim(stated, each.polynomial(z), Phrase("pair {i}", i=i))
    stable = [each.root.as_real_imag()[0].is_negative for each in factors]
    verdict = True if all(stable) else False if any(side is False for side in stable) else None
    return Step("factors", claims=claims, unclaimed="" if claims else "no pair is among them", poles=list(poles),
                found=list(found), stable=verdict, pairs=[each for each in factors if each.pair], T=T)  # fmt: skip


@pole_mapping.verification("poles", "polynomial")
def are_exponentials(given: Given[StateSpace, PoleMappingOptions], answers: Answers) -> Iterable[Check]:
    """Each pole is e^{sT} of another one in s; the polynomial has the values of Π(z − e^{sT})."""
    T, z = sample_time_of(given), sp.Symbol("z")
    if "poles" in answers:
        yield numeric.check_residual(Phrase("$z_i = e^{{s_i T}}$"), ORACLE, lambda: judges.mapped_residual(
            given.options.poles, T, list(answers["poles"])), answer="poles")  # fmt: skip
    if "polynomial" in answers:
        stated = product(*(difference(z, exponential(product(s, T))) for s in given.options.poles))
        yield numeric.check_claim(Claim(stated, answers["polynomial"]), Phrase(r"$p(z) = \prod_i (z - e^{{s_i T}})$"),
                                  answer="polynomial")  # fmt: skip


@pole_mapping.consequence("polynomial", of=("poles",), symbolic=False)
def has_these_poles(given: Given[StateSpace, PoleMappingOptions], found: Mapping[str, Any]) -> Any:  # noqa: ARG001
    """Π(z − zᵢ), multiplied out."""
    z = sp.Symbol("z")
    return sp.expand(sp.Mul(*(z - each for each in found["poles"])), power_exp=False)


NOT_MAPPED = Slip("not_mapped", "these are the poles in $s$: in the $z$-plane the left half plane is no region of "
                                "stability, the unit disc is")  # fmt: skip


@pole_mapping.mistake(NOT_MAPPED, "poles")
def left_in_s(wrong: Attempt[StateSpace, PoleMappingOptions]) -> Iterable[Any]:
    """The poles as they are."""
    yield list(wrong.given.options.poles)


@pole_mapping.mistake(NOT_MAPPED, "polynomial")
def polynomial_in_s(wrong: Attempt[StateSpace, PoleMappingOptions]) -> Iterable[Any]:
    """Π(z − sᵢ)."""
    z = sp.Symbol("z")
    yield sp.expand(sp.Mul(*(z - s for s in wrong.given.options.poles)))


digital_mistakes.period_left_out(pole_mapping)
