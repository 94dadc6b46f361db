"""Transfer functions, poles, realizations against python-control, resolvents in floating point, and Hankel ranks."""

import control
import numpy as np
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Unsolved
from solver.systems import TransferFunction
from tests.helpers.comparing import (
    answers_of,
    arrays,
    as_matrix,
    characteristic,
    close,
    coefficients,
    floats,
    krylov,
    product,
    rank_modulo_a_prime,
    same,
    systems_tried,
)
from tests.helpers.strategies import plain_plants, plants, unimodular

POINTS = (0.7 + 1.3j, 3.1 + 0.4j, -0.35 + 2.9j, 5.3)
s = sp.Symbol("s")


def at(G, point, variable):
    return np.array(G.subs(variable, point).evalf(20).tolist(), dtype=complex)


def resolvent_at(A, B, C, D, point):
    return C @ np.linalg.solve(point * np.eye(len(A)) - A, B) + D


def hankel_rank(plant):
    """The order of a minimal realization: the rank of observability times controllability matrix, exact."""
    return rank_modulo_a_prime(product(krylov(plant.A.T, plant.C.T).T, krylov(plant.A, plant.B)))


def same_markov_parameters(one, other, count):
    left, right = sp.Matrix(one["B"]), sp.Matrix(other.B)
    for _ in range(count):
        if not same(product(one["C"], left), product(other.C, right)):
            return False
        left, right = product(one["A"], left), product(other.A, right)
    return same(one["D"], other.D)


@systems_tried(45)
@given(plants(discrete=None), st.sampled_from(["adjugate", "faddeev_leverrier"]))
def test_transfer_matrices_and_their_poles(made, method):
    plant = made.system
    variable = sp.Symbol("z" if plant.discrete else "s")
    answers = answers_of("transfer_function", plant, method)
    G, (A, B, C, D) = as_matrix(answers["G"]), arrays(plant)
    for point in POINTS:
        assert close(at(G, point, variable), resolvent_at(A, B, C, D, point), 1e-6)
    least = hankel_rank(plant)
    assert len(answers["poles"]) == least
    if G.shape == (1, 1):
        bottom = sp.Poly(sp.denom(sp.cancel(G[0])), variable)
        assert bottom.degree() == least
        assert bottom.monic().all_coeffs() == [sp.expand(c) for c in coefficients(answers["poles"])]
        whole = characteristic(plant.A)
        assert [sp.expand(c) for c in coefficients([*answers["poles"], *answers["cancelled"]])] == whole


@systems_tried(15)
@given(plain_plants(4, inputs=1, outputs=1))
def test_one_channel_against_control(plant):
    G = answers_of("transfer_function", plant)["G"]
    theirs = control.ss2tf(*arrays(plant))
    top, bottom = (sp.Poly(p, s) for p in sp.fraction(sp.cancel(G)))
    ours = control.tf([float(c) for c in top.all_coeffs()], [float(c) for c in bottom.all_coeffs()])
    for point in POINTS:
        assert close(ours(point), theirs(point), 1e-6)


@systems_tried(15)
@given(plants(4, inputs=2, outputs=2))
def test_zeros_are_where_the_system_matrix_falls_in_rank(made):
    plant = made.system
    m, p = plant.B.cols, plant.C.rows
    size = min(m, p)
    chosen = sp.ImmutableMatrix(plant.B[:, :size]), sp.ImmutableMatrix(plant.C[:size, :]), plant.D[:size, :size]
    square = type(plant)(plant.A, chosen[0], chosen[1], sp.ImmutableMatrix(chosen[2]))
    minimal = answers_of("minimal_realization", square)
    zeros = answers_of("transfer_function", square).get("zeros") or []
    A, B, C, D = (minimal[name] for name in "ABCD")
    n = A.rows
    pencil = sp.Matrix(sp.BlockMatrix([[A - s * sp.eye(n), B], [C, D]]).as_explicit()) if n else sp.Matrix(D)
    determinant = sp.Poly(pencil.det(method="berkowitz"), s)
    if determinant.is_zero:  # G is singular everywhere: its zeros are no determinant's
        return
    theirs = [complex(c) for c in determinant.monic().all_coeffs()]
    assert close([complex(c) for c in coefficients(zeros)], theirs, 1e-9)


