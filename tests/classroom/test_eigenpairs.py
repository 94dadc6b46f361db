"""Eigenvectors told with their eigenvalues: each must belong to its own, in whatever order they are told."""

import pytest

from solver.classroom.reading.eigenpairs import eigenpairs
from tests.helpers.marked import marked, verdict

PLANT = "find: {a: {task: eigenstructure, system: {matrix: [[1, 1], [0, 2]]}}}"


@pytest.mark.parametrize(
    "text",
    [
        "λ = 1: (1, 0); λ = 2: (1, 1)",
        "v(1) = (1, 0), v(2) = (1, 1)",
        "(1, 0) for λ = 1, (1, 1) for λ = 2",
        "{1: [1, 0], 2: [1, 1]}",
        "V = [1 1; 0 1], D = diag(1, 2)",
        "[(1, 1, [Matrix([[1], [0]])]), (2, 1, [Matrix([[1], [1]])])]",
        "{{1, 2}, {{1, 0}, {1, 1}}}",
        "(array([1., 2.]), array([[1., 1.], [0., 1.]]))",
    ],
)
def test_eigenvalues_are_told_with_their_vectors(text):
    assert [value.rstrip(".") for value, _ in eigenpairs(text)] == ["1", "2"]


@pytest.mark.parametrize(
    "text", ["(1, 0), (1, 1)", "v1 = (1, 0), v2 = (1, 1)", "λ = 1, λ = 2: (1, 0)", "(1, 0) for λ = 1, λ = 2"]
)
def test_what_does_not_tell_the_eigenvalue_of_each_vector_has_no_pairs(text):
    assert eigenpairs(text) == []


@pytest.mark.parametrize("text", ["λ = 2: (1, 0); λ = 1: (1, 1)", "λ = 1: (1, 0); λ = 3: (1, 1)"])
def test_a_vector_for_another_eigenvalue_than_its_own_is_wrong(text):
    found = verdict(PLANT, "a", "right_eigenvectors", f"'{text}'")
    assert (found.verdict, found.reason) == ("wrong", "a vector is told for an eigenvalue to which it does not belong")


@pytest.mark.parametrize("order", ["1, 2", "2, 1"])
def test_the_vectors_are_put_in_the_order_of_the_eigenvalues_beside_them(order):
    written = f"{{eigenvalues: [{order}], right_eigenvectors: 'λ = 2: (1, 1); λ = 1: (1, 0)'}}"
    answers = marked(PLANT, f"answers: {{a: {written}}}")["a"].answers
    assert {each.verdict for each in answers.values()} == {"correct"}
