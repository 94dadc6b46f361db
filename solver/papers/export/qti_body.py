"""What a QTI item shows: the question, the fields of its answers, and the worked solution, in the XHTML of QTI.

That is a part of XHTML without styles. A matrix is a table of fields; other answers are lines, with fields in them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from html import escape
from xml.etree.ElementTree import Element

from solver.formula import MathProblem
from solver.formula.mathml import mathml
from solver.papers.export.content import html_of, line_of
from solver.papers.export.packages import append_text, contents_of, node, read, read_line
from solver.papers.export.quiz import Asked, Choice, Content, Essay, Field, Fixed, Item
from solver.problem.images import Image

MATHML = "http://www.w3.org/1998/Math/MathML"
FOLDER = "images"
"""Where images lie, beside the folder's items."""

LINES, WIDTH = 15, 10
"""The size of a field for an essay, and of one for a number: the same for all, as it must not tell the answer."""

ESSAY, SOLUTION, SHOWN = "essay", "SOLUTION", "worked"
"""The response of an essay; the outcome that shows the worked solution, and its value."""

_KEPT = {"a": ("href",), "img": ("alt", "src")}
"""The attributes of text that QTI knows, too; styles and classes are left behind."""

_ALIGNED = ("left", "right", "center")


def body_of(item: Item) -> Element:
    """Return what a candidate sees, and for an essay the key, which only who marks it sees."""
    asked = [each for answer in item.answers for each in _answer(answer)]
    return node("itemBody", *blocks(item.question), *asked, *(_essay(item.essay) if item.essay else []))


def shown_feedback(content: Content) -> Element:
    """Return the worked solution."""
    return feedback(SOLUTION, SHOWN, *blocks(content))


def feedback(outcome: str, identifier: str, *content: Element) -> Element:
    """Return what is shown once an outcome has a value."""
    return node("modalFeedback", *content, outcomeIdentifier=outcome, identifier=identifier, showHide="show")


def blocks(content: Content) -> list[Element]:
    """Return content as blocks of QTI."""
    known = map(_known, read(html_of(content, drawn, _address)))
    return [block for each in known for block in _blocks(each)]


def line(markdown: str) -> Element:
    """Return a line of Markdown as a paragraph."""
    return _known(read_line(line_of(markdown, drawn)))


def drawn(latex: str, displayed: bool) -> str:
    """Return a formula as MathML, or as the text it is where it cannot be drawn."""
    try:
        return mathml(latex, displayed).markup
    except MathProblem:
        return f"<code>{escape(latex)}</code>"


def formula(latex: str) -> Element:
    """Return a formula to stand in a line."""
    return _known(read(drawn(latex, False))[0])


def _address(image: Image) -> str:
    return f"{FOLDER}/{image.file_name}"


def _known(element: Element) -> Element:
    """Return the element with all in it as QTI knows it."""
    if element.tag == "math":
        element.set("xmlns", MATHML)
        return _aligned(element)
    kept = {name: element.attrib[name] for name in _KEPT.get(element.tag, ()) if name in element.attrib}
    if element.tag == "a" and kept.get("href", "#").startswith("#"):  # a place of a page; there is none here
        element.tag, kept = "span", {}
    element.attrib.clear()
    element.attrib.update(kept)
    for each in element:
        _known(each)
    return element


def _aligned(math: Element) -> Element:
    """Say how cells are aligned also as MathML before MathML Core says it, for systems that do not read styles."""
    for cell in math.iter("mtd"):
        side = next((each for each in _ALIGNED if f"text-align:{each}" in cell.get("style", "")), "")
        if side:
            cell.set("columnalign", side)
    return math


def _blocks(element: Element) -> Iterator[Element]:
    """Yield an element as blocks that keep apart: displayed formulas one below the other in paragraphs of their own."""
    if element.tag == "math":
        yield node("p", element)
    elif element.tag != "p":
        yield element
    else:
        paragraph, last = node("p"), None
        for each in contents_of(element):
            if _is_displayed(each) and last is not None and _is_displayed(last):
                yield paragraph
                paragraph = node("p")
            if isinstance(each, Element):
                paragraph.append(each)
            else:
                append_text(paragraph, each)
            last = each if isinstance(each, Element) or each.strip() else last
        yield paragraph


def _is_displayed(content: Element | str) -> bool:
    return isinstance(content, Element) and content.tag == "math" and content.get("display") == "block"


def _answer(asked: Asked) -> Iterator[Element]:
    """Yield what is asked, how it is typed, and the fields."""
    yield _named("p", asked.symbol, asked.meaning)
    if asked.form:
        yield line(asked.form)
    if asked.grid:
        yield _grid(asked)
    else:
        yield from map(_line, asked.lines)


def _named(tag: str, symbol: str, meaning: str) -> Element:
    """Return what an answer is, behind its symbol where it has one."""
    named: list[Element | str] = [formula(symbol), ": "] if symbol else []
    return node(tag, *named, *contents_of(line(meaning)))


def _grid(asked: Asked) -> Element:
    name = node("td", formula(f"{asked.symbol} ="), rowspan=str(len(asked.lines)))
    rows = [node("tr", *([] if i else [name]), *(node("td", _inline(cell)) for cell in each))
            for i, each in enumerate(asked.lines)]  # fmt: skip
    return node("table", node("tbody", *rows))


def _line(cells: Sequence[Field | Fixed]) -> Element:
    """Return a line; where all there is to do is to choose a word, the words stand one below the other."""
    fields = [cell for cell in cells if not isinstance(cell, Fixed)]
    last = cells[-1]
    if len(fields) == 1 and isinstance(last, Choice):
        prompt = _spaced(node("prompt"), cells[:-1])
        return _choice(last, [prompt] if len(prompt) else [])
    return _spaced(node("p"), cells)


def _spaced(parent: Element, cells: Sequence[Field | Fixed]) -> Element:
    for cell in cells:
        if cell == Fixed(""):
            continue
        if len(parent):
            append_text(parent, " ")
        parent.append(_inline(cell))
    return parent


def _inline(cell: Field | Fixed) -> Element:
    if isinstance(cell, Fixed):
        return formula(cell.latex)
    if isinstance(cell, Choice):
        words = [node("inlineChoice", word, identifier=word_of(i)) for i, word in enumerate(cell.words)]
        return node("inlineChoiceInteraction", *words, responseIdentifier=cell.key, shuffle="false", label=cell.label)
    return node("textEntryInteraction", responseIdentifier=cell.key, expectedLength=str(WIDTH), label=cell.label)


def _choice(field: Choice, prompt: list[Element]) -> Element:
    words = [node("simpleChoice", word, identifier=word_of(i)) for i, word in enumerate(field.words)]
    return node("choiceInteraction", *prompt, *words, responseIdentifier=field.key, shuffle="false", maxChoices="1")


def word_of(index: int) -> str:
    """Return the identifier of a word that can be chosen."""
    return f"word-{index + 1}"


def _essay(essay: Essay) -> Iterator[Element]:
    items = [_named("li", latex, meaning) for latex, meaning in essay.asked]
    if items:
        yield node("ul", *items)
    yield node("rubricBlock", *blocks(essay.key), view="scorer")
    yield node("extendedTextInteraction", responseIdentifier=ESSAY, expectedLines=str(LINES))
