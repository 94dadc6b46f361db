"""An instructor's changes: verdicts, marks and comments that win over those of the program, rerun after rerun.

    changes:
      A-17:                                   # the label of a student, or the name of an answer file
        comment: Come and see me about part b.
        b:
          comment: The sign is that of the lecture.
          K: {verdict: correct, marks: 3, comment: Right with u = +K x.}

A verdict without marks earns all of them or none; marks without a verdict leave it as it is.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from solver.classroom.verdicts import Verdict
from solver.problem.model import Part
from solver.problem.nodes import Entry, MappingNode, Node, ScalarNode, scalar
from solver.problem.source import Diagnostic, InputError, Report, Source, did_you_mean
from solver.problem.yaml_tree import parse_yaml
from solver.tasks import catalogue

KEYS = ("verdict", "marks", "comment")
COMMENT = "comment"
_NUMBER = re.compile(r"\d{1,6}(\.\d{1,6})?|\d{1,6}/[1-9]\d{0,5}")


@dataclass(frozen=True)
class Change:
    """What an instructor says of an answer; None and "" leave it as it is. `key` and `stated` are where it says so."""

    key: ScalarNode
    stated: Node
    verdict: Verdict | None = None
    marks: Fraction | None = None
    comment: str = ""


@dataclass(frozen=True)
class PartChanges:
    """What an instructor says of a part: the changes by the answer's name, a comment on the whole."""

    key: ScalarNode
    answers: Mapping[str, Change] = field(default_factory=dict)
    comment: str = ""


@dataclass(frozen=True)
class StudentChanges:
    """What an instructor says of a student's answers: the changes by the part's id, a comment on the whole."""

    key: ScalarNode
    parts: Mapping[str, PartChanges] = field(default_factory=dict)
    comment: str = ""


@dataclass(frozen=True)
class Changes:
    """The changes of a file, by what names the student or the answer file."""

    source: Source
    students: Mapping[str, StudentChanges]

    def of(self, *names: str) -> StudentChanges | None:
        """Return the changes for a student that goes by any of these names."""
        return next((self.students[name] for name in names if name in self.students), None)

    def refuse_unknown(self, of: StudentChanges, parts: Mapping[str, Part], what: str = "problem") -> None:
        """Raise InputError where changes name a part or an answer that there is not; `parts` are known by name."""
        report = Report()
        for id_, changed in of.parts.items():
            if id_ not in parts:
                report.diagnostics.append(_no_such(changed.key, f"the {what} has no part '{id_[:40]}'", parts))
                continue
            task = catalogue()[parts[id_].task]
            for name, change in changed.answers.items():
                if name not in task.answers:
                    message = f"{task.name} has no answer '{name[:60]}'"
                    report.diagnostics.append(_no_such(change.key, message, task.answers))
        if report.diagnostics:
            raise InputError(self.source, report.diagnostics)

    def strangers(self, papers: Sequence[Sequence[str]]) -> list[Diagnostic]:
        """Return what is wrong with keys that name none of the papers, each of which goes by several names.

        Raises InputError where a key names several papers, or several keys name one.
        """
        known = sorted({name for names in papers for name in names})
        strange, unclear = list[Diagnostic](), list[Diagnostic]()
        for name, changes in self.students.items():
            count = sum(name in names for names in papers)
            if not count:
                strange.append(_no_such(changes.key, f"no answer file is of '{name[:40]}'", known))
            elif count > 1:
                unclear.append(changes.key.diagnostic(f"{count} answer files go by '{name[:40]}'; name the file"))
        for names in papers:
            for key in [self.students[name].key for name in dict.fromkeys(names) if name in self.students][1:]:
                unclear.append(key.diagnostic(f"'{key.text[:40]}' is changed under another name too"))
        if unclear:
            raise InputError(self.source, unclear)
        return strange


def _no_such(key: ScalarNode, message: str, known: Collection[str]) -> Diagnostic:
    return key.diagnostic(message, did_you_mean(key.text, known), f"there are: {', '.join(list(known)[:20])}")


def read_changes(source: Source) -> Changes:
    """Return the changes of a file; raises InputError, all errors with their places."""
    root, report = parse_yaml(source), Report()
    listed = root.get("changes") if isinstance(root, MappingNode) else None
    if not isinstance(listed, MappingNode) or not isinstance(root, MappingNode):
        raise InputError(
            source, [root.diagnostic("'changes:' must list the changes of each student: A-17: {b: {K: …}}")]
        )
    for entry in root:
        if entry.key.text != "changes":
            with report:
                raise entry.key.fault(f"unknown key '{entry.key.text[:60]}'", suggestion="changes")
    students = {entry.key.text: _student(entry, report) for entry in listed}
    if report.diagnostics:
        raise InputError(source, report.diagnostics)
    return Changes(source, students)


def _student(entry: Entry, report: Report) -> StudentChanges:
    comment, rest = _entries(entry.value, "parts", report)
    return StudentChanges(entry.key, {each.key.text: _part(each, report) for each in rest}, comment)


def _part(entry: Entry, report: Report) -> PartChanges:
    comment, rest = _entries(entry.value, "answers", report)
    changes: dict[str, Change] = {}
    for each in rest:
        with report:
            changes[each.key.text] = _change(each)
    return PartChanges(entry.key, changes, comment)


def _entries(node: Node, of: str, report: Report) -> tuple[str, list[Entry]]:
    """Return the comment that stands in a mapping, and the other entries; a part may be called comment too."""
    comment = ""
    if not isinstance(node, MappingNode):
        with report:
            raise node.fault(f"the {of} that are changed are expected here by name, or a comment, not {node.what}")
        return "", []
    entries = list(node)
    for entry in node:
        if entry.key.text == COMMENT and isinstance(entry.value, ScalarNode):
            comment = entry.value.text.strip()
            entries.remove(entry)
    return comment, entries


def _change(entry: Entry) -> Change:
    node = entry.value
    if not isinstance(node, MappingNode):
        raise node.fault("what is changed is expected here by name: {verdict: correct, marks: 2, comment: …}")
    for each in node:
        if each.key.text not in KEYS:
            message = f"unknown key '{each.key.text[:60]}'"
            raise each.key.fault(
                message, suggestion=did_you_mean(each.key.text, KEYS), note=f"it is one of {', '.join(KEYS)}"
            )
    comment = node.get(COMMENT)
    verdict, marks = node.get("verdict"), node.get("marks")
    return Change(
        entry.key,
        node if marks is None else marks,
        None if verdict is None else _verdict(scalar(verdict)),
        None if marks is None else _marks(scalar(marks)),
        "" if comment is None else scalar(comment).text.strip(),
    )


def _verdict(node: ScalarNode) -> Verdict:
    words = [str(each) for each in Verdict]
    if node.text not in words:
        message = f"a verdict is one of {', '.join(words)}"
        raise node.fault(message, suggestion=did_you_mean(node.text, words))
    return Verdict(node.text)


def _marks(node: ScalarNode) -> Fraction:
    if not _NUMBER.fullmatch(node.text):
        raise node.fault("marks are a number such as 2.5")
    return Fraction(node.text)
