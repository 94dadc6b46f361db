"""Canvas: a package of quizzes in QTI 1.2 as its importer of classic quizzes reads it.

By that importer (instructure/canvas-lms, `gems/plugins/qti_exporter`) and what text2qti writes. Canvas draws single
questions, not groups of them, so there is one quiz that draws a variant of each question only where each is one
question in Canvas, too; else there is a quiz for each variant, to be assigned to those who are to get it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from hashlib import sha256
from xml.etree.ElementTree import Element

from solver.papers.export.canvas_items import Slot, images_in, item_of, slots_of, stem_of
from solver.papers.export.canvas_text import IMAGES, fits
from solver.papers.export.packages import file_of, node, zipped
from solver.papers.export.quiz import Quiz
from solver.papers.export.versions import Question, Version, decimal, questions_of, variants_of

QTI = "http://www.imsglobal.org/xsd/ims_qtiasiv1p2"
CARTRIDGE = "http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1"
METADATA = "http://www.imsglobal.org/xsd/imsmd_v1p2"
SETTINGS = "http://canvas.instructure.com/xsd/cccv1p0"
INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"


@dataclass(frozen=True, slots=True)
class Assessment:
    """A quiz in Canvas: its identifier, its title, its content, and the marks a student can earn."""

    identifier: str
    title: str
    entries: tuple[Element, ...]
    marks: Fraction

    @property
    def path(self) -> str:
        """Where it lies in the package."""
        return f"{self.identifier}/{self.identifier}.xml"

    @property
    def settings(self) -> str:
        """Where its settings lie."""
        return f"{self.identifier}/assessment_meta.xml"


def canvas_package(quiz: Quiz) -> bytes:
    """Return the package as a zip, the same bytes for the same quiz."""
    assessments = list(assessments_of(quiz))
    pictures = dict.fromkeys(image for item in quiz.items for image in images_in(item))
    images = {f"{IMAGES}/{image.file_name}": image.content for image in pictures}
    files = {"imsmanifest.xml": file_of(_manifest(quiz, assessments, list(images)), indented=True)}
    for each in assessments:
        files[each.settings] = file_of(_settings(each), indented=True)
        files[each.path] = file_of(_questions(each))
    return zipped(files | images)


def assessments_of(quiz: Quiz) -> Iterator[Assessment]:
    """Yield one quiz that draws variants, or a quiz for each variant.

    Identifiers begin with one of the exam: an import overwrites what came with the same ones.
    """
    exam = "exam-" + sha256(f"{quiz.course}\n{quiz.title}".encode()).hexdigest()[:12]
    questions = questions_of(quiz)
    if all(map(_is_drawn, questions)):
        drawn = tuple(each for question in questions for each in _drawn(question, exam))
        yield Assessment(exam, quiz.title, drawn, _marks([question.versions[0] for question in questions]))
        return
    for number, variant in enumerate(variants_of(questions), 1):
        name = f"{exam}-{number}" if variant else exam
        versions = [question.of(variant) for question in questions]
        entries = tuple(each for version in versions for each in _asked(version, name))
        yield Assessment(name, f"{quiz.title} ({variant})" if variant else quiz.title, entries, _marks(versions))


def _marks(versions: Sequence[Version]) -> Fraction:
    return sum((version.marks for version in versions), Fraction(0))


def _is_drawn(question: Question) -> bool:
    """Return whether each version is a single question in Canvas, with the same marks."""
    slots = [_slots(version) for version in question.versions]
    return (
        all(len(each) == 1 for each in slots)
        and len({each[0].marks for each in slots}) == 1
        and all(fits(each[0].whole_text) for each in slots)
    )


def _slots(version: Version) -> list[Slot]:
    return [slot for item in version.items for slot in slots_of(item)]


def _drawn(question: Question, exam: str) -> Iterator[Element]:
    """Yield the one question, or the group of which Canvas draws one."""
    slots = [slot for version in question.versions for slot in _slots(version)]
    items = [item_of(slot, f"{exam}-{slot.name}", slot.whole_text) for slot in slots]
    if len(items) == 1:
        yield items[0]
        return
    points = node("selection_extension", node("points_per_item", decimal(slots[0].marks)))
    selection = node("selection", node("selection_number", "1"), points)
    ordering = node("selection_ordering", selection)
    yield node("section", ordering, *items, ident=f"{exam}-group-{question.number}", title=question.title)


def _asked(version: Version, name: str) -> Iterator[Element]:
    """Yield the questions of a version: where an item is several, what all of them ask about comes first, once."""
    for item in version.items:
        slots = slots_of(item)
        alone = len(slots) == 1 and fits(slots[0].whole_text)
        if not alone:
            yield from stem_of(item, f"{name}-{item.identifier}")
        for slot in slots:
            yield item_of(slot, f"{name}-{slot.name}", slot.whole_text if alone else slot.text)


def _questions(assessment: Assessment) -> Element:
    attempts = node("qtimetadatafield", node("fieldlabel", "cc_maxattempts"), node("fieldentry", "1"))
    section = node("section", *assessment.entries, ident="root_section")
    content = [node("qtimetadata", attempts), section]
    told = node("assessment", *content, ident=assessment.identifier, title=assessment.title)
    return node("questestinterop", told, xmlns=QTI, **_located(f"{QTI} {QTI}p1.xsd"))


def _settings(assessment: Assessment) -> Element:
    """Return the settings: not published, and answers and solutions hidden, until the instructor says otherwise."""
    marks = decimal(assessment.marks)
    task = node(
        "assignment",
        node("title", assessment.title), node("workflow_state", "unpublished"),
        node("quiz_identifierref", assessment.identifier), node("points_possible", marks),
        node("grading_type", "points"), node("submission_types", "online_quiz"),
        identifier=f"{assessment.identifier}-assignment",
    )  # fmt: skip
    told = {
        "title": assessment.title, "description": "", "shuffle_answers": "false", "scoring_policy": "keep_highest",
        "hide_results": "always", "quiz_type": "assignment", "points_possible": marks, "show_correct_answers": "false",
        "allowed_attempts": "1", "one_question_at_a_time": "false", "cant_go_back": "false", "available": "false",
    }  # fmt: skip
    content = [*(node(name, value) for name, value in told.items()), task]
    located = _located(f"{SETTINGS} https://canvas.instructure.com/xsd/cccv1p0.xsd")
    return node("quiz", *content, identifier=assessment.identifier, xmlns=SETTINGS, **located)


def _manifest(quiz: Quiz, assessments: Sequence[Assessment], images: Sequence[str]) -> Element:
    title = node("imsmd:title", node("imsmd:string", quiz.title))
    described = node(
        "metadata", node("schema", "IMS Content"), node("schemaversion", "1.1.3"),
        node("imsmd:lom", node("imsmd:general", title)),
    )  # fmt: skip
    resources = [each for assessment in assessments for each in _resources(assessment)]
    pictures = [
        node("resource", node("file", href=path), identifier=f"image-{number}", type="webcontent", href=path)
        for number, path in enumerate(images, 1)
    ]
    content = [described, node("organizations"), node("resources", *resources, *pictures)]
    named = {"xmlns": CARTRIDGE, "xmlns:imsmd": METADATA}
    return node("manifest", *content, identifier="package", **named, **_located(f"{CARTRIDGE} {CARTRIDGE}.xsd"))


def _resources(assessment: Assessment) -> Iterator[Element]:
    settings = f"{assessment.identifier}-settings"
    content = [node("file", href=assessment.path), node("dependency", identifierref=settings)]
    yield node("resource", *content, identifier=assessment.identifier, type="imsqti_xmlv1p2")
    kind = "associatedcontent/imscc_xmlv1p1/learning-application-resource"
    file = node("file", href=assessment.settings)
    yield node("resource", file, identifier=settings, type=kind, href=assessment.settings)


def _located(schema: str) -> dict[str, str]:
    return {"xmlns:xsi": INSTANCE, "xsi:schemaLocation": schema}
