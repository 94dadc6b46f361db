"""The root locus: where the poles of a loop go as a gain rises from zero, by its rules, one by one."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Derivation, Given, Refusal, Step, Task, option
from solver.derivation.parameter_figures import Locus
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.numeric.judges import root_locus as judges
from solver.options.parameter_name import ParameterName
from solver.tasks.plant_options import LoopOptions
from solver.tasks.root_locus import mistakes
from solver.tasks.root_locus.angles import directions_of
from solver.tasks.root_locus.axis import Axis, crossings_of, pair
from solver.tasks.root_locus.locus_equation import Form, locus_equation_of, polynomial_of
from solver.tasks.root_locus.meeting_points import meetings_of
from solver.tasks.root_locus.rules import rules_of
from solver.words import Reason, formula

if TYPE_CHECKING:
    from solver.systems import CharacteristicEquation, System


@dataclass(frozen=True, kw_only=True)
class RootLocusOptions(LoopOptions):
    """What may vary."""

    parameter: str | None = option(
        ParameterName(), "the gain that rises from zero (default: K, the only parameter, or else a gain before L)"
    )


root_locus: Task[CharacteristicEquation, RootLocusOptions] = Task(
    "root_locus",
    title="Root locus",
    doc="The paths of the poles of a loop as a gain rises from zero: the rules one by one, and the figure.",
    needs=("characteristic_equation",),
    options=RootLocusOptions,
    example={"transfer_function": "1/(s(s + 1)(s + 2))"},
    answers=[
        AnswerName("real_axis_segments", r"\text{real axis}", "the parts of the real axis that belong to the locus",
                   intervals=True, earned=("segments",)),
        AnswerName("asymptote_angles", r"\vartheta_{k}", "the directions of the asymptotes, in degrees", numbered=True,
                   free=True, unit="°", earned=("asymptotes",)),
        AnswerName("centroid", r"\sigma_{a}", "where the asymptotes start", optional=True, earned=("asymptotes",)),
        AnswerName("breakaway_points", r"s_{b}", r"the points where branches meet, $K \ge 0$",
                   earned=("turning", "gains")),
        AnswerName("breakaway_gains", r"K_{b}", "the gains at the points where branches meet, in their order",
                   earned=("gains",)),
        AnswerName("imaginary_axis_crossings", r"s_{c}", "where branches cross the imaginary axis, discrete: the unit "
                   "circle, $K > 0$", free=True, earned=("parts", "crossings")),
        AnswerName("critical_gains", r"K_{c}", "the gains at which branches cross the limit of stability, once for "
                   "each pair", earned=("crossings",)),
        AnswerName("departure_angles", r"\varphi_{p}",
                   "the directions in which branches leave complex poles of the upper half plane, in degrees",
                   free=True, unit="°", earned=("direction",)),
        AnswerName("arrival_angles", r"\varphi_{z}",
                   "the directions from which branches reach complex zeros of the upper half plane, in degrees",
                   free=True, unit="°", earned=("direction",)),
    ],
)  # fmt: skip

mistakes.register(root_locus)


@root_locus.refusal
def has_no_such_parameter(system: System, options: RootLocusOptions) -> Iterable[Refusal]:
    """A system with parameters must have the one that is asked for."""
    found = options.parameters_with(system)
    if options.parameter and found and options.parameter not in found and not options.later:
        yield "parameter", Reason("stability/no_parameter", {"name": options.parameter})


@root_locus.method(source="Ogata, Modern Control Engineering, §§6–2, 6–3", time="both")
def by_rules(given: Given[CharacteristicEquation, RootLocusOptions]) -> Derivation[Answers]:
    """Poles and zeros, the real axis, asymptotes, meeting points, crossings, angles; then the figure."""
    form = yield from locus_equation_of(given.system, given.options.parameter)
    segments, lines = yield from rules_of(form)
    meetings = yield from meetings_of(form)
    axis = yield from crossings_of(form)
    leaving, arriving = yield from directions_of(form)
    yield Step(
        "sketch",
        unclaimed="drawn from the numbers found above",
        figures=(_figure(form, lines, meetings, axis),),
        K=form.K,
        positive=form.equation.positive,
    )
    answers = Answers(
        real_axis_segments=segments,
        asymptote_angles=list(lines.angles) if lines else [],
        breakaway_points=[each.point.value for each in meetings],
        breakaway_gains=[each.gain for each in meetings],
        imaginary_axis_crossings=[
            point for each in axis.crossings for point in ([each.point] if each.real else pair(each.point))
        ],
        critical_gains=[each.gain for each in axis.crossings],
        departure_angles=leaving,
        arrival_angles=arriving,
    )
    if lines:
        answers["centroid"] = lines.centroid
    return answers


def _figure(form: Form, lines: exact.Asymptotes | None, meetings: list[exact.Meeting], axis: Axis) -> Locus:
    return Locus(
        "The root locus",
        tuple(sp.Poly(form.N, form.s).all_coeffs()),
        tuple(sp.Poly(form.D, form.s).all_coeffs()),
        formula(form.K),
        centroid=lines.centroid if lines else None,
        angles=lines.angles if lines else (),
        meetings=tuple((each.point.value, each.gain) for each in meetings if each.gain),
        crossings=tuple((each.point, each.gain) for each in axis.crossings),
        discrete=form.discrete,
    )


def _locus(given: Given[CharacteristicEquation, RootLocusOptions]) -> judges.Locus:
    """The question in numbers."""
    p, K, _ = polynomial_of(given.system, given.options.parameter)
    return judges.locus_of(p, given.system.variable, K, discrete=given.system.discrete)


TOLERANCE = 1e-10
BY_DEFINITION = "mpmath: −D/N"
ON_THE_AXIS = (
    "branches cross the imaginary axis at these points only",
    "branches cross the imaginary axis for these gains only",
)
ON_THE_CIRCLE = (
    "branches cross the unit circle at these points only",
    "branches cross the unit circle for these gains only",
)


@root_locus.verification("asymptote_angles", "centroid", "real_axis_segments")
def lines_have_positive_gains(
    given: Given[CharacteristicEquation, RootLocusOptions], answers: Answers
) -> Iterable[Check]:
    """−D/N is positive on the segments and, far away, along the asymptotes; it is a power about the centroid."""
    locus = _locus(given)
    judged = {
        "asymptote_angles": ("the gain is positive far away along the asymptotes", judges.asymptote_angles_residual),
        "centroid": ("far away −D/N is a power of the distance to the centroid", judges.centroid_residual),
        "real_axis_segments": ("the gain is positive on these segments only", judges.segments_residual),
    }
    for name, (says, residual) in judged.items():
        if name in answers:
            yield Check.within(says, BY_DEFINITION, residual(locus, answers[name]), TOLERANCE, answer=name)


@root_locus.verification("breakaway_points", "breakaway_gains")
def branches_meet_there(given: Given[CharacteristicEquation, RootLocusOptions], answers: Answers) -> Iterable[Check]:
    """They are the multiple roots of D + K N for K ≥ 0, all of them, with their gains in the same order."""
    yield from _in_pairs(
        answers,
        ("breakaway_points", "breakaway_gains"),
        (
            "branches meet at these points only",
            "branches meet for these gains only",
            "the gains are those of the points",
        ),
        lambda points, gains: judges.breakaway_residual(_locus(given), points, gains),
    )


@root_locus.verification("imaginary_axis_crossings", "critical_gains")
def branches_cross_there(given: Given[CharacteristicEquation, RootLocusOptions], answers: Answers) -> Iterable[Check]:
    """They are the roots of D + K N on the boundary of stability for K > 0, all of them, with their gains."""
    locus = _locus(given)
    says_of = ON_THE_CIRCLE if locus.discrete else ON_THE_AXIS
    for name, says in zip(("imaginary_axis_crossings", "critical_gains"), says_of, strict=True):
        if name in answers:
            points, gains = (answers[name], None) if name != "critical_gains" else (None, answers[name])
            residual = judges.crossings_residual(locus, points, gains)
            yield Check.within(says, "mpmath.polyroots", residual, TOLERANCE, answer=name)


def _in_pairs(answers: Answers, names: tuple[str, str], says: tuple[str, str, str], residual: Any) -> Iterable[Check]:
    """Each by itself; where both are right, also that they belong together."""
    points, gains = (answers.get(name) for name in names)
    sizes = [
        None if points is None else residual(points, None),
        None if gains is None else residual(None, gains),
    ]
    for name, said, size in zip(names, says, sizes, strict=False):
        if size is not None:
            yield Check.within(said, "mpmath.polyroots", size, TOLERANCE, answer=name)
    if all(size is not None and size < TOLERANCE for size in sizes) and len(points or ()) == len(gains or ()):
        check = Check.within(says[2], BY_DEFINITION, residual(points, gains), TOLERANCE)
        yield replace(check, judges=(names[1],))


@root_locus.verification("departure_angles", "arrival_angles")
def branches_leave_and_arrive_so(
    given: Given[CharacteristicEquation, RootLocusOptions], answers: Answers
) -> Iterable[Check]:
    """Near a pole, and near a zero, −D/N is positive in these directions only."""
    for name, says in (
        ("departure_angles", "near the poles the gain is positive in these directions only"),
        ("arrival_angles", "near the zeros the gain is positive in these directions only"),
    ):
        if name in answers:
            residual = judges.directions_residual(_locus(given), answers[name], poles=name == "departure_angles")
            yield Check.within(says, BY_DEFINITION, residual, TOLERANCE, answer=name)
