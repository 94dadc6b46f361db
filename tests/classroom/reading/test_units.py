"""Units behind numbers and lists, and decibels for ratios."""

import pytest

from solver.classroom.reading.units import ForeignUnitError, inside, shared, without_unit


@pytest.mark.parametrize(
    ("items", "unit", "found"),
    [
        (["1", "10", "50 rad/s"], "rad/s", ["1 rad/s", "10 rad/s", "50 rad/s"]),
        (["π/3", "π", "5π/3 rad"], "°", ["π/3 rad", "π rad", "5π/3 rad"]),
        (["1", "2 s", "3 s"], "s", ["1", "2 s", "3 s"]),
        (["1", "2"], "s", ["1", "2"]),
        (["1", "2 s"], "", ["1", "2 s"]),
        ([], "s", []),
    ],
)
def test_a_unit_behind_a_list_is_that_of_each_item(items, unit, found):
    assert shared(items, unit) == found


@pytest.mark.parametrize(
    ("text", "unit", "found"),
    [
        ("9.54 dB", "ratio", "10^((9.54)/20)"),
        ("180° - 154.6°", "°", "180 - 154.6"),
        ("-20 dB/dec", "dB/decade", "-20"),
        ("19 s^-1", "1/s", "19"),
    ],
)
def test_a_number_without_its_unit(text, unit, found):
    assert without_unit(text, unit) == found


@pytest.mark.parametrize(("text", "unit"), [("3 dB", "s"), ("-20 dB/oct", "dB/decade"), ("3 rad/s", "ratio")])
def test_a_unit_of_another_kind_is_refused(text, unit):
    with pytest.raises(ForeignUnitError):
        without_unit(text, unit)


def test_a_list_in_brackets_with_its_unit():
    assert inside("[1, 10, 50] rad/s", "rad/s") == "1, 10, 50 rad/s"
    assert inside("[1; 10] rad/s", "rad/s") == "1; 10 rad/s"
    assert inside("[1, 10] a", "rad/s") == "[1, 10] a"
