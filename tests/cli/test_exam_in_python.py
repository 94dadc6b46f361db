"""Exams in Python: the same bytes as the command line's, and errors with their places as exceptions."""

import csv
import io
import json
import re
import zipfile

import pytest

import solver
from solver.papers.interface.exams import PaperError
from solver.problem.source import InputError
from tests.cli.test_exam import written
from tests.papers.conftest import FAMILY
from tests.papers.exams import EXAM, write_exam

CLASS = EXAM.replace("count: 2", "students: class.csv")
SMALL = {
    "exam": "Small",
    "questions": [{"problem": {"system": {"A": [[0, 1], [-2, -3]]}, "find": {"a": "stability"}}, "marks": 4}],
}


@pytest.fixture
def in_folder(tmp_path):
    """Write an exam of a class of three."""
    (tmp_path / "class.csv").write_text("student\nAnna\n=Ben\nCleo\n", encoding="utf-8")
    write_exam(tmp_path, CLASS)


def filled(folder, name, text):
    """Write an answer file beside those to fill in."""
    (folder / f"{name}.yaml").write_text(text, encoding="utf-8")


def test_a_class_is_examined_as_on_the_command_line(solve, in_folder, tmp_path):
    assert solve("exam", "exam.yaml", "-o", "by-command", "-f", "html,latex", "--jobs", 1).code == 0
    told = []
    papers = solver.exam("exam.yaml", formats=("html", "latex"), progress=lambda *each: told.append(each))
    papers.write("in-python")
    assert written(tmp_path / "in-python") == written(tmp_path / "by-command")
    assert [each.student for each in papers.variants] == ["Anna", "=Ben", "Cleo"]
    assert set(papers.values["Anna"]) == {"1.a", "1.b", "1.p"}
    assert told[0][1] == 5
    assert told[-1] == (2, 3, "writing")
    assert "srcdoc" in papers._repr_html_()
    assert repr(papers) == "<exam 'Final <exam>': 3 papers, all verified>"
    assert "exam:" not in papers.files()["answers/answers-Anna.yaml"].decode()


def test_the_bank_is_that_of_the_command_line(solve, tmp_path):
    """One of a question with one right answer, and of one whose answers are judged."""
    questions = [{"problem": {**SMALL["questions"][0]["problem"], "find": {"a": "eigenstructure"}}}]
    (tmp_path / "exam.yaml").write_text(json.dumps({**SMALL, "questions": questions}), encoding="utf-8")
    assert solve("exam", "exam.yaml", "-o", "banks", "--export", "moodle,qti,canvas", "--jobs", 1).code == 0
    bank = solver.exam_bank("exam.yaml")
    assert bank.content("moodle") == (tmp_path / "banks/exam-moodle.xml").read_bytes()
    for system in ("qti", "canvas"):
        (tmp_path / "bank.zip").write_bytes(bank.content(system))
        assert contents(tmp_path / "bank.zip") == contents(tmp_path / f"banks/exam-{system}.zip")
    assert repr(bank).startswith("<bank of 'Small': ")
    assert bank.essays
    assert not bank.left_out
    with pytest.raises(ValueError, match="there are moodle, qti, canvas"):
        bank.content("blackboard")


def contents(path):
    with zipfile.ZipFile(path) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def test_a_class_is_marked_as_on_the_command_line(solve, in_folder, tmp_path):
    (tmp_path / "in").mkdir()
    head = "answers: {2: {a: {verdict: unstable}, b: {poles: [-4], zeros: []}}}\n"
    filled(tmp_path / "in", "anna", f"student: anna\n{head}")
    filled(tmp_path / "in", "ben", f"student: Benn\n{head}")
    filled(tmp_path / "in", "none", "answers: [")
    done = solve(
        "check", "exam.yaml", "in", "-f", "json", "--csv", "grades.csv", "--report", "report.html", "--jobs", 1
    )
    marked = solver.check_exam("exam.yaml", "in")
    assert marked.grades() == (tmp_path / "grades.csv").read_text(encoding="utf-8")
    assert marked.report() == (tmp_path / "report.html").read_text(encoding="utf-8")
    assert marked.data() == json.loads(done.out)
    assert marked.missing == ["=Ben", "Cleo"]
    assert "is no student of this class" in marked.papers[1].fault
    assert repr(marked) == "<exam 'Final <exam>': 1 of 3 files marked>"
    assert marked._repr_html_().startswith("<iframe ")


def test_a_sheet_is_that_of_the_command_line(solve, tmp_path):
    (tmp_path / "small.yaml").write_text(json.dumps(SMALL), encoding="utf-8")
    filled(tmp_path, "anna", "student: Anna\nanswers: {1: {a: {verdict: unstable}}}\n")
    named = "small.yaml", "anna.yaml"
    solve("check", *named, "-f", "html", "-o", "sheet.html", "--answers", "--solution", "--jobs", 1)
    marked = solver.check_exam(*named, solution=True)
    sheet = (tmp_path / "sheet.html").read_text(encoding="utf-8")
    assert marked.sheet("Anna", answers=True) == marked.sheet("anna.yaml", answers=True) == sheet
    with pytest.raises(KeyError, match="no student 'Dora'"):
        marked.sheet("Dora")


