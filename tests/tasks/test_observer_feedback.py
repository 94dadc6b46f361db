"""Feedback of estimates: separation, simulation, compensators against python-control, corruptions, refusals."""

import control
import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.linalg import expm

from solver.derivation import CheckStatus, Claim, Status
from solver.numeric import check_claim
from solver.render.wording import Wording
from solver.stated import Stated
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

R, I = sp.Rational, sp.I
s = sp.Symbol("s")
COMPANION = [[0, 1, 0], [0, 0, 1], [-4, -4, -1]]
PLANT = system(COMPANION, B=[0, 0, 1], C=[[1, 0, 0]], D=[[0]])
POLES = [R(-2), -2 + 2 * I, -2 - 2 * I]
FULL = {"poles": POLES, "observer_poles": [R(-1), R(-2), R(-3)]}
REDUCED = {"poles": POLES, "observer_poles": [R(-5), R(-5)], "reduced": True}


def floats(matrix):
    return np.array(matrix.tolist(), dtype=float).reshape(matrix.shape)


def test_the_closed_loop_of_the_course_with_an_observer_of_full_order():
    answers = ask("observer_feedback", PLANT, **FULL).answers
    K, L = sp.Matrix([[12, 12, 5]]), sp.Matrix([5, 2, -20])
    A, B, C = PLANT.A, PLANT.B, PLANT.C
    assert answers["closed_loop_A"] == sp.Matrix([[A - B * K, B * K], [sp.zeros(3), A - L * C]])
    assert sorted(map(str, answers["eigenvalues"])) == sorted(map(str, [*POLES, R(-1), R(-2), R(-3)]))


MEASURED = [  # lecture note, section 4.6, examples 3 to 5: closed loop in (η₁, η₂, η₂ − η̂₂), printed ones corrected
    (0, [[0, 1, 0, 0, 0], [0, 0, 1, 0, 0], [-16, -16, -6, 12, 5], [0, 0, 0, -9, 1], [0, 0, 0, -16, -1]]),
    (1, [[0, 0, 1, 0, 0], [1, 0, 0, 0, 0], [-16, -16, -6, 12, 5], [0, 0, 0, 0, R(25, 4)], [0, 0, 0, -4, -10]]),
    (2, [[-6, -16, -16, 12, 12], [0, 0, 1, 0, 0], [1, 0, 0, 0, 0], [0, 0, 0, 15, 16], [0, 0, 0, -25, -25]]),
]


@pytest.mark.parametrize(("state", "expected"), MEASURED)
def test_the_closed_loops_of_the_course_with_an_observer_of_reduced_order(state, expected):
    plant = system(COMPANION, B=[0, 0, 1], C=[[int(j == state) for j in range(3)]])
    result = ask("observer_feedback", plant, **REDUCED)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["closed_loop_A"] == sp.Matrix(expected)
    assert result.answers["S1"] == sp.Matrix([int(j == state) for j in range(3)])


def transfer(value, variable):
    """A matrix of rational functions as a system of python-control."""
    entries = value.tolist() if isinstance(value, sp.MatrixBase) else [[value]]
    fractions = [[sp.fraction(sp.together(entry)) for entry in row] for row in entries]
    numerators, denominators = (
        [[[float(c) for c in sp.Poly(pair[k], variable).all_coeffs()] for pair in row] for row in fractions]
        for k in (0, 1)
    )
    return (
        control.ss(control.tf(numerators, denominators))
        if len(entries) > 1 or len(entries[0]) > 1
        else control.tf(numerators[0][0], denominators[0][0])
    )


@pytest.mark.parametrize("options", [FULL, REDUCED], ids=["full", "reduced"])
@pytest.mark.parametrize("through", [0, 2])
def test_the_compensator_closes_the_loop_in_python_control(options, through):
    plant = system(COMPANION, B=[0, 0, 1], C=[[1, 0, 0]], D=[[through]])
    result = ask("observer_feedback", plant, **options)
    assert result.status is Status.VERIFIED, result.reason
    G = transfer(result.answers["compensator"], s)
    loop = control.feedback(control.ss(floats(plant.A), floats(plant.B), floats(plant.C), floats(plant.D)), G, sign=1)
    wanted = [complex(value) for value in result.answers["eigenvalues"]]
    assert np.allclose(np.poly(loop.poles()), np.poly(wanted), rtol=1e-6, atol=1e-6)


