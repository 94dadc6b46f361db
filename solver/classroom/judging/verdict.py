"""The verdicts of the values submitted for one part, by the verification of its task."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from solver.classroom.judging.entries import all_right, by_items, entrywise, shaped
from solver.classroom.judging.pairs import arranged
from solver.classroom.judging.question import Question, checks_of
from solver.classroom.judging.readings import judged_by_readings
from solver.classroom.judging.rounding import bounds_are_rounded
from solver.classroom.judging.vectors import Vectors
from solver.classroom.submitted import Submitted
from solver.classroom.verdicts import AnswerVerdict, Verdict
from solver.derivation import Check, CheckStatus
from solver.symbols import MEANINGS, SAMPLES
from solver.words import Reason

MOST_CLAIMS = 2
"""Checks that fail are told up to so many."""

TO_THE_DIGITS = Reason("marking/to_the_digits")


def judge(question: Question, submitted: Mapping[str, Submitted]) -> dict[str, AnswerVerdict]:
    """Return the verdict of every value, of one with several readings by the one that is right."""
    return judged_by_readings(question, submitted, _judged)


def _judged(question: Question, submitted: Mapping[str, Submitted]) -> dict[str, AnswerVerdict]:
    """Return the verdict of every value as it is read.

    First all values are judged together, with the relations between them. Where that fails each is judged alone, and
    what fails alone is taken out: it must not spoil the others.
    """
    verdicts: dict[str, AnswerVerdict] = {}
    fitting: dict[str, Submitted] = {}
    answers = question.task.answers
    submitted = arranged(submitted, rows={name: answers[name].vectors == "rows" for name in submitted})
    for name, each in submitted.items():
        misfit = _misfit(name, each, question)
        if misfit is None:
            fitting[name] = each
        else:
            verdicts[name] = misfit
    if len(fitting) > 1 and _fails(checks_of(question, fitting)):
        for name, each in list(fitting.items()):
            alone = _verdict(name, {name: each}, question)
            if alone.verdict is Verdict.WRONG:
                verdicts[name] = alone
                del fitting[name]
    for name, each in fitting.items():
        found = _verdict(name, fitting, question)
        verdicts[name] = (found.verdict is Verdict.CORRECT and _wrong_pairs(name, each, question)) or found
    return {name: verdicts[name] for name in submitted}


def _wrong_pairs(name: str, each: Submitted, question: Question) -> AnswerVerdict | None:
    """The verdict of vectors of which one is told for another eigenvalue than its own, or for none; None of others."""
    if each.eigenvalues is None:
        return None
    told = {name: replace(each, eigenvalues=None), "eigenvalues": each.eigenvalues}
    if all(_verdict(one, told, question).verdict is Verdict.CORRECT for one in told):
        return None
    entries = shaped(each.value, lambda _: str(Verdict.WRONG))
    return AnswerVerdict(name, Verdict.WRONG, each.value, Reason("marking/other_eigenvalues"), entries=entries)


def _fails(checks: list[Check] | None) -> bool:
    return checks is None or any(check.status is CheckStatus.FAILED for check in checks)


def _misfit(name: str, each: Submitted, question: Question) -> AnswerVerdict | None:
    """What needs no check: a value that is not finite; a matrix of the wrong shape, where the question has one."""
    ours: Any = question.ours.get(name)
    reason = None
    both = isinstance(ours, sp.MatrixBase) and isinstance(each.value, sp.MatrixBase)
    if _infinite(each.value) and not _infinite(ours):
        reason = Reason("marking/not_finite")
    elif both and each.value.shape != ours.shape and 0 not in ours.shape and not question.task.answers[name].any_size:
        reason = Reason("marking/size", {"wanted": ours.shape, "given": each.value.shape})
    elif varying := _varying(name, each, question):
        reason = Reason("marking/not_constant", {"names": varying})
    entries = shaped(each.value, lambda _: str(Verdict.WRONG))
    return AnswerVerdict(name, Verdict.WRONG, each.value, reason, entries=entries) if reason is not None else None


def _varying(name: str, each: Submitted, question: Question) -> list[str]:
    """Variables in a value of which many are right, such as s or t, where neither ours nor the question has them."""
    if not question.task.answers[name].is_free(question.given):
        return []
    known = _symbols([question.ours.get(name), *question.given.options.values, *_matrices_of(question.given.system)])
    return sorted(symbol.name for symbol in _symbols([each.value]) - known if symbol.name in {*MEANINGS, *SAMPLES})


def _infinite(value: Any) -> bool:
    if isinstance(value, list | tuple):
        return any(map(_infinite, value))
    return isinstance(value, sp.Expr | sp.MatrixBase) and value.has(sp.oo, -sp.oo, sp.zoo, sp.nan)


def _verdict(name: str, fitting: Mapping[str, Submitted], question: Question) -> AnswerVerdict:
    """Judge one value; one that is right only for what a decimal of too few digits may stand for is not judged."""
    each = fitting[name]
    firm = each.with_digits(question.digits)
    found = _verdict_to_the_digits(name, {**fitting, name: firm}, question)
    if found.verdict is not Verdict.WRONG or firm is each:
        return found
    if _verdict_to_the_digits(name, fitting, question).verdict is not Verdict.CORRECT:
        return found
    reason = Reason("marking/too_few_digits", {"least": question.digits})
    return AnswerVerdict(name, Verdict.NOT_JUDGED, each.value, reason)


def _verdict_to_the_digits(name: str, fitting: Mapping[str, Submitted], question: Question) -> AnswerVerdict:
    """Judge one value: by its checks, then to the digits written, then by what is undecided."""
    each = fitting[name]
    checks = checks_of(question, fitting)
    if checks is None and len(fitting) > 1:
        checks = checks_of(question, {name: each})
    own = [check for check in checks or () if name in check.judges]
    if own and all(check.status is CheckStatus.PASSED for check in own):
        return _correct(name, each)
    failed = [check for check in own if check.status is CheckStatus.FAILED]
    declared = question.task.answers[name]
    free = declared.is_free(question.given)
    entries = entrywise(each, question.ours.get(name), ordered=declared.ordered)
    by_digits = not failed or (bool(each.decimals) and not (free and len(fitting) > 1))
    if entries is not None and all_right(entries) and by_digits:
        return _correct(name, each, TO_THE_DIGITS if each.decimals and failed else "")
    crashed = checks is None and not free and entries is not None
    freely = Vectors(question, name, each)
    if failed or crashed or (own and not _some_skipped(own)):
        if (each.decimals and free and freely.rounded(fitting, failed)) or bounds_are_rounded(question, name, each):
            return _correct(name, each, TO_THE_DIGITS)
        entries = freely.entries() if free else by_items(own, entries, each.value, question.ours.get(name))
        return AnswerVerdict(name, Verdict.WRONG, each.value, _complaint(each.value, failed), entries=entries)
    if not free and (strange := _strangers(each, question)):
        reason = Reason("marking/unknown_symbols", {"names": strange})
        return AnswerVerdict(name, Verdict.WRONG, each.value, reason, entries=shaped(each.value, lambda _: "wrong"))
    undecided = next((check.reason for check in own if check.reason), "the check cannot decide about it")
    return AnswerVerdict(name, Verdict.NOT_JUDGED, each.value, undecided)


def _strangers(each: Submitted, question: Question) -> list[str]:
    """Symbols that stand neither in the question nor in our answers."""
    known = _symbols([*question.ours.values(), *question.given.options.values, *_matrices_of(question.given.system)])
    return sorted(str(symbol) for symbol in _symbols([each.value]) - known)


def _matrices_of(system: Any) -> list[Any]:
    names = ("A", "B", "C", "D", "x0", "matrix")
    return [value for name in names if (value := getattr(system, name, None)) is not None]


def _symbols(values: Iterable[Any]) -> set[Any]:
    found: set[Any] = set()
    for value in values:
        found |= _symbols(value) if isinstance(value, list | tuple) else set(getattr(value, "free_symbols", ()))
    return found


def _correct(name: str, each: Submitted, note: Reason | str = "") -> AnswerVerdict:
    entries = shaped(each.value, lambda _: str(Verdict.CORRECT))
    return AnswerVerdict(name, Verdict.CORRECT, each.value, note=note, entries=entries)


def _some_skipped(checks: Iterable[Check]) -> bool:
    return any(check.status is CheckStatus.SKIPPED for check in checks)


def _complaint(value: Any, failed: list[Check]) -> Reason | str:
    """What the value does not satisfy, in the words of the table of checks."""
    if isinstance(value, bool):
        return Reason("marking/opposite")
    claims = list(dict.fromkeys(check.claim for check in failed if check.claim))
    return Reason("marking/failed_checks", {"claims": claims[:MOST_CLAIMS]}) if claims else ""
