"""The search for members: draws in their order, each rejected by the first thing that does not hold, until enough hold.

Cheap tests come first: answers in decimals from a formula in letters, conditions on the values, then (in processes with
limits) the system and the answers asked for, exactly. What was found does not depend on how many draws are
judged at a time, nor on how many processes judge them.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

from solver.executors import Executor, Processes
from solver.limits import Exceeded, Limits
from solver.papers.constructions.building import constructions_of
from solver.papers.draws import Draw, Draws, holds
from solver.papers.formulas import Formulas
from solver.papers.judging import Rejection, judged
from solver.problem.family import Family
from solver.problem.members import member_text
from solver.problem.model import Problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

MOST_DRAWS = 100_000
FIRST, LARGEST = 64, 4096
"""So many draws are sorted out by formulas at a time, at first and later."""

TOGETHER = 16
"""So many draws are judged exactly between two looks at how many are wanted."""

BEFORE = Rejection("it was drawn before", own=True)

Tell = Callable[[int, int], object]
"""Is told how many draws were made and how many members were found."""


@dataclass(frozen=True, slots=True)
class Candidate:
    """A draw that holds what is required, as a problem; `number` counts the draws from 1."""

    number: int
    draw: Draw
    text: str
    problem: Problem


@dataclass
class Search:
    """A search of the members of a family; `draws` and `rejections` tell what it took so far, of `count` draws.

    `judgements` are those of draws by their numbers, as far as they are known.
    """

    source: Source
    family: Family
    seed: int
    limits: Limits = field(default_factory=Limits)
    most: int = MOST_DRAWS
    executor: Executor = field(default_factory=Processes)
    tell: Tell = lambda _draws, _found: None
    draws: int = 0
    found: int = 0
    count: int = 0
    rejections: Counter[Rejection] = field(default_factory=Counter)
    judgements: dict[int, Rejection | None] = field(default_factory=dict)

    @property
    def is_exhausted(self) -> bool:
        """Whether all choices of values were drawn."""
        return self.draws >= self.count > 0

    def candidates(self) -> Iterator[Candidate]:
        """Yield the draws for which all holds, in their order; whoever takes one may reject it."""
        seen: set[str] = set()
        for number, draw, text, judgement in self._judged():
            self.draws, rejection = number, judgement
            if rejection is None:
                problem = read_problem(Source(self.source.name, text), catalogue())
                if (asked := _question(problem)) in seen:
                    rejection = Rejection("it asks the same as another member", own=True)
            self.tell(number, self.found)
            if rejection is not None:
                self.reject(rejection)
                continue
            seen.add(asked)
            self.found += 1
            yield Candidate(number, draw, text, problem)
        self.draws = min(self.most, self.count)

    def begin_again(self) -> None:
        """Forget what it took so far."""
        self.draws = self.found = self.count = 0
        self.rejections.clear()

    def reject(self, rejection: Rejection) -> None:
        """Count a draw that is no member."""
        self.rejections[rejection] += 1

    def take_back(self, rejection: Rejection) -> None:
        """Reject a candidate that was yielded."""
        self.found -= 1
        self.reject(rejection)

    def _judged(self) -> Iterator[tuple[int, Draw, str, Rejection | None]]:
        """Yield the draws that the cheap tests leave, with why they are rejected; those before are counted."""
        pending: list[tuple[int, Draw, Counter[Rejection]]] = []
        for number, draw, before in self._left():
            pending.append((number, draw, before))
            if len(pending) == TOGETHER:
                yield from self._exactly(pending)
                pending = []
        yield from self._exactly(pending)

    def _exactly(
        self, pending: Sequence[tuple[int, Draw, Counter[Rejection]]]
    ) -> Iterator[tuple[int, Draw, str, Rejection | None]]:
        """Judge some draws in processes; yield them in their order."""
        texts = [member_text(self.source, draw.texts) for _, draw, _ in pending]
        new = [place for place, (number, _, _) in enumerate(pending) if number not in self.judgements]
        calls = [(texts[place], self.source.name, self.family.required, self.family.nice) for place in new]
        for each, result in self.executor.calls(self.limits, judged, calls):
            by_limits = isinstance(result, Exceeded)
            self.judgements[pending[new[each]][0]] = Rejection.by_limits(result.reason) if by_limits else result
        for place, (number, draw, before) in enumerate(pending):
            self.rejections += before
            yield number, draw, texts[place], self.judgements[number]

    def _left(self) -> Iterator[tuple[int, Draw, Counter[Rejection]]]:
        """Yield the draws that formulas and conditions leave, with what became of those since the one before.

        The last ones, behind which there is none, are counted at the end.
        """
        formulas = Formulas.of(self.source, self.family)
        draws = Draws(self.family, self.seed, constructions_of(self.source, self.family, self.seed, formulas.pattern))
        self.count = draws.count
        conditions = [each for each in self.family.required if each.chain is not None]
        rejected: Counter[Rejection] = Counter()
        seen: set[tuple[int, ...]] = set()
        start, size, end = 0, FIRST, min(self.most, self.count)
        while start < end:
            places = [draws.places(number) for number in range(start, min(start + size, end))]
            for number, (at, far) in enumerate(zip(places, formulas.rejected(places), strict=True), start + 1):
                if draws.constructions and tuple(at) in seen:
                    rejected[BEFORE] += 1
                    continue
                seen.add(tuple(at))
                draw = draws.at(at)
                broken = (each.text for each in conditions if not holds(each, draw.values))
                if why := far or next(broken, ""):
                    rejected[Rejection(why)] += 1
                    continue
                yield number, draw, rejected
                rejected = Counter()
            start, size = start + len(places), min(2 * size, LARGEST)
            self.tell(start, self.found)
        self.rejections += rejected


def _question(problem: Problem) -> str:
    """Return what tells whether two members ask the same: systems and options, in whatever order poles are given."""
    parts = [
        (part.id, part.task, part.methods, part.prompt, str(part.system), _options(part.options))
        for part in problem.parts
    ]
    return repr((problem.statement, str(problem.system), parts))


def _options(options: Any) -> list[tuple[str, str]]:
    found = []
    for name, value in sorted(options.items()):
        unordered = isinstance(value, tuple) and name.endswith("poles")
        found.append((name, str(sorted(map(str, value))) if unordered else str(value)))
    return found