def test_the_compensator_of_full_order_is_minus_k_resolvent_l():
    answers = ask("observer_feedback", PLANT, **FULL).answers
    K, L = sp.Matrix([[12, 12, 5]]), sp.Matrix([5, 2, -20])
    F = PLANT.A - PLANT.B * K - L * PLANT.C
    expected = (-K * (s * sp.eye(3) - F).inv() * L)[0]
    assert sp.cancel(answers["compensator"] - expected) == 0


def test_a_simulated_loop_follows_the_matrix_given():
    result = ask("observer_feedback", PLANT, **FULL)
    whole = floats(result.answers["closed_loop_A"])
    A, B, C = floats(PLANT.A), floats(PLANT.B), floats(PLANT.C)
    K, L = np.array([[12.0, 12.0, 5.0]]), np.array([[5.0], [2.0], [-20.0]])
    together = np.block([[A, -B @ K], [L @ C, A - B @ K - L @ C]])  # in (x, x̂)
    x, estimate = np.array([1.0, -2.0, 0.5]), np.array([0.0, 1.0, 0.0])
    for t in (0.3, 1.4):
        state = expm(together * t) @ np.concatenate([x, estimate])
        ours = expm(whole * t) @ np.concatenate([x, x - estimate])
        assert np.allclose(ours, np.concatenate([state[:3], state[:3] - state[3:]]))


@pytest.mark.parametrize("reduced", [False, True])
def test_gains_may_be_given_in_place_of_poles(reduced):
    designed = ask("observer_feedback", PLANT, **(REDUCED if reduced else FULL)).answers
    L = sp.ImmutableMatrix([9, 12] if reduced else [5, 2, -20])
    K = sp.ImmutableMatrix([[12, 12, 5]])
    result = ask("observer_feedback", PLANT, gain=K, observer_gain=L, reduced=reduced)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["closed_loop_A"] == designed["closed_loop_A"]
    assert sp.cancel(result.answers["compensator"] - designed["compensator"]) == 0
    assert {"given_feedback", "given_observer"} <= {step.kind for step in result.steps}


@st.composite
def plants(draw):
    """A random plant with up to two inputs and outputs, controllable and observable."""
    A = draw(systems(3))
    n, small = A.rows, st.integers(-2, 2)
    m, p = draw(st.integers(1, 2)), draw(st.integers(1, 2))
    B = sp.ImmutableMatrix(n, m, [draw(small) for _ in range(n * m)])
    C = sp.ImmutableMatrix(p, n, [draw(small) for _ in range(n * p)])
    D = sp.ImmutableMatrix(p, m, [draw(st.integers(0, 1)) for _ in range(m * p)])
    assume(C.rank() == p)
    assume(sp.Matrix.hstack(*(A**k * B for k in range(n))).rank() == n)
    assume(sp.Matrix.vstack(*(C * A**k for k in range(n))).rank() == n)
    return system(A, B=B, C=C, D=D, discrete=draw(st.booleans()))


@tried(15)
@given(plants(), st.booleans())
def test_random_plants_are_closed_with_both_spectra(plant, reduced):
    n, p = plant.order, plant.C.rows
    assume(not reduced or p < n)
    poles = [R(-1, k + 2) for k in range(n)]
    observer = [R(1, k + 3) for k in range(n - p if reduced else n)]
    result = ask("observer_feedback", plant, poles=poles, observer_poles=observer, reduced=reduced)
    if result.status is Status.UNSOLVED:
        assert reduced
        assert "well posed" in str(result.reason)
        return
    assert result.status is Status.VERIFIED, result.reason
    whole = result.answers["closed_loop_A"]
    expected = sp.expand(sp.prod(s - pole for pole in (*poles, *observer)))
    assert sp.expand(whole.charpoly(s).as_expr() - expected) == 0


