from __future__ import annotations

import re
import weakref
from dataclasses import replace
from html.parser import HTMLParser
from itertools import pairwise
from pathlib import Path

import pytest

from solver.derivation import Status
from solver.document.model import Document, Presentation
from solver.render.page import POLICY, STYLE, drawn, encoded_page, render_page
from tests.helpers.sample_pages import ATTACK, hostile, part, sample

VOID = {"meta", "img", "br", "hr", "wbr"}
PROSE = "h1 h2 h3 h4 h5 p span div a code strong em ol ul li table caption thead tbody tr th td wbr"
STRUCTURE = "html head meta title style body header footer main nav section details summary"
MATH = (
    "math mrow mi mn mo mtext mspace msub msup msubsup munder mover munderover mfrac msqrt mroot mtable mtr mtd "
    "mstyle mpadded mphantom"
)
TAGS = set(f"{STRUCTURE} {PROSE} {MATH}".split())


class Reader(HTMLParser):
    """Collects elements and attributes, and fails where elements do not nest."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.opened: list[str] = []
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.text: list[str] = []
        self.feed(page)
        self.close()
        assert self.opened == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        assert len({name for name, _ in attrs}) == len(attrs)
        self.elements.append((tag, dict(attrs)))
        if tag not in VOID:
            self.opened.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.opened.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text.append(data)

    def all(self, tag: str) -> list[dict[str, str | None]]:
        return [attributes for name, attributes in self.elements if name == tag]


@pytest.fixture(scope="module")
def page() -> str:
    return render_page(replace(sample(), name="sample.yaml"))


@pytest.fixture(scope="module")
def read(page: str) -> Reader:
    return Reader(page)


def test_a_page_is_well_formed_and_has_no_elements_but_those_expected(read: Reader) -> None:
    assert {tag for tag, _ in read.elements} <= TAGS


def test_a_page_has_its_style_once_whatever_the_problem_is_called() -> None:
    document = replace(sample(), title=str(STYLE))
    written = render_page(document)
    assert written.count("@font-face") == 1
    assert STYLE not in written
    assert encoded_page(document) == written.encode()


def test_a_page_does_not_keep_its_document() -> None:
    document = replace(sample(), name="let go")
    held = weakref.ref(document)
    assert "let go" in render_page(document)
    del document
    assert held() is None, "it waits for garbage to be collected"


def test_a_page_carries_its_policy_before_anything_that_could_load(page: str, read: Reader) -> None:
    metas = read.all("meta")
    assert {"http-equiv": "Content-Security-Policy", "content": POLICY} in metas
    assert page.index("Content-Security-Policy") < page.index("<style>")
    assert "default-src 'none'" in POLICY
    assert "script" not in POLICY


def test_a_page_refers_to_nothing_outside_itself(page: str, read: Reader) -> None:
    for _, attributes in read.elements:
        assert not {"src", "srcset", "action", "data", "poster", "background"} & attributes.keys()
        assert (attributes.get("href") or "#").startswith("#")
    assert not re.findall(r"@import|url\((?!\"data:)", page)
    assert "http:" not in page
    assert "https:" not in page


def test_links_of_the_contents_lead_to_parts_and_ids_are_unique(read: Reader) -> None:
    ids = [attributes["id"] for _, attributes in read.elements if "id" in attributes]
    assert len(ids) == len(set(ids))
    for link in read.all("a"):
        assert str(link["href"])[1:] in ids
    labels = [attributes["aria-labelledby"] for _, attributes in read.elements if "aria-labelledby" in attributes]
    assert {label for several in labels for label in str(several).split()} <= set(ids)


def test_headings_are_in_order(read: Reader) -> None:
    levels = [int(tag[1]) for tag, _ in read.elements if re.fullmatch("h[1-6]", tag)]
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(after <= before + 1 for before, after in pairwise(levels))


def test_everything_of_the_document_is_on_the_page(read: Reader) -> None:
    text = " ".join("".join(read.text).split())
    for words in (
        "Sample with everything", "Lecture note, 1.16", "Lecture note, section 1.13", "3.5 marks", "1 mark ",
        "Inverse Laplace transform", "Subtract", "A smaller step", "Cofactor by cofactor", "1.2", "numpy.linalg.det",
        "it has the parameter", "A check of this part failed.", "too large", "No answer is given.",
        "has one eigenvector", "A check failed", "Checks: 1 passed, 1 failed, 1 skipped", "Problem file sample.yaml",
        "level of detail “full”",
    ):  # fmt: skip
        assert words in text, words


def test_statuses_are_told_by_words_not_by_colour_alone(page: str) -> None:
    for status, symbol in (("passed", "✓"), ("failed", "✗"), ("skipped", "–"), ("verified", "✓"), ("unsolved", "?")):
        assert f'<span class="badge {status}"><span aria-hidden="true">{symbol}</span> {status}</span>' in page


def test_the_same_document_gives_the_same_bytes() -> None:
    assert render_page(sample()) == render_page(sample())


def test_a_page_of_one_part_has_no_contents() -> None:
    document = Document("One", "", "", "", (part("a", Status.VERIFIED),))
    assert "<nav" not in render_page(document)


def test_all_text_is_escaped() -> None:
    page = render_page(replace(hostile(), name=ATTACK, presentation=Presentation(ATTACK)))
    read = Reader(page)
    assert {tag for tag, _ in read.elements} <= TAGS
    for _, attributes in read.elements:
        assert not [name for name in attributes if name.startswith("on")]
        assert not str(attributes.get("href", "#")).startswith("javascript")
    assert ATTACK in "".join(read.text)
    assert page.count("</style>") == page.count("</title>") == 1


def test_all_formulas_of_the_sample_are_drawn(page: str) -> None:
    assert '<code class="not-drawn"' not in page


def test_a_displayed_formula_has_a_box_of_its_own_and_one_in_a_line_has_none() -> None:
    assert drawn("x", True).startswith('<span class="formula display"><math display="block"')
    assert drawn("x", False).startswith("<math ")


def test_a_formula_that_cannot_be_drawn_is_shown_as_it_stands_and_marked() -> None:
    shown = drawn(r"\foo<b>", False)
    assert shown.startswith('<code class="not-drawn" title="\\foo is not known in formulas here">')
    assert r"\foo&lt;b&gt;</code>" in shown


@pytest.mark.parametrize(("latex", "reached"), [("x = 1", False), (r"x = " + "a + " * 20 + "b", True)])
def test_a_formula_that_may_scroll_can_be_reached_by_keyboard(latex: str, reached: bool) -> None:
    assert ('tabindex="0" role="group" aria-label="Formula"' in drawn(latex, True)) is reached
    assert ("<span" in drawn(latex, False)) is reached


def test_templates_of_ones_own_come_first(tmp_path: Path) -> None:
    (tmp_path / "html").mkdir()
    (tmp_path / "html" / "page.html.jinja").write_text("<p>{{ document.title }} & {{ version }}", encoding="utf-8")
    page = render_page(replace(hostile(), presentation=Presentation(templates=tmp_path)))
    assert page.startswith("<p>&lt;/script&gt;")
