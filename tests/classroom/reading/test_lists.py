"""Lists, matrices and mappings in the notations of students and programs."""

import pytest
import sympy as sp

from solver.classroom.reading.choices import Choices
from solver.classroom.reading.expected import Expected
from solver.problem.source import Fault
from tests.helpers.reading import a, b, read

s, t = sp.symbols("s t")
x1, x2 = sp.symbols("x1 x2", real=True)
i, M, e = sp.I, sp.ImmutableMatrix, sp.exp
TWO, ROW, COLUMN, SQUARE = [a, b], M([[a, b]]), M([a, b]), M([[a, b], [a, b]])


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("[-3 ± j2]", [-3 + 2 * i, -3 - 2 * i]),
        ("-3 ± j2", [-3 + 2 * i, -3 - 2 * i]),
        ("-3 +- 2j", [-3 + 2 * i, -3 - 2 * i]),
        ("-3 +/- i√3", [-3 + sp.sqrt(3) * i, -3 - sp.sqrt(3) * i]),
        (r"-1 \pm 2j", [-1 + 2 * i, -1 - 2 * i]),
        ("-1, -2", [-1, -2]),
        ("'-1, -2'", [-1, -2]),
        ("-1; -2", [-1, -2]),
        ("-1 and -2", [-1, -2]),
        ("-1 -2", [-1, -2]),
        ("[-1 -2]", [-1, -2]),
        ("[-1; -2]", [-1, -2]),
        ("[[-1], [-2]]", [-1, -2]),
        ("{-1, -2}", [-1, -2]),
        ("{-1, -1}", [-1, -1]),
        ("(-1, -2)", [-1, -2]),
        ("'array([-1., -2.])'", [-1, -2]),
        ("diag(-1, -2)", [-1, -2]),
        ("'[-1 0; 0 -2]'", [-1, -2]),
        ("<-1, -2>", [-1, -2]),
        ("'{{s -> -1}, {s -> -2}}'", [-1, -2]),
        ("-(1, 2)", [-1, -2]),
        ("-1 / -2", [-1, -2]),
        ("-1 x 2", [-1, -1]),
        ("2 × -1", [-1, -1]),
        ("-1 et -2", [-1, -2]),
        ("'%i, -%i'", [i, -i]),
        ("2∠±90°", [2 * i, -2 * i]),
        ("[-1+2j -1-2j]", [-1 + 2 * i, -1 - 2 * i]),
        ("λ1 = -1; λ2 = -2", [-1, -2]),
        (r"'\lambda_1 = -1, \lambda_2 = -2'", [-1, -2]),
        ("[λ_2 = -2, λ_1 = -1]", [-1, -2]),
        ("{λ_1: -1, λ_2: -2}", [-1, -2]),
        ("'s_{1,2} = -3 ± 2j'", [-3 + 2 * i, -3 - 2 * i]),
        ("[a -b]", [a, -b]),
        ("-1 ± 2√3 j", [-1 + 2 * sp.sqrt(3) * i, -1 - 2 * sp.sqrt(3) * i]),
        ("-1 ± 2sqrt3 j", [-1 + 2 * sp.sqrt(3) * i, -1 - 2 * sp.sqrt(3) * i]),
        (r"$-2 \pm j\,2\sqrt{3}$", [-2 + 2 * sp.sqrt(3) * i, -2 - 2 * sp.sqrt(3) * i]),
        ("-1 (double)", [-1, -1]),
        ("-1 (twice)", [-1, -1]),
        ("-1 with multiplicity 2", [-1, -1]),
        ("-1 (2x)", [-1, -1]),
        ("λ1 = λ2 = -1", [-1, -1]),
        ("{-1: 2}", [-1, -1]),
        ("'{1 - sqrt(6): 1, 1 + sqrt(6): 1}'", [1 - sp.sqrt(6), 1 + sp.sqrt(6)]),
        ("[1+2j, 1-2j]", [1 + 2 * i, 1 - 2 * i]),
        ("'λ1,2 = 0'", [0, 0]),
        ("'s1,2 = -3 ± 2j, s3,4 = -10'", [-3 + 2 * i, -3 - 2 * i, -10, -10]),
        ("'b ∈ {-1, -2}'", [-1, -2]),
        ("4e^(±j 2pi/3)", [-2 + 2 * sp.sqrt(3) * i, -2 - 2 * sp.sqrt(3) * i]),
        ("'exp(±i*pi/2)'", [i, -i]),
        (r"'\lambda_{1,2} = -3 \pm 2j'", [-3 + 2 * i, -3 - 2 * i]),
        (r"'s_{1,2} = -2 \pm 3\,\mathrm{j}'", [-2 + 3 * i, -2 - 3 * i]),
    ],
)
def test_a_list_is_read(text, value):
    found = read(text, TWO)
    assert (found.value, found.others) == (value, ())


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("[1 2]", [1, 2]),
        ("(1, 2)", [1, 2]),
        ("1, 2", [1, 2]),
        ("1 2", [1, 2]),
        ("[-1 -2]", [-1, -2]),
        ("[1, 2;]", [1, 2]),
        ("[2a 3]", [2 * a, 3]),
        ("[-j 2]", [-i, 2]),
        ("[-j j]", [-i, i]),
        ("[a -b]", [a, -b]),
        ("np.array([[1, 2]])", [1, 2]),
        ("np.matrix('1 2')", [1, 2]),
        ("K = [1 2]", [1, 2]),
        ("1/2 [1 2]", [sp.Rational(1, 2), 1]),
        ("'[1, 2]/2'", [sp.Rational(1, 2), 1]),
        ("-[1 2]", [-1, -2]),
        (r"\begin{bmatrix} 1 & \frac12 \end{bmatrix}", [1, sp.Rational(1, 2)]),
    ],
)
def test_a_row_is_read(text, value):
    found = read(text, ROW)
    assert (found.value, found.others) == (M([value]), ())


