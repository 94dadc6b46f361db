"""The corpus: its truths are those of the judges, and the program marks nothing wrong as correct."""

from itertools import groupby
from pathlib import Path

import pytest
import yaml

from tests.classroom.corpus.cases import submissions
from tests.classroom.corpus.marking import outcomes
from tests.helpers.shares import turn

ALL = list(submissions())
PROBLEMS = {name: list(each) for name, each in groupby(ALL, lambda each: each.problem.name)}
IN_TURN, SELDOM = (
    [pytest.param(each, id=name, marks=turn(name, of)) for name, each in PROBLEMS.items()] for of in (8, 32)
)
"""What is asked of the program, and what only of the corpus itself."""
REASONS = yaml.safe_load((Path(__file__).parent / "known.yaml").read_text(encoding="utf-8"))
"""Right answers that are not marked correct yet, by the reason."""
KNOWN = {name for names in REASONS.values() for name in names}
MOST_KNOWN = 0
"""It may only shrink."""


def mismarked(chosen):
    """What is marked otherwise than it is, without what is known."""
    found = [outcome for each in chosen for outcome in outcomes(each)]
    negative = [each for each in found if each.false_negative and each.submission.id not in KNOWN]
    return [str(each) for each in found if each.false_positive] + [str(each) for each in negative]


def test_names_are_unique_and_those_that_are_known_exist():
    names = [each.id for each in ALL]
    assert len(names) == len(set(names))
    assert set(KNOWN) <= set(names)


def test_half_of_the_submissions_are_right():
    right = sum(each.claims[0].truth == "right" for each in ALL)
    assert len(ALL) > 1000
    assert 0.35 < right / len(ALL) < 0.65
    assert len(KNOWN) <= MOST_KNOWN


def test_truths_of_a_sample_are_those_of_the_judges():
    assert not [slip for each in ALL[3::240] for slip in each.slips()]


@pytest.mark.parametrize("chosen", SELDOM)
def test_truths_are_those_of_the_judges(chosen):
    assert not [slip for each in chosen for slip in each.slips()]


def test_a_sample_is_marked_as_it_is():
    assert not mismarked(ALL[7::160])


@pytest.mark.parametrize("chosen", IN_TURN)
def test_nothing_wrong_is_correct_and_what_is_right_is(chosen):
    assert not mismarked(chosen)
