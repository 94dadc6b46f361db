"""Packages for Canvas: read back as its importer reads them, and marked as they were meant."""

import io
import re
import zipfile
from dataclasses import replace
from decimal import Decimal
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from lxml import etree

from solver.papers.export.canvas import canvas_package
from solver.papers.export.canvas_text import few
from solver.papers.export.quiz import Asked, Content, Fixed, Group, Quiz, Text
from tests.papers.banks.canvas_reader import CP, LARGEST, QTI, Draw, faults, quizzes_of
from tests.papers.banks.quizzes import CONTROLLABLE, content, item, number, quiz, single_questions

RIGHT = {
    "k-1-1": "4", "k-1-2": "3.0", "k-2-1": "0", "k-2-2": "-12", "p-1": "-1.06066", "p-2": "0.33", "p-3": "1.2",
    "stable": "2", "g": "999999", "n-0": "1.5", "d-1": "3.2", "d-0": "2", "c": "1",
}  # fmt: skip


@pytest.fixture(scope="module")
def package():
    return canvas_package(quiz())


@pytest.fixture(scope="module")
def read(package):
    return quizzes_of(package)


def of_one(*items):
    """Return the quiz of a package of some items of one variant."""
    groups = tuple(Group(("Q", f"{i}", "a"), (each,)) for i, each in enumerate(items))
    (found,) = quizzes_of(canvas_package(Quiz("Q", "", "en", groups)))
    return found


def test_each_variant_is_a_quiz_where_questions_are_several_in_canvas(read):
    assert [each.title[-4:] for each in read] == [" (1)", " (2)"]
    for each in read:
        kinds = [entry.kind for entry in each.entries]
        assert kinds[0] == "text_only_question"
        assert kinds.count("numerical_question") == 11
        assert kinds.count("multiple_choice_question") == 2
        assert kinds.count("essay_question") == 1
        assert float(each.settings["points_possible"]) == pytest.approx(20)
        assert sum(entry.points for entry in each.entries) == pytest.approx(20)


def test_no_question_is_that_of_another_exam_or_variant(read):
    names = [entry.identifier for each in read for entry in each.entries]
    assert len(set(names)) == len(names)
    other = quizzes_of(canvas_package(replace(quiz(), title="Another")))
    assert not set(names) & {entry.identifier for each in other for entry in each.entries}


def test_nothing_is_published_or_shown_by_an_import(read):
    for each in read:
        told = each.settings
        assert (told["available"], told["hide_results"], told["show_correct_answers"]) == ("false", "always", "false")
        assert told["shuffle_answers"] == "false"


def test_right_answers_earn_all_marks_others_none(read):
    for entry in read[0].entries:
        if entry.kind == "essay_question":
            assert entry.marks("T") is None
        elif entry.kind != "text_only_question":
            key = next(key for key in sorted(RIGHT, key=len, reverse=True) if entry.identifier.endswith(f"-{key}"))
            assert entry.marks(RIGHT[key]) == entry.points > 0
            assert entry.marks("") == entry.marks("77") == entry.marks("yes?") == 0


def test_what_is_asked_about_is_told_once_and_each_question_says_what_it_wants(read):
    stem, first, second, *_ = read[0].entries
    assert stem.text.count("The plant has") == 1
    assert stem.points == 0
    assert "The plant has" not in first.text + second.text
    assert r"\(K = \begin{bmatrix} \boxed{?} &amp; \cdot \\ \cdot &amp; \cdot \end{bmatrix}\)" in first.text
    assert r"\cdot &amp; \boxed{?} \\" in second.text
    assert first.title.endswith("entry k-1-1")
    fraction = next(each for each in read[0].entries if each.identifier.endswith("d-1"))
    assert r"\(G(s) = \square /(s^2 + \boxed{?} s + \square )\)" in fraction.text


def test_the_worked_solution_stands_below_the_last_question_of_a_part(read):
    told = [bool(entry.neutral) for entry in read[0].entries if entry.kind != "text_only_question"]
    assert told == [False] * 11 + [True] + [True] + [True]  # twelve fields, the essay, the other question


def test_hints_are_told_for_wrong_answers(read):
    gain = read[0].entries[2]
    assert r"<li>\(-3\): The law is" in gain.incorrect
    assert r"<li>\(8\): no</li>" in gain.incorrect
    assert not read[0].entries[3].incorrect


@pytest.mark.parametrize(("value", "told"), [
    ("3.66666666667", "3.6667"), ("-12", "-12"), ("123456789", "123456789"), ("0.00123456", "0.0012346"),
])  # fmt: skip
def test_a_wrong_value_is_told_in_few_digits(value, told):
    assert few(Decimal(value)) == told


def test_questions_that_are_one_in_canvas_are_drawn():
    (found,) = quizzes_of(canvas_package(single_questions()))
    assert found.title == "Short"
    assert all(isinstance(each, Draw) for each in found.entries)
    assert [(each.title, each.points, len(each.questions)) for each in found.entries] == [
        ("1. One", 5.0, 3), ("2. Two", 5.0, 3),
    ]  # fmt: skip
    assert all("The plant has" in one.text for each in found.entries for one in each.questions)
    assert float(found.settings["points_possible"]) == 10


