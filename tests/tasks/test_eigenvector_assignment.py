"""Assignment of eigenvectors: gains from closed forms, projections by lstsq, corruptions, refusals, marking."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st

from solver.derivation import CheckStatus, Claim, Status
from solver.numeric import check_claim
from solver.stated import Stated
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.marked import verdict
from tests.helpers.tried import tried

I = sp.I
PLANT = system([[0, 1, 0], [0, 0, 1], [-2, -5, -4]], B=[[0, 0], [1, 0], [0, 1]])
ATTAINABLE = {"poles": (-1, -2, -3), "eigenvectors": [[1, 1, 0], [-1, -2, 0], [0, 1, 1]]}
NEAREST = {"poles": (-2, -3, -4), "eigenvectors": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}
PAIR = {"poles": (-1 + 2 * I, -1 - 2 * I, -3), "eigenvectors": [[1, 1, 0], [0, 0, 1], [I, -I, 1]]}
QUESTIONS = (ATTAINABLE, NEAREST, PAIR)


def options(asked):
    return {"poles": tuple(map(sp.sympify, asked["poles"])), "eigenvectors": sp.ImmutableMatrix(asked["eigenvectors"])}


def floats(M):
    return np.array(sp.Matrix(M).evalf(30).tolist(), dtype=complex)


def projected(plant, pole, wanted):
    """The nearest vector (λI − A)⁻¹ B q by least squares in q; the pole is no eigenvalue of A."""
    A, B = floats(plant.A), floats(plant.B)
    columns = np.linalg.solve(complex(pole) * np.eye(len(A)) - A, B)
    return columns @ np.linalg.lstsq(columns, floats(wanted).ravel(), rcond=None)[0]


def angle(u, v):
    return np.linalg.norm(u - v * (v.conj() @ u) / (v.conj() @ v)) / np.linalg.norm(u)


def test_a_gain_worked_by_hand():
    result = ask("pole_placement", PLANT, **options(ATTAINABLE))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["K"] == sp.ImmutableMatrix([[2, 3, 1], [-1, -4, -1]])
    assert result.answers["eigenvectors"] == sp.ImmutableMatrix(ATTAINABLE["eigenvectors"])
    assert result.answers["closed_loop_A"] == sp.ImmutableMatrix([[0, 1, 0], [-2, -3, 0], [-1, -1, -3]])
    s = sp.Symbol("s")
    assert sp.expand(result.answers["polynomial"] - (s + 1) * (s + 2) * (s + 3)) == 0


def test_with_as_many_inputs_as_states_any_matrix_is_the_closed_loop():
    V, Lambda = sp.Matrix([[1, 2, 0], [0, 1, 1], [1, 0, 1]]), sp.diag(-1, -2, -2)
    plant = system([[1, 2, 3], [0, 1, 4], [5, 6, 0]], B=sp.eye(3))
    result = ask("pole_placement", plant, poles=(-sp.S.One, sp.S(-2), sp.S(-2)), eigenvectors=sp.ImmutableMatrix(V))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["K"] == plant.A - V * Lambda * V.inv()


@tried(12)
@given(st.integers(2, 4), st.data())
def test_attainable_vectors_are_given_by_the_gain_of_the_closed_form(n, data):
    m = data.draw(st.integers(2, n))
    entries = st.integers(-2, 2)
    A = sp.Matrix(n, n, data.draw(st.lists(entries, min_size=n * n, max_size=n * n)))
    B = sp.Matrix(n, m, data.draw(st.lists(entries, min_size=n * m, max_size=n * m)))
    W = sp.Matrix(m, n, data.draw(st.lists(st.integers(-3, 3), min_size=n * m, max_size=n * m)))
    poles = [sp.Rational(-2 * i - 7, 2) for i in range(n)]  # no eigenvalue of an integer matrix is half an odd number
    V = sp.Matrix.hstack(*((pole * sp.eye(n) - A).LUsolve(-B * W[:, i]) for i, pole in enumerate(poles)))
    assume(V.det() != 0 and B.rank() == m)
    result = ask("pole_placement", system(A, B=B), poles=tuple(poles), eigenvectors=sp.ImmutableMatrix(V))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["K"] == sp.ImmutableMatrix(W * V.inv())
    assert result.answers["eigenvectors"] == sp.ImmutableMatrix(V)


@tried(12)
@given(st.integers(2, 4), st.booleans(), st.booleans(), st.data())
def test_the_nearest_vectors_are_those_of_lstsq_and_eigenvectors_for_numpy(n, pair, discrete, data):
    m = data.draw(st.integers(2, n))
    entries = st.integers(-2, 2)
    A = sp.Matrix(n, n, data.draw(st.lists(entries, min_size=n * n, max_size=n * n)))
    B = sp.Matrix(n, m, data.draw(st.lists(entries, min_size=n * m, max_size=n * m)))
    wanted = sp.Matrix(n, n, data.draw(st.lists(st.integers(-3, 3), min_size=n * n, max_size=n * n)))
    poles = [sp.Rational(-2 * i - 7, 2) for i in range(n)]
    if pair:
        poles[:2] = [sp.Rational(-1, 2) + I, sp.Rational(-1, 2) - I]
        wanted[:, 0] = wanted[:, 0] + I * wanted[:, 1]
        wanted[:, 1] = wanted[:, 0].conjugate()
    assume(all(not wanted[:, i].is_zero_matrix for i in range(n)))
    plant = system(A, B=B, discrete=discrete)
    result = ask("pole_placement", plant, poles=tuple(poles), eigenvectors=sp.ImmutableMatrix(wanted))
    assert result.status in (Status.VERIFIED, Status.UNSOLVED), result.reason
    nearest = [projected(plant, pole, wanted[:, i]) for i, pole in enumerate(poles)]
    together = np.array([v / (np.linalg.norm(v) or 1) for v in nearest])
    if result.status is Status.UNSOLVED:
        assert np.linalg.svd(together)[1].min() < 1e-9
        return
    loop, V = floats(result.answers["closed_loop_A"]), floats(result.answers["eigenvectors"])
    for i, pole in enumerate(poles):
        assert angle(V[:, i], nearest[i]) < 1e-7
        assert np.allclose(loop @ V[:, i], complex(pole) * V[:, i], atol=1e-7 * (1 + np.abs(loop).max()))
    assert not result.answers["K"].has(I)


@pytest.mark.parametrize("asked", QUESTIONS, ids=["attainable", "nearest", "pair"])
@pytest.mark.parametrize("name", ["K", "closed_loop_A", "eigenvectors"])
def test_each_answer_alone_is_accepted_and_each_corruption_rejected(asked, name):
    answer = ask("pole_placement", PLANT, **options(asked)).answers[name]
    assert not rejected("pole_placement", PLANT, {name: answer}, **options(asked))
    for i in range(len(answer)):
        changed = answer.as_mutable()
        changed[i] += sp.Rational(1, 1000)
        j = i % answer.cols
        rescaled = name == "eigenvectors" and sp.Matrix.hstack(answer[:, j], changed[:, j]).rank() == 1
        assert rescaled is not rejected(
            "pole_placement", PLANT, {name: sp.ImmutableMatrix(changed)}, **options(asked)
        ), changed


def test_a_gain_with_the_right_poles_and_other_eigenvectors_is_rejected():
    K = ask("pole_placement", PLANT, "unity_rank", poles=options(NEAREST)["poles"]).answers["K"]
    assert not rejected("pole_placement", PLANT, {"K": K}, poles=options(NEAREST)["poles"])
    assert rejected("pole_placement", PLANT, {"K": K}, **options(NEAREST))
    loop = sp.ImmutableMatrix(PLANT.A - PLANT.B * K)
    assert rejected("pole_placement", PLANT, {"closed_loop_A": loop}, **options(NEAREST))


def test_eigenvectors_are_right_up_to_their_scale_and_wrong_in_another_order():
    V = sp.Matrix(ATTAINABLE["eigenvectors"])
    scaled = sp.ImmutableMatrix(V * sp.diag(2, -1, sp.Rational(1, 3)))
    assert not rejected("pole_placement", PLANT, {"eigenvectors": scaled}, **options(ATTAINABLE))
    for wrong in (V[:, [1, 0, 2]], V * sp.diag(1, 0, 1), V[:, :2]):
        assert rejected("pole_placement", PLANT, {"eigenvectors": sp.ImmutableMatrix(wrong)}, **options(ATTAINABLE))


@pytest.mark.parametrize("asked", QUESTIONS, ids=["attainable", "nearest", "pair"])
def test_claims_hold_and_corrupted_ones_do_not(asked):
    result = ask("pole_placement", PLANT, **options(asked))
    claims = [claim for step in result.steps for each in step.walk() for claim in each.claims.values()]
    assert len(claims) > 15
    for claim in claims:
        assert check_claim(claim, "").status is CheckStatus.PASSED
        if isinstance(claim.right, Stated):  # a line on the way, which the next claim goes on from
            continue
        shift = sp.ones(*claim.right.shape) if isinstance(claim.right, sp.MatrixBase) else 1
        wrong = claim.right + shift * sp.Rational(1, 1000)
        wrong = sp.ImmutableMatrix(wrong) if isinstance(wrong, sp.MatrixBase) else wrong
        assert check_claim(Claim(claim.left, wrong), "").status is CheckStatus.FAILED, claim


def test_how_far_a_vector_is_from_the_one_asked_for_is_said():
    steps = {
        step.values["i"]: step.values["degrees"]
        for step in ask("pole_placement", PLANT, **options(NEAREST)).steps
        if step.kind == "nearest"
    }
    cosines = [1 / np.sqrt(5), 3 / np.sqrt(10), 1]  # of e₁ to (1, −2, 0), of e₂ to (1, −3, 0), of e₃ to itself
    assert np.allclose([float(steps[i]) for i in (1, 2, 3)], np.degrees(np.arccos(cosines)))


@pytest.mark.parametrize("method", ["bass_gura", "canonical_form", "ackermann", "unity_rank"])
def test_the_eigenvectors_decide_whatever_the_method(method):
    result = ask("pole_placement", PLANT, method, **options(PAIR))
    assert result.answers == ask("pole_placement", PLANT, **options(PAIR)).answers


def test_a_pair_may_be_given_by_any_multiple_of_the_conjugate():
    turned = sp.Matrix(PAIR["eigenvectors"]) * sp.diag(1 + I, 3, 1)
    one, other = (
        ask("pole_placement", PLANT, **options({**PAIR, "eigenvectors": V})) for V in (PAIR["eigenvectors"], turned)
    )
    assert one.status is other.status is Status.VERIFIED
    assert one.answers["K"] == other.answers["K"]


def test_an_uncontrollable_mode_keeps_its_place_and_has_vectors_of_its_own():
    plant = system([[1, 0, 0], [1, -1, 0], [0, 0, -2]], B=[[1, 0], [0, 1], [0, 0]])
    asked = {"poles": (-2, -3, -4), "eigenvectors": [[1, 1, 0], [2, 0, 1], [1, 0, 0]]}
    result = ask("pole_placement", plant, **options(asked))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["fixed_poles"] == [-2]
    V = sp.Matrix(asked["eigenvectors"])
    assert result.answers["eigenvectors"] == V
    assert result.answers["closed_loop_A"] == V * sp.diag(-2, -3, -4) * V.inv()


def test_inputs_that_do_the_same_leave_the_gain_free():
    plant = system([[0, 1], [0, 0]], B=[[1, 2, 0], [0, 0, 1]])
    asked = {"poles": (sp.S(-1), sp.S(-2)), "eigenvectors": sp.ImmutableMatrix([[1, 0], [0, 1]])}
    result = ask("pole_placement", plant, **asked)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["closed_loop_A"] == sp.diag(-1, -2)
    for K in ([[1, 1], [0, 0], [0, 2]], [[-1, 3], [1, -1], [0, 2]]):
        assert not rejected("pole_placement", plant, {"K": sp.ImmutableMatrix(K)}, **asked)
    assert rejected("pole_placement", plant, {"K": sp.ImmutableMatrix([[1, 1], [1, 0], [0, 2]])}, **asked)


def test_symbols_and_surds_stay_exact():
    a, p = sp.Symbol("a", real=True), sp.Symbol("p", real=True)
    plant = system([[0, 1], [a, 0]], B=sp.eye(2))
    V = sp.ImmutableMatrix([[1, 1], [1, sp.sqrt(2)]])
    result = ask("pole_placement", plant, poles=(p, -sp.sqrt(2)), eigenvectors=V)
    assert result.status is Status.VERIFIED, result.reason
    expected = plant.A - V * sp.diag(p, -sp.sqrt(2)) * V.inv()
    assert all(sp.radsimp(sp.expand(gap)).expand() == 0 for gap in result.answers["K"] - expected)


@pytest.mark.parametrize(
    ("rows", "inputs", "asked", "says"),
    [
        ("PLANT", None, {"poles": (-1, -1, -1), "eigenvectors": sp.eye(3)}, "asked for 3 times"),
        ("PLANT", None, {"poles": (-1, -2, -2), "eigenvectors": [[1, 1, 2], [-1, -2, -4], [0, 1, 2]]}, "dependent"),
        ("PLANT", None, {"poles": (-1, -2, -3), "eigenvectors": [[1, 1, 0], [1, -2, 0], [0, 1, 1]]}, "orthogonal"),
        ([[1, 0], [0, -2]], [[1, 1], [0, 0]], {"poles": (-1, -3), "eigenvectors": sp.eye(2)}, "uncontrollable"),
    ],
)
def test_what_no_gain_gives_is_unsolved_with_the_reason(rows, inputs, asked, says):
    plant = PLANT if rows == "PLANT" else system(rows, B=inputs)
    result = ask("pole_placement", plant, **options(asked))
    assert result.status is Status.UNSOLVED
    assert says in str(result.reason)


@pytest.mark.parametrize(
    ("changed", "at", "says"),
    [
        ({"eigenvectors": [[1, 1], [0, 1], [1, 0]]}, "eigenvectors", "3 columns are to be given, not 2"),
        ({"eigenvectors": [[1, 1, 0], [0, 1, 1]]}, "eigenvectors", "it must be 3×3"),
        ({"eigenvectors": [[1, 0, 0], [0, 0, 1], [1, 0, 0]]}, "eigenvectors", "column 2 is zero"),
        ({"eigenvectors": [[1, 0, 0], [0, 1, I], [1, 0, 1]]}, "eigenvectors", "column 3 is complex"),
        ({"poles": (-1, -2)}, "poles", "give 3, not 2"),
        (
            {"poles": (-1 + I, -1 - I, -3), "eigenvectors": [[1, 1, 0], [I, I, 1], [0, 0, 1]]},
            "eigenvectors",
            "conjugate to column 1 is 1, - j, 0",
        ),
    ],
)
def test_what_the_file_shows_to_be_wrong_is_refused(changed, at, says):
    asked = options({**ATTAINABLE, **changed})
    faults = list(catalogue()["pole_placement"].refused(PLANT, asked))
    assert [option for option, _ in faults] == [at], faults
    assert says in str(faults[0][1])


def test_with_one_input_there_is_nothing_to_choose():
    plant = system([[0, 1], [0, 0]], B=[0, 1])
    asked = {"poles": (sp.S(-1), sp.S(-2)), "eigenvectors": sp.ImmutableMatrix([[1, 1], [-1, -2]])}
    ((option, reason),) = catalogue()["pole_placement"].refused(plant, asked)
    assert option == "eigenvectors"
    assert "with one input the poles decide them" in str(reason)


def test_poles_of_the_controllable_part_alone_are_too_few():
    plant = system([[1, 0, 0], [1, -1, 0], [0, 0, -2]], B=[[1, 0], [0, 1], [0, 0]])
    asked = {"poles": (sp.S(-3), sp.S(-4)), "eigenvectors": sp.ImmutableMatrix([[1, 0], [0, 1], [0, 0]])}
    assert not list(catalogue()["pole_placement"].refused(plant, {"poles": asked["poles"]}))
    ((option, reason),) = catalogue()["pole_placement"].refused(plant, asked)
    assert option == "poles"
    assert "all 3 poles" in str(reason)


MARKED = """
title: Eigenvectors
system: {A: [[0, 1, 0], [0, 0, 1], [-2, -5, -4]], B: [[0, 0], [1, 0], [0, 1]]}
find:
  had: {task: pole_placement, poles: [-1, -2, -3], eigenvectors: [[1, 1, 0], [-1, -2, 0], [0, 1, 1]]}
  near: {task: pole_placement, poles: [-2, -3, -4], eigenvectors: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}
