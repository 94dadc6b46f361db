"""How many roots of a polynomial lie in the right half plane: the Routh array, Hurwitz's determinants."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.arithmetic.determinants import leading_minors
from solver.derivation import AnswerName, Answers, Attempt, Check, Claim, Derivation, Given, Step, Task
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import stability as judges
from solver.stated.matrices import determinant
from solver.tasks import consequences
from solver.tasks.form_meanings import routh_entry
from solver.tasks.stability.counterexamples import condition_check, counterexample
from solver.tasks.stability.criterion import (
    CriterionOptions,
    companion,
    condition_of,
    has_no_such_parameter,
    has_numbers,
    has_parameters,
    polynomial_of,
    positive_lead,
    symmetric_roots,
)
from solver.tasks.stability.routh_array import rows_of
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import Polynomial


routh_hurwitz: Task[Polynomial, CriterionOptions] = Task(
    "routh_hurwitz",
    title="Routh–Hurwitz criterion",
    doc="Roots of a characteristic polynomial in the right half plane and on the imaginary axis, without finding them.",
    needs=("polynomial",),
    options=CriterionOptions,
    answers=[
        AnswerName(
            "array",
            r"\text{array}",
            "the Routh array, shorter rows filled up with zeros",
            ("array",),
            principal=True,
            earned=("array",),
        ),
        AnswerName(
            "determinants",
            r"\Delta_k",
            "Hurwitz's determinants",
            ("hurwitz_determinants",),
            principal=True,
            ordered=True,
            earned=("minors",),
        ),
        AnswerName(
            "right_half_plane_roots",
            r"n_{+}",
            "the number of roots with positive real part",
            optional=True,
            principal=has_numbers,
            count=True,
            earned=("zero_pivot", "zero_row", "array", "sign_changes", "ratios", "verdict"),
        ),
        AnswerName(
            "imaginary_axis_roots", r"n_{0}", "the number of roots on the imaginary axis", optional=True, count=True
        ),
        AnswerName(
            "stable",
            r"\text{stable}",
            "whether all roots lie in the open left half plane",
            optional=True,
            earned=("array", "minors", "sign_changes", "ratios"),
        ),
        AnswerName(
            "condition",
            r"\text{condition}",
            "where all roots lie in the open left half plane, a condition on the parameters",
            optional=True,
            principal=has_parameters,
            earned=("array", "minors", "condition"),
        ),
    ],
)


routh_hurwitz.refusal(has_no_such_parameter)


@routh_hurwitz.method(
    "array", title="Routh array", source="Gantmacher, The Theory of Matrices II, XV §§3–4", time="continuous"
)
def by_array(given: Given[Polynomial, CriterionOptions]) -> Derivation[Answers]:
    """As many roots in the right half plane as changes of sign in the first column."""
    x = given.system.variable
    coefficients = yield from positive_lead(given.system)
    array = yield from rows_of(exact.routh(coefficients), x)
    signs = [exact.sign_of(entry) for entry in array.at_zero]
    answers = Answers(array=array.matrix)
    counts = None if None in signs else exact.root_counts(coefficients)
    if counts is not None:
        changes = exact.sign_changes(signs)
        yield Step(
            "sign_changes",
            unclaimed="counted; the number has a check of its own",
            column=list(zip([row.entries[0] for row in array.rows], signs, strict=True)),
            epsilon=array.epsilon,
            changes=changes,
            trusted=changes == counts.outside,
        )
        answers.update((yield from _counted(coefficients, x, counts)))
    first = [row.computed[0] for row in array.rows]
    answers.update(
        (yield from condition_of(given, first, of="first_column", special=any(row.special for row in array.rows)))
    )
    return answers


@routh_hurwitz.method(
    "hurwitz_determinants",
    title="Hurwitz's determinants",
    source="Gantmacher, The Theory of Matrices II, XV §6",
    time="continuous",
)
def by_determinants(given: Given[Polynomial, CriterionOptions]) -> Derivation[Answers]:
    """Stable if and only if all leading minors of the Hurwitz matrix are positive."""
    x = given.system.variable
    coefficients = yield from positive_lead(given.system)
    H = exact.hurwitz_matrix(coefficients)
    yield Step("matrix", unclaimed="the coefficients, written row by row", H=H, x=x, p=polynomial_of(coefficients, x))
    minors = [sp.ImmutableMatrix(H[:k, :k]) for k in range(1, H.rows + 1)]
    values = [exact.determinant(M) for M in minors]
    claims = {
        f"minor{k}": Claim(determinant(M), value, f"$\\Delta_{k}$")
        for k, (M, value) in enumerate(zip(minors, values, strict=True), 1)
    }
    yield Step("minors", claims=claims, steps=leading_minors(minors, values))
    answers = Answers(determinants=values)
    signs = [exact.sign_of(value) for value in (coefficients[0], *values)]
    counts = None if None in signs else exact.root_counts(coefficients)
    if counts is not None:
        yield Step(
            "ratios",
            unclaimed="counted; the number has a check of its own",
            singular=0 in signs,
            stable=all(sign == 1 for sign in signs),
            outside=counts.outside,
        )
        answers.update((yield from _counted(coefficients, x, counts)))
    answers.update(
        (
            yield from condition_of(
                given, [coefficients[0], *values], of="determinants", special=any(v == 0 for v in values)
            )
        )
    )
    return answers


def _counted(coefficients: Sequence[Expr], x: Symbol, counts: exact.RootCounts) -> Derivation[dict[str, Any]]:
    """Where the roots lie; those that lie symmetrically to the origin are the roots of a factor of their own."""
    n = len(coefficients) - 1
    yield from symmetric_roots(coefficients, x, counts)
    stable = not counts.outside and not counts.on
    yield Step("verdict", unclaimed="a consequence of the count; the answers have checks of their own", stable=stable,
               outside=counts.outside, on=counts.on, inside=n - counts.outside - counts.on)  # fmt: skip
    return {
        "right_half_plane_roots": sp.Integer(counts.outside),
        "imaginary_axis_roots": sp.Integer(counts.on),
        "stable": stable,
    }


BY_ROOTS = "numpy.linalg.eigvals of the companion matrix; on the axis with 100 digits"


@routh_hurwitz.verification("right_half_plane_roots", "imaginary_axis_roots", "stable")
def are_counted_by_numbers(given: Given[Polynomial, CriterionOptions], answers: Answers) -> Iterable[Check]:
    """The roots themselves, at several values of the parameters."""
    found = judges.locations(companion(given.system), discrete=False)
    counts = {
        "right_half_plane_roots": {each.outside for each in found},
        "imaginary_axis_roots": {each.on for each in found},
        "stable": {not each.outside and not each.on for each in found},
    }
    labels = {
        "right_half_plane_roots": "the number of roots in the right half plane",
        "imaginary_axis_roots": "the number of roots on the imaginary axis",
        "stable": "whether all roots lie in the left half plane",
    }
    for name, values in counts.items():
        if name in answers:
            own = bool(answers[name]) if name == "stable" else answers[name]
            yield Check.that(labels[name], BY_ROOTS, bool(values == {own}), answer=name)


@routh_hurwitz.verification("array")
def follows_row_by_row(given: Given[Polynomial, CriterionOptions], answers: Answers) -> Iterable[Check]:
    """The first rows from the coefficients, each further row from the two above it."""
    fault = judges.routh_fault(companion(given.system), answers["array"], discrete=False)
    yield replace(Check.that("each row follows from the two above it", "mpmath", not fault), reason=fault)


@routh_hurwitz.verification("determinants")
def are_the_minors(given: Given[Polynomial, CriterionOptions], answers: Answers) -> Iterable[Check]:
    """Each is the determinant of a leading block, whose entry in row i, column j is a_{2j − i}, with a₀ > 0."""
    c, n = given.system.coefficients, given.system.degree
    a = [each * (1 if c[0].is_positive else -1 if c[0].is_negative else 1 / c[0]) for each in c]
    found = list(answers["determinants"])
    yield Check.that(Phrase("there are {n} determinants", n=n), "counted", len(found) == n)
    for k, value in enumerate(found[:n], 1):
        rows = [[a[2 * j - i] if 0 <= 2 * j - i <= n else 0 for j in range(1, k + 1)] for i in range(1, k + 1)]
        yield numeric.check_claim(Claim(determinant(sp.ImmutableMatrix(rows)), value), f"$\\Delta_{{{k}}}$")


@routh_hurwitz.verification("condition")
def holds_where_the_roots_say(given: Given[Polynomial, CriterionOptions], answers: Answers) -> Iterable[Check]:
    """At points on both sides of every edge, and at random ones, the condition is true if and only if p is stable."""
    says = "the condition holds exactly where all roots lie in the left half plane"
    yield condition_check(companion(given.system), answers["condition"], says, discrete=False)


routh_hurwitz.consequence("right_half_plane_roots", of=("array",), symbolic=False)(consequences.sign_changes)


@routh_hurwitz.consequence("stable", of=("right_half_plane_roots", "imaginary_axis_roots"), symbolic=False)
def none_outside(_given: Given[Polynomial, CriterionOptions], found: Mapping[str, Any]) -> Any:
    """No root in the right half plane or on the axis."""
    return bool(found["right_half_plane_roots"] == found["imaginary_axis_roots"] == 0)


@routh_hurwitz.meaning("array")
def first_wrong_entry(wrong: Attempt[Polynomial, CriterionOptions]) -> Reason | None:
    """The first entry that does not follow from the coefficients, or from the rows above it."""
    return routh_entry(wrong.given.system.coefficients, wrong.value)


@routh_hurwitz.meaning("condition")
def where_it_is_wrong(wrong: Attempt[Polynomial, CriterionOptions]) -> Reason | None:
    """Values of the parameters at which the condition is wrong."""
    return counterexample(companion(wrong.given.system), wrong.value, discrete=False)
