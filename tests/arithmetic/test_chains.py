"""Chains of generalized eigenvectors: dimensions by numpy's ranks, equations that hold."""

import numpy as np
import pytest
import sympy as sp

from solver.numeric import check_steps
from solver.render.wording import Wording
from tests.helpers.asking import ask, system

TUTOR = Wording(detail="tutor")
TWO_BLOCKS = [[2, 1, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, 0]]
ONE_BLOCK = [[0, 1, 0], [0, 0, 1], [-1, -3, -3]]
COMPLEX = [[0, 1, 0, 0], [-1, 0, 1, 0], [0, 0, 0, 1], [0, 0, -1, 0]]


def lines(rows, kind):
    """The steps of that kind below the right eigenvectors."""
    steps = [step for step in ask("eigenstructure", system(rows)).steps if step.wording == "lemmas/eigenvectors"]
    return [line for step in steps for line in step.steps if line.kind == kind]


def displayed(steps):
    return "\n".join(f"{each.title}\n{each.markdown}" for each in TUTOR.words(steps))


@pytest.mark.parametrize("rows", [TWO_BLOCKS, ONE_BLOCK, COMPLEX])
def test_the_dimensions_are_those_of_numpys_ranks(rows):
    found = lines(rows, "lengths")
    assert found
    for step in found:
        N = np.array(step.values["N"].tolist(), dtype=complex)
        by_numpy = [len(rows) - np.linalg.matrix_rank(np.linalg.matrix_power(N, k + 1)) for k in range(2)]
        assert [int(d) for d in step.values["nullities"]][:2] == by_numpy
        assert all(check.status == "passed" for check in check_steps([step]))


def test_the_lengths_follow_from_the_dimensions():
    shown = displayed(lines(TWO_BLOCKS, "lengths"))
    assert (
        "$d_{1} = 2$ chains; $d_{2} - d_{1} = 1$ of them has at least 2 vectors. So the lengths are 2 and 1." in shown
    )
    assert "there is one chain, and it has all 3 vectors" in displayed(lines(ONE_BLOCK, "lengths"))


@pytest.mark.parametrize("rows", [TWO_BLOCKS, ONE_BLOCK, COMPLEX])
def test_a_chain_ends_in_zero(rows):
    for step in lines(rows, "chain"):
        assert all(check.status == "passed" for check in check_steps([step]))
        N = np.array(step.values["N"].tolist(), dtype=complex)
        first, *_ = step.claims.values()
        last = np.array(first.left.operands[1].tolist(), dtype=complex)
        k = step.values["length"]
        assert np.allclose(np.linalg.matrix_power(N, k) @ last, 0)
        assert not np.allclose(np.linalg.matrix_power(N, k - 1) @ last, 0)


def test_the_entries_of_a_chain_are_worked_out():
    shown = displayed(lines(ONE_BLOCK, "chain"))
    assert (
        r"\begin{bmatrix}1 - 1 \\ -1 + 1 \\ -1 + (-3)(-1) - 2\end{bmatrix} = \begin{bmatrix}0 \\ 0 \\ 0\end{bmatrix}"
        in shown
    )


def test_pages_without_chains_have_none():
    assert lines([[0, 1], [-2, -3]], "lengths") == []
    assert sp.Symbol("x_1") not in lines([[0, 1], [-2, -3]], "null_vectors")[0].values["free"]


def test_the_last_vector_solves_the_reduced_equations_of_the_power():
    (line,) = lines([[0, 1, 0], [0, 0, 1], [2, -5, 4]], "chain")
    rows, last = line.values["rows"], line.values["last"]
    assert rows.tolist() == [[1, -2, 1]]
    assert (rows * last)[0] == 0
    assert r"\begin{bmatrix}1 & -2 & 1\end{bmatrix}x = 0" in displayed([line])
