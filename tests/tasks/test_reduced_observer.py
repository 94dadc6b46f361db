"""Observers of reduced order: the course's examples, simulation, random plants, corruptions, refusals."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.linalg import expm

import solver
from solver.derivation import Status
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

I, R, M = sp.I, sp.Rational, sp.Matrix
COMPANION = [[0, 1, 0], [0, 0, 1], [-4, -4, -1]]
POLES = [R(-5), R(-5)]


def floats(matrix):
    return np.array(matrix.tolist(), dtype=complex).real.astype(float).reshape(matrix.shape)


def measuring(state):
    return system(COMPANION, B=[0, 0, 1], C=[[int(j == state) for j in range(3)]])


COURSE = [  # lecture note, section 4.6, examples 3 to 5, with what the printed matrices should be
    (0, [9, 12], [[-9, 1], [-16, -1]], [-69, -160], [0, 1]),
    (1, [R(-25, 4), 9], [[0, R(25, 4)], [-4, -10]], [R(229, 4), -69], [0, 1]),
    (2, [R(15, 4), R(-25, 4)], [[15, 16], [-25, -25]], [-40, R(229, 4)], [R(-15, 4), R(25, 4)]),
]


@pytest.mark.parametrize(("state", "L", "J", "N", "forward"), COURSE)
def test_the_examples_of_the_course(state, L, J, N, forward):
    result = ask("reduced_observer", measuring(state), poles=POLES)
    assert result.status is Status.VERIFIED, result.reason
    answers = result.answers
    assert (answers["L"], answers["J"], answers["N"], answers["M"]) == (M(L), M(J), M(N), M(forward))


def test_the_unmeasured_states_keep_their_order():
    answers = ask("reduced_observer", measuring(2), poles=POLES).answers
    x = M(sp.symbols("x1:4"))
    assert answers["T"] * M([x[2], x[0], x[1]]) == x
    assert answers["A12"] == M([[-4, -4]])
    assert answers["A21"] == M([0, 1])
    assert answers["B1"] == M([1])


def test_the_steps_lead_from_the_measurement_to_the_combined_model():
    kinds = [step.kind for step in ask("reduced_observer", measuring(0), poles=POLES).steps]
    assert kinds == [
        *("measured", "blocks", "error_equation", "pair", "desired", "unknown", "compare", "gain"),
        *("matrices", "estimate", "error", "combined"),
    ]


def test_measured_states_may_be_named_or_numbered():
    plant = system(COMPANION, B=[0, 0, 1])
    by_c = ask("reduced_observer", measuring(1), poles=POLES).answers
    for word in ("x2", "2"):
        assert ask("reduced_observer", plant, poles=POLES, measured=(word,)).answers == by_c


def test_the_unknown_entries_of_the_gain_have_names_that_the_plant_has_not():
    length = sp.Symbol("l1", positive=True)
    plant = system([[0, 1, 0], [0, 0, length], [0, -length, -1]], B=[0, 0, 1], C=[[1, 0, 0]])
    result = ask("reduced_observer", plant, poles=[R(-2), R(-3)])
    assert result.status is Status.VERIFIED, result.reason
    (compared,) = (step for step in result.steps if step.kind == "compare")
    assert [str(unknown) for unknown, _ in compared.values["solution"]] == ["h1", "h2"]


def test_two_positions_of_the_pendulum_give_its_velocities():
    A = [[0, 1, 0, 0], [0, R(-3, 17), R(-981, 425), 0], [0, 0, 0, 1], [0, R(20, 51), R(2289, 85), 0]]
    plant = system(A, B=[0, R(30, 17), 0, R(-200, 51)], C=[[1, 0, 0, 0], [0, 0, 1, 0]])
    result = ask("reduced_observer", plant, poles=[-1 + 2 * I, -1 - 2 * I])
    assert result.status is Status.VERIFIED, result.reason
    spectrum = np.linalg.eigvals(floats(result.answers["J"]))
    assert np.allclose(sorted(spectrum, key=np.imag), [-1 - 2j, -1 + 2j])


def simulated_error(plant, answers, times):
    """The error of the estimate when plant and observer run together under a constant input, by scipy alone."""
    A, B, C = floats(plant.A), floats(plant.B), floats(plant.C)
    D = np.zeros((len(C), B.shape[1])) if plant.D is None else floats(plant.D)
    J, N, forward = (floats(answers[name]) for name in ("J", "N", "M"))
    L, T = floats(answers["L"]), floats(answers["T"])
    n, q, m = len(A), len(J), B.shape[1]
    whole = np.zeros((n + q + m, n + q + m))
    whole[:n, :n], whole[:n, n + q :] = A, B
    whole[n : n + q, :n], whole[n : n + q, n : n + q], whole[n : n + q, n + q :] = N @ C, J, N @ D + forward
    start = np.random.default_rng(1).normal(size=n + q + m)
    for t in times:
        state = expm(whole * t) @ start
        x, omega, u = state[:n], state[n : n + q], state[n + q :]
        y = C @ x + D @ u
        eta2 = np.linalg.solve(T, x)[n - q :]
        yield eta2 - (omega + L @ (y - D @ u)), J


@pytest.mark.parametrize(
    "plant",
    [
        measuring(0),
        system(COMPANION, B=[0, 0, 1], C=[[1, 0, 0]], D=[[2]]),
        system(COMPANION, B=[[1, 0], [0, 0], [0, 1]], C=[[3, 1, 0]], D=[[1, 2]]),
        system(COMPANION, B=[0, 0, 1], C=[[0, 2, 0]]),
    ],
    ids=["one state", "direct term", "combination of states", "scaled state"],
)
def test_the_simulated_error_depends_on_nothing_but_itself(plant):
    result = ask("reduced_observer", plant, poles=POLES)
    assert result.status is Status.VERIFIED, result.reason
    times = [0.0, 0.3, 1.1]
    errors = list(simulated_error(plant, result.answers, times))
    start, J = errors[0]
    for t, (error, _) in zip(times, errors, strict=True):
        assert np.allclose(error, expm(J * t) @ start, atol=1e-8)


@st.composite
def observed_plants(draw):
    """A random plant with one or two outputs of which C may be anything independent."""
    A = draw(systems(4))
    n = A.rows
    assume(n >= 2)
    p = draw(st.integers(1, min(2, n - 1)))
    small = st.integers(-2, 2)
    C = sp.ImmutableMatrix(p, n, [draw(small) for _ in range(p * n)])
    assume(C.rank() == p)
    B = sp.ImmutableMatrix(n, 1, [draw(small) for _ in range(n)])
    return system(A, B=B, C=C, discrete=draw(st.booleans()))


@tried(25)
@given(observed_plants(), st.booleans())
def test_random_plants_are_solved_or_refused_for_a_reason(plant, paired):
    n, p = plant.order, plant.C.rows
    q = n - p
    poles = [R(-1, 2) + R(1, 3) * I, R(-1, 2) - R(1, 3) * I][: 2 * (paired and q >= 2)]
    poles += [R(-1, k + 2) for k in range(q - len(poles))]
    seen = M.vstack(*(plant.C * plant.A**k for k in range(n))).rank()
    # a hidden eigenvalue that is asked for by chance is no reason to refuse
    assume(seen == n or all((plant.A - pole * sp.eye(n)).det() != 0 for pole in poles))
    result = ask("reduced_observer", plant, poles=poles)
    if seen == n:
        assert result.status is Status.VERIFIED, result.reason
        assert (
            sp.expand(
                (result.answers["A22"] - result.answers["L"] * result.answers["A12"]).charpoly(sp.Symbol("s")).as_expr()
                - sp.prod(sp.Symbol("s") - pole for pole in poles)
            )
            == 0
        )
        start, J = next(simulated_error(plant, result.answers, [0.0]))
        (later, _) = next(simulated_error(plant, result.answers, [0.4]))
        if not plant.discrete:
            assert np.allclose(
                later, expm(J * 0.4) @ start, atol=1e-6 * (1 + np.linalg.norm(floats(result.answers["L"])))
            )
    else:
        assert result.status is Status.UNSOLVED
        assert "unobservable" in str(result.reason) or "moved by any gain" in str(result.reason)


CORRUPTIONS = [
    ("sign", lambda X: -X),
    ("one entry", lambda X: X + sp.Matrix(*X.shape, lambda i, j: R(1, 100) if i == j == 0 else 0)),
    ("scaled", lambda X: X * R(101, 100)),
    ("last entry", lambda X: X + sp.Matrix(*X.shape, lambda i, j: int((i, j) == (X.rows - 1, X.cols - 1)))),
]


@pytest.mark.parametrize("name", list(catalogue()["reduced_observer"].answers))
@pytest.mark.parametrize("state", [0, 2])
def test_every_answer_alone_is_accepted_and_its_corruptions_rejected(name, state):
    plant, poles = measuring(state), POLES
    answers = ask("reduced_observer", plant, poles=poles).answers
    right = answers[name]
    assert not rejected("reduced_observer", plant, {name: right}, poles=poles)
    for _, corrupt in CORRUPTIONS:
        corrupted = sp.ImmutableMatrix(corrupt(right))
        if corrupted != right:
            assert rejected("reduced_observer", plant, {name: corrupted}, poles=poles), corrupted
            assert rejected("reduced_observer", plant, {**answers, name: corrupted}, poles=poles), corrupted


def test_any_gain_of_several_outputs_is_right_with_its_own_matrices():
    A = sp.ImmutableMatrix([[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [-1, -2, -3, -4]])
    plant = system(A, B=[0, 0, 0, 1], C=[[1, 0, 0, 0], [0, 0, 1, 0]])
    poles = [R(-2), R(-3)]
    answers = dict(ask("reduced_observer", plant, poles=poles).answers)
    A11, A12, A21, A22, B1, B2 = (answers[name] for name in ("A11", "A12", "A21", "A22", "B1", "B2"))
    assert not rejected("reduced_observer", plant, answers, poles=poles)
    L = (A22 - sp.diag(-3, -2)) * A12.inv()
    J = A22 - L * A12
    other = {**answers, "L": L, "J": J, "N": A21 - L * A11 + J * L, "M": B2 - L * B1}
    N = other["N"]
    other["A_combined"] = M([[A, sp.zeros(4, 2)], [N * plant.C, J]])
    other["B_combined"] = M.vstack(plant.B, other["M"])
    frozen = {name: sp.ImmutableMatrix(value) for name, value in other.items()}
    assert frozen["L"] != answers["L"]
    assert not rejected("reduced_observer", plant, frozen, poles=poles)
    assert rejected("reduced_observer", plant, {**frozen, "N": answers["N"]}, poles=poles)
    assert not rejected("reduced_observer", plant, {"A_combined": frozen["A_combined"]}, poles=poles)


def test_any_completion_of_a_combination_of_states_is_right():
    plant = system(COMPANION, B=[0, 0, 1], C=[[3, 1, 0]])
    answers = ask("reduced_observer", plant, poles=POLES).answers
    assert not rejected("reduced_observer", plant, answers, poles=POLES)
    T = sp.ImmutableMatrix(M([[3, 1, 0], [1, 0, 1], [0, 0, 2]]).inv())
    assert not rejected("reduced_observer", plant, {"T": T}, poles=POLES)
    assert rejected("reduced_observer", plant, {"T": sp.ImmutableMatrix(sp.eye(3))}, poles=POLES)


def test_a_detectable_plant_keeps_its_fixed_eigenvalue():
    plant = system([[-2, 0, 0], [0, -3, 1], [0, 0, -1]], B=[1, 1, 1], C=[[0, 1, 0]])
    for poles in ([R(-7)], [R(-7), R(-2)]):
        result = ask("reduced_observer", plant, poles=poles)
        assert result.status is Status.VERIFIED, result.reason
        assert sorted(result.answers["J"].eigenvals()) == [-7, -2]
    refused = ask("reduced_observer", plant, poles=[R(-7), R(-4)])
    assert "cannot be moved" in str(refused.reason)


def test_an_undetectable_plant_is_refused_in_words():
    plant = system([[2, 0, 0], [0, -3, 1], [0, 0, -1]], B=[1, 1, 1], C=[[0, 1, 0]])
    result = ask("reduced_observer", plant, poles=[R(-7)])
    assert result.status is Status.UNSOLVED
    assert "not detectable" in str(result.reason)


def test_symbols_stay_symbols():
    a, b, c, d, p, b1, b2 = sp.symbols("a b c d p b1 b2")
    result = ask("reduced_observer", system([[a, b], [c, d]], B=[b1, b2], C=[[1, 0]]), poles=[p])
    assert result.status is Status.VERIFIED, result.reason
    L = (d - p) / b
    assert sp.cancel(result.answers["L"][0] - L) == 0
    assert sp.cancel(result.answers["N"][0] - (c - L * a + p * L)) == 0
    assert sp.cancel(result.answers["M"][0] - (b2 - L * b1)) == 0


REFUSED = [
    ({}, {"C": [[1, 0, 0]]}, [R(-5)], "2"),
    ({}, {"C": sp.eye(3)}, [R(-5)], "nothing to estimate"),
    ({}, {"C": [[1, 0, 0], [2, 0, 0]]}, [R(-5)], "independent"),
    ({}, {}, [R(-5)], "what is measured"),
    ({"measured": ("x9",)}, {}, [R(-5)], "no state 'x9'"),
]


@pytest.mark.parametrize(("options", "matrices", "poles", "words"), REFUSED)
def test_what_the_file_shows_to_be_wrong_is_refused(options, matrices, poles, words):
    plant = system(COMPANION, B=[0, 0, 1], **matrices)
    faults = list(catalogue()["reduced_observer"].refused(plant, {"poles": poles, **options}))
    assert any(words in str(message) for _, message in faults)


@pytest.mark.parametrize("state", range(3))
def test_poles_at_the_origin_make_a_deadbeat_observer(state):
    plant = system(COMPANION, B=[0, 0, 1], C=[[int(j == state) for j in range(3)]], discrete=True)
    result = ask("reduced_observer", plant, poles=[R(0), R(0)])
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["J"] ** 2 == sp.zeros(2)


def test_the_coordinates_of_the_combined_model_are_those_of_the_plant():
    for state in range(3):
        answers = ask("reduced_observer", measuring(state), poles=POLES).answers
        assert answers["A_combined"][:3, :3] == M(COMPANION)
        assert answers["A_combined"][3:, :3] == answers["N"] * measuring(state).C


def test_a_file_may_name_the_states_though_it_gives_no_names():
    text = """\
