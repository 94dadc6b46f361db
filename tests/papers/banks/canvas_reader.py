"""Reads a package as Canvas does: what its importer makes of quizzes and questions, and how it marks them.

After `gems/plugins/qti_exporter` of instructure/canvas-lms and what text2qti 0.8 writes: the elements in their order.
"""

from __future__ import annotations

import io
import re
import zipfile
from dataclasses import dataclass, field
from decimal import Decimal, InvalidOperation

from lxml import etree

QTI = "{http://www.imsglobal.org/xsd/ims_qtiasiv1p2}"
CP = "{http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1}"
LARGEST = 16 * 1024

CHILDREN = {
    "questestinterop": "assessment ",
    "assessment": "qtimetadata section ",
    "section": "(selection_ordering )?((item|section) )*",
    "selection_ordering": "selection ",
    "selection": "selection_number selection_extension ",
    "selection_extension": "points_per_item ",
    "item": "itemmetadata presentation (resprocessing )?(itemfeedback )*",
    "itemmetadata": "qtimetadata ",
    "qtimetadata": "(qtimetadatafield )+",
    "qtimetadatafield": "fieldlabel fieldentry ",
    "presentation": "material ((response_lid|response_str) )?",
    "material": "mattext ",
    "response_str": "render_fib ",
    "response_lid": "render_choice ",
    "render_fib": "response_label ",
    "render_choice": "(response_label )+",
    "response_label": "(material )?",
    "resprocessing": "outcomes (respcondition )+",
    "outcomes": "decvar ",
    "respcondition": "conditionvar (setvar )?(displayfeedback )?",
    "conditionvar": "(other |(varequal )+|vargte varlte |or )",
    "or": "varequal and ",
    "and": "vargte varlte ",
    "itemfeedback": "flow_mat ",
    "flow_mat": "material ",
    **dict.fromkeys(["mattext", "fieldlabel", "fieldentry", "decvar", "other", "varequal", "vargte", "varlte", "setvar",
                     "displayfeedback", "selection_number", "points_per_item"], ""),
}  # fmt: skip
ATTRIBUTES = {
    "assessment": "ident title", "section": "ident", "item": "ident title", "mattext": "texttype",
    "response_str": "ident rcardinality", "response_lid": "ident rcardinality", "response_label": "ident",
    "decvar": "maxvalue minvalue varname vartype", "respcondition": "continue", "setvar": "action varname",
    "displayfeedback": "feedbacktype linkrefid", "itemfeedback": "ident",
    "varequal": "respident", "vargte": "respident", "varlte": "respident",
}  # fmt: skip
OPTIONAL = {"section": {"title"}, "render_fib": {"fibtype"}, "response_label": {"rshuffle"}}


def faults(root):
    """Return what a file of questions has that Canvas does not know, in words."""
    found = []
    for each in root.iter():
        name = each.tag.removeprefix(QTI)
        children = "".join(f"{child.tag.removeprefix(QTI)} " for child in each)
        if not re.fullmatch(CHILDREN.get(name, "unknown"), children):
            found.append(f"in {name}: {children}")
        if name != "questestinterop":
            told, wanted = set(each.attrib), set(ATTRIBUTES.get(name, "").split())
            if not wanted <= told <= wanted | OPTIONAL.get(name, set()):
                found.append(f"{name} has {sorted(told)}")
    names = [each.get("ident") for tag in ("item", "section") for each in root.iter(f"{QTI}{tag}")]
    return found + [f"{name} is there twice" for name in names if names.count(name) > 1]


@dataclass
class Question:
    """A question as it is imported: its kind, marks and text; an interval or a value, words or spellings."""

    identifier: str
    title: str
    kind: str
    points: float
    text: str
    right: list = field(default_factory=list)
    words: list = field(default_factory=list)
    neutral: str = ""
    incorrect: str = ""

    def marks(self, typed):
        """Return the marks for what is typed or chosen; None where a person gives them."""
        if self.kind == "essay_question":
            return None
        if self.kind == "numerical_question":
            return self.points * any(low <= number(typed) <= high for low, high in self.right)
        return self.points * (typed.strip().casefold() in {each.casefold() for each in self.right})


