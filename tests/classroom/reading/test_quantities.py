"""Texts of quantities put otherwise: what each says, and what it must not be taken for."""

import pytest
import sympy as sp

from solver.classroom.reading.components import in_numbers
from solver.classroom.reading.control_laws import coefficients_of, controller_of
from solver.classroom.reading.counts import counted, whole_number
from solver.classroom.reading.decimals import decimals_of
from solver.classroom.reading.in_order import by_variables
from solver.classroom.reading.quantities import told_otherwise
from solver.classroom.reading.remarks import without_remarks, without_words_in_brackets
from solver.classroom.reading.said_twice import says_how
from solver.classroom.reading.sentences import premise
from solver.classroom.reading.words import fitting, truth


@pytest.mark.parametrize(
    ("text", "numbers"),
    [
        ("47kΩ/10 kOhm", "(47*10^(3))/(10*10^(3))"),
        ("4k7", "(4.7*10^(3))"),
        ("100n v1", "(100*10^(-9)) v1"),
        ("2 µF", "(2*10^(-6))"),
        ("5 m v1", "5 m v1"),
        ("v1/R1 + 10", "v1/R1 + 10"),
    ],
)
def test_values_of_components(text, numbers):
    assert in_numbers(text, lambda name: False) == numbers


def test_a_name_of_the_problem_is_no_power_of_ten():
    assert in_numbers("4k7 + 2k", lambda name: name == "k") == "4k7 + 2k"


@pytest.mark.parametrize(
    ("text", "count"), [("52", 1), ("-127", 1), ("180 - 128", 1), ("9", 1), ("0", 0), ("52/2", 0), ("-90 - atan(2)", 0)]
)
def test_whole_degrees_are_rounded_where_nothing_else_stands_there(text, count):
    found = list(decimals_of(text, 0, whole=True).values())
    assert len(found) == count
    assert all(decimal.half_unit == sp.Rational(1, 2) for _, decimal in found)
    assert not decimals_of(text, 0)


@pytest.mark.parametrize(
    ("name", "text", "told"),
    [
        ("gain_margin", "inf dB", "inf"),
        ("gain_margin", "infinite, the phase never reaches -180°", "infinite"),
        ("error", "grows without bound", "∞"),
        ("error", "0.5, the error", "0.5, the error"),
        ("slopes", "-40/-20/-40 dB/dec", "-40,-20,-40 dB/dec"),
        ("uncontrollable_modes", "e^-2t", "-2"),
        ("departure_angles", "-45° and +45° for the conjugate pole", "-45°"),
        ("departure_angles", "-45° and -45° for the conjugate pole", "-45° and -45° for the conjugate pole"),
    ],
)
def test_quantities_are_told_otherwise(name, text, told):
    assert told_otherwise(text, name, sp.Integer(1)) == told


@pytest.mark.parametrize(
    ("text", "controller"),
    [
        ("u = 3 e + 2 ∫e dt + 0.5 de/dt", "(((3)) + (+(2)/s) + (+(0.5)*s))"),
        ("u = 3(e + 1/2 ∫ e dt)", "(3)*(((1)) + (+(1/2)/s))"),
        ("K_p = (4-a)/b, K_i = 5/b", "((4-a)/b) + (5/b)/s"),
        ("K = 10, T = 0.2, α = 0.3", "(10)*((0.2)*s + 1)/((0.3)*(0.2)*s + 1)"),
        ("u = 3 e + 2 e", ""),
        ("u = 3 x", ""),
        ("u(k) = 3 e(k) - 2 e(k-1)", ""),
    ],
)
def test_controllers_are_told_by_their_laws(text, controller):
    assert controller_of(text) == controller


def test_what_is_added_to_the_last_input_has_the_coefficients():
    assert coefficients_of("7 e(k) - 12 e(k-1) + 5 e(k-2)") == "[(7), -(12), (5)]"
    assert coefficients_of("u(k) = 7 e(k) - 12 e(k-1)") == ""


