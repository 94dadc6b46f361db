"""What is told at each level of detail, in every format: papers, keys, checks, sources, the answers asked for."""

import json
import re

import pytest

from solver.classroom import mark, read_submission
from solver.document.model import Presentation
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue

FORMATS = ["html", "latex", "md", "text"]
SYSTEM = "system: {A: [[0, 1], [2, 3]], B: [0, 1], C: [1, 0]}\n"
TEXT = f"""\
title: A paper
source: A book
{SYSTEM}find:
  a:
    task: pole_placement
    poles: [-1, -2]
    method: [ackermann, bass_gura]
    marks: 4
    answers: [K, closed_loop_A]
  b: stability
"""


def problem(text=TEXT):
    return read_problem(Source("file.yaml", text), catalogue())


def told(text=TEXT, **presentation):
    return document_of(solve_problem(problem(text)), Presentation(**presentation))


@pytest.fixture(scope="module")
def solved():
    return solve_problem(problem())


@pytest.fixture(scope="module")
def shown(solved):
    def write(format_, **presentation):
        return document_of(solved, Presentation(**presentation)).rendered(format_).decode()

    return write


@pytest.mark.parametrize("format_", FORMATS)
def test_a_paper_asks_each_part_once_and_gives_nothing_away(shown, format_):
    paper = " ".join(shown(format_, detail="question").split())
    assert paper.count("that places the closed-loop poles") == 1
    assert re.search(r"Ackermann.{1,7}s formula, Formula of Bass and Gura", paper)
    assert "4 marks" in paper
    body = paper.split(r"\begin{document}")[-1].split("</style>")[-1]
    for word in ("verified", "Answer", "passed", "unstable</", "Checks", "numpy", "Characteristic polynomial"):
        assert word not in body


@pytest.mark.parametrize("format_", FORMATS)
def test_a_key_has_the_answers_asked_for_their_marks_and_the_lines_that_earn_them(shown, solved, format_):
    key = shown(format_, detail="key")
    assert key.count("[2]" if format_ == "text" else "2 marks") == 4  # two answers by two methods
    assert "numpy" not in key
    assert "verified:" not in key  # nothing follows: a key counts no checks
    document = document_of(solved, Presentation("key"))
    assert [[answer.name for answer in part.answers] for part in document.parts[:2]] == [["K", "closed_loop_A"]] * 2
    assert all(len(part.steps) < len(result.steps) for part, result in zip(document.parts, solved.parts, strict=True))
    assert all(not step.steps for part in document.parts for step in part.steps)
    assert r"K_f = q\,\hat{p}(A) = " in document.parts[0].answers[0].derived


@pytest.mark.parametrize("format_", FORMATS)
def test_checks_are_told_as_a_table_as_a_summary_or_not_at_all(shown, format_):
    none, summary, table = (shown(format_, checks=checks) for checks in ("none", "summary", "table"))
    assert len(none) <= len(summary) <= len(table)
    assert "numpy" in table
    if format_ == "html":  # folded away
        assert '<details class="checks">' in summary
        assert '<details class="checks" open>' in table
        assert '<details class="checks"' not in none
    else:
        assert "numpy" not in summary
        assert re.search(r"Checks: \d+ passed\.|\d+ of \d+ checks passed", summary)
    assert shown(format_) == summary


@pytest.mark.parametrize("format_", FORMATS)
def test_sources_can_be_left_out(shown, format_):
    assert "A book" in shown(format_)
    assert "Lecture note" in shown(format_)
    assert "A book" not in shown(format_, sources=False)
    assert "Lecture note" not in shown(format_, sources=False)


@pytest.mark.parametrize("format_", FORMATS)
def test_a_paper_leaves_out_what_would_give_it_away(format_):
    text = TEXT.replace("find:", "show: {source: false}\nfind:").replace("marks: 4", "show: {method: false}")
    paper = told(text, detail="question").rendered(format_).decode()
    assert "Ackermann" not in paper
    assert "A book" not in paper
    assert "Lecture note" not in paper
    full = told(text).rendered(format_).decode()
    assert "Ackermann" in full
    assert "A book" in full


def test_what_is_given_can_be_left_to_the_statement():
    assert told().given
    assert not told(TEXT.replace("find:", "show: {system: false}\nfind:")).given
    part = "  c: {task: stability, show: {system: false}, system: {matrix: [[5]]}}\n"
    assert told(TEXT + part).parts[-1].given == ""
    assert told(TEXT + part.replace("show: {system: false}, ", "")).parts[-1].given