"""


@pytest.mark.parametrize(
    ("part", "name", "written", "right"),
    [
        ("had", "K", "[[2, 3, 1], [-1, -4, -1]]", True),
        ("had", "K", "[[2.0, 3.0, 1.0], [-1.0, -4.0, -1.0]]", True),
        ("had", "K", "[[2.1, 3.0, 1.0], [-1.0, -4.0, -1.0]]", False),
        ("had", "eigenvectors", "[[2, -1, 0], [-2, 2, 0], [0, -1, 4]]", True),
        ("near", "eigenvectors", "[[1, 1, 0], [-2, -3, 0], [0, 0, 1]]", True),
        ("near", "eigenvectors", "[[0.4472, 0.3162, 0], [-0.8944, -0.9487, 0], [0, 0, 1]]", True),
        ("near", "eigenvectors", "[[0.4772, 0.3162, 0], [-0.8944, -0.9487, 0], [0, 0, 1]]", False),
    ],
)
def test_marking_judges_by_what_is_asked(part, name, written, right):
    found = verdict(MARKED, part, name, written)
    assert (found.verdict.value == "correct") is right, found.reason


def test_the_vectors_asked_for_in_place_of_those_attained_are_named():
    found = verdict(MARKED, "near", "eigenvectors", "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]")
    assert "not all of them are attainable" in str(found.reason)
