"""The result as JSON: readable by any program, the values by sympy, and never a number that JSON does not have."""

import json
from functools import partial

import pytest
import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import BooleanAtom

from solver.derivation import Answers, Check, CheckStatus, PartResult, Status
from solver.document.model import Presentation
from solver.document.works import document_of
from solver.engine import Solution, solve_problem
from solver.patches import Program, program_of
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.render.data import as_data, render_json
from solver.tasks import catalogue
from solver.words import Reason
from tests.helpers.solved import EXAMPLES, by_problem, document_of_problem, solution_of

PROBLEM = "title: T\nsystem: {A: [[1, beta], [0, N]]}\nfind: {a: {task: characteristic_polynomial, marks: 3}}\n"


def problem(text=PROBLEM):
    return read_problem(Source("<test>", text), catalogue())


def ended(words):
    """Return a reason of these words."""
    return Reason("limits/ended", {"words": words})


def told(solution):
    """Return the document of a solution as JSON is made of it."""
    return document_of(solution, Presentation(data=True))


def with_result(**changes):
    """Return the document of a solution of one part that is what the changes say."""
    result = {"id": "a", "task": "characteristic_polynomial", "method": "determinant", "status": Status.VERIFIED}
    return told(Solution(problem(), (PartResult(**{**result, **changes}),)))


@pytest.mark.parametrize(**by_problem(EXAMPLES, EXAMPLES[1::6], of=2))
def test_every_answer_is_read_back_as_it_was(path):
    solution = solution_of(path)
    data = json.loads(render_json(document_of_problem(path)))
    names = {name: sp.Symbol(name) for name in data["symbols"]}
    assert [part["id"] for part in data["parts"]] == [part.id for part in solution.parts]
    for result, part in zip(solution.parts, data["parts"], strict=True):
        assert part["answers"].keys() == result.answers.keys()
        for name, value in result.answers.items():
            text = part["answers"][name]["value"]
            if isinstance(value, str):
                assert text == value
            elif isinstance(value, Program):
                assert list(program_of(text, partial(sp.sympify, locals=names)).readout) == list(value.readout)
            else:
                assert same(read_back(text, names), value)


def read_back(text, names):
    """The value of a text; a sample y(k+1) is a symbol."""
    found = sp.sympify(text, locals=names)
    if not isinstance(found, sp.MatrixBase):
        return found
    return found.xreplace({f: sp.Symbol(str(f).replace(" ", "")) for f in found.atoms(AppliedUndef)})


def same(read, value):
    """Whether two values agree, symbols by name and decimals to 12 digits."""
    if isinstance(value, dict):
        read = {str(name).replace(" ", ""): each for name, each in read.items()}
        return read.keys() == set(map(str, value)) and all(same(read[str(name)], each) for name, each in value.items())
    if isinstance(value, list | tuple):
        return len(read) == len(value) and all(map(same, read, value))
    if isinstance(value, str):
        return read == value
    if isinstance(value, bool | BooleanAtom):
        return bool(read) is bool(value)
    if isinstance(value, sp.MatrixBase):
        return read.shape == value.shape and all(map(same, read, value))
    value = sp.sympify(value)
    if value in (sp.oo, -sp.oo):
        return read == value
    plain = value.xreplace({symbol: sp.Symbol(symbol.name) for symbol in value.free_symbols})
    difference = sp.expand(read - plain) if isinstance(plain, sp.Expr) else 0 if read == plain else 1
    points = {symbol: sp.Rational(7, 5) + index for index, symbol in enumerate(sorted(read.free_symbols, key=str))}
    return difference == 0 or abs(complex(difference.subs(points))) <= 1e-11 * (1 + abs(complex(plain.subs(points))))


def test_free_names_are_listed_and_known_ones_are_not():
    assert as_data(told(solve_problem(problem())))["symbols"] == ["N", "beta"]


def test_numbers_that_json_does_not_have_become_null():
    checks = (
        Check("c", "o", float("nan"), 1e-9, CheckStatus.FAILED),
        Check("c", "o", float("inf"), 1e-9, CheckStatus.FAILED),
        Check.that("c", "o", True),
    )
    text = render_json(with_result(status=Status.FAILED, checks=checks, reason=ended("2 of 3 checks failed")))
    part = json.loads(text, parse_constant=pytest.fail)["parts"][0]
    assert [check["residual"] for check in part["checks"]] == [None, None, None]
    assert part["reason"] == "2 of 3 checks failed"


def test_a_skipped_check_says_why():
    part = as_data(with_result(checks=(Check.skipped("c", "o", "too large"),)))["parts"][0]
    assert part["checks"] == [
        {"claim": "c", "oracle": "o", "residual": None, "tolerance": None, "status": "skipped", "reason": "too large"}
    ]


def test_an_unsolved_part_has_its_reason_and_no_answers():
    data = as_data(with_result(status=Status.UNSOLVED, reason=ended("time limit of 60 s")))
    assert data["status"] == "unsolved"
    assert data["parts"][0]["reason"] == "time limit of 60 s"
    assert data["parts"][0]["answers"] == {}


def test_marks_are_numbers():
    assert as_data(with_result())["parts"][0]["marks"] == 3


def test_truth_values_and_texts_stand_as_they_are():
    answers = Answers(polynomial=sp.Matrix(2, 0, []))
    value = as_data(with_result(answers=answers))["parts"][0]["answers"]["polynomial"]["value"]
    assert value == "Matrix(2, 0, [])"
