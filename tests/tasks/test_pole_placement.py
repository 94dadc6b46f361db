"""Pole placement: textbook gains, every method on random plants, hidden modes, prescribed shapes, several inputs."""

import control
import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st

import solver
from solver.derivation import CheckStatus, Claim, Status
from solver.exact import reachable_order
from solver.numeric import check_claim
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

ONE_INPUT = ("coefficient_matching", "bass_gura", "canonical_form", "ackermann", "unity_rank")
I = sp.I
s = sp.Symbol("s")


def numbers(*values):
    return tuple(sp.sympify(value) for value in values)


def floats(M):
    return np.array(M.tolist(), dtype=complex)


COURSE = [
    # ch3-q01, ch3-q02 and example 5 with ω_d = √3, worked by hand
    ([[-1, -2], [2, -4]], [1, 3], (-4, -5), [[-sp.Rational(16, 11), sp.Rational(20, 11)]]),
    ([[1, 0], [1, 1]], [1, 0], (-1 + sp.sqrt(3) * I, -1 - sp.sqrt(3) * I), [[4, 7]]),
    ([[-2, 5, 6], [1, 0, 0], [0, 1, 0]], [1, 0, 0], (-2, -2, -3), [[5, 21, 18]]),
    ([[0, 1, 0], [0, 0, 1], [1, -1, -2]], [0, 1, 0], (-1, -1, -1), None),
    ([[0, 1], [0, 1]], [0, 1], (-4, -1), [[4, 6]]),
]


@pytest.mark.parametrize(("A", "B", "poles", "K"), COURSE)
@pytest.mark.parametrize("method", ONE_INPUT)
def test_gains_of_the_course(A, B, poles, K, method):
    result = ask("pole_placement", system(A, B=B), method, poles=numbers(*poles))
    assert result.status is Status.VERIFIED, result.reason
    wanted = np.poly([complex(pole) for pole in numbers(*poles)])
    assert np.allclose(np.poly(floats(result.answers["closed_loop_A"])), wanted, atol=1e-9)
    if K is not None:
        assert result.answers["K"] == sp.ImmutableMatrix(K)


@tried(12)
@given(systems(4), st.data())
def test_all_methods_agree_with_each_other_and_with_python_control(A, data):
    n = A.rows
    b = sp.ImmutableMatrix(n, 1, data.draw(st.lists(st.integers(-2, 2), min_size=n, max_size=n)))
    assume(reachable_order(A, b) == n)
    poles = data.draw(st.lists(st.integers(-6, -1), min_size=n, max_size=n))
    results = [ask("pole_placement", system(A, B=b), method, poles=numbers(*poles)) for method in ONE_INPUT]
    assert {result.status for result in results} == {Status.VERIFIED}, [result.reason for result in results]
    assert all(result.answers["K"] == results[0].answers["K"] for result in results)
    C_o = np.array(sp.Matrix.hstack(*[A**i * b for i in range(n)]).tolist(), dtype=float)
    if np.linalg.cond(C_o) < 1e6:
        peer = control.acker(np.array(A, dtype=float), np.array(b, dtype=float), [float(p) for p in poles])
        ours = np.array(results[0].answers["K"], dtype=float)
        assert np.allclose(ours, np.asarray(peer).reshape(1, n), rtol=1e-4, atol=1e-4 * np.abs(ours).max())


@tried(12)
@given(systems(5), st.integers(2, 3), st.data())
def test_several_inputs_are_placed_whatever_the_jordan_structure(A, m, data):
    n = A.rows
    entries = data.draw(st.lists(st.integers(-1, 1), min_size=n * m, max_size=n * m))
    B = sp.ImmutableMatrix(n, m, entries)
    assume(reachable_order(A, B) == n)
    poles = [sp.Integer(-1 - i) for i in range(n)]
    result = ask("pole_placement", system(A, B=B), "unity_rank", poles=tuple(poles))
    assert result.status is Status.VERIFIED, result.reason
    assert (sp.Matrix(A - B * result.answers["K"]).charpoly(s).as_expr() - sp.prod(s - p for p in poles)).expand() == 0


def test_the_identity_needs_a_preliminary_gain():
    result = ask("pole_placement", system(sp.eye(3), B=sp.eye(3)), "unity_rank", poles=numbers(-1, -2, -3))
    assert result.status is Status.VERIFIED, result.reason
    step = next(step for step in result.steps if step.kind == "one_input")
    assert step.values["K0"] is not None


