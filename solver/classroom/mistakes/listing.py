"""The values that the usual mistakes lead to, listed: what a system that marks by itself is told beforehand."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from solver.classroom.mistakes.changed import changed_questions
from solver.classroom.mistakes.naming import careful, values_of
from solver.classroom.mistakes.values import TRANSFORMED, Case
from solver.derivation import Slip
from solver.derivation import usual_mistakes as usual

UNLISTED = (usual.INTERMEDIATE, usual.ROWS_IN_ORDER, usual.WITHOUT_A_TERM)
"""Mistakes of which there are many values, none likelier than another."""

MOST_VALUES = 3
"""Values of one mistake."""


def usual_values(case: Case) -> Iterator[tuple[Slip, Any]]:
    """Yield mistakes with the values they lead to, in the order in which marking looks for them.

    Whether marking names them is for the caller to find out: some values are right, or the same as others.
    """
    listed = [*values_of(case), *((slip, _of(values, case)) for slip, values in TRANSFORMED if slip not in UNLISTED)]
    for slip, values in listed:
        for value, _ in zip(careful(values), range(MOST_VALUES), strict=False):
            yield slip, value
    for slip, (_, answers) in changed_questions(case.part, case.earlier):
        if case.name in answers:
            yield slip, answers[case.name]


def _of(values: Any, case: Case) -> Any:
    return lambda: values(case)
