"""Does a polynomial in z have all its roots inside the unit circle? Jury's table, or Routh's array in the w-plane."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Derivation, Given, Step, Task
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.numeric.judges import digital as judges
from solver.numeric.judges import stability
from solver.tasks.digital import jury_mistakes
from solver.tasks.digital.jury_table import comparisons_of, necessary_conditions, products_of, table_of
from solver.tasks.digital.w_plane import by_the_image_in_w
from solver.tasks.stability.counterexamples import condition_check
from solver.tasks.stability.criterion import (
    CriterionOptions,
    companion,
    condition_of,
    has_no_such_parameter,
    has_numbers,
    has_parameters,
    positive_lead,
)

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import Polynomial

jury: Task[Polynomial, CriterionOptions] = Task(
    "jury",
    title="Jury's criterion",
    doc="Roots of a characteristic polynomial in z inside and outside the unit circle, without finding them.",
    needs=("polynomial",),
    options=CriterionOptions,
    answers=[
        AnswerName(
            "array",
            r"\text{array}",
            "the table (by the bilinear map: the Routh array), shorter rows filled up with zeros",
            principal=True,
            earned=("table", "array"),
            any_size=True,
        ),
        AnswerName(
            "stable",
            r"\text{stable}",
            "whether all roots lie inside the unit circle",
            optional=True,
            principal=has_numbers,
            earned=("necessary", "table", "array", "comparisons", "sign_changes"),
        ),
        AnswerName(
            "condition",
            r"\text{condition}",
            "where all roots lie inside the unit circle, a condition on the parameters",
            optional=True,
            principal=has_parameters,
            earned=("table", "array", "condition"),
        ),
        AnswerName(
            "unstable_poles",
            r"n_{\text{out}}",
            "the number of roots outside the unit circle",
            optional=True,
            count=True,
            earned=("products", "sign_changes"),
        ),
    ],
    example={"time": "discrete", "polynomial": "z^3 - 1.2z^2 + 0.5z - 0.1"},
)
jury.refusal(has_no_such_parameter)
jury_mistakes.register(jury)


@jury.method("jury", title="Jury's table", source="Ogata, Discrete-Time Control Systems, §4–3", time="discrete")
def by_the_table(given: Given[Polynomial, CriterionOptions]) -> Derivation[Answers]:
    """p(1) > 0, (−1)ⁿ p(−1) > 0, |a₀| < aₙ, and in each further row the first entry outweighs the last."""
    z = given.system.variable
    coefficients = yield from positive_lead(given.system)
    yield from necessary_conditions(coefficients, z)
    positive = exact.jury_conditions(coefficients).positive
    signs = [exact.sign_of(each) for each in positive]
    stable = False if {0, -1} & {*signs} else None if None in signs else True
    counts = exact.disc_counts(coefficients) if stable is False else None
    counted = counts is not None and counts.counts is not None
    table = yield from table_of(coefficients, z, whole=counted and _counts(coefficients))
    yield from comparisons_of(table)
    answers = Answers(array=table.matrix)
    if stable:
        answers.update((yield from _verdict(coefficients, 0, 0)))
    elif counted:
        answers.update((yield from _counted(coefficients, table, given)))
    answers.update((yield from condition_of(given, positive, of="inequalities", special=False)))
    return answers


def _counts(coefficients: Sequence[Expr]) -> bool:
    """Whether the first column of the table counts the roots: it has no zero."""
    return exact.inside_by_jury(exact.jury_table(coefficients, whole=True)) is not None


def _counted(
    coefficients: Sequence[Expr], table: exact.JuryTable, given: Given[Polynomial, CriterionOptions]
) -> Derivation[dict[str, Any]]:
    """The roots outside: by the signs of the first column, or by the w-plane where there is a zero in it."""
    if len(table.rows[-1].entries) == 1:
        inside = yield from products_of(table)
        return (yield from _verdict(coefficients, len(coefficients) - 1 - inside, 0))
    whole = exact.jury_table(coefficients, whole=True)
    at = next(i for i, row in enumerate(whole.rows) if i and exact.sign_of(row.entries[0]) == 0)
    yield Step("singular", unclaimed="it is seen in the table", row=at, zeros=not any(whole.rows[at].entries))
    found = yield from by_the_image_in_w(coefficients, given.system.variable)
    assert found.counts.outside is not None and found.counts.on is not None  # noqa: S101, PT018 - signs are known
    return (yield from _verdict(coefficients, found.counts.outside, found.counts.on))


def _verdict(coefficients: Sequence[Expr], outside: int, on: int) -> Derivation[dict[str, Any]]:
    """How many roots lie where."""
    inside, stable = len(coefficients) - 1 - outside - on, not outside and not on
    yield Step("verdict", unclaimed="a consequence of the count; the answers have checks of their own", stable=stable,
               outside=outside, on=on, inside=inside)  # fmt: skip
    return {"stable": stable, "unstable_poles": sp.Integer(outside)}


@jury.method(
    "bilinear", title="Bilinear map and Routh array", source="Kuo, Digital Control Systems, §5", time="discrete"
)
def by_the_bilinear_map(given: Given[Polynomial, CriterionOptions]) -> Derivation[Answers]:
    """With z = (1 + w)/(1 − w) the inside of the unit circle is the left half plane of w."""
    coefficients = yield from positive_lead(given.system)
    found = yield from by_the_image_in_w(coefficients, given.system.variable)
    answers = Answers()
    answers["array"] = sp.ImmutableMatrix([[found.counts.image[0]]]) if found.array is None else found.array.matrix
    if found.counts.outside is not None and found.counts.on is not None:
        answers.update((yield from _verdict(coefficients, found.counts.outside, found.counts.on)))
    rows = () if found.array is None else found.array.rows
    special = found.minus_ones > 0 or any(row.special for row in rows)
    first = [row.computed[0] for row in rows]
    answers.update((yield from condition_of(given, first, of="first_column", special=special)))
    return answers


BY_ROOTS = "numpy.linalg.eigvals of the companion matrix; on the circle with 100 digits"


@jury.verification("stable", "unstable_poles")
def are_counted_by_numbers(given: Given[Polynomial, CriterionOptions], answers: Answers) -> Iterable[Check]:
    """The roots themselves, at several values of the parameters."""
    found = stability.locations(companion(given.system), discrete=True)
    if "stable" in answers:
        truths = {not each.outside and not each.on for each in found}
        yield Check.that("whether all roots lie inside the unit circle", BY_ROOTS, truths == {bool(answers["stable"])},
                         answer="stable")  # fmt: skip
    if "unstable_poles" in answers:
        numbers = {each.outside for each in found}
        yield Check.that("the number of roots outside the unit circle", BY_ROOTS,
                         bool(numbers == {answers["unstable_poles"]}), answer="unstable_poles")  # fmt: skip


@jury.verification("array")
def follows_row_by_row(given: Given[Polynomial, CriterionOptions], answers: Answers) -> Iterable[Check]:
    """Each row from the one above it, up to a factor; Routh's array of the image in w from the two above."""
    fault = judges.table_fault(companion(given.system), answers["array"], given.method)
    yield replace(Check.that("each row follows from those above it", "mpmath", not fault), reason=fault)


@jury.verification("condition")
def holds_where_the_roots_say(given: Given[Polynomial, CriterionOptions], answers: Answers) -> Iterable[Check]:
    """At points on both sides of every edge, and at random ones, the condition is true if and only if p is stable."""
    says = "the condition holds exactly where all roots lie inside the unit circle"
    yield condition_check(companion(given.system), answers["condition"], says, discrete=True)
