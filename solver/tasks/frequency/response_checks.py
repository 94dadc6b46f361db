"""What frequency responses are held to: values of C G/(1 + C G H) on the boundary, the largest of samples refined."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, NamedTuple

from solver.derivation import Check
from solver.lazy import sympy as sp
from solver.numeric.judges import frequency as judges
from solver.tasks.frequency.boundary import period_of

if TYPE_CHECKING:
    from solver.derivation import Answers, Given, Task
    from solver.systems import OpenLoop
    from solver.tasks.frequency.frequency_response import ResponseOptions

BY_VALUES = "mpmath, values of C G/(1 + C G H)"
TOLERANCE = 1e-19
ON_AXIS = ("$|T(j\\omega)|$", "$\\angle T(j\\omega)$")
ON_CIRCLE = ("$|T(e^{j\\omega T})|$", "$\\angle T(e^{j\\omega T})$")


def register(task: Task[OpenLoop, ResponseOptions]) -> None:
    """Add the verifications to the task."""
    task.verification("magnitude", "phase", "y_steady_state")(is_the_value)
    task.verification("resonant_frequency", "resonant_peak", "resonant_phase")(is_the_largest)
    task.verification("bandwidth")(falls_there_first)


def _asked(given: Given[OpenLoop, ResponseOptions], answers: Answers) -> list[Asked]:
    """The question in numbers, at random values of its parameters; once where there are none."""
    loop, options = given.system, given.options
    H = loop.H if loop.closed else sp.S.Zero
    formulas = [loop.C, loop.G, H, sp.S.Zero + loop.delay]
    further = [each for each in (options.frequency, options.input) if each is not None]
    found = []
    for values in judges.values_of_parameters([*formulas, *further], (loop.variable, *sp.symbols("t k"))):
        C, G, feedback, delay = (each.xreplace(values) for each in formulas)
        function = judges.closed_response(C, G, feedback, loop.variable, delay, period_of(loop))
        u, omega = (None if each is None else each.xreplace(values) for each in (options.input, options.frequency))
        own = {name: (sp.S.Zero + answers[name]).xreplace(values) for name in answers}
        found.append(Asked(function, own, function.frequency_asked(u, omega), u))
    return found


class Asked(NamedTuple):
    """T, the answers, the frequency of the question (None for functions) and its input, in numbers."""

    T: judges.ClosedResponse
    answers: dict[str, Any]
    omega: Any
    input: Any


def is_the_value(given: Given[OpenLoop, ResponseOptions], answers: Answers) -> Iterable[Check]:
    """T(jω), or T(e^{jωT}), by numbers; phases are judged up to full turns."""
    size, angle = ON_CIRCLE if given.system.discrete else ON_AXIS
    asked = _asked(given, answers)
    if "magnitude" in answers:
        worst = max(each.T.magnitude_residual(each.answers["magnitude"], each.omega) for each in asked)
        yield Check.within(size, BY_VALUES, worst, TOLERANCE, answer="magnitude")
    if "phase" in answers:
        worst = max(each.T.phase_residual(each.answers["phase"], each.omega) for each in asked)
        yield Check.within(angle, BY_VALUES, worst, TOLERANCE, answer="phase")
    if "y_steady_state" in answers:
        worst = max(each.T.steady_residual(each.answers["y_steady_state"], each.input) for each in asked)
        yield Check.within("the steady answer to the input", BY_VALUES, worst, TOLERANCE, answer="y_steady_state")


def is_the_largest(given: Given[OpenLoop, ResponseOptions], answers: Answers) -> Iterable[Check]:
    """The largest magnitude is sought among samples and refined."""
    asked = _asked(given, answers)
    for name, place in (("resonant_frequency", 0), ("resonant_peak", 1), ("resonant_phase", 2)):
        if name in answers:
            judged = "phase_margin" if place == 2 else name  # modulo 360°
            peaks = [(each.answers[name], each.T.peak()) for each in asked]
            worst = max(judges.margin_residual(own, [peak[place]], judged) if peak else float("inf")
                        for own, peak in peaks)  # fmt: skip
            yield Check.within(
                "the largest magnitude and where it is", "mpmath, samples refined", worst, TOLERANCE, answer=name
            )


def falls_there_first(given: Given[OpenLoop, ResponseOptions], answers: Answers) -> Iterable[Check]:
    """The first frequency of all samples where |T| has fallen to |T(0)|/√2, of a discrete loop |T(1)|/√2."""
    bands = [(each.answers["bandwidth"], each.T.bandwidth()) for each in _asked(given, answers)]
    residual = max(judges.margin_residual(own, [band], "bandwidth") if band else float("inf") for own, band in bands)
    says = (
        "$|T(e^{j\\omega_b T})| = |T(1)|/\\sqrt{2}$"
        if given.system.discrete
        else "$|T(j\\omega_b)| = |T(0)|/\\sqrt{2}$"
    )
    yield Check.within(says, "mpmath, samples bisected", residual, TOLERANCE)


__all__ = ["register"]
