"""Wrong values judged again with the student's own earlier values, of earlier parts and of the same one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import chain

from solver.classroom.following.between import OwnResults, Source
from solver.classroom.following.blame import blamed
from solver.classroom.following.within import OwnAnswers
from solver.classroom.judging.entries import all_right
from solver.classroom.judging.question import Question
from solver.classroom.judging.verdict import judge
from solver.classroom.submitted import Submitted
from solver.classroom.verdicts import AnswerVerdict, Verdict
from solver.problem.model import Part
from solver.words import Reason

Verdicts = dict[str, AnswerVerdict]


def followed(
    part: Part, question: Question, values: Mapping[str, Submitted], verdicts: Verdicts, own: OwnResults
) -> Verdicts:
    """Return the verdicts with those right that follow from own values, and with what is right of the others.

    `verdicts` are those to the question as it is asked.
    """
    found = blamed(question, values, verdicts)
    for asked, sources in chain([(question, ())], own.questions(part)):
        doubtful = [name for name, verdict in found.items() if verdict.verdict is not Verdict.CORRECT]
        if not doubtful:
            break
        again = blamed(asked, values, judge(asked, values)) if sources else found
        answers = OwnAnswers(asked, values)
        for name in doubtful:
            for verdict, of in _candidates(part, name, again[name], answers):
                found[name] = _better(found[name], verdict, [*sources, *of])
    return found


def _candidates(
    part: Part, name: str, again: AnswerVerdict, answers: OwnAnswers
) -> Iterator[tuple[AnswerVerdict, list[Source]]]:
    """Yield the verdict to a question, then those by what follows from other answers to it, up to a right one."""
    yield again, []
    if again.verdict is Verdict.CORRECT:
        return
    for reading, entries, of in answers.compared(name):
        right = all_right(entries)
        which = Verdict.CORRECT if right else Verdict.WRONG
        yield (
            replace(again, verdict=which, value=reading.value, reason="", entries=entries),
            [(part.id, each) for each in of],
        )
        if right:
            return


def _better(found: AnswerVerdict, other: AnswerVerdict, sources: list[Source]) -> AnswerVerdict:
    """The verdict by own values where it is right, or where more entries are."""
    if not sources or found.verdict is Verdict.CORRECT:
        return found
    own = [{"name": name, "part": part} for part, name in dict.fromkeys(sources)]
    if other.verdict is Verdict.CORRECT:
        return replace(other, note=Reason("marking/with_your_own_answer", {"own": own}), follows=True)
    if found.verdict is other.verdict is Verdict.WRONG and other.share > found.share:
        note = Reason("marking/partly_with_your_own_answer", {"own": own})
        return replace(found, entries=other.entries, note=note)
    return found
