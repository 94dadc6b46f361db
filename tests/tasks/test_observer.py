"""Observers of full order: the course's examples, python-control, random plants by every method, refusals."""

import control
import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.signal import place_poles

from solver.derivation import Status
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

R, I = sp.Rational, sp.I
METHODS = ["coefficient_matching", "bass_gura", "canonical_form", "ackermann"]
COMPANION = [[0, 1, 0], [0, 0, 1], [-4, -4, -1]]
PLANT = system(COMPANION, B=[0, 0, 1], C=[[1, 0, 0]])
POLES = [R(-1), R(-2), R(-3)]


def floats(matrix):
    return np.array(matrix.tolist(), dtype=float).reshape(matrix.shape)


def polynomial(matrix, x="s"):
    return sp.expand(matrix.charpoly(sp.Symbol(x)).as_expr())


COURSE = [
    (system([[0, 1], [-1, -2]], B=[0, 1], C=[[0, 1]]), [R(-1, 4), R(-1, 2)], [R(7, 8), R(-5, 4)]),
    (PLANT, POLES, [5, 2, -20]),
    (system([[0, 1, 0], [0, 0, 1], [-5, -10, -5]], C=[[0, 0, 1]]), [-5 + 4 * I, -5 - 4 * I, R(-10)], None),
]


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(("plant", "poles", "L"), COURSE)
def test_the_examples_of_the_course(plant, poles, L, method):
    result = ask("observer", plant, method, poles=poles)
    assert result.status is Status.VERIFIED, result.reason
    if L is not None:
        assert result.answers["L"] == sp.Matrix(L)
    expected = control.acker(floats(plant.A).T, floats(plant.C).T, [complex(pole) for pole in poles]).reshape(-1, 1)
    assert np.allclose(floats(result.answers["L"]), expected)
    assert result.answers["error_A"] == plant.A - result.answers["L"] * plant.C


def test_the_gain_polynomial_of_the_course_example():
    plant = COURSE[0][0]
    answers = ask("observer", plant, "coefficient_matching", poles=COURSE[0][1]).answers
    s, l1, l2 = sp.symbols("s l1 l2")
    assert sp.expand(answers["gain_polynomial"] - (s**2 + (2 + l2) * s + 1 - l1)) == 0
    assert answers["polynomial"] == s**2 + R(3, 4) * s + R(1, 8)


@tried(12)
@given(systems(4), st.data())
def test_every_method_gives_the_same_gain_of_one_output(A, data):
    n = A.rows
    C = sp.ImmutableMatrix(1, n, [data.draw(st.integers(-2, 2)) for _ in range(n)])
    assume(sp.Matrix.vstack(*(C * A**k for k in range(n))).rank() == n)
    plant = system(A, C=C, discrete=data.draw(st.booleans()))
    poles = [data.draw(st.sampled_from([R(-1, 2), R(-1, 3), R(0), R(-2)])) for _ in range(n)]
    results = [ask("observer", plant, method, poles=poles) for method in METHODS]
    for result in results:
        assert result.status is Status.VERIFIED, result.reason
        assert result.answers["L"] == results[0].answers["L"]
        assert result.answers["error_A"] == A - result.answers["L"] * C
    x = sp.Symbol("z" if plant.discrete else "s")
    wanted = sp.expand(sp.prod(x - pole for pole in poles))
    assert polynomial(results[0].answers["error_A"], x.name) == wanted
    assert sp.expand(results[0].answers["polynomial"] - wanted) == 0


@tried(12)
@given(systems(4), st.data())
def test_several_outputs_get_a_gain_of_rank_one_after_a_preliminary_one(A, data):
    n = A.rows
    assume(n >= 2)
    C = sp.ImmutableMatrix(2, n, [data.draw(st.integers(-2, 2)) for _ in range(2 * n)])
    assume(sp.Matrix.vstack(*(C * A**k for k in range(n))).rank() == n)
    poles = [-1 + I, -1 - I, *[R(-k - 2) for k in range(n - 2)]]
    result = ask("observer", system(A, C=C), "unity_rank", poles=poles)
    assert result.status is Status.VERIFIED, result.reason
    s = sp.Symbol("s")
    assert polynomial(A - result.answers["L"] * C) == sp.expand(sp.prod(s - pole for pole in poles))


