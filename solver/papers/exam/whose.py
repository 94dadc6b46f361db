"""Whose an answer file is: names of students as the class writes them, and the variant that is theirs.

A name that is written as the class writes it is that one. Capitals, spaces and ways of encoding letters do not count
where only one student is left then: who is called Anna gets no marks of who is called anna.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import PurePath
from unicodedata import combining, normalize

from solver.classroom.reading.answer_file import is_blank, student_in
from solver.papers.exam.model import Exam
from solver.papers.exam.students import JOINERS
from solver.problem.nodes import MappingNode, Node, whole_number
from solver.problem.source import Diagnostic, Fault, did_you_mean

ANOTHER_VARIANT, UNKNOWN, UNCLEAR = "variant does not fit", "unknown student", "unclear student"
NO_VARIANT, ANOTHER_EXAM = "no variant", "another exam"


class Unplaced(Fault):
    """It is not sure whose a file is: `status` says why in two words."""

    def __init__(self, diagnostic: Diagnostic, status: str) -> None:
        super().__init__(diagnostic)
        self.status = status


def spelt_alike(name: str, students: Sequence[str]) -> tuple[str, ...]:
    """Return the student of this very name, else those whose names are the same but for capitals and spaces."""
    exact = _exact(name)
    if (same := [each for each in students if _exact(each) == exact]) and exact:
        return (same[0],)
    plain = _plain(name)
    return tuple(dict.fromkeys(each for each in students if plain and _plain(each) == plain))


def meant(name: str, students: Sequence[str]) -> str:
    """Return the student whose name is most like a name, "" where none is; accents count least."""
    bare = [each for each in students if _bare(each) == _bare(name)]
    names = {_plain(each): each for each in students}
    return bare[0] if bare else names.get(did_you_mean(_plain(name), names), "")


def who(root: MappingNode, exam: Exam) -> tuple[str, int]:
    """Return the student and the variant of a file; raises Unplaced where that is not sure."""
    student, node, count = student_in(root), root.get("variant"), len(exam.variants)
    alike = spelt_alike(student, exam.students)
    own = exam.students.index(alike[0]) + 1 if len(alike) == 1 else None
    if exam.students and student and own is None:
        raise _nobody(root, student, alike, exam.students)
    said = _variant_in(root, count)
    if own is not None and said is not None and own != said and node is not None:
        raise Unplaced(_of_another(node, said, own, exam.students), ANOTHER_VARIANT)
    variant = own or said or (1 if count == 1 else None)
    if variant is None:
        message = f"it does not say which of the {count} variants it answers: the key 'variant' is missing"
        raise Unplaced(root.diagnostic(message), NO_VARIANT)
    return (exam.students[variant - 1] if exam.students else student), variant


def may_be_of(file: str, root: MappingNode | None, exam: Exam) -> str:
    """Return whose a file may be that is not marked: whom it names, else for whom a file was called so, else ""."""
    if root is not None and (said := student_in(root)):
        alike = spelt_alike(said, exam.students)
        return alike[0] if len(alike) == 1 else said
    called = {f"answers-{each.label}": each.student for each in exam.variants}
    return called.get(normalize("NFC", PurePath(file).stem), "")


def _variant_in(root: MappingNode, count: int) -> int | None:
    """Return the variant that a file names, None where it names none; raises Unplaced where there is no such one."""
    node = root.get("variant")
    if node is None or is_blank(node):
        return None
    try:
        return whole_number(node, "variant", 1, count)
    except Fault as fault:
        raise Unplaced(fault.diagnostics[0], ANOTHER_VARIANT) from None


def _nobody(root: MappingNode, student: str, alike: Sequence[str], students: Sequence[str]) -> Unplaced:
    """Return what is said of a name that is that of no student, or of several."""
    node = root["student"]
    if alike:
        message = f"'{student[:60]}' may be {' or '.join(each[:60] for each in alike)}"
        note = "write the name as the class writes it"
        return Unplaced(node.diagnostic(message, note=note), UNCLEAR)
    message = f"'{student[:60]}' is no student of this class"
    return Unplaced(node.diagnostic(message, suggestion=meant(student, students)), UNKNOWN)


def _of_another(node: Node, said: int, own: int, students: Sequence[str]) -> Diagnostic:
    """Return what is said where the student and the variant do not fit: either may be wrong."""
    student, other = students[own - 1], students[said - 1]
    message = f"{student} has variant {own}, not {said}"
    if _bare(student) == _bare(other):
        note = "write the student, or the variant, that is right"
        return node.diagnostic(f"{message}, which is that of {other}", note=note)
    return node.diagnostic(message, note="take out the line that is wrong")


def _exact(name: str) -> str:
    """Return a name as the table of a class has it."""
    return " ".join(normalize("NFC", name).split())


def _plain(name: str) -> str:
    """Return a name as it is compared: without capitals and joiners, and in one way of writing its letters."""
    seen = "".join(each for each in normalize("NFKC", name) if each not in JOINERS)
    return normalize("NFKC", " ".join(seen.casefold().split()))


def _bare(name: str) -> str:
    """Return a name without its accents, capitals and spaces."""
    letters = normalize("NFKD", _plain(name))
    return "".join(each for each in letters if not combining(each) and not each.isspace())
