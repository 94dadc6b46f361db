"""What was found before, by all it depends on: so an exam of which one question changed is not solved anew.

Who keeps it, and where, the command line decides; here nothing is kept. What is kept is plain data (see `plain`).
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Generic, Protocol, TypeVar

from solver.limits import Limits
from solver.papers.judging import Rejection
from solver.papers.making import Made, Wanted
from solver.papers.plain import NotPlain, as_plain, of_plain
from solver.papers.search import Search
from solver.problem.model import Problem

Kind = TypeVar("Kind", bound=Made)
HEADING = re.compile(r"\A(?:#.*\n)+")


class Kept(Protocol):
    """Keeps plain data by the facts on which they depend; the program and its templates need not be told."""

    @property
    def place(self) -> str:
        """Where data are kept, "" where there are none."""

    def get(self, *facts: Any) -> Any:
        """Return what was put for the same facts, None where there is nothing, or nothing that can be read."""

    def put(self, data: Any, *facts: Any) -> None:
        """Keep data."""


class NothingKept:
    """Keeps nothing."""

    place = ""

    def get(self, *facts: Any) -> Any:
        """Return None."""

    def put(self, data: Any, *facts: Any) -> None:
        """Do nothing."""


NOTHING = NothingKept()


@dataclass(frozen=True)
class MadeBefore(Generic[Kind]):
    """What was made of problems by their texts, for one thing that is wanted of them."""

    kept: Kept
    kind: type[Kind]
    facts: tuple[Any, ...]

    def get(self, text: str) -> Kind | None:
        """Return what was made of a text, None where that is not known."""
        data = self.kept.get("made", _without_heading(text), *self.facts)
        if data is None:
            return None
        try:
            found = of_plain(data)
        except NotPlain:
            return None
        return found if isinstance(found, self.kind) else None

    def put(self, text: str, made: Made) -> None:
        """Keep what was made of a text, if it is plain data."""
        try:
            self.kept.put(as_plain(made), "made", _without_heading(text), *self.facts)
        except NotPlain:  # it is made again
            return


def _without_heading(text: str) -> str:
    """Return a text without the comments on top: a member has its heading there only when it is one."""
    return HEADING.sub("", text, count=1)


def facts_of(problem: Problem, name: str, wanted: Wanted) -> tuple[Any, ...]:
    """Return what is made of a problem depends on, beside its text: its name, its pictures, and what is wanted."""
    pictures = {address: image.file_name for address, image in sorted(problem.images.items())}
    return name, pictures, repr(replace(wanted, limits=Limits()))


def drawn_before(kept: Kept, search: Search, count: int) -> Sequence[tuple[Mapping[str, str], str]]:
    """Return the values and texts of so many members that the same search found before; nothing where it is new.

    The search then tells what it took.
    """
    data = kept.get(*_facts_of_search(search, count))
    try:
        found = [
            ({str(name): str(each) for name, each in values.items()}, str(text)) for values, text in data["members"]
        ]
        rejected = {Rejection(str(why), bool(own)): int(times) for why, own, times in data["rejected"]}
        search.draws, search.count, search.found = int(data["draws"]), int(data["choices"]), len(found)
        search.rejections = Counter(rejected)
    except (TypeError, KeyError, ValueError, AttributeError):
        return []
    return found


def recall(kept: Kept, search: Search) -> None:
    """Let a search know what became of the draws that the same search judged before, for another count of members."""
    try:
        found = {
            int(number): str(asked) if why is None else Rejection(str(why), bool(own))
            for number, asked, why, own in kept.get(*_facts_of_judgements(search)) or ()
        }
    except (TypeError, ValueError):
        return
    search.judgements.update(found)


def keep_drawn(kept: Kept, search: Search, count: int, members: Sequence[tuple[Mapping[str, str], str]]) -> None:
    """Keep what a search judged, and values and texts of its members, unless other limits may give more."""
    judged = [
        (number, it, None, False) if isinstance(it, str) else (number, "", it.why, it.own)
        for number, it in search.judgements.items()
        if isinstance(it, str) or not it.is_by_limits
    ]
    if judged:
        kept.put(judged, *_facts_of_judgements(search))
    if not members or (len(members) < count and any(each.is_by_limits for each in search.rejections)):
        return
    rejected = [[why.why, why.own, times] for why, times in search.rejections.items()]
    found = [[dict(values), text] for values, text in members]
    data = {"draws": search.draws, "choices": search.count, "rejected": rejected, "members": found}
    kept.put(data, *_facts_of_search(search, count))


def _facts_of_judgements(search: Search) -> tuple[Any, ...]:
    return "judged", search.source.name, search.source.text, search.seed


def _facts_of_search(search: Search, count: int) -> tuple[Any, ...]:
    return "drawn", search.source.name, search.source.text, search.seed, search.most, count