@pytest.mark.parametrize(
    "text",
    [
        "[1 2; 3 4]", "[1, 2; 3, 4]", "'[1,2;3,4]'", "[[1 2], [3 4]]", "[[1; 3], [2; 4]]",
        "'[[1; 3], [2; 4]]'", "[1 2\n ; 3 4]", "'[1 2 ...\n ; 3 4]'",
        "[[1, 2], [3, 4]]", "{{1, 2}, {3, 4}}", "\"[1 3; 2 4]'\"", "\"[[1, 3], [2, 4]].T\"", "|\n  1 2\n  3 4",
        "|\n  [[1 2]\n   [3 4]]", "\n  - 1 2\n  - 3 4", "np.array([[1, 2], [3, 4]])", "Matrix(2, 2, [1, 2, 3, 4])",
        "'np.array([[1., 2.], [3., 4.]], dtype=float)'", "sympy.Matrix([[1, 2], [3, 4]])",
        "'ImmutableDenseMatrix([[1, 2], [3, 4]])'", r"\begin{pmatrix} 1 & 2 \\ 3 & 4 \end{pmatrix}",
        r"$\left[\begin{array}{cc} 1 & 2 \\ 3 & 4 \\ \end{array}\right]$", "A_c = [1 2; 3 4]", "((1, 2), (3, 4))",
        r"\frac{1}{2} \begin{bmatrix} 2 & 4 \\ 6 & 8 \end{bmatrix}", "np.matrix('1 2; 3 4')",
    ],
)  # fmt: skip
def test_a_matrix_is_read_in_the_notation_of_many_programs(text):
    found = read(text, SQUARE)
    assert (found.value, found.others) == (M([[1, 2], [3, 4]]), ())


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("'[e^(-t) 0; 0 e^(-2t)]'", M([[e(-t), 0], [0, e(-2 * t)]])),
        (
            "'e^(-t) [2 1; -2 -1] + e^-2t [-1 -1; 2 2]'",
            M([[2, 1], [-2, -1]]) * e(-t) - M([[1, 1], [-2, -2]]) * e(-2 * t),
        ),
        ("'[1 2; 3 4] - [1 1; 1 1]/2'", M([[1, 3], [5, 7]]) / 2),
        ("'1/(s+1) [s 1; -2 s+3]'", M([[s, 1], [-2, s + 3]]) / (s + 1)),
        ("[[te^-t, 0], [0, cos2t]]", M([[t * e(-t), 0], [0, sp.cos(2 * t)]])),
    ],
)
def test_entries_may_be_expressions(text, value):
    found = read(text, SQUARE)
    assert sp.expand(found.value - value) == sp.zeros(2, 2)
    assert found.others == ()


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("'p11 = 1, p12 = 2, p22 = 3'", [[1, 2], [2, 3]]),
        ("'p_11 = 1, p_21 = 2, p_22 = 3'", [[1, 2], [2, 3]]),
        ("'p_{11} = 1, p_{12} = p_{21} = 2, p_{22} = 3'", [[1, 2], [2, 3]]),
        ("'a_11 = 1; a_12 = 2; a_21 = 4; a_22 = 3'", [[1, 2], [4, 3]]),
    ],
)
def test_a_matrix_is_read_by_the_names_of_its_entries(text, value):
    found = read(text, SQUARE)
    assert (found.value, found.respelt) == (M(value), True)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("'span{(-2, 1, 0), (-3, 0, 1)}'", [[-2, -3], [1, 0], [0, 1]]),
        ("'span{[1; 2; 0], [3; 4; 1]}'", [[1, 3], [2, 4], [0, 1]]),
        ("'v1 = [1; 2; 0], v2 = [3; 4; 1]'", [[1, 3], [2, 4], [0, 1]]),
        ("'span([1, 2, 0], [3, 4, 1])'", [[1, 3], [2, 4], [0, 1]]),
        ("'[B AB] = [1 3; 2 4; 0 1]'", [[1, 3], [2, 4], [0, 1]]),
    ],
)
def test_vectors_are_the_columns_of_a_basis(text, value):
    assert read(text, M([[a, b], [a, b], [b, a]])).value == M(value)