@dataclass
class Draw:
    """A group of questions of which one is drawn."""

    title: str
    points: float
    questions: list


@dataclass
class Quiz:
    """A quiz with its title, questions and groups, and its settings."""

    title: str
    entries: list
    settings: dict


def quizzes_of(package):
    """Return the quizzes of a package by the way of its manifest."""
    archive = zipfile.ZipFile(io.BytesIO(package))
    manifest = etree.fromstring(archive.read("imsmanifest.xml"))
    resources = {each.get("identifier"): each for each in manifest.iter(f"{CP}resource")}
    found = []
    for each in resources.values():
        if each.get("type") == "imsqti_xmlv1p2":
            root = etree.fromstring(archive.read(each.find(f"{CP}file").get("href")))
            meta = resources[each.find(f"{CP}dependency").get("identifierref")]
            settings = etree.fromstring(archive.read(meta.get("href")))
            assert faults(root) == []
            section = root.find(f"{QTI}assessment/{QTI}section")
            told = {child.tag.rpartition("}")[2]: child.text or "" for child in settings}
            found.append(Quiz(root.find(f"{QTI}assessment").get("title"), list(map(entry_of, section)), told))
    return found


def entry_of(node):
    """Return a question or a group."""
    if node.tag == f"{QTI}item":
        return question_of(node)
    chosen = node.find(f"{QTI}selection_ordering/{QTI}selection")
    assert chosen.find(f"{QTI}selection_number").text == "1"
    points = float(chosen.find(f"{QTI}selection_extension/{QTI}points_per_item").text)
    return Draw(node.get("title"), points, list(map(question_of, node.iter(f"{QTI}item"))))


def question_of(item):
    """Return a question."""
    told = {each.find(f"{QTI}fieldlabel").text: each.find(f"{QTI}fieldentry").text
            for each in item.iter(f"{QTI}qtimetadatafield")}  # fmt: skip
    text = item.find(f"{QTI}presentation/{QTI}material/{QTI}mattext").text or ""
    if len(text) > LARGEST:
        text = "The imported question text for this question was too long."
    found = Question(item.get("ident"), item.get("title"), told["question_type"], float(told["points_possible"]), text)
    labels = item.iter(f"{QTI}response_label")
    found.words = [(each.get("ident"), "".join(each.itertext()).strip()) for each in labels]
    feedback = {each.get("ident"): "".join(each.itertext()) for each in item.iter(f"{QTI}itemfeedback")}
    shown = {each.get("linkrefid") for each in item.iter(f"{QTI}displayfeedback")}
    assert shown == set(feedback)
    found.neutral, found.incorrect = feedback.pop("general_fb", ""), feedback.pop("general_incorrect_fb", "")
    assert not feedback
    for condition in item.iter(f"{QTI}respcondition"):
        if condition.find(f"{QTI}setvar") is not None:
            assert condition.get("continue") == "No"
            assert condition.find(f"{QTI}setvar").text == "100"
            found.right = right_of(condition.find(f"{QTI}conditionvar"), found.kind)
    return found


def right_of(condition, kind):
    """Return what is right; an exact value is kept only where Canvas does not take it for significant digits."""
    low, high = condition.find(f".//{QTI}vargte"), condition.find(f".//{QTI}varlte")
    if kind != "numerical_question":
        return [each.text for each in condition.iter(f"{QTI}varequal")]
    exact = condition.find(f"{QTI}or/{QTI}varequal")
    if exact is not None:
        assert not is_precision(exact.text, low.text, high.text)
    return [(Decimal(low.text), Decimal(high.text))]


def is_precision(exact, low, high):
    """Return whether Canvas makes a number of significant digits of a value with a margin."""
    ends = all(re.sub("[0.]", "", each).endswith("5") for each in (low, high))
    width = Decimal(high) - Decimal(low)
    same = Decimal(exact) - Decimal(low) == Decimal(high) - Decimal(exact)
    return ends and same and width.normalize().as_tuple().digits == (1,)


def number(typed):
    """Return what is typed as a number; what is none is far off."""
    try:
        return Decimal(typed)
    except InvalidOperation:
        return Decimal("inf")
