"""Usual mistakes with sampled plants."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.lazy import exact, systems
from solver.lazy import sympy as sp
from solver.tasks.sample_times import sample_time_of

if TYPE_CHECKING:
    from sympy import Expr

    from solver.derivation import Task

PERIOD = Slip("period_left_out", "the sampling period is left out: it is $e^{sT}$, not $e^{s}$")
PERIOD_ONE = Slip("period_left_out", "the sampling period is left out: it is taken as one")
HOLD_LEFT_OUT = Slip("hold_left_out", "the hold is left out: it is $\\mathcal{Z}\\{G(s)\\}$")
STEP_RESPONSE = Slip(
    "difference_left_out", "the factor $1 - z^{-1}$ of the hold is left out: it is $\\mathcal{Z}\\{G(s)/s\\}$"
)
WITH_HOLD = Slip("hold_added", "there is no hold here: impulses drive the plant")
PRODUCT = Slip("product_of_transforms", "the transform of a product is taken as the product of the transforms; there "
                                        "is no sampler between the factors")  # fmt: skip
PRODUCT_BACK = Slip("product_of_transforms", "$G(z)H(z)$ stands for $\\overline{GH}(z)$; there is no sampler between "
                                             "plant and feedback")  # fmt: skip
OTHER_RULES = {
    "zero_order_hold": "it is the discrete plant with a zero-order hold",
    "forward_euler": "it is the discrete plant by Euler's forward method",
    "backward_euler": "it is the discrete plant by Euler's backward method",
    "tustin": "it is the discrete plant by Tustin's method",
    "matched": "it is the discrete plant by matched poles and zeros",
}


def period_left_out(task: Task[Any, Any], slip: Slip = PERIOD) -> None:
    """Register that T = 1 was put where another period is asked for."""

    def change(system: Any, options: Any) -> tuple[Any, Any] | None:
        if options.sample_time is None or options.sample_time == 1:
            return None
        return system, replace(options, sample_time=sp.S.One)

    task.mistaken_question(slip)(change)


def name_mistakes_of_pulses(task: Task[Any, Any]) -> None:
    """Register what goes wrong with pulse transfer functions."""
    period_left_out(task, PERIOD_ONE)

    @task.mistaken_question(HOLD_LEFT_OUT)
    def without_hold(system: Any, options: Any) -> tuple[Any, Any] | None:
        return (system, replace(options, hold="none")) if options.hold == "zero_order" else None

    @task.mistaken_question(WITH_HOLD)
    def with_hold(system: Any, options: Any) -> tuple[Any, Any] | None:
        return (system, replace(options, hold="zero_order")) if options.hold == "none" else None

    task.mistake(STEP_RESPONSE, "G")(step_response)
    task.mistake(PRODUCT, "G")(product_of_factors)
    task.mistake(PRODUCT_BACK, "G")(sampled_feedback)


def _plain(attempt: Attempt[Any, Any]) -> Expr | None:
    """G(s) of a plant without dead time and loop; None for any other."""
    plant, options = attempt.given.system, attempt.given.options
    loop = (getattr(options, name, None) for name in ("controller", "feedback", "delay"))
    if not isinstance(plant, systems.TransferFunction) or plant.matrix.shape != (1, 1):
        return None
    G: Expr = plant.matrix[0, 0]
    return G if all(each is None for each in loop) else None


def step_response(attempt: Attempt[Any, Any]) -> Iterable[Any]:
    """𝒵{G(s)/s}."""
    G, z = _plain(attempt), sp.Symbol("z")
    if G is not None and getattr(attempt.given.options, "hold", "zero_order") == "zero_order":
        yield attempt.ours * z / (z - 1)


def product_of_factors(attempt: Attempt[Any, Any]) -> Iterable[Any]:
    """G₁(z) G₂(z) of two factors of G, each with the hold where there is one."""
    G, s, z = _plain(attempt), sp.Symbol("s"), sp.Symbol("z")
    split = None if G is None else exact.two_factors(G, s)
    if split is None:
        return
    T, held = sample_time_of(attempt.given), getattr(attempt.given.options, "hold", "zero_order") == "zero_order"
    yield sp.Mul(*(exact.pulse(each, s, T, held=held).result.expression(z) for each in split))


def sampled_feedback(attempt: Attempt[Any, Any]) -> Iterable[Any]:
    """C G/(1 + C G(z) H(z)) where H acts between the samples."""
    given, s, z = attempt.given, sp.Symbol("s"), sp.Symbol("z")
    H, C = given.options.feedback, given.options.controller
    plant = given.system
    if H is None or not H.has(s) or not isinstance(plant, systems.TransferFunction) or given.options.delay is not None:
        return
    T, held = sample_time_of(given), given.options.hold == "zero_order"
    G = exact.pulse(plant.matrix[0, 0], s, T, held=held).result
    if sp.degree(sp.denom(sp.together(H)), s) > sp.degree(sp.numer(sp.together(H)), s):
        for way in (False, True):
            image = exact.pulse(H, s, T, held=way).result.expression(z)
            yield exact.closed_in_z(sp.S.One if C is None else C, G, image, z).whole


def name_mistakes_of_discretization(task: Task[Any, Any], answers_by: Callable[[Any, str], Any]) -> None:
    """Register that another method was taken; `answers_by` gives the answers of a question by a method."""
    period_left_out(task, PERIOD_ONE)

    def taken(name: str) -> Callable[[Attempt[Any, Any]], Iterable[Any]]:
        def values(attempt: Attempt[Any, Any]) -> Iterable[Any]:
            if (attempt.given.method or "zero_order_hold") != name:
                found = answers_by(attempt.given, name)
                if attempt.name in found:
                    yield found[attempt.name]

        return values

    for name, words in OTHER_RULES.items():
        task.mistake(Slip(name, words), *"ABCDG")(taken(name))
    task.mistake(STEP_RESPONSE, "G")(held_alone(step_response))
    task.mistake(HOLD_LEFT_OUT, "G")(held_alone(impulse_response))
    task.mistake(PRODUCT, "G")(held_alone(product_of_factors))


def held_alone(values: Callable[[Attempt[Any, Any]], Iterable[Any]]) -> Callable[[Attempt[Any, Any]], Iterable[Any]]:
    """The values where the method is the hold."""

    def of_hold(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        if attempt.given.method in ("", "zero_order_hold"):
            yield from values(attempt)

    return of_hold


def impulse_response(attempt: Attempt[Any, Any]) -> Iterable[Any]:
    """𝒵{G(s)}."""
    G, s, z = _plain(attempt), sp.Symbol("s"), sp.Symbol("z")
    if G is not None and sp.degree(sp.denom(sp.together(G)), s) > sp.degree(sp.numer(sp.together(G)), s):
        yield exact.pulse(G, s, sample_time_of(attempt.given), held=False).result.expression(z)
