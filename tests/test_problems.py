"""Every problem in problems/ is solved, every check passes, and every format words it at every level of detail."""

import json
import re

import pytest
import sympy as sp

from solver.derivation import CheckStatus, Status
from solver.document.model import Presentation
from solver.document.works import document_of
from solver.numeric import NoRule
from solver.render.data import render_json
from solver.render.latex_document import latex_document
from solver.render.markdown import markdown_of
from solver.render.page import render_page
from solver.render.wording import LEVELS
from solver.symbols import NOTATIONS
from tests.helpers.solved import EXAMPLES, PROBLEMS, by_problem, document_of_problem, solution_of

CLUMSY = re.compile(r"(?<![\d.])\d+\.0(?!\d)|[-+] ?[-+]|(?<![\d.])1 ?\\cdot|\bNone\b|Matrix\(|(?<=[\w)])\*\*(?=[\w(])")
"""What nobody would write: 1.0, - -2, + -, 1 · x, and remains of Python."""

FORMULA = re.compile(r"\$\$.*?\$\$|\$.*?\$", re.DOTALL)
SLOVENLY = re.compile(
    r"[a-z]{2}[.:;,!?][A-Z]|\b(?:first|last|the) 1 |\b1 (?:columns|rows|steps|states|equations|unknowns|values|poles)\b"
    r"|\b([a-z]+) \1\b| [.,;:](?=\s|$)"
)
"""Sentences without a blank between them, the first 1 column, a word twice, a blank before a full stop."""

ODD = re.compile(r"\\lambda\\lambda|\\begin\{bmatrix\}[^&\\]*\\end\{bmatrix\}\^\{-1\}")
"""λλ, and the inverse of a matrix of one entry."""


def carelessly_written(markdown):
    """What is slovenly in the words of a step, or odd in its formulas, with what stands around it."""
    for text, kind in ((FORMULA.sub("x", markdown), SLOVENLY), (markdown, ODD)):
        for found in kind.finditer(text):
            yield text[max(0, found.start() - 60) : found.end() + 60]


@pytest.mark.parametrize(**by_problem(PROBLEMS))
def test_the_problem_is_verified(path):
    for part in solution_of(path).parts:
        failed = [check for check in part.checks if check.status is not CheckStatus.PASSED]
        assert part.status is Status.VERIFIED, (part.id, part.method, part.reason, failed)
        assert not failed


@pytest.mark.parametrize(**by_problem(PROBLEMS))
def test_no_check_is_left_out_for_want_of_a_rule(path):
    """What can not be judged is told with its reason; that the oracle was never taught an operation is no reason."""
    wanting = [check for part in solution_of(path).parts for check in part.checks if str(NoRule("")) in check.reason]
    assert not wanting


@pytest.mark.parametrize(
    "detail", ["tutor", pytest.param("full", marks=pytest.mark.slow), pytest.param("brief", marks=pytest.mark.slow)]
)
@pytest.mark.parametrize(**by_problem(PROBLEMS, quick=EXAMPLES))
def test_every_format_shows_it_at_every_level_of_detail(path, detail):
    document = document_of_problem(path).told(detail=detail)
    shown = [render_page(document), latex_document(document), markdown_of(document)]
    for part in document.parts:
        assert all(answer.equation in shown[2] for answer in part.found)
        for formula in [step.markdown for step in part.steps] + [answer.tex for answer in part.answers]:
            assert not CLUMSY.search(formula), formula
        assert not [each for step in part.steps for each in carelessly_written(step.markdown)]
    assert all(len(text) > 500 for text in shown)


PRESENTATIONS = [Presentation(detail, notation=each) for detail in ("key", *LEVELS) for each in NOTATIONS]
PRESENTATIONS += [Presentation(language="de", notation=each) for each in NOTATIONS]


@pytest.mark.slow
@pytest.mark.parametrize(**by_problem(PROBLEMS))
def test_what_is_displayed_holds_at_every_level_in_every_notation(path):
    solution = solution_of(path)
    for presentation in PRESENTATIONS:
        for result, part in zip(solution.parts, document_of(solution, presentation).parts, strict=True):
            wrong = [check for check in part.checks if check.status is CheckStatus.FAILED]
            assert part.status is result.status, (presentation, part.id, part.method, wrong)
            assert "the judge cannot" not in part.unchecked


@pytest.mark.slow
@pytest.mark.parametrize(**by_problem(PROBLEMS))
def test_the_same_is_checked_in_every_notation(path):
    told = [document_of(solution_of(path), Presentation(notation=notation)) for notation in NOTATIONS]
    checked = [[[(c.step, c.status) for c in part.checks] for part in each.parts] for each in told]
    assert all(each == checked[0] for each in checked)


@pytest.mark.parametrize(**by_problem(PROBLEMS, quick=[]))
def test_the_values_in_json_are_read_back_as_they_were(path):
    solution = solution_of(path)
    data = json.loads(render_json(document_of_problem(path)))
    names = {name: sp.Symbol(name) for name in data["symbols"]}
    for result, part in zip(solution.parts, data["parts"], strict=True):
        for name, answer in part["answers"].items():
            if isinstance(result.answers[name], str):  # words, where the catalogue says so
                assert answer["value"] == result.answers[name]
                continue
            ours, theirs = result.answers[name], sp.sympify(answer["value"], locals=names)
            plain = {symbol: sp.Symbol(symbol.name) for symbol in getattr(ours, "free_symbols", ())}
            if isinstance(ours, sp.MatrixBase):
                point = {symbol: sp.Rational(7 + i, 5) for i, symbol in enumerate(sorted(theirs.free_symbols, key=str))}
                point = {symbol: 3 if symbol.name == "k" else value for symbol, value in point.items()}
                ours, theirs = (M.subs(point).evalf(20) for M in (ours.xreplace(plain), theirs))
                assert all(abs(a - b) <= 1e-12 * max(1, abs(a)) for a, b in zip(ours, theirs, strict=True))
            elif isinstance(ours, bool):
                assert theirs in (sp.true, sp.false)
                assert bool(theirs) is ours
