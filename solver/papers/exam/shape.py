"""The shape of an exam file, as models, like that of problem files."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Field, Tag

from solver.problem.elements import Shape, Value, either, optional
from solver.problem.nodes import Node
from solver.problem.shape import Text, YesOrNo
from solver.problem.shape_check import Misshapen, check_shape

Problem = Annotated[
    Annotated[Text, Tag("<value>")] | Annotated[dict[str, Any], Tag("<mapping>")],
    either("the name of a problem file, or a problem {system: .., find: ..},"),
]


class QuestionShape(Shape):
    """A question: a problem, which may be a family, and what it carries."""

    problem: Problem = Field(description="a problem file, found from the folder of the exam, or a problem itself")
    marks: Value = optional("the marks of the question, to which those of its parts are scaled")
    page_break: YesOrNo = optional("whether the question begins a page")


class VariantsShape(Shape):
    """How many papers there are, or who gets one."""

    count: Value = optional("how many variants there are")
    students: Text = optional("a table of the class (CSV), its first column the students: a paper for each")


class ExamShape(Shape):
    """An exam: what stands on its cover, and its questions."""

    exam: Text = Field(description="the title")
    course: Text = optional("the course")
    date: Text = optional("the date, as it is printed")
    duration: Text = optional("how long it takes, as it is printed")
    instructions: Text = optional("what is said before the questions: Markdown with $math$")
    questions: list[QuestionShape] = Field(min_length=1, description="the questions, in order")
    variants: VariantsShape = optional("how many papers there are, 1 if nothing is said")
    seed: Value = optional("the same seed draws the same papers anywhere")


def check_exam_shape(root: Node) -> list[Misshapen]:
    """Return what is wrong with the shape of an exam."""
    return check_shape(root, ExamShape, "an exam", {"questions": QuestionShape, "variants": VariantsShape})
