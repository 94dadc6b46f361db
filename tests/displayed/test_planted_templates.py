"""An error planted in a template makes the page that shows it failed, whatever the kind of its formula."""

import pytest

from solver.derivation import Status
from tests.helpers.planted import PLANTED, PROBLEMS
from tests.helpers.planting import told


def grouped(names):
    """Parameters of one problem run in one worker, which solves it once."""
    return [pytest.param(key, marks=pytest.mark.xdist_group(f"planted-{name}"), id=key) for key, name in names]


@pytest.mark.parametrize("name", grouped((name, name) for name in PROBLEMS))
def test_what_the_templates_say_holds(name):
    document = told(name)
    assert document.status is Status.VERIFIED, [part.reason for part in document.parts]


@pytest.mark.parametrize("place", grouped((place, planted[0]) for place, planted in PLANTED.items()))
def test_an_error_planted_there_fails(place):
    document = told(*PLANTED[place])
    assert not any(part.fault for part in document.parts)
    assert document.status is Status.FAILED


def test_there_are_forty_kinds():
    assert len(PLANTED) >= 40