@pytest.mark.parametrize(
    ("text", "name", "number"),
    [
        ("1 (not full rank)", "rank", "1"),
        ("2 (not full rank)", "rank", None),
        ("2 in the right half plane", "right_half_plane_roots", "2"),
        ("two closed-loop poles in the RHP", "closed_loop_unstable_poles", "2"),
        ("2 closed-loop poles in the RHP", "open_loop_unstable_poles", None),
        ("1 (once clockwise)", "encirclements", "1"),
        ("1 (once counterclockwise)", "encirclements", None),
        ("N = -1 (counterclockwise)", "encirclements", "-1"),
        ("-1 (cw)", "encirclements", None),
        ("1 (ccw)", "encirclements", "-1"),
        ("proportional (type 0)", "system_type", "0"),
    ],
)
def test_counts_with_remarks(text, name, number):
    assert counted(text, name, 2) == number


def test_a_number_of_something_else_is_none_of_this_one():
    assert whole_number("rank 1", "determinant") == "rank 1"
    assert whole_number("determinant zero", "determinant") == "0"


@pytest.mark.parametrize(
    ("text", "bare"),
    [
        ("5.8 (numerically)", "5.8"),
        ("0.25 (percent)", "0.25 (percent)"),
        ("3 (not stable)", "3 (not stable)"),
        ("2 (two)", "2 (two)"),
        ("2 (alpha)", "2 (alpha)"),
        ("-1 (double)", "-1 (double)"),
    ],
)
def test_words_in_brackets_that_say_nothing_of_a_number_are_left_out(text, bare):
    assert without_words_in_brackets(text) == bare


@pytest.mark.parametrize(
    ("text", "own", "bare"),
    [
        ("3.08 at s = -0.845", "breakaway_gains", "3.08"),
        ("|G| = 1 at ω = 1.14", "gain_crossover", "|G| = 1 at ω = 1.14"),
        ("-40 (ω<2), -20 (2<ω<10)", "slopes", "-40, -20"),
        ("-0.845 between 0 and -2", "breakaway_points", "-0.845"),
        ("153° for the pole -2+2j", "departure_angles", "153°"),
    ],
)
def test_where_a_number_stands_is_no_part_of_it(text, own, bare):
    assert without_remarks(text, own) == bare


def test_scaled_variables_have_the_factors():
    assert by_variables("X1 = x/5, X2 = 0.1x'") == "x: 1/5, x': 0.1"
    assert by_variables("0.2, 0.1") == "0.2, 0.1"


def test_formulas_in_components_say_how_a_signal_is_found():
    assert says_how("-RC v1", ["v1"], of_functions=False)
    assert not says_how("-K v1", ["v1"], of_functions=False)
    assert says_how("1 - G(0)", [], of_functions=True)
    assert not says_how("2 G(0)", [], of_functions=False)


def test_a_conclusion_in_words_follows_from_a_value():
    assert premise("0.33 → unstable") == "0.33"
    assert premise("det = 0 → rank 1") == "det = 0"
    assert premise("K → infinity") == ""
    assert premise("k - 2 = 5 → k = 7") == ""


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("it isn't controllable", False),
        ("never controllable", False),
        ("not controllable for any a", False),
        ("controllable for all a", None),
        ("always controllable", None),
    ],
)
def test_what_is_so_for_all_values_is_no_plain_yes(text, said):
    assert truth(text, "controllable") is said


@pytest.mark.parametrize("text", ["abcdefghijklmnop" * 60 + " < 0", "a b " * 400 + "< 0", "word " * 300 + "("])
def test_long_texts_of_words_are_read_without_going_back_and_forth(text):
    """Patterns that could part a run of letters in many ways would not come to an end here."""
    assert fitting(text, ("stable",)) == []
    assert premise(text) == ""


def test_an_infinite_margin_has_no_unit_in_decibels_either():
    assert told_otherwise("inf dB", "gain_margin_db", sp.oo) == "inf"
