"""Answer files are as hostile as problem files: every fault has a place, and words."""

import pytest

from solver.problem.source import InputError
from tests.helpers.marked import marked

pytestmark = pytest.mark.xdist_group("answer_file")  # its problem is solved once

PLANT = "system: {A: [[0, 1], [-2, -3]], B: [0, 1]}\nfind: {a: eigenstructure, b: controllability}\n"


@pytest.mark.parametrize(
    ("text", "place", "words"),
    [
        ("answers: {a: {eigenvalue: [1]}}", ":1:15:", "did you mean 'eigenvalues'"),
        ("answers: {c: {rank: 1}}", ":1:11:", "the problem has no part 'c'"),
        ("answer: {a: {rank: 1}}", ":1:1:", "did you mean 'answers'"),
        ("answers: [1, 2]", ":1:10:", "'answers:' must list"),
        ("- 1", ":1:1:", "an answer file is a mapping"),
        ("answers: {a: {eigenvalues: [1, 2+]}}", ":1:", "expected"),
        ("answers: {a: {eigenvalues: [1, 1/2x]}}", ":1:", "unclear"),
        ("answers: {b: {controllability_matrix: [[1, 2], [3]]}}", ":1:", "same length"),
        ("answers: {b: {controllable: maybe}}", ":1:29:", "yes or no"),
        ("answers: {b: {rank: '1 ± 2'}}", ":1:21:", "stands for two values"),
        ("answers: {b: {rank: &x 1}}", ":1:", "anchor"),
        ("answers: {b: {rank: 1, rank: 2}}", ":1:", "twice"),
        ("answers: {b: {rank: __import__('os')}}", ":1:", ""),
    ],
)
def test_a_fault_is_reported_at_its_place(text, place, words):
    with pytest.raises(InputError) as caught:
        marked(PLANT, text)
    message = caught.value.render()
    assert place in message
    assert words in message


def test_all_faults_are_reported_together():
    with pytest.raises(InputError) as caught:
        marked(PLANT, "answers:\n  a: {eigenvalues: [1+]}\n  b: {rank: 2+, controllable: maybe}\n")
    assert len(caught.value.diagnostics) == 3


def test_a_matrix_of_the_wrong_shape_is_wrong_and_not_a_fault():
    found = marked(PLANT, "answers: {b: {controllability_matrix: [[0, 1, 2], [1, -3, 4]]}}")
    answer = found["b"].answers["controllability_matrix"]
    assert (answer.verdict, answer.reason) == ("wrong", "it must be 2×2; this one is 2×3")
