"""Answer files of an exam: whose they are, of which variant, and what they say to each question."""

from __future__ import annotations

from dataclasses import dataclass, replace

from solver.classroom.reading.answer_file import (
    Submission,
    answers_in,
    is_blank,
    report_unknown,
    root_of_answers,
)
from solver.papers.exam.model import Exam
from solver.papers.exam.whose import Unplaced, who
from solver.problem.nodes import MappingNode
from solver.problem.source import InputError, Report, Source, did_you_mean

KEYS = ("exam", "variant", "student", "answers")


@dataclass(frozen=True)
class ExamSubmission:
    """What a student handed in: for each question, in their order, what was submitted to it, maybe nothing."""

    student: str
    variant: int
    answers: tuple[Submission, ...]


class NotPlacedError(InputError):
    """A file can be read, and cannot be marked: `status` says why in two words."""

    def __init__(self, source: Source, fault: Unplaced) -> None:
        super().__init__(source, fault.diagnostics)
        self.status = fault.status


def read_exam_submission(source: Source, exam: Exam) -> ExamSubmission:
    """Return what a file answers to an exam; raises InputError where it does not say of which variant, or nothing.

    Whatever else is strange in it costs nothing but itself, as in answers to one problem.
    """
    root, report = root_of_answers(source), Report()
    report_unknown(root, KEYS, report)
    try:
        student, variant = who(root, exam)
    except Unplaced as fault:
        raise NotPlacedError(source, fault) from None
    listed = root.get("answers")
    if not isinstance(listed, MappingNode):
        message = "'answers:' must list the questions, and under each its parts: 1: {a: {K: [1, 2]}}"
        raise InputError(source, [(listed or root).diagnostic(message)])
    numbers = {str(question.number): question for question in exam.questions}
    found: dict[int, Submission] = {}
    if len(numbers) == 1 and not any(entry.key.text in numbers for entry in listed):
        only = exam.questions[0]
        found[only.number] = Submission(source, student, answers_in(listed, only.problem, report))
    for entry in listed if not found else ():
        with report:
            question = numbers.get(entry.key.text)
            if question is None:
                note = f"its questions are: {', '.join(numbers)}"
                message = f"the exam has no question '{entry.key.text[:40]}'"
                raise entry.key.fault(message, suggestion=did_you_mean(entry.key.text, numbers), note=note)
            found[question.number] = Submission(source, student, {})
            if isinstance(entry.value, MappingNode):
                answers = answers_in(entry.value, question.problem, report)
                found[question.number] = Submission(source, student, answers)
            elif not is_blank(entry.value):
                raise entry.value.fault(f"the parts of question {question.number} are expected by name")
    if not found:
        raise InputError(source, report.diagnostics or [listed.diagnostic("no question is answered here")])
    blank = Submission(source, student, {})
    answers_of = [found.get(question.number, blank) for question in exam.questions]
    answers_of[0] = replace(answers_of[0], strange=tuple(report.diagnostics))
    return ExamSubmission(student, variant, tuple(answers_of))
