"""The DC gain G(0), of discrete systems G(1): what a constant input becomes in the end."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Claim,
    Derivation,
    Given,
    Slip,
    Step,
    Task,
    Unsolved,
)
from solver.derivation.conversion import converted_to
from solver.lazy import exact, numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import classical as judges
from solver.stated.algebra import power, product, quotient
from solver.stated.calculus import value_at
from solver.tasks.classical.paths import Path, path_of, quietly, stated_path
from solver.tasks.mistakes import OPEN_LOOP, not_closed
from solver.tasks.plant_options import LoopOptions

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.classical.paths import Plant

dc_gain: Task[Plant, LoopOptions] = Task(
    "dc_gain",
    title="DC gain",
    doc="G(0), in discrete time G(1): the gain of a constant input in the stationary state.",
    needs=("path",),
    options=LoopOptions,
    answers=[
        AnswerName(
            "dc_gain", r"\text{DC gain}", "the DC gain", unit="ratio", infinite=True, earned=("value", "integrators")
        )
    ],
)


@dc_gain.method(source="Franklin, Powell and Emami-Naeini, section 3.1; Ogata, Discrete-Time Control Systems, §3–4")
def by_the_value_at_zero(given: Given[Plant, LoopOptions]) -> Derivation[Answers]:
    """G at s = 0, at z = 1; infinite where G has a pole there. Of a loop round a dead time e⁰ is 1 in it."""
    late = isinstance(given.system, systems.LateLoop)
    path = yield from (_at_rest(given) if late else path_of(given))
    found = exact.value_at_zero(path.fraction, discrete=path.discrete)
    if found.order and late:
        raise Unsolved("dc_gain/late_pole")
    if found.order:
        return (yield from _infinite(path, found))
    claim = Claim(value_at(quotient(*path.shown), path.variable, path.rest), found.value, "the DC gain")
    yield Step("value", claims={"value": claim}, x=path.variable, delay=path.delay, discrete=path.discrete,
               excluded=exact.vanishing_factors(found.below.subs(path.variable, path.rest)))  # fmt: skip
    yield _late_meaning(given) if late else _meaning(path)
    return Answers(dc_gain=found.value)


def _at_rest(given: Given[Any, LoopOptions]) -> Derivation[Path]:
    """The loop without its dead time, which is the same at s = 0."""
    loop = given.system
    yield Step("at_rest", unclaimed="e to the power of zero is one", delay=loop.plant.delay, x=sp.Symbol("s"))
    T = yield from converted_to(loop.rational, systems.TransferFunction)
    return (yield from path_of(replace(given, system=T)))


def _late_meaning(given: Given[Any, LoopOptions]) -> Step:
    """Whether the output of a constant input settles in a loop round a dead time, by Nyquist's count."""
    loop = quietly(converted_to(given.system, systems.OpenLoop))
    known = not set(loop.parameters) - {loop.variable}
    stable = None
    if known and sp.degree(loop.numerator, loop.variable) < sp.degree(loop.denominator, loop.variable):
        stable = exact.encirclements(loop.numerator, loop.denominator, loop.variable, loop.delay).stable
    return Step("late_meaning", detail="full", unclaimed="a remark; the answer has a check of its own", stable=stable)


def _infinite(path: Path, found: exact.ValueAtZero) -> Derivation[Answers]:
    """Without the integrators G has a value, whose sign tells where the output goes."""
    x = path.variable
    rest = quotient(path.top, found.below)
    factor = x - 1 if path.discrete else x
    apart = product(quotient(1, power(factor, sp.Integer(found.order)) if found.order > 1 else factor), rest)
    claims = {
        "apart": Claim(quotient(*path.shown), apart, "integrators apart"),
        "rest": Claim(value_at(rest, x, path.rest), found.value, "value without the integrators"),
    }
    sign = exact.sign_of(found.value)
    yield Step("integrators", claims=claims, x=x, order=found.order, name=path.name, sign=sign, discrete=path.discrete)
    if sign is None:
        raise Unsolved("dc_gain/sign_open", value=found.value)
    return Answers(dc_gain=sp.oo if sign > 0 else -sp.oo)


def _meaning(path: Path) -> Step:
    """Whether the output of a constant input settles at all."""
    listed = sp.Poly(path.bottom, path.variable).all_coeffs()
    stable = exact.is_stable_polynomial(listed, discrete=path.discrete) if len(listed) > 1 else True
    return Step("meaning", detail="full", unclaimed="a remark; the answer has a check of its own", stable=stable,
                static=len(listed) == 1, discrete=path.discrete)  # fmt: skip


@dc_gain.verification("dc_gain")
def is_the_value_near_zero(given: Given[Plant, LoopOptions], answers: Answers) -> Iterable[Check]:
    """G as it was given, at a point so near to 0, or to 1, that it makes no difference."""
    discrete = given.system.discrete
    x, stated = sp.Symbol("z" if discrete else "s"), stated_path(given.system)
    check = partial(judges.dc_gain_residual, stated, answers["dc_gain"], x, int(discrete))
    label = "$G$ near $z = 1$" if discrete else "$G$ near $s = 0$"
    yield numeric.check_residual(label, "mpmath (50 digits)", check, answer="dc_gain")


@dc_gain.mistake(
    Slip("gain_of_factors", "it is the factor before the fraction; the constant terms count too"), "dc_gain"
)
def leading_coefficients(wrong: Attempt[Plant, LoopOptions]) -> Iterable[Expr]:
    """The gain of the pole-zero form, G's value at infinity where it has one."""
    path = quietly(path_of(wrong.given))
    yield sp.LC(path.top, path.variable)


@dc_gain.mistake(
    Slip("at_zero", "it is $G$ at $z = 0$; a constant input has $z = 1$, as $e^{sT}$ is 1 for $s = 0$"), "dc_gain"
)
def at_the_origin(wrong: Attempt[Plant, LoopOptions]) -> Iterable[Expr]:
    """G(0) of a discrete system."""
    path = quietly(path_of(wrong.given))
    if path.discrete:
        yield exact.value_at_zero(path.fraction).value


@dc_gain.mistake(Slip("reciprocal", "numerator and denominator are exchanged"), "dc_gain")
def upside_down(wrong: Attempt[Plant, LoopOptions]) -> Iterable[Expr]:
    """1/G(0)."""
    if wrong.ours.is_finite and wrong.ours != 0:
        yield 1 / wrong.ours


dc_gain.mistaken_question(OPEN_LOOP)(not_closed)
