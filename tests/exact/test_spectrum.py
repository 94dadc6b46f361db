"""Eigenvalues against mpmath and known spectra; their kinds, order, precision and exceptions."""

import mpmath
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver import exact
from solver.exact.linear_algebra.fields import in_powers
from solver.exact.linear_algebra.spectrum import irreducible_factors
from tests.helpers.exact_cases import COMPLEX, DECIMAL, NUMERIC, RATIONAL, SURD, companion, each, theta, x

p, q = sp.symbols("p q", real=True)
c, m, stiffness = sp.symbols("c m stiffness", positive=True)
j, sqrt = sp.I, sp.sqrt

SPECTRA = [
    (companion((x + 1) * (x + 2) * (x + 3)), [-3, -2, -1]),
    (companion(x**2 * (x - 1)), [0, 0, 1]),
    (companion((x + 40) ** 2 * (x - 25) * (x + 120)), [-120, -40, -40, 25]),
    (companion(x * (x - 12) * (x**2 + 1) * (x + sp.S.Half)), [-sp.S.Half, 0, 12, j, -j]),
    (companion(x**2 - 4 * x + 1), [2 - sqrt(3), 2 + sqrt(3)]),
    (companion(x**2 + 2 * x + 5), [-1 + 2 * j, -1 - 2 * j]),
    (companion(x**2 + x + 1), [-sp.S.Half + sqrt(3) * j / 2, -sp.S.Half - sqrt(3) * j / 2]),
    (companion((x**2 + 4) ** 2), [2 * j, 2 * j, -2 * j, -2 * j]),
    (companion(x**2 - sp.Rational(1, 2)), [-sqrt(2) / 2, sqrt(2) / 2]),
    (companion((x**2 + 1) * (x - 1)), [1, j, -j]),
    (companion((x**2 - 12) * (x + 9)), [-9, -2 * sqrt(3), 2 * sqrt(3)]),
    (sp.ImmutableMatrix([[0, sqrt(2)], [sqrt(2), 1]]), [-1, 2]),
    (sp.ImmutableMatrix([[sqrt(2), 1], [0, sqrt(3)]]), [sqrt(2), sqrt(3)]),
    (sp.ImmutableMatrix([[sp.cos(theta), sp.sin(theta)], [-sp.sin(theta), sp.cos(theta)]]), None),
]


@pytest.mark.parametrize(("A", "expected"), [case for case in SPECTRA if case[1]])
def test_known_spectra_in_their_order(A, expected):
    assert [sp.expand(found - value) for found, value in zip(exact.spectrum(A).eigenvalues, expected, strict=True)] == [
        0
    ] * A.rows


def roots_in_numbers(polynomial, point):
    coefficients = sp.Poly(polynomial.subs(point), x).all_coeffs()
    return mpmath.polyroots([mpmath.mpmathify(c) for c in coefficients], maxsteps=200, extraprec=200)


def near(found, wanted):
    return len(found) == len(wanted) and all(min(abs(z - w) for w in wanted) < 1e-10 for z in found)


@given(st.integers(-12, 12), st.integers(-12, 12).filter(bool))
def test_roots_of_even_polynomials_of_degree_four_are_exact_where_no_root_is_nested(b, c):
    spectrum = exact.spectrum(companion(x**4 + b * x**2 + c))
    found = [mpmath.mpmathify(sp.N(value, 20)) for value in spectrum.eigenvalues]
    assert near(found, roots_in_numbers(x**4 + b * x**2 + c, {}))
    exact_roots = not any(root.kind == "decimal" for root in spectrum.roots)
    assert exact_roots is (any(sp.sqrt(each).is_Integer for each in (c, b * b - 4 * c)) or (b == 0 and c < 0))
    for root in spectrum.roots:
        nested = [each for each in root.value.atoms(sp.Pow) if each.base.has(sp.Pow)]
        assert root.kind == "decimal" or not nested


MASSES = [(sp.Rational(3), sp.Integer(1)), (sp.Integer(4), sp.Integer(2)), (sp.Integer(5), sp.Integer(3))]


@pytest.mark.parametrize(("middle", "last"), MASSES)
def test_two_masses_have_the_frequencies_of_one_times_numbers(middle, last):
    q = stiffness / m
    chi = x**4 + middle * q * x**2 + last * q**2
    point = {stiffness: sp.Rational(7, 3), m: sp.Rational(5, 2)}
    found = [mpmath.mpmathify(sp.N(value.subs(point), 20)) for value in exact.spectrum(companion(chi)).eigenvalues]
    assert near(found, roots_in_numbers(chi, point))


