"""Smith's form: textbook values, sympy's, the operations, divisibility, parameters, corruptions, marking, faults."""

from __future__ import annotations

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy.matrices.normalforms import smith_normal_form

from solver.derivation import Status
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import PolynomialMatrix
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict

TASK = "smith_form"
s, a, b = sp.symbols("s a b")


def matrix(rows):
    return PolynomialMatrix(sp.ImmutableMatrix(rows).applyfunc(sp.expand), s)


KNOWN = [
    ([[s, 1], [s**2, s + 1]], [1, s]),
    ([[s * (s + 1), 0], [0, s * (s + 2)]], [s, s * (s + 1) * (s + 2)]),
    # Kailath, Linear Systems, §6.3.3; Gantmacher I, VI §2
    ([[s**2, 0], [0, s**2 - 1]], [1, s**2 * (s**2 - 1)]),
    ([[s + 1, s**2 + 3, 1], [s, s + 3, 2 * s]], [1, 1]),
    ([[s], [s**2 + s]], [s]),
    ([[0, 0], [0, 0]], [0, 0]),
    ([[0, 0, 0], [0, 0, 0], [0, 0, 0]], [0, 0, 0]),
    ([[s, s], [s, s]], [s, 0]),
    ([[2, 0], [0, 3]], [1, 1]),
    ([[s**2 + s, s**2, s], [s + 1, s, 1], [s**2 - 1, s**2 - s, s - 1]], [1, 0, 0]),
    ([[s + sp.sqrt(2), 0], [0, s**2 - 2]], [s + sp.sqrt(2), s**2 - 2]),
    ([[s + a, b], [b, s + a]], [1, (s + a) ** 2 - b**2]),
    ([[s - 1, 1, 0], [0, s - 1, 0], [0, 0, s - 1]], [1, s - 1, (s - 1) ** 2]),
]


@pytest.mark.parametrize(("rows", "factors"), KNOWN)
def test_known_forms(rows, factors):
    plant = matrix(rows)
    result = ask(TASK, plant)
    assert result.status is Status.VERIFIED
    found = result.answers["invariant_factors"]
    assert [sp.expand(each - factor) for each, factor in zip(found, factors, strict=True)] == [0] * len(factors)
    form = result.answers["form"]
    assert form.shape == plant.matrix.shape
    assert [form[i, i] for i in range(len(found))] == found
    assert not rejected(TASK, plant, dict(result.answers))


def test_the_operations_lead_from_the_matrix_to_the_form():
    plant = matrix([[s * (s + 1), 0], [0, s * (s + 2)]])
    result = ask(TASK, plant)
    assert [step.kind for step in result.steps] == ["sought", "pivot", "pivot", "factors", "unimodular"]
    stages = [each.stage for step in result.steps if step.kind == "pivot" for each in step.values["stages"]]
    assert [stage.kind for stage in stages] == ["divisibility", "columns", "pivot", "columns", "rows", "monic"]
    M = plant.matrix
    for stage in stages:
        assert stage.before == M
        M = sp.ImmutableMatrix((stage.left * M * stage.right).applyfunc(sp.expand))
        assert stage.after == M
    last = result.steps[-1].values
    assert (last["U"] * plant.matrix * last["V"] - M).applyfunc(sp.expand).is_zero_matrix
    assert not last["U"].det().has(s) and not last["V"].det().has(s)  # noqa: PT018


def test_where_operations_grow_long_the_minors_are_taken():
    rows = [[3 * s**4 + 7 * s - 2, 5 * s**3 + s**2 - 4], [2 * s**4 - 3 * s**2 + 9, 7 * s**4 + 8 * s + 1]]
    plant = matrix([[*rows[0], s**3 + 11], [*rows[1], 6 * s**2 - 5], [s**4 + 13, 2 * s**4 + 3, 9 * s**3 + s]])
    result = ask(TASK, plant)
    assert result.status is Status.VERIFIED
    assert [step.kind for step in result.steps] == ["sought", "minors", "minors", "minors", "quotients", "factors"]
    det = sp.Poly(plant.matrix.det(), s).monic().as_expr()
    assert [sp.expand(e) for e in result.answers["invariant_factors"]] == [1, 1, sp.expand(det)]


entries = st.lists(st.integers(-2, 2), min_size=1, max_size=3)


@settings(max_examples=40)
@given(st.integers(1, 3), st.integers(1, 3), st.data())
def test_the_form_is_sympys(rows, columns, data):
    M = sp.Matrix(rows, columns, lambda i, j: sp.Poly(data.draw(entries), s).as_expr())
    result = ask(TASK, matrix(M))
    assert result.status is Status.VERIFIED
    theirs = smith_normal_form(M, domain=sp.QQ[s])
    expected = [theirs[i, i] for i in range(min(M.shape))]
    expected = [sp.Poly(each, s).monic().as_expr() if each != 0 else each for each in expected]
    assert [sp.expand(each) for each in result.answers["invariant_factors"]] == [sp.expand(e) for e in expected]


