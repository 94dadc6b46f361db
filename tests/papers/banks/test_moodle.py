"""Moodle XML, read back by a reader of its own: what is typed earns what our marking gives, nothing runs."""

import re
from base64 import b64decode
from decimal import Decimal
from fractions import Fraction
from html import unescape

import pytest

from solver.papers.export.cloze import gap, hint, share_of, weights_of
from solver.papers.export.moodle import moodle_xml
from solver.papers.export.quiz import Asked, Choice, Content, Essay, Group, Item, Number, Quiz, Text, Wrong
from tests.papers.banks.making import items_of, quiz_with
from tests.papers.banks.moodle_reader import FRACTIONS, gaps_of, harmless, read_moodle
from tests.papers.banks.quizzes import HOSTILE
from tests.papers.banks.test_fields import GAIN

MIXED = """\
title: A plant & its <b>poles</b>
statement: "Given ]]> and {1:NUMERICAL:=5}, 😀, and \\\\\\\\(x\\\\\\\\)."
system: {A: [[0, 1], [-2, -3]], B: [0, 1]}
find:
  a: {task: stability, answers: [bibo_stable], marks: 2}
  b: {task: stability, answers: [verdict, eigenvalues], marks: 8}
  c: {task: eigenstructure, answers: [right_eigenvectors], marks: 3}
  d: {task: pole_placement, poles: [-3, -4], answers: [K], marks: 1}
"""


@pytest.fixture(scope="module")
def items():
    return items_of(MIXED)


@pytest.fixture(scope="module")
def read(items):
    found = read_moodle(moodle_xml(quiz_with(items)))
    assert [each.name for each in found] == ["(a)", "(b)", "(c)", "(d) (1)"]  # what its gaps weigh is not 1
    return {each.name[:3]: each for each in found}


def test_each_kind_of_question_is_written(read):
    assert {name: each.type for name, each in read.items()} == {
        "(a)": "multichoice", "(b)": "cloze", "(c)": "essay", "(d)": "cloze",
    }  # fmt: skip
    assert [each.grade for each in read.values()] == [2, 8, 3, 2]  # two gaps cannot weigh 1 together
    assert read["(a)"].category == "$course$/top/An exam/(a)"


def test_what_is_right_earns_all_and_anything_else_nothing(items, read):
    for item in items.values():
        for field, one in zip(item.fields, read[item.name].gaps, strict=True):
            if isinstance(field, Number):
                assert one.marked(field.typed)[0] == 100
                assert one.marked(str(field.value + field.tolerance * 2 + 1))[0] == 0
            else:
                assert one.right == [field.words[field.right]]


def test_a_named_mistake_earns_its_share_and_its_hint():
    gain = read_moodle(moodle_xml(quiz_with(items_of(GAIN))))[0]
    assert gain.grade == 10  # in the ratio of 2, 2, ½, ½, which whole weights for 5 marks cannot have
    first, second, *others = gain.gaps
    assert (first.weight, second.weight, [each.weight for each in others]) == (4, 4, [1, 1])
    share, hint = first.marked("-1")
    assert share == 75
    assert re.sub("<[^>]*>", "", hint) == r"It is the gain of \(A + BK_f\); the feedback is subtracted, \(A - BK_f\)."
    assert first.marked("1") == (100, "")
    assert second.marked("-2")[0] == 75


def test_texts_of_a_file_begin_no_gap_and_no_formula(read):
    text = read["(b)"].text
    assert len(gaps_of(text)) == 5
    assert "&#123;1:NUMERICAL:=5}" in text
    assert "😀" in text
    assert "]]&gt;" in text
    assert "\\\u2060(x" in text


def test_the_worked_solution_is_the_feedback_and_the_key_is_for_who_marks(read):
    for each in read.values():
        assert "<h3>1. " in each.feedback
    assert "(3 marks)" in read["(c)"].key
    assert r"\[" in read["(c)"].key
    assert not read["(d)"].key


def test_figures_are_files(read):
    assert read["(d)"].files
    for name, content in read["(d)"].files.items():
        assert re.fullmatch(r"image-[0-9a-f]{12}\.svg", name)
        assert b"<svg" in b64decode(content)


def test_the_same_bank_is_written_in_the_same_bytes(items):
    assert moodle_xml(quiz_with(items)) == moodle_xml(quiz_with(items_of(MIXED)))


@pytest.mark.parametrize("part", range(0, 101))
def test_shares_are_those_of_moodles_list(part):
    found = float(share_of(Fraction(part, 100)))
    assert found in FRACTIONS
    assert found <= part + 1e-3


def test_thirds_keep_their_name():
    assert [share_of(Fraction(k, 3)) for k in (1, 2)] == ["33.33333", "66.66667"]
    assert share_of(Fraction(1, 6)) == "16.66667"


