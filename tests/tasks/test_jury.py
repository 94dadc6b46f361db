"""Jury's criterion: counts against the roots by numpy, Raible's tables, special cases, conditions, corruptions."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Status
from solver.numeric.judges.digital import jury_fault
from solver.systems import Polynomial, StateSpace, TransferFunction
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict
from tests.helpers.said import page_of

z, K, a, b = sp.Symbol("z"), *sp.symbols("K a b", real=True)
METHODS = ("jury", "bilinear")
OGATA = z**4 - sp.Rational(6, 5) * z**3 + sp.Rational(7, 100) * z**2 + sp.Rational(3, 10) * z - sp.Rational(8, 100)


def polynomial(p):
    return Polynomial(tuple(sp.Poly(p, z).all_coeffs()), z, discrete=True)


def companion(p):
    c = sp.Poly(p, z).monic().all_coeffs()
    n = len(c) - 1
    last = [-each for each in reversed(c[1:])]
    return sp.ImmutableMatrix([[int(j == i + 1) for j in range(n)] for i in range(n - 1)] + [last])


def raible(p):
    """Raible's table: a row less its last entry over its first times the row in reverse order."""
    rows = [sp.Poly(p, z).all_coeffs()]
    while len(rows[-1]) > 1:
        row = rows[-1]
        rows.append([x - row[-1] / row[0] * y for x, y in zip(row, row[::-1], strict=True)][:-1])
    width = len(rows[0])
    return sp.ImmutableMatrix([r + [0] * (width - len(r)) for row in rows for r in (row, row[::-1])][:-1])


factors = st.lists(
    st.one_of(
        st.sampled_from([z, z - 1, z + 1, 2 * z - 1, z - 2, 3 * z + 1, z + 3, 2 * z + 3]),
        st.sampled_from([z**2 + 1, z**2 - z + 1, 2 * z**2 + 2 * z + 1, z**2 + 2 * z + 2, 4 * z**2 + 1, z**2 + 4]),
    ),
    min_size=1,
    max_size=4,
)


@settings(max_examples=14)
@given(factors, st.sampled_from([1, -2, 3]), st.sampled_from(METHODS))
def test_the_counts_are_those_of_the_factors(listed, lead, method):
    p = sp.expand(lead * sp.prod(listed))
    sizes = [abs(root) for factor in listed for root in np.roots([float(c) for c in sp.Poly(factor, z).all_coeffs()])]
    outside, on = sum(size > 1 + 1e-9 for size in sizes), sum(abs(size - 1) <= 1e-9 for size in sizes)
    result = ask("jury", polynomial(p), method)
    assert result.status is Status.VERIFIED
    assert result.answers["unstable_poles"] == outside
    assert result.answers["stable"] is bool(outside == on == 0)
    (told,) = (step.values for step in result.steps if step.kind == "verdict")
    assert (told["outside"], told["on"], told["inside"]) == (outside, on, sp.degree(p, z) - outside - on)


def test_the_table_of_a_textbook():
    """Ogata, Discrete-Time Control Systems, example 4–4."""
    result = ask("jury", polynomial(OGATA), "jury")
    assert [step.kind for step in result.steps if step.kind != "row"] == [
        "necessary", "table", "comparisons", "verdict",
    ]  # fmt: skip
    assert (result.steps[0].values["n"], result.steps[0].values["odd"]) == (4, False)
    wanted = [[-0.994, 1.176, -0.0756, -0.204, 0], [0.946, -1.184, 0.315, 0, 0]]
    assert np.allclose(np.array(result.answers["array"].tolist(), dtype=float)[[2, 4]], wanted, atol=1e-3)


