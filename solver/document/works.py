"""From a result of the engine to its work in words. What is not words, numbers or drawings stays behind."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

import sympy as sp

from solver.derivation import Answers, Check, Method, PartResult, Status, Step, Task, Unsolved
from solver.derivation.figures import Drawing, Figure
from solver.displayed import judged
from solver.document.checks import Say, check_rows, unchecked, worded_check
from solver.document.model import Document, Presentation, Work, WorkAnswer, WorkStep
from solver.document.values import numbers_of, symbols_of, texts_of, values_of
from solver.engine import Earlier, Solution, resolved
from solver.problem.asked import asked_of, marks_of
from solver.problem.model import Chain, Display, Part, Problem
from solver.render.numbers import NumberFormat
from solver.render.plain import sympy_text
from solver.render.prose import plain
from solver.render.wording import WordedStep, Wording, WordingError
from solver.systems import System
from solver.tasks import catalogue
from solver.words import Phrase, Reason


def document_of(solution: Solution, presentation: Presentation | None = None, name: str = "") -> Document:
    """Return a solution in words. A part that cannot be worded is unsolved, and says why."""
    writer = Writer(solution.problem, presentation or Presentation())
    results = {result.id: result for result in reversed(solution.parts)}
    works = [writer.work(result, results) for result in solution.parts]
    document = writer.document(works, name, lambda: {name: result.answers for name, result in results.items()})
    return replace(document, retell=lambda told: document_of(solution, told, name))


LEVELS = {"question": "brief", "key": "brief"}
"""The level at which steps are worded, for levels of detail that are not one themselves."""


class Writer:
    """Words the parts of a problem one by one, and what stands around them."""

    def __init__(self, problem: Problem, presentation: Presentation) -> None:
        self.problem = problem
        self.presentation = presentation
        self.parts = {part.id: part for part in problem.parts}
        self.any_marks = any(part.marks is not None for part in problem.parts)

    def document(
        self, works: Iterable[Work], name: str = "", exact: Callable[[], Mapping[str, Answers]] = dict
    ) -> Document:
        """Return the document of all parts; `name` is the problem's file, `exact` gives the exact answers."""
        problem, told = self.problem, self.presentation
        wording = self._wording(problem.display)
        given = _given(wording, problem, problem.system, problem.conditions) if problem.show.system else ""
        source = problem.source if told.sources and (problem.show.source or not told.is_paper) else ""
        parts = tuple(work for work in works if not (told.is_paper and work.again))
        texts = problem.title, source, problem.statement, given
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
            return self._worded(result, part, display, earlier)
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
        told, show = self.presentation, part.show
        task = catalogue()[result.task]
        method = task.method_named(result.method, part.options)
        wording = self._wording(display)
        steps, answers, checks = _shown(result, part, told)
        worded = wording.words(steps)
        # The status of the engine says what the mathematics is worth; the one that is told, what the page displays too.
        # A key is judged with the steps that it leaves out: they say what its names stand for.
        read = wording.words(result.steps) if told.detail == "key" else worded
        with suppress(Unsolved):  # where nothing was found that it could go on with, there is no step either
            result = judged(result, resolved(part, earlier or {}), read, wording)
        checks = result.checks if checks else ()
        asked = [task.answers[name] for name in part.asked]
        return Work(
            id=result.id,
            task=result.task,
            method=result.method,
            title=wording.say(task.title),
            method_title=_method_title(task, part, method, told, wording.say),
            source=wording.say(method.source) if told.sources and (show.source or not told.is_paper) else "",
            marks="" if part.marks is None else NumberFormat("decimal").text(part.marks),
            question=wording.question(part, loops=_loops(task, part), asked=asked),
            given=self._given_by(part, wording) if show.system else "",
            again=result.method != part.methods[0],
            steps=tuple(map(self._step, worded)),
            answers=tuple(_answers(result, part, answers, wording, data=told.data)),
            rows=tuple(check_rows(result, wording.say)) if checks else (),
            status=result.status,
            reason=wording.reason(result.reason),
            unchecked=unchecked(checks, wording.say),
            out_of=_number(part.marks) if part.marks is not None else int(not self.any_marks),
            checks=tuple(worded_check(check, wording.say) for check in checks),
            system=texts_of(part.system) if told.data else {},
            symbols=tuple(symbols_of(result, worded)) if told.data else (),
        )

    def _given_by(self, part: Part, wording: Wording) -> str:
        """Return what a part gives: its own system and assumptions, and the conditions that it adds."""
        told = {chain.place for chain in self.problem.conditions}
        own = [chain for chain in part.conditions if chain.place not in told]
        return _given(wording, part, part.system if part.own_system else None, own)

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

    def _step(self, worded: WordedStep) -> WorkStep:
        values = values_of(worded.step) if self.presentation.data else {}
        return WorkStep(
            worded.step.kind,
            worded.title,
            worded.markdown,
            tuple(map(self._step, worded.steps)),
            tuple(map(_drawing, worded.figures)),
            {name: sympy_text(value) for name, value in values.items()},
        )