@pytest.mark.parametrize("text", ["2+4*[3 1]", "2 + 4 [3 1]", "7 - 1*[3 1]", "[3 1]/2 + 1", "(2 + 4) [3 1] + 1"])
def test_a_number_beside_a_matrix_is_no_factor_of_it(text):
    with pytest.raises(Fault):
        read(f"'{text}'", ROW)


@pytest.mark.parametrize(("text", "value"), [("-[1 2] + [3 4]", [2, 2]), ("[20 9] - [2 3]", [18, 6])])
def test_sums_of_rows_are_read(text, value):
    assert read(f"'{text}'", ROW).value == M([value])


def test_the_name_of_a_whole_space_is_its_basis():
    assert read("R^2", SQUARE).value == sp.eye(2)
    assert read(r"'\mathbb{R}^{2}'", SQUARE).value == sp.eye(2)
    assert read("R^3", SQUARE).value != sp.eye(2)


def test_a_mixed_number_is_the_sum_or_the_product():
    found = read("2 3/5", M([[a]]))
    assert [each.value for each in (found, *found.others)] == [M([[sp.Rational(13, 5)]]), M([[sp.Rational(6, 5)]])]


def test_zeros_left_out_at_the_end_of_a_row_of_rouths_array_are_read_there_only():
    array = M([[1, 3, 5], [2, 4, 0], [a, 0, 0]])
    text = "[[1, 3, 5], [2, 4], [7]]"
    assert read(text, array, Expected("array")).value == M([[1, 3, 5], [2, 4, 0], [7, 0, 0]])
    with pytest.raises(Fault, match="the same length"):
        read(text, array)


@pytest.mark.parametrize(
    ("text", "value"),
    [("diag(1, 2)", sp.diag(1, 2)), ("diag([1 2])", sp.diag(1, 2)), ("np.diag([1, 2])", sp.diag(1, 2)),
     ("eye(2)", sp.eye(2)), ("np.eye(2)", sp.eye(2)), ("zeros(2)", sp.zeros(2)), ("ones(2, 2)", sp.ones(2))],
)  # fmt: skip
def test_matrices_with_a_name_are_read(text, value):
    assert read(f'"{text}"', SQUARE).value == M(value)


