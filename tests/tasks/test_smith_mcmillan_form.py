"""The Smith–McMillan form: textbook values, minors, state space, parameters, special cases, corruptions, marking."""

from __future__ import annotations

from functools import reduce
from itertools import combinations

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Status
from solver.systems import TransferFunction
from tests.helpers.asking import ask, rejected, system
from tests.helpers.marked import verdict

TASK = "smith_mcmillan_form"
s, z, k = sp.symbols("s z k")


def matrix(rows, *, x=s):
    """The transfer matrix with these entries."""
    G = sp.ImmutableMatrix(rows)
    pairs = [[sp.fraction(sp.together(entry)) for entry in row] for row in G.tolist()]
    tops, bottoms = (tuple(tuple(sp.expand(pair[i]) for pair in row) for row in pairs) for i in (0, 1))
    return TransferFunction(G.applyfunc(sp.cancel), tops, bottoms, x, discrete=str(x) == "z")


SKOGESTAD = [
    [(s - 1) * (s + 2), 0, (s - 1) ** 2],
    [-(s + 1) * (s + 2), (s - 1) * (s + 1), (s - 1) * (s + 1)],
]
KNOWN = [
    # Maciejowski, Multivariable Feedback Design (1989), example 2.1
    (
        [[1, -1], [s**2 + s - 4, 2 * s**2 - s - 8], [s**2 - 4, 2 * s**2 - 8]],
        (s + 1) * (s + 2),
        [1 / ((s + 1) * (s + 2)), (s - 2) / (s + 1)],
    ),
    # Skogestad and Postlethwaite, Multivariable Feedback Control (2005), example 4.8
    (SKOGESTAD, (s + 1) * (s + 2) * (s - 1), [1 / ((s + 1) * (s + 2) * (s - 1)), (s - 1) / (s + 2)]),
    (
        [[s + 2, s + 1], [s + 1, s + 2]],
        (s + 1) * (s + 2),
        [1 / ((s + 1) * (s + 2)), (2 * s + 3) / (2 * s + 4) / (s + 1)],
    ),
    ([[1, 0], [0, (s + 1) ** 2]], s + 1, [1 / (s + 1), s + 1]),
    ([[1, 2], [2, 4]], s + 1, [1 / (s + 1), 0]),
    ([[0, 0], [0, 0]], sp.S.One, [0, 0]),
    ([[1, 2], [3, 4]], sp.S.One, [1, 1]),
    ([[2 * s + 4]], s**2 + 3 * s + 2, [1 / (s + 1)]),
    ([[(s + 1) ** 2, (s + 1) * (s + 2)], [s + 2, 2 * s + 2]], (s + 1) ** 2, None),
]


def by_minors(G):
    """The form by the definition with minors: pole and zero polynomials of each order."""
    found, before = [], sp.S.One
    for order in range(1, min(G.shape) + 1):
        minors = [
            sp.cancel(G.extract(list(rows), list(columns)).det())
            for rows in combinations(range(G.rows), order)
            for columns in combinations(range(G.cols), order)
        ]
        fractions = [sp.fraction(sp.together(minor)) for minor in minors if minor != 0]
        if not fractions:
            return found + [sp.S.Zero] * (min(G.shape) - len(found))
        below = reduce(sp.lcm, (q for _, q in fractions))
        above = reduce(sp.gcd, (sp.cancel(p * below / q) for p, q in fractions))
        monic = [
            sp.Poly(each, s, extension=True).monic().as_expr() if each.has(s) else sp.S.One for each in (above, below)
        ]
        whole = sp.cancel(monic[0] / monic[1])
        found.append(sp.cancel(whole / before))
        before = whole
    return found


@pytest.mark.parametrize(("numerators", "denominator", "diagonal"), KNOWN)
def test_known_forms(numerators, denominator, diagonal):
    G = (sp.Matrix(numerators) / denominator).applyfunc(sp.cancel)
    result = ask(TASK, matrix(G))
    assert result.status is Status.VERIFIED
    found = result.answers["diagonal"]
    for each in filter(None, (diagonal, by_minors(G))):
        assert [sp.cancel(a - b) for a, b in zip(found, each, strict=True)] == [0] * len(found)
    assert result.answers["form"].shape == G.shape
    assert not rejected(TASK, matrix(G), dict(result.answers))


def test_the_steps_of_a_plant_in_state_space():
    plant = system([[-1, 0, 0], [0, -2, 0], [0, 0, -2]], B=[[1, 0], [0, 1], [1, 1]], C=[[1, 0, 1], [0, 1, 1]])
    result = ask(TASK, plant)
    assert result.status is Status.VERIFIED
    kinds = [step.kind for step in result.steps]
    assert kinds[-8:] == ["common_denominator", "sought", "pivot", "pivot", "factors", "unimodular", "divided", "form"]
    three = sp.Rational(5, 3)
    assert result.answers["diagonal"] == [1 / ((s + 1) * (s + 2)), (s + three) / (s + 2)]


def test_a_mode_that_is_not_seen_is_no_pole():
    plant = system(sp.diag(-1, -2, -3), B=[[1, 0], [0, 1], [0, 0]], C=[[1, 0, 1], [0, 1, 1]])
    result = ask(TASK, plant)
    assert result.status is Status.VERIFIED
    assert result.answers["diagonal"] == [1 / ((s + 1) * (s + 2)), sp.S.One]


