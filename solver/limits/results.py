"""What a child sends of a result: texts and numbers. The exact answers are taken out of it when they are wanted."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from solver.derivation import Answers, Check, PartResult, Status
from solver.document.checks import plain_check
from solver.document.model import Work
from solver.document.works import lost
from solver.limits.codec import Node, NotPlain, decode, encode
from solver.words import Reason


@dataclass(frozen=True, slots=True)
class Sent:
    """A result as plain data: without steps, its exact answers as nodes (see `codec`), its work in words if wanted.

    An answer that is not mathematics has no nodes, but it stands in the work.
    """

    id: str
    task: str
    method: str
    status: Status
    reason: tuple[str, list[Node]] | None
    seconds: float
    checks: tuple[Check, ...]
    answers: Mapping[str, list[Node]]
    work: Work | None = None

    def result(self) -> PartResult:
        """Return the result with its exact answers, without steps."""
        answers = Answers(**{name: decode(nodes) for name, nodes in self.answers.items()})
        reason = None if self.reason is None else Reason(self.reason[0], decode(self.reason[1]))
        return PartResult(self.id, self.task, self.method, self.status, answers, self.checks, (), reason, self.seconds)


def sent(result: PartResult, work: Work | None = None) -> Sent:
    """Return a result as it is sent. Where it could not be put into words it is as unsolved as its work."""
    if work is not None and work.fault:
        result = lost(result, work.reason)
    answers: dict[str, list[Node]] = {}
    for name, value in result.answers.items():
        try:
            answers[name] = encode(value)
        except NotPlain:
            continue
    checks = tuple(map(plain_check, result.checks))
    reason = _encoded(result.reason) if result.reason is not None else None
    return Sent(result.id, result.task, result.method, result.status, reason, result.seconds, checks, answers, work)


def _encoded(reason: Reason) -> tuple[str, list[Node]]:
    try:
        return reason.kind, encode(reason.values)
    except NotPlain:  # it is told in English
        return "limits/ended", encode({"words": str(reason)})
