"""Marking one answer file to one problem, as tests do."""

from functools import cache

from solver.classroom import Submission, mark, read_submission
from solver.classroom.marking import Marker
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue


@cache
def solved(text):
    """The solution of a problem given as text, solved once in a process."""
    return solve_problem(read_problem(Source("problem.yaml", text), catalogue()))


def marked(problem, answers):
    """The verdicts of an answer file given as text: {part: PartVerdict}; the problem is a text, or solved already."""
    solution = solved(problem) if isinstance(problem, str) else problem
    submission = read_submission(Source("answers.yaml", answers), solution.problem)
    return {part.id: part for part in mark(solution, submission).parts}


def verdict(problem, part, name, value):
    """The verdict of one value."""
    return marked(problem, f"answers: {{{part}: {{{name}: {value}}}}}")[part].answers[name]


def marker(solution):
    """The marker of a problem, with nothing submitted."""
    return Marker(solution, Submission(Source("answers.yaml", ""), "", {}))
