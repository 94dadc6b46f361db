"""Lemma: rational functions of z transformed back by residues: f(k) = Σ Res F(z) z^{k−1}."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient, total
from solver.stated.calculus import derivative, value_at
from solver.tasks.transforms.back_transform import denominator_in_factors
from solver.tasks.transforms.sequence_back import polar_forms

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.transforms.back_transform import Names


@lemma("sequence_residues")
def by_residues_in_z(image: exact.SequenceImage, names: Names) -> Derivation[tuple[Expr, Expr]]:
    """The sequence of a rational image; returns it with F as a sum of fractions. Raises Unsolved for improper F."""
    z, k, divided = names.s, names.t, image.divided
    if image.advanced:
        raise Unsolved("transforms/begins_before_zero", image=image.whole)
    proper: Any = divided.proper
    poles = exact.poles_of(proper, z)
    at_zero = [each for each in poles if each.root.value == 0]
    others = [each for each in poles if each.root.value != 0]
    yield Step("formula", unclaimed="the general formula", detail="full", whole=image.whole, divided=divided.whole,
               repeated=any(each.order > 1 for each in others), paired=any(each.paired for each in poles),
               at_zero=at_zero[0].order if at_zero else 0, **names.told)  # fmt: skip
    yield from denominator_in_factors(divided.as_shown, names.divided)
    yield from polar_forms(proper, names)
    for each in others:
        yield _residue(each, names)
    for each in at_zero:
        yield _at_zero(each, names)
    function = image.function(k)
    terms = [exact.fraction_of_term(term) for term in proper.partial_fractions(z)]
    claims = {
        "f": Claim(names.inverse(image.whole), function, "the sum of the residues"),
        "expansion": Claim(image.whole, total(*(z * term for term in terms)), "the residues as coefficients"),
    }
    yield Step("residues", claims=claims, function=function, several=len(poles) > 1, pulses=bool(at_zero),
               **names.told)  # fmt: skip
    return function, sp.Add(*(z * term for term in terms))


def _residue(pole: exact.Pole, names: Names) -> Step:
    """(1/(m − 1)!) dᵐ⁻¹/dzᵐ⁻¹ [G zᵏ] at the pole, G = (z − p)ᵐ F/z; of a pair twice the real part."""
    z, k, p = names.s, names.t, pole.root.value
    G, kernel = pole.functions[0], z**k
    shown: Any = product(G, kernel) if G != 1 else kernel
    amplitude = sp.Add(*pole.in_samples(k))
    value = product(amplitude, p**k) if amplitude.is_Add else amplitude * p**k
    claims: dict[str, Claim] = {}
    if pole.order > 1:
        derived = product(pole.derived_power(z, k), z ** (k - pole.order + 1))
        claims["derived"] = Claim(derivative(shown, z, pole.order - 1), derived, "the derivative")
        shown = derived
    at = value_at(shown, z, p)
    if pole.order > 2:
        at = product(quotient(sp.S.One, sp.factorial(pole.order - 1)), at)
    claims["value"] = Claim(at, value, "the residue")
    real = None
    if pole.paired:
        real = pole.real_in_samples(k)
        conjugate = [part.subs(sp.I, -sp.I) for part in (amplitude, p)]
        claims["real"] = Claim(
            total(value, product(conjugate[0], conjugate[1] ** k)), real, "both residues of the pair"
        )
    return Step("residue", claims=claims, pole=p, order=pole.order, paired=pole.paired, real=real, value=value,
                **names.told)  # fmt: skip


def _at_zero(pole: exact.Pole, names: Names) -> Step:
    """The residues of F z^{k−1} at zero for the few k for which there is a pole: of order m − k, k < m."""
    z, claims, rows = names.s, {}, []
    for k, c in enumerate(pole.coefficients):
        order = pole.order - k
        G = pole.functions[0]
        shown: Any = derivative(G, z, order - 1) if order > 1 else G
        at: Any = value_at(shown, z, sp.S.Zero)
        if order > 2:
            at = product(quotient(sp.S.One, sp.factorial(order - 1)), at)
        claims[f"at{k}"] = Claim(at, c, "the residue at zero")
        rows.append((k, order, c))
    return Step("at_zero", claims=claims, rows=rows, order=pole.order, **names.told)
