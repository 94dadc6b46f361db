"""Solutions of Riccati equations in the form a person would write: no root below a root where none is needed."""

import json

import pytest
import sympy as sp

from solver import solve
from solver.derivation import Status
from tests.helpers.asking import ask, system

a, b, q, r, w = sp.symbols("a b q r w", positive=True)
I2 = sp.ImmutableMatrix(sp.eye(2))
INTEGRATORS = [[0, 1], [0, 0]]


def weights(Q, R):
    return {"Q": sp.ImmutableMatrix(Q), "R": sp.ImmutableMatrix(R)}


def depth(value) -> int:
    """How many roots stand below each other."""
    if not hasattr(value, "args"):
        return max(map(depth, value), default=0)
    inner = max(map(depth, value.args), default=0)
    return inner + 1 if value.is_Pow and value.exp.is_Rational and not value.exp.is_Integer else inner


@pytest.mark.parametrize(
    ("Q", "R", "expected"),
    [
        (q * I2, r * I2, -sp.sqrt(q) / sp.sqrt(r)),
        (q * I2, I2, -sp.sqrt(q)),
        (I2, r * I2, -1 / sp.sqrt(r)),
        (q**2 * I2, I2, -q),
        ((q**2 + 2 * q * r + r**2) * I2, I2, -q - r),
    ],
)
def test_a_rotation_is_damped_by_the_root_of_the_weights(Q, R, expected):
    """A = w [[0, 1], [−1, 0]], B = I: every eigenvalue is −√(q/r) ± jw."""
    plant = system([[0, w], [-w, 0]], B=I2)
    answers = ask("lqr", plant, "hamiltonian", **weights(Q, R)).answers
    assert {sp.expand(each) for each in answers["eigenvalues"]} == {expected + sp.I * w, expected - sp.I * w}


ROOTS = [q, q * r, q / r, q**2 * a, (q + r) ** 2, q + 1, q / (a + 1)]


@pytest.mark.parametrize("c", ROOTS)
@pytest.mark.parametrize("d", [0, a, b * q])
def test_what_two_integrators_need_are_roots_of_rational_functions(c, d):
    """s⁴ − d²s² + c² = (s² + √(2c + d²) s + c)(…): roots of rational functions, whatever c and d are."""
    result = ask("lqr", system(INTEGRATORS, B=[0, 1]), "hamiltonian", **weights([[c**2, 0], [0, d**2]], [[1]]))
    assert result.status is Status.VERIFIED, result.reason
    assert depth(result.answers["P"]) <= 1
    assert depth(result.answers["eigenvalues"]) <= 1


@pytest.mark.parametrize("c", ROOTS)
def test_filters_need_no_more(c):
    result = ask("kalman_filter", system(INTEGRATORS, C=[[1, 0]]), "hamiltonian", **weights([[a, 0], [0, c**2]], [[1]]))
    assert result.status is Status.VERIFIED, result.reason
    assert depth(result.answers["P"]) <= 1
    assert depth(result.answers["eigenvalues"]) <= 1


def test_common_factors_stand_before_the_root():
    """P = [[√p √(q + 2√(p r)), √(p r)], [√(p r), √r √(q + 2√(p r))]] by both methods, and so on the way."""
    p = sp.Symbol("p", positive=True)
    root = sp.sqrt(q + 2 * sp.sqrt(p) * sp.sqrt(r))
    off = sp.sqrt(p) * sp.sqrt(r)
    expected = sp.ImmutableMatrix([[sp.sqrt(p) * root, off], [off, sp.sqrt(r) * root]])
    for method in ("riccati", "hamiltonian"):
        result = ask("lqr", system(INTEGRATORS, B=[0, 1]), method, **weights([[p, 0], [0, q]], [[r]]))
        assert result.answers["P"] == expected
        ends = [step.values["P"] for each in result.steps for step in each.walk() if step.kind == "end"]
        assert expected in ends or method == "hamiltonian"


@pytest.mark.parametrize(
    ("A", "Q", "expected"),
    [
        ([[1]], [[2 + 2 * sp.sqrt(2)]], [-1 - sp.sqrt(2)]),
        (INTEGRATORS, [[2, 0], [0, 6]], [-sp.sqrt(3 + sp.sqrt(7)), -sp.sqrt(3 - sp.sqrt(7))]),
        (INTEGRATORS, [[1, 0], [0, 6]], [-sp.sqrt(2) - 1, 1 - sp.sqrt(2)]),
        (INTEGRATORS, [[1, 0], [0, 10]], [-sp.sqrt(3) - sp.sqrt(2), sp.sqrt(2) - sp.sqrt(3)]),
    ],
)
def test_numbers_have_as_few_roots_as_can_be(A, Q, expected):
    plant = system(A, B=[0, 1][-len(A) :])
    assert set(ask("lqr", plant, "hamiltonian", **weights(Q, [[1]])).answers["eigenvalues"]) == set(expected)


def test_what_later_parts_make_of_decimals_is_decimals():
    """The gain of three states is known in decimals; what follows from it has no fractions of 15 digits."""
    text = (
        "system: {A: [[0, 1, 0], [0, 0, 1], [1, 2, 3]], B: [0, 0, 1], C: [1, 0, 0]}\nfind:\n"
        "  a: {task: lqr, method: hamiltonian, Q: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], R: 1}\n"
        "  b: {task: transfer_function, gain: {from: a}}\n"
        "  c: {task: reference_tracking, gain: {from: a}}\n"
        "  d: {task: controllability, system: {from: b}}\n"
    )
    _, *parts = json.loads(solve(text).json())["parts"]
    for part in parts:
        assert part["status"] == "verified", part
        for answer in part["answers"].values():
            values = sp.sympify(answer["value"]) if isinstance(answer["value"], str) else sp.S.Zero
            numbers = values.atoms(sp.Rational) if hasattr(values, "atoms") else set()
            assert all(max(abs(number.p), number.q) < 1000 for number in numbers)
    assert parts[1]["answers"]["N"]["value"] == "Matrix([[-1]])"
