"""Marking a class: each student against the own variant, the marks of all questions together."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from solver.classroom import Marking, mark_each
from solver.classroom.syntax import Readings, readings
from solver.document.exam import as_question
from solver.document.model import Document, Presentation
from solver.document.works import document_of, solve_as_told
from solver.engine import Solution
from solver.executors import Executor
from solver.limits import Exceeded, Limits
from solver.papers.again import members_again
from solver.papers.exam.drawing import Means, in_turn, search_of
from solver.papers.exam.model import Exam, Question
from solver.papers.exam.scaling import scaled
from solver.papers.exam.solved import solve_each
from solver.papers.exam.submitted import ExamSubmission
from solver.papers.making import Wanted
from solver.papers.marked import MarkedBefore, keep_worked, worked_before
from solver.problem.model import Problem
from solver.problem.partial import ruled
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

Solutions = Mapping[int, Sequence[Solution]]
"""The solutions of the questions, in their order, by the number of a variant."""

Worked = Mapping[tuple[int, int], Document | None]
"""The worked solutions by variant and question."""


def solutions_of(
    exam: Exam, variants: Collection[int], means: Means, prepared: Callable[[Problem], Problem]
) -> Solutions:
    """Return the solved questions of some variants; raises InputError where a family has too few members."""
    numbers = sorted(set(variants))
    problems: dict[tuple[int, str], Problem] = {}  # by text: what is the same in all variants is solved once
    places: dict[int, list[tuple[int, str]]] = {number: [] for number in numbers}
    for question in exam.questions:
        texts = _texts(exam, question, max(numbers, default=0), means)
        for number in numbers:
            place = question.number, texts[number - 1]
            if place not in problems:
                problem = read_problem(Source(question.source.name, texts[number - 1]), catalogue())
                problems[place] = prepared(scaled(problem, question.marks))
            places[number].append(place)
    found = solve_each(list(problems.values()), means.limits, means.executor, means.kept)
    solved = dict(zip(problems, found, strict=True))
    return {number: [solved[place] for place in of_variant] for number, of_variant in places.items()}


def prepared(presentation: Presentation, partial: str | None, problem: Problem) -> Problem:
    """Return a problem in the language asked for, and marked by the rule asked for."""
    told = presentation.of(problem)
    return ruled(told, partial, catalogue()) if partial else told


def _texts(exam: Exam, question: Question, count: int, means: Means) -> list[str]:
    """Return the texts of a question in the first variants, the same that the papers have."""
    if question.problem.family is None:
        return [question.source.text] * count
    search = search_of(exam, question, means)
    wanted = Wanted(limits=means.limits)
    found = [each.text for each in members_again(means.kept, question.problem, search, count, wanted, "member")]
    return in_turn(exam, question, search, found, count)


def marked(
    papers: Sequence[ExamSubmission],
    solutions: Solutions,
    means: Means,
) -> Iterator[tuple[Marking, ...]]:
    """Yield the markings of each paper, one for each question."""
    pairs = [pair for paper in papers for pair in zip(solutions[paper.variant], paper.answers, strict=True)]
    templates, memory = means.presentation.templates, MarkedBefore(means.kept)
    markings = mark_each(pairs, means.limits, templates, means.executor, memory)
    for paper in papers:
        yield tuple(next(markings) for _ in paper.answers)


def together(student: str, of_questions: Sequence[Marking]) -> Marking:
    """Return the marking of a paper: its parts are called `2.a`, and carry the marks of the exam."""
    parts = tuple(
        replace(part, id=f"{number}.{part.id}") for number, each in enumerate(of_questions, 1) for part in each.parts
    )
    return Marking(student, parts, tuple(remark for each in of_questions for remark in each.remarks))


def apart(whole: Marking, of_questions: Sequence[Marking]) -> tuple[Marking, ...]:
    """Return the markings of the questions with what stands in that of the paper, whose parts `together` put there."""
    parts = iter(whole.parts)
    return tuple(
        replace(each, parts=tuple(replace(next(parts), id=part.id) for part in each.parts)) for each in of_questions
    )


def read_as(
    papers: Sequence[ExamSubmission], solutions: Solutions, limits: Limits, templates: Path | None, executor: Executor
) -> Iterator[Readings | Exceeded]:
    """Yield how the values of each paper are read; their parts are called `2.a`."""
    calls = [
        (solution, submission, templates)
        for paper in papers
        for solution, submission in zip(solutions[paper.variant], paper.answers, strict=True)
    ]
    found = executor.in_order(limits, readings, calls)
    for paper in papers:
        of_questions: list[Readings | Exceeded] = [next(found) for _ in paper.answers]
        stopped = next((each for each in of_questions if isinstance(each, Exceeded)), None)
        read = [each for each in of_questions if isinstance(each, Readings)]
        values = [replace(value, part=f"{n}.{value.part}") for n, each in enumerate(read, 1) for value in each.values]
        remarks = tuple(remark for each in read for remark in each.remarks)
        yield stopped or Readings(paper.student, tuple(values), remarks)


def worked_of(solutions: Solutions, means: Means) -> Worked:
    """Return the worked solutions, each worded once however many variants have it; None where it met its limit."""
    places: dict[int, list[tuple[int, int]]] = {}
    for variant, of_questions in solutions.items():
        for number, solution in enumerate(of_questions, 1):
            places.setdefault(id(solution), []).append((variant, number))
    calls = [(solutions[variant][number - 1], means.presentation, number) for (variant, number), *_ in places.values()]
    documents = [worked_before(means.kept, *each) for each in calls]
    new = [place for place, document in enumerate(documents) if document is None]
    parts = max((len(solution.parts) for solution, *_ in calls), default=1)
    found = means.executor.in_order(means.limits.times(parts), _worked, [calls[place] for place in new])
    for place, document in zip(new, found, strict=True):
        if not isinstance(document, Exceeded):
            documents[place] = document
            solution, *told = calls[place]
            keep_worked(means.kept, solution, document, *told)
    told_of = zip(places.values(), documents, strict=True)
    return {place: document for each, document in told_of for place in each}


def _worked(solution: Solution, presentation: Presentation, number: int) -> Document:
    """Return the worked solution of a question, solved anew for its steps, without what is asked."""
    problem = solution.problem
    solved = solve_as_told(problem, presentation)
    told = as_question(document_of(solved, presentation), number)
    parts = tuple(replace(part, question="", given="") for part in told.parts)
    return replace(told, statement="", given="", parts=parts)
