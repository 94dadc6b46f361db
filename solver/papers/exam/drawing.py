"""What is asked in each variant: of a family a member each, drawn as everywhere; of other problems the same in all."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, TypeVar

from solver.derivation import Status
from solver.document.model import Presentation
from solver.executors import Executor, Processes
from solver.limits import Exceeded, Limits
from solver.papers.again import members_again
from solver.papers.exam.model import Exam, Question
from solver.papers.exam.question import Asked, QuestionMade
from solver.papers.exam.reading import SeveralAtFault
from solver.papers.exam.telling import question_made
from solver.papers.judging import Judged
from solver.papers.kept import NOTHING, Kept, MadeBefore, facts_of
from solver.papers.making import Made, WronglyAsked, made_of
from solver.papers.search import MOST_DRAWS, Search, Tell
from solver.papers.telling import shortage
from solver.problem.refusals import refuse
from solver.problem.source import Diagnostic, InputError


@dataclass(frozen=True, slots=True)
class Means:
    """How papers are made: how the key is told, what a part may take, who makes the calls, how many draws.

    `space` are the millimetres left blank for each mark of a part; None leaves no space for answers. `kept` knows what
    was made before. With `partly` a question may have parts without a solution, where it is the same in all variants.
    `make` makes of the text of a question what is wanted of it, for which it may take `factor` times the limits.
    """

    presentation: Presentation = field(default_factory=lambda: Presentation("key"))
    limits: Limits = field(default_factory=Limits)
    executor: Executor = field(default_factory=Processes)
    draws: int = MOST_DRAWS
    space: Fraction | None = None
    kept: Kept = NOTHING
    partly: bool = False
    make: Callable[[Judged, str, Any], QuestionMade] = question_made
    factor: int = 1


@dataclass(frozen=True, slots=True)
class Drawn:
    """A question of a variant: the values drawn as they are written, the text of the problem, what was made of it."""

    question: Question
    values: Mapping[str, str]
    text: str
    made: QuestionMade


def drawn(exam: Exam, means: Means, tell: Tell = lambda _draws, _found: None) -> list[list[Drawn]]:
    """Return for each variant its questions, all verified.

    Raises InputError where there are too few members of a family (but see `in_turn`), and where a question that is the
    same in all of them is not verified.
    """
    count, found = len(exam.variants), dict[int, list[Drawn]]()
    fixed = [each for each in exam.questions if each.problem.family is None]
    for question, made in _alike(exam, fixed, means, tell):
        found[question.number] = [Drawn(question, {}, question.source.text, made)] * count
    done = len(fixed)
    for question in exam.questions:
        if question.problem.family is not None:
            found[question.number] = _members(exam, question, count, means, _beyond(done, tell))
            done += count
            tell(0, done)
    return [[found[question.number][i] for question in exam.questions] for i in range(count)]


def to_be_made(exam: Exam) -> int:
    """Return how many questions `drawn` solves in all: it tells how many are done."""
    return sum(1 if each.problem.family is None else len(exam.variants) for each in exam.questions)


def _beyond(done: int, tell: Tell) -> Tell:
    """Return what tells of one family where so many questions are done."""
    return lambda draws, found: tell(draws, done + found)


def _alike(exam: Exam, questions: list[Question], means: Means, tell: Tell) -> Iterator[tuple[Question, QuestionMade]]:
    """Yield what was made of the questions that are the same in all variants; raises InputError."""
    results = dict[int, Any]()
    for question in questions:
        results[question.number] = _memory(question, means).get(question.source.text)
    new = [each for each in questions if results[each.number] is None]
    calls = [(each.source.text, each.source.name, means.make, asked_of(each, means)) for each in new]
    parts = max((each.problem.solutions for each in new), default=1)
    for place, result in means.executor.calls(_limits(means, parts), made_of, calls):
        results[new[place].number] = result
        tell(0, sum(each is not None for each in results.values()))
        if isinstance(result, QuestionMade) and result.status is Status.VERIFIED:
            _memory(new[place], means).put(new[place].source.text, result)
    wrong = list[Diagnostic]()
    faults = {exam.source: wrong}
    for question in questions:
        result = results[question.number]
        if isinstance(result, Exceeded):
            wrong.append(question.node.diagnostic(f"question {question.number} cannot be solved: {result.reason}"))
        elif isinstance(result, WronglyAsked):
            error = _misasked(question, result)
            faults.setdefault(error.source, []).extend(error.diagnostics)
        elif result.status is Status.FAILED or (result.status is Status.UNSOLVED and not means.partly):
            message = f"question {question.number} is {result.status}: {result.reason}"
            wrong.append(question.node.diagnostic(message))
        else:
            yield question, result
    if errors := [InputError(source, found) for source, found in faults.items() if found]:
        raise SeveralAtFault(errors)


def _misasked(question: Question, found: WronglyAsked) -> InputError:
    """Return what is wrong with a question as it is asked, where it is told: in the exam or in a file of its own."""
    try:
        refuse(question.problem, found.refusals)
    except InputError as error:
        return error
    raise AssertionError("a question is refused for a reason")


def _members(exam: Exam, question: Question, count: int, means: Means, tell: Tell) -> list[Drawn]:
    """Return the members of a family for the variants in order, as `in_turn` does."""
    search = search_of(exam, question, means, tell)
    asked, name = asked_of(question, means), f"question-{question.number}"
    some = members_again(means.kept, question.problem, search, count, asked, name, means.make, QuestionMade)
    found = [Drawn(question, each.values, each.text, _question(each.made)) for each in some]
    return in_turn(exam, question, search, found, count)


def _question(made: Made) -> QuestionMade:
    if not isinstance(made, QuestionMade):
        raise AssertionError("`make` makes questions")
    return made


def _memory(question: Question, means: Means) -> MadeBefore[QuestionMade]:
    """Return what knows what was made of the texts of a question."""
    facts = facts_of(question.problem, question.source.name, asked_of(question, means))
    return MadeBefore(means.kept, QuestionMade, facts)


Drew = TypeVar("Drew")


def in_turn(exam: Exam, question: Question, search: Search, found: Sequence[Drew], count: int) -> list[Drew]:
    """Return as many members as wanted, of a smaller family in turn for the students of a class.

    Raises InputError where there are too few of them without a class, and where not all choices were looked through
    within the usual number of draws: who marks later must find the same.
    """
    if len(found) < count and not (found and exam.students and search.is_exhausted and search.count <= MOST_DRAWS):
        raise shortage(search, question.told, count)
    return [found[i % len(found)] for i in range(count)]


def shared(variants: Sequence[Sequence[Drawn]]) -> dict[int, int]:
    """Return the questions whose members several students share, with how many members there are."""
    found: dict[int, int] = {}
    for questions in zip(*variants, strict=True):
        members = len({each.text for each in questions})
        if questions[0].values and members < len(questions):
            found[questions[0].question.number] = members
    return found


def search_of(exam: Exam, question: Question, means: Means, tell: Tell = lambda _draws, _found: None) -> Search:
    """Return the search of the members of a question that tells a family; the same one for papers and for marking."""
    family = question.problem.family
    if family is None:
        raise AssertionError("only a family has members")
    return Search(question.source, family, exam.seed_of(question), means.draws, means.executor, tell)


def asked_of(question: Question, means: Means) -> Asked:
    """Return what is wanted of a question."""
    return Asked((), means.presentation, _limits(means, 1), False, question.number, question.marks)


def _limits(means: Means, parts: int) -> Limits:
    return means.limits.times(means.factor * parts)