def test_an_exam_and_its_answers_may_be_data(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    papers = solver.exam({**SMALL, "variants": {"count": 1}})
    assert sorted(papers.files("build")) == [
        "answers/answers-1.yaml", "keys/key-1.html", "papers/paper-1.html", "variants.csv",
    ]  # fmt: skip
    sheet = next(path for path in papers.write("build") if path.suffix == ".yaml")
    sheet.write_text("answers: {1: {a: {verdict: stable}}}\n", encoding="utf-8")
    assert sheet not in papers.write("build")
    assert "verdict: stable" in sheet.read_text(encoding="utf-8")
    answers = {
        "Ada": {1: {"a": {"verdict": "asymptotically stable"}}},
        "Bob": {"1": {"a": {"verdict": "unstable"}}},
        "Cy": 5,
    }
    marked = solver.check_exam(SMALL, answers, partial_credit="none")
    assert [each.marking and each.marking.marks for each in marked.papers] == [4, 0, None]
    changes = "changes:\n  Bob: {1.a: {verdict: {marks: 3, comment: well argued}}}\n"
    marked = solver.check_exam(SMALL, answers, override=changes)
    assert [each.marking and each.marking.marks for each in marked.papers] == [4, 3, None]
    with pytest.raises(InputError, match="Rob"):
        solver.check_exam(SMALL, answers, override=changes.replace("Bob", "Rob"))
    assert "<Cy>: at answers: error: 'answers:' must list" in marked.papers[2].fault


def test_sheet_table_and_data_tell_the_same_marks():
    asked = "task: eigenstructure, answers: [eigenvalues, diagonalizable]"
    find = f"{{a: {{{asked}, marks: 10}}, b: {{{asked}, marks: 8}}}}"
    exam = f"exam: E\nquestions:\n  - {{marks: 20, problem: {{system: {{matrix: [[1, 2], [0, 3]]}}, find: {find}}}}}\n"
    half = {"eigenvalues": [1, 3], "diagonalizable": False}
    marked = solver.check_exam(exam, {"Ada": {1: {"a": half, "b": half}}})
    row = next(csv.DictReader(io.StringIO(marked.grades())))
    shown = re.findall(r'class="marks">([\d.]+) of ([\d.]+)<', marked.sheet("Ada"))
    of_question, of_a, *a, of_b, of_b1, of_b2 = [earned for earned, _ in shown]
    assert [of_question, of_a, of_b] == [row["1"], row["1.a"], row["1.b"]] == ["10.01", "5.56", "4.45"]
    assert (*a, of_b1, of_b2) == ("5.56", "0", "4.45", "0")
    assert [whole for _, whole in shown] == ["20", "11.11", "5.56", "5.55", "8.89", "4.45", "4.44"]
    assert [part["marks"] for part in marked.data()[0]["parts"]] == [5.56, 4.45]


def test_answers_as_data_say_their_variant():
    exam = {**SMALL, "variants": {"count": 2}}
    said = {1: {"a": {"verdict": "asymptotically stable"}}}
    marked = solver.check_exam(exam, {"Ada": {"variant": 2, "answers": said}, "Bob": said})
    ada, bob = marked.papers
    assert (ada.variant, ada.marking and ada.marking.marks) == (2, 4)
    assert "the key 'variant' is missing" in bob.fault


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (EXAM.replace("family.yaml", "famly.yaml"), "exam.yaml:8:15: error: 'famly.yaml': there is no such file"),
        (EXAM.replace("marks: 10", "marks: -1"), "exam.yaml:8:35: error: marks are a number greater than zero"),
        (EXAM, "family.yaml:7:"),
    ],
)
def test_what_is_wrong_is_raised_with_its_place(tmp_path, monkeypatch, text, told):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError) as caught:
        solver.exam(write_exam(tmp_path, text, family=FAMILY.replace("a != 2", "a > 5")))
    assert told in caught.value.render()


def test_a_question_that_is_not_verified_is_told_where_the_exam_names_it(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    unsolved = "system: {A: [[1, 0], [0, 2]], B: [0, 1]}\nfind: {a: {task: pole_placement, poles: [-1, -2]}}\n"
    text = "exam: One\nquestions: [{problem: step.yaml}]\n"
    with pytest.raises(InputError, match=r"question 1 is unsolved: .*controllable") as caught:
        solver.exam(write_exam(tmp_path, text, step=unsolved))
    assert "exam.yaml:2:23: error" in caught.value.render()


def test_a_page_that_cannot_be_made_is_told(tmp_path):
    (tmp_path / "html").mkdir()
    (tmp_path / "html" / "exam.html.jinja").write_text("{{ nothing.at.all }}", encoding="utf-8")
    with pytest.raises(PaperError, match=r"cannot make the paper: .*nothing"):
        solver.exam(SMALL, templates=tmp_path)
    with pytest.raises(ValueError, match="no format 'docx'; there are html, pdf, latex"):
        solver.exam(SMALL, formats=("docx",))


def test_where_there_is_nothing_to_mark_it_is_said(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "empty").mkdir()
    for answers, told in (
        ("nowhere/", "nowhere: error: there is no such file"),
        ("a.yaml", "a.yaml: error: there is no such file"),
        ("empty", "empty: error: there is no answer file in this folder; they end in .yaml"),
    ):
        with pytest.raises(InputError) as caught:
            solver.check_exam(write_exam(tmp_path), answers)
        assert caught.value.render().startswith(told)
