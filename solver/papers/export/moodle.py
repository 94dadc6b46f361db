"""A bank as Moodle XML: questions with gaps, numerical ones, choices, essays; the worked solution as feedback."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterator
from dataclasses import replace
from html import escape
from xml.etree.ElementTree import Element

from solver.papers.export.cloze import gap, hint, share_of, weights_of, without_gaps
from solver.papers.export.content import html_of, images_of, line_of, with_tex
from solver.papers.export.decimals import written
from solver.papers.export.packages import file_of, node
from solver.papers.export.quiz import Asked, Choice, Content, Field, Fixed, Item, Number, Quiz
from solver.problem.images import Image

TOP = "$course$/top"
LONGEST = 255
"""Letters of a name that Moodle keeps."""

LITERAL = "text"
"""Elements whose text stands in CDATA sections: between two signs that are escaped Moodle's reader loses a space."""


def moodle_xml(quiz: Quiz) -> bytes:
    """Return the bank as a file that Moodle imports ("Moodle XML format"), a category for each group."""
    root = node("quiz")
    for group in quiz.groups:
        path = "/".join([TOP, *(part.replace("/", "//") for part in group.path)])
        root.append(node("question", node("category", _text(path)), type="category"))
        for item in group.items:
            root.append(_question(item))
    return file_of(root, literal=LITERAL)


def _question(item: Item) -> Element:
    if item.essay is not None:
        return node("question", *_common(item, _question_html(item, {})), *_essay(item), type="essay")
    alone = _alone(item)
    if alone is None:
        fields = item.fields
        weights = weights_of(fields, item.marks)
        gaps = {field.key: gap(field, weight) for field, weight in zip(fields, weights, strict=True)}
        shown = "" if sum(weights) == item.marks else f" ({_marks(item)})"
        told = replace(item, name=item.name[: LONGEST - len(shown)] + shown)
        return node("question", *_common(told, _question_html(item, gaps), graded=False), type="cloze")
    content = _common(item, _question_html(item, {alone.key: ""}))
    match alone:
        case Number():
            return node("question", *content, *_numerical(alone), type="numerical")
        case Choice():
            return node("question", *content, *_choice(alone), type="multichoice")


def _alone(item: Item) -> Field | None:
    """Return the only field where it is at the end of its line: a question of its own kind can ask for it."""
    fields = item.fields
    last = [line[-1] for asked in item.answers for line in asked.lines]
    return fields[0] if len(fields) == 1 and last == [fields[0]] else None


def _common(item: Item, question: str, *, graded: bool = True) -> list[Element]:
    """Return what all kinds of questions have; one with gaps is worth what its gaps weigh."""
    marks = [node("defaultgrade", _marks(item))] if graded else []
    return [
        node("name", _text(item.name[:LONGEST])),
        _html("questiontext", question, item.question),
        _html("generalfeedback", with_tex(lambda math: html_of(item.feedback, math, _address)), item.feedback),
        *marks,
        node("penalty", "0"),
        node("hidden", "0"),
        node("idnumber", item.identifier),
        node("tags", *(node("tag", _text(tag)) for tag in item.tags)),
    ]


def _marks(item: Item) -> str:
    return f"{float(item.marks):.7g}"


def _question_html(item: Item, gaps: dict[str, str]) -> str:
    """Return the question with the gaps of its fields by their keys."""
    html = [without_gaps(with_tex(lambda math: html_of(item.question, math, _address)))]
    for asked in item.answers:
        html += [_asked_html(asked, gaps)]
    return "\n".join(html)


def _asked_html(asked: Asked, gaps: dict[str, str]) -> str:
    """Return what an answer is, its fields, and how they are filled in."""
    form = with_tex(lambda math: line_of(asked.form, math)) if asked.form else ""
    meaning = with_tex(lambda math: line_of(_sentence(asked.meaning), math))
    heading = f"<p><strong>{meaning}</strong></p>"
    told = f"<p><small>{form}</small></p>" if form else ""
    if not asked.grid:
        cells = (" ".join(filter(None, (_cell(cell, gaps) for cell in line))) for line in asked.lines)
        lines = "\n".join(f"<p>{line}</p>" for line in cells if line)
        return without_gaps(f"{heading}\n{told}\n").replace("\n\n", "\n") + lines
    rows = [[f"<td>{_cell(cell, gaps)}</td>" for cell in line] for line in asked.lines]
    name = without_gaps(_cell(Fixed(f"{asked.symbol} ="), gaps))
    rows[0].insert(0, f'<th rowspan="{len(rows)}">{name}</th>')
    table = "\n".join(f"<tr>{''.join(row)}</tr>" for row in rows)
    return without_gaps(f"{heading}\n{told}\n").replace("\n\n", "\n") + f"<table>\n{table}\n</table>"


def _cell(cell: Field | Fixed, gaps: dict[str, str]) -> str:
    if isinstance(cell, Fixed):
        return without_gaps(with_tex(lambda math: math(cell.latex, False))) if cell.latex else ""
    return gaps[cell.key]


def _sentence(words: str) -> str:
    return words[:1].upper() + words[1:]


def _numerical(field: Number) -> Iterator[Element]:
    yield _answer("100", written(field.value), written(field.tolerance))
    for wrong in field.wrong:
        yield _answer(share_of(wrong.share), written(wrong.value), written(wrong.tolerance), hint(wrong.hint))
    for name, value in (("unitgradingtype", "0"), ("unitpenalty", "0.1"), ("showunits", "3"), ("unitsleft", "0")):
        yield node(name, value)


def _choice(field: Choice) -> Iterator[Element]:
    yield node("single", "true")
    yield node("shuffleanswers", "false")
    yield node("answernumbering", "none")
    for i, word in enumerate(field.words):
        yield _answer("100" if i == field.right else "0", escape(word), format_="html")


def _answer(
    fraction: str, text: str, tolerance: str = "", feedback: str = "", format_: str = "moodle_auto_format"
) -> Element:
    own = [node("tolerance", tolerance)] if tolerance else []
    told = node("feedback", _text(feedback), format="html")
    return node("answer", _text(text), *own, told, fraction=fraction, format=format_)


def _essay(item: Item) -> Iterator[Element]:
    """Yield how an essay is answered, and the key for who marks it."""
    for name, value in (("responseformat", "editorfilepicker"), ("responserequired", "0"),
                        ("responsefieldlines", "15"), ("attachments", "3"), ("attachmentsrequired", "0")):  # fmt: skip
        yield node(name, value)
    key = item.essay.key if item.essay is not None else Content()
    yield _html("graderinfo", with_tex(lambda math: html_of(key, math, _address)), key)
    yield node("responsetemplate", _text(""), format="html")


def _html(tag: str, html: str, content: Content) -> Element:
    """Return HTML with its images."""
    files = [
        node("file", b64encode(image.content).decode("ascii"), name=image.file_name, path="/", encoding="base64")
        for image in images_of(content)
    ]
    return node(tag, _text(html), *files, format="html")


def _address(image: Image) -> str:
    return f"@@PLUGINFILE@@/{image.file_name}"


def _text(text: str) -> Element:
    return node(LITERAL, text)
