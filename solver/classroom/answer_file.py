"""Answer files: YAML as hostile as problem files, read by the same parser with the same bounds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from solver.problem.model import Problem
from solver.problem.nodes import MappingNode, Node, ScalarNode
from solver.problem.source import InputError, Report, Source, did_you_mean
from solver.problem.yaml_tree import parse_yaml
from solver.tasks import catalogue

KEYS = ("problem", "student", "answers")


@dataclass(frozen=True)
class Submission:
    """A student's answers, not yet read: for each part's id the values by the answer's name, as nodes of the file."""

    source: Source
    student: str
    answers: Mapping[str, Mapping[str, Node]]


def problem_named_in(source: Source) -> str:
    """Return the problem file that an answer file names, or ""; raises InputError."""
    root = _root(source)
    node = root.get("problem")
    return node.text.strip() if isinstance(node, ScalarNode) else ""


def read_submission(source: Source, problem: Problem) -> Submission:
    """Return the answers of a file to a problem; raises InputError with everything that is wrong with its shape."""
    root = _root(source)
    report = Report()
    for entry in root:
        if entry.key.text not in KEYS:
            with report:
                suggestion = did_you_mean(entry.key.text, KEYS)
                raise entry.key.fault(f"unknown key '{entry.key.text[:60]}'", suggestion=suggestion)
    answers: dict[str, Mapping[str, Node]] = {}
    listed = root.get("answers")
    if not isinstance(listed, MappingNode):
        with report:
            raise (listed or root).fault("'answers:' must list the answers of each part: a: {K: [1, 2]}")
    else:
        for entry in listed:
            with report:
                answers[entry.key.text] = _part(entry.key, entry.value, problem)
    if report.diagnostics:
        raise InputError(source, report.diagnostics)
    return Submission(source, _student(root), answers)


def _root(source: Source) -> MappingNode:
    root = parse_yaml(source)
    if not isinstance(root, MappingNode):
        raise InputError(source, [root.diagnostic("an answer file is a mapping with the key 'answers'")])
    return root


def _student(root: MappingNode) -> str:
    node = root.get("student")
    return " ".join(node.text.split()) if isinstance(node, ScalarNode) else ""


def _part(key: ScalarNode, node: Node, problem: Problem) -> Mapping[str, Node]:
    """Return the values submitted for a part; raises Fault."""
    parts = {part.id: part for part in problem.parts}
    if key.text not in parts:
        note = f"its parts are: {', '.join(parts)}"
        message = f"the problem has no part '{key.text[:40]}'"
        raise key.fault(message, suggestion=did_you_mean(key.text, parts), note=note)
    task = catalogue()[parts[key.text].task]
    if not isinstance(node, MappingNode):
        if len(task.answers) == 1 and not (isinstance(node, ScalarNode) and node.is_null):
            return {next(iter(task.answers)): node}
        names = ", ".join(task.answers)
        raise node.fault(f"the answers of part {key.text} are expected by name", note=f"it has: {names}")
    report = Report()
    for entry in node:
        if entry.key.text not in task.answers:
            with report:
                name = entry.key.text
                note = f"its answers are: {', '.join(task.answers)}"
                message = f"{task.name} has no answer '{name[:60]}'"
                raise entry.key.fault(message, suggestion=did_you_mean(name, task.answers), note=note)
    report.conclude()
    return {entry.key.text: entry.value for entry in node}
