"""Our own marking, asked about values before a learning system marks them: what is right, and what mistakes lead to."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cached_property
from typing import Any

from solver.classroom.following.conventions import asked_by, other_conventions
from solver.classroom.marking import Marker
from solver.classroom.marks import carried
from solver.classroom.mistakes.listing import usual_values
from solver.classroom.mistakes.values import Case
from solver.classroom.reading.answer_file import Submission
from solver.classroom.verdicts import AnswerVerdict, Verdict
from solver.derivation import AnswerName
from solver.engine import Solution
from solver.problem.hundredths import told_in_hundredths
from solver.problem.model import Part, Problem
from solver.problem.nodes import MappingNode, Node
from solver.problem.source import Source
from solver.problem.yaml_tree import parse_yaml
from solver.tasks import catalogue

Answer = tuple[Part, str]


class Bench:
    """Marks values of a solved problem, each alone, as they would be marked in an answer file."""

    def __init__(self, solution: Solution) -> None:
        self.solution = solution
        self.blank = Marker(solution, Submission(Source("", ""), "", {}))

    @property
    def problem(self) -> Problem:
        """The problem."""
        return self.solution.problem

    @cached_property
    def marks(self) -> dict[str, dict[str, Fraction]]:
        """The marks of each answer of each part that carries some; one a part where the problem gives none."""
        parts = self.problem.parts
        told = any(part.marks is not None for part in parts)
        out_of = {part.id: Fraction(int(part.marks.p), int(part.marks.q)) if part.marks is not None
                  else Fraction(int(not told)) for part in parts}  # fmt: skip
        return {part.id: carried(part, self.blank.ours(part.id), out_of[part.id]) for part in parts}

    @cached_property
    def told_marks(self) -> dict[str, dict[str, Fraction]]:
        """Return these marks as they are told: in hundredths that add up to those of the part, where those are some."""
        return {
            part: dict(zip(marks, told_in_hundredths(list(marks.values())), strict=True))
            for part, marks in self.marks.items()
        }

    def declared(self, answer: Answer) -> AnswerName:
        """Return what the catalogue knows of an answer."""
        part, name = answer
        return catalogue()[part.task].answers[name]

    def verdict(self, answer: Answer, text: str) -> AnswerVerdict:
        """Return the verdict of a value as it is typed: a text, or a list or mapping of YAML."""
        part, name = answer
        submission = Submission(Source("", ""), "", {part.id: {name: _node(text)}})
        return Marker(self.solution, submission).part(part).answers[name]

    def is_right(self, answer: Answer, text: str) -> bool:
        """Whether a value is right as it is typed, by our own conventions."""
        found = self.verdict(answer, text)
        return found.verdict is Verdict.CORRECT and not found.follows

    def conventions(self, answer: Answer) -> dict[str, str]:
        """Return the conventions that the file does not name and by others of which other values are right: ours."""
        part, name = answer
        ours, found = self.blank.ours(part.id)[name], dict[str, str]()
        for option, typed in other_conventions(part):
            _, question = asked_by(part, option, typed, self.blank.own.earlier())
            if question is not None and name in question.ours and question.ours[name] != ours:
                found[option] = str(catalogue()[part.task].options[option].default)
        return found

    def mistakes(self, answer: Answer) -> Iterator[tuple[Any, str]]:
        """Yield the values that usual mistakes lead to, with their words."""
        part, name = answer
        ours, earlier = self.blank.ours(part.id), self.blank.own.earlier()
        question = self.blank.question_of(part, earlier, ours)
        if question.task.answers[name].count:
            return
        case = Case(part, question, name, ours[name], self.blank.results[part.id], earlier)
        for slip, value in usual_values(case):
            yield value, self.blank.messages.say(slip.words)


def _node(text: str) -> Node:
    """Return a value as it stands in an answer file."""
    source = text if text[:1] in "[{" else f"'{text}'"
    tree = parse_yaml(Source("", f"value: {source}\n"))
    if not isinstance(tree, MappingNode):
        raise AssertionError("it is a mapping")
    return tree["value"]
