"""Members of a family that are as they were kept; only those that are new are searched, solved and verified."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import chain
from typing import Any

from solver.derivation import Status
from solver.papers.families import Made, Member, Wanted, all_made, made, members
from solver.papers.kept import Kept, MadeBefore, drawn_before, facts_of, keep_drawn, recall
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
    make: Callable[[str, str, Any], Made] = made,
    kind: type[Made] = Made,
    engine: str = "",
) -> Iterator[Member]:
    """Yield what `members` does of the family that a problem tells, and keep it; `make` makes things of a kind.

    For another count what became of the draws, and what was made of their texts, is known. `engine` makes PDFs.
    """
    memory = MadeBefore(kept, kind, (*facts_of(problem, search.source.name, wanted), engine))
    recall(kept, search)
    if drawn := drawn_before(kept, search, count):
        limits = wanted.limits.times(sum(len(part.methods) for part in problem.parts))
        some = [drawn[start : start + AT_ONCE] for start in range(0, len(drawn), AT_ONCE)]

        def made_of(few: Sequence[tuple[Mapping[str, str], str]]) -> list[Any]:
            calls = [(text, search.source.name, wanted) for _, text in few]
            return all_made(search.executor, limits, make, calls, memory)

        # What is made is kept, so it is asked for again rather than a thousand held.
        if all(isinstance(each, Made) and each.status is Status.VERIFIED for few in some for each in made_of(few)):
            width, again = max(2, len(str(count))), (zip(few, made_of(few), strict=True) for few in some)
            for number, ((values, text), result) in enumerate(chain.from_iterable(again), 1):
                yield Member(number, f"{name}-{number:0{width}}", values, text, result)
            return
        search.begin_again()  # a limit was met, say: the search says it
    found = []
    for member in members(search, count, wanted, name, make, memory):
        found.append((member.values, member.text))
        yield member
    keep_drawn(kept, search, count, found)
