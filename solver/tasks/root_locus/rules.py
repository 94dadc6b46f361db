"""Lemma: poles and zeros of L, the branches, their parts of the real axis, and their asymptotes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.roots import factored as found_by_trial
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient, total
from solver.words import Phrase

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sympy import Expr, Symbol

    from solver.tasks.root_locus.locus_equation import Form


@lemma("locus_rules")
def rules_of(form: Form) -> Derivation[tuple[list[Any], exact.Asymptotes | None]]:
    """The rules that need poles and zeros only; returns the segments and the asymptotes."""
    equation = form.equation
    poles, zeros = (exact.roots_with_factors(p) for p in (equation.denominator, equation.numerator))
    n, m = equation.denominator.degree(), equation.numerator.degree()
    given = form.in_factors or (None, None)
    factors = {
        name: Claim(value, product_of, Phrase("the factors of {name}", name=name))
        for name, value, typed in (("N", form.N, given[0]), ("D", form.D, given[1]))
        if not _tells_roots(typed, form.s) and (product_of := factored(value, form.s)) is not None
    }
    trials = tuple(line for each in factors.values() for line in found_by_trial(each.left, each.right, form.s))
    yield Step("poles_zeros", claims=factors, unclaimed="" if factors else "they are read off", steps=trials, K=form.K,
               s=form.s,
               N=form.N, D=form.D, n=n, m=m, poles=_listed(poles), zeros=_listed(zeros), lead=equation.lead,
               positive=equation.positive)  # fmt: skip
    yield Step("branches", unclaimed="counted", n=n, m=m, q=n - m, K=form.K, poles=_listed(poles), zeros=_listed(zeros),
               infinity=None if n > m or equation.positive else sp.radsimp(-1 / equation.lead))  # fmt: skip
    segments = exact.real_axis_segments(equation)
    points = exact.real_points(equation)
    yield Step("segments", unclaimed="the answer, which has a check of its own", segments=segments,
               positive=equation.positive, K=form.K, s=form.s,
               points=[(each.point.value, each.pole, each.point.multiplicity) for each in points])  # fmt: skip
    lines = exact.asymptotes(equation)
    if lines is None:
        yield Step("no_asymptotes", unclaimed="counted", n=n)
    else:
        yield _asymptotes(lines, n - m, (_listed(poles), _listed(zeros)), positive=equation.positive)
    return segments, lines


def _tells_roots(typed: Expr | None, s: Symbol) -> bool:
    """Whether a polynomial was given in factors of which none can be split."""
    if typed is None:
        return False
    bases = [each.as_base_exp()[0] for each in sp.Mul.make_args(typed)]
    return all(sp.Poly(each, s).is_irreducible for each in bases if each.has(s))


def factored(value: Expr, s: Symbol) -> Expr | None:
    """The factors of a polynomial, monic ones where its coefficients are not whole; None where there is nothing to do.

    A constant is no factor to be told.
    """
    found: Expr = sp.factor(value)
    if not value.has(s) or found == value:
        return None
    p = sp.Poly(value, s)
    if all(c.is_Integer for c in p.all_coeffs()) or not all(c.is_Rational for c in p.all_coeffs()):
        return found
    listed = [(factor.monic().as_expr(), m) for factor, m in p.factor_list()[1]]
    monic = sp.Mul(p.LC(), *(factor**m for factor, m in listed), evaluate=False) if p.LC() != 1 else None
    if p.degree() == 1 and monic is not None:
        return sp.Mul(p.LC(), listed[0][0], evaluate=False)
    return monic if monic is not None else sp.Mul(*(factor**m for factor, m in listed)) if len(listed) > 1 else None


def _listed(points: Sequence[exact.PlacedRoot]) -> list[Expr]:
    """The roots, each as often as it is one."""
    return [each.value for each in points for _ in range(each.multiplicity)]


def _asymptotes(lines: exact.Asymptotes, q: int, points: tuple[list[Expr], list[Expr]], *, positive: bool) -> Step:
    """The angles (2k + 1) 180°/q, of the locus of 0° 2k 180°/q, and their centroid."""
    poles, zeros = points
    claims: dict[str, Claim] = {}
    for k, angle in enumerate(lines.angles):
        raw = sp.Rational((2 * k + 1 if positive else 2 * k) * 180, q)
        factor = sp.Integer(2 * k + 1 if positive else 2 * k)
        says = Phrase("the angle of asymptote {k}", k=k + 1)
        claims[f"angle{k}"] = Claim(quotient(product(factor, sp.Integer(180)), sp.Integer(q)), raw, says)
        assert (raw - angle) % 360 == 0  # noqa: S101 - the same direction
    above = difference(total(*poles), total(*zeros)) if zeros else total(*poles)
    claims["centroid"] = Claim(quotient(above, sp.Integer(q)), lines.centroid, "the centroid of the asymptotes")
    return Step("asymptotes", claims=claims, q=q, angles=list(lines.angles), centroid=lines.centroid, poles=poles,
                zeros=zeros, positive=positive, turned=any(abs(2 * k) > q for k in range(q)))  # fmt: skip
