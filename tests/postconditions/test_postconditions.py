"""What must hold of a kernel's result holds of the right one, and of none that is a little wrong."""

from dataclasses import replace
from importlib import import_module
from pkgutil import iter_modules

import pytest
import sympy as sp

from solver import exact, postconditions
from solver.derivation import CheckStatus
from solver.lazy import Call
from solver.postconditions import check_calls, postcondition_of
from tools.corrupted_kernels.changes import changes

s, t, K = sp.symbols("s t K")
A = sp.ImmutableMatrix([[0, 1, 0], [0, 0, 1], [-6, -11, -6]])
HIDDEN = sp.ImmutableMatrix([[-1, 0, 0], [0, -2, 0], [0, 0, -2]])
B, ONES, SECOND = (sp.ImmutableMatrix(column) for column in ([0, 0, 1], [1, 1, 1], [1, 1, 3]))
TURNING = sp.ImmutableMatrix([[0, 1], [-5, -2]])
SINGULAR = sp.ImmutableMatrix([[0, 2, 2], [1, 1, 0], [2, 4, 2]])
ROW = sp.ImmutableMatrix([[1, 0, 0]])
G = exact.transfer_matrix(TURNING, sp.ImmutableMatrix([0, 1]), sp.ImmutableMatrix([[1, 0]]), None, s)
SMITH = sp.ImmutableMatrix([[s * (s + 1), 0], [0, s * (s + 2)]])
FACTOR = exact.spectrum(TURNING).factors[0]
TINY = sp.Rational(1, 10**12)
TWO = sp.ImmutableMatrix([[1, 0], [0, 1], [1, 1]])
SPACES = [exact.attainable_eigenvectors(A, TWO, pole) for pole in (sp.Integer(-4), -1 + 2 * sp.I)]
VECTORS = sp.ImmutableMatrix([1, 0, 0]), sp.ImmutableMatrix([1, sp.I, 2])
EPSILON = (1, 1, 2, 2, 3)

