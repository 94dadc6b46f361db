"""Kinds of phase portraits, figures of exact trajectories, refusals, corruptions."""

from itertools import product

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import expm

import solver
from solver.derivation import Status
from solver.numeric.judges import stability
from solver.problem.source import InputError
from tests.helpers.asking import ask, rejected, system
from tests.helpers.tried import tried

p, d = sp.symbols("p d", positive=True)
KINDS = {
    "stable node": [[-2, 0], [1, -1]],
    "unstable node": [[3, 1], [1, 3]],
    "saddle": [[1, 2], [3, 0]],
    "stable focus": [[0, 1], [-5, -2]],
    "unstable focus": [[1, 2], [-2, 1]],
    "center": [[0, 2], [-1, 0]],
    "stable star": [[-2, 0], [0, -2]],
    "unstable star": [[3, 0], [0, 3]],
    "stable degenerate node": [[0, 1], [-1, -2]],
    "unstable degenerate node": [[2, 1], [0, 2]],
    "line of equilibria": [[-1, 1], [1, -1]],
    "shear": [[0, 1], [0, 0]],
    "all points are equilibria": [[0, 0], [0, 0]],
}


@pytest.mark.parametrize("kind", KINDS)
def test_kinds(kind):
    result = ask("phase_portrait", system(KINDS[kind]))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["kind"] == kind


@pytest.mark.parametrize("kind", KINDS)
def test_every_other_kind_is_rejected(kind):
    plant = system(KINDS[kind])
    for other in [*KINDS, "node"]:
        assert rejected("phase_portrait", plant, {"kind": other}) == (other != kind)


@tried(25)
@given(st.lists(st.integers(-3, 3), min_size=4, max_size=4))
def test_numpys_eigenvalues_are_of_the_kind(entries):
    A = np.array(entries, dtype=float).reshape(2, 2)
    result = ask("phase_portrait", system(A.astype(int).tolist()))
    assert result.status is Status.VERIFIED, result.reason
    kind, values = result.answers["kind"], np.linalg.eigvals(A)
    if "stable" in kind:
        assert np.all(values.real < 1e-6) if not kind.startswith("un") else np.all(values.real > -1e-6)
    if kind == "saddle":
        assert values.real.min() < 0 < values.real.max()
    if "focus" in kind or kind == "center":
        assert abs(values[0].imag) > 1e-6


def figures(plant):
    return [figure for step in ask("phase_portrait", plant).steps for figure in step.figures]


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "all points are equilibria"])
def test_the_trajectories_are_free_motions(kind):
    (plot,) = figures(system(KINDS[kind]))
    A = np.array(KINDS[kind], dtype=float)
    arrows = [curve for curve in plot.curves if curve.style == "arrow"]
    assert len(arrows) >= 4
    for curve in arrows:
        at = [np.array([float(part.subs(plot.variable, u)) for part in (curve.x, curve.y)]) for u in (0, 0.5, 1)]
        slope = np.array([float(sp.diff(part, plot.variable).subs(plot.variable, 0)) for part in (curve.x, curve.y)])
        time = slope @ (A @ at[0]) / np.sum((A @ at[0]) ** 2)  # x' = A x: the length of the whole motion
        assert time > 0
        assert np.allclose(at[1], expm(A * time / 2) @ at[0], atol=1e-6)
        assert np.allclose(at[2], expm(A * time) @ at[0], atol=1e-6)


def test_lines_of_real_eigenvectors_are_drawn():
    (plot,) = figures(system(KINDS["saddle"]))
    dashed = [curve for curve in plot.curves if curve.style == "dashed"]
    assert len(dashed) == 2
    for curve, value in zip(dashed, (-2, 3), strict=True):
        v = sp.Matrix([curve.x, curve.y]).subs(plot.variable, 1)
        assert sp.Matrix(KINDS["saddle"]) * v == value * v


def test_without_numbers_there_is_no_figure():
    plant = system([[0, 1], [-p, 0]])
    assert ask("phase_portrait", plant).answers["kind"] == "center"
    assert not figures(plant)


