"""A reader of Moodle XML that shares nothing with the writer: it loses what Moodle's loses, and marks as Moodle does.

After `public/lib/classes/xml_parser.php`, `public/question/format/xml/format.php` and
`public/question/type/multianswer/questiontype.php` of moodle/moodle (5.1), and what gaps were before.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from html import unescape
from xml.etree import ElementTree
from xml.parsers import expat

ALT = r"((?:=|%(?:-?[0-9]+(?:[.,][0-9]*)?)%)?)(.+?HIDDEN(?=[~#}]|$))(#(.*?(?<!\\)(?=[~}]|$)))?"
HIDDEN = (r"(?<!\\)", r"(?<!\\)(?<!&)(?<!&amp;)")
"""What no answer ends behind, in Moodle 5 and before."""

NUMBER = re.compile(r"-?(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?:[eE][-+]?[0-9]+)?")
PLACE = re.compile(r"\{#\d+\}")
"""What Moodle writes in the place of a gap."""

FRACTIONS = {100, 90, 83.33333, 80, 75, 70, 66.66667, 60, 50, 40, 33.33333, 30, 25, 20, 16.66667, 14.28571, 12.5,
             11.11111, 10, 5, 0}  # fmt: skip
TYPES = {"cloze", "numerical", "multichoice", "essay"}


@dataclass
class Answer:
    """What is taken for an answer: a text, or a number with its tolerance; the percentage, the feedback in HTML."""

    fraction: float
    text: str
    feedback: str = ""
    tolerance: float | None = None

    def takes(self, typed: str, kind: str) -> bool:
        """Whether Moodle takes what is typed for this answer."""
        if kind != "NUMERICAL":
            return typed.strip().lower() == self.text.strip().lower()
        slack = abs(float(self.text)) * 2e-14
        return abs(float(typed) - float(self.text)) <= (self.tolerance or 0) + slack


@dataclass
class Gap:
    """A field: its weight, its kind, and the answers in their order."""

    weight: float
    kind: str
    answers: list[Answer]

    def marked(self, typed: str) -> tuple[float, str]:
        """Return the percentage and the feedback for what is typed."""
        for answer in self.answers:
            if answer.takes(typed, self.kind):
                return answer.fraction, answer.feedback
        return 0.0, ""

    @property
    def right(self) -> list[str]:
        """What earns all."""
        return [each.text for each in self.answers if each.fraction == 100]


@dataclass
class Read:
    """A question of the file, and the category it stands in."""

    category: str
    type: str
    name: str
    text: str
    feedback: str
    idnumber: str
    grade: float
    gaps: list[Gap]
    tags: list[str]
    files: dict[str, str] = field(default_factory=dict)
    key: str = ""


def read_moodle(content: bytes) -> list[Read]:
    """Return the questions of a file as Moodle imports them; raises AssertionError where it would refuse or misread."""
    assert content.startswith(b"<?xml")
    root = parsed(content)
    assert root.tag == "quiz"
    found: list[Read] = []
    category = ""
    for question in root:
        if question.get("type") == "category":
            category = told(question, "category")
            assert category.startswith("$course$/top/")
            continue
        assert category, "a category stands first"
        found.append(read_question(question, category))
    numbers = [each.idnumber for each in found]
    assert len(set(numbers)) == len(numbers)
    return found


def parsed(content: bytes) -> ElementTree.Element:
    """Return the elements as Moodle's parser has them: of a text it loses each piece that is white.

    Pieces are what stands between two signs that are escaped, and whole sections of CDATA.
    """
    builder, pieces, sections = ElementTree.TreeBuilder(), list[str](), [False]

    def ended() -> None:
        text = "".join(pieces)
        pieces.clear()
        if text.strip():
            builder.data(text)

    def piece(text: str) -> None:
        pieces.append(text)
        if not sections[0]:
            ended()

    def section(begins: bool) -> None:
        ended()
        sections[0] = begins

    parser = expat.ParserCreate()
    parser.StartElementHandler = builder.start
    parser.EndElementHandler = builder.end
    parser.CharacterDataHandler = piece
    parser.StartCdataSectionHandler = lambda: section(True)
    parser.EndCdataSectionHandler = lambda: section(False)
    parser.Parse(content, True)
    return builder.close()


def told(element: ElementTree.Element, tag: str) -> str:
    """Return the text of a child."""
    child = element.find(f"{tag}/text")
    return "" if child is None else child.text or ""


def read_question(question: ElementTree.Element, category: str) -> Read:
    """Return one question."""
    kind = question.get("type") or ""
    assert kind in TYPES
    htmls = {tag: told(question, tag) for tag in ("questiontext", "generalfeedback", "graderinfo")}
    files: dict[str, str] = {}
    for tag, html in htmls.items():
        own = {each.get("name"): each.text or "" for each in question.findall(f"{tag}/file")}
        assert set(re.findall(r"@@PLUGINFILE@@/([\w.-]+)", html)) == set(own)
        files |= {str(name): text for name, text in own.items()}
        harmless(html)
    gaps = gaps_of(htmls["questiontext"]) if kind == "cloze" else [alone(question, kind)] if kind != "essay" else []
    for each in (answer for gap in gaps for answer in gap.answers):
        assert each.fraction in FRACTIONS
        harmless(each.feedback)
    grade = sum(gap.weight for gap in gaps) if kind == "cloze" else float(question.findtext("defaultgrade") or "nan")
    name = told(question, "name")
    assert 0 < len(name) <= 255
    assert 0 < len(question.findtext("idnumber") or "") <= 100
    tags = [each.findtext("text") or "" for each in question.findall("tags/tag")]
    idnumber = question.findtext("idnumber") or ""
    texts = htmls["questiontext"], htmls["generalfeedback"]
    return Read(category, kind, name, *texts, idnumber, grade, gaps, tags, files, htmls["graderinfo"])


def harmless(html: str) -> None:
    """Nothing runs, nothing comes from outside, formulas are TeX; it is well-formed."""
    ElementTree.fromstring("<div>" + re.sub(r"&(?!amp;|lt;|gt;|quot;|#)", "&amp;", html) + "</div>")  # noqa: S314 - as above
    assert not re.search(r"<(script|math|iframe|object|style|link)\b", html, re.IGNORECASE)
    assert not re.search(r"<[^>]*\son\w+\s*=", html)
    assert not re.findall(r'src="(?!@@PLUGINFILE@@/)', html)


def gaps_of(text: str) -> list[Gap]:
    """Return the gaps of a text, as Moodle extracts them, which must be the same in its versions."""
    assert not PLACE.search(text)
    now, before = (gaps_by(text, ALT.replace("HIDDEN", hidden)) for hidden in HIDDEN)
    assert now == before
    return now


def gaps_by(text: str, alternative: str) -> list[Gap]:
    """Return the gaps of a text by the regular expression of an answer with its share and feedback."""
    gap = re.compile(rf"\{{([0-9]*):(NUMERICAL|MULTICHOICE):({alternative}(?:~{alternative})*)\}}", re.DOTALL)
    return [
        Gap(float(found[1] or 1), found[2], list(answers_of(found[3], found[2], re.compile(alternative, re.DOTALL))))
        for found in gap.finditer(text)
    ]


def answers_of(rest: str, kind: str, alternative: re.Pattern[str]) -> Iterator[Answer]:
    """Yield the answers of a gap."""
    while rest:
        each = alternative.match(rest)
        assert each, rest
        share = 100.0 if each[1] == "=" else float(each[1].strip("%") or 0)
        if kind == "NUMERICAL":
            value, tolerance = each[2].split(":")
            assert NUMBER.fullmatch(value)
            assert NUMBER.fullmatch(tolerance)
            yield Answer(share, value, decoded(each[4] or ""), float(tolerance))
        else:
            harmless(decoded(each[2]))
            yield Answer(share, unescape(decoded(each[2])), decoded(each[4] or ""))
        rest = rest[each.end() :]
        assert not rest or rest[0] == "~"
        rest = rest[1:]


def decoded(text: str) -> str:
    """Return the HTML that Moodle makes of a text in a gap."""
    return unescape(text).replace("\\}", "}").replace("\\#", "#")


def alone(question: ElementTree.Element, kind: str) -> Gap:
    """Return the only field of a question of another kind."""
    answers = []
    for each in question.findall("answer"):
        answer = Answer(float(each.get("fraction") or 0), each.findtext("text") or "", told(each, "feedback"))
        if kind == "numerical":
            answer.tolerance = float(each.findtext("tolerance") or "nan")
        answers.append(answer)
    return Gap(float(question.findtext("defaultgrade") or 1), kind.upper(), answers)
