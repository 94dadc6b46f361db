"""A solution as plain text and as a summary; prose in Markdown as plain text."""

import io
from dataclasses import replace

import pytest
from rich.console import Console

from solver.document.model import Presentation
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.formula.terminal.boxes import cells
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.render.prose import inline_as_text, to_text
from solver.render.terminal import answer_lines, print_summary, text_document
from solver.tasks import catalogue

PROBLEM = """\
title: A problem
source: Exam 3
statement: |
  Find it, with $\\dot{x} = A x$.
system: {A: [[0, 1], [-2, -3]]}
find:
  a: {task: characteristic_polynomial, marks: 2.5}
  b: {task: state_transition_matrix, method: [laplace, modal], marks: 1}
"""


@pytest.fixture(scope="module")
def view():
    return document_of(solve_problem(read_problem(Source("<test>", PROBLEM), catalogue())))


def printed(view, verbose=False, **options):
    console = Console(file=io.StringIO(), width=100, highlight=False, **options)
    print_summary(view, console, verbose=verbose)
    return console.file.getvalue()


def test_the_summary_has_every_part_with_answers_and_verdict(view):
    text = printed(view)
    assert "a  Characteristic polynomial" in text
    assert "[2.5 marks]" in text
    assert "[1 mark]" in text
    assert "χ(λ) = λ² + 3λ + 2" in text
    assert text.count("verified: ") == 3
    assert "⎡ 2e⁻ᵗ − e⁻²ᵗ" in text
    assert "scipy.linalg.expm" not in text
    assert "scipy.linalg.expm" in printed(view, verbose=True)


@pytest.mark.parametrize("title", ["x ∈ [a, b]", "both [/bold]", "at :smile: last", "[/b] " * 40])
def test_a_title_is_told_as_it_is_written(view, title):
    """Brackets and colons mean nothing; one that is too long for the line is cut."""
    head, *_ = printed(replace(view, title=title)).splitlines()
    told, dots, _ = head.partition("…")
    assert told.rstrip("─ ") == title if len(title) < 100 else dots and title.startswith(told)
    assert cells(head) == 100


def test_a_text_cannot_act_on_the_terminal(view):
    evil = "\x1b[31mred\x07\u202e"
    odd = replace(view, title=evil, source=evil, statement=f"{evil} ${evil}$\n\n`{evil}`")
    text = printed(odd) + text_document(odd)
    assert "red" in text
    assert not {"\x1b", "\x07", "\u202e"} & set(text)


def test_colours_are_for_terminals_only(view):
    assert "\x1b[32mverified" in printed(
        view, force_terminal=True, color_system="standard", no_color=False, _environ={}
    )


def test_the_document_has_everything_the_page_has(view):
    text = text_document(view)
    for piece in ("Exam 3", "Find it, with ẋ = Ax.", "(a) Characteristic polynomial", "1. ", "Answer: "):
        assert piece in text
    assert "checks passed" in text
    assert "passed: " in text_document(replace(view, presentation=Presentation(checks="table")))
    for part in view.parts:
        assert all(inline_as_text(step.title) in text for step in part.steps)
    assert "$" not in text
    assert "\\" not in text


def test_lines_fit_the_width_where_formulas_allow_it(view):
    assert all(cells(line) <= 100 or "residual" in line for line in text_document(view).splitlines())


PROSE = {
    "One *word* and **another**, `code`.": "One word and another, code.",
    "a\n\nb": "a\n\nb",
    "- one\n- two $x^2$\n": "• one\n• two x²",
    "3. three\n4. four\n": "3. three\n4. four",
    "Text $$\\frac{a}{b}$$ goes on": "Text\n\n    a\n    ─\n    b\n\ngoes on",
    "$$\nx = 1\n$$": "    x = 1",
    "> quoted": "  quoted",
    "```\nx  y\n```": "    x  y",
    "| a | $b_1$ |\n|---|---|\n| long | 2 |\n": "a     b₁\n────  ──\nlong  2",
    "# Heading": "Heading",
    "a<br>b": "a<br>b",
}


@pytest.mark.parametrize("markdown", PROSE)
def test_prose_as_text(markdown):
    assert to_text(markdown, 60) == PROSE[markdown]


def test_a_paragraph_is_wrapped_but_not_inside_a_short_formula():
    lines = to_text("word " * 9 + "$a + b + c + d$ and so on", 50).split("\n")
    assert len(lines) == 2
    assert lines[1].startswith("a + b + c + d and")


def test_a_formula_that_is_too_wide_is_written_on_wrapped_lines():
    wide = " & ".join(["x_1 + x_2"] * 12)
    lines = to_text(f"$$\\begin{{bmatrix}}{wide}\\end{{bmatrix}}$$", 60).split("\n")
    assert len(lines) > 1
    assert all(cells(line) <= 60 for line in lines)


def answers_to(task, matrix):
    text = f"title: A problem\nsystem: {{A: {matrix}}}\nfind:\n  a: {task}\n"
    return document_of(solve_problem(read_problem(Source("<test>", text), catalogue()))).parts[0].answers


def test_a_word_in_place_of_a_symbol_stands_before_a_colon():
    lines = {answer.name: answer_lines(answer) for answer in answers_to("stability", "[[0, 1], [-2, -3]]")}
    assert lines["verdict"] == ["verdict:  asymptotically stable"]
    assert lines["eigenvalues"] == ["λᵢ = −2, −1"]


def test_a_matrix_too_wide_for_the_terminal_is_listed_entry_by_entry():
    (answer,) = answers_to("state_transition_matrix", "[[0, 1], [-k, -d]]")
    lines = answer_lines(answer, 90)
    assert [line.partition("=")[0].strip() for line in lines if "=" in line] == ["Φ₁₁", "Φ₁₂", "Φ₂₁", "Φ₂₂"]
    assert max(map(cells, lines)) <= 90


def test_the_gain_that_closes_the_loop_is_part_of_the_question():
    text = "title: A problem\nsystem: {A: [[0, 1], [0, 0]], B: [0, 1]}\nfind:\n  a: {task: stability, gain: [2, 3]}\n"
    (part,) = document_of(solve_problem(read_problem(Source("<test>", text), catalogue()))).parts
    assert part.question.endswith(r"$u = -K_fx$ with $K_f = \begin{bmatrix}2 & 3\end{bmatrix}$.")


def test_a_matrix_of_one_entry_is_told_as_a_number():
    text = "system: {A: 2, B: 1, C: 1}\nfind: {a: {task: pole_placement, poles: [-3]}}\n"
    document = document_of(solve_problem(read_problem(Source("one.yaml", text), catalogue())), Presentation("key"))
    (gain,) = [each for each in document.parts[0].answers if each.name == "K"]
    assert answer_lines(gain)[0].endswith("= 5")