@pytest.mark.parametrize("text", ["eye(99)", "ones(a)", "zeros(1, 2, 3)", "eye(1e9)"])
def test_matrices_of_no_size_are_refused(text):
    with pytest.raises(Fault):
        read(f"'{text}'", SQUARE)


@pytest.mark.parametrize(("text", "ours"), [("[[1], [2]]", ROW), ("[1; 2]", ROW), ("[[1, 2]]", COLUMN)])
def test_a_vector_in_the_other_orientation_is_turned_and_that_is_said(text, ours):
    found = read(text, ours)
    assert list(found.value) == [1, 2]
    assert found.value.shape == ours.shape
    assert found.respelt


def test_a_matrix_is_never_turned():
    assert read("[1 2; 3 4]", SQUARE).value != read("[1 3; 2 4]", SQUARE).value
    assert read("[[1, 2, 3]]", COLUMN).value.shape == (1, 3)


@pytest.mark.parametrize(("text", "one"), [("[a -b]", a - b), ("[1 - 2]", sp.Integer(-1)), ("[2 a]", 2 * a)])
def test_spaces_separate_where_only_that_has_the_shape_asked_for(text, one):
    assert read(text, M([[a]])).value == M([[one]])


def test_what_shapes_do_not_tell_apart_has_both_readings():
    found = read("[a -b]", [a, b, a])
    assert [found.value, *(other.value for other in found.others)] == [[a, -b], [a - b]]


@pytest.mark.parametrize("text", ["{0}", "'{0}'", "{}", "[]", "none", "∅", "trivial", "only the zero vector"])
def test_the_basis_of_the_trivial_space_has_no_columns(text):
    assert read(text, SQUARE).value.shape == (2, 0)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[1 2; 3]", "same length"),
        ("'[[1, 2], [3]]'", "same length"),
        ('"[[1, 2], [3]]\'"', "same length"),
        ("'[1 2'", "operator is missing"),
        (r"\begin{bmatrix} 1 & 2", "is missing"),
        (r"\begin{tikzpicture} 1", "not read"),
    ],
)
def test_what_is_no_matrix_is_refused(text, words):
    with pytest.raises(Fault, match=words):
        read(text, SQUARE)


@pytest.mark.parametrize(
    "text", ["{x1: 1, x2: 2}", "x1 = 1, x2 = 2", "'x_1: 1; x_2: 2'", "[x1 = 1, x2 = 2]", "[x1: 1, x2: 2]"]
)
def test_names_with_values_are_read(text):
    assert read(text, {x1: a, x2: b}).value == {x1: 1, x2: 2}


@pytest.mark.parametrize(
    ("text", "ours", "value"),
    [
        ("1,5", a, sp.Rational(3, 2)),
        ("'1,5'", a, sp.Rational(3, 2)),
        ("1.5", a, sp.Rational(3, 2)),
        ("2,5 a", a, sp.Rational(5, 2) * a),
        ("1,5; 2,5", TWO, [sp.Rational(3, 2), sp.Rational(5, 2)]),
        ("[1,5; 2,5]", ROW, M([[sp.Rational(3, 2), sp.Rational(5, 2)]])),
        ("[1,5, 2,5]", ROW, M([[sp.Rational(3, 2), sp.Rational(5, 2)]])),
        ("[1,5 2,5]", ROW, M([[sp.Rational(3, 2), sp.Rational(5, 2)]])),
        ("['1,5', '2,5']", TWO, [sp.Rational(3, 2), sp.Rational(5, 2)]),
        ("[1, 5]", TWO, [1, 5]),
        ("[1,5]", TWO, [1, 5]),
        ("[1.5,2.5]", TWO, [sp.Rational(3, 2), sp.Rational(5, 2)]),
        ("[[1,5, 2], [3, 4]]", SQUARE, M([[sp.Rational(3, 2), 2], [3, 4]])),
    ],
)
def test_a_decimal_comma_is_read_where_the_problem_has_it(text, ours, value):
    found = read(text, ours, comma=True)
    assert (found.value, found.others) == (value, ())


