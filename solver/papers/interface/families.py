"""Families in Python: `solver.variants(path_or_text, count=…, seed=…)`.

>>> import solver
>>> for variant in solver.variants("problems/families/integer-regulators.yaml", count=3, seed=7):
...     print(variant.values, variant.solve().answers["a"]["K"])
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from solver.api import solve, source_of
from solver.document.model import Document
from solver.executors import Processes
from solver.limits import Limits
from solver.papers.families import family_of, members
from solver.papers.making import Making, Wanted, made
from solver.papers.search import MOST_DRAWS, Search
from solver.papers.telling import shortage
from solver.problem.reader import file_stem, read_problem
from solver.progress import Tell, Watch, shown
from solver.tasks import catalogue


@dataclass(frozen=True, slots=True)
class Variant:
    """A member of a family: its number from 1, the values drawn as they are written, its text as a problem file."""

    number: int
    values: Mapping[str, str]
    text: str

    def solve(self, **told: Any) -> Document:
        """Solve it; the arguments are those of `solver.solve`."""
        return solve(self.text, **told)


def variants(
    problem: str | Path | Mapping[str, Any],
    *,
    count: int,
    seed: int = 1,
    draws: int = MOST_DRAWS,
    jobs: int = 1,
    progress: Watch = None,
    **limits: Any,
) -> list[Variant]:
    """Return verified members of the family that a problem tells, given as `solve` takes a problem.

    The same seed gives the same members on every machine. At most so many `draws` are made, by `jobs` processes;
    `seconds` and `megabytes` are the limits of a part, `progress` as for `solve`. Raises
    `solver.problem.source.InputError` where the problem is at fault or tells no family, and where there are fewer
    members than asked for.
    """
    source = source_of(problem)
    read = read_problem(source, catalogue())
    family, each = family_of(read), Limits(**limits)
    making = Making(made, Wanted(limits=each), each.times(read.solutions))
    with Processes(jobs) as executor, shown(progress) as tell:
        told = partial(_told, tell, count)
        search = Search(source, family, seed, draws, executor, told)
        found = list(members(search, count, making, file_stem(source.name)))
        told(search.draws, len(found))
    if len(found) < count:
        raise shortage(search, source, count)
    return [Variant(member.number, member.values, member.text) for member in found]


def _told(tell: Tell, count: int, draws: int, found: int) -> None:
    tell(found, count, f"{draws} draws")


__all__ = ["Variant", "variants"]
