"""A search of which nothing is made: its draws are judged, and not solved and verified."""

from solver.derivation import Status
from solver.limits import Limits
from solver.papers.making import Made, Making

ALL = 10**6


def unmade(_draw, _source, _wanted):
    """Make nothing."""
    return Made(Status.VERIFIED, "", {})


def candidates(search, wanted=ALL):
    """Return so many draws that hold."""
    return list(search.candidates(wanted, Making(unmade, None, Limits())))
