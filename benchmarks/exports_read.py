"""What the exports of an exam take for right, by readers that share nothing with the writers: those of the tests."""

from __future__ import annotations

import re
import zipfile
from collections import defaultdict
from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path

from lxml import etree

from tests.papers.banks.canvas_reader import quizzes_of
from tests.papers.banks.moodle_reader import read_moodle
from tests.papers.banks.qti_processor import Attempt
from tests.papers.banks.qti_schema import faults

Numbers = Mapping[tuple[str, int], list[Fraction]]
"""The numbers that are right, in order, by part (`1.b`) and variant."""

IDENTIFIED = re.compile(r"-(\d+)-(\w)-\d+-(\d+)$")
TITLED = re.compile(r"^(?:Question )?(\d+)\.(?:.*, \((\w)\))?.*, Variant (\d+)")


def of_moodle(file: Path) -> tuple[int, Numbers]:
    """Return how many questions there are, and the right numbers of the fields that want one."""
    questions, found = read_moodle(file.read_bytes()), defaultdict(list)
    for each in questions:
        place = _place(IDENTIFIED.search(each.idnumber))
        found[place] += [Fraction(gap.right[0]) for gap in each.gaps if gap.kind == "NUMERICAL"]
    return len(questions), found


def of_qti(file: Path) -> tuple[int, Numbers]:
    """The same of a package of QTI; raises ValueError where an item is not what the schema allows."""
    found, count = defaultdict(list), 0
    with zipfile.ZipFile(file) as package:
        for name in package.namelist():
            if re.fullmatch(r"items/[^/]+\.xml", name):
                item = etree.fromstring(package.read(name))
                if wrong := faults(item):
                    raise ValueError(f"{name}: {wrong[0]}")
                place = _place(IDENTIFIED.search(name.removesuffix(".xml")))
                right = Attempt(item, {}).right.values()
                found[place] += [Fraction(each) for each in right if isinstance(each, float)]
                count += 1
    return count, found


def of_canvas(file: Path) -> tuple[int, Numbers]:
    """The same of a package for Canvas, where each entry is a question."""
    found, count = defaultdict(list), 0
    for quiz in quizzes_of(file.read_bytes()):
        for each in quiz.entries:
            count += 1
            if each.kind == "numerical_question":
                found[_place(TITLED.search(each.title))].append(Fraction(sum(each.right[0]) / 2))
    return count, found


def _place(found: re.Match[str] | None) -> tuple[str, int]:
    """The part and the variant; a part that has no letter is the only one, a."""
    if found is None:
        raise ValueError("a question does not say which it is")
    return f"{found[1]}.{found[2] or 'a'}", int(found[3])


READERS = {"moodle": of_moodle, "qti": of_qti, "canvas": of_canvas}
FILES = {"moodle": "exam-moodle.xml", "qti": "exam-qti.zip", "canvas": "exam-canvas.zip"}
