"""Marking of root loci: intervals as students write them, angles modulo 360°, mistakes and extra points by name."""

import pytest

from tests.helpers.marked import marked, verdict

pytestmark = pytest.mark.xdist_group("root loci")  # its problem is solved once

LOOPS = """
title: Root loci
system: {transfer_function: 1/(s(s + 1)(s + 2))}
find:
  three: root_locus
  zero: {task: root_locus, system: {transfer_function: (2s + 3)/(s^2 + 2s + 3)}}
"""


def judged(part, name, value):
    """The verdict of a value that stands on a line of its own."""
    return marked(LOOPS, f"answers:\n  {part}:\n    {name}: {value}\n")[part].answers[name]


@pytest.mark.parametrize(
    "written",
    [
        "(-oo, -2], [-1, 0]",
        '"]-∞, -2] and [-1, 0]"',
        "s <= -2 or -1 <= s <= 0",
        "[[-oo, -2], [-1, 0]]",
        '["(-oo, -2)", "(-1, 0)"]',
        "(-oo; -2) ∪ (-1; 0)",
        "[Interval(-oo, -2), Interval(-1, 0)]",
    ],
)
def test_intervals_are_read_as_they_are_written(written):
    assert judged("three", "real_axis_segments", written).verdict == "correct"


@pytest.mark.parametrize("written", ["[-1, 0]", "(-oo, -2], [-1, 1]", "none", "(-oo, 0]"])
def test_other_intervals_are_wrong(written):
    assert judged("three", "real_axis_segments", written).verdict == "wrong"


def test_what_is_no_interval_is_not_judged():
    assert judged("three", "real_axis_segments", "x + y < 1").verdict == "not judged"


def test_angles_are_right_modulo_whole_turns_and_rounded():
    assert verdict(LOOPS, "three", "asymptote_angles", "[60, -180, 300]").verdict == "correct"
    assert verdict(LOOPS, "zero", "departure_angles", "[160.53]").verdict == "correct"
    assert verdict(LOOPS, "zero", "departure_angles", "[-199.47]").verdict == "correct"
    assert verdict(LOOPS, "zero", "departure_angles", "[161.53]").verdict == "wrong"


@pytest.mark.parametrize(
    ("part", "name", "value", "words"),
    [
        ("three", "asymptote_angles", "[0, 120, 240]", "even multiples"),
        ("zero", "centroid", "-3.5", "zeros are added"),
        ("three", "breakaway_points", "[-0.423, -1.577]", "all candidates are listed"),
        ("zero", "departure_angles", "[-160.53]", "the sign is reversed"),
        ("zero", "departure_angles", "[-19.47]", "180°"),
    ],
)
def test_usual_mistakes_are_named(part, name, value, words):
    found = verdict(LOOPS, part, name, value)
    assert found.verdict == "wrong"
    assert words in found.reason


def test_a_point_that_is_extra_is_named_with_its_gain():
    found = verdict(LOOPS, "three", "breakaway_points", "[-0.423, -1.577]")
    assert "−0.38" in str(found) or "-0.38" in str(found)


def test_crossings_are_pairs_or_frequencies():
    for written in ("[1.414j, -1.414j]", "±1.414j", "1.414", "[1.414, -1.414]", "[-1.414, 1.41]"):
        assert judged("three", "imaginary_axis_crossings", written).verdict == "correct"
    for written in ("[1.5j, -1.5j]", "none", "-1.414j", "[1.414, -1.43]", "[1.5, -1.5]"):
        assert judged("three", "imaginary_axis_crossings", written).verdict == "wrong"


@pytest.mark.parametrize("written", ["6", "[6, 6]", '"[6,6]"', '"6,0"'])
def test_whole_numbers_in_brackets_are_a_list_and_no_decimal(written):
    assert judged("three", "critical_gains", written).verdict == "correct"
