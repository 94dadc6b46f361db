"""Registration of tasks and methods. The catalogue, `solve tasks`, `solve new`, the schema and the docs read it.

A task file creates one `Task`, decorates its methods (generators of steps that return `Answers`) and its
verification. Nothing here computes, so that reading the catalogue needs no algebra.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import wraps
from itertools import chain
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from solver.derivation.answer_equations import AnswerEquations
from solver.derivation.answer_names import AnswerName
from solver.derivation.consequences import Consequence
from solver.derivation.lemmas import Derivation, MistakenDerivation, lost_lemmas, worded_by
from solver.derivation.mistakes import Attempt, Meaning, Mistake, MistakenQuestion, Slip
from solver.derivation.options import Option, Options
from solver.derivation.steps import Answers, Check
from solver.words import Reason

if TYPE_CHECKING:
    from solver.systems import System

S = TypeVar("S")
O = TypeVar("O", bound=Options)
S_co = TypeVar("S_co", covariant=True)
O_co = TypeVar("O_co", bound=Options, covariant=True)
Refusal = tuple[str, Reason]
"""The option at fault ("" for the question as a whole) and what is wrong with it, in words."""


@dataclass(frozen=True, slots=True)
class Given(Generic[S_co, O_co]):
    """What a method works on: the exact system and the task's options, read and validated."""

    system: S_co
    options: O_co
    method: str = ""


Derive = Callable[[Given[S, O]], Derivation[Answers]]
Judge = Callable[[Given[S, O], Answers], Iterable[Check]]
Refuse = Callable[["System", O], Iterable[Refusal]]
Wrong = Callable[[Attempt[S, O]], Iterable[Any]]
Change = Callable[["System", O], "tuple[System, O] | None"]
Follow = Callable[[Given[S, O], Mapping[str, Any]], Any]
Tell = Callable[[Attempt[S, O]], Reason | None]


@dataclass(frozen=True, slots=True)
class Method:
    """One way of solving a task. `time` is the kind of system it is for: "continuous", "discrete" or "both".

    `system` names the kind that it is for, where it is not for all; `needs` is what it works on, where that is not
    what the task needs.
    """

    name: str
    title: str
    source: str
    time: str
    derive: Callable[[Given[Any, Any]], Derivation[Answers]]
    system: str = ""
    needs: tuple[str, ...] = ()

    def serves(self, discrete: bool, system: str = "") -> bool:
        """Whether the method is for systems in discrete (continuous) time, of this kind."""
        return (self.time == "both" or (self.time == "discrete") == discrete) and self.system in ("", system)


@dataclass(frozen=True, slots=True)
class Verification:
    """The judge of some answers by their defining property; works on any of them alone."""

    answers: tuple[str, ...]
    judge: Callable[[Given[Any, Any], Answers], Iterable[Check]]

    def checks(self, given: Given[Any, Any], answers: Answers) -> Iterable[Check]:
        """Return the checks; one that names no answer judges all of these that are present."""
        present = tuple(name for name in self.answers if name in answers)
        if present:
            for check in self.judge(given, answers):
                yield check if check.judges else replace(check, judges=present)


