"""What a derivation is made of: steps, claims, answers, checks. Data only; no topic is known here."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from solver.derivation.figures import Figure
from solver.words import Reason, Told


class Status(StrEnum):
    """How a part, or the whole problem, ended; listed from best to worst."""

    VERIFIED = "verified"
    UNSOLVED = "unsolved"
    FAILED = "failed"

    @staticmethod
    def worst(statuses: list[Status]) -> Status:
        """Return the worst of some statuses (`verified` if there are none)."""
        return max(statuses, key=list(Status).index, default=Status.VERIFIED)


class Unsolved(Told):
    """The question has no answer, or not by this method; the reason says why. No error of the program."""


@dataclass(frozen=True, slots=True)
class Claim:
    """An equality that a step displays. The engine evaluates both sides numerically at random points.

    `left` is the formula as stated (see `solver.stated`), `right` what it was found to be; each is an expression, a
    matrix or a `Stated` formula. `says` names the equality in the table of checks (Markdown with $math$).
    """

    left: Any
    right: Any
    says: str = ""


class Step:
    """One line of reasoning as data: a kind, exact values, the equalities claimed, and substeps.

    The wording macro of the step's kind turns it into prose; it finds the values by their names.
    A step without claims must say in `unclaimed` why there is nothing to check.
    `detail` is the least level of detail at which the step is shown: "brief", "full" or "tutor".
    `figures` are shown below its text.
    """

    __slots__ = ("claims", "detail", "figures", "kind", "steps", "unclaimed", "values", "wording")

    def __init__(
        self,
        kind: str,
        /,
        *,
        claims: Mapping[str, Claim] | None = None,
        steps: tuple[Step, ...] = (),
        unclaimed: str = "",
        detail: str = "brief",
        figures: tuple[Figure, ...] = (),
        **values: Any,
    ) -> None:
        self.kind = kind
        self.figures = figures
        self.values: Mapping[str, Any] = values
        self.claims: Mapping[str, Claim] = claims or {}
        self.steps = steps
        self.unclaimed = unclaimed
        self.detail = detail
        self.wording = ""  # "<folder>/<file>" under templates/wording; set by the method or lemma that yields it

    def __repr__(self) -> str:
        return f"Step({self.wording}:{self.kind})"

    def walk(self) -> Iterator[Step]:
        """This step and all its substeps, in the order of reading."""
        yield self
        for step in self.steps:
            yield from step.walk()


class Answers(dict[str, Any]):
    """The answers of a part by name: sympy objects, lists, truth values or texts, as the catalogue says."""

    def __init__(self, **answers: Any) -> None:
        super().__init__(answers)


class CheckStatus(StrEnum):
    """How one check ended."""

    PASSED = "passed"
    FAILED = "failed"
    SKIPPED = "skipped"


@dataclass(frozen=True, slots=True)
class Check:
    """One line of the table of checks: what was checked, by what, and with what result.

    `judges` names the answers that the check judges; none for an equality displayed in a step. `step` is the number
    of the step, counted from 1 among those of the part, that displays the equality; 0 for a check of answers. `item` is
    the number of the item of a list, counted from 1, that the check judges by itself; 0 for the whole. `sides` are
    those of an equality that failed.
    """

    claim: str
    oracle: str
    residual: float | None
    tolerance: float | None
    status: CheckStatus
    reason: str = ""
    judges: tuple[str, ...] = ()
    step: int = 0
    item: int = 0
    sides: tuple[Any, Any] | None = field(default=None, compare=False, repr=False)

    def displayed_in(self, step: int) -> Check:
        """Return the check as that of an equality which the step of this number displays."""
        result = self.claim, self.oracle, self.residual, self.tolerance, self.status, self.reason
        return Check(*result, self.judges, step, self.item, self.sides)

    @staticmethod
    def within(claim: str, oracle: str, residual: float, tolerance: float, *, answer: str = "") -> Check:
        """Passed if the residual is a number not above the tolerance, else failed. `answer`: the one it judges."""
        passed = residual <= tolerance  # False for nan
        status = CheckStatus.PASSED if passed else CheckStatus.FAILED
        return Check(claim, oracle, residual, tolerance, status, judges=_named(answer))

    @staticmethod
    def that(claim: str, oracle: str, holds: bool, *, answer: str = "") -> Check:
        """Return a check without a number: it holds or it does not. `answer`: the one it judges."""
        status = CheckStatus.PASSED if holds else CheckStatus.FAILED
        return Check(claim, oracle, None, None, status, judges=_named(answer))

    @staticmethod
    def skipped(claim: str, oracle: str, reason: str, *, answer: str = "") -> Check:
        """Return a check that could not be made, with the reason. `answer`: the one it judges."""
        return Check(claim, oracle, None, None, CheckStatus.SKIPPED, reason, _named(answer))


def _named(answer: str) -> tuple[str, ...]:
    return (answer,) if answer else ()


@dataclass(frozen=True, slots=True)
class PartResult:
    """What became of one part by one method."""

    id: str
    task: str
    method: str
    status: Status
    answers: Answers = field(default_factory=Answers)
    checks: tuple[Check, ...] = ()
    steps: tuple[Step, ...] = ()
    reason: Reason | None = None
    seconds: float = 0.0
