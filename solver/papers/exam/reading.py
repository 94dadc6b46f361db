"""From the text of an exam file, and of the problem files that it names, to an `Exam`, or to all that is wrong."""

from __future__ import annotations

import re
from datetime import date
from pathlib import Path
from typing import TYPE_CHECKING

from solver.markup import images_in
from solver.papers.exam.model import Exam, Question
from solver.papers.exam.scaling import marks_told
from solver.papers.exam.shape import check_exam_shape
from solver.papers.exam.students import read_students
from solver.problem.files import load
from solver.problem.hundredths import HUNDRED
from solver.problem.lexicon import exact_number
from solver.problem.members import written
from solver.problem.nodes import TRUE, MappingNode, Node, ScalarNode, SequenceNode, whole_number
from solver.problem.other_files import EXAM, mistaken
from solver.problem.reader import problem_of, read_problem
from solver.problem.source import Fault, InputError, Report, Source
from solver.problem.texts import check_formulas
from solver.problem.yaml_tree import parse_yaml
from solver.tasks import catalogue

if TYPE_CHECKING:
    import sympy as sp

    from solver.problem.model import Problem

MOST_QUESTIONS = 60
MOST_VARIANTS = 10_000
MOST_MARKS = 10_000
_DAY = re.compile(r"\d{4}-\d{1,2}-\d{1,2}")
TEXTS = ("course", "date", "duration", "instructions")


class SeveralAtFault(InputError):  # noqa: N818 - named after what it is one of
    """Several files are at fault; each tells what is wrong with it."""

    def __init__(self, errors: list[InputError]) -> None:
        self.errors = errors
        super().__init__(errors[0].source, [each for error in errors for each in error.diagnostics])

    def render(self) -> str:
        """Return the errors of all files."""
        return "\n".join(dict.fromkeys(error.render() for error in self.errors))


def read_exam(source: Source) -> Exam:
    """Return the exam of a source; raises InputError with all that is wrong, with it and with the files it names."""
    root = parse_yaml(source)
    if not isinstance(root, MappingNode):
        message = f"an exam is a mapping with the keys 'exam' and 'questions', not {root.what[:40]}"
        raise InputError(source, [root.diagnostic(message)])
    if other := mistaken(source, root, EXAM):
        raise InputError(source, [other])
    if misshapen := check_exam_shape(root):
        raise InputError(source, [each.diagnostic for each in misshapen])
    return _ExamReader(source, root).exam()


def is_exam(root: Node) -> bool:
    """Whether what a file holds is meant as an exam."""
    return isinstance(root, MappingNode) and "exam" in root and "questions" in root