class Task(Generic[S, O]):
    """A question that can be asked: a name in the field's terms, what it needs, options, answers and methods.

    S is the system that its methods get, O the dataclass of its options. `needs` lists the matrices of the system the
    question is about, e.g. ("A",) or ("A", "B"); what is needed with some options only is for a refusal. `example` are
    matrices and options that the file of `solve new` gives, as they are typed, where the needed and the required ones
    as usual would not do. The entries of the system are real, but where `complex_entries` says that they need not; the
    functions of time of a `sampled` task are sequences. A task with one way of solving it has a method of its own name.
    """

    def __init__(
        self,
        name: str,
        *,
        title: str,
        doc: str,
        needs: tuple[str, ...],
        answers: Iterable[AnswerName],
        options: type[O],
        example: Mapping[str, str] = MappingProxyType({}),
        complex_entries: bool = False,
        sampled: bool = False,
    ) -> None:
        self.name = name
        self.title = title
        self.doc = doc
        self.needs = needs
        self.example = example
        self.complex_entries, self.sampled = complex_entries, sampled
        self.equations: list[AnswerEquations] = []
        self.answers = {answer.name: answer for answer in answers}
        self.options_class, self.options = options, options.declared()
        self.methods: dict[str, Method] = {}
        self.verifications: list[Verification] = []
        self.refusals: list[Callable[[System, O], Iterable[Refusal]]] = []
        self.consequences: list[Consequence] = []
        self.mistakes: list[Mistake] = []
        self.mistaken_questions: list[MistakenQuestion] = []
        self.meanings: list[Meaning] = []

    @property
    def principal(self) -> tuple[str, ...]:
        """The answers that may earn the marks: those declared so, or else all that are always given."""
        declared = tuple(name for name, answer in self.answers.items() if answer.principal)
        return declared or tuple(name for name, answer in self.answers.items() if not answer.optional)

    def principal_of(self, system: S) -> tuple[str, ...]:
        """The answers that earn the marks where a question is about this system."""
        declared = {name: self.answers[name].principal for name in self.principal}
        return tuple(name for name, of in declared.items() if not callable(of) or of(system))

    def given(self, system: S, values: Mapping[str, Any], method: str = "") -> Given[S, O]:
        """Return what a method works on, from the values of options by name."""
        return Given(system, self.options_class.of(values), method)

    def method(
        self,
        name: str = "",
        *,
        title: str = "",
        source: str = "",
        time: str = "both",
        system: str = "",
        needs: tuple[str, ...] = (),
    ) -> Callable[[Derive[S, O]], Derive[S, O]]:
        """Register a derivation. Its steps are worded by `templates/wording/<task>/<method>.md.jinja`."""
        name = name or self.name

        def register(derive: Derive[S, O]) -> Derive[S, O]:
            worded = worded_by(f"{self.name}/{name}")(self._complete(derive, name))
            self.methods[name] = Method(name, title or self.title, source, time, worded, system, needs)
            return worded

        return register

    def _complete(self, derive: Derive[S, O], method: str) -> Derive[S, O]:
        """Return the derivation; it ends in a MistakenDerivation where a lemma was lost or an answer is unknown."""

        @wraps(derive)
        def completed(given: Given[S, O]) -> Derivation[Answers]:
            lost_lemmas.clear()
            answers = yield from derive(given)
            where = f"{self.name}, method {method}"
            if lost_lemmas:
                lost = lost_lemmas[0]
                raise MistakenDerivation(f"{where}: {lost}(…) was called and not run; write `yield from {lost}(…)`")
            if not isinstance(answers, Answers):
                raise MistakenDerivation(f"{where}: it must end in `return Answers(…)`, not in {answers!r}")
            for name in answers:
                if name not in self.answers:
                    declared = ", ".join(self.answers)
                    message = (
                        f"the answer {name} is not declared; add AnswerName({name!r}, …) or use one of: {declared}"
                    )
                    raise MistakenDerivation(f"{where}: {message}")
            return answers

        return completed

    def together(self, equations: AnswerEquations) -> None:
        """Register answers that pages show together, as equations."""
        self._known(equations.answers, "equations")
        self.equations.append(equations)

    def verification(self, *answers: str) -> Callable[[Judge[S, O]], Judge[S, O]]:
        """Register the judge of some answers, called when at least one of them is present.

        It yields checks of the defining property, by other means than the derivation's: it accepts every right answer
        and rejects every wrong one, ours or a student's. It relates answers to each other only where both are present.
        """
        self._known(answers, "a verification")

        def register(judge: Judge[S, O]) -> Judge[S, O]:
            self.verifications.append(Verification(answers, judge))
            return judge

        return register

    def verify(self, given: Given[S, O], answers: Answers) -> Iterable[Check]:
        """Return the checks of all the answers present."""
        for verification in self.verifications:
            yield from verification.checks(given, answers)

    def refusal(self, refuse: Refuse[O]) -> Refuse[O]:
        """Register what makes a question wrong as the file asks it: yields (option or "", reason) for each fault.

        It is called within limits before anything is solved, without the values of options taken from an
        earlier part (`options.later`), and again when these are known. The fault is told at the place of the
        option in the file.
        """
        self.refusals.append(refuse)
        return refuse

    def refused(self, system: System, values: Mapping[str, Any]) -> Iterable[Refusal]:
        """Return what makes the question wrong; None stands for the value of an option that is not known yet."""
        asked = self.options_class.of(values)
        return asked.misfits(system) or chain(asked.faults(system), *(each(system, asked) for each in self.refusals))

    def consequence(
        self, answer: str, *, of: tuple[str, ...], symbolic: bool = True, completing: bool = False
    ) -> Callable[[Follow[S, O]], Follow[S, O]]:
        """Register the formula by which an answer follows from others of the question (None: not from these).

        The others may be anyone's, so that what is right from a wrong one can be told apart from what is wrong. A
        `symbolic` formula can be formed with letters for their entries; by a `completing` one each of several answers
        may follow from the rest.
        """
        self._known((answer, *of) if of else (), "a consequence")

        def register(formula: Follow[S, O]) -> Follow[S, O]:
            self.consequences.append(Consequence(answer, of, formula, symbolic, completing))
            return formula

        return register

    def mistake(self, slip: Slip, *answers: str) -> Callable[[Wrong[S, O]], Wrong[S, O]]:
        """Register a usual mistake by a generator of values; it is named where one is the very value submitted."""
        self._known(answers, "a mistake")

        def register(values: Wrong[S, O]) -> Wrong[S, O]:
            self.mistakes.append(Mistake(slip, answers, values))
            return values

        return register

    def mistaken_question(self, slip: Slip) -> Callable[[Change[O]], Change[O]]:
        """Register a usual mistake that answers another question: the system and options changed (None: not here)."""

        def register(change: Change[O]) -> Change[O]:
            self.mistaken_questions.append(MistakenQuestion(slip, change))
            return change

        return register

    def meaning(self, *answers: str) -> Callable[[Tell[S, O]], Tell[S, O]]:
        """Register what a wrong value of some answers would mean, in the student's terms; ours is never told."""
        self._known(answers, "a meaning")

        def register(of: Tell[S, O]) -> Tell[S, O]:
            self.meanings.append(Meaning(answers, of))
            return of

        return register

    def _known(self, answers: tuple[str, ...], what: str) -> None:
        if (unknown := set(answers) - set(self.answers)) or not answers:
            raise ValueError(f"{self.name}: {what} needs names of its answers, not {sorted(unknown)}")

    @property
    def slips(self) -> list[Slip]:
        """What goes wrong in this task more than in others."""
        return [*(each.slip for each in self.mistakes), *(each.slip for each in self.mistaken_questions)]

    def methods_for(self, discrete: bool, system: str = "") -> list[str]:
        """Names of the methods for that kind of time and of system, the default first."""
        return [method.name for method in self.methods.values() if method.serves(discrete, system)]

    def method_named(self, name: str, options: Mapping[str, Any]) -> Method:
        """Return a method with the title and source that pages give it: those of the way that an option leads."""
        given = (option for option in self.options.values() if option.way and options.get(option.name) is not None)
        way, method = next((option.way for option in given), None), self.methods[name]
        return replace(method, title=way.title, source=way.source) if way else method

    def title_of(self, options: Mapping[str, Any], written: Collection[str]) -> str:
        """Return the title of a question with these options: by the value of one that the file has written."""
        titled = ((name, each.titles) for name, each in self.options.items() if name in written and each.titles)
        return next(filter(None, (titles.get(str(options.get(name))) for name, titles in titled)), self.title)

    def options_for(self, method: str) -> dict[str, Option]:
        """Return the options that the method takes."""
        return {name: option for name, option in self.options.items() if not option.methods or method in option.methods}
