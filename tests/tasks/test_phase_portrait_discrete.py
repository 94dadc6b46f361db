"""Phase portraits in discrete time: kinds by the unit circle, parameters, figures of orbits, corruptions, marking."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from solver.numeric.judges import stability
from tests.helpers.asking import ask, rejected, system
from tests.helpers.marked import verdict
from tests.helpers.tried import tried

R = sp.Rational
a, b, p = sp.Symbol("a"), sp.Symbol("b"), sp.Symbol("p", positive=True)
KINDS = {
    "stable node": [[R(1, 2), 1], [0, R(-3, 4)]],
    "unstable node": [[3, 1], [0, -2]],
    "saddle": [[R(-3, 2), 1], [0, R(1, 2)]],
    "stable focus": [[0, 1], [R(-4, 5), 1]],
    "unstable focus": [[1, 2], [-2, 1]],
    "center": [[0, 1], [-1, 1]],
    "stable star": [[R(-1, 2), 0], [0, R(-1, 2)]],
    "unstable star": [[3, 0], [0, 3]],
    "stable degenerate node": [[0, 1], [0, 0]],
    "unstable degenerate node": [[2, 1], [0, 2]],
    "line of equilibria": [[1, 1], [0, R(1, 2)]],
    "shear": [[1, 1], [0, 1]],
    "all points are equilibria": [[1, 0], [0, 1]],
}


def plant_of(rows):
    return system(rows, discrete=True)


@pytest.mark.parametrize("kind", KINDS)
def test_kinds_and_every_other_is_rejected(kind):
    plant = plant_of(KINDS[kind])
    result = ask("phase_portrait", plant)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["kind"] == kind
    for other in KINDS:
        assert rejected("phase_portrait", plant, {"kind": other}) == (other != kind)


@tried(25)
@given(st.lists(st.integers(-4, 4), min_size=4, max_size=4), st.integers(1, 4))
def test_numpys_eigenvalues_are_of_the_kind(entries, below):
    A = np.array(entries, dtype=float).reshape(2, 2) / below
    result = ask("phase_portrait", plant_of([[R(x, below) for x in entries[:2]], [R(x, below) for x in entries[2:]]]))
    sizes = np.abs(np.linalg.eigvals(A))
    if result.status is Status.UNSOLVED:
        assert np.min(np.abs(np.linalg.eigvals(A) + 1)) < 1e-6
        return
    assert result.status is Status.VERIFIED, result.reason
    kind = result.answers["kind"]
    if kind.startswith("stable"):
        assert np.all(sizes < 1)
    elif kind.startswith("unstable"):
        assert np.all(sizes > 1)
    elif kind == "saddle":
        assert sizes.min() < 1 < sizes.max()
    else:
        assert np.any(np.abs(sizes - 1) < 1e-6)


@pytest.mark.parametrize(
    "rows",
    [
        [[0, 1], [a, b]], [[a, 1], [0, b]], [[a, 1], [0, 2]], [[0, 1], [-p, 0]], [[p, 0], [0, p]], [[p, 1], [0, p]],
        [[1, p], [0, a]], [[0, 1], [R(-1, 2), a]], [[a, b], [-b, a]], [[3, 1], [0, p]], [[1 - p, p], [0, -2]],
    ],
)  # fmt: skip
def test_where_parameters_make_it_another_kind(rows):
    result = ask("phase_portrait", plant_of(rows))
    assert result.status is Status.VERIFIED, result.reason
    general, special = stability.kinds_and_exceptions(
        sp.ImmutableMatrix(rows), result.answers["exceptions"], discrete=True
    )
    assert general == {result.answers["kind"]}
    assert not general & special


def test_a_wrong_exception_is_rejected():
    plant = plant_of([[0, 1], [R(-1, 2), a]])
    right = ask("phase_portrait", plant).answers["exceptions"]
    assert not rejected("phase_portrait", plant, {"kind": "stable focus", "exceptions": right})
    assert rejected("phase_portrait", plant, {"kind": "stable focus", "exceptions": [a < 0]})


def test_an_eigenvalue_minus_one_has_no_name():
    result = ask("phase_portrait", plant_of([[-1, 1], [0, R(1, 2)]]))
    assert (result.status, result.reason.kind) == (Status.UNSOLVED, "phase_portrait/eigenvalue_minus_one")


@pytest.mark.parametrize("kind", KINDS)
def test_orbits_are_those_of_the_plant(kind):
    A = np.array(KINDS[kind], dtype=float)
    (figure,) = next(step for step in ask("phase_portrait", plant_of(KINDS[kind])).steps if step.figures).figures
    orbits = [curve for curve in figure.curves if curve.style == "jumps"]
    assert bool(orbits) == (kind != "all points are equilibria")
    for orbit in orbits:
        points = np.array([orbit.x, orbit.y], dtype=float)
        assert np.allclose(A @ points[:, :-1], points[:, 1:], atol=1e-4)


PROBLEM = "system: {time: discrete, A: [[1/2, 0], [0, 1/4]]}\nfind: {a: phase_portrait}\n"


def test_the_half_plane_taken_for_the_disc_is_named():
    found = verdict(PROBLEM, "a", "kind", "unstable node")
    assert found.verdict == "wrong"
    assert "not where" in str(found.reason)
    assert verdict(PROBLEM, "a", "kind", "stable node").verdict == "correct"


def test_a_verdict_by_the_half_plane_is_named():
    problem = "system: {time: discrete, A: [[1/2, 0], [0, 1/4]]}\nfind: {a: stability}\n"
    assert "time is discrete here" in str(verdict(problem, "a", "verdict", "unstable").reason)
