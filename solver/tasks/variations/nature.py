"""Lemma: what an extremal is: convexity where it decides at once, else Legendre's condition and conjugate points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.jets import jet_symbol
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.calculus import partial_derivative
from solver.tasks.variations.conjugate_points import begins_fixed, first_zero_of, jets_along, stand_apart
from solver.tasks.variations.coupled_points import coupled_point_of
from solver.tasks.variations.free_ends import sign_at_free_end, sign_of_moving_end

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.systems import Functional
    from solver.tasks.variations.found_extremal import Extremal

WORDS = {"convex": "minimum", "concave": "maximum", "positive": "minimum", "negative": "maximum"}
UNDECIDED, NEITHER = "undecided", "neither"
SUFFICIENT = ("none", "beyond", "free", "moving")
BEYOND = ("order", "coupled", "jacobi", "zero")
VIOLATED = ("inside", "focal", "free_against", "moving_against")
"""Conditions by which Jacobi's equation and what is free at the end decide."""


@dataclass(frozen=True)
class Nature:
    """The verdict, φ_x'x' along the extremal (a matrix for several functions) and the first conjugate point, if any.

    The verdict is None where the means here do not suffice; "undecided" where the conditions leave it open.
    """

    verdict: str | None
    legendre: Expr | ImmutableMatrix | None
    conjugate_point: Expr | None


@lemma("nature")
def nature_of(system: Functional, found: Extremal) -> Derivation[Nature]:
    """Of a weak extremum: never "minimum" or "maximum" where only a necessary condition holds."""
    legendre, sign = (None, "") if _is_bound(system) else (yield from _legendre_of(system, found))
    bent = yield from _convexity_of(system, found)
    point, reason, verdict = None, "", UNDECIDED
    if bent:
        verdict = WORDS[bent]
    elif sign == "changing":
        verdict = NEITHER
    elif sign in WORDS and not (reason := _out_of_reach(system)):
        point, reason = yield from _by_jacobi(system, found, 1 if sign == "positive" else -1)
        verdict = WORDS[sign] if reason in SUFFICIENT else NEITHER if reason in VIOLATED else UNDECIDED
    else:
        reason = reason or ("bound" if _is_bound(system) else "semidefinite" if sign else "sign")
    yield Step("verdict", unclaimed="what was found above", verdict=verdict, bent=bent, sign=sign, reason=reason,
               point=point, t_f=found.t_f)  # fmt: skip
    return Nature(None if reason in BEYOND else verdict, legendre, point)


def _is_bound(system: Functional) -> bool:
    return bool(system.constraints or system.integral_constraints)


def _out_of_reach(system: Functional) -> str:
    """Why Jacobi's equation would not decide; empty where it may."""
    if {*system.orders.values()} != {1}:
        return "order"
    if _mixes(system) or (not stand_apart(system) and not _all_fixed(system)):
        return "coupled"
    last = [system.ends[name, 0][1] if (name, 0) in system.ends else None for name in system.functions]
    if system.stop is None and (len(last) > 1 or last[0] is None or last[0].free):
        return "free_time"
    return ""


def _all_fixed(system: Functional) -> bool:
    """Whether all values at both ends are given."""
    return all(begins_fixed(system, name) and _ends_fixed(system, name) for name in system.functions)


def _mixes(system: Functional) -> bool:
    """Whether the terminal cost mixes functions."""
    symbols = [system.symbol((name, 0)) for name in system.functions]
    return any(sp.diff(system.terminal_cost, a, b) != 0 for a in symbols for b in symbols if a != b)


def _by_jacobi(system: Functional, found: Extremal, sign: int) -> Derivation[tuple[Any, str]]:
    """The first conjugate point, and which condition decides, function by function."""
    if not stand_apart(system):
        together = yield from coupled_point_of(system, found)
        return together.point, together.reason or _where(together.point, found.t_f, fixed=True)
    points: list[Any] = []
    reason = "none"
    for name in system.functions:
        zero = yield from first_zero_of(system, found, name)
        if begins_fixed(system, name) and zero.point is not None:
            points.append(zero.point)
        own = zero.reason or _where(zero.point, found.t_f, fixed=begins_fixed(system, name))
        if own in SUFFICIENT and not _ends_fixed(system, name):
            own = yield from _at_end(system, found, name, zero.solution, sign)
        order = [own, reason]
        reason = next((each for each in order if each in VIOLATED), "") or next(
            (each for each in order if each not in SUFFICIENT), own if own != "none" else reason
        )
    if len(points) > 1 and any(point.free_symbols for point in points):
        return None, "where"
    return min(points, key=sp.N, default=None), reason


