"""PID controllers by the rules of Ziegler and Nichols, or by placing the poles of the closed loop."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Derivation, Given, Refusal, Task, Unsolved
from solver.derivation.conversion import converted
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import compensators as judges
from solver.tasks.compensators import pid_mistakes
from solver.tasks.compensators.closed_loop import loop_closed_by
from solver.tasks.compensators.pid_options import PidOptions, is_measured, number_of_poles, pid_faults
from solver.tasks.compensators.placed_loop import gains_that_place
from solver.tasks.compensators.plants import loop_of
from solver.tasks.compensators.ultimate import ultimate_gain_of, ultimate_gain_with_dead_time
from solver.tasks.compensators.ziegler_nichols import controller_of, reaction_curve_of, tuned_by_table
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpenLoop, System

GAINS = ("K_p", "K_i", "K_d")
EARNED = ("period", "tangent", "table", "equations")

pid_tuning: Task[Any, PidOptions] = Task(
    "pid_tuning",
    title="PID controller",
    doc="The gains of a P, PI or PID controller: by Ziegler and Nichols, or by the poles of the closed loop.",
    needs=(),
    options=PidOptions,
    answers=[
        AnswerName("controller", "C(s)", "the controller", principal=True, earned=EARNED),
        AnswerName("K_p", "K_p", "the gain of the error", principal=True, earned=EARNED),
        AnswerName("K_i", "K_i", "the gain of the integral of the error", principal=True, unit="1/s", earned=EARNED),
        AnswerName("K_d", "K_d", "the gain of the derivative of the error", principal=True, unit="s", earned=EARNED),
        AnswerName("K_u", "K_u", "the gain at which the loop oscillates", ("ziegler_nichols_ultimate",), optional=True,
                   earned=("crossings",)),
        AnswerName("T_u", "T_u", "the period of the loop on the verge of instability", ("ziegler_nichols_ultimate",),
                   optional=True, unit="s", earned=("crossings",)),
    ],
    example={"transfer_function": '"1/(s (s + 1) (s + 5))"'},
)  # fmt: skip
pid_mistakes.register(pid_tuning)


@pid_tuning.refusal
def incomplete_question(system: System, options: PidOptions) -> Iterable[Refusal]:
    """A plant is needed, or the tangent of a step response."""
    yield from pid_faults(system, options)


def _plant(given: Given[Any, PidOptions]) -> Derivation[OpenLoop]:
    """The plant as it stands in the loop; raises Unsolved where it holds parameters."""
    G: OpenLoop = yield from converted(given.system, ("open_loop",))
    if G.numerator == 0:
        raise Unsolved("pid_tuning/zero_plant")
    return G


def _of_numbers(G: OpenLoop) -> None:
    if G.around:
        raise Unsolved("pid_tuning/parameters", names=sorted(map(str, G.around)))


@pid_tuning.method(
    "ziegler_nichols_ultimate",
    title="Ziegler and Nichols, ultimate gain",
    source="Ogata, Modern Control Engineering, §8–2",
    time="continuous",
    needs=("open_loop",),
)
def by_the_ultimate_gain(given: Given[OpenLoop, PidOptions]) -> Derivation[Answers]:
    """The gain K_u and the period T_u of the loop at its stability limit, then the table."""
    G = given.system
    _of_numbers(G)
    if G.numerator == 0:
        raise Unsolved("pid_tuning/zero_plant")
    K_u, T_u = yield from (ultimate_gain_of(G) if G.delay == 0 else ultimate_gain_with_dead_time(G))
    answers = yield from _tuned(given, G, "ultimate", K_u, T_u, {"K_u": K_u, "T_u": T_u})
    answers.update(K_u=K_u, T_u=T_u)
    return answers


@pid_tuning.method(
    "ziegler_nichols_step",
    title="Ziegler and Nichols, step response",
    source="Ogata, Modern Control Engineering, §8–2",
    time="continuous",
)
def by_the_reaction_curve(given: Given[Any, PidOptions]) -> Derivation[Answers]:
    """The slope R of the steepest tangent of the step response and the dead time L, then the table."""
    options = given.options
    if is_measured(options):
        R, L, G = options.slope, options.dead_time, None
        assert R is not None and L is not None  # noqa: S101, PT018 - the refusal has seen to it
    else:
        G = yield from _plant(given)
        _of_numbers(G)
        curve = yield from reaction_curve_of(G)
        R, L = curve.slope, curve.dead_time
    return (yield from _tuned(given, G, "step", 1 / (R * L), L, {"R": R, "L": L}))


def _tuned(
    given: Given[Any, PidOptions], G: OpenLoop | None, of: str, gain: Expr, time: Expr, letters: dict[str, Expr]
) -> Derivation[Answers]:
    """The gains by the table, the controller, and the loop that it closes."""
    found = yield from tuned_by_table(of, given.options.controller_type, gain, time, letters)
    return (yield from _controlled(found.gains, G))


def _controlled(gains: exact.Gains, G: OpenLoop | None) -> Derivation[Answers]:
    """The controller as one fraction, and the loop that it closes where that is rational."""
    s = sp.Symbol("s")
    parts = yield from controller_of(gains, s)
    if G is not None and G.delay == 0:
        yield from loop_closed_by(parts, (G.numerator, G.denominator), s, "After a step of the reference")
    K_p, K_i, K_d = gains
    return Answers(controller=parts[0] / parts[1], K_p=K_p, K_i=K_i, K_d=K_d)


@pid_tuning.method(
    "pole_placement",
    title="Pole placement",
    source="Åström and Murray, Feedback Systems, §11.2",
    time="continuous",
    needs=("open_loop",),
)
def by_placing_the_poles(given: Given[OpenLoop, PidOptions]) -> Derivation[Answers]:
    """The characteristic polynomial with the gains in it, compared with the polynomial of the poles."""
    G, kind, poles = given.system, given.options.controller_type, given.options.poles
    if G.delay != 0:
        raise Unsolved("pid_tuning/dead_time")
    if not poles:
        raise Unsolved("pid_tuning/no_poles")
    n = number_of_poles(kind, G.numerator, G.denominator, G.variable)
    if len(poles) != n:
        raise Unsolved("pid_tuning/number_of_poles", kind=kind, n=n, count=len(poles))
    gains = yield from gains_that_place(G, kind, poles)
    return (yield from _controlled(gains, G))


ORACLES = {
    "ziegler_nichols_ultimate": ("numpy.roots", "the ultimate gain and its period in numbers, and the table"),
    "ziegler_nichols_step": ("scipy.linalg.expm", "the steepest tangent in numbers, and the table"),
    "pole_placement": ("numpy.linalg.lstsq", "the coefficients compared in numbers"),
}
NEAR = 4e-10
"""What roots in doubles leave of a gain."""


@pid_tuning.verification("controller", *GAINS, "K_u", "T_u")
def are_those_of_the_method(given: Given[Any, PidOptions], answers: Answers) -> Iterable[Check]:
    """Each answer by itself, from the plant or the tangent in numbers."""
    question = _question(given)
    oracle, label = ORACLES[question.method]
    for name, value in answers.items():
        yield numeric.check_residual(
            Phrase("{name}: {label}", name=name, label=label),
            oracle,
            lambda name=name, value=value: judges.pid_residual(question, name, value),  # type: ignore[misc]  # bound here
            NEAR,
            answer=name,
        )


def _question(given: Given[Any, PidOptions]) -> judges.PidQuestion:
    options = given.options
    implied = "pole_placement" if options.poles else "ziegler_nichols_step" if is_measured(options) else ""
    method = given.method or implied or "ziegler_nichols_ultimate"
    if method == "ziegler_nichols_step" and is_measured(options):
        R, L = options.slope, options.dead_time
        return judges.PidQuestion(method, options.controller_type, variable=sp.Symbol("s"), slope=R, dead_time=L)
    G = loop_of(given.system)
    poles = options.poles if method == "pole_placement" else ()
    return judges.PidQuestion(
        method, options.controller_type, G.numerator, G.denominator, G.variable, G.delay, poles=poles
    )
