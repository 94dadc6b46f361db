"""Expressions in the notations of students: what they are read as, whether that is said, what is refused."""

import pytest
import sympy as sp

from solver.problem.source import Fault
from tests.helpers.reading import K, a, read

s, t, lamda = sp.symbols("s t lamda")
x1, x_dot, p11, p12, p22 = sp.symbols("x1 x_dot p11 p12 p22", real=True)
i = sp.I
step = sp.Heaviside
NAMED = step(t - 5) + x1 + x_dot + p11 + p12 + p22


@pytest.mark.parametrize(
    ("text", "value", "said"),
    [
        ("cos2t", sp.cos(2 * t), True),
        ("cos 2t", sp.cos(2 * t), True),
        ("cos 2t + 1", sp.cos(2 * t) + 1, True),
        ("sint", sp.sin(t), True),
        ("sin^2(t)", sp.sin(t) ** 2, True),
        ("Exp[-2 t] Sin[t]", sp.exp(-2 * t) * sp.sin(t), True),
        ("exp{-2t}", sp.exp(-2 * t), True),
        ("exp -t", sp.exp(-t), True),
        ("exp^(-2t)", sp.exp(-2 * t), True),
        ("e^-t", sp.exp(-t), False),
        ("e^-2t", sp.exp(-2 * t), False),
        ("'e^{-2t}'", sp.exp(-2 * t), True),
        ("te^(-t)", t * sp.exp(-t), True),
        ("e^(-2 t) (e^t - 1)", sp.exp(-2 * t) * (sp.exp(t) - 1), False),
        ("√3", sp.sqrt(3), True),
        ("√(a)", sp.sqrt(a), False),
        ("sqrt3/2", sp.sqrt(3) / 2, True),
        ("2√3 j", 2 * sp.sqrt(3) * i, True),
        ("ln 2", sp.log(2), True),
        ("arctan(2)", sp.atan(2), False),
        ("j2", 2 * i, True),
        ("1j", i, False),
        ("2*I", 2 * i, False),
        ("2i", 2 * i, False),
        ("−2·a×3", -6 * a, False),
        ("t² + ½", t**2 + sp.Rational(1, 2), True),
        ("u(t)", step(t), True),
        ("(t - 1)u(t - 1)", (t - 1) * step(t - 1), True),
        ("σ(t)", step(t), True),
        ("θ(t - 2)", step(t - 2), True),
        ("3*1(t)", 3 * step(t), True),
        ("δ(t)", sp.DiracDelta(t), False),
        ("x_1", x1, True),
        ("'x_{1}'", x1, True),
        ("x₁", x1, True),
        ("x'", x_dot, True),
        ("x1(t)", x1, True),
        ("p_12", p12, True),
        ("p21", p12, True),
        ("p_21 + p22", p12 + p22, True),
        ("2.", sp.Integer(2), True),
        ("1e-3", sp.Rational(1, 1000), False),
        ("20 %", sp.Rational(1, 5), True),
        ("≈ 2", sp.Integer(2), True),
        ("5.", sp.Integer(5), True),
        ("[5]", sp.Integer(5), False),
        (r"\frac{1}{2}e^{-t}", sp.exp(-t) / 2, False),
        (r"$\sqrt{3}\,\sin\left(2t\right)$", sp.sqrt(3) * sp.sin(2 * t), False),
        ("tf([1], [1 3 2])", 1 / (s**2 + 3 * s + 2), True),
        ("tf([1 0], [1, 3, 2])", s / (s**2 + 3 * s + 2), True),
        ("y(t) = 2t", 2 * t, True),
        ("1/s+1", 1 / s + 1, False),
        ("cos3t + 2sin3t", sp.cos(3 * t) + 2 * sp.sin(3 * t), True),
        ("1*np.exp(-2*t)*np.cos(3*t)", sp.exp(-2 * t) * sp.cos(3 * t), True),
        ("sin(3t + 30°)", sp.sin(3 * t + sp.pi / 6), True),
        ("t 3^(t-1)", t * 3 ** (t - 1), True),
        (r"\frac{1}{1}t3^{t-1}", t * 3 ** (t - 1), True),
        ("control.tf([2, 5], [1, 2])", (2 * s + 5) / (s + 2), True),
        ("Y(s)/U(s) = 1/s", 1 / s, True),
        ("y[k] = 2t", 2 * t, True),
        ("√2 t", sp.sqrt(2) * t, True),
        ("cos(5√3 t)", sp.cos(5 * sp.sqrt(3) * t), True),
        ("cos 5√3 t", sp.cos(5 * sp.sqrt(3) * t), True),
        ("2cos t √3", 2 * sp.sqrt(3) * sp.cos(t), True),
        ("a√(t+1)", a * sp.sqrt(t + 1), False),
        ("(1 + 2t) 0.5^t", (1 + 2 * t) * sp.Rational(1, 2) ** t, True),
    ],
)
def test_an_expression_is_read_and_what_it_does_not_say_is_said(text, value, said):
    found = read(text, NAMED)
    assert sp.expand(found.value - value) == 0
    assert found.others == ()
    assert found.respelt == said


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("1/2 e^(-t)", [sp.exp(-t) / 2, sp.exp(t) / 2]),
        ("1/2t", [t / 2, 1 / (2 * t)]),
        ("sin t/2", [sp.sin(t / 2), sp.sin(t) / 2]),
        ("e^-2 t", [sp.exp(-2 * t), sp.exp(-2) * t]),
        ("√2t", [sp.sqrt(2) * t, sp.sqrt(2 * t)]),
    ],
)
def test_what_has_two_readings_has_both(text, values):
    found = read(text, a)
    assert [found.value, *(other.value for other in found.others)] == values
    assert all(each.respelt for each in (found, *found.others))