@pytest.mark.parametrize("rows", [rows for rows, _ in KNOWN])
def test_corrupted_factors_are_rejected(rows):
    plant = matrix(rows)
    factors = ask(TASK, plant).answers["invariant_factors"]
    for i, e in enumerate(factors):
        for wrong in (2 * e, e + 1, e * (s + 7), e + s**9) if e != 0 else (sp.S.One, s):
            assert rejected(TASK, plant, {"invariant_factors": [*factors[:i], wrong, *factors[i + 1 :]]})
    if len(set(factors)) > 1:
        assert rejected(TASK, plant, {"invariant_factors": factors[::-1]})
    assert rejected(TASK, plant, {"invariant_factors": [*factors, sp.S.Zero]})


def test_entries_beside_the_diagonal_are_rejected():
    plant = matrix([[s, 1], [s**2, s + 1]])
    form = ask(TASK, plant).answers["form"]
    assert rejected(TASK, plant, {"form": form + sp.ImmutableMatrix([[0, 1], [0, 0]])})
    assert rejected(TASK, plant, {"form": form.row_join(sp.ImmutableMatrix([0, 0]))})


@pytest.mark.parametrize(
    ("rows", "where"),
    [
        ([[s + a, b], [b, s + a]], [b]),
        ([[a, 0], [0, s]], [a]),
        ([[s + a, s + 1], [0, 0]], [a - 1]),
        ([[a**2 + 1, 0], [0, s]], []),
        ([[s, a], [0, s]], [a]),
        ([[1, a], [0, s]], []),
    ],
)
def test_parameters_with_which_the_form_is_another_are_named(rows, where):
    symbols = {x: sp.Symbol(x.name, real=True) for x in (a, b)}
    result = ask(TASK, matrix(sp.Matrix(rows).xreplace(symbols)))
    factors = next(step for step in result.steps if step.kind == "factors")
    assert [sp.expand(each) for each in factors.values["exceptions"]] in (
        [sp.expand(each.xreplace(symbols)) for each in where],
        [sp.expand(-each.xreplace(symbols)) for each in where],
    )


PROBLEM = "system: {polynomial_matrix: [[s(s + 1), 0], [0, s(s + 2)]]}\nfind: {a: smith_form}\n"


@pytest.mark.parametrize(
    ("value", "right", "says"),
    [
        ("[s, s(s+1)(s+2)]", True, ""),
        ("[s, s^3 + 3s^2 + 2s]", True, ""),
        ("[s(s+1), s(s+2)]", False, "do not divide each other"),
        ("[s(s+1)(s+2), s]", False, "order is reversed"),
        ("[s, s^2(s+1)(s+2)]", False, "divided by the one before it"),
        ("[s, s]", False, "larger minors"),
        ("[2s, s(s+1)(s+2)]", False, "not monic"),
        ("[s + 1, s(s+2)]", False, "must divide item 2"),
    ],
)
def test_marking(value, right, says):
    found = verdict(PROBLEM, "a", "invariant_factors", f'"{value}"')
    assert (found.verdict.value == "correct") is right, found.reason
    assert says in str(found.reason)


@pytest.mark.parametrize(
    ("system", "line", "column", "message"),
    [
        ("{polynomial_matrix: [[s, 1], [s]]}", 1, 38, "this row has 1 entry, row 1 has 2"),
        ("{polynomial_matrix: [[s, 1/s], [s, 1]]}", 1, 34, "a polynomial is expected here, not a quotient"),
        ("{polynomial_matrix: [[s, exp(-s)], [s, 1]]}", 1, 34, "without a dead time"),
        ("{polynomial_matrix: [[s, z], [s, 1]]}", 1, 34, "written in s"),
        ("{A: [[1]]}", 2, 11, "smith_form needs a matrix of polynomials"),
    ],
)
def test_faults_stand_at_their_places(system, line, column, message):
    with pytest.raises(InputError) as failed:
        read_problem(Source("file.yaml", f"system: {system}\nfind: {{a: smith_form}}\n"), catalogue())
    diagnostic = failed.value.diagnostics[0]
    assert message in diagnostic.message
    assert (diagnostic.line, diagnostic.column) == (line, column)


def test_in_discrete_time_the_polynomials_are_in_z():
    text = "system: {time: discrete, polynomial_matrix: [[z, 1], [z^2, z + 1]]}\nfind: {a: smith_form}\n"
    part = read_problem(Source("file.yaml", text), catalogue()).parts[0]
    assert ask(TASK, part.system).answers["invariant_factors"] == [1, sp.Symbol("z")]
