"""From a result of the engine to its work in words. What is not words, numbers or drawings stays behind."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from typing import Any

import sympy as sp

from solver.derivation import Answers, PartResult, Status, Step, Unsolved
from solver.derivation.figures import Drawing, Figure
from solver.displayed import judged
from solver.document.checks import Say, check_rows, plain_check, unchecked
from solver.document.compact import compact
from solver.document.keys import key_of
from solver.document.model import Document, Presentation, Work, WorkAnswer, WorkStep
from solver.document.questions import given, given_with, method_title, question_of, reason_in_print, source_of
from solver.document.titles import titles_of
from solver.document.values import as_written, functions_of, numbers_of, symbols_of, texts_of, values_of
from solver.engine import NOTHING_FOUND, Earlier, Findings, Solution, resolved, solve_problem
from solver.problem.asked import asked_of, marks_shown
from solver.problem.model import Display, Part, Problem
from solver.render.numbers import NumberFormat
from solver.render.plain import sympy_text
from solver.render.prose import inline_as_text, plain
from solver.render.wording import WordedStep, Wording, WordingError
from solver.special_cases import SpecialCase, special_cases
from solver.tasks import catalogue
from solver.words import Phrase, Reason


def solve_as_told(problem: Problem, told: Presentation, found: Findings = NOTHING_FOUND) -> Solution:
    """Solve a problem as far as it is to be told. Raises InputError, in the words of the presentation."""
    return solve_problem(problem, messages=told.messages(problem.display), arithmetic=told.arithmetic, found=found)


def document_of(solution: Solution, presentation: Presentation | None = None, name: str = "") -> Document:
    """Return a solution in words. A part that cannot be worded is unsolved, and says why."""
    writer = Writer(solution.problem, presentation or Presentation())
    results = {result.id: result for result in reversed(solution.parts)}
    works = [writer.work(result, results) for result in solution.parts]
    document = writer.document(works, name, lambda: {name: result.answers for name, result in results.items()})

    def told_otherwise(told: Presentation) -> Document:
        enough = solution.arithmetic or not told.arithmetic
        return document_of(solution if enough else solve_as_told(solution.problem, told), told, name)

    return replace(document, retell=told_otherwise)


LEVELS = {"question": "brief", "key": "brief"}
"""The level at which steps are worded, for levels of detail that are not one themselves."""


class Writer:
    """Words the parts of a problem one by one, and what stands around them."""

    def __init__(self, problem: Problem, presentation: Presentation) -> None:
        self.problem = problem
        self.presentation = presentation
        self.parts = {part.id: part for part in problem.parts}
        self.labels = problem.labels
        self.any_marks = any(part.marks is not None for part in problem.parts)

    @cached_property
    def titles(self) -> Mapping[str, str]:
        """The titles of the parts, which tell them apart."""
        return titles_of(self.problem, lambda part: self._wording(self._display(part, {})), self.labels)

    def document(
        self, works: Iterable[Work], name: str = "", exact: Callable[[], Mapping[str, Answers]] = dict
    ) -> Document:
        """Return the document of all parts; `name` is the problem's file, `exact` gives the exact answers."""
        problem, told = self.problem, self.presentation
        wording = self._wording(problem.display)
        shown = given(wording, problem, problem.system, problem.conditions) if problem.show.system else ""
        source = problem.source if told.sources and (problem.show.source or not told.is_paper) else ""
        asked = (work for work in works if not (told.is_paper and work.again))
        parts = tuple(each for work in asked for each in (work, *work.cases))
        texts = problem.title, source, problem.statement, shown
        return Document(*texts, parts, told, name, wording.messages, problem.images, exact)

    def load(self, part: Part) -> None:
        """Compile the wording of a part before it is needed; raises Jinja's `TemplateError`."""
        for name in ("question", *part.methods):
            self._wording(self.problem.display).load(f"{part.task}/{name}")

    def work(self, result: PartResult, earlier: Earlier) -> Work:
        """Return a result in words; `earlier` has the results that it goes on with, and may have others.

        Where a template is missing or wrong, or writes what cannot be drawn, the part is unsolved and says so.
        """
        part = self.parts[result.id]
        display = self._display(part, {**earlier, part.id: result})
        try:
            work = self._worded(result, part, display, earlier)
            return self._with_cases(work, result, part, earlier)
        except WordingError as error:
            fault = str(error)
        left = lost(result, Phrase("its solution cannot be worded: {fault}", fault=plain(fault)))
        try:
            work = self._worded(left, part, display)
        except WordingError:  # it is the question itself
            work = self._worded(left, replace(part, prompt="–", asked=()), display)
        return replace(work, fault=fault)

    def _worded(self, result: PartResult, part: Part, display: Display, earlier: Earlier | None = None) -> Work:
        """Return a result in words; what it displays is judged with the earlier results. Raises WordingError."""
        told, labels = self.presentation, self.labels
        task = catalogue()[result.task]
        wording = self._wording(display)
        asking = part, task, result.method, told, wording.say
        paper, key = told.is_paper, told.detail == "key"
        # The status of the engine says what the mathematics is worth; the one that is told, what the page displays too.
        # A key is judged with the steps that it leaves out: they say what its names stand for.
        worded = () if paper else wording.words(result.steps)
        with suppress(Unsolved):  # where nothing was found that it could go on with, there is no step either
            result = judged(result, resolved(part, earlier or {}), worded, wording)
        checks = () if paper or key else tuple(plain_check(check, wording.say) for check in result.checks)
        answers = {} if paper else result.answers
        derived: Mapping[str, str] = {}
        if key:
            answers = {name: answers[name] for name in asked_of(part, task) if name in answers}
            earning = key_of(worded, answers, task.answers, wording)
            worded, derived = earning.steps, earning.derived
        # A heading alone says nothing.
        told_of = [each for each in worded if each.markdown or each.steps or each.figures]
        shown = tuple(self._step(each, wording.say, result.steps) for each in told_of)
        work = Work(
            id=result.id,
            task=result.task,
            method=result.method,
            title=self.titles[part.id],
            method_title=method_title(*asking, self.titles[part.id]),
            source=source_of(*asking),
            marks="" if part.marks is None else NumberFormat("decimal").text(part.marks),
            question=question_of(part, task, wording, labels),
            given=given_with(part, self.problem, wording, labels) if part.show.system else "",
            again=result.method != part.methods[0],
            steps=shown,
            answers=tuple(_answers(result, part, answers, derived, wording, data=told.data)),
            equations=tuple(
                each for each in _equations(result, part, answers, derived, wording) if each.instead or not key
            ),
            rows=tuple(check_rows(checks, shown, wording.say)),
            status=result.status,
            reason=wording.reason(reason_in_print(result.reason, labels)),
            unchecked=unchecked(checks, wording.say),
            out_of=_number(part.marks) if part.marks is not None else int(not self.any_marks),
            checks=checks,
            system=texts_of(part.system) if told.data else {},
            symbols=tuple(symbols_of(result, worded)) if told.data else (),
            functions=tuple(functions_of(result)) if told.data else (),
            label=labels[result.id] if labels[result.id] != result.id else "",
        )
        return compact(work) if key else work

    def _with_cases(self, work: Work, result: PartResult, part: Part, earlier: Earlier) -> Work:
        """Return the work with the special values of parameters for which the question is to be solved anew."""
        if self.presentation.detail not in {"full", "tutor"} or work.again:
            return work
        cases, fault = special_cases(part, result, earlier, arithmetic=self.presentation.arithmetic)
        if not cases and fault is None:
            return work
        wording = self._wording(self._display(part, {part.id: result}))
        if fault is not None:
            return replace(work, status=Status.FAILED, reason=wording.reason(fault))
        holds = WorkStep("special_values", wording.special("heading"), wording.special("holds", cases))
        told = replace(work, steps=(*work.steps, holds), cases=tuple(self._case(work, case) for case in cases))
        failed = [case for case in told.cases if case.status is Status.FAILED]
        return replace(told, status=Status.FAILED, reason=failed[0].reason) if failed else told

    def _case(self, general: Work, case: SpecialCase) -> Work:
        """Return a special case in words."""
        display = self._display(case.part, {case.part.id: case.result})
        wording = self._wording(display)
        title = f"{general.title}: {inline_as_text(wording.special('title', case))}"
        task, asked = catalogue()[case.part.task], replace(case.part, prompt="")
        again = wording.given(asked.system) if task.needs else question_of(asked, task, wording, self.labels)
        return replace(
            self._worded(case.result, case.part, display),
            title=title,
            method_title=title,
            source="",
            marks="",
            out_of=0.0,
            question=wording.special("question", case),
            given=again,
            case=f"{case.parameter} = {sympy_text(case.value)}",
        )

    def _wording(self, display: Display) -> Wording:
        told = self.presentation
        messages = told.messages(display)
        asked_for = replace(display, language=messages.language, notation=messages.notation)
        return Wording.of(asked_for, LEVELS.get(told.detail, told.detail), told.templates)

    def _display(self, part: Part, results: Earlier) -> Display:
        """How numbers are shown: in decimals where some are typed in the part, found, or taken from an earlier part."""
        found = (results[name].answers.values() for name in (*part.sources, part.id) if name in results)
        decimals = part.decimals_typed or any(_holds_decimals(value) for values in found for value in values)
        return replace(self.problem.display, decimals_typed=decimals)

    def _step(self, worded: WordedStep, say: Say, all_steps: Sequence[Step] = ()) -> WorkStep:
        values = values_of(worded.step) if self.presentation.data else {}
        place = all_steps.index(worded.step) + 1 if worded.step in all_steps else 0
        return WorkStep(
            worded.step.kind,
            worded.title,
            worded.markdown,
            tuple(self._step(each, say) for each in worded.steps),
            tuple(_drawing(each, say) for each in worded.figures),
            {name: sympy_text(value) for name, value in values.items()},
            covers=(place,) if place else (),
        )


