"""What remains of the error e = r − y: by the final value theorem, or by the error constants of the loop."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Check,
    Claim,
    Derivation,
    Given,
    Step,
    Task,
    Unsolved,
    option,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import loops as judges
from solver.options.loop_element import UNITY, LoopElement
from solver.options.signal import Signal
from solver.stated.algebra import quotient, total
from solver.tasks.loops import error_mistakes
from solver.tasks.loops.error_constants import CONSTANTS, DISCRETE_LIMITS, LIMITS, constants_of, limit_stated
from solver.tasks.loops.error_signals import Acting, acting_on, needs_the_sample_time
from solver.tasks.loops.error_transforms import limit_of, shares_of
from solver.tasks.loops.late_loops import image_of, is_stable_at, long_run_of, stable_late_loop
from solver.tasks.loops.loop_stability import Inside, stable_loop
from solver.tasks.plant_options import LoopOptions
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpenLoop


@dataclass(frozen=True, kw_only=True)
class ErrorOptions(LoopOptions):
    """What acts on the loop."""

    reference: Expr = option(Signal(), "the reference r", default="step")
    disturbance: Expr | None = option(Signal(), "a disturbance at the input of the plant, whose part is added")
    feedback: Expr | None = option(
        LoopElement(switched=True),
        "what is in the feedback path, H; none: the error r − y without a loop",
        default=UNITY,
        loop="loop",
    )


steady_state_error: Task[OpenLoop, ErrorOptions] = Task(
    "steady_state_error",
    title="Steady-state error",
    doc="The limit of e = r − y, the type of the loop and its error constants.",
    needs=("open_loop",),
    options=ErrorOptions,
    example={"transfer_function": "10/(s(s + 2))", "reference": "ramp"},
    answers=[
        AnswerName(
            "error",
            r"e(\infty)",
            "the limit of the error $r - y$",
            principal=True,
            infinite=True,
            earned=("at_both_ends", "stable", "unity", "reference", "disturbance", "final_value", "by_constants"),
        ),
        AnswerName(
            "system_type", r"\text{type}", "the number of integrators of $L$", count=True, earned=("constants",)
        ),
        AnswerName(
            "position_constant",
            "K_p",
            r"the position constant (the limit of $L(s)$ for $s \to 0$, discrete: of $L(z)$ for $z \to 1$)",
            optional=True,
            infinite=True,
            earned=("constants",),
        ),
        AnswerName(
            "velocity_constant",
            "K_v",
            r"the velocity constant (the limit of $s L(s)$ for $s \to 0$, discrete: of $(z - 1) L(z)/T$ for $z \to 1$)",
            optional=True,
            unit="1/s",
            infinite=True,
            earned=("constants",),
        ),
        AnswerName(
            "acceleration_constant",
            "K_a",
            r"the acceleration constant (the limit of $s^2 L(s)$ for $s \to 0$, "
            r"discrete: of $(z - 1)^2 L(z)/T^2$ for $z \to 1$)",
            optional=True,
            unit="1/s^2",
            infinite=True,
            earned=("constants",),
        ),
    ],
)
steady_state_error.refusal(needs_the_sample_time)


@steady_state_error.method(
    "final_value",
    title="Final value theorem",
    source="Ogata, Modern Control Engineering, §5–8; Discrete-Time Control Systems, §4–4",
)
def by_final_value(given: Given[OpenLoop, ErrorOptions]) -> Derivation[Answers]:
    """The limit of s E(s), where all poles of s E(s) are inside; in discrete time that of (1 − z⁻¹) E(z)."""
    loop, acting = given.system, acting_on(given)
    inside = yield from _stable(loop)
    shares = yield from shares_of(loop, acting.r, acting.d)
    e: Expr = (yield from limit_of(loop, shares, inside)) if shares else sp.S.Zero
    constants = yield from constants_of(loop, inside)
    return Answers(error=e, **constants)


@steady_state_error.method(
    "error_constants",
    title="Error constants",
    source="Ogata, Modern Control Engineering, §5–8; Discrete-Time Control Systems, §4–4",
)
def by_constants(given: Given[OpenLoop, ErrorOptions]) -> Derivation[Answers]:
    """1/(1 + K_p), 1/K_v, 1/K_a for each step, ramp and parabola in the reference; of stable loops with H = 1."""
    loop, acting = given.system, acting_on(given)
    r, t, discrete = acting.r, acting.time, loop.discrete
    powers = acting.parts
    missing = (
        "loop" if not loop.closed
        else "unity" if loop.H != 1
        else "disturbance" if acting.d != 0
        else "reference" if powers is None
        else "sample_time" if discrete and loop.sample_time is None and any(powers[1:])
        else ""
    )  # fmt: skip
    if missing:
        raise Unsolved("steady_state_error/no_constants", missing=missing, r=r)
    inside = yield from _stable(loop)
    constants = yield from constants_of(loop, inside)
    N, D, x = loop.numerator * loop.factor, loop.denominator, loop.variable
    image = exact.transform_of(r, t, x, discrete=discrete) if r != 0 else sp.S.Zero
    E = image_of(loop, D / (D + N), image) if r != 0 else sp.S.Zero
    found = long_run_of(loop, E, inside)
    if found.value is None:
        raise Unsolved("steady_state_error/sign", lead=found.lead, order=found.order)
    yield _told_by_constants(acting, constants, found.value)
    return Answers(error=found.value, **constants)


def _told_by_constants(acting: Acting, constants: Mapping[str, Any], e: Expr) -> Step:
    """The error as a sum of one quotient for each power of t."""
    powers = acting.parts or ()
    rows: list[Any] = []
    for n, (c, name) in enumerate(zip(powers, CONSTANTS, strict=True)):
        K = constants.get(name)
        if c != 0 and K is not None:
            rows.append((n, c, K, quotient(c, total(1, K)) if n == 0 else quotient(c, K)))
    finite = [stated for _, _, K, stated in rows if K not in (sp.oo, -sp.oo, 0)]
    claims = {}
    if finite and e not in (sp.oo, -sp.oo):
        claims = {"e": Claim(total(*finite) if len(finite) > 1 else finite[0], e, "the error")}
    return Step("by_constants", claims=claims, unclaimed="" if claims else "a quotient by zero or by infinity",
                rows=rows, e=e, r=acting.r)  # fmt: skip


def _stable(loop: OpenLoop) -> Derivation[Inside]:
    """The loop is stable; with a dead time in it by Nyquist's count."""
    return (yield from (stable_late_loop if loop.delay != 0 and loop.closed else stable_loop)(loop))


