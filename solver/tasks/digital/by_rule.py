"""Lemmas: a plant in discrete time by a rule that puts a function of z for s, and what the rule does to stability."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.inverses import inverted
from solver.arithmetic.products import multiplied
from solver.derivation import Claim, Derivation, Step, lemma
from solver.derivation.figures import Curve, Mark, Plot
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.matrices import entry_alone
from solver.stated.algebra import power, product, quotient, total
from solver.stated.calculus import value_at
from solver.stated.matrices import inverse

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import StateSpace, TransferFunction

NEARLY_ROUND = 6.283
"""A curve that ends where it begins would be a point to whoever draws it."""
FORWARD, BACKWARD, TUSTIN = "forward_euler", "backward_euler", "tustin"


@lemma("by_rule")
def mapped_plant_of(plant: StateSpace, name: str, T: Expr, prewarp: Expr | None) -> Derivation[tuple[Any, ...]]:
    """State equations by a rule; returns A_d, B_d, C_d, D_d, None for what the plant does not have."""
    A, B, C, D = plant.A, plant.B, plant.C, plant.D
    rule = exact.rule_of(name, T, prewarp)
    yield _rule(rule, name, T, prewarp, states=True)
    found = exact.mapped_matrices(A, B, C, D, rule)
    h, identity = rule.h, sp.ImmutableMatrix(sp.eye(A.rows))
    if found.inverted is not None:
        pencil = sp.ImmutableMatrix(identity - h * A)
        claims = {"inverse": Claim(inverse(pencil), found.inverted, "the inverse")}
        lines = inverted("(I - hA)", pencil, found.inverted)
        yield Step("inverse", claims=claims, steps=lines, h=h, pencil=pencil, n=A.rows)
    yield Step("matrices", claims=_matrix_claims(plant, found, name, h), steps=_products(plant, found, name, h),
               name=name, T=T, h=h, plain=prewarp is None, found=found,
               direct=found.D is not None and not found.D.is_zero_matrix)  # fmt: skip
    yield from stability_by(rule, name, T, exact.spectrum(A).roots, states=True)
    return found.A, found.B, found.C, found.D


def _matrix_claims(plant: StateSpace, found: exact.Mapped, name: str, h: Expr) -> dict[str, Claim]:
    """The matrices by their formulas."""
    A, B, C, D = plant.A, plant.B, plant.C, plant.D
    identity = sp.ImmutableMatrix(sp.eye(A.rows))
    M, claims = found.inverted, {}
    forward = total(identity, product(h, A))
    stated = forward if M is None else product(M, forward) if name == TUSTIN else M
    if stated is not M:
        claims["A"] = Claim(stated, found.A, "system matrix")
    twice = 2 * h if name == TUSTIN else h
    if B is not None:
        claims["B"] = Claim(product(*([] if M is None else [M]), twice, B), found.B, "input matrix")
    if C is not None and M is not None:
        claims["C"] = Claim(product(C, M), found.C, "output matrix")
        if B is not None and D is not None:
            through = product(C, M, h, B)
            claims["D"] = Claim(through if D.is_zero_matrix else total(D, through), found.D, "feedthrough")
    return claims


@where_exact
def _products(plant: StateSpace, found: exact.Mapped, name: str, h: Expr) -> tuple[Step, ...]:
    """The products with the inverse."""
    M, B, C = found.inverted, found.B, found.C
    if M is None:
        return ()
    forward = sp.ImmutableMatrix(sp.eye(M.rows) + h * plant.A)
    lines = multiplied(M, forward, found.A) if name == TUSTIN else ()
    if plant.B is not None and B is not None:
        lines += multiplied(M, sp.ImmutableMatrix((2 * h if name == TUSTIN else h) * plant.B), B)
    return lines if plant.C is None or C is None else lines + multiplied(plant.C, M, C)


@lemma("by_rule")
def mapped_transfer_of(G: TransferFunction, name: str, T: Expr, prewarp: Expr | None) -> Derivation[Any]:
    """A transfer function by a rule, entry by entry; returns it in z, of one channel alone."""
    s, z = G.variable, sp.Symbol("z")
    rule = exact.rule_of(name, T, prewarp)
    yield _rule(rule, name, T, prewarp, states=False)
    p, m = G.matrix.shape
    entries, denominators = [], []
    for i in range(p):
        for j in range(m):
            N, D = sp.fraction(sp.together(G.matrix[i, j]))
            found = exact.mapped_quotient(sp.expand(N), sp.expand(D), s, z, rule)
            entries.append(found.whole)
            denominators.append(sp.Poly(D, s))
            shown = G.matrix[i, j] if p * m > 1 else G.uncancelled[0, 0]
            claims = {
                "put": Claim(value_at(shown, s, rule.s(z)), quotient(found.above, found.below), "s replaced"),
                "whole": Claim(quotient(found.above, found.below), found.whole, "in lowest terms"),
            }
            lines = _cleared(N, D, s, z, rule, found)
            yield Step("substituted", claims=claims, steps=lines, place=(i + 1, j + 1) if p * m > 1 else (),
                       z=z, s=s, name=name, G=shown, whole=found.whole, below=rule.below(z), h=rule.h)  # fmt: skip
    common = denominators[0]
    for each in denominators[1:]:
        common = common.lcm(each)
    roots = exact.spectrum_of_polynomial(common.to_field()).roots if common.degree() > 0 else ()
    yield from stability_by(rule, name, T, roots, states=False)
    return entry_alone(sp.ImmutableMatrix(p, m, entries))


@where_exact
def _cleared(N: Expr, D: Expr, s: Symbol, z: Symbol, rule: exact.Rule, found: exact.MappedQuotient) -> tuple[Step, ...]:
    """Numerator and denominator after they were multiplied by the power that clears the fractions, and sorted."""
    degree = int(sp.degree(sp.expand(D), s))
    if rule.name == FORWARD or not degree:
        return ()
    return tuple(_multiplied(N, D, s, z, rule, found, degree))


@lemma("by_rule")
def _multiplied(
    N: Expr, D: Expr, s: Symbol, z: Symbol, rule: exact.Rule, found: exact.MappedQuotient, degree: int
) -> Derivation[None]:
    claims = {}
    for name, p, value, of_which in (
        ("above", N, found.above, "the numerator"),
        ("below", D, found.below, "the denominator"),
    ):
        terms = [
            product(*(each for each in (c * rule.h ** (degree - i), rule.above(z) ** i, rule.below(z) ** (degree - i))
                      if each != 1))
            for (i,), c in sp.Poly(p, s).terms()
        ]  # fmt: skip
        claims[name] = Claim(total(*terms), value, of_which)
    yield Step("cleared", detail="tutor", claims=claims, by=product(rule.h, rule.below(z)), degree=degree)


def _rule(rule: exact.Rule, name: str, T: Expr, prewarp: Expr | None, *, states: bool) -> Step:
    """What is put for s."""
    z = sp.Symbol("z")
    claims = {}
    if prewarp is not None:
        angle = prewarp * T / 2
        claims["h"] = Claim(quotient(sp.tan(angle), prewarp), rule.h, "prewarped")
    return Step("rule", claims=claims, unclaimed="" if claims else "the definition of the rule", name=name, T=T,
                h=rule.h, prewarp=prewarp, s_of_z=rule.s(z), states=states)  # fmt: skip


@lemma("by_rule")
def stability_by(
    rule: exact.Rule, name: str, T: Expr, roots: Sequence[exact.Root], *, states: bool
) -> Derivation[None]:
    """Where the left half plane goes, and for which periods a stable plant stays stable by Euler's forward method."""
    stable = [root for root in roots if _is_left(root)]
    limits = exact.longest_period(stable) if name == FORWARD else []
    claims = {}
    for i, (root, limit) in enumerate(limits, 1):
        if root.value.has(sp.I):
            square = total(power(root.sigma, 2), power(root.shift, 2))
            claims[f"limit{i}"] = Claim(quotient(product(2, -root.sigma), square), limit, "the longest period")
        else:
            claims[f"limit{i}"] = Claim(quotient(sp.Integer(2), -root.value), limit, "the longest period")
    undecided = [root.value for root in roots if _is_left(root) is None]
    least = _least([limit for _, limit in limits])
    yield Step(
        "stability",
        claims=claims,
        unclaimed="" if claims else "where the map sends the left half plane",
        detail="brief" if limits else "full",
        name=name,
        T=T,
        limits=limits,
        least=least,
        kept=None if least is None else _is_below(T, least),
        unstable=[root.value for root in roots if _is_left(root) is False],
        undecided=undecided,
        states=states,
        figures=(_figure(rule, name, roots, T),),
    )


