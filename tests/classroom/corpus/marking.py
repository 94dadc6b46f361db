"""How the program marks the submissions of the corpus."""

from collections.abc import Iterator
from dataclasses import dataclass

from solver.problem.source import InputError
from tests.classroom.corpus.cases import Claim, Submission
from tests.helpers.marked import marked


@dataclass(frozen=True)
class Outcome:
    """What the program says of values of which something is true."""

    submission: Submission
    claim: Claim
    said: str
    read: str

    @property
    def name(self) -> str:
        """The submission, and in a chain the value."""
        first = self.claim.values[0]
        chain = f" {first.part}.{first.answer}" if len(self.submission.claims) > 1 else ""
        return f"{self.submission.id}{chain} [{self.submission.kind}]"

    @property
    def false_positive(self) -> bool:
        """Marked correct though it is wrong, or has several readings."""
        return self.said == "correct" and self.claim.truth in ("wrong", "slip", "ambiguous")

    @property
    def false_negative(self) -> bool:
        """Not marked correct though it is right."""
        return self.said != "correct" and self.claim.truth in ("right", "follows")

    @property
    def guessed(self) -> bool:
        """Marked wrong though it can be read in several ways, not all of them wrong, or in none."""
        guessed = self.claim.truth == "ambiguous" and self.said == "wrong"
        return guessed and not self.submission.none_right(self.claim)

    def __str__(self) -> str:
        typed = "; ".join(f"{each.answer}: {each.typed}" for each in self.claim.values)
        return f"{self.name} {typed!r}: {self.claim.truth}, said {self.said}{self.read}"


def outcomes(submission: Submission) -> Iterator[Outcome]:
    """What the program says of all that a submission claims."""
    try:
        parts = marked(submission.problem.text, submission.answers)
    except InputError as fault:
        for claim in submission.claims:
            yield Outcome(submission, claim, "refused", f" ({str(fault).splitlines()[0]})")
        return
    for claim in submission.claims:
        found = [parts[each.part].answers.get(each.answer) for each in claim.values]
        verdicts = [each.verdict if each is not None else "not judged" for each in found]
        said = "wrong" if "wrong" in verdicts else "correct" if set(verdicts) == {"correct"} else "not judged"
        notes = [str(each.reason) for each in found if each is not None and each.verdict != "correct" and each.reason]
        yield Outcome(submission, claim, said, f" ({'; '.join(notes)})" if notes else "")