@steady_state_error.verification("error")
def is_what_remains(given: Given[OpenLoop, ErrorOptions], answers: Answers) -> Iterable[Check]:
    """Continuous: by s E(s) beside the origin and a simulation; discrete: by the recursion of the loop, twice."""
    loop, error, acting = given.system, answers["error"], acting_on(given)
    s, signals, discrete = loop.variable, [acting.r, acting.d], loop.discrete
    label = Phrase("$e(\\infty)$ is what remains of $r - y$")
    if error == sp.zoo:
        yield Check.that(label, "compared", False, answer="error")
        return

    def loops() -> Any:
        factors = (loop.C, loop.G, loop.H)
        return judges.stable_loops(
            factors, s, [*signals, error], closed=loop.closed, discrete=discrete, delay=loop.delay,
            late_stable=lambda point: is_stable_at(loop, point),
        )  # fmt: skip

    for oracle, residual, tolerance in judges.error_judges(discrete=discrete, late=loop.delay != 0):
        check = partial(residual, loops, signals, s, acting.time, error)
        yield numeric.check_residual(label, oracle, check, tolerance, answer="error")


@steady_state_error.verification("system_type")
def is_the_order_of_the_pole(given: Given[OpenLoop, ErrorOptions], answers: Answers) -> Iterable[Check]:
    """How fast L grows near the origin, near z = 1."""
    loop = given.system
    at = sp.Integer(1 if loop.discrete else 0)
    found = judges.order_at_origin(loop.numerator, loop.denominator, loop.variable, at)
    own = answers["system_type"]
    label = "the order of the pole of $L$ at $z = 1$" if loop.discrete else "the order of the pole of $L$ at the origin"
    yield Check.that(label, "mpmath", {max(n, 0) for n in found} == {own})


@steady_state_error.verification(*CONSTANTS)
def are_limits(given: Given[OpenLoop, ErrorOptions], answers: Answers) -> Iterable[Check]:
    """The limits of sⁿ L; of an infinite one that of 1/(sⁿ L), which is zero, and the sign of L beside the origin."""
    loop, acting = given.system, acting_on(given)
    s, labels = loop.variable, DISCRETE_LIMITS if loop.discrete else LIMITS

    def wrong_side(sign: int) -> float:
        factors = (loop.C, loop.G, loop.H)
        signals = [acting.r, acting.d]
        found = judges.stable_loops(
            factors, s, signals, closed=loop.closed, discrete=loop.discrete, delay=loop.delay,
            late_stable=lambda point: is_stable_at(loop, point),
        )  # fmt: skip
        return judges.sign_residual(found, s, sign)

    for n, name in enumerate(CONSTANTS):
        if name in answers:
            value, T = answers[name], loop.sample_time
            if value == sp.zoo:
                yield Check.that(labels[n], "mpmath", False, answer=name)
                continue
            if value in (sp.oo, -sp.oo):
                side = partial(wrong_side, 1 if value == sp.oo else -1)
                yield numeric.check_residual(labels[n], "mpmath", side, answer=name)
                claim = Claim(limit_stated(loop, n, "+", inverse=True), sp.S.Zero)
            else:
                claim = Claim(limit_stated(loop, n, "+"), value * T**n if n and T is not None else value)
            yield numeric.check_claim(claim, labels[n], answer=name)


error_mistakes.register(steady_state_error)