def test_the_question_names_the_answers_that_are_asked_for():
    assert "Give $K_f$ (the gain of the feedback) and $A - BK_f$ (the matrix of the closed loop)." in told().parts[
        0
    ].question.replace("\n", " ")
    assert "Give" not in told(TEXT.replace("    answers: [K, closed_loop_A]\n", "")).parts[0].question


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (("[K, closed_loop_A]", "[K, closed_lop_A]"), ("9:18", "no answer 'closed_lop_A'", "'closed_loop_A'?")),
        (("[K, closed_loop_A]", "[K, K]"), ("9:18", "asked for twice")),
        (("[K, closed_loop_A]", "[]"), ("9:14", "no answer is named here")),
        (("marks: 4", "show: {methd: false}"), ("8:12", "unknown key 'methd'", "'method'?")),
        (("marks: 4", "show: {method: perhaps}"), ("8:20", "true or false is expected")),
    ],
)
def test_a_mistake_in_what_is_asked_or_shown_is_refused_at_its_place(change, words):
    text = TEXT.replace(*change).replace("source: A book\n", "")
    with pytest.raises(InputError) as caught:
        problem(text)
    assert all(word in caught.value.render() for word in words), caught.value.render()


def test_json_has_the_question_the_system_the_marks_and_the_numbers():
    data = json.loads(told(data=True).json())
    first, second, third = data["parts"]
    assert first["question"] == second["question"]
    assert "closed-loop poles" in first["question"]
    assert first["system"] == {
        "A": "Matrix([[0, 1], [2, 3]])", "B": "Matrix([[0], [1]])", "C": "Matrix([[1, 0]])", "D": "Matrix([[0]])",
    }  # fmt: skip
    assert (first["marks"], first["out_of"], third["out_of"]) == (4, 4, 0)
    assert first["answers"]["K"]["numeric"] == [[4, 6]]
    assert "numeric" not in first["answers"]["polynomial"]
    assert "numeric" not in third["answers"]["verdict"]
    assert third["answers"]["eigenvalues"]["numeric"] == pytest.approx([(3 - 17**0.5) / 2, (3 + 17**0.5) / 2])


def test_complex_numbers_are_pairs_and_a_problem_without_marks_counts_one_a_part():
    data = json.loads(told("system: {matrix: [[0, 1], [-1, 0]]}\nfind: {a: stability}\n", data=True).json())
    assert sorted(data["parts"][0]["answers"]["eigenvalues"]["numeric"]) == [[0.0, -1.0], [0.0, 1.0]]
    assert data["parts"][0]["out_of"] == 1


def test_a_matrix_with_a_symbol_in_one_entry_has_no_numbers():
    text = "system: {A: [[0, 1], [a, 2]], B: [0, 1], C: [1, 0]}\nfind: {a: {task: pole_placement, poles: [-1, -2]}}\n"
    answers = json.loads(told(text, data=True).json())["parts"][0]["answers"]
    assert "a" in answers["K"]["value"]
    assert "numeric" not in answers["K"]
    assert answers["closed_loop_A"]["numeric"] == [[0, 1], [-2, -3]]


def test_the_marks_are_those_of_the_answers_asked_for(solved):
    submission = "answers: {a: {K: [[4, 6]], polynomial: s^2 + 3s + 2}}\n"
    marking = mark(solved, read_submission(Source("answers.yaml", submission), solved.problem))
    assert (marking.parts[0].marks, marking.parts[0].out_of) == (2, 4)


def test_a_part_has_an_anchor_of_letters_digits_and_hyphens():
    text = TEXT.replace("  b: stability", "  b_2: stability")
    assert [part.anchor for part in told(text).parts] == [
        "part-a-ackermann",
        "part-a-bass-gura",
        "part-b-2-eigenvalues",
    ]


def test_a_part_without_marks_counts_as_one_where_no_part_has_any():
    assert [part.out_of for part in told().parts] == [4, 4, 0]
    assert [part.out_of for part in told(TEXT.replace("    marks: 4\n", "")).parts] == [1, 1, 1]


REGULATOR = """title: Regulator
system: {A: [[0, 1], [0, 0]], B: [0, 1], C: [1, 0]}
find:
  a: {task: lqr, Q: [[4, 0], [0, 1]], R: 1}
  b: {task: lqr, tolerances: [1, 2], R: 1}
  c: {task: lqr, Q: [[4, 0], [0, 1]], R: 1, answers: [Q, K]}
"""


def test_what_is_given_is_no_answer_unless_it_is_asked_for():
    shown = [{answer.name for answer in part.found} & {"Q", "R"} for part in told(REGULATOR).parts]
    assert shown == [set(), {"Q"}, {"Q"}]
    assert all({"Q", "R"} <= {answer.name for answer in part.answers} for part in told(REGULATOR).parts)


@pytest.mark.parametrize(
    ("format_", "boxed"),
    [
        ("html", "the weight of the state</p>"),
        ("text", "Answer: the weight of the state"),
        ("latex", "Q ="),
        ("md", "Q ="),
    ],
)
def test_every_format_leaves_out_what_is_given(format_, boxed):
    given = REGULATOR.partition("  b:")[0]
    asked = given.replace("R: 1}", "R: 1, answers: [Q, K]}")
    shown = [told(text).rendered(format_).decode().count(boxed) for text in (given, asked)]
    assert shown[1] == shown[0] + 1
