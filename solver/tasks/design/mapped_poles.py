"""Poles of a sampled plant that are asked for in s: z = e^{sT} takes them to the z-plane."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, TypeVar

from solver.derivation import Claim, Derivation, Given, Refusal, Slip, Step, Task, lemma, option
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.numeric.judges import design as judges
from solver.options.poles import Poles
from solver.stated.algebra import exponential
from solver.tasks.figures import plane, roots
from solver.tasks.plant_options import PlantOptions
from solver.tasks.sample_times import sample_time_of, sample_time_option, sample_time_refusals
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import Expr

PERIOD_MISSING = Slip("period_missing", "the sampling period is missing: a pole $s$ becomes $e^{sT}$, not $e^{s}$")
NOT_MAPPED = Slip("not_mapped", "the poles in $s$ are taken for poles in $z$; a pole $s$ becomes $z = e^{sT}$")
LINEARIZED = Slip("linearized", "$1 + sT$ is taken for $e^{sT}$")


@dataclass(frozen=True, kw_only=True)
class SampledPoles(PlantOptions):
    """Poles; those of a discrete system may be given in s."""

    poles: tuple[Expr, ...] | None = option(Poles(), "the poles asked for")
    s_poles: tuple[Expr, ...] | None = option(
        Poles(), "of a discrete plant, in place of poles: the poles in s, which z = e^{sT} takes to z", answer="poles"
    )
    sample_time: Expr | None = sample_time_option()


@lemma("mapped_poles")
def mapped_poles(poles: Sequence[Expr], period: Expr) -> Derivation[list[Expr]]:
    """z = e^{sT} for each of the poles in s, in their order."""
    found = [exact.pole_in_z(s, period) for s in poles]
    yield Step(
        "mapped",
        claims={
            f"pole{i}": Claim(exponential(sp.expand(s * period)), z, Phrase("pole {i}", i=i))
            for i, (s, z) in enumerate(zip(poles, found, strict=True), 1)
        },
        poles=list(poles),
        found=found,
        partners=_partners(poles),
        T=period,
        complex=any(s.has(sp.I) for s in poles),
        aliased=[s for s in poles if _is_aliased(s, period)],
        figures=plane("The poles in z, with the unit circle", roots("poles", found), discrete=True),
    )
    return found


def _partners(poles: Sequence[Expr]) -> list[int]:
    """For each pole the number, from 1, of an earlier one that it is conjugate to; 0 where it is the first."""
    numbers: list[int] = []
    for i, s in enumerate(poles):
        mirror = exact.conjugated(s)
        earlier = (j for j in range(i) if s.has(sp.I) and poles[j] == mirror and j + 1 not in numbers)
        numbers.append(next((j + 1 for j in earlier), 0))
    return numbers


def _is_aliased(s: Expr, period: Expr) -> bool:
    """Whether a frequency is beyond half the sampling frequency, |ωT| > π."""
    angle = sp.expand((s - exact.conjugated(s)) * period / (2 * sp.I))
    return bool(angle.is_number and abs(sp.N(angle, 30)) > sp.N(sp.pi, 30))


def poles_in_z(given: Given[Any, SampledPoles]) -> Derivation[list[Expr]]:
    """Return the poles that the question gives, those in s mapped to z by a step."""
    options = given.options
    if options.s_poles is None:
        return list(options.poles or ())
    return (yield from mapped_poles(options.s_poles, sample_time_of(given)))


def exact_poles_in_z(given: Given[Any, SampledPoles]) -> list[Expr]:
    """Return the same without a step."""
    options = given.options
    if options.s_poles is None:
        return list(options.poles or ())
    return [exact.pole_in_z(s, sample_time_of(given)) for s in options.s_poles]


def numeric_poles_in_z(given: Given[Any, SampledPoles]) -> list[Any]:
    """Return the same without the exact kernels, e^{sT} as it stands."""
    options = given.options
    if options.s_poles is None:
        return list(options.poles or ())
    return judges.sampled_poles(options.s_poles, sample_time_of(given))


def mapping_faults(system: Any, options: SampledPoles, *, others: bool = False) -> Iterable[Refusal]:
    """Yield what is wrong with poles in s: a continuous plant, poles in z beside them, no sampling period.

    `others`: there are poles in s by other options, which need the period too.
    """
    asked = options.has("s_poles")
    if asked and not system.discrete:
        yield "s_poles", Reason("mapped_poles/continuous")
    elif asked and options.has("poles"):
        yield "s_poles", Reason("mapped_poles/both")
    elif not system.discrete and options.sample_time is not None:
        yield "sample_time", Reason("mapped_poles/period_of_continuous")
    else:
        yield from sample_time_refusals(system, options, needed=asked or (others and system.discrete))


def asked_faults(system: Any, options: SampledPoles) -> Iterable[Refusal]:
    """Yield what is wrong where poles must be given: neither in z nor in s, or mapped without need or period."""
    if not options.has("poles") and not options.has("s_poles"):
        yield "", Reason("mapped_poles/no_poles", {"discrete": system.discrete})
    yield from mapping_faults(system, options)


def listed(options: SampledPoles) -> tuple[str, Sequence[Any] | None]:
    """Return the name and the value of the option by which the number of poles is judged; None where it is unknown."""
    return ("poles", options.poles) if options.poles is not None else ("s_poles", options.s_poles)


O = TypeVar("O", bound=SampledPoles)


def without_the_period(system: Any, options: O) -> tuple[Any, O] | None:
    """e^{s} for e^{sT}."""
    asked = system.discrete and (options.s_poles is not None or options.poles is None)
    return (replace(system, sample_time=None), replace(options, sample_time=sp.Integer(1))) if asked else None


def not_mapped(system: Any, options: O) -> tuple[Any, O] | None:
    """s for e^{sT}."""
    return None if options.s_poles is None else (system, replace(options, s_poles=None, poles=options.s_poles))


def linearized(system: Any, options: O) -> tuple[Any, O] | None:
    """1 + sT for e^{sT}."""
    period = options.sample_time if options.sample_time is not None else system.sample_time
    if options.s_poles is None or period is None:
        return None
    poles = tuple(sp.expand(1 + s * period) for s in options.s_poles)
    return system, replace(options, s_poles=None, poles=poles)


def with_mapping_mistakes(task: Task[Any, Any]) -> None:
    """Declare what goes wrong when poles are mapped."""
    task.mistaken_question(PERIOD_MISSING)(without_the_period)
    task.mistaken_question(NOT_MAPPED)(not_mapped)
    task.mistaken_question(LINEARIZED)(linearized)
