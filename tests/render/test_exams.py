"""Papers and keys by TeX and by typst: hostile names stand as they are, space for answers, templates of one's own."""

import re
import shutil
import subprocess
from dataclasses import replace
from fractions import Fraction

import pytest

from solver import solve
from solver.document.exam import ExamDocument, ExamQuestion, as_question
from solver.document.model import Presentation
from solver.render import pdf
from solver.render.exam import exam_latex, exam_page, exam_pdf, exam_typst
from tests.document.test_images import PNG
from tests.render.test_documents import HOSTILE
from tests.render.test_typst import streams

NAMES = ('Doe, Jo \\ #panic() $a$ "q" @b {_^~%&}', "李明 🙂 עברית", "=cmd|' /C calc'!A0", "<b>Müller</b> -- Søn", "")

PROBLEM = """\
title: 'A \\ #title $x$'
statement: '![a circuit](a.png) of $x$'
system: {A: [[0, 1], [-2, -3]], B: [0, 1]}
find:
  a: {task: stability, marks: 2}
  b: {task: bode, system: {transfer_function: "1/(s+1)"}, marks: 3}
"""


@pytest.fixture(scope="module")
def told(tmp_path_factory):
    """Return an exam of two questions that are told as in a paper or as a key."""
    folder = tmp_path_factory.mktemp("exam")
    (folder / "a.png").write_bytes(PNG)
    (folder / "p.yaml").write_text(PROBLEM, "utf-8")
    (folder / "q.yaml").write_text(PROBLEM.replace("![a circuit](a.png)", "no picture"), "utf-8")
    solved = [solve(folder / name) for name in ("p.yaml", "q.yaml")]

    def of(detail="question", student="", **of):
        presentation = Presentation(detail, checks="", pdf_engine=of.pop("engine", None), templates=of.pop("own", None))
        shown = [as_question(each.told(detail=detail), n) for n, each in enumerate(solved, 1)]
        shown = [replace(each, presentation=replace(each.presentation, templates=None)) for each in shown]
        questions = tuple(ExamQuestion(n, each.title, "5", each, n == 2) for n, each in enumerate(shown, 1))
        cover = {"course": "EE & 451", "date": "2026", "duration": "1 h", "instructions": HOSTILE, "total": "10"}
        return ExamDocument(
            "Final #x $", questions=questions, student=student, variant="1", presentation=presentation, **cover, **of
        )

    return of


def words_of(content, path):
    """Return the words that a PDF shows."""
    path.write_bytes(content)
    done = subprocess.run(
        [shutil.which("pdftotext") or "pdftotext", "-layout", path, "-"], capture_output=True, check=True
    )
    return " ".join(done.stdout.decode().split())


@pytest.mark.usefixtures("typst", "tex")
@pytest.mark.parametrize("engine", pdf.ENGINES)
@pytest.mark.parametrize("student", NAMES)
def test_names_stand_as_they_are(told, tmp_path, engine, student):
    words = words_of(exam_pdf(told(student=student, engine=engine)), tmp_path / "a.pdf")
    assert "EE & 451" in words
    assert "Final #x $" in words
    assert r"1. A \ #title $x$ 5 marks" in words
    if student.isascii():
        assert student.replace("'", "’") in words.replace("'", "’")
    assert "Answer key" not in words


@pytest.mark.usefixtures("typst", "tex")
def test_a_key_has_its_marks_pictures_and_figures_by_both_engines(told, tmp_path):
    for engine in pdf.ENGINES:
        content = exam_pdf(told("full", engine=engine))
        words = words_of(content, tmp_path / "a.pdf")
        assert "Answer key" in words
        assert "2. A" in words
        assert words.count("2 marks") >= 4  # of the part, and of its answer, in both questions
        assert "asymptotically stable" in words
    said = streams(content)
    assert b"a circuit" in said
    assert b"pdfuaid:part" in said


def test_the_name_of_a_picture_is_that_of_its_question(told):
    first, second = exam_typst(told()).split("#let given = given-of(")[1:]
    assert first.startswith('("a.png": ')
    assert second.startswith("(:)")
    assert '#given("a.png", "a circuit")' in first


@pytest.mark.parametrize(
    ("kind", "name", "write"),
    [
        ("html", "exam.html.jinja", exam_page),
        ("latex", "exam.tex.jinja", exam_latex),
        ("typst", "exam.typ.jinja", exam_typst),
    ],
)
def test_layouts_can_be_replaced(told, tmp_path, kind, name, write):
    (tmp_path / kind).mkdir()
    value = r"\VAR{ exam.total }" if kind == "latex" else "{{ exam.total }}"
    (tmp_path / kind / name).write_text(f"own {value}", "utf-8")
    assert write(told(own=tmp_path)).strip() == "own 10"


@pytest.mark.parametrize(("kind", "ending", "write"), [("latex", "tex", exam_latex), ("typst", "typ", exam_typst)])
def test_what_a_layout_includes_can_be_replaced_alone(told, tmp_path, kind, ending, write):
    (tmp_path / kind).mkdir()
    (tmp_path / kind / f"parts.{ending}.jinja").write_text("own parts", "utf-8")
    written = write(told(own=tmp_path))
    assert written.count("own parts") == 2
    assert "stability" not in written.lower()


def test_space_for_answers_goes_by_the_marks_and_stands_in_papers_only(told):
    paper, key = told(space=Fraction(15, 2)), told("key", space=Fraction(30))
    assert [paper.room(each.document, part) for each in paper.questions for part in each.document.parts] == [20, 22] * 2
    assert [told(space=Fraction(0)).room(paper.questions[0].document, paper.questions[0].document.parts[0])] == [20]
    for write, sign in (
        (exam_page, '<div class="room"'),
        (exam_latex, r"\answerroom{"),
        (exam_typst, "#answer-room(2"),
    ):
        assert (write(paper).count(sign), write(key).count(sign), write(told()).count(sign)) == (4, 0, 0)


@pytest.mark.usefixtures("typst", "tex")
@pytest.mark.parametrize("engine", pdf.ENGINES)
def test_space_goes_on_overleaf(told, tmp_path, engine):
    """Two questions of 5 marks at 100 mm a mark are a metre of paper: four pages and what is asked."""
    content = exam_pdf(told(space=Fraction(100), engine=engine))
    (tmp_path / "a.pdf").write_bytes(content)
    said = subprocess.run(
        [shutil.which("pdfinfo") or "pdfinfo", tmp_path / "a.pdf"], capture_output=True, check=True, text=True
    )
    assert 5 <= int(re.search(r"Pages: +(\d+)", said.stdout)[1]) <= 7