def test_poles_that_the_open_loop_has_need_no_gain():
    plant = system([[0, 1, 0], [0, 0, 1], [6, -11, 6]], B=[[1, 0], [0, 1], [1, 1]])
    result = ask("pole_placement", plant, "unity_rank", poles=numbers(1, 2, 3))
    assert result.answers["K"].is_zero_matrix
    other = sp.ImmutableMatrix([[0, 0, 0], [-2, 3, -1]])  # not zero, and it does not keep the poles
    assert rejected("pole_placement", plant, {"K": other}, poles=numbers(1, 2, 3))


def test_any_gain_of_several_inputs_that_places_the_poles_is_right():
    plant = system([[0, 1], [0, 0]], B=[[1, 0], [0, 1]])
    for K in ([[1, 1], [0, 2]], [[2, 1], [0, 1]], [[0, 3], [-1, 3]]):
        M = plant.A - sp.ImmutableMatrix(K)
        right = sp.expand(M.charpoly(s).as_expr() - (s + 1) * (s + 2)) == 0
        assert rejected("pole_placement", plant, {"K": sp.ImmutableMatrix(K)}, poles=numbers(-1, -2)) is not right


HIDDEN = system([[1, 0, 0], [1, -1, 1], [0, 0, -2]], B=[1, 1, 0])


@pytest.mark.parametrize("method", ONE_INPUT)
@pytest.mark.parametrize("poles", [(-2 + 2 * I, -2 - 2 * I), (-2 + 2 * I, -2 - 2 * I, -2)])
def test_the_gain_of_a_hidden_mode_is_free(method, poles):
    result = ask("pole_placement", HIDDEN, method, poles=numbers(*poles))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["K"] == sp.ImmutableMatrix([[9, -5, sp.Symbol("k3")]])
    assert result.answers["fixed_poles"] == [-2]
    assert result.answers["polynomial"].expand() == ((s + 2) * (s**2 + 4 * s + 8)).expand()


@pytest.mark.parametrize("method", ONE_INPUT)
def test_a_hidden_mode_must_be_among_the_poles(method):
    result = ask("pole_placement", HIDDEN, method, poles=numbers(-1, -3, -4))
    assert result.status is Status.UNSOLVED
    assert "uncontrollable" in str(result.reason)
    assert "-2" in str(result.reason)


@tried(10)
@given(systems(3), systems(2), st.data())
def test_hidden_parts_of_any_structure_stay_where_they_are(movable, hidden, data):
    r, h = movable.rows, hidden.rows
    n = r + h
    b = sp.ImmutableMatrix(r, 1, data.draw(st.lists(st.integers(-2, 2), min_size=r, max_size=r)))
    assume(reachable_order(movable, b) == r)
    coupling = sp.Matrix(r, h, data.draw(st.lists(st.integers(-1, 1), min_size=r * h, max_size=r * h)))
    A = sp.Matrix.vstack(sp.Matrix.hstack(movable, coupling), sp.Matrix.hstack(sp.zeros(h, r), hidden))
    T = sp.Matrix(n, n, lambda i, j: 1 if i == j else (i + 2 * j) % 3 - 1 if j > i else 0)
    plant = system(T * A * T.inv(), B=T * sp.Matrix.vstack(b, sp.zeros(h, 1)))
    poles = numbers(*range(-r, 0))
    results = [ask("pole_placement", plant, method, poles=poles) for method in ("coefficient_matching", "ackermann")]
    assert {result.status for result in results} == {Status.VERIFIED}, [result.reason for result in results]
    assert (results[0].answers["K"] - results[1].answers["K"]).applyfunc(sp.cancel).is_zero_matrix
    chi = sp.Matrix(plant.A - plant.B * results[0].answers["K"]).charpoly(s).as_expr()
    assert sp.expand(chi - sp.prod(s - p for p in poles) * hidden.charpoly(s).as_expr()) == 0


FIXED = system([[-1, 0, 3], [0, -3, 0], [1, 0, -3]], B=[1, 1, -1])
alpha, beta = sp.symbols("alpha beta")


