"""The submissions of the corpus, read from its files.

A file is a list of problems. Each has submissions of one value (`right`, `wrong`, `ambiguous`: lists of kind, typed
text and meaning, by part and answer), of values that belong together (`together`), and of several parts (`chains`).
Typed text stands in the answer file as it is here, after the name of the answer. A `right` one without a meaning means
what the first of its list means; an ambiguous one lists what it could mean; what has no meaning cannot be read,
or (`null`) its truth was found by hand alone.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import yaml

from tests.classroom.corpus.judged import is_right, right_together
from tests.hunt.asked import Question, read

FILES = sorted(Path(__file__).parent.glob("data/*.yaml"))
TEXTS, VALUES = (getattr(yaml, f"C{name}", getattr(yaml, name)) for name in ("BaseLoader", "SafeLoader"))
"""Those of libyaml, where it is installed: many times quicker."""


@dataclass(frozen=True)
class Value:
    """One value of a submission: what was typed and what it means; of an ambiguous one, what it could mean."""

    part: str
    answer: str
    typed: str
    means: Any = None


@dataclass(frozen=True)
class Claim:
    """What is true of values together: `right`, `wrong`, `ambiguous`, or of values in a chain `slip` or `follows`."""

    truth: str
    values: tuple[Value, ...]


@dataclass(frozen=True)
class Problem:
    """A problem of the corpus, with its questions as they are judged."""

    name: str
    data: Mapping[str, Any]
    known: Mapping[str, Any] = field(default_factory=dict)

    @cached_property
    def text(self) -> str:
        """The problem file."""
        return yaml.safe_dump(dict(self.data), sort_keys=False, allow_unicode=True)

    @cached_property
    def questions(self) -> dict[str, Question]:
        """The parts by name, each with the system it is about."""
        return {part: self._question(part, asked) for part, asked in self.data["find"].items()}

    def _question(self, part: str, asked: Any) -> Question:
        given = {"task": asked} if isinstance(asked, str) else dict(asked)
        outer = {"system": self.data.get("system", {}), "assume": self.data.get("assume", {})}
        whole = {**outer, "conditions": self.data.get("conditions", ()), **given, **self.known.get(part, {})}
        return read(part, {name: each for name, each in whole.items() if each != ""})


@dataclass(frozen=True)
class Submission:
    """One answer file, and what is true of it."""

    id: str
    kind: str
    problem: Problem
    claims: tuple[Claim, ...]
    own: Mapping[str, Any] = field(default_factory=dict)

    @property
    def answers(self) -> str:
        """The answer file."""
        parts: dict[str, list[Value]] = {}
        for claim in self.claims:
            for value in claim.values:
                parts.setdefault(value.part, []).append(value)
        lines = ["answers:"]
        for part, values in parts.items():
            lines += [f"  {part}:", *(f"    {each.answer}: {_indented(each.typed)}" for each in values)]
        return "\n".join(lines) + "\n"

    def slips(self) -> Iterator[str]:
        """Where the truth that is stated is not the one that the judges find."""
        for claim in self.claims:
            if (found := self._found(claim)) not in (claim.truth, None):
                yield f"{self.id}: stated {claim.truth}, judged {found}: {[each.typed for each in claim.values]}"

    def none_right(self, claim: Claim) -> bool:
        """Whether a value has several readings, all of them wrong."""
        first = claim.values[0]
        readings = first.means or []
        question = self.problem.questions[first.part]
        return len(readings) > 1 and not any(is_right(question, first.answer, each) for each in readings)

    def _found(self, claim: Claim) -> str | None:
        first = claim.values[0]
        question = self.problem.questions[first.part]
        if claim.truth == "ambiguous":
            readings = first.means or []
            count = sum(is_right(question, first.answer, each) for each in readings)
            return "right" if count == 1 else "ambiguous"
        if first.means is None:  # what has no meaning cannot be right
            return None
        if len(claim.values) > 1:
            return "right" if right_together(question, {each.answer: each.means for each in claim.values}) else "wrong"
        if is_right(question, first.answer, first.means):
            return "right"
        if claim.truth == "slip":
            return "slip"
        if first.part in self.own:
            options = {name: each for name, each in {**question.options, **self.own[first.part]}.items() if each != ""}
            if is_right(replace(question, options=options), first.answer, first.means):
                return "follows"
        return "wrong"


def _indented(typed: str) -> str:
    return typed.replace("\n", "\n      ")


def submissions() -> Iterator[Submission]:
    """All submissions of all files."""
    for path in FILES:
        text = path.read_text(encoding="utf-8")
        entries = yaml.load(text, TEXTS)  # noqa: S506 - what is typed stays text
        for entry, data in zip(entries, yaml.load(text, VALUES), strict=True):  # noqa: S506
            yield from _of_problem(Problem(entry["name"], data["problem"], data.get("known", {})), entry, data)


def _of_problem(problem: Problem, entry: Mapping[str, Any], data: Mapping[str, Any]) -> Iterator[Submission]:
    for truth in ("right", "wrong", "ambiguous"):
        for place, rows in entry.get(truth, {}).items():
            part, answer = place.split(".")
            default = rows[0][2] if truth == "right" else None
            for number, row in enumerate(rows, 1):
                means = row[2] if len(row) > 2 else default
                value = Value(part, answer, row[1], None if means == "null" else means)
                name = f"{problem.name} {place} {truth} {number}"
                yield Submission(name, row[0], problem, (Claim(truth, (value,)),))
    for number, case in enumerate(entry.get("together", ()), 1):
        values = tuple(Value(case["part"], name, *pair) for name, pair in case["answers"].items())
        name = f"{problem.name} {case['part']} together {number}"
        yield Submission(name, case["kind"], problem, (Claim(case["truth"], values),))
    for number, case in enumerate(entry.get("chains", ()), 1):
        claims = []
        for place, (truth, text, means) in case["answers"].items():
            claims.append(Claim(truth, (Value(*place.split("."), text, means),)))
        own = data["chains"][number - 1].get("own", {})
        yield Submission(f"{problem.name} chain {number}", case["kind"], problem, tuple(claims), own)