a, b = sp.symbols("a b", real=True)
GENERAL = {
    "one sign": ([[0, 1], [-a, -1]], "stable focus", [a <= sp.Rational(1, 4)]),
    "an oscillator": ([[0, 1], [-p, -d]], "stable focus", [4 * p - d**2 <= 0]),
    "trace": ([[0, 1], [-1, a]], "unstable focus", [a <= 0, a >= 2]),
    "two rates": ([[-p, 0], [1, a]], "saddle", [a <= 0]),
    "no chain": ([[a, b], [0, a]], "unstable degenerate node", [a <= 0, sp.Eq(b, 0)]),
    "a zero eigenvalue": ([[a**2 - 2, 0], [0, 0]], "line of equilibria", [sp.Eq(a**2 - 2, 0)]),
    "a shear": ([[0, b], [0, 0]], "shear", [sp.Eq(b, 0)]),
    "surd bounds": ([[0, 1], [a**2 - 5, -1]], "stable focus", [a <= -sp.sqrt(19) / 2, a >= sp.sqrt(19) / 2]),
    "nothing at zero": ([[1 / a, 1], [-1, 0]], "unstable focus", [a <= sp.Rational(1, 2)]),
    "a star": ([[a, 0], [0, a]], "unstable star", [a <= 0]),
}


@pytest.mark.parametrize("name", GENERAL)
def test_parameters_are_taken_as_general_and_the_exceptions_named(name):
    rows, kind, exceptions = GENERAL[name]
    result = ask("phase_portrait", system(rows))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["kind"] == kind
    assert result.answers["exceptions"] == exceptions
    assert "general" in [step.kind for step in result.steps]


@pytest.mark.parametrize("name", GENERAL)
def test_wherever_the_kind_is_another_the_case_says_which(name):
    plant = system(GENERAL[name][0])
    result = ask("phase_portrait", plant)
    cases = next(step.values["others"] for step in result.steps if step.kind == "general")
    symbols = sorted(plant.A.free_symbols, key=str)
    values = [sp.Rational(value, 4) for value in (-12, -8, -4, -1, 0, 1, 2, 4, 5, 8, 12)] + [-sp.sqrt(2)]
    for point in product(values, repeat=len(symbols)):
        here = dict(zip(symbols, point, strict=True))
        if any(value <= 0 for x, value in here.items() if x.is_positive) or plant.A.subs(here).has(sp.zoo):
            continue
        (kind,), _ = stability.kinds_and_exceptions(sp.ImmutableMatrix(plant.A.subs(here)), ())
        holding = [kinds for case, kinds in cases if all(sp.sign(sp.expand(x.subs(here))) == sign for x, sign in case)]
        assert kind in (holding[0] if holding else [result.answers["kind"]]), here
        assert len(holding) < 2


@pytest.mark.parametrize("name", [name for name in GENERAL if len(GENERAL[name][2]) == 1 and name != "a star"])
def test_another_general_kind_with_its_own_exceptions_is_right_too(name):
    rows, kind, (exception,) = GENERAL[name]
    plant = system(rows)
    assert not rejected("phase_portrait", plant, {"kind": kind})
    assert rejected("phase_portrait", plant, {"kind": "center"})
    assert rejected("phase_portrait", plant, {"exceptions": [sp.Not(exception)], "kind": kind})
    assert rejected("phase_portrait", plant, {"exceptions": [], "kind": kind})


def test_a_saddle_is_as_general_as_a_focus():
    plant = system(GENERAL["one sign"][0])
    assert not rejected("phase_portrait", plant, {"kind": "saddle", "exceptions": [a >= 0]})
    for wrong in ([a > 0], [a >= 1], [a <= 0], [a >= 0, a < -1]):
        assert rejected("phase_portrait", plant, {"kind": "saddle", "exceptions": wrong})
        assert rejected("phase_portrait", plant, {"exceptions": wrong}) or wrong == [a <= 0]
    focus = {"kind": "stable focus", "exceptions": [a < sp.Rational(1, 4)]}
    assert rejected("phase_portrait", plant, focus)


def test_a_sum_of_squares_is_no_exception():
    result = ask("phase_portrait", system([[1, a - b], [a - b, -1]]))
    assert (result.status, result.answers["kind"]) == (Status.VERIFIED, "saddle")
    assert "exceptions" not in result.answers


def test_the_sense_of_rotation_is_that_of_the_general_case():
    (step,) = (step for step in ask("phase_portrait", system(GENERAL["one sign"][0])).steps if step.kind == "rotation")
    assert step.values["counterclockwise"] == -1


@tried(12)
@given(st.lists(st.sampled_from([0, 1, -1, 2, a, b, a - b, -a, a + 1]), min_size=4, max_size=4))
def test_generated_matrices_with_parameters_are_verified(entries):
    result = ask("phase_portrait", system([entries[:2], entries[2:]]))
    assert result.status is Status.VERIFIED, (entries, result.reason)


@pytest.mark.parametrize(
    ("plant", "words"),
    [
        ("{matrix: [[1]]}", "two states"),
    ],
)
def test_other_systems_are_refused(plant, words):
    with pytest.raises(InputError) as fault:
        solver.solve(f"title: t\nsystem: {plant}\nfind: {{a: phase_portrait}}\n")
    assert words in fault.value.render()