def _is_left(root: exact.Root) -> bool | None:
    """Whether Re λ < 0; None where parameters decide."""
    real = root.sigma if root.kind in ("complex", "decimal") else root.value
    negative: bool | None = real.is_negative
    return negative


def _least(limits: Sequence[Expr]) -> Expr | None:
    """The least of the limits; None where there is none, or parameters decide."""
    if not limits:
        return None
    if len(limits) == 1:
        return limits[0]
    numbers = not any(each.free_symbols for each in limits)
    return min(limits, key=lambda each: sp.N(each, 30)) if numbers else None


def _is_below(T: Expr, limit: Expr) -> bool | None:
    """Whether T is below the limit; None where that is not known."""
    below: bool | None = (limit - T).is_positive
    return below


def _figure(rule: exact.Rule, name: str, roots: Sequence[exact.Root], T: Expr) -> Plot:
    """The image of the imaginary axis, the unit circle, the poles where they are numbers."""
    angle = sp.Symbol("varphi", real=True)
    circle = Curve(sp.sin(angle), r"|z| = 1", sp.cos(angle), "dashed")
    curves = [circle]
    if name == FORWARD:
        curves.append(Curve(sp.Rational(3, 5) * angle - 6 * sp.pi / 10, r"s = j\omega", sp.S.One))
    elif name == BACKWARD:
        curves.append(Curve(sp.sin(angle) / 2, r"s = j\omega", (1 + sp.cos(angle)) / 2))
    else:
        curves = [Curve(sp.sin(angle), r"s = j\omega", sp.cos(angle))]
    marks = []
    if not T.free_symbols and not any(root.value.free_symbols for root in roots):
        images = [sp.N(rule.z(root.value)) for root in roots]
        marks = [Mark(sp.re(z), sp.im(z), "", "dot") for z in images]
    captions = {
        FORWARD: "The left half plane goes to the left of the line: more than the unit disc",
        BACKWARD: "The left half plane goes into the small circle: less than the unit disc",
        TUSTIN: "The left half plane goes into the unit circle, and fills it",
    }
    window = (sp.Rational(-3, 2), sp.Rational(3, 2), sp.Rational(-3, 2), sp.Rational(3, 2))
    return Plot(captions[name], r"\operatorname{Re} z", r"\operatorname{Im} z", angle, sp.S.Zero, NEARLY_ROUND,
                tuple(curves), tuple(marks), True, window)  # fmt: skip