def test_a_comma_that_may_be_either_gives_both_readings():
    found = read("[1,5]", [a, b, a], comma=True)
    assert [found.value, *(other.value for other in found.others)] == [[sp.Rational(3, 2)], [1, 5]]


def test_the_digits_of_a_decimal_comma_count():
    ((_, decimal),) = read("0,67", a, comma=True).decimals.items()
    assert tuple(decimal) == (sp.Rational(67, 100), sp.Rational(1, 200), 2)


def test_too_many_readings_are_refused():
    class Endless(Choices):
        def next(self):
            return self

    def endless():
        while True:
            yield Endless()

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("solver.classroom.reading.values.readings", endless)
        with pytest.raises(Fault, match="too many readings"):
            read("1", a)


@pytest.mark.parametrize(
    "text",
    [
        "<<a,b>|<a,b>>", "<a,a;b,b>", "<<a|a>,<b|b>>", "'[[a,a][b,b]]'", "Transpose[{{a,b},{a,b}}]",
        "transpose([a b; a b])",
        "transpose(matrix([a,b],[a,b]))", "2*{{a,a},{b,b}}/2", "'[1 0; 0 1]*[a a; b b]'", "simplify([a a; b b])",
        "a a / b b", "'[2a 2a; 2b 2b] - [a a; b b]'", "real([a a; b b])",
    ],
)  # fmt: skip
def test_a_matrix_in_the_notation_of_another_program(text):
    assert read(text, SQUARE).value == M([[a, a], [b, b]])


@pytest.mark.parametrize(
    "text",
    ["v1 = (a, b), v2 = (b, a)", "(a, b), (b, a)", "(a,b)^T, (b,a)^T", "span{(a,b)}, span{(b,a)}", "'{(a,b), (b,a)}'"],
)
def test_vectors_listed_one_by_one_are_columns_or_rows_as_the_answer_is_made(text):
    vectors = M([[a, b], [b, a]])
    assert read(text, SQUARE, Expected(vectors="columns")).value == vectors.T
    assert read(text, SQUARE, Expected(vectors="rows")).value == vectors


def test_rows_without_a_name_may_be_vectors_or_the_rows_of_a_matrix():
    found = read("'[a, 1], [b, 2]'", SQUARE, Expected(vectors="columns"))
    assert [each.value for each in (found, *found.others)] == [M([[a, b], [1, 2]]), M([[a, 1], [b, 2]])]


@pytest.mark.parametrize("text", ["2 + 4 [3 1]", "'[3, 1] - a'", "1 + [a a; b b]"])
def test_a_number_is_not_added_to_a_matrix(text):
    with pytest.raises(Fault, match="a number cannot be added to a matrix"):
        read(text, ROW)


@pytest.mark.parametrize("text", ["-1, -2 (both)", "see my sheet", "-cd, cd"])
def test_words_that_mean_nothing_are_not_read(text):
    with pytest.raises(Fault, match="has no meaning here"):
        read(text, TWO)


@pytest.mark.parametrize("text", ["a² = 2", "s² = -2", "λ³ = 8"])
def test_a_power_is_no_label(text):
    with pytest.raises(Fault, match="equation"):
        read(f"'{text}'", TWO)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("λ₁,₂ = 2; λ₃ = 0", [2, 2, 0]),
        ("λ₁,₂,₃ = 2", [2, 2, 2]),
        ("λ_{1,2,3} = 2, λ_4 = 0", [2, 2, 2, 0]),
        ("λ1 = 1, λ2,3,4 = 5", [1, 5, 5, 5]),
    ],
)
def test_a_name_with_several_indices_stands_for_as_many_values(text, value):
    assert read(f"'{text}'", TWO).value == value


@pytest.mark.parametrize(
    "text", ["k1 = 2a; k2 = 3k1", "k_1 = 2a, k_2 = 3 k_1", "k₁ = 2a, k₂ = 3k₁", "k1 = 2a, k2 = 3*k_1"]
)
def test_a_named_entry_stands_for_its_value_in_the_later_ones(text):
    assert read(f"'{text}'", ROW).value == M([[2 * a, 6 * a]])
