"""What is held of a question while many variants are made."""

from dataclasses import replace

import pytest

from solver.document.exam import as_question
from solver.document.model import Presentation
from solver.document.works import document_of, solve_as_told
from solver.papers.exam.packed import opened, packed
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

TEXT = "system: {A: [[0, 1], [-2, -3]], B: [0, 1]}\nfind: {a: {task: pole_placement, poles: [-4, -5]}, b: stability}\n"


@pytest.fixture(scope="module")
def told():
    """A question as a paper and as a key tell it."""
    key = Presentation("key")
    solution = solve_as_told(read_problem(Source("a.yaml", TEXT), catalogue()), key)
    return tuple(as_question(document_of(solution, each), 1) for each in (replace(key, detail="question"), key))


def test_a_packed_question_is_small_and_opens_as_it_was(told):
    content = packed(*told)
    assert isinstance(content, bytes)
    assert len(content) < 4000
    again = opened(content)
    assert again[0] == told[0]
    assert again[1].rendered("html") == told[1].rendered("html")


def test_what_is_no_plain_data_is_kept_as_it_is(told):
    strange = (told[0], replace(told[1], title=object()))
    assert packed(*strange) == strange
    assert opened(strange) == strange