def test_the_steps_by_the_map():
    kinds = [step.kind for step in ask("jury", polynomial((z + 1) * (2 * z - 1) * (z**2 - z + 1)), "bilinear").steps]
    assert [kind for kind in kinds if kind != "row"] == [
        "minus_one", "image", "first_rows", "zero_row", "array", "sign_changes", "symmetric", "verdict",
    ]  # fmt: skip


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("p", "outside", "on"),
    [
        ((z - 4) * (2 * z - 1) ** 2, 1, 0),  # a zero that is no reciprocal pair
        ((2 * z - 1) * (z - 2), 1, 0),
        ((z**2 - z + 1) * (2 * z - 1) * (z - 2), 1, 2),
        ((z + 1) ** 2, 0, 2),
        (z - 1, 0, 1),
        (-2 * z, 0, 0),
        (z**5, 0, 0),
        (z**3 - 8, 3, 0),
        (z**2 - sp.sqrt(2) * z + sp.Rational(1, 2), 0, 0),
        (z**6 + 1, 0, 6),
        ((2 * z - 1) ** 2 * (z - 2) ** 2, 2, 0),
    ],
)
def test_special_cases(method, p, outside, on):
    result = ask("jury", polynomial(sp.expand(p)), method)
    assert result.status is Status.VERIFIED
    assert result.answers["unstable_poles"] == outside
    (told,) = (step.values for step in result.steps if step.kind == "verdict")
    assert (told["outside"], told["on"]) == (outside, on)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("p", "condition"),
    [
        (z**3 - z**2 + z / 4 + K, (-sp.Rational(1, 4) < K) & (sp.Rational(1, 2) > K)),
        (z - K, (K > -1) & (K < 1)),
        (K * z**2 + z + 1, None),
        (z**2 + K * z + 1, sp.false),
        ((z + 1) * (z - K), sp.false),
        (z**2 + K * z / (1 + K**2), sp.true),
        (z**5 + K * z**3 + z / 2 + K / 4, None),
    ],
)
def test_conditions_on_a_parameter(method, p, condition):
    result = ask("jury", polynomial(p), method)
    assert result.status is Status.VERIFIED
    for value in (-2.5, -0.9, -0.3, 0.2, 0.45, 0.6, 1.1, 2.2, 3.7):
        at = bool(result.answers["condition"].subs(K, value))
        roots = np.roots([float(c.subs(K, value)) for c in sp.Poly(p, z).all_coeffs()])
        assert at == bool((abs(roots) < 1 - 1e-12).all())
        assert condition is None or at == bool(condition.subs(K, value))


def test_the_triangle_of_two_parameters():
    result = ask("jury", polynomial(z**2 + a * z + b))
    assert result.status is Status.VERIFIED
    for x in np.linspace(-2.3, 2.3, 9):
        for y in np.linspace(-1.3, 1.3, 9):
            inside = bool((abs(np.roots([1, x, y])) < 1).all())
            assert bool(result.answers["condition"].subs({a: x, b: y})) == inside
    assert any(step.figures for step in result.steps)


def test_only_the_parameter_asked_for_is_solved_for():
    c = sp.Symbol("c", positive=True)
    condition = ask("jury", polynomial(z**2 + K * z + c / (1 + c)), parameter=("K",)).answers["condition"]
    assert condition.has(K)
    assert ask("jury", polynomial(z - c / (1 + c))).answers["stable"]


def test_plants_and_loops_are_asked_by_their_characteristic_polynomial():
    G = TransferFunction(sp.ImmutableMatrix([[1 / (z - 1)]]), ((sp.Integer(1),),), ((z - 1,),), z, discrete=True)
    result = ask("jury", G, controller=K, feedback=sp.Integer(1))
    assert result.answers["condition"] == ((K > 0) & (K < 2))
    plant = StateSpace(sp.ImmutableMatrix([[0, 1], [2, 1]]), discrete=True)
    assert ask("jury", plant).answers["unstable_poles"] == 1
    assert ask("jury", replace(plant, A=sp.ImmutableMatrix([[0, 1], [0, 0]]))).answers["stable"]


@pytest.mark.parametrize("p", [OGATA, 2 * z**5 + 3 * z**4 + z**3 - 2 * z**2 + 5 * z + 1, z**3 - z**2 + z / 4 + K])
def test_raibles_and_other_tables_are_right(p):
    table = raible(p)
    n = sp.degree(p, z)
    ours = ask("jury", polynomial(p), "jury").answers["array"]
    decisive = ours[: 2 * n - 3, :]
    signs = [1, 1, *[(-1) ** i for i in range(decisive.rows)]]
    scaled = sp.diag(*[signs[i] * (i + 2) for i in range(decisive.rows)]) * decisive
    plain = sp.ImmutableMatrix(table[0 : 2 * n - 3 : 2, :])
    for right in (table, table[: 2 * n - 3, :], ours, scaled, plain, table[::2, :]):
        assert jury_fault(companion(p), sp.ImmutableMatrix(right).applyfunc(sp.cancel)) == ""


