"""The DC gain G(0): what a constant input becomes in the end."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import TYPE_CHECKING

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
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import classical as judges
from solver.stated.algebra import power, product, quotient
from solver.stated.calculus import value_at
from solver.tasks.classical.paths import Path, path_of, quietly, stated_path
from solver.tasks.plant_options import LoopOptions

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.classical.paths import Plant

dc_gain: Task[Plant, LoopOptions] = Task(
    "dc_gain",
    title="DC gain",
    doc="G(0), the gain of a constant input in the stationary state.",
    needs=("path",),
    options=LoopOptions,
    answers=[AnswerName("dc_gain", "G(0)", "the DC gain", earned=("value", "integrators"))],
)


@dc_gain.method(source="Franklin, Powell and Emami-Naeini, section 3.1", time="continuous")
def by_the_value_at_zero(given: Given[Plant, LoopOptions]) -> Derivation[Answers]:
    """G at s = 0; infinite where G has a pole there."""
    path = yield from path_of(given)
    found = exact.value_at_zero(path.fraction)
    if found.order:
        return (yield from _infinite(path, found))
    claim = Claim(value_at(quotient(*path.shown), path.variable, sp.Integer(0)), found.value, "$G(0)$")
    yield Step("value", claims={"value": claim}, x=path.variable, delay=path.delay,
               excluded=exact.vanishing_factors(found.below.subs(path.variable, 0)))  # fmt: skip
    yield _meaning(path)
    return Answers(dc_gain=found.value)


def _infinite(path: Path, found: exact.ValueAtZero) -> Derivation[Answers]:
    """Without the integrators G has a value, whose sign tells where the output goes."""
    x = path.variable
    rest = quotient(path.top, found.below)
    apart = product(quotient(1, power(x, sp.Integer(found.order))), rest)
    claims = {
        "apart": Claim(quotient(*path.shown), apart, "integrators apart"),
        "rest": Claim(value_at(rest, x, sp.Integer(0)), found.value, "value without the integrators"),
    }
    sign = exact.sign_of(found.value)
    yield Step("integrators", claims=claims, x=x, order=found.order, name=path.name, sign=sign)
    if sign is None:
        raise Unsolved("dc_gain/sign_open", value=found.value)
    return Answers(dc_gain=sp.oo if sign > 0 else -sp.oo)


def _meaning(path: Path) -> Step:
    """Whether the output of a constant input settles at all."""
    listed = sp.Poly(path.bottom, path.variable).all_coeffs()
    stable = exact.is_stable_polynomial(listed, discrete=False) if len(listed) > 1 else True
    return Step("meaning", detail="full", unclaimed="a remark; the answer has a check of its own", stable=stable,
                static=len(listed) == 1)  # fmt: skip


@dc_gain.verification("dc_gain")
def is_the_value_near_zero(given: Given[Plant, LoopOptions], answers: Answers) -> Iterable[Check]:
    """G as it was given, at a point so near to zero that it makes no difference."""
    check = partial(judges.dc_gain_residual, stated_path(given.system), answers["dc_gain"])
    yield numeric.check_residual("$G$ near $s = 0$", "mpmath (50 digits)", check, answer="dc_gain")


@dc_gain.mistake(
    Slip("gain_of_factors", "it is the factor before the fraction; the constant terms count too"), "dc_gain"
)
def leading_coefficients(wrong: Attempt[Plant, LoopOptions]) -> Iterable[Expr]:
    """The gain of the pole-zero form, G's value at infinity where it has one."""
    path = quietly(path_of(wrong.given))
    yield sp.LC(path.top, path.variable)


@dc_gain.mistake(Slip("reciprocal", "numerator and denominator are exchanged"), "dc_gain")
def upside_down(wrong: Attempt[Plant, LoopOptions]) -> Iterable[Expr]:
    """1/G(0)."""
    if wrong.ours.is_finite and wrong.ours != 0:
        yield 1 / wrong.ours