def _drawing(figure: Figure, say: Say) -> Drawing:
    """Return a figure without expressions, and what is seen in it in words."""
    from solver.figures.drawing import drawing_of  # noqa: PLC0415 - numpy comes with it; most steps have no figure

    return drawing_of(figure, say)


def lost(result: PartResult, reason: str) -> PartResult:
    """Return what is left of a result that cannot be worded or sent: no steps, answers and checks, but the reason."""
    ended = Reason("limits/ended", {"words": reason})
    return PartResult(result.id, result.task, result.method, Status.UNSOLVED, reason=ended, seconds=result.seconds)


def _answers(
    result: PartResult,
    part: Part,
    answers: Mapping[str, Any],
    derived: Mapping[str, str],
    wording: Wording,
    *,
    data: bool,
) -> Iterator[WorkAnswer]:
    task = catalogue()[result.task]
    marks, asked = marks_shown(part, task, result.answers), asked_of(part, task)
    for name, value in answers.items():
        declared = task.answers[name]
        symbol = wording.symbol(declared)
        yield WorkAnswer(
            name,
            symbol,
            wording.answer(value),
            wording.say(declared.doc),
            as_written(value) if data else "",
            wording.equation(symbol, value, zero=declared.zero),
            wording.equation(symbol, value, narrow=True, zero=declared.zero),
            marks=_marks(marks[name]) if name in marks else "",
            numeric=numbers_of(value) if data else None,
            asked=name in asked,
            given=name not in part.asked and name in part.options and bool(part.options[name] == value),
            derived=derived.get(name, ""),
            told=declared.told,
        )


