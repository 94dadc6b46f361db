"""Stability, Lyapunov's equation, Routh's array, eigenstructure against scipy and against how the systems were made."""

from collections import Counter

import numpy as np
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.linalg import solve_continuous_lyapunov, solve_discrete_lyapunov

from tests.helpers.comparing import (
    answers_of,
    close,
    floats,
    numbers,
    product,
    same,
    systems_tried,
)
from tests.helpers.strategies import plain_plants, plants

METHODS = ("eigenvalues", "lyapunov", "routh")


def true_verdict(made):
    """From the blocks: inside, on, or outside the border; on it simple blocks only are stable."""
    marginal = False
    for block in made.blocks:
        beyond = block.sigma**2 + block.omega**2 - 1 if made.system.discrete else block.sigma
        if beyond > 0 or (beyond == 0 and block.size > 1):
            return "unstable"
        marginal = marginal or beyond == 0
    return "marginally stable" if marginal else "asymptotically stable"


@systems_tried(30)
@given(plants(discrete=None), st.sampled_from(METHODS))
def test_verdicts_are_those_of_the_blocks(made, method):
    answers = answers_of("stability", made.system, method)
    assert str(answers["verdict"]) == true_verdict(made)
    if method == "routh":
        beyond = [b.sigma**2 + b.omega**2 > 1 if made.system.discrete else b.sigma > 0 for b in made.blocks]
        expected = sum(b.order for b, out in zip(made.blocks, beyond, strict=True) if out)
        assert answers["right_half_plane_roots"] == expected


@systems_tried(16)
@given(plants(discrete=None))
def test_bounded_inputs_give_bounded_outputs_if_the_poles_decay(made):
    poles = numbers(answers_of("transfer_function", made.system)["poles"])
    decays = np.abs(poles) < 1 - 1e-12 if made.system.discrete else poles.real < -1e-12
    for method in METHODS:
        assert bool(answers_of("stability", made.system, method)["bibo_stable"]) == bool(np.all(decays))


@systems_tried(30)
@given(plain_plants(5), st.sampled_from(METHODS))
def test_verdicts_where_eigenvalues_are_of_any_degree(plant, method):
    roots = np.linalg.eigvals(floats(plant.A))
    assume(np.all(np.abs(roots.real) > 1e-3))
    answers = answers_of("stability", plant, method)
    assert str(answers["verdict"]) == ("asymptotically stable" if np.all(roots.real < 0) else "unstable")
    if method == "routh":
        assert answers["right_half_plane_roots"] == np.count_nonzero(roots.real > 0)
    if method == "eigenvalues":
        assert close(np.poly(numbers(answers["eigenvalues"])), np.poly(floats(plant.A)), 1e-7)


@systems_tried(24)
@given(plants(discrete=None), st.booleans(), st.booleans(), st.data())
def test_lyapunov_solutions_satisfy_their_equation_exactly_and_agree_with_scipy(made, dual, weighted, data):
    plant = made.system
    n, A = plant.order, plant.A
    half = sp.Matrix(n, n, lambda *_: data.draw(st.integers(-1, 1))) if weighted else sp.zeros(n)
    Q = sp.ImmutableMatrix(half * half.T + sp.eye(n))
    answers = answers_of("stability", plant, "lyapunov", Q=Q, dual=dual)
    P, M = answers.get("P"), A if dual else A.T
    roots = np.linalg.eigvals(floats(A))
    sums = np.multiply.outer(roots, roots) - 1 if plant.discrete else np.add.outer(roots, roots)
    if P is None:
        assert np.min(np.abs(sums)) < 1e-2  # two eigenvalues add up to zero (multiple ones are blurred)
        return
    if plant.discrete:
        assert same(product(M, P, M.T) - P, -Q)
    else:
        assert same(product(M, P) + product(P, M.T), -Q)
    if np.min(np.abs(sums)) > 1e-2:
        theirs = (solve_discrete_lyapunov if plant.discrete else solve_continuous_lyapunov)(
            floats(M), floats(Q) if plant.discrete else -floats(Q)
        )
        assert close(floats(P), theirs, 1e-4)


@systems_tried(50)
@given(plants(5, discrete=None))
def test_the_jordan_form_has_the_blocks_the_system_was_made_of(made):
    A = made.system.A
    answers = answers_of("eigenstructure", made.system)
    J, V, W = answers["jordan_form"], answers["right_eigenvectors"], answers["left_eigenvectors"]
    expand = lambda M: sp.Matrix(M).applyfunc(sp.expand)  # noqa: E731
    assert expand(A * V - V * J).is_zero_matrix
    assert expand(W * A - J * W).is_zero_matrix or not answers["diagonalizable"]
    assert sp.expand(V.det(method="berkowitz")) != 0
    found = Counter()
    start = 0
    for i in range(A.rows):
        if i + 1 == A.rows or J[i, i + 1] == 0:
            found[(J[i, i], i + 1 - start)] += 1
            start = i + 1
    expected = Counter()
    for block in made.blocks:
        for sign in (1, -1) if block.omega else (1,):
            expected[(block.sigma + sign * sp.I * block.omega, block.size)] += 1
    assert found == expected
    assert answers["diagonalizable"] == all(block.size == 1 for block in made.blocks)
    assert sorted(map(str, answers["eigenvalues"])) == sorted(str(J[i, i]) for i in range(A.rows))


@systems_tried(20)
@given(plain_plants(5))
def test_eigenvectors_in_decimals(plant):
    A = floats(plant.A)
    answers = answers_of("eigenstructure", plant)
    V, W, J = (
        np.array(answers[name].evalf(25).tolist(), dtype=complex)
        for name in ("right_eigenvectors", "left_eigenvectors", "jordan_form")
    )
    assert close(A @ V, V @ J, 1e-8)
    assert close(np.poly(np.diag(J)), np.poly(A), 1e-7)
    if answers["diagonalizable"]:
        assert close(W @ A, np.diag(np.diag(J)) @ W, 1e-8)


@systems_tried(30)
@given(plants(2, smallest=2))
def test_phase_portraits_are_named_by_the_eigenvalues(made):
    found = str(answers_of("phase_portrait", made.system)["kind"])
    first, last = made.blocks[0], made.blocks[-1]
    if first.omega:
        expected = "center" if not first.sigma else f"{'stable' if first.sigma < 0 else 'unstable'} focus"
    elif first.size == 2:
        expected = "shear" if not first.sigma else f"{'stable' if first.sigma < 0 else 'unstable'} degenerate node"
    else:
        one, two = first.sigma, last.sigma
        side = "stable" if one < 0 else "unstable"
        if one == two:
            expected = f"{side} star" if one else "all points are equilibria"
        elif not one * two:
            expected = "line of equilibria"
        else:
            expected = "saddle" if one * two < 0 else f"{side} node"
    assert found == expected
