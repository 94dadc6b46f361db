"""What the pages of the criterion of Routh and Hurwitz say in words, in every case that steers them."""

import pytest
import sympy as sp

from solver.systems import Polynomial
from tests.helpers.said import Family, cases_of, wrongly_said

s, K = sp.Symbol("s"), sp.Symbol("K", real=True)
POLYNOMIALS = {
    "stable": s**2 + 3 * s + 2,
    "first_order": s - 1,
    "two_right": s**3 - 2 * s**2 + 3 * s + 4,
    "zero_pivot": s**4 + s**3 + 2 * s**2 + 2 * s + 3,
    "zero_row": s**5 + 2 * s**4 + 24 * s**3 + 48 * s**2 - 25 * s - 50,
    "moved": (s**2 + 1) * (s**3 + s - 2),
    "on_axis": s**3 + 2 * s,
    "mirrored": (s**2 - 1) * (s + 2),
    "quartic": s**4 + 1,
    "double": (s**2 + 1) ** 2,
    "integrator": s,
    "negated": -(s**2) - 3 * s - 2,
    "lead_unknown": K * s**2 + s + 1,
    "range": s**3 + 3 * s**2 + K * s + 6,
    "always": s**2 + (K**2 + 1) * s + 1,
    "never": s**2 + K,
    "vanishing": s**4 + s**3 + 2 * s**2 + 2 * s + K - 1,
    "contradiction": s**2 + K * s - K,
}
SYMMETRIC = "zero_row moved on_axis mirrored quartic double integrator"
OF_BOTH = {
    "All signs are changed": "negated",
    "Nothing is known of the sign of the leading coefficient": "lead_unknown",
    "Roots that lie symmetrically to the origin": SYMMETRIC,
    "Of the 1 root of": "integrator",
    "Of the 2 roots of": "moved mirrored",
    "Of the 3 roots of": "on_axis",
    "Of the 4 roots of": "zero_row quartic double",
    "1 lies to the right, as many to the left": "zero_row mirrored",
    "2 lie to the right, as many to the left": "quartic",
    "to the left and none on the imaginary axis": "mirrored quartic",
    "to the left and 2 on the imaginary axis": "zero_row",
    "all lie on the imaginary axis": "moved on_axis double integrator",
    "Together with the other factor there is one root": "zero_row moved mirrored",
    "Together with the other factor there are 2 roots": "quartic",
    "Together with the other factor there are no roots": "on_axis double integrator",
    "No roots lie in the right half plane": "stable on_axis double integrator negated always",
    "1 root lies in the right half plane": "first_order zero_row moved mirrored",
    "2 roots lie in the right half plane": "two_right zero_pivot quartic",
    "plane, none on the imaginary axis": "stable first_order two_right zero_pivot mirrored quartic negated always",
    "plane, 1 on the imaginary axis": "integrator",
    "plane, 2 on the imaginary axis": "zero_row moved",
    "axis, none in the left half plane": "first_order on_axis double integrator",
    "axis, 1 in the left half plane": "two_right",
    "axis, 2 in the left half plane": "stable zero_pivot zero_row moved mirrored quartic negated always",
    "**asymptotically stable**": "stable negated always",
    "**not asymptotically stable**": f"first_order two_right zero_pivot {SYMMETRIC}",
    "if and only if": "lead_unknown range contradiction",
    "A zero stands where a positive number must stand": "never vanishing",
    "This holds for all values": "always",
    "These cannot hold together": "contradiction",
    "Together, without what the others imply": "lead_unknown range",
    "1 > 0": "",
}
OF_THE_ARRAY = {
    "A zero in the first column": "zero_pivot quartic moved vanishing",
    "(unless $K = 1$: then it is a row of zeros": "vanishing",
    r"(for a small $\epsilon > 0$": "zero_pivot quartic moved",
    "A row of zeros": "zero_row on_axis mirrored quartic double integrator never",
    "There are no changes of sign": "stable on_axis double integrator negated always",
    "There is one change of sign": "first_order zero_row mirrored",
    "There are 2 changes of sign": "two_right zero_pivot quartic",
    "There are 3 changes of sign": "moved",
    "this count cannot be trusted": "moved",
    "K - 2 > 0": "range",
}
OF_THE_DETERMINANTS = {
    "All determinants are positive": "stable negated always",
    "A determinant is zero": f"zero_pivot {SYMMETRIC}",
    "there is one change of sign": "first_order",
    "there are 2 changes of sign": "two_right",
    "18K - 36 > 0": "range",
}


def _systems():
    return {name: Polynomial(tuple(sp.Poly(p, s).all_coeffs()), s) for name, p in POLYNOMIALS.items()}


FAMILIES = {
    "array": Family("routh_hurwitz", "array", _systems(), OF_BOTH | OF_THE_ARRAY),
    "determinants": Family("routh_hurwitz", "hurwitz_determinants", _systems(), OF_BOTH | OF_THE_DETERMINANTS),
}


@pytest.mark.parametrize(**cases_of(FAMILIES))
def test_the_words_are_those_of_the_case(family, name):
    assert not wrongly_said(family, name)