def test_a_shape_of_the_gain_leaves_poles_fixed():
    result = ask(
        "pole_placement", FIXED, "coefficient_matching", structure=(-alpha, sp.S.Zero, -beta), poles=(sp.S(-4),)
    )
    assert result.status is Status.VERIFIED, result.reason
    assert sorted(result.answers["fixed_poles"]) == [-3, 0]
    (condition,) = result.answers["conditions"]
    assert sp.expand(condition.lhs - condition.rhs) in (alpha - beta, beta - alpha)
    assert result.answers["K"][1] == 0


@pytest.mark.parametrize(
    ("conditions", "right"),
    [
        ([sp.Eq(alpha, beta)], True),
        ([sp.Eq(2 * alpha - 2 * beta, 0)], True),
        ([sp.Eq(alpha, -beta)], False),
        ([sp.Eq(alpha, 1), sp.Eq(beta, 1)], False),
        ([], False),
    ],
)
def test_conditions_are_judged_by_what_they_allow(conditions, right):
    options = {"structure": (-alpha, sp.S.Zero, -beta), "poles": (sp.S(-4),)}
    assert rejected("pole_placement", FIXED, {"conditions": conditions}, **options) is not right


def test_a_shape_that_cannot_place_the_poles_says_so():
    plant = system([[0, 1, 0], [0, 0, 1], [0, 0, 0]], B=[0, 0, 1])
    result = ask(
        "pole_placement", plant, "coefficient_matching", structure=(alpha, beta, sp.S.Zero), poles=numbers(-1, -2, -3)
    )
    assert result.status is Status.UNSOLVED
    assert "contradict" in str(result.reason)


def test_symbolic_poles_and_parameters():
    p1, p2, a = sp.symbols("p_1 p_2 a")
    for method in ONE_INPUT:
        result = ask("pole_placement", system([[1, 2], [3, a]], B=[0, 1]), method, poles=(p1, p2))
        assert result.status is Status.VERIFIED, result.reason
        K = result.answers["K"]
        assert sp.cancel(K[1] - (1 + a - p1 - p2)) == 0
        assert sp.cancel(2 * K[0] - (p1 * p2 - p1 - p2 + 7)) == 0


def test_unknowns_are_renamed_where_the_plant_uses_their_names():
    k1 = sp.Symbol("k1")
    result = ask("pole_placement", system([[0, k1], [1, 0]], B=[1, 0]), "coefficient_matching", poles=numbers(-1, -2))
    assert result.status is Status.VERIFIED, result.reason
    assert {str(x) for x in result.answers["gain_polynomial"].free_symbols} == {"s", "k1", "kappa1", "kappa2"}


@pytest.mark.parametrize("method", ONE_INPUT)
def test_specifications_of_the_step_response_take_the_place_of_poles(method):
    plant = system([[0, -1], [-3, -2]], B=[0, 1])
    result = ask("pole_placement", plant, method, overshoot=sp.Rational(14, 100), rise_time=sp.Rational(5, 4))
    assert result.status is Status.VERIFIED, result.reason
    zeta = -np.log(0.14) / np.hypot(np.pi, np.log(0.14))
    omega = (np.pi - np.arccos(zeta)) / (1.25 * np.sqrt(1 - zeta**2))
    expected = control.place(
        np.array(plant.A, dtype=float), np.array(plant.B, dtype=float), np.roots([1, 2 * zeta * omega, omega**2])
    )
    assert np.allclose(np.array(result.answers["K"], dtype=float), expected, atol=1e-9)


def test_discrete_time_has_the_polynomial_in_z():
    result = ask("pole_placement", system([[0, 1], [-6, -5]], B=[0, 1], discrete=True), poles=numbers(0, 0))
    assert result.status is Status.VERIFIED
    assert result.answers["polynomial"] == sp.Symbol("z") ** 2
    assert result.answers["K"] == sp.ImmutableMatrix([[-6, -5]])


PLANT = system([[0, 1, 0], [0, 0, 1], [6, -11, 6]], B=[0, 1, 1])
POLES = numbers(-1, -2 + I, -2 - I)


@pytest.mark.parametrize("name", ["K", "closed_loop_A", "polynomial", "gain_polynomial"])
def test_each_answer_alone_is_accepted_and_each_corruption_rejected(name):
    answer = ask("pole_placement", PLANT, "coefficient_matching", poles=POLES).answers[name]
    assert not rejected("pole_placement", PLANT, {name: answer}, poles=POLES)
    for corrupted in corruptions(answer):
        assert rejected("pole_placement", PLANT, {name: corrupted}, poles=POLES), corrupted