def test_one_text_is_read_in_one_way_throughout():
    found = read("1/2 e^(-t) + 1/3 e^(-2t)", a)
    assert len(found.others) == 1
    assert found.value == sp.exp(-t) / 2 + sp.exp(-2 * t) / 3


@pytest.mark.parametrize(("text", "value"), [("two", 2), ("rank 1", 1), ("2 roots", 2), ("Three.", 3)])
def test_a_count_may_be_said_in_words(text, value):
    assert read(text, sp.Integer(5)).value == value


@pytest.mark.parametrize(
    "text",
    [
        "3 dB", "2 rad/s", "30 deg", "'1, 2'", "3 = 4", "1 + 2 = 4", "ss(1, 2, 3, 4)", "sin^-1(t)",
        "x = 1 = 2", r"\int t", r"\frac{1}", "__import__('os')", "t if t else 1", "'(lambda: 1)()'", "'1 ± 2'",
        "{1, 2}",
    ],
)  # fmt: skip
def test_what_is_no_value_of_this_kind_is_refused(text):
    with pytest.raises(Fault):
        read(text, a)


@pytest.mark.parametrize("name", ["u(t)", "j2", "te"])
def test_a_name_of_the_problem_is_never_read_as_something_else(name):
    own = sp.Symbol(name.removesuffix("(t)"), real=True)
    assert read(name, own).value == own


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("[1, 3, 2]", lamda**2 + 3 * lamda + 2),
        ("[1 3 2]", lamda**2 + 3 * lamda + 2),
        ("1, 3, 2", lamda**2 + 3 * lamda + 2),
        ("'np.array([1., 3., 2.])'", lamda**2 + 3 * lamda + 2),
        ("poly1d([1, 3, 2])", lamda**2 + 3 * lamda + 2),
        ("[1 -a 2]", lamda**2 - a * lamda + 2),
        ("s^2 + 3 s + 2", lamda**2 + 3 * lamda + 2),
        ("x^2 + 3x + 2", lamda**2 + 3 * lamda + 2),
        ("s^2 + 3s + 2 = 0", lamda**2 + 3 * lamda + 2),
        ("0 = λ² + a λ", lamda**2 + a * lamda),
        ("p(s) = s^2 + 2", lamda**2 + 2),
        ("Poly(x**2 + 3*x + 2, x, domain='ZZ')", lamda**2 + 3 * lamda + 2),
    ],
)
def test_a_polynomial_is_read_by_its_coefficients_in_any_variable_and_as_an_equation(text, value):
    found = read(text, lamda**2 + a * lamda + 5)
    assert (found.value, found.others, found.respelt) == (value, (), True)


def test_a_polynomial_in_latex_says_what_it_is():
    found = read(r"\lambda^{2}+3\lambda+2", lamda**2 + a * lamda + 5)
    assert (found.value, found.respelt) == (lamda**2 + 3 * lamda + 2, False)


@pytest.mark.parametrize("text", ["a^2 + 3a + 2", "7"])
def test_what_is_no_polynomial_in_one_unknown_name_stays_as_it_is(text):
    found = read(text, lamda**2 + a * lamda + 5)
    assert lamda not in found.value.free_symbols
    assert not found.respelt


@pytest.mark.parametrize("text", ["[13 -10.4]", "'[13 -10.4]'", "[1 2]", "'[1; 2]'", "[[1], [2]]", "(1, 2)"])
def test_two_values_are_never_one(text):
    with pytest.raises(Fault):
        read(text, a)


