"""Marking an answer file: the parts in order, with follow-through of the student's own earlier answers."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import Any

from solver.classroom.alike import known_of, told
from solver.classroom.following.between import OwnResults
from solver.classroom.following.chain import followed
from solver.classroom.following.conventions import Judged, by_convention
from solver.classroom.judging.question import Question
from solver.classroom.judging.verdict import judge
from solver.classroom.marks import carried, fraction, left_out, marked
from solver.classroom.mistakes.explaining import Wrong, explained
from solver.classroom.reading.answer_file import Submission
from solver.classroom.reading.expected import Expected
from solver.classroom.reading.names import names_for
from solver.classroom.reading.spelling import typed
from solver.classroom.reading.values import Reader
from solver.classroom.same import Same
from solver.classroom.submitted import Submitted
from solver.classroom.verdicts import AnswerVerdict, Marking, PartVerdict, Verdict
from solver.derivation import Given, PartResult, Status
from solver.engine import Solution, given_of
from solver.limits import Exceeded, Limits, call_within
from solver.messages import Messages
from solver.problem.model import Part
from solver.problem.nodes import Node
from solver.problem.source import Diagnostic, Fault
from solver.render.prose import plain
from solver.tasks import catalogue
from solver.words import Reason

Values = dict[str, Submitted]
"""What was submitted for a part and could be read, by the answers' names."""


def mark(solution: Solution, submission: Submission, templates: Path | None = None) -> Marking:
    """Return the marking of a submission to a solved problem, in the language and notation of the problem.

    A folder of templates comes before the installed ones.
    """
    return Marker(solution, submission, templates).marking()


