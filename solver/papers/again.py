"""Members of a family that are as they were kept; only those that are new are searched, solved and verified."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import chain
from typing import Any

from solver.derivation import Status
from solver.papers.families import Member, members
from solver.papers.kept import Kept, MadeBefore, drawn_before, facts_of, keep_drawn, recall
from solver.papers.making import Made, Make, Making, Wanted, all_made, made
from solver.papers.search import Search
from solver.problem.model import Problem

AT_ONCE = 64
"""So many members that are kept are read at a time."""


def members_again(
    kept: Kept,
    problem: Problem,
    search: Search,
    count: int,
    wanted: Wanted,
    name: str,
    make: Make = made,
    kind: type[Made] = Made,
    engine: str = "",
) -> Iterator[Member]:
    """Yield what `members` does of the family that a problem tells, and keep it; `make` makes things of a kind.

    For another count what became of the draws, and what was made of their texts, is known. `engine` makes PDFs.
    """
    memory = MadeBefore(kept, kind, (*facts_of(problem, search.source.name, wanted), engine))
    making = Making(make, wanted, wanted.limits.times(problem.solutions), memory)
    recall(kept, search)
    if drawn := drawn_before(kept, search, count):
        some = [drawn[start : start + AT_ONCE] for start in range(0, len(drawn), AT_ONCE)]

        def made_of(few: Sequence[tuple[Mapping[str, str], str]]) -> list[Any]:
            return all_made(search.executor, search.source.name, making, [text for _, text in few])

        # What is made is kept, so it is asked for again rather than a thousand held.
        if all(isinstance(each, Made) and each.status is Status.VERIFIED for few in some for each in made_of(few)):
            width, again = max(2, len(str(count))), (zip(few, made_of(few), strict=True) for few in some)
            for number, ((values, text), result) in enumerate(chain.from_iterable(again), 1):
                yield Member(number, f"{name}-{number:0{width}}", values, text, result)
            return
        search.begin_again()  # a limit was met, say: the search says it
    found = []
    for member in members(search, count, making, name):
        found.append((member.values, member.text))
        yield member
    keep_drawn(kept, search, count, found)
