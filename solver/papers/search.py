"""The search for members: draws in their order, each rejected by the first thing that does not hold, until enough hold.

Cheap tests come first: answers in decimals from a formula in letters, conditions on the values. What they leave is
judged exactly in processes with limits, and what holds there is solved and verified in the same call. What was found
does not depend on how many draws are tried at a time, nor on how many processes try them.
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any

from solver.derivation import Status
from solver.executors import Executor, Processes
from solver.limits import Exceeded
from solver.papers.constructions.building import constructions_of
from solver.papers.draws import Draw, Draws, holds
from solver.papers.formulas import Formulas
from solver.papers.judging import Rejection
from solver.papers.making import Made, Making, Tried, tried
from solver.problem.family import Family
from solver.problem.members import member_text
from solver.problem.source import Source

MOST_DRAWS = 100_000
DRAWN, CONSTRUCTED = (64, 4096), (4, 32)
"""So many draws are sorted out by formulas at a time, at first and later; those that are constructed take longer."""

AHEAD = 64
"""So many draws are begun at most before the first of them is through."""

BEFORE = Rejection("it was drawn before", own=True)
TWICE = Rejection("it asks the same as another member", own=True)

Tell = Callable[[int, int], object]
"""Is told how many draws were made and how many members were found."""


@dataclass(frozen=True, slots=True)
class Candidate:
    """A member that was found: the number of its draw, counted from 1, the draw, its text, what was made of it."""

    number: int
    draw: Draw
    text: str
    made: Made


@dataclass(slots=True)
class Begun:
    """A draw that is tried: its number from 1, what became of those `before` it since the last one that was.

    Behind the last one stands one without a `draw`.
    """

    number: int
    draw: Draw | None
    before: Counter[Rejection]
    text: str = ""
    known: Made | None = None
    outcome: Rejection | Tried | None = None

    @property
    def is_through(self) -> bool:
        """Whether it is known what becomes of it."""
        return self.draw is None or self.outcome is not None


@dataclass(slots=True)
class Pace:
    """How many of the draws that were tried came out well; so it is guessed how many more are to be tried."""

    tried: int = 0
    well: int = 0

    def note(self, outcome: Rejection | Tried) -> None:
        """Count a draw."""
        self.tried += 1
        self.well += isinstance(outcome, Tried)

    def expected(self, begun: Iterable[Begun]) -> float:
        """Return how many of some draws may be members."""
        share = (self.well + 1) / (self.tried + 1)
        weights = (share if not each.is_through else isinstance(each.outcome, Tried) for each in begun)
        return sum(weights)


@dataclass
class Search:
    """A search of the members of a family; `draws` and `rejections` tell what it took so far, of `count` draws.

    `judgements` are those of draws by their numbers, as far as they are known: why one is no member, or what tells
    whether it asks the same as another one.
    """

    source: Source
    family: Family
    seed: int
    most: int = MOST_DRAWS
    executor: Executor = field(default_factory=Processes)
    tell: Tell = lambda _draws, _found: None
    draws: int = 0
    found: int = 0
    count: int = 0
    rejections: Counter[Rejection] = field(default_factory=Counter)
    judgements: dict[int, Rejection | str] = field(default_factory=dict)

    @property
    def is_exhausted(self) -> bool:
        """Whether all choices of values were drawn."""
        return self.draws >= self.count > 0

    def begin_again(self) -> None:
        """Forget what it took so far."""
        self.draws = self.found = self.count = 0
        self.rejections.clear()

    def candidates(self, wanted: int, making: Making) -> Iterator[Candidate]:
        """Yield the draws for which all holds and what is made of them, in their order, until there are so many."""
        seen: set[str] = set()
        left, begun, pace = self._left(), deque[Begun](), Pace()
        while self.found < wanted:
            for _ in self._tried(left, begun, pace, making, wanted):
                while begun and begun[0].is_through and self.found < wanted:
                    first = begun.popleft()
                    self.rejections += first.before
                    self.draws = first.number
                    if first.draw is None:
                        return
                    if (made := self._accepted(first, seen, making)) is not None:
                        yield Candidate(first.number, first.draw, first.text, made)
                    self.tell(self.draws, self.found)

    def _accepted(self, begun: Begun, seen: set[str], making: Making) -> Made | None:
        """Count a draw that is through; return what was made of it if it is a member, in which case it is `seen`."""
        outcome = begun.outcome
        if isinstance(outcome, Tried):
            self.judgements[begun.number] = outcome.asked
            made = outcome.made or begun.known
            if outcome.asked in seen:
                outcome = TWICE
            elif made is None:
                raise AssertionError("something is made of what is not known")
            else:
                seen.add(outcome.asked)
                making.keep(begun.text, made)
                if made.status is Status.VERIFIED:
                    self.found += 1
                    return made
                outcome = Rejection(f"it is {made.status}: {made.reason}", own=True)
        elif outcome is not None:
            self.judgements[begun.number] = outcome
        if outcome is not None:
            self.rejections[outcome] += 1
        return None

    def _tried(
        self, left: Iterator[Begun], begun: deque[Begun], pace: Pace, making: Making, wanted: int
    ) -> Iterator[None]:
        """Have draws tried by processes, as long as those begun may be too few; yield after each."""
        called: list[Begun] = []

        def calls() -> Iterator[tuple[Any, ...]]:
            while len(begun) < AHEAD and self.found + pace.expected(begun) < wanted:
                if (following := next(left, None)) is None:
                    return
                begun.append(following)
                if (call := self._call(following, making)) is not None:
                    called.append(following)
                    yield call

        for place, result in self.executor.calls(making.limits, tried, calls()):
            outcome = Rejection.by_limits(result.reason) if isinstance(result, Exceeded) else result
            called[place].outcome = outcome
            pace.note(outcome)
            yield
        yield  # of some it was known

    def _call(self, begun: Begun, making: Making) -> tuple[Any, ...] | None:
        """Return the arguments by which a draw is tried, None where it is known what becomes of it."""
        if begun.draw is None:
            return None
        judgement = self.judgements.get(begun.number)
        if isinstance(judgement, Rejection):
            begun.outcome = judgement
            return None
        begun.text = member_text(self.source, begun.draw.texts)
        begun.known = making.known(begun.text)
        if judgement is not None and begun.known is not None:
            begun.outcome = Tried(judgement)
            return None
        conditions = (self.family.required, self.family.nice) if judgement is None else ((), ())
        make = making.make if begun.known is None else None
        return begun.text, self.source.name, *conditions, make, making.wanted

    def _left(self) -> Iterator[Begun]:
        """Yield the draws that formulas and conditions leave, in their order, and one without a draw at the end."""
        formulas = Formulas.of(self.source, self.family)
        draws = Draws(self.family, self.seed, constructions_of(self.source, self.family, self.seed, formulas.pattern))
        self.count = draws.count
        conditions = [each for each in self.family.required if each.chain is not None]
        rejected: Counter[Rejection] = Counter()
        seen: set[tuple[int, ...]] = set()
        size, largest = CONSTRUCTED if draws.constructions else DRAWN
        start, end = 0, min(self.most, self.count)
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
                yield Begun(number, draw, rejected)
                rejected = Counter()
            start, size = start + len(places), min(2 * size, largest)
            self.tell(start, self.found)
        yield Begun(end, None, rejected)
