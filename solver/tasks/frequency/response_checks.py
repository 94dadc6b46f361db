"""What frequency responses are held to: values of C G/(1 + C G H) on the boundary, the largest of samples refined."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

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


def _numbers(given: Given[OpenLoop, ResponseOptions]) -> judges.ClosedResponse:
    loop = given.system
    H = loop.H if loop.closed else sp.S.Zero
    return judges.closed_response(loop.C, loop.G, H, loop.variable, loop.delay, period_of(loop))


def is_the_value(given: Given[OpenLoop, ResponseOptions], answers: Answers) -> Iterable[Check]:
    """T(jω), or T(e^{jωT}), by numbers; phases are judged up to full turns."""
    found, options = _numbers(given), given.options
    size, angle = ON_CIRCLE if given.system.discrete else ON_AXIS
    at = found.frequency_asked(options.input, options.frequency)
    if "magnitude" in answers:
        yield Check.within(size, BY_VALUES, found.magnitude_residual(answers["magnitude"], at), TOLERANCE,
                           answer="magnitude")  # fmt: skip
    if "phase" in answers:
        yield Check.within(angle, BY_VALUES, found.phase_residual(answers["phase"], at), TOLERANCE,
                           answer="phase")  # fmt: skip
    if "y_steady_state" in answers:
        residual = found.steady_residual(answers["y_steady_state"], options.input)
        yield Check.within("the steady answer to the input", BY_VALUES, residual, TOLERANCE, answer="y_steady_state")


def is_the_largest(given: Given[OpenLoop, ResponseOptions], answers: Answers) -> Iterable[Check]:
    """The largest magnitude is sought among samples and refined."""
    peak = _numbers(given).peak()
    for name, place in (("resonant_frequency", 0), ("resonant_peak", 1), ("resonant_phase", 2)):
        if name in answers:
            known = [] if peak is None else [peak[place]]
            judged = "phase_margin" if place == 2 else name  # modulo 360°
            residual = judges.margin_residual(answers[name], known, judged) if known else float("inf")
            yield Check.within(
                "the largest magnitude and where it is", "mpmath, samples refined", residual, TOLERANCE, answer=name
            )


def falls_there_first(given: Given[OpenLoop, ResponseOptions], answers: Answers) -> Iterable[Check]:
    """The first frequency of all samples where |T| has fallen to |T(0)|/√2, of a discrete loop |T(1)|/√2."""
    found = _numbers(given).bandwidth()
    residual = judges.margin_residual(answers["bandwidth"], [found], "bandwidth") if found else float("inf")
    says = (
        "$|T(e^{j\\omega_b T})| = |T(1)|/\\sqrt{2}$"
        if given.system.discrete
        else "$|T(j\\omega_b)| = |T(0)|/\\sqrt{2}$"
    )
    yield Check.within(says, "mpmath, samples bisected", residual, TOLERANCE)


__all__ = ["register"]