def test_decimals_keep_their_digits_in_every_notation():
    for text in (r"\frac{0.67}{2} a", "0.67 a/2", "'[0.67]'"):
        ((_, decimal),) = read(text, a).decimals.items()
        assert tuple(decimal) == (sp.Rational(67, 100), sp.Rational(1, 200), 2)
    ((symbol, decimal),) = read("16.3 %", a).decimals.items()
    assert tuple(decimal) == (sp.Rational(163, 1000), sp.Rational(1, 2000), 3)
    found = read("e^-2.5t", a)
    ((symbol, _),) = found.decimals.items()
    assert found.form == sp.exp(-symbol * t)


def test_an_answer_from_zero_on_may_be_written_with_the_step():
    found = read("e^-t u(t)", sp.exp(-t))
    assert (found.value, found.respelt) == (sp.exp(-t), True)
    assert read("e^-t u(t - 1)", sp.exp(-t)).value == sp.exp(-t) * step(t - 1)
    assert read("e^-t u(t)", sp.exp(-t) * step(t - 1)).value == sp.exp(-t) * step(t)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("2e⁻ᵗ", 2 * sp.exp(-t)), ("e⁻²ᵗ", sp.exp(-2 * t)), ("e⁻⁰·⁵ᵗ", sp.exp(-t / 2)), ("2ℯ^(-t)", 2 * sp.exp(-t)),
        ("'%e^(-t)'", sp.exp(-t)), ("'%pi/2'", sp.pi / 2), ("2½", sp.Rational(5, 2)),
        ("Rational(5, 4)", sp.Rational(5, 4)),
        ("Re((1-2j)e^(jt))", sp.cos(t) + 2 * sp.sin(t)), ("im(exp(j*a*t))", sp.sin(a * t)), ("0,5", sp.Rational(1, 2)),
        ("simplify(e^(-t))", sp.exp(-t)), ("{1 \\over 2}", sp.Rational(1, 2)), ("-1 ≠ 0", -1),
    ],
)  # fmt: skip
def test_signs_and_calls_of_other_programs(text, value):
    gap = (read(text, a).value - value).subs({t: sp.Rational(7, 10), a: 2})
    assert abs(complex(gap)) < 1e-12


@pytest.mark.parametrize(
    "text",
    ["poly([-1 -2])", "poly2sym([1 3 2])", "p² + 3p + 2", "s2 + 3s + 2"],
)
def test_a_polynomial_as_a_call_or_in_another_letter(text):
    assert sp.expand(read(text, s**2 + 1).value) == s**2 + 3 * s + 2


@pytest.mark.parametrize(
    "text",
    [
        "1/(p²+3p+2)", "TransferFunctionModel[{{{1}}, 2+3 s+s^2}, s]", "tf(1, conv([1 1],[1 2]))",
        "1/poly2sym([1 3 2])", "'num = 1, den = s^2+3s+2'", "Y/U = 1/(s^2+3s+2)",
    ],
)  # fmt: skip
def test_a_transfer_function_as_other_programs_write_it(text):
    assert sp.cancel(read(text, 1 / s).value - 1 / (s**2 + 3 * s + 2)) == 0


@pytest.mark.parametrize(
    "text",
    [
        "'|K-24|<24'", "abs(K-24)<24", "Interval.open(0, 48)", "K positive and less than 48", "0 to 48 (exclusive)",
        "'{K | 0 < K < 48}'", "solve({K > 0, K < 48})", "K elem (0,48)", "K in (0,48)", "(0,24) ∪ [24,48)", "']0;48['",
        "RealRange(Open(0), Open(48))", "stable for 0 < K < 48", "K between 0 and 48 (exclusive)", "0 < k < 48",
    ],
)  # fmt: skip
def test_a_condition_in_words_and_as_a_set(text):
    found = read(text, sp.And(K > 0, K < 6)).value
    assert [bool(found.subs(K, value)) for value in (-1, 0, 1, 24, 47, 48, 49)] == [
        False,
        False,
        True,
        True,
        True,
        False,
        False,
    ]


@pytest.mark.parametrize("text", ["0 to 48", "K ∉ (0, 48)", "unstable for K > 0"])
def test_a_condition_of_which_the_ends_or_the_sense_are_unclear_is_not_read(text):
    with pytest.raises(Fault):
        read(text, sp.And(K > 0, K < 6))


@pytest.mark.parametrize("text", ["K between 0 and 48", "between 0 and 48", "from 0 to 48", "K zwischen 0 und 48"])
def test_bounds_of_which_the_ends_are_unclear_have_two_readings(text):
    found = read(text, sp.And(K > 0, K < 6))
    assert [bool(each.value.subs(K, 0)) for each in (found, *found.others)] == [False, True]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("coth 1", sp.coth(1)),
        ("20 log10(3)", 20 * sp.log(3, 10)),
        ("20 lg 3", 20 * sp.log(3, 10)),
        ("sech(2)", sp.sech(2)),
    ],
)
def test_functions_that_are_known_by_others(text, value):
    assert abs(sp.N(read(text, sp.Integer(5)).value - value)) < 1e-12
