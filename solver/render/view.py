"""What every format shows of a solution, built once: texts as Markdown with `$math$`, formulas as LaTeX.

A view holds no layout. `page`, `latex_document`, `markdown` and the terminal each lay out the same view, so that no
format can say more, or something else, than another.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Check, CheckStatus, PartResult, Status
from solver.render.numbers import NumberFormat
from solver.render.wording import WordedStep, Wording
from solver.tasks import catalogue

if TYPE_CHECKING:
    from solver.engine import Solution
    from solver.problem.model import Part


@dataclass(frozen=True, slots=True)
class AnswerView:
    """One answer: its name, LaTeX of its symbol and value (no dollar signs), its meaning, and the exact object.

    `equation` is LaTeX of symbol = value laid out for a page: broken over lines, or entry by entry, where it is wide.
    `narrow` is the same entry by entry in any case.
    """

    name: str
    symbol: str
    tex: str
    doc: str
    value: Any
    equation: str
    narrow: str = ""


@dataclass(frozen=True, slots=True)
class CheckRow:
    """One line of the table of checks: `claim`, `oracle`, `reason` are Markdown, numbers LaTeX or "" for none.

    The equalities of one step are one line: `residual` and `tolerance` are then those nearest to failing.
    """

    claim: str
    oracle: str
    residual: str
    tolerance: str
    status: CheckStatus
    reason: str = ""


@dataclass(frozen=True, slots=True)
class PartView:
    """One part by one method.

    `question` and `given` (Markdown) are empty where the same part stands above with another method
    (`again` is then True). `marks` is a number as text, or "". `reason` (Markdown) says why a part is not verified.
    """

    id: str
    task: str
    method: str
    title: str
    method_title: str
    source: str
    marks: str
    question: str
    given: str
    again: bool
    steps: tuple[WordedStep, ...]
    answers: tuple[AnswerView, ...]
    checks: tuple[CheckRow, ...]
    status: Status
    reason: str

    @property
    def unchecked(self) -> str:
        """How many checks could not be made, and why (Markdown); empty where all were made."""
        skipped = [check.reason for check in self.checks if check.status is CheckStatus.SKIPPED]
        return f"{len(skipped)} could not be checked: {'; '.join(dict.fromkeys(skipped))}" if skipped else ""

    @property
    def anchor(self) -> str:
        """A name for links to the part, unique on the page: letters, digits and hyphens."""
        words = f"part-{self.id}-{self.method}".replace("_", "-").lower()
        return "".join(letter for letter in words if letter.isascii() and (letter.isalnum() or letter == "-"))


@dataclass(frozen=True, slots=True)
class SolutionView:
    """A whole solution. `title` and `source` are plain text; `statement` and `given` are Markdown, maybe empty."""

    title: str
    source: str
    statement: str
    given: str
    parts: tuple[PartView, ...]
    status: Status

    @property
    def illustrated(self) -> bool:
        """Whether any step that is shown has a figure."""
        return any(each.step.figures for part in self.parts for step in part.steps for each in step.walk())


def view_of(solution: Solution, wording: Wording | None = None) -> SolutionView:
    """Word and print a solution; without a wording, the installed one at the level "full".

    Raises `WordingError` where a template is missing or wrong.
    """
    problem = solution.problem
    wording = wording or Wording.of(solution.display)
    by_id = {part.id: part for part in problem.parts}
    seen: set[str] = set()
    parts = []
    for result in solution.parts:
        parts.append(_part(result, by_id[result.id], result.id in seen, wording))
        seen.add(result.id)
    given = wording.given(problem.system) if problem.system is not None else ""
    return SolutionView(problem.title, problem.source, problem.statement, given, tuple(parts), solution.status)


def _part(result: PartResult, part: Part, again: bool, wording: Wording) -> PartView:
    task = catalogue()[result.task]
    method = task.methods[result.method]
    steps = wording.words(result.steps)
    return PartView(
        id=result.id,
        task=result.task,
        method=result.method,
        title=task.title,
        method_title=method.title,
        source=method.source,
        marks="" if part.marks is None else NumberFormat("decimal").text(part.marks),
        question="" if again else wording.question(part, closed=task.closes_the_loop and "gain" in part.options),
        given=wording.given(part.system) if part.own_system and not again else "",
        again=again,
        steps=steps,
        answers=tuple(_answers(result, wording)),
        checks=tuple(check_rows(result)),
        status=result.status,
        reason=wording.reason(result.reason),
    )


def _answers(result: PartResult, wording: Wording) -> list[AnswerView]:
    declared = catalogue()[result.task].answers
    views = []
    for name, value in result.answers.items():
        symbol = wording.symbol(declared[name])
        equation, narrow = wording.equation(symbol, value), wording.equation(symbol, value, narrow=True)
        views.append(AnswerView(name, symbol, wording.answer(value), declared[name].doc, value, equation, narrow))
    return views


def check_rows(result: PartResult) -> list[CheckRow]:
    """Return the table of checks: one line for the equalities of each step, then one for each other check."""
    rows = []
    for number in range(1, len(result.steps) + 1):
        rows.extend(_of_step([check for check in result.checks if check.step == number], number))
    return rows + [_row(check) for check in result.checks if not check.step]


def _of_step(checks: list[Check], number: int) -> list[CheckRow]:
    """Return one line for the equalities of a step that passed, then one for each that did not."""
    passed = [check for check in checks if check.status is CheckStatus.PASSED]
    others = [_row(check) for check in checks if check.status is not CheckStatus.PASSED]
    if not passed:
        return others
    worst = max(passed, key=_nearness)
    claim = f"{len(passed)} equalities of step {number}" if len(passed) > 1 else f"the equality of step {number}"
    if len(passed) == 1 and worst.claim:
        claim = f"{worst.claim} (step {number})"
    oracle = ", ".join(dict.fromkeys(check.oracle for check in passed))
    return [CheckRow(claim, oracle, _short(worst.residual), _short(worst.tolerance), CheckStatus.PASSED), *others]


def _nearness(check: Check) -> float:
    """Residual as a part of the tolerance."""
    if check.residual is None or not check.tolerance:
        return 0.0
    return check.residual / check.tolerance


def _row(check: Check) -> CheckRow:
    return CheckRow(
        check.claim, check.oracle, _short(check.residual), _short(check.tolerance), check.status, check.reason
    )


def _short(number: float | None) -> str:
    """Two significant digits are enough for an error."""
    return "" if number is None else NumberFormat("decimal", 2).decimal(number)
