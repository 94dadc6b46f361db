"""Minors of matrices of fractions, Rosenbrock's matrix, directions of zeros: beside sympy's own determinants."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.multivariable.exceptions import parameter_exceptions
from solver.exact.multivariable.rational_minors import (
    rational_determinant,
    rational_minors,
    rational_zeros_of_entries,
)
from solver.exact.multivariable.rosenbrock import common_decoupling_polynomial, in_factors, system_matrix
from solver.exact.multivariable.zero_directions import null_directions, zero_directions
from solver.exact.representation.transfer import transfer_matrix, transfer_matrix_of_fractions
from tests.helpers.tried import tried

M = sp.ImmutableMatrix
s, a, b = sp.symbols("s a b")


def fractions(rows):
    """A transfer matrix from its entries."""
    pairs = [[sp.fraction(sp.together(sp.sympify(entry))) for entry in row] for row in rows]
    return transfer_matrix_of_fractions(*([[pair[k] for pair in row] for row in pairs] for k in (0, 1)), s)


@tried(10)
@given(st.data())
def test_minors_are_sympys_determinants_in_lowest_terms(data):
    p, m = data.draw(st.sampled_from([(2, 2), (2, 3), (3, 2), (3, 3)]))
    bottoms = st.sampled_from([s + 1, s + 2, (s + 1) * (s + 3)])
    tops = st.sampled_from([0, 1, s, s + 1, s - 2])
    rows = [[data.draw(tops) / data.draw(bottoms) / (s + 2) for _ in range(m)] for _ in range(p)]
    found = rational_minors(fractions(rows))
    for minor in (each for listed in found.orders for each in listed):
        expected = M(rows).extract(list(minor.rows), list(minor.columns)).det()
        assert sp.cancel(expected - minor.value) == 0
        assert minor.top.is_zero or minor.top.gcd(minor.bottom).degree() == 0
    if p == m:
        assert sp.cancel(rational_determinant(fractions(rows)) - M(rows).det()) == 0


def test_each_power_of_a_pole_is_one_of_a_minor():
    found = rational_minors(fractions([[1 / (s + 1), 2 / (s + 2)], [1 / (s + 2), 1 / (s + 1)]]))
    assert {(factor, power, minor.order) for factor, power, minor in found.pole_powers} == {
        (s + 1, 2, 2),
        (s + 2, 2, 2),
    }
    assert found.zero_polynomial.as_expr() == s**2 - 2


def test_too_many_minors_are_not_listed():
    with pytest.raises(NotExact):
        rational_minors(fractions((sp.eye(6) / (s + 1)).tolist()))


def test_rosenbrocks_determinant_is_that_of_both_factors():
    A, B, C, D = M([[0, 1], [-2, -3]]), M([[1, 0], [a, 1]]), M([[1, 1], [0, b]]), M([[0, 1], [0, 0]])
    found = system_matrix(A, B, C, D, s)
    G = transfer_matrix(A, B, C, D, s)
    expected = (s * sp.eye(2) - A).det() * G.matrix.det()
    assert sp.cancel(found.determinant.as_expr() - expected) == 0
    assert (found.rank, found.square) == (4, True)


def test_few_minors_decide_what_all_have_in_common():
    A, B, C = M([[0, 1, 0], [0, 0, 1], [-6, -11, -6]]), M([0, 1, -3]), M([[-3, 1, 0], [4, 0, 1]])
    found = system_matrix(A, B, C, M([0, 0]), s)
    assert (found.rank, found.count, len(found.deciding)) == (4, 5, 3)
    assert sp.gcd_list([minor.value.as_expr() for minor in found.deciding]) == 1
    for minor in found.deciding:
        square = found.matrix.extract(list(minor.rows), list(minor.columns))
        assert sp.expand(square.det() - minor.value.as_expr()) == 0
        assert sp.expand(minor.factored - minor.value.as_expr()) == 0


def test_a_matrix_of_rank_zero_has_no_minors_that_decide():
    found = system_matrix(M(0, 0, []), M(0, 1, []), M(1, 0, []), M([[0]]), s)
    assert (found.rank, found.square, found.deciding) == (0, False, ())
    assert found.zero_polynomial.as_expr() == 1


def test_what_is_hidden_from_both_sides():
    A = M.diag(-1, -2, -3)
    both = common_decoupling_polynomial(A, (s + 2) * (s + 3), s + 3, s + 1, s)
    assert sp.expand(both - (s + 3)) == 0


def test_directions_at_conjugate_and_at_irrational_zeros():
    for rows in (
        [[1 / (s + 1), 2 / (s + 2)], [1 / (s + 2), 1 / (s + 1)]],
        [[s / (s + 1), 1 / (s + 2)], [-5 / (s + 2), (s + 2) / (s + 1)]],
    ):
        G = fractions(rows)
        minors = rational_minors(G)
        found = zero_directions(G, minors.rank, minors.zero_polynomial, minors.pole_polynomial)
        assert len(found) == minors.zero_polynomial.degree()
        for each in found:
            there = M(rows).subs(s, each.root.value)
            assert max(abs(complex(entry)) for entry in (there * each.columns[0]).evalf(30)) < 1e-12
            assert max(abs(complex(entry)) for entry in (there - each.value).evalf(30)) < 1e-12


def test_there_are_no_directions_where_they_make_no_sense():
    shared = rational_minors(fractions([[(s + 2) / (s + 1), 0], [0, (s + 1) / (s + 2)]]))
    assert zero_directions(shared.G, 2, shared.zero_polynomial, shared.pole_polynomial) is None
    low = rational_minors(fractions([[(s - 1) / (s + 1), 2 * (s - 1) / (s + 1)]]))
    assert zero_directions(low.G, 1, low.zero_polynomial, low.pole_polynomial) is None
    one = [[sp.Poly(1, s, domain="QQ")]]
    assert null_directions([[sp.Poly(s - 1, s, domain="QQ")]], one, sp.Poly(s - 1, s, domain="QQ"))[0].columns == (
        M([1]),
    )


def test_parameters_that_change_something_are_named():
    minors = rational_minors(fractions([[1 / (s + 1), a / (s + 2)], [1 / (s + 2), 1 / (s + 1)]]))
    assert {condition.lhs - condition.rhs for condition in parameter_exceptions(minors)} <= {a - 1, 1 - a, a}
    assert any(condition.subs(a, 1) == sp.true for condition in parameter_exceptions(minors))
    row = rational_minors(fractions([[1 / (s + a), 1 / (s + b)]]))
    assert any(condition.subs(a, b) == sp.true for condition in parameter_exceptions(row))  # one pole instead of two
    apart = rational_minors(fractions([[1 / (s + a), 0], [0, 1 / (s + b)]]))
    assert parameter_exceptions(apart) == ()  # a double pole is nothing new


def test_rational_zeros_of_entries():
    found = rational_zeros_of_entries(fractions([[(s - 1) ** 2 / (s + 1) ** 2, (s**2 + 1) / (s + 1) ** 2]]))
    assert found == [(0, 0, 1)]


def test_a_polynomial_in_factors():
    assert in_factors(sp.Poly(2 * s**2 + 6 * s + 4, s, domain="QQ")) == sp.Mul(2, s + 1, s + 2)
