"""A file of questions solved once, each part with its answers as the JSON has them."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import sympy as sp

from solver.derivation import Status
from solver.document.model import Presentation, Work
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue
from tests.hunt import judges
from tests.hunt.asked import Question, points, questions_in
from tests.hunt.judges.found import Found


@dataclass(frozen=True)
class Solved:
    """A question by one method: what the program says of it."""

    question: Question
    work: Work

    @property
    def values(self) -> Mapping[str, Any]:
        """The answers, read as FORMAT promises that they can be."""
        names = {name: sp.Symbol(name) for name in self.work.symbols}
        return {each.name: read(each.value, names) for each in self.work.answers}

    @property
    def verified(self) -> bool:
        """Whether the program signs it."""
        return self.work.status is Status.VERIFIED


def read(text: str, names: Mapping[str, sp.Symbol]) -> Any:
    """A value of the JSON: algebra, True and False, or a word."""
    if text in ("True", "False"):
        return text == "True"
    if text.replace(" ", "").isalpha() and text not in names and len(text) > 3:
        return text
    return sp.sympify(text, locals=dict(names))


@cache
def solved(path: Path) -> tuple[Solved, ...]:
    """All questions of a file by all their methods."""
    text = path.read_text(encoding="utf-8")
    solution = solve_problem(read_problem(Source(path.name, text), catalogue()))
    works = document_of(solution, Presentation("full", data=True)).parts
    asked = {question.id: question for question in questions_in(path)}
    return tuple(Solved(asked[work.id], work) for work in works if not work.case)


def faults(one: Solved) -> Iterator[str]:
    """What is wrong with the answers, by the judge of the task, at a point."""
    for point in points(one.question, 1):
        found = Found(point, one.values)
        judges.of(one.question.task)(point, found)
        yield from dict.fromkeys(found.wrong)