@pytest.mark.parametrize("reduced", [False, True])
def test_plants_in_part_hidden_keep_their_fixed_eigenvalues(reduced):
    plant = system([[-3, 0, 0], [1, -7, 0], [0, 1, 2]], B=[0, 1, 0], C=[[0, 0, 1]])
    L = [R(-1)] * (2 if reduced else 3)
    result = ask("observer_feedback", plant, poles=[R(-4), R(-5)], observer_poles=L, reduced=reduced)
    assert result.status is Status.VERIFIED, result.reason
    assert sorted(result.answers["eigenvalues"]) == sorted([-4, -5, -3, *L])
    unseen = system([[-3, 1, 0], [0, -7, 1], [0, 0, 2]], B=[0, 0, 1], C=[[0, 1, 0]])
    seen = [R(-1)] * (1 if reduced else 2)
    result = ask("observer_feedback", unseen, poles=[R(-4), R(-5), R(-6)], observer_poles=seen, reduced=reduced)
    assert result.status is Status.VERIFIED, result.reason
    assert sorted(result.answers["eigenvalues"]) == sorted([-4, -5, -6, -3, *seen])


def corruptions(name, value):
    if isinstance(value, sp.MatrixBase):
        yield sp.ImmutableMatrix(-value)
        for i in range(len(value)):
            changed = value.as_mutable()
            changed[i] = changed[i] + R(1, 100)
            yield sp.ImmutableMatrix(changed)
    elif isinstance(value, list):
        yield [-each for each in value]
        yield value[:-1]
        yield [value[0] + R(1, 100), *value[1:]]
    else:
        yield -value
        yield value * R(101, 100)
        yield value + R(1, 100)
        yield value.subs(s, s + R(1, 10))


@pytest.mark.parametrize("options", [FULL, REDUCED], ids=["full", "reduced"])
@pytest.mark.parametrize("name", list(catalogue()["observer_feedback"].answers))
def test_every_answer_alone_is_accepted_and_its_corruptions_rejected(name, options):
    answers = ask("observer_feedback", PLANT, **options).answers
    if name not in answers:
        assert name in ("S1", "S2")
        return
    assert not rejected("observer_feedback", PLANT, {name: answers[name]}, **options)
    for corrupted in corruptions(name, answers[name]):
        assert rejected("observer_feedback", PLANT, {name: corrupted}, **options), corrupted


COMBINED = system(COMPANION, B=[0, 0, 1], C=[[3, 1, 0]])
"""Its output is no state: the coordinates of an observer of reduced order are those of the answers S1 and S2."""


@pytest.mark.parametrize(
    ("plant", "given_S1", "given_S2", "judged"),
    [
        (COMBINED, True, True, True),
        (COMBINED, True, False, False),
        (COMBINED, False, True, False),
        (PLANT, False, False, True),
    ],
)
def test_the_closed_loop_is_judged_where_the_coordinates_are_known(plant, given_S1, given_S2, judged):
    answers = ask("observer_feedback", plant, **REDUCED).answers
    chosen = {"closed_loop_A": answers["closed_loop_A"]}
    chosen |= {"S1": answers["S1"]} if given_S1 else {}
    chosen |= {"S2": answers["S2"]} if given_S2 else {}
    assert not rejected("observer_feedback", plant, chosen, **REDUCED)
    wrong = {**chosen, "closed_loop_A": sp.ImmutableMatrix(2 * chosen["closed_loop_A"])}
    assert rejected("observer_feedback", plant, wrong, **REDUCED) == judged


def test_a_convention_is_stronger_than_the_coordinates_of_an_answer():
    answers = ask("observer_feedback", PLANT, **REDUCED).answers
    other = {**answers, "S1": sp.ImmutableMatrix(2 * answers["S1"])}
    loop = sp.diag(sp.Rational(1, 2), *[1] * 4) * answers["closed_loop_A"] * sp.diag(2, *[1] * 4)
    assert rejected("observer_feedback", PLANT, {**other, "closed_loop_A": sp.ImmutableMatrix(loop)}, **REDUCED)


def test_a_loop_that_is_not_well_posed_is_refused_in_words():
    A, B, C = [[0, 1], [0, 0]], [0, 1], [[1, 0]]
    K, L = sp.ImmutableMatrix([[1, 2]]), sp.ImmutableMatrix([3])
    D = R(1) / (K[0] + K[1] * L[0])
    result = ask("observer_feedback", system(A, B=B, C=C, D=[[D]]), gain=K, observer_gain=L, reduced=True)
    assert result.status is Status.UNSOLVED
    assert "well posed" in str(result.reason)


