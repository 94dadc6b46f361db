"""Lemma: the controller that gives a sampled loop a transfer function, and what it cancels."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.denominators import brought_together
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.derivation.figures import Motion, Signals
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, quotient, total
from solver.stated.calculus import value_at
from solver.tasks import figures

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sympy import Expr, Symbol

Fraction = tuple["Expr", "Expr"]


@lemma("direct_design")
def controller_that_gives(
    plant: Fraction, target: Expr | None, poles: Sequence[Expr], zeros: Sequence[Expr]
) -> Derivation[exact.DirectDesign]:
    """The target, as given or by its poles; the conditions on it; the controller; the loop that it closes."""
    z = sp.Symbol("z")
    above, below = plant = exact.monic_fraction(plant, z)
    lag = int(sp.degree(below, z) - sp.degree(above, z))
    yield Step("plant", unclaimed="as given", G=quotient(above, below), z=z, lag=lag)
    T = target
    if T is None:
        T = yield from _placed(poles, zeros, lag, z)
    found = _designed(plant, T, z)
    if target is not None:
        yield Step("target", unclaimed="as given", T=found.target, lag=found.target_lag, of_plant=lag, z=z,
                   gain=_at_one(T, z))  # fmt: skip
    _refuse(plant, found, z)
    yield _controller(plant, found, z)
    yield _cancellations(found, z)
    yield _loop(plant, found, z)
    return found


@lemma("direct_design")
def _placed(poles: Sequence[Expr], zeros: Sequence[Expr], lag: int, z: Symbol) -> Derivation[Expr]:
    """T by its poles and zeros: delays until it is as late as the plant, the gain by T(1) = 1."""
    try:
        found = exact.direct_target(poles, zeros, lag, z)
    except ZeroDivisionError as nothing:
        raise Unsolved("ragazzini/at_one", pole=1 in list(poles)) from nothing
    factors = [each for each in (found.poles, power(z, found.delays) if found.delays > 1 else z) if each != 1]
    bottom = product(*(factors if found.delays else factors[:-1])) if found.poles != 1 else factors[0]
    at_one = [sp.expand(each.subs(z, 1)) if each != 1 else sp.Integer(1) for each in (found.poles, found.zeros)]
    claims = {
        "gain": Claim(quotient(*at_one), found.gain, "the gain that makes T(1) one"),
        "T": Claim(quotient(product(found.gain, found.zeros), bottom), found.function, "the target"),
    }
    yield Step("placed", claims=claims, found=found, lag=lag, z=z, count=len(poles), zeros=len(zeros))
    return found.function


def _designed(plant: Fraction, T: Expr, z: Symbol) -> exact.DirectDesign:
    try:
        return exact.direct_design(plant, T, z)
    except ValueError as nothing:
        raise Unsolved("ragazzini/no_controller", zero=T == 0) from nothing


def _at_one(T: Expr, z: Symbol) -> Expr | None:
    """T(1), None where T has a pole there."""
    above, below = (sp.expand(side.subs(z, 1)) for side in sp.fraction(sp.together(T)))
    return None if below == 0 else sp.radsimp(sp.cancel(above / below))


def _refuse(plant: Fraction, found: exact.DirectDesign, z: Symbol) -> None:
    """Raise Unsolved where the controller is not causal, or something does not decay that stays in the loop."""
    if found.lateness < 0:
        raise Unsolved("ragazzini/not_causal", lag=found.lag, target_lag=found.target_lag)
    hidden, unstable = (exact.not_inside(each, z) for each in (found.hidden, found.target_denominator))
    if hidden != 1:
        raise Unsolved("ragazzini/hidden", factor=hidden, z=z)
    if unstable != 1:
        raise Unsolved("ragazzini/unstable_target", factor=unstable, z=z)
    zeros, poles = (exact.not_inside(each, z) for each in (found.cancelled_zeros, found.cancelled_poles))
    if zeros != 1 or poles != 1:
        better = exact.admissible_target(plant, found.target_denominator, z)
        raise Unsolved("ragazzini/cancels_outside", zeros=zeros, poles=poles, target=better, z=z)


def _controller(plant: Fraction, found: exact.DirectDesign, z: Symbol) -> Step:
    """1 − T, and D = (1/G) T/(1 − T)."""
    inverse = quotient(plant[1], plant[0])
    claims = {
        "rest": Claim(difference(sp.Integer(1), found.target), found.rest, "what T leaves"),
        "forward": Claim(quotient(found.target, found.rest), found.forward, "what D and G are together"),
        "D": Claim(product(inverse, found.forward), found.controller, "the controller"),
    }
    return Step("controller", claims=claims, steps=brought_together([sp.S.One, -found.target], z), z=z)


def _roots(p: Sequence[Expr]) -> list[Any]:
    """The roots of a polynomial with numbers; none with parameters, or without a usable form."""
    if len(p) == 1 or any(c.free_symbols for c in p):
        return []
    try:
        return list(exact.roots_of(tuple(p)))
    except exact.NotExact:
        return []


def _cancellations(found: exact.DirectDesign, z: Symbol) -> Step:
    """What is cancelled: where it lies, what it does to the control signal and to disturbances."""
    zeros, poles = _roots(found.cancelled_zeros), _roots(found.cancelled_poles)
    own = [abs(complex(each)) for each in _roots(found.target_denominator)]
    slowest = max(own, default=0.0)
    conditions = [
        each
        for p in (found.cancelled_zeros, found.cancelled_poles, found.target_denominator)
        if len(p) > 1 and any(c.free_symbols for c in p)
        for each in exact.jury_conditions(p).positive
    ]
    condition = exact.all_positive(conditions) if conditions else sp.true
    listed = ((found.cancelled_zeros, zeros), (found.cancelled_poles, poles))
    claims = {
        f"root{i}{j}": Claim(value_at(exact.polynomial_in(z, p), z, root), sp.Integer(0), "a root that is cancelled")
        for i, (p, values) in enumerate(listed)
        for j, root in enumerate(values)
    }
    return Step(
        "cancellations",
        claims=claims,
        unclaimed="" if claims else "nothing is cancelled, or its roots depend on parameters",
        zeros=exact.factors_in(found.cancelled_zeros, z),
        poles=exact.factors_in(found.cancelled_poles, z),
        zero_list=zeros,
        pole_list=poles,
        ringing=[each for each in zeros if complex(each).real < 0],
        slow=[each for each in poles if abs(complex(each)) > slowest],
        condition=condition,
        z=z,
    )


def _loop(plant: Fraction, found: exact.DirectDesign, z: Symbol) -> Step:
    """D G/(1 + D G) = T; the control signal, and the recursion of the controller."""
    L = found.forward
    claims = {
        "forward": Claim(product(found.controller, quotient(*plant)), L, "controller and plant in series"),
        "loop": Claim(quotient(L, total(sp.Integer(1), L)), found.target, "the closed loop"),
        "control": Claim(product(quotient(plant[1], plant[0]), found.target), found.control, "from r to u"),
    }
    above, below = (sp.Poly(sp.expand(side), z).all_coeffs() for side in sp.fraction(sp.together(found.controller)))
    padded = [sp.Integer(0)] * (len(below) - len(above)) + above
    recursion = [
        *((sp.cancel(-c / below[0]), f"u(k-{i})") for i, c in enumerate(below) if i and c != 0),
        *((sp.cancel(c / below[0]), f"e(k-{i})" if i else "e(k)") for i, c in enumerate(padded) if c != 0),
    ]
    return Step("loop", claims=claims, figures=_figure(plant, found, z), z=z, recursion=recursion,
                gain=_at_one(found.target, z), numbers=not any(c.free_symbols for c, _ in recursion))  # fmt: skip


def _figure(plant: Fraction, found: exact.DirectDesign, z: Symbol) -> tuple[Motion, ...]:
    """Output and control after a step of the reference, from a common denominator of T and T/G."""
    if any(side.free_symbols - {z} for side in (*plant, found.target)):
        return ()
    p, q = exact.polynomial_in(z, found.target_denominator), exact.polynomial_in(z, found.cancelled_zeros)
    below = sp.expand(p * q)
    rows = []
    for function in (found.target, found.control):
        above = sp.cancel(function * below)
        if not above.is_polynomial(z):
            return ()  # powers of e are not cancelled by sympy where there are several of them
        A, B, C, D = exact.descending_form(above, below, z)
        rows.append((C, D))
    if A.rows == 0:
        return ()
    signals = (
        Signals("y", ("y",), rows[0][0], rows[0][1], ("r", sp.Integer(1))),
        Signals("u", ("u",), rows[1][0], rows[1][1]),
    )
    rest = sp.ImmutableMatrix(sp.zeros(A.rows, 1))
    return figures.motion("After a step of the reference, from rest", A, rest, *signals, discrete=True, drive=B)
