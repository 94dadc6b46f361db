"""What is asked of a part's answers: which earn its marks, and with how many digits."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction
from typing import Any

from solver.derivation import Task
from solver.problem.hundredths import told_in_hundredths
from solver.problem.model import Part
from solver.problem.nodes import TRUE, MappingNode, ScalarNode, SequenceNode, scalar, whole_number
from solver.problem.source import Report, did_you_mean


def read_asked(part: MappingNode, task: Task[Any, Any], methods: Sequence[str]) -> tuple[str, ...]:
    """Return the answers that the key `answers` of a part lists, none without it; raises Fault."""
    if "answers" not in part:
        return ()
    node = part["answers"]
    items = node.items if isinstance(node, SequenceNode) else (node,)
    if not items:
        raise node.fault("no answer is named here; leave out 'answers' to ask for the usual ones")
    report, found = Report(), list[str]()
    for item in items:
        with report:
            name = answer_named(scalar(item), task, methods)
            if name in found:
                raise item.fault(f"the answer {name} is asked for twice")
            found.append(name)
    report.conclude()
    return tuple(found)


MOST_DIGITS = 12
"""Significant digits that a problem may ask of decimals."""


def read_digits(holder: MappingNode, default: int, report: Report) -> int:
    """Return the significant digits that a student's decimals must have, as the key `digits` of a problem or part says.

    What is wrong with it goes to the report.
    """
    if "digits" in holder:
        with report:
            return whole_number(holder["digits"], "digits", 1, MOST_DIGITS)
    return default


def read_comma(holder: MappingNode, *, default: bool) -> bool:
    """Return whether students may write 1,5 for 1.5, as the key `decimal_comma` of a problem or part says."""
    node = holder.get("decimal_comma")
    return node.text in ("yes", *TRUE) if isinstance(node, ScalarNode) else default


def given_by(task: Task[Any, Any], methods: Sequence[str]) -> list[str]:
    """Return the names of the answers that the methods may give."""
    return [name for name, answer in task.answers.items() if not answer.methods or set(answer.methods) & set(methods)]


def answer_named(node: ScalarNode, task: Task[Any, Any], methods: Sequence[str]) -> str:
    """Return the name of an answer that one of the methods gives; raises Fault for any other."""
    given = given_by(task, methods)
    if node.text not in given:
        note = f"its answers are: {', '.join(given)}"
        message = f"{task.name} has no answer '{node.text[:60]}'"
        raise node.fault(message, suggestion=did_you_mean(node.text, given), note=note)
    return node.text


def asked_of(part: Part, task: Task[Any, Any]) -> tuple[str, ...]:
    """Return the answers asked for: those that the part names or gives marks to, else the task's principal ones."""
    methods = {name: set(answer.methods or part.methods) for name, answer in task.answers.items()}
    principal = tuple(name for name in task.principal_of(part.system) if methods[name] & set(part.methods))
    return part.asked or tuple(part.answer_marks) or principal


def marks_of(part: Part, task: Task[Any, Any]) -> dict[str, Any]:
    """Return the marks of each answer asked for: as the part gives them, else equal shares of those of the part."""
    if part.answer_marks or part.marks is None:
        return dict(part.answer_marks)
    asked = asked_of(part, task)
    return dict.fromkeys(asked, part.marks / len(asked))


def marks_shown(part: Part, task: Task[Any, Any], found: Collection[str]) -> dict[str, Fraction]:
    """Return the marks of each answer as they are printed: in hundredths that add up, where those of all are some.

    Where the part does not give marks to each, answers that this question has not (they are not `found`) carry none.
    """
    told = marks_of(part, task)
    if not part.answer_marks and (there := [name for name in told if name in found]):
        told = dict.fromkeys(there, sum(told.values()) / len(there))
    exact = {name: Fraction(int(each.p), int(each.q)) for name, each in told.items()}
    return dict(zip(exact, told_in_hundredths(list(exact.values())), strict=True))
