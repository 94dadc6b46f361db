"""What is asked of a compensated loop: the options, what is wrong with them, and the gain that the error needs."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Options, Refusal, Step, Unsolved, lemma, option
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.options.number import Number
from solver.options.poles import Poles
from solver.stated.algebra import power, product, quotient, total
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute, phase
from solver.stated.limits import limit
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpenLoop

BODE, LOCUS = ("frequency_response",), ("root_locus",)
CONSTANTS = ("position_constant", "velocity_constant", "acceleration_constant")
LETTERS = {"error": "e", "position_constant": "K_p", "velocity_constant": "K_v", "acceleration_constant": "K_a"}


@dataclass(frozen=True, kw_only=True)
class CompensatorOptions(Options):
    """What is asked of the loop."""

    error: Expr | None = option(Number(percent=True), "largest error after a unit step of the reference, or 2%")
    position_constant: Expr | None = option(Number(), "least position error constant K_p")
    velocity_constant: Expr | None = option(Number(), "least velocity error constant K_v")
    acceleration_constant: Expr | None = option(Number(), "least acceleration error constant K_a")
    phase_margin: Expr = option(Number(), "least phase margin, in degrees", required=True, methods=BODE)
    crossover: Expr | None = option(Number(), "the gain crossover, met to 0.1 %", methods=BODE)
    extra_phase: Expr | None = option(
        Number(), "degrees added to the phase that is missing (default: 5; a lag 6; 0 where a crossover is given)",
        methods=BODE,
    )  # fmt: skip
    poles: tuple[Expr, ...] = option(
        Poles(), "the pair of dominant poles of the closed loop", required=True, methods=LOCUS
    )


def accuracy(options: CompensatorOptions) -> tuple[str, Any] | None:
    """Return the specification of the error by its name, None where there is none."""
    return next(((name, v) for name in LETTERS if (v := getattr(options, name)) is not None), None)


def compensator_faults(options: CompensatorOptions) -> Iterable[Refusal]:
    """Two specifications of the error, values that are not positive, a margin that no loop has, no pair of poles."""
    given = [name for name in LETTERS if options.has(name)]
    if len(given) > 1:
        yield given[1], Reason("compensators/two_errors", {"first": given[0], "second": given[1]})
    for name in (*LETTERS, "crossover"):
        value = getattr(options, name)
        if value is not None and value.is_number and not value.is_positive:
            yield name, Reason("compensators/not_positive", {"name": name})
    if options.error is not None and options.error.is_number and options.error >= 1:
        yield "error", Reason("compensators/large_error")
    margin, poles = options.phase_margin, options.poles
    if margin is not None and margin.is_number and not 0 < margin < 180:
        yield "phase_margin", Reason("compensators/margin_out_of_range")
    if poles is not None and (len(poles) != 2 or not poles[0].has(sp.I)):
        yield "poles", Reason("compensators/no_pair")


def plant_of(G: OpenLoop, options: CompensatorOptions) -> exact.Plant:
    """Return the plant; raises Unsolved where a parameter is left."""
    free = G.around.union(*(value.free_symbols for value in options.values if hasattr(value, "free_symbols")))
    if free:
        raise Unsolved("compensators/parameters", names=sorted(map(str, free)))
    if G.numerator == 0:
        raise Unsolved("compensators/zero_plant")
    return exact.Plant(G.numerator, G.denominator, G.variable, G.delay, G.rational.written)


def rational_plant_of(G: OpenLoop, options: CompensatorOptions) -> exact.Plant:
    """Return the plant for the root locus; raises Unsolved where it has a dead time."""
    if G.delay != 0:
        raise Unsolved("compensators/dead_time")
    return plant_of(G, options)


def written(G: exact.Plant, factor: Any = None) -> Any:
    """Return K G as an expression, in the factors in which G was given."""
    above, below = G.in_factors or (G.numerator, G.denominator)
    found = above / below
    late = found * sp.exp(-G.delay * G.s) if G.delay != 0 else found
    return late if factor is None else factor * late


@lemma("least_gain")
def gain_for_the_error(G: exact.Plant, options: CompensatorOptions) -> Derivation[Expr]:
    """The least K for the error or the constant; raises Unsolved where no gain is enough."""
    asked = accuracy(options)
    if asked is None:
        yield Step("any", unclaimed="nothing is asked of the error")
        return sp.Integer(1)
    name, value = asked
    found = exact.least_gain(G, name, value)
    s = G.s
    times = product(power(s, found.power), written(G)) if found.power else written(G)
    claims = (
        {"limit": Claim(limit(times, s, 0), found.limit, "the constant of the plant")} if found.limit.is_finite else {}
    )
    if found.K is not None and found.limit.is_finite:
        claims["K"] = Claim(quotient(found.wanted, found.limit), found.K, "the least gain")
    yield Step("gain", claims=claims, unclaimed="" if claims else "the constant is infinite for every gain", name=name,
               value=value, found=found, letter=LETTERS[name], s=s)  # fmt: skip
    if found.K is None:
        raise Unsolved("compensators/constant_is_zero", name=name, letter=LETTERS[name])
    if found.K.is_negative:
        raise Unsolved("compensators/negative_gain")
    return found.K


@lemma("uncompensated")
def margins_of_the_gain(G: exact.Plant, K: Expr, wanted: Expr) -> Derivation[exact.Compensated]:
    """The margin of K G as it stands."""
    before = exact.compensated(G, K)
    crossover = before.margins.at_gain
    claims = {}
    if crossover is not None:
        claims = crossover_claims(written(G, K), G.s, crossover.omega, crossover.phase)
        claims["sum"] = angles_added(before.axis, crossover.omega, before.margins.phase_margin - 180)
    omega, parts = sp.Symbol("omega"), before.axis.parts
    yield Step(
        "margins",
        claims=claims,
        unclaimed="" if claims else "there is no crossover",
        K=K,
        s=G.s,
        crossover=crossover,
        phase=before.margins.phase_margin - 180,
        several=len(before.margins.gains.found) > 1,
        margin=before.margins.phase_margin,
        stable=before.stable,
        wanted=wanted,
        above=parts.above.as_expr().xreplace({parts.w: omega**2}),
        below=parts.below.as_expr().xreplace({parts.w: omega**2}),
        angles=before.axis.angles(crossover.omega) if crossover is not None else [],
        late=G.delay != 0,
    )
    return before


def angles_added(L: exact.OnAxis, omega: Expr, phase_there: Expr) -> Claim:
    """∠L(jω) as the sum of the angles of its factors, and of a full turn where it takes one."""
    terms = [each.power * each.degrees for each in L.angles(omega)]
    if L.late:
        terms.append(sp.N(-180 * omega * L.delay / sp.pi, 30))
    turns = sp.Integer(round(float(phase_there - sp.Add(*terms)) / 360))
    whole = [*terms, 360 * turns] if turns else terms
    return Claim(total(*whole), phase_there, "the sum of the angles")


def crossover_claims(L: Any, s: Any, omega: Expr, phase_there: Expr) -> dict[str, Claim]:
    """|L(jω)| = 1 and ∠L(jω) at a crossover."""
    at = value_at(L, s, sp.I * omega)
    return {
        "size": Claim(absolute(at), sp.Integer(1), "the magnitude at the crossover"),
        "phase": Claim(phase(at), phase_there, "the phase at the crossover"),
    }