system: {A: [[0, 1, 0], [0, 0, 1], [-4, -4, -1]], B: [0, 0, 1]}
find: {a: {task: reduced_observer, measured: [x3], poles: [-5, -5]}}
"""
    assert solver.solve(text).answers["a"]["J"] == M([[15, 16], [-25, -25]])


def test_a_transfer_function_is_realized_first():
    text = """\
system: {transfer_function: "(s + 3)/(s^2 + 3s + 2)"}
find:
  a: {task: reduced_observer, poles: [-5]}
  b: {task: observer, poles: [-5, -6]}
  c: {task: observer_feedback, poles: [-4, -4], observer_poles: [-5], reduced: true}
"""
    solution = solver.solve(text)
    assert solution.status == "verified"
    assert solution.answers["a"]["J"] == M([[-5]])


def test_an_error_matrix_that_is_chosen_is_not_found_again():
    plant = "A: [[0, 1, 0, 0], [0, -1, 2, 0], [0, 0, 0, 1], [0, 3, 5, 0]], B: [0, 1, 0, 1]"
    asked = "find: {a: {task: reduced_observer, poles: ['-1 ± 2j']}}"
    text = f"title: t\nsystem: {{{plant}, C: [[1, 0, 0, 0], [0, 0, 1, 0]]}}\n{asked}\n"
    page = solver.solve(text).markdown(detail="tutor")
    assert "with $A_{12} = I$, $L_c = A_{22} - J$" in page
    assert page.count("\nJ = ") == 1
    assert page.count("\\det(sI - J)") == 1
    assert "η̃₂‚₁" in page
    assert "Found on the way: $T$ (step 1); $A_{11}$" in page
    assert "$A_{\\text{combined}}$, $B_{\\text{combined}}$ (step" in page
