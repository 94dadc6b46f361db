"""Where eigenvalues lie by numbers: near the boundary, multiple ones, hidden poles, arrays; conditions at points."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.numeric.judges.stability import counterexample, externally_stable, locations, routh_fault
from solver.numeric.judges.stability.location import certain_excess, located, spread_points

k = sp.Symbol("k", real=True)
small = sp.Rational(1, 10**12)


@pytest.mark.parametrize(
    ("rows", "verdict"),
    [
        ([[0, 1], [-1, small]], "unstable"),
        ([[0, 1], [-1, -small]], "asymptotically stable"),
        ([[0, 1], [-1, 0]], "marginally stable"),
        ([[-(10**9), 0], [0, -small]], "asymptotically stable"),
        ([[-(10**9), 0, 0], [0, 1, 0], [0, 0, -1]], "unstable"),
        ([[0, 1, 0], [0, 0, 1], [0, 0, 0]], "unstable"),
        ([[-small, 10**6], [0, -small]], "asymptotically stable"),
    ],
)
def test_the_boundary_is_decided_with_digits(rows, verdict):
    assert located(sp.ImmutableMatrix(rows), {}, discrete=False).verdict == verdict


@st.composite
def badly_scaled(draw):
    """A matrix with eigenvalues −2 … 2, multiple ones in a chain or not, in states of very different sizes."""
    eigenvalues = draw(st.lists(st.integers(-2, 2), min_size=2, max_size=4))
    n = len(eigenvalues)
    entry = st.integers(-2, 2)
    above = [[draw(entry) if j > i else 0 for j in range(n)] for i in range(n)]
    M = sp.Matrix(n, n, lambda i, j: eigenvalues[i] if i == j else above[i][j])
    L = sp.Matrix(n, n, lambda i, j: 1 if i == j else draw(entry) if j < i else 0)
    D = sp.diag(*(sp.Integer(10) ** draw(st.integers(-6, 6)) for _ in range(n)))
    return sp.ImmutableMatrix(D * L * M * L.inv() * D.inv()), eigenvalues


@given(badly_scaled())
def test_the_states_may_be_of_very_different_sizes(drawn):
    A, eigenvalues = drawn
    found = located(A, {}, discrete=False)
    counts = [sum(value < 0 for value in eigenvalues), eigenvalues.count(0), sum(value > 0 for value in eigenvalues)]
    assert [found.inside, found.on, found.outside] == counts
    assert found.semisimple == (A.rows - A.rank() == eigenvalues.count(0))


def test_a_badly_scaled_matrix_is_balanced_and_decided_in_doubles():
    D = sp.diag(1, 10**6, 10**12)
    A = sp.ImmutableMatrix(D * sp.Matrix([[-1, 1, 0], [0, -2, 1], [1, 0, -3]]) * D.inv())
    excess = certain_excess(A, {}, discrete=False)
    assert excess is not None
    assert max(excess) < 0


def test_what_rounding_may_have_moved_is_left_open():
    D = sp.diag(1, 10**6)
    for rows in ([[0, 1], [0, 0]], [[0, 1], [-1, 0]], [[1, -1], [1, -1]], [[0, 1], [-1, sp.Rational(1, 10**14)]]):
        assert certain_excess(sp.ImmutableMatrix(D * sp.Matrix(rows) * D.inv()), {}, discrete=False) is None


def test_points_respect_assumptions_and_are_of_many_sizes():
    p = sp.Symbol("p", positive=True)
    values = [point[p] for point in spread_points([sp.ImmutableMatrix([[p]])])]
    assert min(values) > 0
    assert max(values) / min(values) > 50


def test_all_points_are_judged():
    found = {each.verdict for each in locations(sp.ImmutableMatrix([[k]]), discrete=False)}
    assert found == {"asymptotically stable", "unstable"}


def test_a_pole_that_is_hidden_only_nearly_counts():
    A, C = sp.ImmutableMatrix([[1, 0], [0, -1]]), sp.ImmutableMatrix([[1, 1]])
    assert externally_stable(A, sp.ImmutableMatrix([0, 1]), C, {}, discrete=False)
    assert not externally_stable(A, sp.ImmutableMatrix([sp.Rational(1, 10**5), 1]), C, {}, discrete=False)


def test_an_array_of_another_polynomial_is_found_out():
    A = sp.ImmutableMatrix([[0, 1], [-2, -3]])
    assert not routh_fault(A, sp.ImmutableMatrix([[1, 2], [3, 0], [2, 0]]), discrete=False)
    assert "row 2" in routh_fault(A, sp.ImmutableMatrix([[1, 2], [4, 0], [2, 0]]), discrete=False)
    assert "rows" in routh_fault(A, sp.ImmutableMatrix([[1, 2], [3, 0]]), discrete=False)


def test_a_narrow_range_is_not_overlooked():
    A = sp.ImmutableMatrix([[0, 1], [k - 100, 99 - k]])  # stable for 99 < k < 100 only
    assert not counterexample(A, (k > 99) & (k < 100), discrete=False)
    assert counterexample(A, sp.false, discrete=False)


def test_an_edge_that_is_included_is_found_out():
    A = sp.ImmutableMatrix([[k]])
    assert not counterexample(A, k < 0, discrete=False)
    assert "k = 0" in counterexample(A, k <= 0, discrete=False)


@pytest.mark.parametrize("size", [k**2, abs(k) ** 2, abs(k**2)])
def test_an_edge_that_is_included_is_found_out_where_the_comparison_is_not_of_the_parameter_itself(size):
    A = sp.ImmutableMatrix([[0, 1], [-1, 2 - k**2]])
    assert not counterexample(A, size > 2, discrete=False)
    assert "holds" in counterexample(A, size >= 2, discrete=False)
    assert counterexample(A, abs(k) >= sp.sqrt(2), discrete=False)


@pytest.mark.parametrize(
    ("assumed", "pole", "right", "wrong"),
    [
        ("negative", k, sp.true, sp.Lt(k, -1)),
        ("positive", -k, sp.true, sp.Gt(k, 1)),
        ("nonpositive", k, sp.Lt(k, 0), sp.true),
        ("nonnegative", -k, sp.Gt(k, 0), sp.true),
        ("nonzero", -(k**2), sp.true, sp.Gt(k, 0)),
        ("integer", k - sp.Rational(1, 2), sp.Lt(k, 1), sp.Lt(k, 0)),
        ("real", k, sp.Lt(k, 0), sp.Le(k, 0)),
    ],
)
def test_only_values_that_the_assumptions_allow_count(assumed, pole, right, wrong):
    own = {k: sp.Symbol("k", **{"real": True, assumed: True})}
    A = sp.ImmutableMatrix([[pole.xreplace(own)]])
    for condition, accepted in ((right, True), (wrong, False)):
        stated = condition.xreplace(own) if condition is not sp.true else condition
        assert (counterexample(A, stated, discrete=False) == "") == accepted
