"""Lemma: rational functions of s transformed back by residues: f(t) = Σ Res F(s) e^{st}."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient, total
from solver.stated.calculus import derivative, value_at
from solver.stated.transforms import inverse_laplace
from solver.tasks.transforms.back_transform import Names, denominator_in_factors

if TYPE_CHECKING:
    from sympy import Expr


@lemma("by_residues")
def with_residues(image: exact.RationalImage, names: Names) -> Derivation[tuple[Expr, Expr]]:
    """The function of time of a rational image; returns it with the sum of partial fractions."""
    s, t = names.s, names.t
    yield from denominator_in_factors(image, names)
    function = image.function(t)
    if image.proper is None:
        yield Step("impulses", unclaimed="impulses, by definition", function=function, **names.told)
        return function, image.polynomial(s)
    own = names.rest if image.direct else names
    poles = exact.poles_of(image.proper, s)
    yield Step("formula", unclaimed="the general formula", detail="full", several=len(poles) > 1,
               repeated=any(each.order > 1 for each in poles), paired=any(each.paired for each in poles),
               **own.told)  # fmt: skip
    for each in poles:
        yield _residue(each, own)
    smooth = image.proper.function(t, discrete=False).matrix[0]
    terms = [exact.fraction_of_term(term) for term in image.proper.partial_fractions(s)]
    claims = {
        "f": Claim(inverse_laplace(image.rest(s), s, t), smooth, "the sum of the residues"),
        "expansion": Claim(image.rest(s), total(*terms), "the residues as coefficients of partial fractions"),
    }
    yield Step("residues", claims=claims, function=function, direct=image.direct, several=len(poles) > 1,
               G=own.image, **names.told)  # fmt: skip
    return function, sp.Add(image.polynomial(s), *terms)


def _residue(pole: exact.Pole, names: Names) -> Step:
    """(1/(m − 1)!) dᵐ⁻¹/dsᵐ⁻¹ [G e^{st}] at the pole; of a pair twice the real part."""
    s, t, p = names.s, names.t, pole.root.value
    G, kernel = pole.functions[0], sp.exp(s * t)
    shown: Any = product(G, kernel) if G != 1 else kernel
    amplitude = pole.amplitude(t)
    value = product(amplitude, sp.exp(p * t)) if amplitude.is_Add else amplitude * sp.exp(p * t)
    claims: dict[str, Claim] = {}
    if pole.order > 1:
        derived = product(pole.derived(t), kernel)
        claims["derived"] = Claim(derivative(shown, s, pole.order - 1), derived, "the derivative")
        shown = derived
    at = value_at(shown, s, p)
    if pole.order > 2:
        at = product(quotient(sp.S.One, sp.factorial(pole.order - 1)), at)
    claims["value"] = Claim(at, value, "the residue")
    real = None
    if pole.paired:
        real = _twice_the_real_part(pole, names)
        conjugate = sp.Add(value.subs(sp.I, -sp.I)) if isinstance(value, sp.Expr) else product(
            amplitude.subs(sp.I, -sp.I), sp.exp(p.subs(sp.I, -sp.I) * t))  # fmt: skip
        claims["real"] = Claim(total(value, conjugate), real, "both residues of the pair")
    return Step("residue", claims=claims, pole=p, order=pole.order, paired=pole.paired, real=real,
                value=value, **names.told)  # fmt: skip


def _twice_the_real_part(pole: exact.Pole, names: Names) -> Expr:
    t, root = names.t, pole.root
    terms = []
    for j, c in enumerate(pole.coefficients):
        X, Y = exact.complex_parts(c)
        wave = 2 * X * sp.cos(root.shift * t) - 2 * Y * sp.sin(root.shift * t)
        terms.append(t**j / sp.factorial(j) * wave)
    return sp.expand(sp.Add(*terms)) * sp.exp(root.sigma * t) if root.sigma != 0 else sp.expand(sp.Add(*terms))
