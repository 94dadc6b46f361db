"""Values that are wrong only together: the fewest are blamed whose replacement makes the others right."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, islice, product

from solver.classroom.following.within import OwnAnswers
from solver.classroom.judging.entries import all_right, entrywise
from solver.classroom.judging.question import Question
from solver.classroom.judging.verdict import judge
from solver.classroom.submitted import Submitted
from solver.classroom.verdicts import AnswerVerdict, Verdict

Values = Mapping[str, Submitted]
Verdicts = dict[str, AnswerVerdict]

MOST_TRIED = 24
"""Replacements that are tried."""


def blamed(question: Question, values: Values, verdicts: Verdicts) -> Verdicts:
    """Return the verdicts with only those wrong that must be; of equal numbers the later answers of the task.

    What is wrong by itself stays so; what is determined by the question is right where it is so by itself. Others are
    replaced by what follows from the rest, or by ours; their entries are those of the replacement, or not.
    """
    doubtful = [name for name in question.task.answers if name in values and not _is_right(verdicts[name])]
    if len(doubtful) < 2:
        return verdicts
    each = {name: judge(question, {name: values[name]})[name] for name in doubtful}
    answers = question.task.answers
    determined = {
        name: own for name, own in each.items() if _is_right(own) and not answers[name].is_free(question.given)
    }
    verdicts, doubtful = {**verdicts, **determined}, [name for name in doubtful if name not in determined]
    alone = [name for name in doubtful if each[name].verdict is Verdict.WRONG]
    together = [name for name in doubtful if name not in alone and verdicts[name].verdict is Verdict.WRONG]
    for chosen in islice(_replaced(question, values, alone, together), MOST_TRIED):
        again = judge(question, {**values, **chosen})
        if all(map(_is_right, again.values())):
            told = {
                name: _with_entries(question, right, values[name], verdicts[name]) for name, right in chosen.items()
            }
            return {**again, **told}
    return verdicts


def _replaced(
    question: Question, values: Values, alone: Sequence[str], together: Sequence[str]
) -> Iterator[dict[str, Submitted]]:
    """Yield replacements of what is wrong alone and of the fewest that are wrong together, the later ones first."""
    sizes = range(1, len(together)) if together else range(1)
    for size in sizes:
        for others in combinations(reversed(together), size):
            names = [*alone, *others]
            rest = OwnAnswers(question, {name: each for name, each in values.items() if name not in names})
            for chosen in product(*(rest.replacements(name) for name in names)):
                yield dict(zip(names, chosen, strict=True))


def _with_entries(question: Question, right: Submitted, each: Submitted, verdict: AnswerVerdict) -> AnswerVerdict:
    """The verdict of a blamed value; those of its entries are wrong that the right value changes."""
    entries = entrywise(each, right.value, ordered=question.task.answers[verdict.name].ordered)
    return verdict if entries is None or all_right(entries) else replace(verdict, entries=entries)


def _is_right(verdict: AnswerVerdict) -> bool:
    return verdict.verdict is Verdict.CORRECT
