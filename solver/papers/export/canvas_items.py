"""Questions of Canvas: a field of an answer is one, an essay is one.

A number is right between two values, a word where it is the one; there are all marks for it or none.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import starmap
from xml.etree.ElementTree import Element

from solver.papers.export.canvas_text import asks, asks_essay, hints, parts_of, told
from solver.papers.export.content import images_of
from solver.papers.export.packages import node
from solver.papers.export.quiz import Choice, Field, Item, Number
from solver.papers.export.versions import decimal, marks_of_fields
from solver.problem.images import Image

RESPONSE = "response1"


@dataclass(frozen=True, slots=True)
class Slot:
    """A question of Canvas: an item's field, or where there is none its essay, with its marks.

    `text` is what it asks; `whole_text` has before it what the item is about. The `is_last` of an item tells the worked
    solution.
    """

    item: Item
    field: Field | None
    marks: Fraction
    text: str
    is_alone: bool = True
    is_last: bool = True

    @property
    def name(self) -> str:
        """Its identifier among all questions of a variant."""
        return self.item.identifier if self.field is None else f"{self.item.identifier}-{self.field.key}"

    @property
    def title(self) -> str:
        """The name of the item, with what the field is where there are others."""
        return self.item.name if self.field is None or self.is_alone else f"{self.item.name}: {self.field.label}"

    @property
    def whole_text(self) -> str:
        """What it asks, with all that is needed for it."""
        return told(self.item.question, self.text)


def slots_of(item: Item) -> list[Slot]:
    """Return the questions that an item becomes."""
    if item.essay:
        return [Slot(item, None, item.marks, asks_essay(item.essay))]
    is_alone, last = len(item.fields) == 1, item.fields[-1]
    return [
        Slot(item, field, marks, asks(asked, field), is_alone, field == last)
        for asked in item.answers
        for field, marks in marks_of_fields(asked).items()
    ]


def images_in(item: Item) -> list[Image]:
    """Return the images that the questions of an item show."""
    return [*images_of(item.question), *images_of(item.feedback)]


def stem_of(item: Item, identifier: str) -> Iterator[Element]:
    """Yield what an item is about as texts without an answer."""
    for number, html in enumerate(parts_of(item.question), 1):
        name = f"{identifier}-text-{number}"
        presentation = node("presentation", _material(html))
        yield node("item", _metadata("text_only_question", Fraction(0), name), presentation,
                   ident=name, title=item.name)  # fmt: skip


def item_of(slot: Slot, identifier: str, html: str) -> Element:
    """Return a question with its text; below the last of an item stands the solution, once the instructor shows it."""
    match slot.field:
        case Number() as field:
            kind, answer, right = "numerical_question", _text("Decimal"), _between(field)
        case Choice() as field:
            kind, answer, right = "multiple_choice_question", _words(field), [_equal(_word(field.right))]
        case None:
            kind, answer, right = "essay_question", _text(), []
    texts = {
        "general_fb": told(slot.item.feedback) if slot.is_last else "",
        "general_incorrect_fb": hints(slot.field.wrong) if isinstance(slot.field, Number) else "",
    }
    feedback = {name: text for name, text in texts.items() if text}
    return node(
        "item", _metadata(kind, slot.marks, identifier), node("presentation", _material(html), answer),
        _processing(right, list(feedback)), *starmap(_feedback, feedback.items()), ident=identifier, title=slot.title,
    )  # fmt: skip


def _metadata(kind: str, marks: Fraction, identifier: str) -> Element:
    told = {
        "question_type": kind,
        "points_possible": decimal(marks),
        "assessment_question_identifierref": f"{identifier}-question",
    }
    fields = [node("qtimetadatafield", node("fieldlabel", name), node("fieldentry", value))
              for name, value in told.items()]  # fmt: skip
    return node("itemmetadata", node("qtimetadata", *fields))


def _material(html: str) -> Element:
    return node("material", node("mattext", html, texttype="text/html"))


def _text(kind: str = "") -> Element:
    """Return a field to type into."""
    shown = node("render_fib", node("response_label", ident="answer1"), **({"fibtype": kind} if kind else {}))
    return node("response_str", shown, ident=RESPONSE, rcardinality="Single")


def _words(field: Choice) -> Element:
    labels = [
        node("response_label", node("material", node("mattext", word, texttype="text/plain")), ident=_word(index))
        for index, word in enumerate(field.words)
    ]
    return node("response_lid", node("render_choice", *labels), ident=RESPONSE, rcardinality="Single")


def _word(index: int) -> str:
    return str(index + 1)


def _equal(value: str) -> Element:
    return node("varequal", value, respident=RESPONSE)


def _between(field: Number) -> list[Element]:
    """Return the edges of what is right; a whole number is exact, with a margin of nothing.

    An interval is no `exact` value with a margin, as of some of those Canvas makes a number of significant digits.
    """
    low, high = (f"{field.value + sign * field.tolerance:f}" for sign in (-1, 1))
    edges = [node("vargte", low, respident=RESPONSE), node("varlte", high, respident=RESPONSE)]
    return edges if field.tolerance else [node("or", _equal(f"{field.value:f}"), node("and", *edges))]


def _processing(right: list[Element], feedback: list[str]) -> Element:
    """Return how it is marked; an essay is not. What is shown in any case comes first, and for a wrong answer last."""
    score = node("decvar", maxvalue="100", minvalue="0", varname="SCORE", vartype="Decimal")
    earned = [node("setvar", "100", action="Set", varname="SCORE")] if right else []
    shown = {name: _condition([node("other")], _shown(name), again=True) for name in feedback}
    last = shown.pop("general_incorrect_fb", None)
    marked = _condition(right or [node("other")], *earned)
    return node("resprocessing", node("outcomes", score), *shown.values(), marked, *([] if last is None else [last]))


def _condition(when: list[Element], *then: Element, again: bool = False) -> Element:
    return node("respcondition", node("conditionvar", *when), *then, continue_="Yes" if again else "No")


def _shown(feedback: str) -> Element:
    return node("displayfeedback", feedbacktype="Response", linkrefid=feedback)


def _feedback(identifier: str, html: str) -> Element:
    return node("itemfeedback", node("flow_mat", _material(html)), ident=identifier)