class Marker:
    """Marks the parts; `values` holds what was submitted, `own` what comes of it in later parts."""

    def __init__(self, solution: Solution, submission: Submission, templates: Path | None = None) -> None:
        display = solution.problem.display
        self.messages = Messages(templates, display.language, display.notation)
        self.solution = solution
        self.submission = submission
        self.results: dict[str, list[PartResult]] = {}
        for result in solution.parts:
            self.results.setdefault(result.id, []).append(result)
        self.known = known_of(Same(solution), templates)
        self.unread: dict[str, dict[str, Reason]] = {}
        self.values = {part.id: self._read_all(part) for part in solution.problem.parts}
        self.own = OwnResults(solution.problem.parts, self.results, self.values)

    def marking(self) -> Marking:
        """Return the verdicts and marks of all parts."""
        parts = tuple(map(self.part, self.solution.problem.parts))
        return Marking(self.submission.student, parts, self.remarks())

    def remarks(self) -> tuple[str, ...]:
        """What stands in the file that nobody asked for, in words."""
        strange = (Reason("marking/strange", placed(diagnostic)) for diagnostic in self.submission.strange)
        return tuple(map(self.messages.reason, strange))

    def within(self, part: Part, limits: Limits) -> PartVerdict:
        """Return what `part` does, within limits of time and memory."""
        try:
            verdict: PartVerdict = call_within(limits, self.part, part)
        except Exceeded as limit:
            return self.unjudged(part, limit.reason)
        return verdict

    def unjudged(self, part: Part, limit: str) -> PartVerdict:
        """Return the part as it is where judging it met a limit."""
        submitted, reason = self.submission.answers.get(part.id, {}), self.messages.say(limit)
        each = carried(part, self.ours(part.id), self._out_of(part))
        answers = {name: AnswerVerdict(name, Verdict.NOT_JUDGED, reason=reason) for name in submitted}
        missing = left_out(each, submitted)
        verdicts = marked(answers, each, part.partial)
        return PartVerdict(part.id, part.task, verdicts, Fraction(0), self._out_of(part), reason, missing)

    def _out_of(self, part: Part) -> Fraction:
        """The marks of a part; one each where the problem gives none to any part."""
        return fraction(part.marks) if part.marks is not None else Fraction(int(not self._any_marks()))

    def _read_all(self, part: Part) -> Values:
        """Read every value submitted for a part by the kind of our own answer; `unread` has why others are not."""
        found, unread = Values(), self.unread.setdefault(part.id, {})
        ours = self.ours(part.id)
        reader = self.reader(part, ours)
        for name, node in self.submission.answers.get(part.id, {}).items():
            if name in ours:
                read = partial(read_value, reader, node, ours[name], self._expected(part, name))
                try:
                    found[name] = self.known.of((part.id, name, json.dumps(told(node))), read)
                except Fault as fault:
                    unread[name] = Reason("marking/not_read", placed(fault.diagnostics[0]))
        return found

    def _expected(self, part: Part, name: str) -> Expected:
        """What is known of an answer before it is read."""
        answers = catalogue()[part.task].answers
        return Expected.of(name, answers, self._given(part) if answers[name].most or answers[name].signals else None)

    def reader(self, part: Part, ours: Mapping[str, Any]) -> Reader:
        """Return what reads the values of a part, in which the names of our own answers have their meaning."""
        problem = self.solution.problem
        symbols, parameters = {**problem.symbols, **part.symbols}, {**problem.parameters, **part.parameters}
        discrete = part.system.discrete or catalogue()[part.task].sampled
        names = names_for(symbols, parameters, dict(ours), discrete)
        return Reader(names, discrete=discrete, decimal_comma=part.decimal_comma)

    def ours(self, part: str) -> dict[str, Any]:
        """Our answers of a part by all its methods, verified ones only."""
        found: dict[str, Any] = {}
        for result in self.results[part]:
            if result.status is Status.VERIFIED:
                found = {**result.answers, **found}
        return found

    def is_determined(self, part: Part, name: str) -> bool:
        """Whether the question leaves no choice of an answer of ours."""
        return not catalogue()[part.task].answers[name].is_free(self._given(part))

    def _given(self, part: Part) -> Given[Any, Any]:
        """What our own solution of a part works on."""
        first = {id_: results[0] for id_, results in self.results.items()}
        return given_of(part, part.methods[0], first)

    def part(self, part: Part) -> PartVerdict:
        """Return the verdicts and marks of one part; of equal answers they are remembered, unless they name places."""
        if self.unread[part.id]:
            return self._part(part)
        about = [part.id, *(part.sources and self.values)]  # what follows from earlier parts may come from any of them
        written = [[[name, told(node)] for name, node in self.submission.answers.get(id_, {}).items()] for id_ in about]
        return self.known.of((part.id, json.dumps(written)), partial(self._part, part))

    def _part(self, part: Part) -> PartVerdict:
        out_of = self._out_of(part)
        submitted = self.submission.answers.get(part.id, {})
        ours, values = self.ours(part.id), self.values[part.id]
        verdicts = {name: self._unreadable(part, name) for name in submitted if name not in values}
        for name, verdict in self._judged(part, ours, values).items():
            verdicts[name] = verdict
        ordered = {name: _shown(verdicts[name], node, values.get(name)) for name, node in submitted.items()}
        each = carried(part, ours, out_of)
        ordered = marked(ordered, each, part.partial)
        undecided = [name for name, verdict in ordered.items() if verdict.verdict is Verdict.NOT_JUDGED]
        said: Reason | str = "" if submitted else "not answered"
        if undecided:
            said = Reason("marking/nothing_earned", {"names": undecided})
        worded = {name: verdict.worded(self.messages) for name, verdict in ordered.items()}
        marks = sum((verdict.marks for verdict in worded.values()), Fraction(0))
        missing = left_out(each, submitted)
        return PartVerdict(part.id, part.task, worded, marks, out_of, self.messages.told(said), missing)

    def _any_marks(self) -> bool:
        return any(part.marks is not None for part in self.solution.problem.parts)

    def _unreadable(self, part: Part, name: str) -> AnswerVerdict:
        """The value is not read, or there is no answer of ours of this name to read and judge it by."""
        if (why := self.unread[part.id].get(name)) is not None:
            return AnswerVerdict(name, Verdict.NOT_JUDGED, reason=why)
        for result in self.results[part.id]:
            if result.status is not Status.VERIFIED:
                reason = Reason("marking/no_solution", {"status": str(result.status), "why": result.reason})
                return AnswerVerdict(name, Verdict.NOT_JUDGED, reason=reason)
        return AnswerVerdict(name, Verdict.NOT_JUDGED, reason=Reason("marking/no_such_answer"))

    def _judged(self, part: Part, ours: Mapping[str, Any], values: Values) -> dict[str, AnswerVerdict]:
        """Judge the values of a part, and those that are wrong again with the student's own values."""
        if not values:
            return {}
        earlier = self.own.earlier()
        question = self.question_of(part, earlier, ours)
        verdicts = followed(part, question, values, judge(question, values), self.own)
        found = by_convention(Judged(part, question, verdicts), values, self.own)
        wrong = Wrong(found.part, found.question, values, self.results[part.id], earlier)
        return {
            name: explained(verdict, wrong) if verdict.verdict is Verdict.WRONG and not values[name].others else verdict
            for name, verdict in found.verdicts.items()
        }

    def question_of(self, part: Part, earlier: Mapping[str, PartResult], ours: Mapping[str, Any]) -> Question:
        """Return what a part asks, with our own answers."""
        return Question(catalogue()[part.task], given_of(part, part.methods[0], earlier), ours, part.digits)


def read_value(reader: Reader, node: Node, ours: Any, expected: Expected | None = None) -> Submitted:
    """Return the value of a node for an answer of the kind of ours; raises Fault."""
    try:
        return reader.read(node, ours, expected)
    except Fault:
        raise
    except (ValueError, TypeError, ArithmeticError, AttributeError, RecursionError) as strange:
        raise node.fault("this value cannot be read as an answer") from strange


def placed(what: Diagnostic) -> dict[str, Any]:
    """Return what is wrong with something in the file, with its place; texts as Markdown."""
    texts = {"message": what.message, "suggestion": what.suggestion, "note": what.note}
    return {"line": what.line, "column": what.column, **{name: plain(text) for name, text in texts.items()}}


def _shown(verdict: AnswerVerdict, node: Node, read: Submitted | None) -> AnswerVerdict:
    """The verdict with what was written."""
    if read is None:
        return replace(verdict, typed=typed(node))
    in_decimals, ambiguous = bool(read.decimals), bool(read.others)
    return replace(verdict, typed=read.typed, respelt=read.respelt, in_decimals=in_decimals, ambiguous=ambiguous)