def test_the_roots_of_two_masses_are_written_with_the_golden_ratio():
    upper = [root.value for root in exact.spectrum(companion(x**4 + 3 * x**2 + 1)).roots][::2]
    assert upper == [j * (sqrt(5) / 2 - sp.S.Half), j * (sqrt(5) / 2 + sp.S.Half)]
    half = sqrt(2) / 2
    found = exact.spectrum(companion(x**4 + m**4)).eigenvalues
    assert [sp.expand(value / m) for value in found] == [
        -half + half * j,
        -half - half * j,
        half + half * j,
        half - half * j,
    ]


def test_what_parameters_leave_undecided_has_no_roots_here():
    with pytest.raises(exact.NotExact):
        exact.spectrum(companion(x**4 + 3 * p * x**2 + p**2))
    with pytest.raises(exact.NotExact):
        exact.spectrum(companion(x**4 + (m + stiffness) * x**2 + m))


@given(st.lists(st.fractions(max_denominator=30) | st.integers(-300, 300), min_size=1, max_size=8))
def test_a_polynomial_is_written_as_sympy_itself_writes_it(coefficients):
    numbers = [sp.Rational(c.numerator, c.denominator) for c in coefficients]
    expected = sum(c * x ** (len(numbers) - 1 - i) for i, c in enumerate(numbers))
    assert in_powers([sp.QQ(int(c.p), int(c.q)) for c in numbers], sp.QQ, x) == expected


@given(st.lists(st.integers(-130, 130), min_size=1, max_size=5), st.sampled_from([1, x**2 + 1, x**2 - 2, 3 * x - 1]))
def test_irreducible_factors_are_those_of_sympy(roots, other):
    chi = sp.Poly(sp.prod([x - root for root in roots]) * other, x).monic()
    found = irreducible_factors(companion(chi.as_expr()))
    expected = [(p.monic(), m) for p, m in chi.factor_list()[1]]
    assert sorted(((p.all_coeffs(), m) for p, m in found), key=str) == sorted(
        ((p.all_coeffs(), m) for p, m in expected), key=str
    )


@pytest.mark.parametrize("A", **each(NUMERIC))
def test_multiplicities_add_up_to_the_order(A):
    found = exact.spectrum(A)
    assert sum(root.multiplicity for root in found.roots) == A.rows == len(found.eigenvalues)
    assert sum(factor.degree * factor.multiplicity for factor in found.factors) == A.rows


@pytest.mark.parametrize("A", **each(NUMERIC))
def test_roots_make_the_determinant_vanish(A):
    for root in exact.spectrum(A).roots:
        with mpmath.workdps(40):
            value = (root.value * sp.eye(A.rows) - A).evalf(40).det(method="berkowitz")
            assert abs(sp.N(value, 20)) < 1e-25


@pytest.mark.parametrize("A", **each(NUMERIC))
def test_the_product_of_the_factors_is_the_characteristic_polynomial(A):
    product = sp.prod([factor.polynomial(x) ** factor.multiplicity for factor in exact.spectrum(A).factors])
    assert sp.expand(product - (x * sp.eye(A.rows) - A).det(method="berkowitz")) == 0


@pytest.mark.parametrize(
    ("cases", "kinds"),
    [
        (RATIONAL, {"rational"}),
        (COMPLEX, {"rational", "complex"}),
        (SURD, {"rational", "surd"}),
        (DECIMAL, {"rational", "decimal"}),
    ],
)
def test_the_kinds_of_roots(cases, kinds):
    found = {root.kind for A in cases.values() for root in exact.spectrum(A).roots}
    assert found <= kinds
    assert kinds - {"rational"} <= found


@pytest.mark.parametrize("A", **each(DECIMAL))
def test_decimal_roots_carry_thirty_digits_and_pairs_are_exactly_conjugate(A):
    decimals = [root for root in exact.spectrum(A).roots if root.kind == "decimal"]
    for root in decimals:
        precise = [part for part in (root.sigma, root.shift) if part != 0]
        assert all(isinstance(part, sp.Float) and part._prec >= 99 for part in precise)
    pairs = [root.value for root in decimals if root.shift != 0]
    assert [value.conjugate() for value in pairs[::2]] == pairs[1::2]
    assert all(sp.im(value) > 0 for value in pairs[::2])


