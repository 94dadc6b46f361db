"""Marking in German: no English word on the sheet, in its LaTeX, on the terminal or in the data."""

import json
import re
from io import StringIO

import pytest
import yaml
from rich.console import Console

from solver.classroom import mark, read_submission
from solver.classroom.report.data import as_data
from solver.classroom.report.sheet import render_sheet
from solver.classroom.report.text import print_marking
from solver.document.works import document_of
from solver.messages import Messages
from solver.problem.source import Source
from tests.helpers.marked import solved

ENGLISH = set(
    "the and are not with without for from that this which wrong right correct check checks marks mark marked answer "
    "answers row column value values must question own solution sign reversed each has have does given gives both "
    "other only where when what shape should would could cannot been being its your judged missing there these "
    "those".split()
)
"""Words of which no German text has any; those of formulas and of programs are left out before."""

PROBLEM = {
    "title": "Regelkreis",
    "system": {"A": [[0, 1], [-2, -3]], "B": [0, 1], "C": [1, 0]},
    "find": {
        "a": {"task": "pole_placement", "poles": [-3, -4]},
        "b": {"task": "characteristic_polynomial", "gain": {"from": "a"}},
        "c": {"task": "characteristic_polynomial"},
        "d": {"task": "pole_placement", "poles": [-1, -2, -3], "system": {"A": [[0, 1, 0], [0, 0, 1], [1, 2, 3]],
              "B": [0, 0, 1]}},
    },
}  # fmt: skip

SUBMITTED = [
    {"a": {"K": [10, 4], "closed_loop_A": [[0, 1], [-12, -7]], "polynomial": "s^2 + 7s + 12"},
     "b": {"polynomial": "lambda^2 + 7lambda + 12"}, "c": {"polynomial": "lambda^2 + 3lambda + 2"}},
    {"a": {"K": [4, 10], "closed_loop_A": [[0, 1], [8, 1]], "polynomial": "s^2 - 7s + 12"},
     "b": {"polynomial": "lambda^2 + lambda + 1"}, "c": {"polynomial": "-lambda^2 - 3lambda - 2"},
     "d": {"K": [7, 13]}},
    {"a": {"K": [-10, -4], "closed_loop_A": [[0, 1], [-12, 7]]}, "c": {"polynomial": "lambda^2 + q"},
     "d": {"K": "inf"}},
    {"a": {"K": [10.2, 4]}, "b": {"polynomial": "lambda^2 + 13lambda + 6"}, "d": {"K": [7, 13, 8.9]},
     "c": {"polynomial": "lambda^2 + 3.01lambda"}},
]  # fmt: skip


def marked_in(language, submitted):
    """The solution and the marking of a submission to the problem in a language."""
    solution = solved(yaml.safe_dump({**PROBLEM, "language": language}))
    text = yaml.safe_dump({"answers": submitted})
    return solution, mark(solution, read_submission(Source("answers.yaml", text), solution.problem))


def words(text):
    """The words of a text that is read, without formulas, code, styles and names of answers and functions."""
    drawn = re.sub(r"\\addplot\+?\[[^\]]*\]", " ", text)  # `only marks` is an option of a plot
    visible = re.sub(r"(?s)<(style|math|code)\b.*?</\1>|<[^>]*>|\$\$.*?\$\$|\$[^$]*\$|\\[A-Za-z]+", " ", drawn)
    return {word.lower() for word in re.findall(r"[^\W\d_]{3,}", re.sub(r"\w*[_.]\w[\w.]*", " ", visible))}


def printed(marking, language):
    """What the terminal shows of a marking."""
    console = Console(file=StringIO(), width=200)
    print_marking(marking, "antworten.yaml", console, Messages(language=language))
    return console.file.getvalue()


@pytest.mark.parametrize("submitted", SUBMITTED)
def test_no_english_word_is_on_a_german_sheet(submitted):
    solution, marking = marked_in("de", submitted)
    document = document_of(solution)
    heard = " ".join(
        re.findall(r'(?:alt|aria-label|title)="([^"]*)"', sheet := render_sheet(solution, marking, document, key=True))
    )
    for text in (
        sheet,
        heard,
        printed(marking, "de"),
        document.latex().partition(r"\begin{document}")[2],
        document.text(),
    ):
        assert words(text) & ENGLISH == set()
    said = [
        each[key]
        for part in as_data(marking)["parts"]
        for each in (part, *part["answers"].values())
        for key in ("reason", "note")
        if key in each
    ]
    assert words(" ".join(said)) & ENGLISH == set()
    assert '<html lang="de">' in sheet


@pytest.mark.parametrize("submitted", SUBMITTED)
def test_verdicts_and_marks_do_not_depend_on_the_language(submitted):
    def judged(language):
        data = as_data(marked_in(language, submitted)[1])
        return json.dumps(data, default=str), [
            (part["marks"], name, answer["verdict"], answer.get("entries"), "reason" in answer, "note" in answer)
            for part in data["parts"]
            for name, answer in part["answers"].items()
        ]

    (english, ours), (german, theirs) = judged("en"), judged("de")
    assert ours == theirs
    assert submitted is SUBMITTED[0] or english != german


def test_english_words_would_be_found():
    solution, marking = marked_in("en", SUBMITTED[1])
    for text in (render_sheet(solution, marking), printed(marking, "en"), document_of(solution).text()):
        assert words(text) & ENGLISH


def test_what_fails_is_told_in_the_notation_of_the_problem():
    text = yaml.safe_dump({**PROBLEM, "notation": "ogata", "system": {"A": [[0, 1], [-2, -3]], "C": [1, 0]},
                           "find": {"a": {"task": "observability"}}})  # fmt: skip
    course = yaml.safe_dump({**yaml.safe_load(text), "notation": "course"})
    submission = "answers: {a: {rank: 1}}"
    reasons = []
    for problem in (text, course):
        solution = solved(problem)
        marking = mark(solution, read_submission(Source("answers.yaml", submission), solution.problem))
        reasons.append(marking.parts[0].answers["rank"].reason)
    assert reasons[0] != reasons[1]
    assert r"\mathcal" in reasons[1]
    assert r"\mathcal" not in reasons[0]
