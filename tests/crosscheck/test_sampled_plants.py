"""Discrete plants against python-control's `sample_system`, by every method that both have."""

import control
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from tests.helpers.asking import ask
from tests.helpers.comparing import systems_tried
from tests.helpers.fractions_of_polynomials import plant, s

z = sp.Symbol("z")
METHODS = {
    "zero_order_hold": "zoh",
    "forward_euler": "euler",
    "backward_euler": "backward_diff",
    "tustin": "bilinear",
    "matched": "matched",
}
FACTORS = st.one_of(
    st.integers(0, 5).map(lambda a: s + a),
    st.tuples(st.integers(1, 3), st.integers(1, 4)).map(lambda p: (s + p[0]) ** 2 + p[1] ** 2),
)


def coefficients(p):
    return [float(c) for c in sp.Poly(p, s).all_coeffs()]


@pytest.mark.parametrize("method", METHODS)
@systems_tried(10)
@given(st.lists(FACTORS, min_size=1, max_size=2), st.integers(-4, 5), st.sampled_from([2, 5, 10]))
def test_transfer_functions_are_those_of_python_control(method, factors, zero, parts):
    bottom = sp.expand(sp.Mul(*factors))
    top = s + zero if sp.degree(bottom, s) > 1 and zero else sp.Integer(2)
    if method == "matched" and bottom.subs(s, 0) == 0:
        return  # there python-control keeps another gain
    found = ask("discretization", plant(top, bottom), method, sample_time=sp.Rational(1, parts))
    assert found.status is Status.VERIFIED, found.reason
    theirs = control.sample_system(control.tf(coefficients(top), coefficients(bottom)), 1 / parts, METHODS[method])
    for point in (0.3 + 0.8j, -1.7 + 0.2j):
        ours, other = complex(found.answers["G"].subs(z, point)), complex(theirs(point))
        if method == "matched" and sp.degree(bottom, s) - sp.degree(top, s) > 1:
            at_one = complex(found.answers["G"].subs(z, 1)) / complex(theirs(1))
            assert at_one == pytest.approx(1, rel=1e-6)  # it leaves the zeros at infinity where they are
            continue
        assert ours == pytest.approx(other, rel=1e-5, abs=1e-9)