def _equations(
    result: PartResult, part: Part, answers: Mapping[str, Any], derived: Mapping[str, str], wording: Wording
) -> Iterator[WorkAnswer]:
    """Yield the answers that are told as equations: where all of them are told, and none has a line of its own."""
    task = catalogue()[result.task]
    marks = marks_shown(part, task, result.answers)
    for each in task.equations:
        found = {name: result.answers[name] for name in each.answers if name in result.answers}
        if not found or not found.keys() <= answers.keys() - derived.keys():
            continue
        moved = next(
            (step.values["following"] for step in result.steps if step.kind == "functions" and "f" in found), None
        )
        discrete = part.system.discrete or any(task.answers[name].discrete for name in found)
        tex = wording.equations(each, found, discrete=discrete, moved=moved)
        narrow = wording.equations(each, found, discrete=discrete, moved=moved, narrow=True) or tex
        earned = sum(marks.get(name, Fraction(0)) for name in each.instead if name in found)
        told = _marks(earned) if earned else ""
        if tex:
            yield WorkAnswer("", "", tex, wording.say(each.doc), "", tex, narrow, marks=told, instead=each.instead)


def _marks(marks: Fraction | int) -> str:
    return NumberFormat("decimal", 8).text(sp.Rational(marks))


def _number(marks: Any) -> float:
    return int(marks) if marks.is_Integer else float(marks)


def _holds_decimals(value: Any) -> bool:
    if isinstance(value, list | tuple):
        return any(map(_holds_decimals, value))
    return bool(getattr(value, "atoms", lambda _: ())(sp.Float))