def _given(wording: Wording, of: Problem | Part, system: System | None, conditions: Sequence[Chain]) -> str:
    """Return what is given about a system, if there is one, and about the parameters."""
    told = [wording.given(system) if system is not None else "", wording.conditions(of.assumed, conditions)]
    return "\n\n".join(filter(None, told))


def _drawing(figure: Figure) -> Drawing:
    """Return a figure without expressions."""
    from solver.figures.sampling import drawing_of  # noqa: PLC0415 - numpy comes with it; most steps have no figure

    return drawing_of(figure)


def lost(result: PartResult, reason: str) -> PartResult:
    """Return what is left of a result that cannot be worded or sent: no steps, answers and checks, but the reason."""
    ended = Reason("limits/ended", {"words": reason})
    return PartResult(result.id, result.task, result.method, Status.UNSOLVED, reason=ended, seconds=result.seconds)


def _loops(task: Task[Any, Any], part: Part) -> list[str]:
    """Return the lemmas that close a loop around the system, for the options that are given."""
    given = (option.loop for name, option in task.options.items() if part.options.get(name) is not None)
    return list(dict.fromkeys(loop for loop in given if loop))


def _method_title(task: Task[Any, Any], part: Part, method: Method, told: Presentation, say: Say) -> str:
    """Return the title of the method; on a paper those of all that are asked for, if they may be said."""
    if not told.is_paper:
        return say(method.title)
    titles = dict.fromkeys(say(task.method_named(name, part.options).title) for name in part.methods)
    return ", ".join(titles) if part.show.method else ""


def _shown(
    result: PartResult, part: Part, told: Presentation
) -> tuple[tuple[Step, ...], Mapping[str, Any], tuple[Check, ...]]:
    """Return the steps, the answers and the checks that are told at the level of detail.

    A question is asked and no more. A key has the answers that are asked, and the steps in which they are found.
    """
    if told.is_paper:
        return (), {}, ()
    if told.detail != "key":
        return result.steps, result.answers, result.checks
    asked = asked_of(part, catalogue()[part.task])
    answers = {name: value for name, value in result.answers.items() if name in asked}
    found = [step for step in result.steps if any(_finds(step, value) for value in answers.values())]
    return tuple(map(_alone, found or result.steps[-1:])), answers, ()


def _finds(step: Step, value: Any) -> bool:
    """Whether a step shows a value as something that was found."""
    return any(each.right is value or each.right == value for each in step.claims.values())


def _alone(step: Step) -> Step:
    """Return a step without those below it."""
    alone = Step(step.kind, claims=step.claims, unclaimed=step.unclaimed, **step.values)
    alone.wording = step.wording
    return alone


def _answers(
    result: PartResult, part: Part, answers: Mapping[str, Any], wording: Wording, *, data: bool
) -> Iterator[WorkAnswer]:
    declared = catalogue()[result.task].answers
    marks = marks_of(part, catalogue()[result.task])
    for name, value in answers.items():
        symbol = wording.symbol(declared[name])
        yield WorkAnswer(
            name,
            symbol,
            wording.answer(value),
            wording.say(declared[name].doc),
            sympy_text(value) if data else "",
            wording.equation(symbol, value),
            wording.equation(symbol, value, narrow=True),
            marks=NumberFormat("decimal", 3).text(marks[name]) if name in marks else "",
            numeric=numbers_of(value) if data else None,
            given=name not in part.asked and name in part.options and bool(part.options[name] == value),
        )


def _number(marks: Any) -> float:
    return int(marks) if marks.is_Integer else float(marks)


def _holds_decimals(value: Any) -> bool:
    if isinstance(value, list | tuple):
        return any(map(_holds_decimals, value))
    return bool(getattr(value, "atoms", lambda _: ())(sp.Float))


__all__ = ["Writer", "document_of", "lost"]
