"""A page tells everything once: what stands above word for word is referred to, or left out where it explains.

Works are complete, and JSON shows them so. Pages show what `told_once` makes of all parts together.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby, takewhile
from operator import itemgetter

from solver.document.checks import Say, check_rows
from solver.document.model import CheckRow, Reference, Work, WorkAnswer, WorkStep
from solver.document.paragraphs import OPERATION, explains, leads_in, remarks
from solver.document.results import (
    RESULT,
    at_the_end,
    chains_in,
    ends_in,
    only_repeats,
    results_of,
    to_go_on_with,
    value_of,
)
from solver.render.pointing import linked
from solver.render.prose import plain
from solver.words import Phrase

LEAST_SAVED = 60
"""Characters that a reference must save."""

LEAST_REPEATED = 30
"""Characters of a result that is left to the next step where that one begins with it."""


def told_once(parts: Sequence[Work], say: Say, problem: str = "") -> tuple[Work, ...]:
    """Return the parts as a page shows them, below what the problem gives: first in full, later by reference."""
    page = _Page(say, frozenset(part.id for part in parts if part.again), problem)
    return tuple(page.work(part) for part in parts)


@dataclass(frozen=True, slots=True)
class _Place:
    """Where something stands in full: the part, the number of its step there, and those of the substeps down to it."""

    part: Work
    number: int
    below: tuple[int, ...] = ()


@dataclass
class _Page:
    """What has been told so far, and where. `several` are the parts that are solved by several methods."""

    say: Say
    several: frozenset[str]
    problem: str
    steps: dict[str, _Place] = field(default_factory=dict)
    substeps: dict[str, _Place] = field(default_factory=dict)
    figures: dict[str, _Place] = field(default_factory=dict)
    given: dict[str, Work] = field(default_factory=dict)
    sources: set[tuple[str, str]] = field(default_factory=set)
    boxed: dict[tuple[str, str], Work] = field(default_factory=dict)
    found: dict[tuple[str, str, str], Work] = field(default_factory=dict)
    results: list[tuple[_Place, str]] = field(default_factory=list)
    blocks: dict[tuple[str, str], _Place] = field(default_factory=dict)

    def work(self, part: Work) -> Work:
        """Return a part with references in place of what stands above."""
        steps = self._steps(part)
        told = replace(
            part, given=self._given(part), source=self._source(part), steps=steps, rows=tuple(self._rows(part, steps))
        )
        for number, step in enumerate(steps, start=1):
            self.results += [(_Place(told, number), chain) for chain in chains_in(step)]
        return self._answered(told)

    def _steps(self, part: Work) -> tuple[WorkStep, ...]:
        """Return the steps, those in a row that stand above as one that refers to them."""
        shown: list[WorkStep] = []
        rest = tuple(each for each in part.steps if not only_repeats(each, self.problem + "\n\n" + part.given))
        while rest:
            run = tuple(takewhile(self._stands_above, rest))
            referring = self._referring(part, run, rest[len(run) :]) if run else None
            if referring is None or _length(referring) + LEAST_SAVED > sum(map(_length, run)):
                run = rest[:1]
                self.steps[_key(rest[0])] = place = _Place(part, len(shown) + 1)
                referring = self._shortened(rest[0], place)
            shown.append(referring)
            rest = rest[len(run) :]
        return tuple(shown)

    def _rows(self, part: Work, steps: Sequence[WorkStep]) -> Iterable[CheckRow]:
        """Return the table of checks, by the numbers of the steps that are shown."""
        as_it_was = [step.covers for step in steps] == [step.covers for step in part.steps]
        return part.rows if as_it_was or not part.checks else check_rows(part.checks, steps, self.say)

    def _given(self, part: Work) -> str:
        """Return what is given, or where it was given before."""
        above = self.given.setdefault(part.given, part)
        if part.again or above is part or len(part.given) < LEAST_SAVED:
            return part.given
        return self.say(Phrase("Given as in {part}.", part=self._reference(part, above, ()).place))

    def _source(self, part: Work) -> str:
        """Return where the method is from, if it is new on the page."""
        known = (part.method_title, part.source) in self.sources
        self.sources.add((part.method_title, part.source))
        return "" if known else part.source

    def _answered(self, part: Work) -> Work:
        """Return a part that points at answers told above: those found on the way, all where a method found the same.

        A method that has found in its steps some of what another one has in its box says that it is the same.
        """
        answers = tuple(answer if answer.asked else self._pointed_at(part, answer) for answer in part.answers)
        told = replace(part, answers=answers)
        for answer in answers:
            self.found.setdefault(_known_as(part, answer), told)
        first = self.boxed.setdefault((part.id, part.case), told)
        named = [answer for answer in told.boxed if answer.name]
        derived = not named or any(self._place_of(part, answer, own=True) for answer in named)
        if part.again and told.boxed and derived and all(answer in first.boxed for answer in told.boxed):
            return replace(told, same=self._reference(part, first, ()))
        return told

    def _pointed_at(self, part: Work, answer: WorkAnswer) -> WorkAnswer:
        place = self._place_of(part, answer) or self._telling(part, answer)
        above = self.found.get(_known_as(part, answer))  # another question about the system has told it
        if not place and not above:
            return answer
        return replace(answer, stands=self._reference(part, *(place.part, [place.number]) if place else (above, ())))

    def _place_of(self, part: Work, answer: WorkAnswer, *, own: bool = False) -> _Place | None:
        """Return the last step of a part, by any method or by its own, that ends in the answer."""
        for place, chain in reversed(self.results):
            mine = place.part.anchor == part.anchor if own else (place.part.id, place.part.case) == (part.id, part.case)
            if mine and ends_in(chain, answer):
                return place
        return None

    @staticmethod
    def _telling(part: Work, answer: WorkAnswer) -> _Place | None:
        """Return the last step of the best of the kinds that tell an answer in a form of their own."""
        numbered = [(each.kind, number) for number, each in enumerate(part.steps, 1) if each.markdown or each.steps]
        numbers = (number for kind in answer.told for told, number in reversed(numbered) if told == kind)
        number = next(numbers, None)
        return None if number is None else _Place(part, number)

    def _stands_above(self, step: WorkStep) -> bool:
        return _key(step) in self.steps

    def _referring(self, part: Work, run: Sequence[WorkStep], rest: Sequence[WorkStep]) -> WorkStep:
        """Return one step for several that stand above: where they do, and the results that the rest goes on with.

        It is titled by the first and the last of them.
        """
        results = results_of(run)
        value = value_of(results[-1]) if results else ""
        goes_on = rest or not part.found
        told_next = len(value) >= LEAST_REPEATED and any(value in each.markdown for each in rest[:1])
        return WorkStep(
            run[-1].kind,
            " … ".join(dict.fromkeys(run[i].title for i in (0, -1))),
            to_go_on_with(results) if goes_on and not told_next else "",
            covers=tuple(number for step in run for number in step.covers),
            refers=tuple(self._references(part, [self.steps[_key(step)] for step in run])),
        )

    def _references(self, part: Work, places: Sequence[_Place]) -> Iterator[Reference]:
        """Yield a reference to each of the parts in which the places are."""
        parts = {place.part.anchor: place.part for place in places}.values()
        several = any(there.id != part.id for there in parts)
        for there in parts:
            numbers = sorted(place.number for place in places if place.part is there)
            yield self._reference(part, there, numbers, named=several)

    def _reference(
        self, part: Work, there: Work, numbers: Sequence[int], *, named: bool = False, below: Sequence[int] = ()
    ) -> Reference:
        """Return a reference to steps there, or `below` one; the part's own name is left out unless it is `named`."""
        places = [f"({plain(there.letter)})"] if named or there.id != part.id else []
        if there.case and there.anchor != part.anchor:
            places.append(Phrase("the case {case}", case=f"`{there.case}`"))
        if there.id in self.several and there.anchor != part.anchor:
            places.append(Phrase("“{method}”", method=plain(there.method_title)))
        if numbers:
            listed = ".".join([_listed(numbers), *map(str, below)])
            places.append(Phrase("steps {numbers}" if numbers[1:] else "step {numbers}", numbers=listed))
        return Reference(there.anchor, tuple(numbers), ", ".join(map(self.say, places)))

    def _shortened(self, step: WorkStep, place: _Place, path: tuple[int, ...] = ()) -> WorkStep:
        """Return a step without what stands above of its explanations, its substeps and its figures."""
        drawn = [figure for figure in step.figures if self.figures.setdefault(repr(figure), place) == place]
        above = [self.figures[repr(figure)] for figure in step.figures if figure not in drawn]
        return replace(
            step,
            markdown=self._unrepeated(step, place),
            steps=tuple(self._below(each, place, (*path, i)) for i, each in enumerate(step.steps, 1)),
            figures=tuple(drawn),
            pictured=tuple(self._reference(place.part, each.part, [each.number]) for each in above),
        )

    def _below(self, step: WorkStep, place: _Place, path: tuple[int, ...]) -> WorkStep:
        """Return a substep, or where it stands above."""
        above = self.substeps.setdefault(_key(step), replace(place, below=path))
        if replace(above, below=()) == place or _length(step) < LEAST_SAVED:
            return self._shortened(step, place, path)
        refers = self._reference(place.part, above.part, [above.number], below=above.below)
        return WorkStep(step.kind, step.title, "", refers=(refers,))

    def _unrepeated(self, step: WorkStep, place: _Place) -> str:
        """Return the text of a step without what stands in one of its kind above, and note what does not.

        What follows the last display of a step concludes, and stays, but for remarks.
        """
        blocks = step.markdown.split("\n\n")
        last = max((i for i, block in enumerate(blocks) if "$$" in block or step.steps), default=-1)
        above = [self.blocks.get((step.kind, block)) for block in blocks[: last + 1]]
        shown: list[str] = []
        told: list[_Place] = []
        for there, group in groupby(zip(above, blocks, strict=False), key=itemgetter(0)):
            found = [block for _, block in group]
            left, referred = (
                (found, False) if there is None else self._abridged(found, place, there, again=there in told)
            )
            told += [there] if there is not None and referred else []
            headed = not shown and len(found) == 1 and leads_in(found[0])  # then the title of the step leads in
            shown += [] if there is not None and left == found and headed else left
        shown += [block for block in blocks[last + 1 :] if not (remarks(block) and (step.kind, block) in self.blocks)]
        for block in blocks:
            self.blocks.setdefault((step.kind, block), place)
        return "\n\n".join(shown)

    def _abridged(self, blocks: list[str], place: _Place, above: _Place, *, again: bool) -> tuple[list[str], bool]:
        """Return less in place of blocks that stand above, and whether it refers to them: explanations need no word.

        A step does not refer to itself, and what was done to other rows is done to these again. What was referred to
        in this step is not named `again`.
        """
        unexplained = [block for block in blocks if not explains(block)]
        if not unexplained or place == above or any(OPERATION.search(block) for block in blocks):
            return (blocks if unexplained else []), False
        goes_on = to_go_on_with(at_the_end(blocks) if RESULT.fullmatch(blocks[-1]) else [])
        there = self._reference(place.part, above.part, [above.number])
        follows = goes_on or not RESULT.fullmatch(blocks[-1])
        phrase = Phrase("As in {places}:" if follows else "As in {places}.", places=linked(there))
        left = [*([] if again else [self.say(phrase)]), *([goes_on] if goes_on else [])]
        length = sum(map(len, left)) - len(linked(there)) + len(there.place)
        shorter = length + LEAST_SAVED <= sum(map(len, blocks))
        return (left, True) if shorter else (unexplained, False)


def _known_as(part: Work, answer: WorkAnswer) -> tuple[str, str, str]:
    """Return by what an answer about a system is known on a page: what is given, what it means and what it is."""
    return part.given, answer.doc, answer.equation


def _key(step: WorkStep) -> str:
    """Return all that a reader sees of a step."""
    return repr((step.title, step.markdown, step.figures, [_key(each) for each in step.steps]))


def _length(step: WorkStep) -> int:
    """Count what a reader reads of a step."""
    own = len(step.title) + len(step.markdown) + sum(len(each.place) for each in step.refers)
    return own + sum(map(_length, step.steps))


def _listed(numbers: Sequence[int]) -> str:
    """Return numbers in order as a list: "1–3, 5"."""
    rows: list[list[int]] = []
    for number in numbers:
        if rows and rows[-1][-1] == number - 1:
            rows[-1].append(number)
        else:
            rows.append([number])
    return ", ".join(f"{row[0]}–{row[-1]}" if row[1:] else str(row[0]) for row in rows)
