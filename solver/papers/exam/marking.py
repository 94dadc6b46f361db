"""Marking a class: each student against the own variant, the marks of all questions together."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from solver.classroom import Marking, mark_each
from solver.engine import Solution
from solver.executors import Executor
from solver.limits import Limits, solve_within
from solver.papers.exam.drawing import Means, in_turn, search_of
from solver.papers.exam.model import Exam, Question
from solver.papers.exam.scaling import scaled
from solver.papers.exam.submitted import ExamSubmission
from solver.papers.families import Wanted, members
from solver.problem.model import Problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

Solutions = Mapping[int, Sequence[Solution]]
"""The solutions of the questions, in their order, by the number of a variant."""


def solutions_of(
    exam: Exam, variants: Collection[int], means: Means, prepared: Callable[[Problem], Problem]
) -> Solutions:
    """Return the solved questions of some variants; raises InputError where a family has too few members."""
    found: dict[int, list[Solution]] = {number: [] for number in sorted(set(variants))}
    for question in exam.questions:
        solved: dict[str, Solution] = {}  # by text: what is the same in all variants is solved once
        texts = _texts(exam, question, max(found, default=0), means)
        for number, solutions in found.items():
            text = texts[number - 1]
            if text not in solved:
                problem = read_problem(Source(question.source.name, text), catalogue())
                told = prepared(scaled(problem, question.marks))
                solved[text] = solve_within(told, means.limits).solution()
            solutions.append(solved[text])
    return found


def _texts(exam: Exam, question: Question, count: int, means: Means) -> list[str]:
    """Return the texts of a question in the first variants, the same that the papers have."""
    if question.problem.family is None:
        return [question.source.text] * count
    search = search_of(exam, question, means)
    found = [each.text for each in members(search, count, Wanted(limits=means.limits), "member")]
    return in_turn(exam, question, search, found, count)


def marked(
    papers: Sequence[ExamSubmission],
    solutions: Solutions,
    limits: Limits,
    templates: Path | None,
    executor: Executor,
) -> Iterator[tuple[Marking, ...]]:
    """Yield the markings of each paper, one for each question."""
    pairs = [pair for paper in papers for pair in zip(solutions[paper.variant], paper.answers, strict=True)]
    markings = mark_each(pairs, limits, templates, executor)
    for paper in papers:
        yield tuple(next(markings) for _ in paper.answers)


def together(student: str, of_questions: Sequence[Marking]) -> Marking:
    """Return the marking of a paper: its parts are called `2.a`, and carry the marks of the exam."""
    parts = tuple(
        replace(part, id=f"{number}.{part.id}") for number, each in enumerate(of_questions, 1) for part in each.parts
    )
    return Marking(student, parts, tuple(remark for each in of_questions for remark in each.remarks))
