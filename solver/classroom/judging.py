"""The verdicts of the values submitted for one part, by the verification of its task."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.classroom.entries import all_right, entrywise, shaped, word_of
from solver.classroom.submitted import Submitted, replaced
from solver.classroom.verdicts import AnswerVerdict, Verdict
from solver.derivation import Answers, Check, CheckStatus, Given, Task
from solver.lazy import numeric
from solver.problem.model import DIGITS
from solver.symbols import MEANINGS, SAMPLES
from solver.words import Reason

STRANGE = (ValueError, TypeError, LookupError, ArithmeticError, AttributeError, NotImplementedError)
"""What a verification may raise on a value of a form it was never meant for."""

TO_THE_DIGITS = Reason("marking/to_the_digits")

MOST_VECTORS = 5
"""Larger matrices with many right values are judged as a whole only."""


@dataclass(frozen=True)
class Question:
    """A part as it is judged: the task, what is given, and our own verified answers (kind and shape of values).

    A decimal must have `digits` significant ones, or be right as the exact number that it is.
    """

    task: Task[Any, Any]
    given: Given[Any, Any]
    ours: Mapping[str, Any]
    digits: int = DIGITS


def judge(question: Question, submitted: Mapping[str, Submitted]) -> dict[str, AnswerVerdict]:
    """Return the verdict of every value.

    First all values are judged together, with the relations between them. Where that fails each is judged alone, and
    what fails alone is taken out: it must not spoil the others.
    """
    verdicts: dict[str, AnswerVerdict] = {}
    fitting: dict[str, Submitted] = {}
    for name, each in submitted.items():
        misfit = _misfit(name, each, question)
        if misfit is None:
            fitting[name] = each
        else:
            verdicts[name] = misfit
    if len(fitting) > 1 and _fails(_checks(question, fitting)):
        for name, each in list(fitting.items()):
            alone = _verdict(name, {name: each}, question)
            if alone.verdict is Verdict.WRONG:
                verdicts[name] = alone
                del fitting[name]
    for name in fitting:
        verdicts[name] = _verdict(name, fitting, question)
    return {name: verdicts[name] for name in submitted}


def _fails(checks: list[Check] | None) -> bool:
    return checks is None or any(check.status is CheckStatus.FAILED for check in checks)


def _misfit(name: str, each: Submitted, question: Question) -> AnswerVerdict | None:
    """What needs no check: a value that is not finite; a matrix of the wrong shape, where the question has one."""
    ours: Any = question.ours.get(name)
    reason = None
    both = isinstance(ours, sp.MatrixBase) and isinstance(each.value, sp.MatrixBase)
    if _infinite(each.value) and not _infinite(ours):
        reason = Reason("marking/not_finite")
    elif both and each.value.shape != ours.shape and 0 not in ours.shape:
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


def _checks(question: Question, values: Mapping[str, Submitted]) -> list[Check] | None:
    """Return the checks of some values, None where the verification can't work on them."""
    answers = Answers(**{name: each.value for name, each in values.items()})
    try:
        with numeric.typed_decimals(any(each.decimals for each in values.values())):
            return list(question.task.verify(question.given, answers))
    except STRANGE:
        return None


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
    checks = _checks(question, fitting)
    if checks is None and len(fitting) > 1:
        checks = _checks(question, {name: each})
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
    if failed or crashed or (own and not _some_skipped(own)):
        if each.decimals and free and _rounded(question, name, fitting, failed):
            return _correct(name, each, TO_THE_DIGITS)
        entries = _vectors(question, name, each) if free else entries
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


def _vectors(question: Question, name: str, each: Submitted) -> Any:
    """Entries of a matrix with many right values: a column (or row) is right that can replace one of a right matrix."""
    ours, own = question.ours.get(name), each.value
    if not isinstance(own, sp.MatrixBase) or not isinstance(ours, sp.MatrixBase) or own.shape != ours.shape:
        return None
    rows = _in_rows(question, name)
    right = _right_vectors(question, name, each) or set()
    if len(right) == (own.rows if rows else own.cols):  # each is right, but not all together
        right = set()
    return [[word_of((i if rows else j) in right) for j in range(own.cols)] for i in range(own.rows)]