def test_another_gain_of_several_outputs_is_right_too():
    A = [[0, 1, 0], [0, 0, 1], [-4, -4, -1]]
    plant = system(A, C=[[1, 0, 0], [0, 0, 1]])
    ours = ask("observer", plant, "unity_rank", poles=POLES).answers["L"]
    theirs = place_poles(floats(plant.A).T, floats(plant.C).T, [-1.0, -2.0, -3.0]).gain_matrix.T
    assert not np.allclose(floats(ours), theirs)
    L = sp.ImmutableMatrix(theirs.tolist())
    assert not rejected("observer", plant, {"L": L}, poles=POLES)
    assert rejected("observer", plant, {"L": 2 * sp.nsimplify(L, rational=True)}, poles=POLES)
    wrong = sp.ImmutableMatrix(sp.Matrix(A) - ours * plant.C + sp.Matrix([[0, 1, 0], [0, 0, 0], [0, 0, 0]]))
    assert rejected("observer", plant, {"error_A": wrong}, poles=POLES)


def test_the_dual_is_explained_and_tested():
    steps = ask("observer", PLANT, "ackermann", poles=POLES).steps
    duality = next(step for step in steps if step.kind == "duality")
    assert set(duality.claims) == {"dual"}


def corruptions(value):
    if isinstance(value, sp.MatrixBase):
        yield sp.ImmutableMatrix(-value)
        yield sp.ImmutableMatrix(value * R(101, 100))
        for i in range(len(value)):
            changed = value.as_mutable()
            changed[i] = changed[i] + R(1, 100)
            yield sp.ImmutableMatrix(changed)
    else:
        s = sp.Symbol("s")
        yield value + R(1, 100)
        yield value * 2
        yield value.subs(s, -s)
        yield value + s


@pytest.mark.parametrize("name", list(catalogue()["observer"].answers))
def test_every_answer_alone_is_accepted_and_its_corruptions_rejected(name):
    answers = ask("observer", PLANT, "coefficient_matching", poles=POLES).answers
    assert not rejected("observer", PLANT, {name: answers[name]}, poles=POLES)
    for corrupted in corruptions(answers[name]):
        assert rejected("observer", PLANT, {name: corrupted}, poles=POLES), corrupted


@pytest.mark.parametrize("method", METHODS)
def test_a_detectable_plant_keeps_its_fixed_eigenvalue(method):
    plant = system([[-2, 0, 0], [0, -3, 1], [0, 0, -1]], C=[[0, 1, 0]])
    for poles in ([R(-6), R(-7)], [R(-6), R(-7), R(-2)]):
        result = ask("observer", plant, method, poles=poles)
        assert result.status is Status.VERIFIED, result.reason
        assert not result.answers["L"].free_symbols
        assert sorted(result.answers["error_A"].eigenvals()) == [-7, -6, -2]


def test_an_undetectable_plant_is_refused_in_words():
    plant = system([[0, 0, 0], [0, -3, 1], [0, 0, -1]], C=[[0, 1, 0]])
    result = ask("observer", plant, poles=[R(-6), R(-7)])
    assert result.status is Status.UNSOLVED
    assert "not detectable" in str(result.reason)
    assert "lambda = 0" in str(result.reason)


def test_a_mode_inside_the_unit_circle_is_detectable_in_discrete_time_only():
    A, C = [[R(1, 2), 0], [0, 2]], [[0, 1]]
    assert ask("observer", system(A, C=C, discrete=True), poles=[R(0)]).status is Status.VERIFIED
    assert ask("observer", system(A, C=C), poles=[R(-1)]).status is Status.UNSOLVED


def test_a_wrong_number_of_poles_is_refused():
    faults = list(catalogue()["observer"].refused(PLANT, {"poles": POLES[:2]}))
    assert [option for option, _ in faults] == ["poles"]
    assert "n = 3" in str(faults[0][1])
    assert not list(catalogue()["observer"].refused(PLANT, {"poles": None}))


def test_parameters_stay_symbols():
    a, b, p, q = sp.symbols("a b p q")
    plant = system([[a, 1], [b, 2]], C=[[1, 0]])
    for method in METHODS:
        result = ask("observer", plant, method, poles=[p, q])
        assert result.status is Status.VERIFIED, result.reason
        expected = sp.Matrix([a + 2 - p - q, b + (2 - p) * (2 - q)])
        assert (result.answers["L"] - expected).expand() == sp.zeros(2, 1)
