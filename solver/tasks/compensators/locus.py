"""Lemmas: sections by the root locus, so that a pair of poles is where it is asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.frequencies import size_and_angle
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute, phase
from solver.tasks.compensators.refusals import no_lead_on_locus
from solver.tasks.compensators.specifications import CompensatorOptions, accuracy, written

if TYPE_CHECKING:
    from sympy import Expr


def upper(poles: tuple[Expr, ...] | None) -> Expr:
    """Return the pole of the pair above the real axis; raises Unsolved where none is asked for."""
    if not poles:
        raise Unsolved("compensators/no_poles")
    return next(pole for pole in poles if sp.im(sp.N(pole)) > 0)


@lemma("locus_design")
def lead_for_a_pole(G: exact.Plant, options: CompensatorOptions) -> Derivation[exact.LeadOnLocus]:
    """The angle that is missing at the pole, zero and pole of the section by the bisector; raises Unsolved."""
    point = upper(options.poles)
    found = exact.lead_on_locus(G, point)
    yield _angle(G, found.at)
    if isinstance(found, exact.NoLocus):
        raise no_lead_on_locus(found.why, missing=found.at.missing, theta=found.at.theta, point=point)
    at = found.at
    less, more = (sp.N(sp.sin(sp.pi * each / 180), 30) for each in (found.half_less, found.half_more))
    claims = {
        "less": Claim(quotient(difference(at.theta, at.missing), sp.Integer(2)), found.half_less, "an angle"),
        "more": Claim(quotient(total(at.theta, at.missing), sp.Integer(2)), found.half_more, "an angle"),
        "zero": Claim(quotient(product(at.radius, less), more), found.zero, "the distance of the zero"),
        "pole": Claim(quotient(product(at.radius, more), less), found.pole, "the distance of the pole"),
        "T": Claim(quotient(sp.Integer(1), found.zero), sp.Float(1 / found.zero, 15), "T"),
        "alpha": Claim(quotient(found.zero, found.pole), sp.Float(found.zero / found.pole, 15), "α"),
    }
    yield Step("bisector", claims=claims, found=found, at=at, T=found.section.T, alpha=found.section.alpha)
    yield _magnitude(G, at, [found.section], found.gain, found.loop.K)
    return found


def _angle(G: exact.Plant, at: exact.AtThePoint) -> Step:
    """G at the point, its angle and what is missing."""
    there = value_at(written(G), G.s, at.point)
    turn = sp.Integer(180) if abs(180 - at.angle - at.missing) < sp.Float("1e-9") else sp.Integer(-180)
    claims = {
        "value": Claim(there, at.value, "the value of the plant at the pole"),
        "angle": Claim(phase(there), at.angle, "its angle"),
        "missing": Claim(difference(turn, at.angle), at.missing, "the angle that is missing"),
    }
    return Step("angle", claims=claims, steps=size_and_angle(written(G), G.s, at.point, None, at.angle), at=at, s=G.s)


def _magnitude(G: exact.Plant, at: exact.AtThePoint, sections: list[exact.Section], gain: Expr, K: Expr) -> Step:
    """K from the magnitude at the pole."""
    s = G.s
    factors = [quotient(each.T * s + 1, each.alpha * each.T * s + 1) for each in sections]
    inner = product(*factors, written(G)) if factors else written(G)
    size = 1 / gain
    claims = {
        "size": Claim(absolute(value_at(inner, s, at.point)), size, "the magnitude at the pole"),
        "K": Claim(quotient(sp.Integer(1), size), gain, "K"),
    }
    whole = sp.Mul(written(G), *((each.T * s + 1) / (each.alpha * each.T * s + 1) for each in sections))
    lines = size_and_angle(whole, s, at.point, size)
    return Step("magnitude", claims=claims, steps=lines, at=at, K=K, alone=not sections)


@lemma("locus_design")
def lag_for_a_pole(
    G: exact.Plant, options: CompensatorOptions, before: tuple[exact.Section, ...] = ()
) -> Derivation[exact.LagOnLocus]:
    """The gain at the pole, the constant with it, and a section that multiplies it; raises Unsolved."""
    point, asked = upper(options.poles), accuracy(options)
    if asked is None:
        raise Unsolved("compensators/no_error")
    found: Any = exact.lag_on_locus(G, point, *asked, before)
    if isinstance(found, exact.NoLocus):
        yield _angle(G, found.at)
        raise Unsolved("compensators/locus_off", missing=found.at.missing, theta=found.at.theta, point=point)
    if found is None or found == "limit":
        raise Unsolved("compensators/lag_not_needed" if found is None else "compensators/no_constant")
    if not before:
        yield _angle(G, found.at)
        yield _magnitude(G, found.at, [], found.gain, found.gain)
    ratio = found.ratio
    s = sp.N(point, 30)
    section = quotient(found.section.T * G.s + 1, found.section.alpha * found.section.T * G.s + 1)
    claims = {
        "reached": Claim(quotient(found.wanted, found.reached), ratio, "the factor that is missing"),
        "T": Claim(quotient(sp.Integer(found.distance), found.at.radius), found.distance / found.at.radius, "T"),
        "angle": Claim(phase(value_at(section, G.s, s)), found.angle, "the angle of the section"),
    }
    yield Step("near_the_origin", claims=claims, found=found, name=asked[0], value=asked[1],
               distance=found.distance, T=found.section.T, alpha=found.section.alpha, K=found.K)  # fmt: skip
    if not found.loop.stable or abs(complex(found.root) - complex(sp.N(point))) > 0.1 * abs(complex(sp.N(point))):
        raise Unsolved("compensators/lag_moves_the_pole", root=found.root, point=point)
    return found
