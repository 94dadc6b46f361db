"""Chains and Jordan forms: A V = V J and M A = J M exactly, against known structures and ranks by sympy."""

import pickle

import mpmath
import pytest
import sympy as sp
from hypothesis import given

from solver import exact
from tests.helpers.exact_cases import (
    DECIMAL,
    EXACT,
    NUMERIC,
    RATIONAL,
    companion,
    each,
    hidden,
    is_zero,
    jordan,
    theta,
    x,
)
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

c, m = sp.symbols("c m", positive=True)
p, q = sp.symbols("p q", real=True)

STRUCTURES = [
    ("one block of three", {-2: [3]}),
    ("blocks of two and one of the same root", {-1: [2, 1]}),
    ("blocks of three, two and one of the same root", {2: [3, 2, 1]}),
    ("two blocks of two of the same root", {-1: [2, 2]}),
    ("two roots with blocks of two", {-1: [2], 1: [2]}),
    ("nilpotent blocks of different sizes", {0: [3, 1]}),
    ("a multiple of the identity", {5: [1, 1, 1]}),
    ("diagonal with equal entries", {1: [1, 1], 2: [1]}),
    ("zero", {0: [1, 1, 1]}),
]

PARAMETERS = {
    "triangular": sp.ImmutableMatrix([[p, 1], [0, q]]),
    "one block": sp.ImmutableMatrix([[p, q], [0, p]]),
    "oscillator": sp.ImmutableMatrix([[0, 1], [-c / m, 0]]),
    "undecided": sp.ImmutableMatrix([[0, 1], [-p, -q]]),
    "three roots": sp.ImmutableMatrix([[p, 1, 0], [0, q, 1], [0, 0, c]]),
    "rotation": sp.ImmutableMatrix([[sp.cos(theta), sp.sin(theta)], [-sp.sin(theta), sp.cos(theta)]]),
}


def residuals(A, found):
    """A V − V J and M A − J M."""
    V, M, J = found.right, found.left, found.jordan_form
    return A * V - V * J, M * A - J * M


def is_regular(modal):
    """Whether the determinant, at 40 digits, is not zero."""
    with mpmath.workdps(40):
        return abs(mpmath.det(mpmath.matrix(sp.Matrix(modal).evalf(40).tolist()))) > mpmath.mpf(10) ** -15


@pytest.mark.parametrize("A", **each(EXACT))
def test_the_chains_make_a_v_equal_to_v_j_exactly(A):
    found = exact.eigenstructure(A)
    assert is_zero(A * found.right - found.right * found.jordan_form)


@pytest.mark.parametrize("A", **each(EXACT))
def test_the_left_chains_make_m_a_equal_to_j_m_exactly(A):
    found = exact.eigenstructure(A)
    assert is_zero(found.left * A - found.jordan_form * found.left)


@pytest.mark.parametrize("A", **each(NUMERIC))
def test_both_modal_matrices_are_regular(A):
    found = exact.eigenstructure(A)
    for modal in (found.right, found.left):
        assert modal.shape == A.shape
        assert is_regular(modal)


@pytest.mark.parametrize("A", **each(DECIMAL))
def test_decimal_chains_hold_to_the_digits_carried(A):
    found = exact.eigenstructure(A)
    for residual in (
        A * found.right - found.right * found.jordan_form,
        found.left * A - found.jordan_form * found.left,
    ):
        assert max(abs(sp.N(entry, 10)) for entry in residual) < 1e-24


@pytest.mark.parametrize(("name", "expected"), STRUCTURES)
def test_known_block_sizes(name, expected):
    spaces = exact.eigenstructure(RATIONAL[name]).eigenspaces
    assert {int(space.root.value): [len(chain) for chain in space.chains] for space in spaces} == expected


@pytest.mark.parametrize("A", **each(EXACT))
def test_nullities_are_those_of_the_powers(A):
    for space in exact.eigenstructure(A).eigenspaces:
        N, power = A - space.root.value * sp.eye(A.rows), sp.eye(A.rows)
        for nullity in space.nullities:
            power = (power * N).applyfunc(lambda e: sp.radsimp(sp.expand(e)))
            assert A.rows - power.rank() == nullity
        assert space.nullities[-1] == space.algebraic
        assert space.nullities[0] == space.geometric


@pytest.mark.parametrize("A", **each(NUMERIC))
def test_diagonalizable_means_no_ones_above_the_diagonal(A):
    found = exact.eigenstructure(A)
    ones = [found.jordan_form[i, i + 1] for i in range(A.rows - 1)]
    assert found.diagonalizable == (not any(ones))
    assert [found.jordan_form[i, i] for i in range(A.rows)] == found.eigenvalues


