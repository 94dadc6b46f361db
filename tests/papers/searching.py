"""A search of which nothing is made: its draws are judged, and not solved and verified."""

from itertools import islice

from solver.derivation import Status
from solver.executors import Executor
from solver.limits import Limits
from solver.papers.making import Made, Making

ALL = 10**6


class Here(Executor):
    """Makes so many calls at a time in this process, without limits, and tells the last of them first."""

    def __init__(self, jobs=1):
        self.jobs = jobs
        self.made = 0

    def calls(self, _limits, function, calls):
        left = enumerate(calls)
        while some := list(islice(left, self.jobs)):
            for place, arguments in reversed(some):
                self.made += 1
                yield place, function(*arguments)


def unmade(_draw, _source, _wanted):
    """Make nothing."""
    return Made(Status.VERIFIED, "", {})


def candidates(search, wanted=ALL):
    """Return so many draws that hold."""
    return list(search.candidates(wanted, Making(unmade, None, Limits())))
