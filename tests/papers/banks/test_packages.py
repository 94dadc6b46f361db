"""Banks of real problems as packages: valid, marked alike by both systems, and with the shares of our own marking."""

import io
import zipfile
from decimal import Decimal

import pytest
from lxml import etree

from solver.papers.export.canvas import canvas_package
from solver.papers.export.moodle import moodle_xml
from solver.papers.export.qti import qti_package
from solver.papers.export.quiz import Number
from solver.papers.export.versions import decimal, marks_of_fields
from tests.papers.banks.canvas_reader import quizzes_of
from tests.papers.banks.making import items_of, quiz_with
from tests.papers.banks.moodle_reader import read_moodle
from tests.papers.banks.qti_processor import Attempt
from tests.papers.banks.qti_schema import faults

PROBLEM = """\
title: A plant & its <b>poles</b>
statement: "With ]]> and \\\\\\\\(x\\\\\\\\), a table.\\n\\n| a | b |\\n|--|--:|\\n| $x_1$ | 2 |"
system: {A: [[0, 1], [1, 3]], B: [0, 3]}
partial: {K: {sign: 1}}
find:
  a: {task: pole_placement, poles: [-1, -2], answers: [K, polynomial], marks: {K: 4, polynomial: 1}}
  b: {task: stability, answers: [verdict, eigenvalues], marks: 4}
  c: {task: eigenstructure, answers: [right_eigenvectors], marks: 3}
"""


@pytest.fixture(scope="module")
def bank():
    return quiz_with(items_of(PROBLEM))


@pytest.fixture(scope="module")
def items(bank):
    archive = zipfile.ZipFile(io.BytesIO(qti_package(bank)))
    return {each.identifier: etree.fromstring(archive.read(f"items/{each.identifier}.xml")) for each in bank.items}


@pytest.fixture(scope="module")
def questions(bank):
    (found,) = quizzes_of(canvas_package(bank))
    return found.entries


def right_of(item, root):
    """What a student types who has all of it right."""
    known = Attempt(root, {}).right
    return {each.key: each.typed if isinstance(each, Number) else known[each.key] for each in item.fields}


def test_items_are_what_the_schemas_allow(items):
    assert len(items) == 3
    assert [faults(root) for root in items.values()] == [[]] * 3


def test_what_is_right_earns_the_marks_of_the_part_in_both(bank, items, questions):
    for item in bank.items:
        root = items[item.identifier]
        if item.essay:
            assert Attempt(root, {}).processed().score is None
            continue
        right = right_of(item, root)
        assert Attempt(root, right).processed().score == pytest.approx(float(item.marks))
        for key, typed in right.items():
            (one,) = [each for each in questions if each.identifier.endswith(f"{item.identifier}-{key}")]
            assert one.marks(typed.removeprefix("word-")) == one.points
    assert sum(each.points for each in questions) == float(sum(item.marks for item in bank.items))


def test_a_named_mistake_earns_what_our_marking_leaves(bank, items):
    item = next(iter(bank.items))
    right = right_of(item, items[item.identifier])
    slips = {each.key: f"{each.wrong[0].value:f}" for each in item.answers[0].fields}
    found = Attempt(items[item.identifier], right | slips).processed()
    assert found.score == 4.0  # the sign of K costs one of five
    assert len(found.feedback) == 2
    assert found.feedback[0].startswith("It is the gain of A+")


def test_a_polynomial_is_right_as_a_whole(bank, items):
    item = next(iter(bank.items))
    root = items[item.identifier]
    right = right_of(item, root)
    *_, last = item.fields
    assert Attempt(root, right | {last.key: "77"}).processed().score == 4.0


def test_questions_of_canvas_say_which_entry_they_want(questions):
    gain = [each for each in questions if "K, row" in each.title]
    assert [each.title.rpartition(": ")[2] for each in gain] == ["K, row 1, column 1", "K, row 1, column 2"]
    assert [each.points for each in gain] == [2.0, 2.0]
    assert r"\boxed{?} &amp; \cdot" in gain[0].text


THIRDS = """\
title: Thirds
system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}
find:
  a: {task: stability, answers: [verdict, eigenvalues, bibo_stable]}
  b: {task: eigenstructure, answers: [eigenvalues, right_eigenvectors, left_eigenvectors]}
"""


def test_the_fields_of_a_part_add_up_to_its_marks_in_hundredths():
    items = items_of(THIRDS)
    assert sum(each.marks for name, each in items.items() if name.startswith("b")) == 1
    archive = zipfile.ZipFile(io.BytesIO(qti_package(quiz_with(items))))
    for item in items.values():
        shares = [share for asked in item.answers for share in marks_of_fields(asked).values()]
        assert all((share * 100).denominator == 1 for share in [*shares, item.marks])
        assert sum(shares) == (item.marks if item.answers else 0)
        root = etree.fromstring(archive.read(f"items/{item.identifier}.xml"))
        assert root.xpath("string(//*[@identifier='MAXSCORE']/*/*)") == decimal(item.marks)
    (found,) = quizzes_of(canvas_package(quiz_with(items)))
    assert sum(Decimal(str(each.points)) for each in found.entries) == 2
    (first, *_) = read_moodle(moodle_xml(quiz_with(items)))
    assert [gap.weight for gap in first.gaps] == [136, 33, 33, 33, 33, 132]  # in Moodle whole weights: hundredths of 4