def _right_vectors(question: Question, name: str, each: Submitted) -> set[int] | None:
    """Return the columns (or rows) that can each take the place of another one of ours, to the digits written.

    None where the answer is no matrix of vectors, or too large a one.
    """
    ours: Any = question.ours.get(name)
    vectors = question.task.answers[name].vectors
    fits = isinstance(ours, sp.MatrixBase) and isinstance(each.form, sp.MatrixBase) and each.form.shape == ours.shape
    if not vectors or not fits or max(ours.shape) > MOST_VECTORS:
        return None
    rows = _in_rows(question, name)
    mine, own = (ours.T, each.form.T) if rows else (ours, each.form)
    left, found = list(range(mine.cols)), set[int]()
    for j in range(own.cols):
        for k in left:
            tried = mine.as_mutable()
            tried[:, k] = own[:, j]
            form = sp.ImmutableMatrix(tried.T if rows else tried)
            decimals = {symbol: each.decimals[symbol] for symbol in form.free_symbols & each.decimals.keys()}
            value = replaced(form, {symbol: decimal.number for symbol, decimal in decimals.items()})
            if _is_right(question, name, Submitted(value, form, decimals)):
                found.add(j)
                left.remove(k)
                break
    return found


def _is_right(question: Question, name: str, each: Submitted) -> bool:
    """Whether a value passes its own checks, exactly or but for rounding."""
    own = [check for check in _checks(question, {name: each}) or () if name in check.judges]
    failed = [check for check in own if check.status is CheckStatus.FAILED]
    if not failed:
        return bool(own) and all(check.status is CheckStatus.PASSED for check in own)
    return bool(each.decimals) and _within_rounding(question, name, each, {name: each}, failed)


def _rounded(question: Question, name: str, fitting: Mapping[str, Submitted], failed: list[Check]) -> bool:
    """Whether rounding explains what is left: of each vector of a matrix by itself, where it is made of such."""
    each = fitting[name]
    if not _within_rounding(question, name, each, fitting, failed):
        return False
    right = _right_vectors(question, name, each)
    return right is None or len(right) == (each.value.rows if _in_rows(question, name) else each.value.cols)


def _in_rows(question: Question, name: str) -> bool:
    return question.task.answers[name].vectors == "rows"


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
    return Reason("marking/failed_checks", {"claims": claims}) if claims else ""


def _within_rounding(
    question: Question, name: str, each: Submitted, fitting: Mapping[str, Submitted], failed: list[Check]
) -> bool:
    """Whether rounding explains what is left of a defining property that has many right answers.

    To first order: the residual is at most the sum of what moving each decimal by half a unit changes in it.
    """
    if not failed or not _numbers(failed):
        return False
    allowed = 0.0
    for symbol, decimal in each.decimals.items():
        changes = [
            abs(moved - start)
            for half in (decimal.half_unit, -decimal.half_unit)
            for start, moved in _residuals(question, name, each, fitting, symbol, decimal.number + half)
        ]
        allowed += max(changes, default=0.0)
    return all(check.residual <= 1.05 * allowed + 1e-9 for check in failed if check.residual is not None)


def _numbers(checks: Iterable[Check]) -> bool:
    return all(check.residual is not None and check.residual < float("inf") for check in checks)


def _residuals(
    question: Question, name: str, each: Submitted, fitting: Mapping[str, Submitted], symbol: Any, value: Any
) -> list[tuple[float, float]]:
    """Pairs of residuals of the same checks, before and after one decimal is moved."""
    at = {other: decimal.number for other, decimal in each.decimals.items()} | {symbol: value}
    moved = Submitted(replaced(each.form, at), each.form)
    before, after = (_checks(question, {**fitting, name: which}) or [] for which in (each, moved))
    return [
        (a.residual, b.residual)
        for a, b in zip(before, after, strict=False)
        if name in a.judges and a.residual is not None and b.residual is not None
    ]
