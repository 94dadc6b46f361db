"""Answer files: YAML as hostile as problem files, read by the same parser with the same bounds.

A file is at fault only where it is no YAML or names no part of the problem. Whatever else is strange in it costs
nothing but itself: what nobody asked for is remarked, a value that cannot be read is not judged.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from solver.classroom.reading.keys import as_meant, joined, told_by_name, with_parts
from solver.classroom.reading.quoting import quoted
from solver.problem.model import Problem
from solver.problem.nodes import Entry, MappingNode, Node, ScalarNode
from solver.problem.other_files import ANSWERS, mistaken
from solver.problem.source import Diagnostic, InputError, Report, Source, did_you_mean
from solver.problem.yaml_tree import parse_yaml
from solver.tasks import catalogue

KEYS = ("problem", "student", "answers")


@dataclass(frozen=True)
class Submission:
    """A student's answers, not yet read: for each part's id the values by the answer's name, as nodes of the file.

    What is left blank is not among them. `strange` is what else stands in the file: unknown keys, parts and answers.
    """

    source: Source
    student: str
    answers: Mapping[str, Mapping[str, Node]]
    strange: tuple[Diagnostic, ...] = ()


def node_naming(source: Source, key: str) -> ScalarNode | None:
    """Return where an answer file names its problem (or exam) by a key, None where it does not; raises InputError."""
    node = root_of_answers(source).get(key)
    return node if isinstance(node, ScalarNode) and not node.is_null and node.text.strip() else None


def read_submission(source: Source, problem: Problem) -> Submission:
    """Return the answers of a file to a problem; raises InputError where it names no part of it."""
    root = _with_answers(root_of_answers(source), [part.id for part in problem.parts])
    report, shapeless = Report(), Report()
    report_unknown(root, KEYS, report)
    answers: Mapping[str, Mapping[str, Node]] = {}
    listed = joined(root.get("answers"))
    if not isinstance(listed, MappingNode):
        with shapeless:
            raise (listed or root).fault("'answers:' must list the answers of each part: a: {K: [1, 2]}")
    else:
        answers = answers_in(listed, problem, report)
        if not answers and not report.diagnostics:
            report.diagnostics.append(listed.diagnostic("no part of the problem is answered here"))
    if shapeless.diagnostics or not answers:
        raise InputError(source, [*report.diagnostics, *shapeless.diagnostics])
    return Submission(source, student_in(root), answers, tuple(report.diagnostics))


def _with_answers(root: MappingNode, parts: Collection[str]) -> MappingNode:
    """The tree of a file with the parts that stand beside `answers`, or without it, below it."""
    beside = {key: entry for key, entry in as_meant(root, parts).entries.items() if key in parts and key not in KEYS}
    listed = root.get("answers")
    if not beside or not (listed is None or isinstance(listed, MappingNode) or is_blank(listed)):
        return root
    inside = as_meant(listed, parts).entries if isinstance(listed, MappingNode) else {}
    if beside.keys() & inside.keys():
        return root
    places = {entry.key.place for entry in beside.values()}
    key = root.entries["answers"].key if listed is not None else next(iter(beside.values())).key
    others = {name: entry for name, entry in root.entries.items() if entry.key.place not in places}
    key = ScalarNode(key.place, "answers")
    return MappingNode(root.place, others | {"answers": Entry(key, MappingNode(key.place, {**inside, **beside}))})


def report_unknown(root: MappingNode, known: Sequence[str], report: Report) -> None:
    """Report the keys of an answer file that mean nothing."""
    for entry in root:
        if entry.key.text not in known:
            with report:
                suggestion = did_you_mean(entry.key.text, known)
                raise entry.key.fault(f"unknown key '{entry.key.text[:60]}'", suggestion=suggestion)


def answers_in(listed: MappingNode, problem: Problem, report: Report) -> Mapping[str, Mapping[str, Node]]:
    """Return the values submitted for each part of a problem; what names no part or answer of it is reported."""
    answers: dict[str, Mapping[str, Node]] = {}
    ids = [part.id for part in problem.parts]
    names = {part.id: tuple(catalogue()[part.task].answers) for part in problem.parts}
    for entry in with_parts(as_meant(listed, ids), names):
        with report:
            answers[entry.key.text] = _part(entry.key, entry.value, problem, report)
    return answers


def root_of_answers(source: Source) -> MappingNode:
    """Return the tree of an answer file; raises InputError."""
    root = _tree(source)
    if not isinstance(root, MappingNode):
        raise InputError(source, [root.diagnostic("an answer file is a mapping with the key 'answers'")])
    root = as_meant(root, KEYS)
    if other := mistaken(source, root, ANSWERS):
        raise InputError(source, [other])
    return root


def _tree(source: Source) -> Node:
    """The tree of a file; a value that alone keeps it from being YAML is read as a text. Raises InputError."""
    try:
        return parse_yaml(source, colonless=True)
    except InputError:
        mended = quoted(source)
        if mended is None:
            raise
    try:
        return parse_yaml(mended, colonless=True)
    except InputError:
        return parse_yaml(source, colonless=True)  # told as it is


def student_in(root: MappingNode) -> str:
    """Return the student whom an answer file names, or ""."""
    node = root.get("student")
    return " ".join(node.text.split()) if isinstance(node, ScalarNode) else ""


def _part(key: ScalarNode, node: Node, problem: Problem, report: Report) -> Mapping[str, Node]:
    """Return the values submitted for a part; raises Fault where there is no such part. Other names are reported."""
    parts = {part.id: part for part in problem.parts}
    if key.text not in parts:
        note = f"its parts are: {', '.join(parts)}"
        message = f"the problem has no part '{key.text[:40]}'"
        raise key.fault(message, suggestion=did_you_mean(key.text, parts), note=note)
    if is_blank(node):
        return {}
    task = catalogue()[parts[key.text].task]
    node = told_by_name(joined(node) or node, task.answers)
    if not isinstance(node, MappingNode):
        if len(task.answers) == 1:
            return {next(iter(task.answers)): node}
        with report:
            names = ", ".join(task.answers)
            raise node.fault(f"the answers of part {key.text} are expected by name", note=f"it has: {names}")
        return {}
    node = as_meant(node, task.answers)
    for entry in node:
        if entry.key.text not in task.answers:
            with report:
                name = entry.key.text
                note = f"its answers are: {', '.join(task.answers)}"
                message = f"{task.name} has no answer '{name[:60]}'"
                raise entry.key.fault(message, suggestion=meant_answer(name, task.answers), note=note)
    return {entry.key.text: entry.value for entry in node if _answers(entry, task.answers)}


def meant_answer(name: str, answers: Collection[str]) -> str:
    """Return the answer that a name may stand for: one like it, else the only one that has other indices, K for K_f."""
    bare = [each for each in answers if _letter(each) and _letter(each) == _letter(name)]
    return did_you_mean(name, answers) or (bare[0] if len(bare) == 1 else "")


def _letter(name: str) -> str:
    return name.partition("_")[0].rstrip("0123456789'")


def _answers(entry: Entry, names: Collection[str]) -> bool:
    return entry.key.text in names and not is_blank(entry.value)


def is_blank(node: Node) -> bool:
    """Whether nothing is written there; an empty list is an answer, the empty set."""
    return isinstance(node, ScalarNode) and (node.is_null or not node.text.strip())
