"""The sensitivity of a loop: 1/(1 + L), or that of its transfer function to a parameter."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
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
    Refusal,
    Slip,
    Step,
    Task,
    Unsolved,
    option,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import loops as judges
from solver.options.parameter_name import ParameterName
from solver.stated.algebra import product, quotient, total
from solver.stated.calculus import partial_derivative
from solver.tasks.loops.late_loops import fraction_of, image_of, rational_of, with_dead_time
from solver.tasks.plant_options import LoopOptions
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import OpenLoop, System


@dataclass(frozen=True, kw_only=True)
class SensitivityOptions(LoopOptions):
    """To what."""

    parameter: str | None = option(ParameterName(), "the parameter p of (∂T/∂p)·(p/T); default: that of the loop")


sensitivity: Task[OpenLoop, SensitivityOptions] = Task(
    "sensitivity",
    title="Sensitivity",
    doc="S = 1/(1 + L), or how much the transfer function T changes with a parameter, both relatively.",
    needs=("open_loop",),
    options=SensitivityOptions,
    example={"transfer_function": "K/(s + 1)"},
    answers=[
        AnswerName(
            "S",
            "S",
            r"the sensitivity: $1/(1 + L)$, or of $T$ to a parameter $p$, $(\partial T/\partial p)\,p/T$",
            principal=True,
            earned=("of_loop", "transfer", "derivative", "relative"),
        ),
    ],
)


@sensitivity.refusal
def has_that_parameter(system: System, options: SensitivityOptions) -> Iterable[Refusal]:
    """The parameter stands in the loop."""
    name = options.parameter
    if name is not None and name not in options.parameters_with(system) and not options.later:
        yield "parameter", Reason("stability/no_parameter", {"name": name})


@sensitivity.method(source="Åström, Murray, Feedback Systems, §§12.1–12.2")
def by_definition(given: Given[OpenLoop, SensitivityOptions]) -> Derivation[Answers]:
    """1/(1 + L); of a parameter the derivative of T, times p over T."""
    loop, s = given.system, given.system.variable
    p = _parameter(given)
    if p is None:
        below: Any = total(1, with_dead_time(loop, quotient(loop.numerator, loop.denominator)))
        S = rational_of(loop, 1 / (1 + loop.numerator / loop.denominator * loop.factor))
        yield Step("of_loop", claims={"S": Claim(quotient(1, below), S, "sensitivity")}, s=s)
        return Answers(S=S)
    T = rational_of(loop, _transfer(loop))
    if T == 0:
        raise Unsolved("sensitivity/zero")
    yield Step("transfer", claims={"T": Claim(_stated_transfer(loop), T, "from the reference to the output")}, s=s,
               closed=loop.closed, unity=loop.H == 1, direct=loop.C == 1)  # fmt: skip
    slope = image_of(loop, sp.diff(T, p), sp.S.One)
    claim = Claim(partial_derivative(T, p), slope, "derivative by the parameter")
    yield Step("derivative", claims={"slope": claim}, s=s, p=p)
    S, (above, below) = rational_of(loop, slope * p / T), fraction_of(loop, T)
    claim = Claim(product(slope, quotient(product(p, below), above)), S, "sensitivity")
    yield Step("relative", claims={"S": claim}, s=s, p=p, none=S == 0)
    if loop.closed and not (loop.C * loop.H).has(p) and loop.G.has(p):
        yield _by_the_plant(loop, p, S)
    return Answers(S=S)


def _by_the_plant(loop: OpenLoop, p: Symbol, S: Expr) -> Step:
    """A check: that of the plant alone, times 1/(1 + L)."""
    G = exact.rational(loop.G)
    alone = exact.rational(sp.diff(G, p) * p / G)
    below = total(1, with_dead_time(loop, quotient(loop.numerator, loop.denominator)))
    claims = {
        "plant": Claim(product(partial_derivative(G, p), quotient(p, G)), alone, "sensitivity of the plant"),
        "loop": Claim(product(alone, quotient(1, below)), S, "through the loop"),
    }
    return Step("by_the_plant", claims=claims, detail="full", p=p, s=loop.variable)


def _parameter(given: Given[OpenLoop, SensitivityOptions]) -> Any:
    """The symbol of the parameter; None where none is named."""
    name = given.options.parameter
    return next((symbol for symbol in given.system.parameters if str(symbol) == name), None) if name else None


def _transfer(loop: OpenLoop) -> Expr:
    """T = CG/(1 + CGH), without feedback CG."""
    path = loop.C * loop.G * loop.factor
    return path / (1 + path * loop.H) if loop.closed else path


def _stated_transfer(loop: OpenLoop) -> Any:
    """T as it is written."""
    path = with_dead_time(loop, product(loop.C, loop.G) if loop.C != 1 else loop.G)
    if not loop.closed:
        return path
    return quotient(path, total(1, product(path, loop.H) if loop.H != 1 else path))


@sensitivity.verification("S")
def is_the_relative_change(given: Given[OpenLoop, SensitivityOptions], answers: Answers) -> Iterable[Check]:
    """The loop in numbers; of a parameter by differences of T in many digits."""
    loop, p = given.system, _parameter(given)
    factors = (loop.C, loop.G * loop.factor, loop.H)
    if p is None:
        check = partial(judges.loop_sensitivity_residual, factors, answers["S"])
        yield numeric.check_residual("$S\\,(1 + L) = 1$", "mpmath (50 digits)", check, answer="S")
    else:
        check = partial(judges.parameter_sensitivity_residual, factors, answers["S"], p, closed=loop.closed)
        label = "the relative change of $T$ over that of the parameter"
        yield numeric.check_residual(label, "mpmath, differences of T (50 digits)", check, answer="S")


COMPLEMENTARY = Slip("complementary", "it is the complementary sensitivity $\\frac{L}{1 + L}$")
OPEN_LOOP = Slip("open_loop", "it is the sensitivity without feedback")
NOT_RELATIVE = Slip("not_relative", "it is the derivative alone; it is still to be multiplied by $\\frac{p}{T}$")
INVERSE = Slip("inverse", "it is $1 + L$; the sensitivity is its inverse")


@sensitivity.mistake(COMPLEMENTARY, "S")
def complementary(wrong: Attempt[OpenLoop, SensitivityOptions]) -> Iterable[Any]:
    """T for S."""
    if _parameter(wrong.given) is None:
        yield exact.rational(1 - wrong.ours)


@sensitivity.mistake(INVERSE, "S")
def one_plus_loop(wrong: Attempt[OpenLoop, SensitivityOptions]) -> Iterable[Any]:
    """1 + L for its inverse."""
    if _parameter(wrong.given) is None:
        yield exact.rational(1 / wrong.ours)


@sensitivity.mistake(NOT_RELATIVE, "S")
def derivative_alone(wrong: Attempt[OpenLoop, SensitivityOptions]) -> Iterable[Any]:
    """∂T/∂p."""
    p = _parameter(wrong.given)
    if p is not None:
        yield exact.rational(sp.diff(_transfer(wrong.given.system), p))


@sensitivity.mistaken_question(OPEN_LOOP)
def without_feedback(system: Any, options: Any) -> tuple[Any, Any] | None:
    """The question about the open path."""
    if options.parameter is None or options.feedback is None:
        return None
    return system, replace(options, feedback=None)
