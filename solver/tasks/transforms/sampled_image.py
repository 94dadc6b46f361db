"""Lemma: the z-transform of a sampled function from its image in s: partial fractions, samples, table."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.tasks.transforms.back_transform import Names, by_partial_fractions, split_by_delays
from solver.tasks.transforms.forward import terms_of

if TYPE_CHECKING:
    from sympy import Expr


@dataclass(frozen=True)
class SampledTerm:
    """A term e^{−τs} G(s) that begins to be seen at the sample n, μ = n − τ/T of a period after it has begun."""

    image: exact.RationalImage
    delay: Expr
    n: Expr
    ahead: Expr


def terms_to_sample(F: Expr, T: Expr) -> tuple[SampledTerm, ...]:
    """The terms of an image in s; raises NotExact for impulses, and for dead times not in periods."""
    found = []
    for each in exact.read_image(F, sp.Symbol("s")):
        if each.image.direct:
            raise exact.NotExact("transforms/impulses_sampled", image=each.image.whole)
        periods = sp.cancel(each.delay / T)
        if not periods.is_number:
            raise exact.NotExact("transforms/periods_of_delay", delay=each.delay, T=T)
        n = sp.ceiling(periods)
        found.append(SampledTerm(each.image, each.delay, n, n - periods))
    return tuple(found)


@lemma("sampled_image")
def samples_transformed(F: Expr, T: Expr, names: Names) -> Derivation[tuple[Expr, set[str]]]:
    """The transform of f(kT), with the rules that it took."""
    s, t = sp.Symbol("s"), sp.Symbol("t")
    continuous = Names(names.image, names.function, s, t)
    terms = terms_to_sample(F, T)
    used: set[str] = set()
    split = len(terms) > 1 or terms[0].delay != 0
    if split:
        yield from split_by_delays(exact.read_image(F, s), F, continuous)
    parts: list[tuple[Expr, Expr]] = []
    for number, each in enumerate(terms, 1):
        own = continuous.part(number) if split else continuous
        factor, before = _multiple(each, terms[: number - 1])
        if factor is not None:
            image = factor * parts[before - 1][1]
            yield Step("as_before", unclaimed="a multiple of what was found", number=number, before=before,
                       factor=factor, image=image, **names.told)  # fmt: skip
        else:
            f, _ = yield from by_partial_fractions(each.image, own)
            image = yield from _sampled(f, each, T, (own, names.part(number) if split else names), used)
        parts.append((each.n, image))
    whole = sp.Add(*(exact.moved_image(n, image, names.s) for n, image in parts))
    if split:
        used |= {"delay"} | ({"linearity"} if len(parts) > 1 else set())
        yield Step("delayed", unclaimed="each at its sample", parts=parts, whole=whole,
                   terms=[(each.delay, each.n, each.ahead) for each in terms], T=T, **names.told)  # fmt: skip
    return whole, used


def _multiple(term: SampledTerm, earlier: tuple[SampledTerm, ...]) -> tuple[Expr | None, int]:
    """The factor by which a term is a multiple of an earlier one seen at the same times, and the number of that."""
    for number, each in enumerate(earlier, 1):
        factor = exact.ratio_of_images(term.image, each.image) if each.ahead == term.ahead else None
        if factor is not None:
            return factor, number
    return None, 0


@lemma("sampled_image")
def _sampled(f: Expr, term: SampledTerm, T: Expr, both: tuple[Names, Names], used: set[str]) -> Derivation[Expr]:
    """The samples, their transforms by the table, and the sum over one denominator."""
    continuous, names = both
    t, z, k = continuous.t, names.s, names.t
    image = exact.sampled_image(f, t, T, term.ahead)
    time = sp.expand((k + term.ahead) * T)
    sequence = image.sequence(k)
    claim = Claim(f.subs(t, time), sequence, "the function at the samples")
    yield Step("sampled", claims={"f": claim}, time=time, T=T, ahead=term.ahead, f=continuous.function,
               sequence=sequence, jumps=_jumps(term.image, continuous.s))  # fmt: skip
    terms = exact.terms_of_samples(image)
    yield from terms_of(terms, names, used, set())
    if len(terms) > 1 or any(each.factor != 1 for each in terms):
        used.add("linearity")
    images = [product(each.factor, each.pairs(k, z)[-1].image) for each in terms]
    together = _together(image, z)
    claims = {"F": Claim(total(*images), together, "over one denominator")}
    yield Step("together", claims=claims, several=len(terms) > 1, **names.told)
    return together


def _jumps(image: exact.RationalImage, s: Any) -> bool:
    """Whether the function begins with a jump: the denominator is of one degree more."""
    return bool(sp.degree(image.denominator, s) - sp.degree(image.numerator, s) == 1)


def _together(image: exact.SampledImage, z: Any) -> Expr:
    """z N(z) over the product of the denominators, N without fractions."""
    degree = len(image.numerator) - 1
    whole = sp.Add(*(c * z ** (degree - i) for i, c in enumerate(image.numerator)))
    marks = {each: sp.Dummy() for each in whole.atoms(sp.exp)}  # e^{-T} is no fraction
    back = {mark: each for each, mark in marks.items()}
    above, common = sp.fraction(sp.together(whole.xreplace(marks)))
    above = sp.factor_terms(sp.collect(sp.expand(above), z)).xreplace(back)
    below = sp.Mul(*(base.polynomial(z) ** -m for base, m in image.factors))
    found: Expr = z * above * below / common.xreplace(back)
    return found