def corruptions(answer):
    if isinstance(answer, sp.MatrixBase):
        yield -answer
        for i in range(len(answer)):
            changed = answer.as_mutable()
            changed[i] += sp.Rational(1, 1000)
            yield sp.ImmutableMatrix(changed)
    else:
        yield answer + sp.Rational(1, 1000)
        yield answer + s / 1000
        yield 2 * answer


@pytest.mark.parametrize("wrong", [[], [-1], [-2, -2], [-3]])
def test_wrong_fixed_poles_are_rejected(wrong):
    poles = numbers(-2 + 2 * I, -2 - 2 * I)
    assert not rejected("pole_placement", HIDDEN, {"fixed_poles": [sp.S(-2)]}, poles=poles)
    assert rejected("pole_placement", HIDDEN, {"fixed_poles": [sp.S(value) for value in wrong]}, poles=poles)


@pytest.mark.parametrize("k3", [0, 5, sp.Symbol("kappa")])
def test_any_value_of_a_free_gain_is_right(k3):
    K = sp.ImmutableMatrix([[9, -5, k3]])
    assert not rejected("pole_placement", HIDDEN, {"K": K}, poles=numbers(-2 + 2 * I, -2 - 2 * I))
    wrong = sp.ImmutableMatrix([[9, -6, k3]])
    assert rejected("pole_placement", HIDDEN, {"K": wrong}, poles=numbers(-2 + 2 * I, -2 - 2 * I))


@pytest.mark.parametrize(
    ("options", "at", "says"),
    [
        ({}, "", "poles"),
        ({"poles": numbers(-1)}, "poles", "3 poles"),
        ({"poles": numbers(-1, -2, -3, -4)}, "poles", "not 4"),
        ({"overshoot": sp.Rational(1, 7)}, "overshoot", "two"),
        ({"poles": POLES, "structure": (alpha, beta)}, "structure", "3 entries"),
        ({"poles": POLES, "structure": (alpha**2, beta, sp.S.One)}, "structure", "linear"),
        ({"poles": POLES, "structure": (sp.S.One, sp.S.One, sp.S.One)}, "structure", "no symbol"),
    ],
)
def test_questions_that_the_file_shows_to_be_wrong(options, at, says):
    faults = list(catalogue()["pole_placement"].refused(PLANT, options))
    assert any(option == at and says in str(message) for option, message in faults), faults


def test_poles_from_an_earlier_part_are_not_missed():
    assert not list(catalogue()["pole_placement"].refused(PLANT, {"poles": None}))


CLAIMED = [
    (PLANT, POLES, {}),
    (HIDDEN, numbers(-2 + 2 * I, -2 - 2 * I), {}),
    (system([[0, 1], [-2, -3]], B=[[1, 0], [0, 1]]), numbers(-4, -5), {}),
]


@pytest.mark.parametrize(("plant", "poles", "options"), CLAIMED)
@pytest.mark.parametrize("method", ONE_INPUT)
def test_claims_hold_and_corrupted_ones_do_not(plant, poles, options, method):
    result = ask("pole_placement", plant, method, poles=poles, **options)
    claims = [claim for step in result.steps for each in step.walk() for claim in each.claims.values()]
    assert claims
    for claim in claims:
        assert check_claim(claim, "").status is CheckStatus.PASSED
        if isinstance(claim.right, sp.MatrixBase):
            wrong = Claim(claim.left, sp.ImmutableMatrix(claim.right + sp.ones(*claim.right.shape) / 1000))
            assert check_claim(wrong, "").status is CheckStatus.FAILED


@pytest.mark.parametrize(("assumed", "says"), [("positive", "completely controllable"), ("real", "general parameters")])
def test_a_determinant_that_cannot_vanish_is_not_doubted(assumed, says):
    text = f"title: t\nassume: {{b: {assumed}}}\nsystem: {{A: [[0, 1], [0, -a]], B: [0, b]}}\n"
    page = solver.solve(text + "find: {a: {task: pole_placement, poles: [-1, -2]}}\n").markdown(detail="tutor")
    assert says in page
    assert ("where it vanishes" in page) == (assumed == "real")
    assert page.count(r"\begin{bmatrix}b \\ -ab\end{bmatrix} = ") == 0
