"""The Python interface to families and exams; it has what the command line has, as objects and bytes."""

from solver.papers.interface.classes import MarkedExam, check_exam
from solver.papers.interface.exams import ExamBank, Papers, exam, exam_bank
from solver.papers.interface.families import Variant, variants

__all__ = ["ExamBank", "MarkedExam", "Papers", "Variant", "check_exam", "exam", "exam_bank", "variants"]