def test_parameters_and_where_the_form_is_another():
    a = sp.Symbol("a", real=True)
    plant = matrix([[1 / (s + a), 1 / (s + 1)], [1 / (s + 1), 1 / (s + 1)]])
    result = ask(TASK, plant)
    assert result.status is Status.VERIFIED
    assert result.steps[-1].values["exceptions"] == (a - 1,)
    at_one = ask(TASK, matrix([[1 / (s + 1), 1 / (s + 1)], [1 / (s + 1), 1 / (s + 1)]]))
    assert at_one.answers["diagonal"] == [1 / (s + 1), 0]


def test_a_zero_that_meets_a_pole_is_an_exception():
    b = sp.Symbol("b", real=True)
    result = ask(TASK, matrix([[(s + b) / (s + 1)]]))
    assert result.answers["diagonal"] == [(s + b) / (s + 1)]
    assert [sp.expand(each**2 - (b - 1) ** 2) for each in result.steps[-1].values["exceptions"]] == [0]


def test_four_tanks_with_eight_parameters():
    T, c, g = (sp.symbols(f"{name}1:5", positive=True) for name in "Tcg")
    G = sp.Matrix([
        [g[0] * c[0] / (T[0] * s + 1), (1 - g[1]) * c[0] / ((T[0] * s + 1) * (T[2] * s + 1))],
        [(1 - g[0]) * c[1] / ((T[1] * s + 1) * (T[3] * s + 1)), g[1] * c[1] / (T[1] * s + 1)],
    ])  # fmt: skip
    result = ask(TASK, matrix(G))
    assert result.status is Status.VERIFIED
    zeros = (T[2] * s + 1) * (T[3] * s + 1) - (1 - g[0]) * (1 - g[1]) / (g[0] * g[1])
    expected = zeros / (T[2] * T[3])
    poles = sp.Mul(*(s + 1 / each for each in T))
    assert sp.cancel(result.answers["diagonal"][0] * poles) == 1
    assert sp.cancel(result.answers["diagonal"][1] - expected) == 0


@settings(max_examples=25)
@given(st.integers(1, 3), st.integers(1, 3), st.data())
def test_random_matrices_have_the_form_by_minors(rows, columns, data):
    tops = st.lists(st.integers(-2, 2), min_size=1, max_size=2)
    roots = st.lists(st.sampled_from([0, -1, -2]), min_size=1, max_size=2)

    def entry(_i, _j):
        return sp.Poly(data.draw(tops), s).as_expr() / sp.Mul(*(s - root for root in data.draw(roots)))

    G = sp.Matrix(rows, columns, entry).applyfunc(sp.cancel)
    result = ask(TASK, matrix(G))
    assert result.status is Status.VERIFIED
    found = result.answers["diagonal"]
    assert [sp.cancel(a - b) for a, b in zip(found, by_minors(G), strict=True)] == [0] * len(found)


@pytest.mark.parametrize(("numerators", "denominator"), [each[:2] for each in KNOWN[:5]])
def test_corrupted_forms_are_rejected(numerators, denominator):
    plant = matrix((sp.Matrix(numerators) / denominator).applyfunc(sp.cancel))
    diagonal = ask(TASK, plant).answers["diagonal"]
    for i, entry in enumerate(diagonal):
        for wrong in (
            (2 * entry, entry / (s + 1), entry * (s + 9), entry * (s + 5) / (s + 6)) if entry != 0 else (1 / s,)
        ):
            assert rejected(TASK, plant, {"diagonal": [*diagonal[:i], wrong, *diagonal[i + 1 :]]})
    if len(set(diagonal)) > 1:
        assert rejected(TASK, plant, {"diagonal": diagonal[::-1]})


PROBLEM = """
system: {transfer_matrix: [["(s + 2)/(s + 1)", 0], [0, "(s + 1)/(s + 2)"]]}
find: {a: smith_mcmillan_form}
"""


@pytest.mark.parametrize(
    ("value", "right", "says"),
    [
        ("[1/((s+1)(s+2)), (s+1)(s+2)]", True, ""),
        ("[1/(s^2 + 3s + 2), s^2 + 3s + 2]", True, ""),
        ("[1, (s+1)^2(s+2)^2]", False, "common denominator is forgotten"),
        ("[(s+1)(s+2), 1/((s+1)(s+2))]", False, "order is reversed"),
        ("[1, 1]", False, "do not cancel"),
        ("[2/((s+1)(s+2)), (s+1)(s+2)]", False, "not monic"),
        ("[(s+2)/(s+1), (s+1)/(s+2)]", False, "must divide item 2"),
    ],
)
def test_marking(value, right, says):
    found = verdict(PROBLEM, "a", "diagonal", f'"{value}"')
    assert (found.verdict.value == "correct") is right, found.reason
    assert says in str(found.reason)


def test_in_discrete_time_the_form_is_in_z():
    G = matrix([[1 / z, 1 / (z - 1)], [0, 1 / z]], x=z)
    result = ask(TASK, G)
    assert result.status is Status.VERIFIED
    assert result.answers["diagonal"] == [1 / (z**2 * (z - 1)), z - 1] or sp.cancel(
        result.answers["diagonal"][0] * z * (z - 1)
    )
