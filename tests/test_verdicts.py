"""What the checks make of a part: verified needs a passed check of each answer; what could not be checked is told."""

import io
from dataclasses import replace

import pytest
from rich.console import Console

from solver.derivation import Check, CheckStatus, Status
from solver.document.works import document_of
from solver.engine import solve_problem, verdict
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.render.data import as_data
from solver.render.latex_document import latex_document
from solver.render.markdown import markdown_of
from solver.render.page import render_page
from solver.render.terminal import print_summary, text_document
from solver.tasks import catalogue

DISPLAYED = Check.within("an equality", "random points", 0.0, 1e-9)
PASSED = Check.within("poles", "numpy", 0.0, 1e-9, answer="K")
FAILED = Check.within("poles", "numpy", 1.0, 1e-9, answer="K")
SKIPPED = Check.skipped("poles", "numpy", "too few digits", answer="K")


@pytest.mark.parametrize(
    ("checks", "answers", "status", "reason"),
    [
        ([PASSED], ["K"], Status.VERIFIED, ""),
        ([PASSED, SKIPPED], ["K"], Status.VERIFIED, ""),
        ([PASSED, FAILED], ["K"], Status.FAILED, "1 of 2 checks failed"),
        ([DISPLAYED, SKIPPED], ["K"], Status.UNSOLVED, "no check could be made of the answer K"),
        ([PASSED], ["K", "L"], Status.UNSOLVED, "no check could be made of the answer L"),
        ([DISPLAYED], ["K", "L"], Status.UNSOLVED, "no check could be made of the answers K, L"),
        ([DISPLAYED], [], Status.UNSOLVED, "no check could be made of the answer"),
    ],
)
def test_every_answer_needs_a_passed_check_of_its_own(checks, answers, status, reason):
    found, why = verdict(checks, answers)
    assert (found, str(why or "")) == (status, reason)


@pytest.fixture(scope="module")
def solution():
    text = "title: T\nsystem: {A: [[0, 1], [-2, -3]]}\nfind:\n  a: characteristic_polynomial\n"
    solved = solve_problem(read_problem(Source("<test>", text), catalogue()))
    part = solved.parts[0]
    skipped = [Check.skipped(claim, "numpy", "too few digits") for claim in ("one", "two")]
    return solved, replace(solved, parts=(replace(part, checks=(*part.checks, *skipped)),))


@pytest.mark.parametrize("write", [render_page, latex_document, markdown_of, text_document])
def test_every_format_tells_what_could_not_be_checked(solution, write):
    whole, lacking = (write(document_of(each)) for each in solution)
    assert "could not be checked" not in whole
    assert "2 could not be checked: too few digits" in " ".join(lacking.split())


def test_the_terminal_and_the_data_tell_what_could_not_be_checked(solution):
    console = Console(file=io.StringIO(), width=120)
    print_summary(document_of(solution[1]), console)
    assert "2 could not be checked: too few digits" in console.file.getvalue()
    whole, lacking = (as_data(document_of(each))["parts"][0] for each in solution)
    assert "unchecked" not in whole
    assert lacking["unchecked"] == "2 could not be checked: too few digits"
    assert [check["status"] for check in lacking["checks"]].count("skipped") == 2


def test_a_check_of_a_displayed_equality_keeps_all_else():
    found = Check("a = b", "numpy", 1.0, 0.1, CheckStatus.FAILED, "why", ("x",), 2, 3, (1, 2))
    assert found.displayed_in(7) == replace(found, step=7)
    assert found.displayed_in(7).sides == (1, 2)
