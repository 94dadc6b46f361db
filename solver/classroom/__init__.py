"""Marking: a student's answers judged by what the question asks, by the verifications that check our own."""

from solver.classroom.marking import mark
from solver.classroom.reading.answer_file import Submission, read_submission
from solver.classroom.verdicts import AnswerVerdict, Marking, PartVerdict, Verdict
from solver.classroom.within import mark_each, mark_within

__all__ = [
    "AnswerVerdict",
    "Marking",
    "PartVerdict",
    "Submission",
    "Verdict",
    "mark",
    "mark_each",
    "mark_within",
    "read_submission",
]
