"""Answer files of an exam: whose they are, of which variant, and what they say to each question."""

from __future__ import annotations

from dataclasses import dataclass, replace
from unicodedata import normalize

from solver.classroom.reading.answer_file import (
    Submission,
    answers_in,
    is_blank,
    report_unknown,
    root_of_answers,
    student_in,
)
from solver.papers.exam.model import Exam
from solver.problem.nodes import MappingNode, whole_number
from solver.problem.source import Fault, InputError, Report, Source, did_you_mean

KEYS = ("exam", "variant", "student", "answers")


@dataclass(frozen=True)
class ExamSubmission:
    """What a student handed in: for each question, in their order, what was submitted to it, maybe nothing."""

    student: str
    variant: int
    answers: tuple[Submission, ...]


def read_exam_submission(source: Source, exam: Exam) -> ExamSubmission:
    """Return what a file answers to an exam; raises InputError where it does not say of which variant, or nothing.

    Whatever else is strange in it costs nothing but itself, as in answers to one problem.
    """
    root, report = root_of_answers(source), Report()
    report_unknown(root, KEYS, report)
    try:
        student, variant = _who(root, exam)
    except Fault as fault:
        raise InputError(source, fault.diagnostics) from None
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


def _who(root: MappingNode, exam: Exam) -> tuple[str, int]:
    """Return the student and the variant of a file; raises Fault where that is not sure."""
    student, node, count = student_in(root), root.get("variant"), len(exam.variants)
    said = whole_number(node, "variant", 1, count) if node is not None and not is_blank(node) else None
    known = {_plain(name): number for number, name in enumerate(exam.students, 1)}
    own = known.get(_plain(student))
    if own is not None and said is not None and own != said and node is not None:
        raise node.fault(f"{student} has variant {own}, not {said}", note="take out the line that is wrong")
    if exam.students and student and own is None:
        names = {_plain(name): name for name in exam.students}
        close = names.get(did_you_mean(_plain(student), names), "")
        raise root["student"].fault(f"'{student[:60]}' is no student of this class", suggestion=close)
    variant = own or said or (1 if count == 1 else None)
    if variant is None:
        raise root.fault(f"it does not say which of the {count} variants it answers: the key 'variant' is missing")
    return (exam.students[variant - 1] if exam.students else student), variant


def _plain(name: str) -> str:
    """Return a name as it is compared: without capitals, and in one way of writing its letters."""
    return " ".join(normalize("NFKC", name).casefold().split())
