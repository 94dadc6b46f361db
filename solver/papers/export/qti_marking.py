"""How a QTI item is marked: what is declared, what each field adds to the score, and the hints for wrong values.

A field that is right adds its marks, and the value of a usual mistake its share of them, with a hint. Where an answer
is right as a whole only, one condition looks at all of its fields.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from xml.etree.ElementTree import Element

from solver.papers.export.packages import node
from solver.papers.export.qti_body import ESSAY, SHOWN, SOLUTION, feedback, line, word_of
from solver.papers.export.quiz import Asked, Choice, Field, Item, Number, Wrong
from solver.papers.export.versions import decimal, marks_of_fields

SCORE, HINTS = "SCORE", "FEEDBACK"
HAIR = Decimal("1e-9")


def declarations_of(item: Item) -> Iterator[Element]:
    """Yield what is answered, with what is right, and what comes of it. An essay has no score until it is marked."""
    for field in item.fields:
        yield _response(field)
    if item.essay:
        yield node("responseDeclaration", identifier=ESSAY, cardinality="single", baseType="string")
    marks = decimal(item.marks)
    yield _outcome(SCORE, "float", *([] if item.essay else [_value("defaultValue", "0")]), normalMaximum=marks)
    yield _outcome("MAXSCORE", "float", _value("defaultValue", marks))
    if _hints(item):
        yield node("outcomeDeclaration", identifier=HINTS, cardinality="multiple", baseType="identifier")
    yield _outcome(SOLUTION, "identifier")


def processing_of(item: Item) -> Element:
    """Return what is done with the answers."""
    hints = _hints(item)
    marked = [each for asked in item.answers for each in (_whole if asked.whole else _each)(asked, hints)]
    return node("responseProcessing", *marked, _set(SOLUTION, _constant("identifier", SHOWN)))


def hints_of(item: Item) -> Iterator[Element]:
    """Yield the hints for wrong values, each once."""
    for hint, identifier in _hints(item).items():
        yield feedback(HINTS, identifier, line(hint))


def _hints(item: Item) -> Mapping[str, str]:
    """Return identifiers of the hints: a mistake that spoils several fields is told once."""
    told = dict.fromkeys(wrong.hint for field in item.fields for wrong in _wrong_of(field) if wrong.hint)
    return {hint: f"hint-{number}" for number, hint in enumerate(told, 1)}


def _response(field: Field) -> Element:
    match field:
        case Number(typed=typed):
            base, right = "float", typed
        case Choice(right=index):
            base, right = "identifier", word_of(index)
    correct = _value("correctResponse", right)
    return node("responseDeclaration", correct, identifier=field.key, cardinality="single", baseType=base)


def _outcome(identifier: str, base: str, *content: Element, **attributes: str) -> Element:
    named = {"identifier": identifier, "cardinality": "single", "baseType": base, **attributes}
    return node("outcomeDeclaration", *content, **named)


def _value(tag: str, value: str) -> Element:
    return node(tag, node("value", value))


def _each(asked: Asked, hints: Mapping[str, str]) -> Iterator[Element]:
    """Yield a condition for each field."""
    marks = marks_of_fields(asked)
    for field in asked.fields:
        branches = [(_right(field), [_add(marks[field])])]
        branches += [(_equals(field, wrong), list(_earned(wrong, marks[field], hints))) for wrong in _wrong_of(field)]
        yield _chosen(branches)


def _whole(asked: Asked, hints: Mapping[str, str]) -> Iterator[Element]:
    """Yield the condition for all fields, which knows the mistakes that explain all of them, and those for hints."""
    fields = list(asked.fields)
    branches = [(_all(list(map(_right, fields))), [_add(asked.marks)])]
    branches += [(_all([_by(field, hint) for field in fields]), [_add(asked.marks * share)])
                 for hint, share in _shares(asked).items()]  # fmt: skip
    yield _chosen(branches)
    for field in fields:
        for wrong in _wrong_of(field):
            if wrong.hint:
                yield node("responseCondition", node("responseIf", _equals(field, wrong), _told(hints[wrong.hint])))


def _chosen(branches: Sequence[tuple[Element, list[Element]]]) -> Element:
    """Return the condition that takes the first branch that holds."""
    tags = ["responseIf", *["responseElseIf"] * (len(branches) - 1)]
    taken = zip(tags, branches, strict=True)
    return node("responseCondition", *(node(tag, when, *then) for tag, (when, then) in taken))


def _shares(asked: Asked) -> Mapping[str, Fraction]:
    """Return the shares of the mistakes that earn some, by their hints."""
    return {wrong.hint: wrong.share for field in asked.fields for wrong in _wrong_of(field) if wrong.share}


def _by(field: Field, hint: str) -> Element:
    """Return whether a field holds what a mistake leads to: where that changes nothing there, what is right."""
    wrong = next((each for each in _wrong_of(field) if each.hint == hint), None)
    return _right(field) if wrong is None else _equals(field, wrong)


def _earned(wrong: Wrong, marks: Fraction, hints: Mapping[str, str]) -> Iterator[Element]:
    """Yield what a wrong value leads to: marks, a hint, or both."""
    if wrong.share:
        yield _add(marks * wrong.share)
    if wrong.hint:
        yield _told(hints[wrong.hint])


def _wrong_of(field: Field) -> tuple[Wrong, ...]:
    return field.wrong if isinstance(field, Number) else ()


def _right(field: Field) -> Element:
    match field:
        case Number(value=value, tolerance=tolerance):
            return _near(field, value, tolerance)
        case Choice():
            return node("match", _variable(field.key), node("correct", identifier=field.key))


def _equals(field: Field, wrong: Wrong) -> Element:
    return _near(field, wrong.value, wrong.tolerance)


def _near(field: Field, value: Decimal, tolerance: Decimal) -> Element:
    compared = [_variable(field.key), _constant("float", f"{value:f}")]
    if not tolerance:
        return node("equal", *compared, toleranceMode="exact")
    width = _width(value, tolerance)
    return node("equal", *compared, toleranceMode="absolute", tolerance=f"{width} {width}")


def _width(value: Decimal, tolerance: Decimal) -> str:
    """Return the tolerance, a hair wider where else binary arithmetic would take one of its edges for wrong."""
    middle, low, high = float(value), float(value - tolerance), float(value + tolerance)
    exact = Decimal(max(middle - low, high - middle))
    wider = (tolerance, tolerance * (1 + HAIR), exact)
    return next(f"{each:f}" for each in wider if middle - float(each) <= low and high <= middle + float(each))


def _all(conditions: list[Element]) -> Element:
    return node("and", *conditions) if len(conditions) > 1 else conditions[0]


def _add(marks: Fraction) -> Element:
    return _set(SCORE, node("sum", _variable(SCORE), _constant("float", decimal(marks))))


def _told(hint: str) -> Element:
    return _set(HINTS, node("multiple", _variable(HINTS), _constant("identifier", hint)))


def _set(identifier: str, value: Element) -> Element:
    return node("setOutcomeValue", value, identifier=identifier)


def _variable(identifier: str) -> Element:
    return node("variable", identifier=identifier)


def _constant(base: str, value: str) -> Element:
    return node("baseValue", value, baseType=base)