def test_corrupted_tables_are_rejected():
    p = polynomial(OGATA)
    for method in METHODS:
        array = ask("jury", p, method).answers["array"]
        for i in range(array.rows):
            for j in range(array.cols):
                wrong = array.as_mutable()
                wrong[i, j] += sp.Rational(1, 7)
                assert rejected("jury", p, {"array": sp.ImmutableMatrix(wrong)}), (i, j)
        assert rejected("jury", p, {"array": sp.ImmutableMatrix(array[:-1, :])})
        assert method == "bilinear" or rejected("jury", p, {"array": -array})
        assert not rejected("jury", p, {"array": array})
    unstable = polynomial(z**3 + 2 * z**2 + 3 * z + 5)
    table = ask("jury", unstable, "jury").answers["array"].as_mutable()
    table[-1, 0] *= 2
    assert rejected("jury", unstable, {"array": sp.ImmutableMatrix(table)})


def test_corrupted_answers_are_rejected():
    p = polynomial(z**3 - 2 * z**2 + z / 3 - sp.Rational(1, 5))
    assert rejected("jury", p, {"stable": True})
    for number in (0, 2, 3):
        assert rejected("jury", p, {"unstable_poles": sp.Integer(number)})
    assert not rejected("jury", p, {"stable": False, "unstable_poles": sp.Integer(1)})
    q = polynomial(z**3 - z**2 + z / 4 + K)
    low, high = -sp.Rational(1, 4) < K, sp.Rational(1, 2) > K
    for condition in (low, high, low & (sp.Rational(51, 100) > K), (low & high) | (K > 4), sp.true, sp.false):
        assert rejected("jury", q, {"condition": condition}), condition
    assert not rejected("jury", q, {"condition": low & high})


MARKED = """
find:
  a: {task: jury, system: {time: discrete, polynomial: z^3 - z^2 + z/4 + K}}
  b: {task: jury, system: {time: discrete, polynomial: z^3 - 2z^2 + z/3 - 1/5}}
  c: {task: jury, method: bilinear, system: {time: discrete, polynomial: z^2 - z/2 + 1/4}}
  e: {task: jury, system: {time: discrete, polynomial: z^3 + 3z^2/2 + z + K}}
  d: {task: jury, method: jury, system: {time: discrete, polynomial: z^3 - 2z^2 + z/3 - 1/5}}
"""


@pytest.mark.parametrize(
    ("part", "name", "value", "found"),
    [
        ("a", "condition", "-0.25 < K < 0.5", ("correct", None)),
        ("a", "condition", "K > 0 and K < 1", ("wrong", None)),
        ("a", "condition", "-0.25 < K < 1", ("wrong", "necessary_only")),
        ("a", "condition", "never", ("wrong", None)),
        ("e", "condition", "0 < K < 1.5", ("wrong", "half_plane")),
        ("b", "stable", "no", ("correct", None)),
        ("b", "unstable_poles", "1", ("correct", None)),
        ("b", "array", '"[1, -2, 1/3, -1/5; -1/5, 1/3, -2, 1; 24/25, -29/15, -1/15, 0]"', ("correct", None)),
        ("c", "array", '"[7, 3; 6, 0; 3, 0]"', ("correct", None)),  # z = (1 + w)/(1 − w)
        ("c", "array", '"[3, 7; 6, 0; 7, 0]"', ("correct", None)),  # z = (w + 1)/(w − 1)
        ("d", "array", '"[3, 7; 6, 0; 7, 0]"', ("wrong", None)),
    ],
)
def test_marking(part, name, value, found):
    told = verdict(MARKED, part, name, value)
    assert (told.verdict, told.mistake or None) == found


@pytest.mark.parametrize(
    ("p", "halved", "second_row"),
    [
        (z**2 + K * z + a, True, False),
        (z**3 + K * z + a, False, True),
        (z**2 + z / 2, False, False),
        (OGATA, False, True),
    ],
)
def test_only_a_table_of_more_than_a_row_has_rows_in_reverse_order(p, halved, second_row):
    page = page_of("jury", "jury", polynomial(p))
    assert ("the half $a_{0} < a_{2}$ is enough" in page) is halved
    assert ("in the second in reverse order" in page) is second_row