def test_variants_with_other_marks_are_not_drawn():
    one = item("one-1", (CONTROLLABLE,), None, "1")
    other = item("one-2", (replace(CONTROLLABLE, marks=Fraction(3)),), None, "2")
    told = Quiz("Q", "", "en", (Group(("Q", "1", "a"), (one, other)),))
    assert [each.title for each in quizzes_of(canvas_package(told))] == ["Q (1)", "Q (2)"]


values = st.decimals(min_value=-2000, max_value=2000, allow_nan=False, allow_infinity=False, places=5)


@settings(max_examples=200, deadline=None)
@given(values, st.sampled_from(["0", "0.005", "0.05", "0.5", "0.0123"]), st.integers(-1, 1), st.integers(-2, 2))
def test_the_edges_of_a_tolerance_are_those_of_the_numbers_as_typed(value, tolerance, side, beyond):
    typed = value + side * Decimal(tolerance) + beyond * Decimal("0.00001")
    asked = Asked("x", "x", "", "", Fraction(2), ((Fixed("x ="), number("x", str(value), tolerance)),))
    bare = replace(item("one", (asked,)), question=Content(), feedback=Content())
    (entry,) = of_one(bare).entries
    assert entry.marks(f"{typed:f}") == (2.0 if abs(typed - value) <= Decimal(tolerance) else 0.0)


@pytest.mark.parametrize(("value", "tolerance"), [("1.06", "0.005"), ("5", "0"), ("25", "0"), ("0.5", "0.05")])
def test_canvas_makes_no_significant_digits_of_an_interval(value, tolerance):
    asked = Asked("x", "x", "", "", Fraction(2), ((number("x", value, tolerance),),))
    (entry,) = of_one(replace(item("one", (asked,)), question=Content())).entries
    assert entry.right == [(Decimal(value) - Decimal(tolerance), Decimal(value) + Decimal(tolerance))]


def test_long_texts_are_parted_so_that_canvas_imports_them():
    long = Content(tuple(Text("word " * 1500) for _ in range(5)))
    found = of_one(replace(item("one", (CONTROLLABLE,)), question=long))
    assert [each.kind for each in found.entries] == ["text_only_question"] * 3 + ["multiple_choice_question"]
    assert all(len(each.text) < LARGEST and "too long" not in each.text for each in found.entries)
    assert sum(each.text.count("word") for each in found.entries) == 7500


def test_hostile_texts_stay_texts(package, read):
    for each in read:
        for entry in each.entries:
            for html in (entry.text, entry.neutral, entry.incorrect):
                root = etree.fromstring(f"<div>{html}</div>")
                assert not [one for one in root.iter() if one.tag in {"script", "style", "iframe"}]
                assert {one.get("src") for one in root.iter("img")} <= {
                    "%24IMS-CC-FILEBASE%24/images/" + picture(package)
                }
                assert not re.search(r"\$\$ \\\( \\\[", html)  # no text begins a formula
    title = read[0].entries[0].title
    assert title == "1 <b> ]]> & place-a-1"


def picture(package):
    names = zipfile.ZipFile(io.BytesIO(package)).namelist()
    return next(name for name in names if name.startswith("images/")).removeprefix("images/")


def test_the_manifest_names_what_is_there_and_nothing_else(package):
    archive = zipfile.ZipFile(io.BytesIO(package))
    manifest = etree.fromstring(archive.read("imsmanifest.xml"))
    assert {each.get("href") for each in manifest.iter(f"{CP}file")} == set(archive.namelist()) - {"imsmanifest.xml"}


@pytest.mark.parametrize("spoil", ["order", "twice", "attribute", "unknown"])
def test_what_canvas_does_not_know_is_found(package, spoil):
    archive = zipfile.ZipFile(io.BytesIO(package))
    name = next(name for name in archive.namelist() if re.fullmatch(r"(exam-\w+-1)/\1\.xml", name))
    root = etree.fromstring(archive.read(name))
    assert faults(root) == []
    items = list(root.iter(f"{QTI}item"))
    if spoil == "order":
        items[1].append(items[1][0])
    elif spoil == "twice":
        items[1].set("ident", items[0].get("ident"))
    elif spoil == "attribute":
        del items[1].attrib["title"]
    else:
        etree.SubElement(items[1], f"{QTI}script")
    assert faults(root)


def test_the_same_quiz_is_the_same_bytes(package):
    assert canvas_package(quiz()) == package


words = st.text(st.characters(exclude_categories=("Cs",)), max_size=60)


@settings(max_examples=50, deadline=None)
@given(words, words, words)
def test_any_text_makes_a_question_that_canvas_reads(name, text, hint):
    asked = Asked("x", "x", text, text, Fraction(1), ((number("x", "1", "0", ("2", "1/2", hint)),),), grid=True)
    (entry,) = of_one(replace(item("one", (asked,)), name=name, question=content(text, hostile=name))).entries
    etree.fromstring(f"<div>{entry.text}{entry.neutral}{entry.incorrect}</div>")
    assert entry.marks("1") == 1


def test_a_word_that_stands_alone_has_no_place_to_be_shown():
    bare = replace(CONTROLLABLE, symbol="", lines=((Fixed(""), CONTROLLABLE.lines[0][1]),))
    (entry,) = of_one(replace(item("one", (bare,)), question=Content())).entries
    assert entry.text == "<p>whether it is controllable</p>"
