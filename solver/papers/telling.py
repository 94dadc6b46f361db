"""What a search took, and what kept it from finding enough, in words."""

from __future__ import annotations

from collections import Counter

from solver.papers.judging import Rejection
from solver.papers.search import BEFORE, Search
from solver.problem.nodes import Node, Place
from solver.problem.source import Diagnostic, InputError, Source

SHOWN = 4


def took(search: Search) -> str:
    """Return how many draws it took, and what rejected how many of them."""
    told = f"{_counted(search.draws, 'draw')} of {search.family.size} choices"
    rejected = [f"{count} by {why.why}" if not why.own else f"{count}: {why.why}" for why, count in _most(search)]
    hidden = len(search.rejections) - SHOWN
    return told + (f"; rejected {'; '.join(rejected)}" if rejected else "") + ("; …" if hidden > 0 else "")


def shortage(search: Search, source: Source, count: int) -> InputError:
    """Return what is wrong where fewer members were found than wanted: what rejected most, at its place."""
    found = f"{search.found} of {_counted(count, 'member')}" if search.found else "no member"
    all_drawn = f"all {search.family.size} choices were drawn" if search.is_exhausted else f"after {search.draws} draws"
    message, note = f"found {found}: {all_drawn}", ""
    place = Place()
    # What was drawn before is no draw of its own: it was looked at once.
    rejections = Counter({why: times for why, times in search.rejections.items() if why != BEFORE})
    if rejections:
        why, most = rejections.most_common(1)[0]
        place = _place(search, why)
        others = ", more than by anything else" if len(rejections) > 1 else ""
        cause = f": {why.why}" if why.own else f" by '{why.why}'{others}"
        message += f", and {most} {'was' if most == 1 else 'were'} rejected{cause}"
    if not search.is_exhausted:
        note = "--draws N makes more of them"
    elif search.found < count:
        note = "give what is drawn more values, or ask for fewer members"
    if met := sum(times for why, times in search.rejections.items() if why.is_by_limits):
        note = f"{_counted(met, 'draw')} met a limit; --time-limit and --memory-limit allow more"
    diagnostic = Node(place).diagnostic(message, note=note) if place.line else Diagnostic(message, note=note)
    return InputError(source, [diagnostic])


def _place(search: Search, why: Rejection) -> Place:
    """Where in the file the condition stands that rejected a draw."""
    family = search.family
    stated = {each.text: each.place for each in family.required} | {each.text: each.place for each in family.nice}
    return Place() if why.own else stated.get(why.why, Place())


def _most(search: Search) -> list[tuple[Rejection, int]]:
    """What rejected most draws, in the order of their number, then of their words."""
    return sorted(search.rejections.items(), key=lambda item: (-item[1], item[0].why))[:SHOWN]


def _counted(number: int, thing: str) -> str:
    return f"{number} {thing}" if number == 1 else f"{number} {thing}s"