CALLS = {
    "controllability_matrix": [(A, B), (HIDDEN, ONES)],
    "reachable_order": [(A, B), (HIDDEN, ONES)],
    "rank": [(SINGULAR,), (sp.ImmutableMatrix([[K, 1], [1, K]]),)],
    "independent_columns": [(SINGULAR,)],
    "row_reduction": [(SINGULAR,), (A,)],
    "hidden_part": [(HIDDEN, SECOND), (A, B)],
    "pencil_ranks": [(HIDDEN, SECOND), (TURNING, sp.ImmutableMatrix([0, 1]))],
    "characteristic_factors": [(A,), (TURNING,)],
    "spectrum": [(A,), (TURNING,), (HIDDEN,)],
    "multiply": [(A, B)],
    "determinant": [(SINGULAR,), (sp.ImmutableMatrix([[K, 1], [1, K]]),)],
    "inverse": [(A,), (sp.ImmutableMatrix([[K, 1], [1, K]]),)],
    "solve_affine": [(sp.ImmutableMatrix([[1, 1], [2, 2]]), (s, 2 * s), sp.symbols("x1 x2"))],
    "taylor": [(sp.exp(-2 * t), t, 4), (sp.sin(t), t, 4)],
    "sign_of": [(sp.Integer(3),), (sp.sqrt(2) - 2,), (sp.Integer(0),), (sp.Symbol("a", positive=True),)],
    "sign_changes": [([1, -1, 0, 1],)],
    "routh": [(EPSILON,), ((1, 2, 3, 4, 5),), ((1, 1, 2, 2),), ((1, 3, K, 6),)],
    "hurwitz_matrix": [((1, 2, 3, 4),), ((K, 1, s, 3, K, 2, 1),)],
    "resolvent_cancels": [(HIDDEN,), (TURNING,)],
    "shifted": [(sp.ImmutableMatrix([sp.exp(-t)]), t, sp.Integer(2))],
    "read_inputs": [((sp.Heaviside(t - 2) * t, sp.DiracDelta(t)), t)],
    "added": [(A, A)],
    "at_rest": [(A,)],
    "location": [(A,), (TURNING,), (sp.ImmutableMatrix([[0, 1], [-1, 0]]),)],
    "root_conditions": [((sp.Integer(1), K, s),), ((sp.Integer(1), K),)],
    "is_stable_polynomial": [((sp.Integer(1), sp.Integer(2), sp.Integer(sign * 3)),) for sign in (1, -1)],
    "decays": [(FACTOR,)],
    "constant_root": [(FACTOR,), (exact.spectrum(sp.ImmutableMatrix([[0]])).factors[0],)],
    "in_time": [(sp.exp(t + 1) / (sp.exp(2) - 1) - sp.exp(1 - t) / (sp.exp(2) - 1), t), ((t + 1) ** 2, t)],
    "along": [(sp.cos(t) ** 2 - sp.sin(t) ** 2, t), ((t - 1) ** 2 + t, t)],
    "definite_integral": [(t**2 + sp.exp(-t), t, sp.S.Zero, sp.S(2)), (sp.cosh(t), t, sp.S.Zero, sp.S.One)],
    "kalman_decomposition": [(HIDDEN, SECOND, sp.ImmutableMatrix([[1, 0, 1]]))],
    "controllable_decomposition": [(HIDDEN, SECOND, None)],
    "observable_decomposition": [(HIDDEN, None, sp.ImmutableMatrix([[1, 0, 1]]))],
    "reached_in_echelon": [(HIDDEN, SECOND, sp.ImmutableMatrix([[1, 0, 1]]))],
    "seen_in_echelon": [(HIDDEN, SECOND, sp.ImmutableMatrix([[1, 0, 1]]))],
    "companion_orders": [(G,)],
    "set_point": [(A, B, sp.ImmutableMatrix([[1, 0, 0]]), sp.ImmutableMatrix([[0]]))],
    "is_upper": [(mode,) for mode in exact.modes(G)],
    "complex_parts": [(sp.Integer(-1) + 2 * sp.I,), (sp.Integer(3),)],
    "without_bars": [(A,)],
    "tidy": [((s + 1) ** 2,)],
    "interpolation": [(exact.spectrum(A), t)],
    "affine": [((2 * K + s * t + 1, K - t), (K, t))],
    "equations_of_rest": [(A, B, ROW, sp.ImmutableMatrix([[0]]))],
    "with_integrators": [(A, B, ROW, sp.ImmutableMatrix([[0]]))],
    "matrix_of": [((2 * K + s * t, K - t), (K, t))],
    "is_singular": [(SINGULAR,), (A,)],
    "measured_first": [(A, B, sp.ImmutableMatrix([[1, 0, 0]])), (A, B, sp.ImmutableMatrix([[1, 1, 0]]))],
    "minimal_solution": [tuple(sp.ImmutableMatrix([[value]]) for value in (TINY, 1, TINY, 1))],
    "attainable_eigenvectors": [(A, TWO, sp.Integer(-4)), (A, TWO, -1 + 2 * sp.I), (A, B.row_join(B), sp.Integer(-3))],
    "nearest_eigenvector": list(zip(SPACES, VECTORS, strict=True)),
    "parts_of_columns": [(VECTORS[1],)],
    "polynomial_in": [(s, (sp.Integer(1), K, sp.Integer(-2)))],
    "conjugated": [(VECTORS[1],), (K - 2 * sp.I,)],
    "normal": [(K * sp.sin(t) ** 2 + K * sp.cos(t) ** 2 + 1 / (s + 1),), (K,)],
    "is_zero": [(sp.sin(t + K) - sp.sin(t) * sp.cos(K) - sp.cos(t) * sp.sin(K),), (K - 1 / t,), (sp.S.Zero,)],
    "time_derivative": [(K * sp.cos(t), {t: s}), (t, {t: s, s: K})],
    "smith_form": [(SMITH, s), (sp.ImmutableMatrix([[s, 1, s], [s**2, s, s**2]]), s)],
    "smith_mcmillan": [(G,), (exact.transfer_matrix(A, TWO, TWO.T, None, s),)],
    "determinantal_divisors": [(SMITH, s)],
    "relative_gains": [(sp.ImmutableMatrix([[2, 1], [3, 4]]),), (sp.ImmutableMatrix([[1, K], [sp.I, 2]]),)],
    "gains_at": [([[sp.S.One, s], [s + 2, sp.S(2)]], [[s, s + 1], [s + 1, s + 4]], s, sp.S.Zero)],
    "values_at": [(sp.ImmutableMatrix([[1 / (s + 1), s / (s + 2)]]), s, sp.S.One)],
    "pairing": [(sp.ImmutableMatrix([[2, -1], [-1, 2]]),), (sp.ImmutableMatrix([[1, 3], [3, 1]]) / 4,)],
    "trials": [(exact.LinearForm((sp.S(2), sp.S(3), sp.S.One), t * sp.exp(-t)), t)],
    "table_integral": [(t * sp.exp(-t), t), (1 / (t**2 + 4), t)],
    "integrating_factor": [(exact.LinearForm((1 / t, sp.S.One), t**2), t)],
    "conjugate": [(sp.sin(2 * t) / 2, t, sp.S.Zero, sp.S.One)],
    "matching": [(s + 1, s**2 + 3 * s + 5, (s + 1) / (s**2 + 4 * s + 5), s)],
}
TIMED = (
    "equations_of_rest",
    "with_integrators",
    "interpolation",
    "set_point",
    "read_inputs",
    "at_rest",
    "location",
    "is_stable_polynomial",
    "root_conditions",
    "decays",
    "constant_root",
)
"""Kernels that want to know whether time is discrete."""

