"""From a result of the engine to its work in words. What is not words, numbers or drawings stays behind."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from solver.derivation import Answers, PartResult, Status, Step, Task
from solver.document.checks import check_rows, unchecked, worded_check
from solver.document.model import Document, Presentation, Work, WorkAnswer, WorkStep
from solver.engine import Earlier, Solution
from solver.figures.sampling import drawing_of
from solver.problem.model import Display, Part, Problem
from solver.render.numbers import NumberFormat
from solver.render.plain import sympy_text
from solver.render.prose import plain
from solver.render.wording import WordedStep, Wording, WordingError
from solver.stated import Stated
from solver.tasks import catalogue
from solver.words import Reason

KNOWN = frozenset({"s", "z", "t", "k", "lamda"})
"""Names whose meaning is fixed; they are not listed among the symbols."""


def document_of(solution: Solution, presentation: Presentation | None = None, name: str = "") -> Document:
    """Return a solution in words. A part that cannot be worded is unsolved, and says why."""
    writer = Writer(solution.problem, presentation or Presentation())
    results = {result.id: result for result in reversed(solution.parts)}
    works = [writer.work(result, results) for result in solution.parts]
    document = writer.document(works, name, lambda: {name: result.answers for name, result in results.items()})
    return replace(document, retell=lambda told: document_of(solution, told, name))


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
        given = wording.given(problem.system) if problem.system is not None else ""
        texts = problem.title, problem.source, problem.statement, given
        return Document(*texts, tuple(works), told, name, wording.messages, exact)

    def load(self, part: Part) -> None:
        """Compile the wording of a part before it is needed; raises Jinja's `TemplateError`."""
        for name in ("question", *part.methods):
            self._wording(self.problem.display).load(f"{part.task}/{name}")

    def work(self, result: PartResult, earlier: Earlier) -> Work:
        """Return a result in words; `earlier` has the results that it goes on with, and may have others.

        Where a template is missing or wrong, or writes what cannot be drawn, the part is unsolved and says so.
        """
        part = self.parts[result.id]
        again = result.method != part.methods[0]
        try:
            return self._worded(result, part, earlier, again=again)
        except WordingError as error:
            fault = str(error)
        left = lost(result, f"its solution cannot be worded: {plain(fault)}")
        try:
            work = self._worded(left, part, earlier, again=again)
        except WordingError:  # it is the question itself
            work = self._worded(left, part, earlier, again=True)
        return replace(work, fault=fault)

    def _worded(self, result: PartResult, part: Part, earlier: Earlier, *, again: bool) -> Work:
        """Return a result in words, without the question if it was asked before. Raises WordingError."""
        task = catalogue()[result.task]
        method = task.methods[result.method]
        wording = self._wording(self._display(part, {**earlier, part.id: result}))
        worded = wording.words(result.steps)
        return Work(
            id=result.id,
            task=result.task,
            method=result.method,
            title=wording.say(task.title),
            method_title=wording.say(method.title),
            source=wording.say(method.source),
            marks="" if part.marks is None else NumberFormat("decimal").text(part.marks),
            question="" if again else wording.question(part, loops=_loops(task, part)),
            given=wording.given(part.system) if part.own_system and not again else "",
            again=again,
            steps=tuple(map(self._step, worded)),
            answers=tuple(_answers(result, wording)),
            rows=tuple(check_rows(result, wording.say)),
            status=result.status,
            reason=wording.reason(result.reason),
            unchecked=unchecked(result.checks, wording.say),
            out_of=_number(part.marks) if part.marks is not None else int(not self.any_marks),
            checks=tuple(worded_check(check, wording.say) for check in result.checks),
            symbols=tuple(_symbols(result, worded)) if self.presentation.data else (),
        )

    def _wording(self, display: Display) -> Wording:
        told = self.presentation
        language, notation = told.language or display.language, told.notation or display.notation
        return Wording.of(replace(display, language=language, notation=notation), told.detail, told.templates)

    def _display(self, part: Part, results: Earlier) -> Display:
        """How numbers are shown: as if decimals had been typed where a part hands decimals on, or goes on with them."""
        display = self.problem.display
        is_source = any(part.id in other.sources for other in self.problem.parts)
        for name in (*part.sources, *([part.id] if is_source else [])):
            if name in results and any(map(_holds_decimals, results[name].answers.values())):
                return replace(display, decimals_typed=True)
        return display

    def _step(self, worded: WordedStep) -> WorkStep:
        values = _values(worded.step) if self.presentation.data else {}
        return WorkStep(
            worded.step.kind,
            worded.title,
            worded.markdown,
            tuple(map(self._step, worded.steps)),
            tuple(map(drawing_of, worded.figures)),
            {name: sympy_text(value) for name, value in values.items()},
        )


def lost(result: PartResult, reason: str) -> PartResult:
    """Return what is left of a result that cannot be worded or sent: no steps, answers and checks, but the reason."""
    ended = Reason("limits/ended", {"words": reason})
    return PartResult(result.id, result.task, result.method, Status.UNSOLVED, reason=ended, seconds=result.seconds)


def _loops(task: Task[Any, Any], part: Part) -> list[str]:
    """Return the lemmas that close a loop around the system, for the options that are given."""
    given = (option.loop for name, option in task.options.items() if part.options.get(name) is not None)
    return list(dict.fromkeys(loop for loop in given if loop))


def _answers(result: PartResult, wording: Wording) -> Iterator[WorkAnswer]:
    declared = catalogue()[result.task].answers
    for name, value in result.answers.items():
        symbol = wording.symbol(declared[name])
        equation, narrow = wording.equation(symbol, value), wording.equation(symbol, value, narrow=True)
        doc = wording.say(declared[name].doc)
        yield WorkAnswer(name, symbol, wording.answer(value), doc, sympy_text(value), equation, narrow)


def _number(marks: Any) -> float:
    return int(marks) if marks.is_Integer else float(marks)


def _holds_decimals(value: Any) -> bool:
    if isinstance(value, list | tuple):
        return any(map(_holds_decimals, value))
    return bool(getattr(value, "atoms", lambda _: ())(sp.Float))


def _values(step: Step) -> Mapping[str, Any]:
    """Return the values of a step that are data, and what its claims found, by name."""
    found = {name: claim.right for name, claim in step.claims.items()}
    return {name: value for name, value in {**step.values, **found}.items() if _is_data(value)}


def _is_data(value: Any) -> bool:
    """Whether a value is mathematics (or a list of it) and not an object of the program."""
    if isinstance(value, list | tuple):
        return all(map(_is_data, value))
    return isinstance(value, sp.Basic | sp.MatrixBase | Stated | str | int | float)


def _symbols(result: PartResult, steps: Iterable[WordedStep]) -> list[str]:
    """Return every free name of the answers and steps but those whose meaning is fixed, sorted."""
    names = set(_names(result.answers.values()))
    for step in steps:
        for each in step.walk():
            names.update(_names(_values(each.step).values()))
    return sorted(names - KNOWN)


def _names(values: Iterable[Any]) -> Iterator[str]:
    """Yield the names of all free symbols."""
    for value in values:
        if isinstance(value, list | tuple):
            yield from _names(value)
        elif isinstance(value, Stated):
            yield from _names(value.operands)
        elif isinstance(value, sp.Basic | sp.MatrixBase):
            yield from (str(symbol) for symbol in value.free_symbols)


__all__ = ["Writer", "document_of", "lost"]
