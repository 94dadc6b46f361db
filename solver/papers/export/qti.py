"""QTI 2.1: a package of items, one for each part and variant, and a test that draws one variant of each question.

By "IMS Question and Test Interoperability 2.1", Information Model and XML Binding (2012), and its integration guide for
the manifest. Formulas are Presentation MathML, pictures are files.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from xml.etree.ElementTree import Element

from solver.papers.export.content import images_of
from solver.papers.export.packages import file_of, node, zipped
from solver.papers.export.qti_body import FOLDER, body_of, shown_feedback
from solver.papers.export.qti_marking import declarations_of, hints_of, processing_of
from solver.papers.export.quiz import Content, Item, Quiz
from solver.papers.export.versions import Question, Version, decimal, questions_of
from solver.problem.images import Image

QTI = "http://www.imsglobal.org/xsd/imsqti_v2p1"
PACKAGING = "http://www.imsglobal.org/xsd/imscp_v1p1"
INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"
ITEMS = "items"
TEST = "test.xml"


def qti_package(quiz: Quiz) -> bytes:
    """Return the package as a zip, the same bytes for the same quiz."""
    items = {_path(item): file_of(item_xml(item, quiz.language)) for item in quiz.items}
    pictures = {path_of(image): image.content for item in quiz.items for image in pictures_of(item)}
    manifest = file_of(manifest_xml(quiz), indented=True)
    test = file_of(test_xml(quiz), indented=True)
    return zipped({"imsmanifest.xml": manifest, TEST: test, **items, **pictures})


def item_xml(item: Item, language: str) -> Element:
    """Return an item: declarations, what is asked, how it is marked, hints and the worked solution."""
    return _root(
        "assessmentItem",
        [*declarations_of(item), body_of(item), processing_of(item), *hints_of(item), shown_feedback(item.feedback)],
        identifier=item.identifier, title=item.name, xml_lang=language, adaptive="false", timeDependent="false",
    )  # fmt: skip


def test_xml(quiz: Quiz) -> Element:
    """Return the test: all is submitted together, once; feedback and solutions are shown after that.

    A question with several variants is a section that selects one of its sections.
    """
    questions = questions_of(quiz)
    total = sum((question.versions[0].marks for question in questions), Fraction(0))
    score = node("sum", node("testVariables", variableIdentifier="SCORE"))
    session = node("itemSessionControl", maxAttempts="1", showFeedback="true", allowReview="true")
    part = node(
        "testPart", session, *map(_section, questions),
        identifier="part", navigationMode="nonlinear", submissionMode="simultaneous",
    )  # fmt: skip
    return _root(
        "assessmentTest",
        [
            node("outcomeDeclaration", identifier="SCORE", cardinality="single", baseType="float",
                 normalMaximum=decimal(total)),
            part,
            node("outcomeProcessing", node("setOutcomeValue", score, identifier="SCORE")),
        ],
        identifier="exam", title=quiz.title,
    )  # fmt: skip


def _section(question: Question) -> Element:
    name = f"question-{question.number}"
    versions = question.versions
    if len(versions) == 1:
        inside = _references(versions[0])
    else:
        inside = [node("selection", select="1"), *(_version(question, f"{name}-variant-{number}", version)
                  for number, version in enumerate(versions, 1))]  # fmt: skip
    return node("assessmentSection", *inside, identifier=name, title=question.title, visible="true")


def _version(question: Question, name: str, version: Version) -> Element:
    """Return a version: where it is drawn, all of its items are."""
    items = _references(version)
    return node(
        "assessmentSection", *items, identifier=name, title=question.title, visible="false", keepTogether="true"
    )


def _references(version: Version) -> list[Element]:
    return [node("assessmentItemRef", identifier=f"item-{each.identifier}", href=_path(each)) for each in version.items]


def _path(item: Item) -> str:
    return f"{ITEMS}/{item.identifier}.xml"


def manifest_xml(quiz: Quiz) -> Element:
    """Return what the package holds."""
    described = node("metadata", node("schema", "QTIv2.1 Package"), node("schemaversion", "1.0.0"))
    items = list(quiz.items)
    test = node(
        "resource", _file(TEST), *(node("dependency", identifierref=f"item-{each.identifier}") for each in items),
        identifier="test", type="imsqti_test_xmlv2p1", href=TEST,
    )  # fmt: skip
    resources = node("resources", test, *map(_resource, items))
    content = [described, node("organizations"), resources]
    schema = f"{PACKAGING} {PACKAGING}.xsd"
    return node("manifest", *content, xmlns=PACKAGING, identifier="package", **_located(schema))


def _resource(item: Item) -> Element:
    path = _path(item)
    files = [_file(path), *(_file(path_of(image)) for image in pictures_of(item))]
    return node("resource", *files, identifier=f"item-{item.identifier}", type="imsqti_item_xmlv2p1", href=path)


def _file(path: str) -> Element:
    return node("file", href=path)


def pictures_of(item: Item) -> list[Image]:
    """Return the images of an item, each once."""
    contents: Iterable[Content] = [item.question, item.feedback, *([item.essay.key] if item.essay else [])]
    return list(dict.fromkeys(image for content in contents for image in images_of(content)))


def path_of(image: Image) -> str:
    """Return where an image lies in the package."""
    return f"{ITEMS}/{FOLDER}/{image.file_name}"


def _root(tag: str, content: Sequence[Element], **attributes: str) -> Element:
    schema = f"{QTI} http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1p1.xsd"
    return node(tag, *content, xmlns=QTI, **attributes, **_located(schema))


def _located(schema: str) -> dict[str, str]:
    return {"xmlns:xsi": INSTANCE, "xsi:schemaLocation": schema}
