"""What a wrong answer can still earn: the key `partial` of a problem or of a part.

A word (`entries`, `none`, `named`) holds for every answer; a mapping says it by answer, or what named mistakes cost:
`{K: none, eigenvalues: {order: 1}, sign: 1}`. What costs nothing by its name earns in proportion to what is right.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from solver.derivation import Task
from solver.derivation.usual_mistakes import USUAL
from solver.problem.lexicon import exact_number
from solver.problem.model import RULES, Partial, Problem
from solver.problem.nodes import MappingNode, Node, ScalarNode, scalar
from solver.problem.source import Report, did_you_mean


@dataclass(frozen=True, slots=True)
class Said:
    """What one `partial` says: of certain answers, and of all others (None where it says nothing of them)."""

    answers: Mapping[str, Partial] = field(default_factory=dict)
    others: Partial | None = None

    def of(self, answer: str) -> Partial | None:
        """Return what it says of an answer."""
        return self.answers.get(answer, self.others)


def slips_of(tasks: Iterable[Task[Any, Any]]) -> list[str]:
    """Return the names of the mistakes that marking may find in some tasks."""
    own = [slip.name for task in tasks for slip in task.slips]
    return list(dict.fromkeys([*(slip.name for slip in USUAL), *own]))


def read_partial(node: Node | None, answers: Collection[str], slips: Collection[str]) -> Said:
    """Return what stands under the key, nothing where it is absent; raises Fault."""
    if node is None:
        return Said()
    if not isinstance(node, MappingNode):
        return Said(others=_rule(scalar(node)))
    report, by_answer, costs = Report(), dict[str, Partial](), dict[str, Any]()
    for entry in node:
        with report:
            if entry.key.text in answers:
                by_answer[entry.key.text] = _of_answer(entry.value, slips)
            else:
                name = _slip(entry.key, slips, answers)
                costs[name] = _cost(entry.value)
    report.conclude()
    return Said(by_answer, Partial("named", costs) if costs else None)


def settled(answers: Iterable[str], part: Said, problem: Said) -> dict[str, Partial]:
    """Return what holds of each answer of which anything is said; the part's word wins over the problem's."""
    found = {name: part.of(name) or problem.of(name) for name in answers}
    return {name: partial for name, partial in found.items() if partial is not None}


def ruled(problem: Problem, rule: str, catalogue: Mapping[str, Task[Any, Any]]) -> Problem:
    """Return the problem with one rule for all its answers, whatever it says itself."""
    every = (dict.fromkeys(catalogue[part.task].answers, Partial(rule)) for part in problem.parts)
    parts = tuple(replace(part, partial=partial) for part, partial in zip(problem.parts, every, strict=True))
    return replace(problem, parts=parts)


def _of_answer(node: Node, slips: Collection[str]) -> Partial:
    if not isinstance(node, MappingNode):
        return Partial(_rule(scalar(node)).rule)
    report, costs = Report(), dict[str, Any]()
    for entry in node:
        with report:
            name = _slip(entry.key, slips)
            costs[name] = _cost(entry.value)
    report.conclude()
    return Partial("named", costs)


def _rule(node: ScalarNode) -> Partial:
    if node.text not in RULES:
        note = f"there are {', '.join(RULES)}, and mappings such as {{K: none}} or {{sign: 1}}"
        suggestion = did_you_mean(node.text, RULES)
        raise node.fault(f"there is no rule '{node.text[:60]}' for partial marks", suggestion=suggestion, note=note)
    return Partial(node.text)


def _slip(node: ScalarNode, slips: Collection[str], answers: Collection[str] = ()) -> str:
    if node.text not in slips:
        what = "answer and no mistake" if answers else "mistake"
        note = f"mistakes are: {', '.join(slips)}"
        suggestion = did_you_mean(node.text, [*answers, *slips])
        raise node.fault(f"there is no {what} '{node.text[:60]}'", suggestion=suggestion, note=note)
    return node.text


def _cost(node: Node) -> Any:
    """Return what a mistake costs, in marks; raises Fault."""
    marks = exact_number(node)
    if marks < 0:
        raise node.fault("what a mistake costs can't be negative")
    return marks
