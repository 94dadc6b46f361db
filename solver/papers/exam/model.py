"""An exam as read: its questions, each a problem or a family, and who gets a paper."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from solver.papers.exam.names import Names
from solver.papers.generator import hashed
from solver.problem.nodes import MappingNode

if TYPE_CHECKING:
    import sympy as sp

    from solver.problem.model import Problem
    from solver.problem.nodes import Node
    from solver.problem.source import Source


@dataclass(frozen=True, slots=True)
class Question:
    """A question by its number from 1: the problem as read from `told`, and `source`, the text of that problem alone.

    Both are the same where the problem has a file of its own; where it stands in the exam, `told` is the exam.
    `node` is where the exam names it.
    """

    number: int
    problem: Problem
    told: Source
    source: Source
    node: Node = field(repr=False)
    marks: sp.Rational | None = None
    page_break: bool = False

    @property
    def title(self) -> str:
        """The title of the problem, "" where it stands in the exam and has none."""
        untold = isinstance(self.node, MappingNode) and "title" not in self.node
        return "" if untold else self.problem.title


@dataclass(frozen=True, slots=True)
class Variant:
    """A paper: its number from 1, what files of it are called, and whose it is, "" where it is nobody's."""

    number: int
    label: str
    student: str = ""


@dataclass(frozen=True, slots=True)
class Exam:
    """An exam file as read. `students` are those of the class, none where papers are told apart by numbers only."""

    source: Source
    title: str
    questions: tuple[Question, ...]
    course: str = ""
    date: str = ""
    duration: str = ""
    instructions: str = ""
    seed: int = 1
    count: int = 1
    students: tuple[str, ...] = ()

    @property
    def variants(self) -> list[Variant]:
        """The papers in order; each student has one."""
        if self.students:
            names = Names()
            return [Variant(i, names.of(student), student) for i, student in enumerate(self.students, 1)]
        width = len(str(self.count))
        return [Variant(number, f"{number:0{width}}") for number in range(1, self.count + 1)]

    def seed_of(self, question: Question) -> int:
        """Return the seed that draws the members of a question: it depends on its place, and on nothing else."""
        return hashed(self.seed, question.number)
