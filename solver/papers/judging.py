"""Whether a draw is a member: read, held against what is required of its system, and what is asked found quickly.

All is done with the means of the engine, without steps in words and without checks: a member is verified afterwards,
with what was found here.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from hashlib import sha256
from typing import Any

from solver.derivation import Answers, PartResult, Status, Unsolved
from solver.engine import Finding, Findings, finding, found_by, refusals_of
from solver.lazy import exact
from solver.messages import Messages
from solver.papers.niceness import is_nice
from solver.problem.family import Nice, Required
from solver.problem.model import Part, Problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.problem.systems import NOTHING
from solver.systems import EarlierPart, System
from solver.tasks import catalogue

MEANINGS: Mapping[str, tuple[tuple[str, str, object], ...]] = {
    "controllable": (("controllability", "controllable", True),),
    "observable": (("observability", "observable", True),),
    "minimal": (("controllability", "controllable", True), ("observability", "observable", True)),
    "stable": (("stability", "verdict", "asymptotically stable"),),
    "unstable": (("stability", "verdict", "unstable"),),
}
"""What words about a system mean: the tasks that decide it, their answers, and what these must be."""


UNSOLVABLE = "it cannot be solved: "


@dataclass(frozen=True, slots=True)
class Rejection:
    """Why a draw is no member: what is required as it is written in the file, or words of the program (`own`)."""

    why: str
    own: bool = False

    @classmethod
    def by_limits(cls, reason: str) -> Rejection:
        """Return why a draw is none that met a limit."""
        return cls(UNSOLVABLE + reason, own=True)

    @property
    def is_by_limits(self) -> bool:
        """Whether a limit was met: with others the draw may be a member."""
        return self.own and self.why.startswith(UNSOLVABLE)


@dataclass(frozen=True, slots=True)
class Judged:
    """A problem that seems to be a member, with what its parts were found to be so far."""

    problem: Problem
    found: Findings = field(default_factory=dict)

    @property
    def asked(self) -> str:
        """What tells whether two members ask the same: systems and options, in whatever order poles are given."""
        parts = [
            (part.id, part.task, part.methods, part.prompt, str(part.system), _options(part.options))
            for part in self.problem.parts
        ]
        told = repr((self.problem.statement, str(self.problem.system), parts))
        return sha256(told.encode("utf-8", "surrogatepass")).hexdigest()


def _options(options: Mapping[str, Any]) -> list[tuple[str, str]]:
    found = []
    for name, value in sorted(options.items()):
        unordered = isinstance(value, tuple) and name.endswith("poles")
        found.append((name, str(sorted(map(str, value))) if unordered else str(value)))
    return found


def judged(text: str, name: str, required: Iterable[Required], nice: Iterable[Nice]) -> Rejection | Judged:
    """Return why a draw is no member, or the problem where it seems to be one; `text` is its file."""
    try:
        problem = read_problem(Source(name, text), catalogue())
        messages = Messages(language=problem.display.language)
        for part in problem.parts:
            if refused := refusals_of(part, messages):
                return Rejection(f"part {part.id} cannot be asked: {refused[0][1]}", own=True)
    except InputError as error:
        return Rejection(f"the question cannot be asked: {error.diagnostics[0].message}", own=True)
    words = [each.text for each in required if each.chain is None]
    if rejected := _rejected_by_words(words, systems_of(problem), messages):
        return rejected
    found: dict[tuple[str, str], Finding] = {}
    return _rejected_by_answers(problem, nice, found) or Judged(problem, found)


def systems_of(problem: Problem) -> list[System]:
    """The systems that words are about: that of all parts, or those of the parts where there is none."""
    own = [part.system for part in problem.parts]
    return [problem.system] if problem.system else [each for each in own if not isinstance(each, EarlierPart)]


def _rejected_by_words(words: Iterable[str], systems: Sequence[System], messages: Messages) -> Rejection | None:
    """Return which word is not right of a system, or why that cannot be told."""
    for word in words:
        try:
            if not all(_is(system, word) for system in systems):
                return Rejection(word)
        except (Unsolved, exact.NotExact) as refusal:
            reason = messages.reason(refusal.reason).rstrip(".")
            return Rejection(f"it cannot be told whether it is {word}: {reason}", own=True)
    return None


def _is(system: System, word: str) -> bool:
    """Whether a word is right of a system. Raises Unsolved, NotExact where that cannot be told."""
    if system is NOTHING:
        return True
    for name, answer, expected in MEANINGS[word]:
        task = catalogue()[name]
        part = Part("", name, tuple(task.methods_for(discrete=system.discrete)[:1]), system)
        if str(found_by(part.methods[0], part, {})[1].get(answer)) != str(expected):
            return False
    return True


def _rejected_by_answers(
    problem: Problem, nice: Iterable[Nice], found: dict[tuple[str, str], Finding]
) -> Rejection | None:
    """Return which answer does not come out as it must; `found` gets what is found on the way."""
    known: dict[str, PartResult] = {}
    for each in nice:
        try:
            value = answers_of(each.part, problem, known, found).get(each.answer)
        except (Unsolved, exact.NotExact):
            return Rejection(f"part {each.part} has no solution", own=True)
        if value is None:
            return Rejection(f"part {each.part} has no {each.answer}", own=True)
        if not is_nice(value, each.kind):
            return Rejection(each.text)
    return None


def answers_of(
    name: str,
    problem: Problem,
    known: dict[str, PartResult],
    found: dict[tuple[str, str], Finding] | None = None,
) -> Answers:
    """Return what a part finds by its first method, with the parts that it goes on with.

    `known` has what was found, and keeps it; `found` gets how. Raises Unsolved, NotExact.
    """
    if name not in known:
        part = next(part for part in problem.parts if part.id == name)
        for source in part.sources:
            answers_of(source, problem, known, found)
        method = part.methods[0]
        its = finding(method, part, known)
        if found is not None:
            found[name, method] = its
        known[name] = PartResult(name, part.task, method, Status.VERIFIED, its.answers, (), tuple(its.steps))
    return known[name].answers
