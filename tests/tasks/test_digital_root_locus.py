"""Root loci in the z-plane: textbook values, numpy's roots on fine gains, corruptions, marking."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from solver import exact
from solver.derivation import Status
from solver.derivation.conversion import converted
from solver.engine import yield_into
from solver.systems import TransferFunction
from tests.helpers.asking import ask, rejected

z, K = sp.Symbol("z"), sp.Symbol("K", real=True)
R = sp.Rational


def loop(numerator, denominator, sample_time=None):
    N, D = sp.expand(numerator), sp.expand(denominator)
    matrix = sp.ImmutableMatrix([[sp.cancel(N / D)]])
    return TransferFunction(matrix, ((N,),), ((D,),), z, discrete=True, sample_time=sample_time)


def equation(system):
    """What the task works on."""
    return yield_into([], converted(system, ("characteristic_equation",)))


EXACT = loop(z + R(1, 2), (z - 1) * (z - R(1, 2)))


def test_a_locus_with_exact_crossings():
    result = ask("root_locus", EXACT)
    answers = result.answers
    assert result.status is Status.VERIFIED
    assert answers["real_axis_segments"] == [sp.Interval(-sp.oo, -R(1, 2)), sp.Interval(R(1, 2), 1)]
    assert answers["critical_gains"] == [1, 6]  # by Jury: 1 − (1/2 + K/2) > 0 and 1 + 3/2 − K + 1/2 + K/2 > 0
    assert answers["imaginary_axis_crossings"] == [
        R(1, 4) + sp.sqrt(15) * sp.I / 4,
        R(1, 4) - sp.sqrt(15) * sp.I / 4,
        -1,
    ]
    assert [step.kind for step in result.steps][-4:] == ["parts", "crossings", "ranges", "sketch"]
    (ranges,) = (step.values["ranges"] for step in result.steps if step.kind == "ranges")
    assert ranges == [(0, 1, 0, 0), (1, 6, 2, 0), (6, sp.oo, 1, 0)]


def test_ogatas_sampled_loop():
    """Ogata, Discrete-Time Control Systems, §4–3: G = 1/(s(s + 1)) behind a hold, T = 1 is stable for K < 2.3925."""
    system = loop(R(3679, 10000) * z + R(2642, 10000), (z - R(3679, 10000)) * (z - 1), sp.Integer(1))
    result = ask("root_locus", system)
    gains = [float(each) for each in result.answers["critical_gains"]]
    assert abs(gains[0] - 2.3925) < 2e-4
    (rows,) = (step.values["rows"] for step in result.steps if step.kind == "crossings")
    assert abs(float(rows[0]["omega"]) - np.arccos(float(sp.re(rows[0]["point"])))) < 1e-9


def test_branches_along_the_circle_are_no_crossings():
    result = ask("root_locus", loop(z, z**2 + 1))
    assert result.status is Status.VERIFIED
    assert result.answers["critical_gains"] == [2]
    (ranges,) = (step.values["ranges"] for step in result.steps if step.kind == "ranges")
    assert ranges == [(0, 2, 0, 2), (2, sp.oo, 1, 0)]


factors = st.sampled_from(
    [z, z - 1, z - R(1, 2), z + R(1, 2), z + 1, z - 2, z**2 - z + R(1, 2), z**2 + 1, z**2 + R(1, 4), z - R(9, 10)]
)
loops = st.tuples(
    st.lists(factors, max_size=2).map(sp.prod),
    st.lists(factors, min_size=1, max_size=3).map(sp.prod),
    st.sampled_from([1, R(1, 3), -1]),
).filter(lambda each: sp.degree(each[0], z) <= sp.degree(each[1], z) and not sp.cancel(each[1] / each[0]).is_number)


@settings(max_examples=30, deadline=None)
@given(loops)
def test_ranges_and_crossings_are_those_of_numpys_roots(found):
    numerator, denominator, lead = found
    N, D = sp.expand(lead * numerator), sp.expand(denominator)
    e = exact.locus_equation(N, D, z, discrete=True)
    assume(e.denominator.degree() > 0)
    p = sp.Poly(D + K * N, z)
    for each in exact.crossings(e):
        roots = np.roots([complex(c.subs(K, each.gain)) for c in p.all_coeffs()])
        assert np.min(np.abs(roots - complex(each.point))) < 1e-4
        assert abs(abs(complex(each.point)) - 1) < 1e-12
    for each in exact.stable_gains(e):
        low, high = float(each.low), float(each.high) if each.high != sp.oo else float(each.low) + 3
        for part in (0.17, 0.41, 0.83):
            roots = np.abs(np.roots([complex(c.subs(K, low + part * (high - low))) for c in p.all_coeffs()]))
            assert (sum(roots > 1 + 1e-5), sum(abs(roots - 1) < 1e-5)) == (each.outside, each.on)


@settings(max_examples=6, deadline=None)
@given(loops)
@example((sp.Integer(1), (z**2 - z + R(1, 2)) ** 3, sp.Integer(1)))  # near a multiple pole few digits of D are left
def test_generated_loci_are_verified(found):
    numerator, denominator, lead = found
    assume(exact.locus_equation(lead * numerator, denominator, z).denominator.degree() > 0)
    assert ask("root_locus", loop(lead * numerator, denominator)).status is Status.VERIFIED


RIGHT = {
    "imaginary_axis_crossings": [R(1, 4) + sp.sqrt(15) * sp.I / 4, -1, R(1, 4) - sp.sqrt(15) * sp.I / 4],
    "critical_gains": [sp.Integer(6), sp.Integer(1)],
}


@pytest.mark.parametrize("name", list(RIGHT))
def test_right_answers_in_another_order_are_accepted(name):
    assert not rejected("root_locus", equation(EXACT), {name: RIGHT[name]})


@pytest.mark.parametrize(
    ("name", "wrong"),
    [
        ("imaginary_axis_crossings", RIGHT["imaginary_axis_crossings"][:2]),
        ("imaginary_axis_crossings", [*RIGHT["imaginary_axis_crossings"], sp.Integer(1)]),
        ("imaginary_axis_crossings", [sp.I, -sp.I, sp.Integer(-1)]),
        ("critical_gains", [sp.Integer(1)]),
        ("critical_gains", [sp.Integer(1), sp.Integer(6), sp.Integer(0)]),
        ("critical_gains", [sp.Integer(1), R(13, 2)]),
    ],
)
def test_corrupted_answers_are_rejected(name, wrong):
    assert rejected("root_locus", equation(EXACT), {name: wrong})