FREE = {
    "smith_form": (".stages", ".leads", ".is_long", ".is_general", ".rows", ".shape"),
    "smith_mcmillan": (
        ".smith.stages",
        ".smith.leads",
        ".smith.is_long",
        ".smith.is_general",
        ".smith.rows",
        ".G.",
        ".form",
        ".shape",
    ),
    "kalman_decomposition": (".hidden_modes", ".reached", ".unseen"),
    "controllable_decomposition": (".hidden_modes", ".reached", ".unseen"),
    "observable_decomposition": (".hidden_modes", ".reached", ".unseen"),
    "reached_in_echelon": (".hidden_modes", ".unseen"),
    "seen_in_echelon": (".hidden_modes", ".reached", ".unseen"),
    "set_point": (".exceptions",),
    "interpolation": (".right", "in it", ".row["),
    "location": (".critical", ".spectrum.exceptions"),
    "spectrum": (".exceptions",),
    "solve_affine": (".conditions", ".residue"),
    "read_inputs": (".generator",),
    "trials": (".letters", ".equations", ".resonance", ".angle", ".exponent", ".exceptions", ".function"),
    "integrating_factor": (".factor", ".right"),
    "conjugate": (".searched",),
    "matching": (".numerator", ".denominator", ".target", ".missing", ".gain", ".possible", ".desired", ".compensator"),
}
"""What is judged elsewhere, by the steps that show it; and bases, of which others are right."""

MOST = 40
"""Changes that are tried of a result."""

CASES = [pytest.param(name, arguments, id=f"{name}-{i}") for name in CALLS for i, arguments in enumerate(CALLS[name])]


def statuses(name, arguments, result):
    named = {"discrete": False} if name in TIMED else {}
    return {check.status for check in check_calls([Call(name, arguments, named, result, 1)], [])}


@pytest.mark.parametrize(("name", "arguments"), CASES)
def test_it_holds_of_the_right_result_and_of_none_that_is_a_little_wrong(name, arguments):
    result = getattr(exact, name)(*arguments, **({"discrete": False} if name in TIMED else {}))
    assert statuses(name, arguments, result) <= {CheckStatus.PASSED}
    judged = [each for each in changes(result) if not any(free in each.what for free in FREE.get(name, ()))]
    judged = judged[:: len(judged) // MOST + 1]
    survived = [each.what for each in judged if not _is_seen(name, arguments, each.made)]
    assert judged or result is None
    assert not survived


def _is_seen(name, arguments, made):
    try:
        return CheckStatus.FAILED in statuses(name, arguments, made())
    except (ValueError, IndexError, KeyError, TypeError, AttributeError, sp.ShapeError):
        return True


@pytest.mark.parametrize("unmeasured", [(1, -1), (-2, -1), (1, 3), (1,), (0, 1, 2)])
def test_states_that_are_not_measured_are_counted_from_zero(unmeasured):
    arguments = (A, B, ROW)
    wrong = replace(exact.measured_first(*arguments), unmeasured=unmeasured)
    assert CheckStatus.FAILED in statuses("measured_first", arguments, wrong)


@pytest.mark.parametrize("u", [sp.Heaviside(sp.Symbol("k")), sp.Heaviside(sp.Symbol("k") - 3)])
def test_inputs_at_samples_of_which_no_piece_was_read_are_seen(u):
    arguments, timed = ([u], sp.Symbol("k")), {"discrete": True}
    for found in (exact.read_inputs(*arguments, **timed), ()):
        checks = check_calls([Call("read_inputs", arguments, timed, found, 1)], [])
        assert (CheckStatus.FAILED in {check.status for check in checks}) == (not found)


def test_each_postcondition_is_that_of_a_kernel():
    modules = [import_module(f"solver.postconditions.{each.name}") for each in iter_modules(postconditions.__path__)]
    named = {name.removeprefix("of_") for module in modules for name in vars(module) if name.startswith("of_")}
    assert set(CALLS) <= named <= set(exact.__all__)


def test_what_was_found_twice_is_checked_once():
    arguments = (A, B, ROW)
    found = exact.measured_first(*arguments)
    results = found, replace(found), replace(found, unmeasured=(0, 1))
    calls = [Call("measured_first", arguments, {}, result, 1) for result in results]
    once = list(check_calls(calls[:1], []))
    assert list(check_calls(calls[:2], [])) == once
    assert CheckStatus.FAILED in {check.status for check in check_calls(calls, [])}


def test_what_is_checked_is_named():
    for name, arguments in ((name, CALLS[name][0]) for name in CALLS):
        named = {"discrete": False} if name in TIMED else {}
        result = getattr(exact, name)(*arguments, **named)
        checks = list(check_calls([Call(name, arguments, named, result, 1)], []))
        assert all(check.claim for check in checks), name


def test_of_other_kernels_nothing_is_said():
    assert postcondition_of("exponential") is None


def test_solutions_of_another_equation_or_too_few_are_seen():
    coefficients = (sp.S(2), sp.S(3), sp.S.One)
    found = exact.fundamental_system(coefficients, t)
    assert statuses("fundamental_system", (coefficients, t), found) == {CheckStatus.PASSED}
    for functions in ((sp.exp(-t), sp.exp(2 * t)), (sp.exp(-t),), (sp.exp(-t), 3 * sp.exp(-t))):
        assert CheckStatus.FAILED in statuses(
            "fundamental_system", (coefficients, t), replace(found, functions=functions)
        )