def test_decimal_roots_are_those_of_mpmath():
    with mpmath.workdps(40):
        expected = mpmath.polyroots([1, 0, 1, 1], maxsteps=200, extraprec=100)
        real = next(z.real for z in expected if z.imag == 0)
        assert abs(mpmath.mpf(str(exact.spectrum(DECIMAL["a cubic"]).roots[0].value)) - real) < mpmath.mpf(10) ** -28


def test_roots_close_together_stay_apart():
    apart = sp.Rational(1, 10**8)
    A = companion(sp.expand((x - 1) * (x**3 - 3 * x**2 + 3 * x - 1 - apart**3 * 2)))  # 1 and 1 + ∛2 · 10⁻⁸ (and a pair)
    reals = [root.value for root in exact.spectrum(A).roots if root.shift == 0]
    assert len(reals) == 2
    assert abs((reals[1] - reals[0]) / apart - sp.cbrt(2)) < 1e-12


def test_a_rotation_has_the_eigenvalues_of_its_angle():
    A = SPECTRA[-1][0]
    assert exact.spectrum(A).eigenvalues == [sp.cos(theta) + j * sp.sin(theta), sp.cos(theta) - j * sp.sin(theta)]


def test_a_rotation_names_the_angles_at_which_it_has_one_eigenvalue():
    assert exact.spectrum(SPECTRA[-1][0]).exceptions == (sp.Eq(sp.sin(theta), 0),)


def test_a_discriminant_known_to_be_negative_gives_a_pair():
    A = sp.ImmutableMatrix([[0, 1], [-stiffness / m, 0]])
    roots = exact.spectrum(A).roots
    assert [root.kind for root in roots] == ["complex", "complex"]
    assert sp.expand(roots[0].shift - sqrt(stiffness / m)) == 0


def test_a_discriminant_known_to_be_positive_gives_real_roots():
    roots = exact.spectrum(sp.ImmutableMatrix([[0, 1], [c, p]])).roots
    assert [root.kind for root in roots] == ["surd", "surd"]


def test_an_undecided_discriminant_is_kept_and_its_zero_is_an_exception():
    A = sp.ImmutableMatrix([[0, 1], [-stiffness / m, -c / m]])
    found = exact.spectrum(A)
    assert {root.kind for root in found.roots} == {"symbolic"}
    (exception,) = found.exceptions
    assert sp.expand(exception.lhs - exception.rhs - (c**2 - 4 * m * stiffness)) in (
        0,
        sp.expand(-2 * (c**2 - 4 * m * stiffness)),
    )


def test_parameters_that_may_meet_are_an_exception():
    exceptions = exact.spectrum(sp.ImmutableMatrix([[p, 1], [0, q]])).exceptions
    assert len(exceptions) == 1
    assert sp.expand(exceptions[0].lhs) in (p - q, q - p)


def test_parameters_known_to_differ_from_the_other_root_are_no_exception():
    assert exact.spectrum(sp.ImmutableMatrix([[c, 1], [0, 0]])).exceptions == ()
    assert exact.spectrum(sp.ImmutableMatrix([[-c, 1], [0, m]])).exceptions == ()


def test_numbers_have_no_exceptions():
    assert all(exact.spectrum(A).exceptions == () for A in NUMERIC.values())


def test_a_cubic_with_a_parameter_is_refused():
    with pytest.raises(exact.NotExact, match="degree 3"):
        exact.spectrum(companion(x**3 + p * x + 1))


@pytest.mark.parametrize("entry", [sp.Float("0.5"), sp.Float(2)])
def test_decimal_approximations_are_refused(entry):
    with pytest.raises(exact.NotExact):
        exact.spectrum(sp.ImmutableMatrix([[entry, 1], [0, 1]]))


def test_a_radicand_that_is_a_product_of_sums_is_shown_multiplied_out_where_that_is_shorter():
    xi, omega = sp.symbols("xi omega", positive=True)
    found = exact.spectrum(sp.ImmutableMatrix([[0, 1], [-(omega**2), -2 * xi * omega]]))
    assert [root.value for root in found.roots] == [
        -omega * xi - omega * sp.sqrt(xi**2 - 1),
        -omega * xi + omega * sp.sqrt(xi**2 - 1),
    ]
