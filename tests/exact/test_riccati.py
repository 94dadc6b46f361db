"""All solutions of the Riccati equation: residuals, the number of them, the stabilizing one, findings that refuse."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import solve_continuous_are

from solver.exact import NotStabilizable, OnTheAxis, case_split, definiteness_of_numbers, riccati
from solver.exact.optimal.square_roots import RootTower
from tests.helpers.tried import tried

I2 = sp.eye(2)


def residual(A, B, Q, R, P) -> float:
    A, B, Q, R = map(sp.Matrix, (A, B, Q, R))
    left = A.T * P + P * A - P * B * R.inv() * B.T * P + Q
    return max(abs(complex(entry.evalf(40))) for entry in left)


def as_floats(M) -> np.ndarray:
    return np.array(sp.Matrix(M).evalf(30).tolist(), dtype=float)


INTEGER_SOLUTIONS = [
    ([[0, 1], [0, 1]], [[0], [1]], I2, [[1]], [[2, 1], [1, 3]], 3),
    ([[0, 1], [0, -2]], [[0], [1]], sp.diag(4, 1), [[1]], [[6, 2], [2, 1]], 4),
    ([[-1, 0], [0, -2]], [[0], [1]], sp.diag(1, 0), [["1/2"]], [["1/2", 0], [0, 0]], 2),
    ([[1]], [[1]], [[0]], [[1]], [[2]], 2),
]


@pytest.mark.parametrize(("A", "B", "Q", "R", "P", "count"), INTEGER_SOLUTIONS)
def test_textbook_solutions(A, B, Q, R, P, count):
    R, P = (sp.ImmutableMatrix(M).applyfunc(sp.Rational) for M in (R, P))
    found = riccati(*map(sp.ImmutableMatrix, (A, B, Q, R)))
    assert found.stabilizing.P == P
    assert found.count == count == len(found.solutions)
    assert all(residual(A, B, Q, R, each.P) == 0 for each in found.solutions)


def test_a_large_rational_number_stays_one():
    found = riccati(*map(sp.ImmutableMatrix, ([[0]], [[1]], [[123456789**2]], [[1]])))
    assert found.stabilizing.exact
    assert list(found.stabilizing.P) == [123456789]


def test_nested_roots_of_the_unstable_plant_of_the_course():
    A, B, Q, R = [[1, 1], [0, 2]], [[0], [1]], sp.diag(1, 0), sp.Matrix([[1]])
    found = riccati(*map(sp.ImmutableMatrix, (A, B, Q, R)))
    printed = [
        [[19.4317, 6.3138], [6.3138, 6.0777]],
        [[-0.4875, 0.1584], [0.1584, -0.0777]],
        [[1.4259, -1.9626], [-1.9626, 2.2735]],
        [[-0.3702, -0.5095], [-0.5095, 3.7265]],
    ]
    for each in found.solutions:
        assert each.exact
        assert not each.P.has(sp.Float)
        assert residual(A, B, Q, R, each.P) < 1e-30
    listed = [as_floats(each.P) for each in found.solutions]
    for matrix in printed:
        assert any(np.abs(P - np.array(matrix)).max() < 1e-4 for P in listed)
    assert np.abs(listed[0] - np.array(printed[0])).max() < 1e-4


def test_symbolic_weights_of_the_double_integrator():
    mu = sp.Symbol("mu", positive=True)
    found = riccati(*map(sp.ImmutableMatrix, ([[0, 1], [0, 0]], [[0], [1]], sp.diag(1, mu), [[1]])))
    root = sp.sqrt(mu + 2)
    assert sp.ImmutableMatrix([[root, 1], [1, root]]) == found.stabilizing.P
    conditions = {each.radicand for each in found.solutions}
    assert conditions == {None, mu - 2}


def test_the_hamiltonian_may_not_have_eigenvalues_on_the_axis():
    with pytest.raises(OnTheAxis):
        riccati(*map(sp.ImmutableMatrix, ([[0, 1], [-1, 0]], [[0], [1]], sp.zeros(2), [[1]])))


def test_an_unstable_mode_out_of_reach_is_named():
    with pytest.raises(NotStabilizable) as caught:
        riccati(*map(sp.ImmutableMatrix, ([[-1, 0], [0, 3]], [[1], [0]], I2, [[1]])))
    assert caught.value.modes == [3]


def test_a_continuum_is_described_by_a_family():
    A, B = sp.zeros(2), sp.eye(2)
    found = riccati(*map(sp.ImmutableMatrix, (A, B, I2, I2)))
    assert found.count is None
    family, eigenvalue = found.family(sp.Symbol("tau"))
    assert eigenvalue == -1
    for tau in (0, 1, sp.Rational(7, 3)):
        P = family.subs(sp.Symbol("tau"), tau)
        assert residual(A, B, I2, I2, P) == 0
        assert P != found.stabilizing.P


@st.composite
def problems(draw, largest=4):
    n, m = draw(st.integers(1, largest)), draw(st.integers(1, 2))
    small = st.integers(-2, 2)
    A = sp.Matrix(n, n, lambda i, j: draw(small))
    B = sp.Matrix(n, m, lambda i, j: draw(small))
    C = sp.Matrix(1, n, lambda i, j: draw(small))
    Q = C.T * C + (sp.eye(n) if draw(st.booleans()) else sp.zeros(n))
    return A, B, Q, sp.diag(*(draw(st.integers(1, 3)) for _ in range(m)))


@tried(25)
@given(problems())
def test_random_problems_agree_with_scipy_or_are_refused(problem):
    A, B, Q, R = problem
    F = [as_floats(M) for M in problem]
    try:
        found = riccati(*map(sp.ImmutableMatrix, problem))
    except NotStabilizable as finding:
        mode = complex(finding.modes[0])
        pencil = np.hstack([mode * np.eye(len(F[0])) - F[0], F[1]])
        assert mode.real >= 0
        assert np.linalg.svd(pencil, compute_uv=False)[-1] < 1e-7
        return
    except OnTheAxis:
        H = np.block([[F[0], -F[1] @ np.linalg.solve(F[3], F[1].T)], [-F[2], -F[0].T]])
        assert np.abs(np.linalg.eigvals(H).real).min() < 1e-2
        return
    P = solve_continuous_are(*F)
    assert np.abs(as_floats(found.stabilizing.P) - P).max() <= 1e-6 * (1 + np.abs(P).max())
    if found.count is not None and found.count <= 16:
        assert len(found.solutions) == found.count
        for each in found.solutions:
            scale = 1 + max(abs(float(x.evalf())) for x in each.P) ** 2
            assert residual(A, B, Q, R, each.P) <= 1e-18 * scale
            difference = as_floats(found.stabilizing.P - each.P)
            assert np.linalg.eigvalsh(difference)[0] >= -1e-6 * (1 + np.abs(difference).max())
        distinct = {tuple(np.round(as_floats(each.P), 6).flat) for each in found.solutions}
        assert len(distinct) == found.count


@pytest.mark.parametrize(
    ("rows", "word"),
    [
        ([[2, 1], [1, 3]], "positive definite"),
        ([[1, 1], [1, 1]], "positive semidefinite"),
        ([[0, 0], [0, 0]], "positive semidefinite"),
        ([[-1, 0], [0, 0]], "negative semidefinite"),
        ([[-1, 0], [0, -2]], "negative definite"),
        ([[1, 2], [2, 1]], "indefinite"),
        ([[sp.sqrt(2), 2], [2, 2 * sp.sqrt(2)]], "positive semidefinite"),
        ([[1, 0], [0, sp.Float("1e-13")]], "positive semidefinite"),
        ([[1, 0], [0, sp.Float("-1e-11")]], "indefinite"),
        ([[-1, 0], [0, sp.Float("-1e-11")]], "negative definite"),
        ([[1, 0], [0, sp.Float("1e-20", 30)]], "positive definite"),
    ],
)
def test_definiteness_in_words(rows, word):
    assert definiteness_of_numbers(sp.Matrix(rows)) == word


def test_a_root_that_is_in_the_tower_is_not_adjoined_again():
    tower = RootTower(sp.QQ)
    two, three = (tower.square_root((sp.QQ(n),)) for n in (2, 3))
    assert tower.expression(tower.square_root((sp.QQ(6),))) == sp.sqrt(6)
    assert tower.expression(tower.square_root(tower.add((sp.QQ(3),), tower.scale(sp.QQ(2), two)))) == 1 + sp.sqrt(2)
    assert len(tower.roots) == 2
    product = tower.multiply(three, tower.inverse(three))
    assert tower.expression(product) == 1


def test_the_case_split_of_the_exam_and_its_ends():
    p11, p12, p22 = unknowns = sp.symbols("p11 p12 p22")
    split = case_split([1 - p12**2, p11 + p12 - p12 * p22, 1 + 2 * p12 + 2 * p22 - p22**2], unknowns)
    assert (split.kind, split.unknown, set(split.values)) == ("roots", p12, {1, -1})
    ends = {tuple(end[x] for x in unknowns) for end in split.ends()}
    assert ends == {(2, 1, 3), (-2, 1, -1), (0, -1, 1)}


def test_a_split_knows_contradictions_products_and_its_limits():
    x, y = sp.symbols("x y")
    assert {end[x] for end in case_split([x * (x - 1) * (x**2 + 1)], [x]).ends()} == {0, 1}
    assert case_split([x, x - 1], [x]).following[0].kind == "contradiction"
    assert case_split([x**2 + 1], [x]).ends() == []
    assert case_split([x - y], [x, y]) is None
    assert case_split([x**5 - x - 1], [x]) is None


@pytest.mark.parametrize(
    ("factor", "centre", "e", "f"), [(1, 1, -10, 1), (3, -2, -4, 2), (-2, 5, 0, -7), (1, 0, 3, -1)]
)
def test_an_equation_of_degree_four_that_is_even_about_a_point(factor, centre, e, f):
    x = sp.Symbol("x")
    equation = sp.expand(factor * ((x - centre) ** 4 + e * (x - centre) ** 2 + f))
    found = sorted(float(end[x]) for end in case_split([equation], [x]).ends())
    assert found == pytest.approx(sorted(float(root) for root in sp.real_roots(equation)))


def test_an_equation_with_parameters_below_a_line_is_factored():
    x, y, r = sp.symbols("x y r", positive=True)
    split = case_split([x**2 / r + x * y, x + y - 3], [x, y])
    assert split.kind == "factors"
    assert [sp.cancel(end[x]) for end in split.ends()] == [0, sp.cancel(3 * r / (r - 1))]


@tried(15)
@given(problems(largest=2))
def test_case_splits_find_what_the_hamiltonian_finds(problem):
    try:
        found = riccati(*map(sp.ImmutableMatrix, problem))
    except (NotStabilizable, OnTheAxis):
        return
    A, B, Q, R = problem
    n = A.rows
    P = sp.Matrix(n, n, lambda i, j: sp.Symbol(f"p{min(i, j)}{max(i, j)}"))
    left = (A.T * P + P * A - P * B * R.inv() * B.T * P + Q).expand()
    pairs = [(i, j) for i in range(n) for j in range(i, n)]
    split = case_split([left[i, j] for i, j in pairs], [P[i, j] for i, j in pairs])
    if split is not None and found.count is not None:
        ends = {tuple(np.round(as_floats(P.subs(end)), 6).flat) for end in split.ends()}
        listed = {tuple(np.round(as_floats(each.P), 6).flat) for each in found.solutions}
        assert len(ends) == len(listed)
        assert np.allclose(sorted(ends), sorted(listed), atol=1e-5)