@systems_tried(45)
@given(plants(discrete=None))
def test_minimal_realizations_have_the_order_of_the_hankel_rank(made):
    plant = made.system
    answers = answers_of("minimal_realization", plant)
    least = hankel_rank(plant)
    assert answers["A"].rows == least
    if not least:
        assert same(answers["D"], plant.D)
        return
    assert same_markov_parameters(answers, plant, 2 * plant.order)
    assert rank_modulo_a_prime(krylov(answers["A"], answers["B"])) == least
    assert rank_modulo_a_prime(krylov(answers["A"].T, answers["C"].T)) == least


@systems_tried(20)
@given(plants(4, inputs=1, outputs=1, through=False))
def test_control_reduces_to_the_same_order_where_it_can(made):
    plant = made.system
    least = answers_of("minimal_realization", plant)["A"].rows
    if not least:
        return
    top, bottom = np.ravel(control.ss2tf(*arrays(plant)).num[0][0]), control.ss2tf(*arrays(plant)).den[0][0]
    theirs = control.minreal(control.tf(np.where(np.abs(top) < 1e-9, 0, top), bottom), 1e-3, verbose=False)
    simple = all(block.size == 1 for block in made.blocks)
    if simple and len({(b.sigma, b.omega) for b in made.blocks}) == len(made.blocks):
        assert len(theirs.den[0][0]) - 1 == least


@systems_tried(60)
@given(plants(5, inputs=2, outputs=2), st.sampled_from(["controllable", "observable", "diagonal", "jordan", "modal"]))
def test_realizations_have_the_transfer_matrix_they_are_made_from(made, form):
    plant = made.system
    G = as_matrix(answers_of("transfer_function", plant)["G"])
    parts = [[sp.fraction(sp.cancel(entry)) for entry in row] for row in G.tolist()]
    given_G = TransferFunction(
        sp.ImmutableMatrix(G),
        tuple(tuple(sp.expand(top) for top, _ in row) for row in parts),
        tuple(tuple(sp.expand(bottom) for _, bottom in row) for row in parts),
        s,
    )
    convention = {"jordan": "superdiagonal"}.get(form, "last_row")
    try:
        answers = answers_of("realization", given_G, form=form, convention=convention)
    except Unsolved as refusal:
        simple = sp.Poly(sp.lcm_list([bottom for row in parts for _, bottom in row]), s).is_sqf
        assert not G.has(s) or (form in ("diagonal", "modal") and (not simple or "omplex" in str(refusal)))
        return
    A, B, C, D = (
        np.array(answers[name].evalf(25).tolist(), dtype=complex).reshape(answers[name].shape) for name in "ABCD"
    )
    for point in POINTS:
        assert close(resolvent_at(A, B, C, D, point), at(G, point, s), 1e-6)


@systems_tried(20)
@given(plants(discrete=None), st.data())
def test_other_coordinates_leave_the_transfer_matrix_and_the_spectrum(made, data):
    plant = made.system
    T = sp.ImmutableMatrix(data.draw(unimodular(plant.order)))
    answers = answers_of("similarity_transformation", plant, T=T)
    assert same(product(T, answers["A"]), product(plant.A, T))
    assert same_markov_parameters(answers, plant, plant.order)
    assert characteristic(answers["A"]) == characteristic(plant.A)


@systems_tried(20)
@given(plants(discrete=None), st.sampled_from(["determinant", "faddeev_leverrier"]))
def test_characteristic_polynomials(made, method):
    plant = made.system
    found = sp.Poly(answers_of("characteristic_polynomial", plant, method)["polynomial"], sp.Symbol("lamda"))
    assert found.all_coeffs() == characteristic(plant.A)
    roots = []
    for block in made.blocks:
        pair = [block.sigma + sp.I * block.omega, block.sigma - sp.I * block.omega]
        roots += (pair if block.omega else pair[:1]) * block.size
    assert [sp.expand(c) for c in coefficients(roots)] == found.all_coeffs()
    assert close([float(c) for c in found.all_coeffs()], np.poly(floats(plant.A)), 1e-6)