def _where(point: Any, t_f: Expr, *, fixed: bool) -> str:
    """Where a first zero lies."""
    if point is None:
        return "none"
    beyond = exact.sign_of(sp.expand(point - t_f))
    if beyond is None:
        return "where"
    return {1: "beyond", 0: "at_end", -1: "inside" if fixed else "focal"}[beyond]


def _ends_fixed(system: Functional, name: str) -> bool:
    """Whether time and value at the end are given."""
    pair = system.ends.get((name, 0))
    return system.stop is not None and pair is not None and pair[1].value is not None


def _at_end(system: Functional, found: Extremal, name: str, u: Any, sign: int) -> Derivation[str]:
    """What the end that may move says; `sign` is 1 for a minimum."""
    if u is None:
        return "jacobi"
    decide = sign_of_moving_end if system.stop is None else sign_at_free_end
    own = yield from decide(system, found, name, u)
    end = "moving" if system.stop is None else "free"
    return f"{end}_open" if own is None else f"{end}_zero" if own == 0 else end if own == sign else f"{end}_against"


@lemma("nature")
def _legendre_of(system: Functional, found: Extremal) -> Derivation[tuple[Any, str]]:
    """The second derivatives by the highest derivatives along the extremal, and their sign over the time."""
    t, names = system.t, list(system.functions)
    jets = jets_along(system, found)
    highest = [jet_symbol((name, system.orders[name])) for name in names]
    general = exact.hessian(system.integrand, highest)
    R = sp.ImmutableMatrix(*general.shape, [exact.in_motion(entry, jets, t) for entry in general.flat()])
    sign = exact.definite_in_time(R, t, system.start, found.t_f)
    single = len(names) == 1
    claims = {}
    if single:
        claims["second"] = Claim(partial_derivative(system.integrand, highest[0], 2), general[0], "$\\varphi$ twice")
        varying = general[0].free_symbols & {*jets}
        if varying:
            claims["along"] = Claim(general[0].xreplace(jets), R[0], "the extremal put in")
    else:
        for i, q in enumerate(highest):
            slope = partial_derivative(sp.diff(system.integrand, q), q)
            claims[f"second{i}"] = Claim(slope, general[i, i], "$\\varphi$ twice")
    yield Step("legendre", claims=claims, names=highest, general=general[0] if single else general,
               R=R[0] if single else R, sign=sign, single=single, varies=general != R, start=system.start,
               stop=found.t_f)  # fmt: skip
    return (R[0] if single else R), sign


@lemma("nature")
def _convexity_of(system: Functional, found: Extremal) -> Derivation[str]:
    """Return "convex" or "concave" where φ, and the terminal cost, are so in all that varies."""
    if system.stop is None:
        return ""
    multipliers = {jet_symbol((name, 0)): value for name, value in found.multipliers.items()}
    multipliers |= {jet_symbol((name, 0)): value for name, value in found.x.items() if name not in system.functions}
    phi = found.phi.xreplace(multipliers)
    inside = [symbol for symbol, (name, _) in system.jets.items() if name in system.functions and phi.has(symbol)]
    inside += [jet for jet in _derivatives(system) if phi.has(jet) and jet not in inside]
    curved = [x for x in inside if sp.diff(phi, x).has(*inside)]
    if not curved or phi.free_symbols - {*inside, system.t, *system.parameters}:
        return ""
    H = exact.hessian(phi, curved)
    word: str = exact.bending(H, system.t, system.start, found.t_f)
    cost = [x for x in _derivatives(system) if sp.diff(system.terminal_cost, x).has(*_derivatives(system))]
    if (
        word
        and cost
        and exact.bending(exact.hessian(system.terminal_cost, cost), system.t, found.t_f, found.t_f) != word
    ):
        word = ""
    if word:
        claims = {
            f"entry{i}{j}": Claim(partial_derivative(sp.diff(phi, x), y), H[i, j], "second derivatives of $\\varphi$")
            for i, x in enumerate(curved)
            for j, y in enumerate(curved)
            if i <= j
        }
        yield Step("convexity", claims=claims, names=curved, H=H[0] if len(curved) == 1 else H, word=word,
                   linear=[x for x in inside if x not in curved], cost=bool(cost), bound=bool(system.constraints),
                   integrals=bool(system.integral_constraints), free=not _has_values(system))  # fmt: skip
    return word


def _has_values(system: Functional) -> bool:
    return all(end.value is not None for pair in system.ends.values() for end in pair)


def _derivatives(system: Functional) -> list[Symbol]:
    """The symbols of the functions and of their derivatives that may occur."""
    return [jet_symbol((name, k)) for name in system.functions for k in range(system.orders[name] + 1)]