REFUSED = [
    ({"poles": POLES}, "observer_poles"),
    ({"observer_poles": POLES}, "'poles' or 'gain'"),
    ({**FULL, "gain": sp.ImmutableMatrix([[1, 2, 3]])}, "not both"),
    ({**FULL, "poles": POLES[:1]}, "n = 3"),
    ({**FULL, "reduced": True}, "order"),
    ({"poles": POLES, "observer_gain": sp.ImmutableMatrix([1, 2, 3]), "reduced": True}, "2×1"),
]


@pytest.mark.parametrize(("options", "words"), REFUSED)
def test_what_the_file_shows_to_be_wrong_is_refused(options, words):
    faults = list(catalogue()["observer_feedback"].refused(PLANT, options))
    assert any(words in str(message) for _, message in faults), faults


def test_options_from_earlier_parts_are_known_to_be_given():
    assert not list(catalogue()["observer_feedback"].refused(PLANT, {"gain": None, "observer_gain": None}))


def corrupted_sides(right):
    if isinstance(right, Stated):
        for i, operand in enumerate(right.operands):
            for corrupted in corrupted_sides(operand):
                yield Stated(right.operation, (*right.operands[:i], corrupted, *right.operands[i + 1 :]))
    elif isinstance(right, sp.MatrixBase):
        for i in range(len(right)):
            changed = right.as_mutable()
            changed[i] = changed[i] + R(1, 1000)
            yield sp.ImmutableMatrix(changed)
    elif isinstance(right, sp.Expr):
        yield right + R(1, 1000)


TWO = system(COMPANION, B=[[1, 0], [0, 0], [0, 1]], C=[[3, 1, 0], [0, 0, 1]], D=[[0, 1], [0, 0]])
QUESTIONS = [
    ("observer_feedback", PLANT, FULL),
    ("observer_feedback", PLANT, REDUCED),
    ("observer_feedback", TWO, {"poles": POLES, "observer_poles": [R(-5)], "reduced": True}),
    ("observer", system([[2, 0, 0], [0, 2, 0], [0, 1, 1]], C=[[1, 1, 0], [0, 0, 1]]), {"poles": POLES}),
    ("reduced_observer", TWO, {"poles": [R(-5)]}),
]


@pytest.mark.parametrize(("task", "plant", "options"), QUESTIONS)
def test_corrupted_claims_are_rejected(task, plant, options):
    result = ask(task, plant, **options)
    assert result.status is Status.VERIFIED, result.reason
    claims = [claim for step in result.steps for each in step.walk() for claim in each.claims.values()]
    for claim in claims:
        for corrupted in corrupted_sides(claim.right):
            if check_claim(Claim(claim.right, corrupted), "").status is not CheckStatus.PASSED:
                assert check_claim(Claim(claim.left, corrupted), "").status is CheckStatus.FAILED, claim


def lines_of(plant, **options):
    result = ask("observer_feedback", plant, **options)
    assert result.status is Status.VERIFIED, result.reason
    return "\n".join(each.markdown for step in Wording(detail="tutor").words(result.steps) for each in step.walk())


def test_a_compensator_is_multiplied_out_at_tutor():
    told = lines_of(PLANT, **REDUCED)
    for line in (
        r"12 + 12 \cdot 9 + 5 \cdot 12 = 180",
        r"\omega - 180y",
        r"\operatorname{adj}\begin{bmatrix}s + 9 & -1 \\ 28 & s + 6\end{bmatrix}",
        r"- 180(s^{2} + 15s + 82) = -180s^{2} - 172s - 72",
    ):
        assert line in told
    assert "row $i$ and column $j$ are struck out" in lines_of(PLANT, **FULL)


def test_the_equations_of_a_compensator_of_one_state_have_no_brackets():
    plant = system([[0, 1], [0, 0]], B=[0, 1], C=[[1, 0]], D=[[0]])
    told = lines_of(plant, poles=[R(-1), R(-2)], observer_poles=[R(-4)], reduced=True)
    assert r"\dot{\omega} = -7\omega - 30y" in told
    assert r"u = -3\omega - 14y" in told
