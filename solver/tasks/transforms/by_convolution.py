"""Lemma: a product of images transformed back by convolution: F₁ F₂ is the transform of f₁ ∗ f₂."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.arithmetic.exactness import at_full
from solver.arithmetic.integrals import integrated
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.stated.calculus import integral
from solver.stated.transforms import inverse_laplace
from solver.tasks.transforms.back_transform import Names, by_partial_fractions, denominator_in_factors

if TYPE_CHECKING:
    from sympy import Expr


@lemma("by_convolution")
def with_convolution(image: exact.RationalImage, names: Names) -> Derivation[tuple[Expr, Expr]]:
    """The function of time of a product; returns it with the sum of partial fractions. Raises Unsolved."""
    s, t = names.s, names.t
    if image.proper is not None and not image.direct and len(image.proper.partial_fractions(s)) == 1:
        return (yield from by_partial_fractions(image, names))  # there is nothing to convolve
    factors = exact.factors_for_convolution(image, s)
    if not factors or image.proper is None:
        raise Unsolved("transforms/no_product", image=image.given, proper=not image.direct)
    yield from denominator_in_factors(image, names)
    images = [exact.rational_image(each, s) for each in factors]
    functions = [each.function(t) for each in images]
    claims = {
        f"f{i}": Claim(inverse_laplace(F, s, t), f, "from the table")
        for i, (F, f) in enumerate(zip(factors, functions, strict=True), 1)
    }
    claims["product"] = Claim(image.whole, product(*factors), "the image as a product")
    yield Step("factors", claims=claims, factors=list(factors), functions=functions, **names.told)
    whole, found = factors[0], functions[0]
    for number, (F, f) in enumerate(zip(factors[1:], functions[1:], strict=True), 2):
        whole = whole * F
        value = exact.rational_image(whole, s).function(t)
        yield _convolved(found, f, value, (number, len(factors)), names)
        found = value
    terms = [exact.fraction_of_term(term) for term in image.proper.partial_fractions(s)]
    claim = Claim(image.whole, total(*terms), "partial fractions")
    yield Step("expansion", claims={"expansion": claim}, **names.told)
    return found, sp.Add(*terms)


def _convolved(left: Expr, right: Expr, value: Expr, place: tuple[int, int], names: Names) -> Step:
    """∫ g(τ) f(t − τ) dτ from 0 to t, carried out."""
    t, tau = names.t, sp.Symbol("tau")
    here, mirrored = left.xreplace({t: tau}), right.xreplace({t: t - tau})
    integrand = sp.powsimp(sp.expand_mul(here * mirrored), combine="exp")
    claims = {"integral": Claim(integral(integrand, tau, sp.S.Zero, t), value, "convolution")}
    if here * mirrored != integrand:
        claims["integrand"] = Claim(product(here, mirrored), integrand, "what is integrated")
    column, wanted = sp.ImmutableMatrix([integrand]), sp.ImmutableMatrix([value])
    steps = at_full(integrated, column, tau, sp.S.Zero, t, wanted)
    number, count = place
    return Step("convolution", claims=claims, steps=steps, number=number, last=number == count, tau=tau,
                **names.told)  # fmt: skip
