"""Which answers become fields: those of which one value only is right, each value judged by our own marking first."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal
from fractions import Fraction
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from solver.classroom.kinds import kind_of
from solver.classroom.verdicts import Verdict
from solver.papers.export.bench import Answer, Bench
from solver.papers.export.decimals import exactly, tolerance_of, typed, value_of
from solver.papers.export.quiz import Asked, Choice, Fixed, Number, Wrong
from solver.papers.export.scalars import Real
from solver.papers.export.shapes import Shape, shape_of, with_parts
from solver.render.prose import plain
from solver.symbols import COMPLEX
from solver.words import Phrase

MOST_WRONG = 4
"""Wrong values of a field: more make a question long, and are made by few."""

WRONG_DIGITS = 6
"""Digits to which a wrong value is typed where our marking is asked about it."""

INFINITE = {sp.oo: 999999, -sp.oo: -999999}
"""What is typed for infinity where a number may be infinite: a field for a word would tell that it is."""

MANY = "several values are right, by what the question asks of them"
HOW_MANY = "how many values there are is part of what is asked"
LETTERS = "it is a formula in letters"
OF_TIME = "it is a function"
NOT_OURS = "the value, rounded as it is asked for, is not right by the marking of answer files"
FORM = "its form is what is asked"
OTHERS = "it is {kind}"
CONVENTION = "The {option} is {value}."
UNIT = "It is told in {unit}."
INFINITY = "Infinity is written as {number}, minus infinity as -{number}."
ANGLES = "Angles are in degrees, above -180 and at most 180."

DEGREES = "°"
HALF_TURN = 180


class NoField(Exception):  # noqa: N818 - it is no error: a person marks the answer
    """No field can ask for an answer; the message says why, a phrase."""


def asked_of_answer(bench: Bench, answer: Answer, symbol: str, meaning: str) -> Asked:
    """Return the fields that ask for an answer of ours; raises NoField."""
    part, name = answer
    value, declared = bench.blank.ours(part.id)[name], bench.declared(answer)
    say = bench.blank.messages.say
    if not _is_unique(bench, answer):
        raise NoField(MANY)
    marks = bench.told_marks[part.id][name]
    whole = name in part.partial and part.partial[name].rule == "none"
    asked = Asked(name, symbol, meaning, "", marks, (), whole=whole)
    if isinstance(value, bool | sp.logic.boolalg.BooleanAtom):
        found = _choice(bench, answer, asked, ("yes", "no"), "yes" if value else "no")
    elif isinstance(value, str) and value in declared.words:
        found = _choice(bench, answer, asked, declared.words, value)
    elif isinstance(value, list | tuple) and not declared.numbered:
        raise NoField(HOW_MANY)
    elif declared.modal:
        raise NoField(FORM)
    elif declared.infinite and value in INFINITE:
        found = _infinite(bench, answer, asked)
    else:
        found = _numbers(bench, answer, asked)
    told = [say(each) for each in found.form.split("\n") if each]
    if declared.infinite:
        told.append(say(Phrase(INFINITY, number=INFINITE[sp.oo])))
    if declared.unit == DEGREES:
        told.append(say(ANGLES))
    elif declared.unit and declared.unit != "ratio":
        told.append(say(Phrase(UNIT, unit=declared.unit)))
    for option, ours in bench.conventions(answer).items():
        told.append(say(Phrase(CONVENTION, option=bench.blank.messages.named(option), value=plain(ours))))
    return replace(found, form=" ".join(told))


def _is_unique(bench: Bench, answer: Answer) -> bool:
    """Whether one value only is right; an angle is, once it is said in which range it lies."""
    part, name = answer
    declared = bench.declared(answer)
    if declared.any_size or declared.intervals or declared.zero:
        return False
    if bench.blank.is_determined(part, name):
        return True
    ours = bench.blank.ours(part.id)[name]
    if declared.infinite and ours in INFINITE:
        return True
    angles = [exactly(each) for each in (ours if isinstance(ours, list | tuple) else [ours])]
    return declared.unit == DEGREES and all(map(_in_range, angles))


def _in_range(angle: Fraction | None) -> bool:
    """Whether an angle is above -180 and at most 180 degrees."""
    return angle is not None and -HALF_TURN < angle <= HALF_TURN


def _choice(bench: Bench, answer: Answer, asked: Asked, words: Sequence[str], right: str) -> Asked:
    say = bench.blank.messages.say
    if not bench.is_right(answer, right):
        raise NoField(NOT_OURS)
    if any(bench.is_right(answer, each) for each in words if each != right):
        raise NoField(MANY)
    field = Choice(
        _key(asked.name), _label(bench, asked), tuple(map(say, words)), list(words).index(right), _exact(bench, answer)
    )
    return replace(asked, lines=((_lead(asked), field),))


def _infinite(bench: Bench, answer: Answer, asked: Asked) -> Asked:
    """Return the field for a number that is infinite, which looks as one for any other."""
    value = bench.blank.ours(answer[0].id)[answer[1]]
    if not bench.is_right(answer, "oo" if value == sp.oo else "-oo"):
        raise NoField(NOT_OURS)
    code = INFINITE[value]
    shape = Shape("scalar", (Real(),), (asked.symbol,), ())
    field = Number(
        f"{_key(asked.name)}-1", _label(bench, asked), Decimal(code), Decimal(0), _exact(bench, answer), str(code)
    )
    return replace(asked, lines=shape.lines([field]))


def _exact(bench: Bench, answer: Answer) -> Fraction:
    """Return the marks of an answer before they are told in hundredths: systems with weights keep their ratio."""
    return bench.marks[answer[0].id][answer[1]]


def _lead(asked: Asked) -> Fixed:
    return Fixed("" if asked.symbol.startswith(r"\text") else f"{asked.symbol} =")


def _shape(bench: Bench, answer: Answer, symbol: str) -> tuple[Shape, Sequence[Fraction], list[str]]:
    """Return how an answer is laid out, its numbers, and how they are typed, which is right by our marking.

    A list that is right in its own order only, such as the first values of a sequence, keeps it. Raises NoField.
    """
    part, name = answer
    value = bench.blank.ours(part.id)[name]
    why: str = _why(value)
    for ordered in dict.fromkeys((bench.declared(answer).ordered, True)):
        shape = shape_of(value, symbol, ordered=ordered)
        if shape is not None and not bench.declared(answer).unit:
            shape = with_parts(shape)
        numbers = shape.numbers(value) if shape is not None else None
        if shape is None or numbers is None:
            continue
        texts = [typed(number, part.digits) for number in numbers]
        if bench.is_right(answer, shape.typed(texts)):
            return shape, numbers, texts
        why = NOT_OURS
    raise NoField(why)


def _numbers(bench: Bench, answer: Answer, asked: Asked) -> Asked:
    """Return the fields for numbers; raises NoField."""
    part, name = answer
    shape, numbers, texts = _shape(bench, answer, asked.symbol)
    wrong = _wrong_values(bench, answer, shape, numbers)
    marks = _exact(bench, answer) / len(numbers)
    fields = [
        Number(f"{_key(name)}-{i}", _label(bench, asked, place), value_of(number),
               tolerance_of(number, part.digits), marks, text, tuple(wrong[i - 1]))
        for i, (number, text, place) in enumerate(zip(numbers, texts, shape.places, strict=True), 1)
    ]  # fmt: skip
    whole = asked.whole or (len(numbers) > 1 and shape.kind in {"scalar", "bounds"})
    form = "\n".join(shape.told)
    return replace(asked, form=form, lines=shape.lines(fields), grid=shape.is_grid, whole=whole)


def _wrong_values(bench: Bench, answer: Answer, shape: Shape, right: Sequence[Fraction]) -> list[list[Wrong]]:
    """Return for each field the values that usual mistakes lead to, each wrong by our marking and with its share."""
    part, _ = answer
    found: list[list[Wrong]] = [[] for _ in right]
    marks = bench.marks[part.id][answer[1]]
    seen: set[tuple[Fraction, ...]] = {tuple(right)}
    for value, _words in bench.mistakes(answer):
        numbers = shape.numbers(value)
        if numbers is None or tuple(numbers) in seen:
            continue
        seen.add(tuple(numbers))
        if all(len(each) >= MOST_WRONG for each in found):
            break
        verdict = bench.verdict(answer, shape.typed([typed(each, WRONG_DIGITS) for each in numbers]))
        if verdict.verdict is not Verdict.WRONG or not verdict.mistake:
            continue
        off = [i for i, pair in enumerate(zip(numbers, right, strict=True)) if pair[0] != pair[1]]
        named = part.partial.get(answer[1])
        share = _share(verdict.marks / marks, len(right), len(off)) if named and named.rule == "named" and marks else 0
        hint = f"{bench.blank.messages.told(verdict.reason).rstrip('.')}."
        degrees = bench.declared(answer).unit == DEGREES
        for i in (i for i in off if not degrees or _in_range(numbers[i])):
            wrong = Wrong(value_of(numbers[i]), tolerance_of(numbers[i], part.digits), Fraction(share), _sentence(hint))
            if len(found[i]) < MOST_WRONG and _stands_apart(wrong, right[i], part.digits, found[i]):
                found[i].append(wrong)
    return found


def _share(earned: Fraction, count: int, off: int) -> Fraction:
    """Return what each wrong field earns so that all earn what the mistake leaves of the marks."""
    return min(Fraction(1), max(Fraction(0), (earned * count - (count - off)) / off))


def _stands_apart(wrong: Wrong, right: Fraction, digits: int, others: Sequence[Wrong]) -> bool:
    """Whether no number is taken for this value and for the right one, or for another wrong one."""
    taken = [(value_of(right), tolerance_of(right, digits)), *((each.value, each.tolerance) for each in others)]
    return all(abs(wrong.value - value) > wrong.tolerance + tolerance for value, tolerance in taken)


def _why(value: Any) -> str:
    """Return why an answer that is determined has no field, a phrase."""
    symbols = {symbol.name for each in _leaves(value) for symbol in getattr(each, "free_symbols", ())}
    functions = any(each.atoms(AppliedUndef) for each in _leaves(value) if isinstance(each, sp.Basic))
    if symbols & {"t", "k"} or functions:
        return OF_TIME
    if symbols - COMPLEX:
        return LETTERS
    if symbols:
        return FORM
    return Phrase(OTHERS, kind=kind_of(value))


def _leaves(value: Any) -> Iterator[Any]:
    """Yield what lists and mappings hold."""
    if isinstance(value, Mapping):
        yield from _leaves(list(value.values()))
    elif isinstance(value, list | tuple):
        for each in value:
            yield from _leaves(each)
    else:
        yield value


def _key(name: str) -> str:
    """Return a name for a field: letters, digits and hyphens, a letter first."""
    return "f-" + re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")


def _label(bench: Bench, asked: Asked, places: Sequence[tuple[str, Mapping[str, Any]]] = ()) -> str:
    say: Callable[[str], str] = bench.blank.messages.say
    told = [bench.blank.messages.named(asked.name), *(say(Phrase(words, **of)) for words, of in places if words)]
    return ", ".join(filter(None, told))


def _sentence(words: str) -> str:
    return words[:1].upper() + words[1:]