@pytest.mark.parametrize("A", **each({name: A for name, A in EXACT.items() if exact.eigenstructure(A).diagonalizable}))
def test_the_inverses_of_both_modal_matrices(A):
    found = exact.eigenstructure(A)
    assert is_zero(found.right_inverse * found.right - sp.eye(A.rows))
    assert is_zero(found.left_inverse * found.left - sp.eye(A.rows))


@pytest.mark.parametrize("A", **each(RATIONAL))
def test_chains_of_rational_roots_are_integers_without_a_common_factor(A):
    for space in exact.eigenstructure(A).eigenspaces:
        for chain in space.chains:
            entries = [entry for vector in chain for entry in vector]
            assert all(entry.is_Integer for entry in entries)
            assert sp.igcd(0, *entries) == 1


@pytest.mark.parametrize("A", **each({name: A for name, A in RATIONAL.items() if len(A) > 1}))
def test_eigenvectors_without_chains_start_with_a_positive_entry(A):
    for space in exact.eigenstructure(A).eigenspaces:
        if space.geometric == space.algebraic:
            for (vector,) in space.chains:
                assert next(entry for entry in vector if entry != 0) > 0


@pytest.mark.parametrize("A", **each(EXACT))
def test_conjugate_roots_have_conjugate_chains(A):
    spaces = [space for space in exact.eigenstructure(A).eigenspaces if space.root.kind == "complex"]
    for upper, lower in zip(spaces[::2], spaces[1::2], strict=True):
        for left, right in zip(upper.chains, lower.chains, strict=True):
            assert all(is_zero(sp.Matrix(v).conjugate() - w) for v, w in zip(left, right, strict=True))


@pytest.mark.parametrize("A", **each(PARAMETERS))
def test_chains_with_parameters(A):
    found = exact.eigenstructure(A)
    point = {p: sp.Rational(-1, 3), q: sp.Rational(3, 4), c: sp.Rational(3, 2), m: 2, theta: sp.Rational(7, 10)}
    for residual in (
        A * found.right - found.right * found.jordan_form,
        found.left * A - found.jordan_form * found.left,
    ):
        assert max(abs(sp.N(entry.subs(point), 30)) for entry in residual) < 1e-25
    assert abs(sp.N(sp.Matrix(found.right).subs(point).det(), 10)) > 1e-9


def test_textbook_eigenvectors():
    found = exact.eigenstructure(companion((x + 1) * (x + 2)))
    assert found.right == sp.Matrix([[1, 1], [-2, -1]])
    assert found.eigenvalues == [-2, -1]


def test_a_companion_matrix_has_vandermonde_eigenvectors_of_its_pair():
    found = exact.eigenstructure(companion(x**2 + 2 * x + 5))
    (vector,) = found.eigenspaces[0].chains[0]
    assert sp.expand(vector[1] - (-1 + 2 * sp.I) * vector[0]) == 0


@tried(25)
@given(systems(6))
def test_random_systems(A):
    found = exact.eigenstructure(A)
    assert is_zero(A * found.right - found.right * found.jordan_form)
    assert is_zero(found.left * A - found.jordan_form * found.left)
    assert is_regular(found.right)
    assert is_regular(found.left)


def test_a_chain_of_chains_at_order_six():
    A = hidden(jordan((1, 3), (1, 2), (1, 1)))
    found = exact.eigenstructure(A)
    assert found.eigenspaces[0].nullities == (3, 5, 6)
    assert is_zero(A * found.right - found.right * found.jordan_form)


def test_eigenspaces_over_a_field_with_parameters_are_sent_to_another_process():
    a, b = sp.symbols("a b")
    found = exact.eigenstructure(sp.ImmutableMatrix([[0, -1], [a * b, a + b]]))
    received = pickle.loads(pickle.dumps(found.eigenspaces))  # noqa: S301 - our own bytes
    assert [space.chains for space in received] == [space.chains for space in found.eigenspaces]


@pytest.mark.parametrize(
    ("A", "expected"),
    [
        ([[-10, -10], [10, 0]], [2, -1 - sp.sqrt(3) * sp.I]),
        ([[0, 1], [-100, -9]], [2, -9 + sp.sqrt(319) * sp.I]),
        ([[1, 2], [3, 1]], [2, -sp.sqrt(6)]),
        ([[0, 1], [-25, 0]], [1, 5 * sp.I]),
    ],
)
def test_eigenvectors_with_square_roots_have_the_smallest_integers(A, expected):
    assert list(exact.eigenstructure(sp.ImmutableMatrix(A)).right[:, 0]) == expected


def test_vectors_of_measured_numbers_have_a_one_and_no_large_integers():
    A = sp.Matrix([["-0.313", "56.7", 0], ["-0.0139", "-0.426", 0], [0, "56.7", 0]]).applyfunc(sp.Rational)
    right = exact.eigenstructure(A.as_immutable()).right
    for vector in (right.col(j) for j in range(3)):
        assert 1 in list(vector)
        assert max(abs(complex(entry)) for entry in vector) < 100