class _ExamReader:
    """Reads an exam whose shape is right. What is wrong is collected: `report` has it of the exam itself."""

    def __init__(self, source: Source, root: MappingNode) -> None:
        self.source = source
        self.root = root
        self.folder = Path() if source.name.startswith("<") else Path(source.name).parent
        self.report = Report()
        self.others: list[InputError] = []

    def exam(self) -> Exam:
        """Return the exam; raises InputError."""
        listed = self.root["questions"]
        items = listed.items if isinstance(listed, SequenceNode) else ()
        if len(items) > MOST_QUESTIONS:
            with self.report:
                raise listed.fault(f"an exam has at most {MOST_QUESTIONS} questions")
            items = items[:MOST_QUESTIONS]
        questions = [self.question(number, item) for number, item in enumerate(items, 1)]
        students, count = self.variants()
        seed = self.whole("seed", self.root, 1, None, None)
        self.cover()
        if self.report.diagnostics:
            self.others.insert(0, InputError(self.source, self.report.diagnostics))
        if self.others:
            raise self.others[0] if len(self.others) == 1 else SeveralAtFault(self.others)
        texts = {key: self.text(key) for key in TEXTS}
        read = tuple(question for question in questions if question is not None)
        return Exam(self.source, self.text("exam"), read, seed=seed, count=count, students=students, **texts)

    def text(self, key: str) -> str:
        """Return a text of the cover, or ""."""
        node = self.root.get(key)
        text = node.text.strip() if isinstance(node, ScalarNode) else ""
        return text if key == "instructions" else " ".join(text.split())

    def cover(self) -> None:
        """Report what is wrong with the texts of the cover."""
        with self.report:
            if not self.text("exam"):
                raise self.root["exam"].fault("the exam has no title")
        day = self.text("date")
        if _DAY.fullmatch(day):
            with self.report:
                try:
                    date.fromisoformat(day)
                except ValueError:
                    raise self.root["date"].fault(f"there is no {day}: it is written year-month-day") from None
        node = self.root.get("instructions")
        if isinstance(node, ScalarNode):
            check_formulas(node, self.source, self.report)
            if images_in(node.text):
                with self.report:
                    note = "put them into the statement of a question"
                    raise node.fault("the instructions of an exam have no images", note=note)

    def whole(self, key: str, holder: MappingNode, usual: int, least: int | None, most: int | None) -> int:
        """Return a whole number, the usual one where there is none or it is wrong."""
        node = holder.get(key)
        if node is not None:
            with self.report:
                return whole_number(node, key, least, most)
        return usual

    def question(self, number: int, item: Node) -> Question | None:
        """Return a question, None where it is wrong."""
        if not isinstance(item, MappingNode):
            raise AssertionError("the shape of a question was checked")
        node, marks, broken = item["problem"], self.marks(item), item.get("page_break")
        found = self.problem(number, node)
        if found is None:
            return None
        problem, told, alone = found
        if marks is not None and not sum(marks_told(problem)):
            with self.report:
                raise item["marks"].fault("there is nothing to scale: no part of this problem carries marks")
        on_new_page = isinstance(broken, ScalarNode) and broken.text in ("yes", *TRUE)
        return Question(number, problem, told, alone, node, marks, on_new_page)

    def marks(self, item: MappingNode) -> sp.Rational | None:
        """Return the marks of a question, None where it tells none."""
        node = item.get("marks")
        if node is None:
            return None
        with self.report:
            value = exact_number(node)
            if not 0 < value <= MOST_MARKS:
                raise node.fault(f"marks are a number greater than zero, and at most {MOST_MARKS}")
            if (value * HUNDRED).q != 1:
                raise node.fault("marks are told in hundredths at most", note="6.67, not 20/3")
            return value
        return None

    def problem(self, number: int, node: Node) -> tuple[Problem, Source, Source] | None:
        """Return a problem, what it was read from, and its own text; None where it is wrong."""
        try:
            if isinstance(node, MappingNode):
                problem = problem_of(self.source, node, catalogue())
                name = f"<question {number}>" if self.source.name.startswith("<") else f"question-{number}.yaml"
                return problem, self.source, Source(str(self.folder / name), written(node) + "\n")
            source = self.file(node)
            return read_problem(source, catalogue()), source, source
        except InputError as error:
            self.others.append(error)
        except Fault as fault:
            self.report.diagnostics.extend(fault.diagnostics)
        return None

    def file(self, node: Node) -> Source:
        """Return the text of the file that is named; raises Fault where it cannot be read, InputError for its text."""
        name = node.text.strip() if isinstance(node, ScalarNode) else ""
        try:
            return load(self.folder / name)
        except InputError as error:
            if error.source.text:
                raise
            found = error.diagnostics[0]
            suggestion = str(Path(name).with_name(Path(found.suggestion).name)) if found.suggestion else ""
            raise node.fault(f"'{name[:100]}': {found.message}", suggestion=suggestion) from None

    def variants(self) -> tuple[tuple[str, ...], int]:
        """Return the students, or none, and how many papers there are."""
        node = self.root.get("variants")
        if not isinstance(node, MappingNode):
            return (), 1
        named = [key for key in ("count", "students") if key in node]
        if len(named) != 1:
            with self.report:
                raise node.fault("either 'count' or 'students' is expected here", note="variants: {count: 4}")
        if named == ["students"]:
            try:
                students = read_students(self.file(_table(node["students"])))
                return students, len(students)
            except InputError as error:
                self.others.append(error)
            except Fault as fault:
                self.report.diagnostics.extend(fault.diagnostics)
            return (), 1
        return (), self.whole("count", node, 1, 1, MOST_VARIANTS)


def _table(node: Node) -> Node:
    """Return where a table is named; raises Fault for files that are none by their names."""
    ending = Path(node.text.strip()).suffix.lower() if isinstance(node, ScalarNode) else ""
    if ending in (".xlsx", ".xls", ".ods", ".numbers"):
        raise node.fault("this is a spreadsheet: save it as CSV in UTF-8, and name that", note="students: class.csv")
    if ending in (".yaml", ".yml", ".json"):
        raise node.fault("a table (CSV) is expected here, its first column the students", note="students: class.csv")
    return node


__all__ = ["SeveralAtFault", "is_exam", "read_exam"]
