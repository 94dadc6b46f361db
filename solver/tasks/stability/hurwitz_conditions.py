"""Lemma: where the roots of a polynomial are inside, by its coefficients, where the roots themselves are of no use."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.arithmetic.determinants import leading_minors
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.matrices import determinant
from solver.tasks.stability.routh_array import bilinear_image_of
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr


@lemma("hurwitz_conditions")
def hurwitz_conditions_of(factor: exact.Factor, *, discrete: bool) -> Derivation[list[Expr]]:
    """What must be positive: Hurwitz's determinants (Gantmacher, XV §6), in discrete time of the bilinear image."""
    x, coefficients = sp.Symbol("lamda"), factor.coefficients
    yield Step(
        "no_roots",
        unclaimed="said of the factor; the conditions follow",
        p=factor.polynomial(x),
        degree=factor.degree,
        roots=bool(factor.roots),
    )
    if discrete:
        x = sp.Symbol("w")
        coefficients, _ = yield from bilinear_image_of(coefficients, x)
    H = exact.hurwitz_matrix(coefficients)
    minors = [sp.ImmutableMatrix(H[:k, :k]) for k in range(1, H.rows + 1)]
    positive = [_sign_inside(sp.factor(value)) for value in (coefficients[0], *map(exact.determinant, minors))]
    yield Step(
        "determinants",
        claims={
            f"minor{k}": Claim(determinant(M), value, Phrase("${name}$", name=f"\\Delta_{k}"))
            for k, (M, value) in enumerate(zip(minors, positive[1:], strict=True), 1)
        },
        steps=leading_minors(minors, positive[1:]),
        H=H,
        p=sp.Add(*(c * x ** (H.rows - i) for i, c in enumerate(coefficients))),
        lead=coefficients[0],
        conditions=[value for value in positive if exact.sign_of(value) != 1],
        never=any(exact.sign_of(value) in (0, -1) for value in positive),
    )
    return positive


def _sign_inside(value: Expr) -> Expr:
    """Return a product with its minus sign in a factor that has one: K(6 − K) for −K(K − 6)."""
    coefficient, rest = value.as_coeff_Mul()
    factors = sp.Mul.make_args(rest)
    for i, factor in enumerate(factors):
        if coefficient.is_negative and any(term.could_extract_minus_sign() for term in sp.Add.make_args(factor)):
            return sp.Mul(-coefficient, *factors[:i], sp.expand(-factor), *factors[i + 1 :])
    return value
