"""The files of an exam: papers, keys, files to fill in, and the table of who has which."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from solver.classroom.blank import HOW, comment, quoted
from solver.classroom.report.table import harmless
from solver.document.exam import ExamDocument, ExamQuestion
from solver.document.model import Document
from solver.limits import Exceeded
from solver.papers.exam.drawing import Drawn, Means, asked_of
from solver.papers.exam.model import Exam, Question, Variant
from solver.papers.exam.packed import opened
from solver.papers.exam.scaling import scaled
from solver.papers.kept import facts_of
from solver.render.exam import EXAM_FORMATS
from solver.render.numbers import NumberFormat
from solver.words import Phrase

PAPERS, KEYS, ANSWERS = "papers", "keys", "answers"
"""The folders: who puts the papers where students find them puts no key there."""


@dataclass(frozen=True, slots=True)
class Files:
    """The files of a variant by their paths below the folder of the exam, or why there are none.

    Where they are there already, `unchanged`, there are no contents.
    """

    variant: Variant
    contents: Mapping[str, bytes]
    fault: str = ""
    unchanged: bool = False


def files_of(
    exam: Exam,
    variants: Sequence[Sequence[Drawn]],
    formats: Sequence[str],
    means: Means,
    is_there: Callable[[Variant], bool] = lambda _: False,
) -> Iterator[Files]:
    """Yield the papers and the keys in all formats, in the order of the variants; they are written by processes.

    Those that are there already are not written again.
    """
    there = {variant.label for variant in exam.variants if is_there(variant)}
    marks = {each.number: _marks_of(each) for each in exam.questions}
    covers = _covers(exam, _text(sum(marks.values())), means)
    calls = (
        (*_covers_of(variant, len(exam.variants), covers), variant.label, tuple(formats),
         tuple(_placed(each, _text(marks[each.question.number])) for each in questions))
        for variant, questions in zip(exam.variants, variants, strict=True) if variant.label not in there
    )  # fmt: skip
    limits = means.limits.times(2 * len(exam.questions))
    results = means.executor.in_order(limits, _written, calls)
    for variant in exam.variants:
        if variant.label in there:
            yield Files(variant, {}, unchanged=True)
            continue
        result = next(results)
        is_written = not isinstance(result, Exceeded | str)
        fault = "" if is_written else getattr(result, "reason", result)
        yield Files(variant, result if is_written else {}, str(fault))


def facts_of_paper(
    exam: Exam, variant: Variant, questions: Sequence[Drawn], formats: Sequence[str], means: Means
) -> Any:
    """Return what the paper and the key of a variant depend on."""
    asked = [(facts_of(each.question.problem, each.question.source.name, asked_of(each.question, means)), each.text,
              each.question.title, each.question.page_break) for each in questions]  # fmt: skip
    cover = (exam.title, exam.course, exam.date, exam.duration, exam.instructions, len(exam.variants))
    return [asked, cover, variant.number, variant.student, list(formats), repr(means.presentation), str(means.space)]


@dataclass(frozen=True, slots=True)
class Placed:
    """A question as it is sent to who writes it: `told` as a paper and a key tell it, packed; see `ExamQuestion`."""

    number: int
    title: str
    marks: str
    page_break: bool
    told: bytes | tuple[Document, Document]


def _written(
    paper: ExamDocument, key: ExamDocument, label: str, formats: Sequence[str], placed: Sequence[Placed]
) -> dict[str, bytes] | str:
    """Return the files of a paper and its key, or what is wrong with the templates or TeX, in words."""
    from jinja2 import TemplateError  # noqa: PLC0415 - only who writes needs it

    from solver.render.pdf import PdfUnavailable  # noqa: PLC0415 - as above

    files: dict[str, bytes] = {}
    documents = zip(*(opened(each.told) for each in placed), strict=True)
    try:
        for folder, stem, cover, told in zip((PAPERS, KEYS), ("paper", "key"), (paper, key), documents, strict=True):
            whole = _with_questions(cover, placed, told)
            for name in formats:
                format_ = EXAM_FORMATS[name]
                files[f"{folder}/{stem}-{label}{format_.suffix}"] = format_.write(whole)
                files |= {f"{folder}/{each}": content for each, content in format_.beside(whole).items()}
    except (PdfUnavailable, TemplateError) as error:
        return str(error)
    return files


def _with_questions(cover: ExamDocument, placed: Sequence[Placed], documents: Sequence[Document]) -> ExamDocument:
    """Return a paper or a key with its questions."""
    questions = tuple(
        ExamQuestion(each.number, each.title, each.marks, document, each.page_break)
        for each, document in zip(placed, documents, strict=True)
    )
    return replace(cover, questions=questions, messages=questions[0].document.messages)


def _covers(exam: Exam, total: str, means: Means) -> tuple[ExamDocument, ExamDocument]:
    """Return a paper, in which no answer is, and a key, as much of it as the presentation tells: without questions."""
    key = ExamDocument(
        title=exam.title,
        course=exam.course,
        date=exam.date,
        duration=exam.duration,
        instructions=exam.instructions,
        total=total,
        questions=(),
        presentation=means.presentation,
    )
    told = replace(means.presentation, detail="question", checks="")
    return replace(key, presentation=told, space=means.space), key


def _covers_of(variant: Variant, variants: int, covers: Sequence[ExamDocument]) -> Iterator[ExamDocument]:
    """Yield the covers of a variant."""
    for each in covers:
        yield replace(each, variant=str(variant.number) if variants > 1 else "", student=variant.student)


def _placed(each: Drawn, marks: str) -> Placed:
    question = each.question
    return Placed(question.number, question.title, marks, question.page_break, each.made.told)


def _marks_of(question: Question) -> Any:
    """Return the marks of a question."""
    return sum(part.marks for part in scaled(question.problem, question.marks).parts if part.marks is not None)


def _text(marks: Any) -> str:
    return NumberFormat("decimal", 8).text(marks)


def answer_file(exam: Exam, named: str, variant: Variant, questions: Sequence[Drawn]) -> str:
    """Return the file that a student fills in; `named` is the exam as it is found from there."""
    made = [each.made for each in questions]
    say = made[0].messages.say
    lines = [*comment(exam.title), *comment(say(HOW))]
    lines += [" ".join(["exam:", quoted(named)])] if named else []
    lines += [f"variant: {variant.number}"]
    lines += [f"student: {quoted(variant.student)}" if variant.student else "student:", "answers:"]
    for each, told in zip(questions, made, strict=True):
        number = each.question.number
        heading = say(Phrase("Question {number}", number=number))
        lines += ["", *comment(f"{heading}. {each.question.title}".removesuffix(" "), "  ")]
        lines += [f"  {number}:", *(f"  {line}" if line else line for line in told.sheet.split("\n"))]
    return "\n".join(lines) + "\n"


def variants_table(exam: Exam, variants: Sequence[Sequence[Drawn]]) -> str:
    """Return who has which variant, and the values drawn: CSV with a column for each name, as `1.a`."""
    content = io.StringIO()
    writer = csv.writer(content, lineterminator="\n")
    names = [(each.question.number, name) for each in variants[0] for name in each.values]
    writer.writerow(["student", "variant", *(f"{number}.{name}" for number, name in names)])
    for variant, questions in zip(exam.variants, variants, strict=True):
        values = {(each.question.number, name): text for each in questions for name, text in each.values.items()}
        writer.writerow([harmless(variant.student), variant.number, *(_cell(values[name]) for name in names)])
    return content.getvalue()


def _cell(text: str) -> str:
    """Return a value that was drawn: a plain number as it is, anything else as no formula of a spreadsheet."""
    return text if text.removeprefix("-").replace(".", "", 1).isdecimal() else harmless(text)