@pytest.mark.parametrize(
    ("marks", "total", "weights"),
    [((1, 1), 2, [1, 1]), ((2, 2), 4, [2, 2]), ((1, 1, 1), 2, [1, 1, 1]), ((4, 4, 1, 1), 5, [4, 4, 1, 1]),
     ((0, 0), 0, [1, 1]), ((3, 3, 3), 9, [3, 3, 3])],
)  # fmt: skip
def test_weights_are_whole_and_in_the_ratio_of_the_marks(marks, total, weights):
    fields = [number(f"f-{i}", Fraction(each)) for i, each in enumerate(marks)]
    assert weights_of(fields, Fraction(total)) == weights


def number(key, marks=Fraction(1), wrong=()):
    return Number(key, key, Decimal("0.666666666667"), Decimal("0.005"), marks, "0.67", tuple(wrong))


HINT = 'Not $\\frac{a}{b} \\sim \\{c\\} x < y$ & ~ } { # {#1} \\\\ / " <b> &lt; *one* **two** =\\\\'


def test_a_hint_in_a_gap_is_the_same_html_as_in_a_question_of_one_number():
    wrong = Wrong(Decimal("-1.5"), Decimal("0.05"), Fraction(1, 2), HINT)
    field = number("f", wrong=[wrong])
    found = gaps_of(f"before {gap(field, 3)} between {gap(field, 1)} after }}")
    assert [each.weight for each in found] == [3, 1]
    share, told = found[0].marked("-1.52")
    assert share == 50
    assert unescape(told) == unescape(hint(HINT))
    assert r"\(\frac{a}{b} \sim \{c\} x < y\)" in unescape(told)
    harmless(told)


@pytest.mark.parametrize("words", [("a}~#b", "=c{&", "%50%d"), ("yes", "no & <never>", "'both' #1 &lt; \\")])
def test_words_in_a_gap_are_words(words):
    (found,) = gaps_of(f"before {gap(Choice('f', 'f', words, 1, Fraction(1)), 3)} after }}")
    assert [each.text for each in found.answers] == list(words)
    assert found.right == [words[1]]


SPACED = Content(
    (Text("**one** *two* `three` $x < y$ **four** and {#1} {2:SA:=x}, ]]> done.\n\n    a = 1\n    b & c"),)
)


def test_no_space_between_tags_is_lost():
    items = [Item(f"q-{key}", "q", SPACED, SPACED, Fraction(1), (Asked("x", "x", "", "", Fraction(1), (
        tuple(number(f"f-{i}") for i in range(count)),)),)) for key, count in (("a", 1), ("b", 2))]  # fmt: skip
    items.append(Item("q-c", "q", SPACED, SPACED, Fraction(1), (), Essay((), SPACED, {})))
    for each in read_moodle(moodle_xml(Quiz("Q", "", "en", (Group(("Q", "1"), tuple(items)),)))):
        for html in filter(None, (each.text, each.feedback, each.key)):
            assert "<strong>one</strong> <em>two</em> <code>three</code>" in html
            assert "</strong> and " in html
            assert "]]&gt; done" in html
            assert "a = 1\nb &amp; c" in html


def test_the_marks_stand_behind_a_name_that_is_cut_off():
    fields = Asked("x", "x", "", "", Fraction(1, 2), ((number("f"), number("g")),))
    item = Item("q-1", "long " * 80, Content(), Content(), Fraction(1, 2), (fields,))
    (found,) = read_moodle(moodle_xml(Quiz("Q", "", "en", (Group(("Q", "1"), (item,)),))))
    assert found.name.endswith(" (0.5)")
    assert len(found.name) == 255


def test_hostile_names_stay_texts():
    item = Item("q-1", HOSTILE, Content((Text("x"),)), Content(), Fraction(1), (
        Asked("x", "x", HOSTILE.replace("$", ""), "", Fraction(1), ((number("f"),),)),), tags=(HOSTILE,))  # fmt: skip
    quiz = Quiz(HOSTILE, "", "en", (Group((HOSTILE, "a/b"), (item,)),))
    (found,) = read_moodle(moodle_xml(quiz))
    assert found.name == HOSTILE
    assert found.tags == [HOSTILE]
    assert found.category.endswith("/a//b")
    assert found.gaps[0].marked("0.67")[0] == 100


@pytest.mark.parametrize("side", [-1, 1])
@pytest.mark.parametrize(("beyond", "earned"), [("0", 100), ("0.000001", 0), ("-0.000001", 100)])
def test_the_edges_of_a_tolerance_are_those_that_are_written(side, beyond, earned):
    (one,) = gaps_of(gap(number("f"), 1))
    typed = Decimal("0.666666666667") + side * (Decimal("0.005") + Decimal(beyond))
    assert one.marked(str(typed))[0] == earned
