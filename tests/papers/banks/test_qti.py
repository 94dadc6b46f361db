"""QTI 2.1 packages: valid by what the schemas say, and marked by another reader as they were meant."""

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

from solver.papers.export.packages import HEADER, zipped
from solver.papers.export.qti import item_xml, qti_package
from solver.papers.export.quiz import Asked, Content, Fixed, Group, Quiz, Text
from tests.papers.banks.qti_processor import Attempt
from tests.papers.banks.qti_schema import CP, MATH, QTI, faults
from tests.papers.banks.quizzes import FRACTION, GAIN, MARGIN, POLES, SIGN, STABLE, content, item, number, quiz

RIGHT = {
    "k-1-1": "4", "k-1-2": "3", "k-2-1": "0", "k-2-2": "-12", "p-1": "-1.06066", "p-2": "0.33", "p-3": "1.2",
    "stable": "word-2", "g": "999999", "n-0": "1.5", "d-1": "3.2", "d-0": "2",
}  # fmt: skip


def opened(package):
    return zipfile.ZipFile(io.BytesIO(package))


def documents(package):
    archive = opened(package)
    return {name: etree.fromstring(archive.read(name)) for name in archive.namelist() if name.endswith(".xml")}


def written(made):
    """Return an item as it is in a package."""
    return documents(qti_package(Quiz("Q", "", "en", (Group(("Q", "1", "a"), (made,)),))))[
        f"items/{made.identifier}.xml"
    ]


@pytest.fixture(scope="module")
def package():
    return qti_package(quiz())


@pytest.fixture(scope="module")
def first(package):
    return documents(package)["items/place-a-1.xml"]


def test_all_documents_are_what_the_schemas_allow(package):
    for name, root in documents(package).items():
        assert faults(root) == [], name


def spoil_order(root):
    root.append(root.find(f"{QTI}itemBody"))


def spoil_declaration(root):
    root.remove(root.find(f"{QTI}responseDeclaration"))


def spoil_twice(root):
    entries = list(root.iter(f"{QTI}textEntryInteraction"))
    entries[0].set("responseIdentifier", entries[1].get("responseIdentifier"))


def spoil_style(root):
    next(root.iter(f"{QTI}td")).set("style", "color: red")


def spoil_nesting(root):
    paragraph = next(root.iter(f"{QTI}p"))
    paragraph.append(etree.Element(f"{QTI}p"))


def spoil_text(root):
    root.find(f"{QTI}itemBody").text = "words"


def spoil_hint(root):
    next(root.iter(f"{QTI}modalFeedback")).set("identifier", "elsewhere")


def spoil_math(root):
    fraction = next(root.iter(f"{MATH}msub"))
    fraction.append(etree.Element(f"{MATH}mi"))


def spoil_script(root):
    next(root.iter(f"{QTI}p")).append(etree.Element(f"{QTI}script"))


def spoil_feedback(root):
    hint = next(root.iter(f"{QTI}modalFeedback"))
    etree.SubElement(hint[0], f"{QTI}textEntryInteraction", responseIdentifier="k-1-1")


def spoil_number(root):
    next(root.iter(f"{QTI}textEntryInteraction")).set("expectedLength", "long")


def spoil_word(root):
    next(root.iter(f"{QTI}equal")).set("toleranceMode", "near")


def spoil_label(root):
    next(root.iter(f"{QTI}textEntryInteraction")).set("label", "x" * 257)


def spoil_name(root):
    next(root.iter(f"{QTI}setOutcomeValue")).set("identifier", "1")


def spoil_sign(root):
    next(root.iter(f"{MATH}mo")).set("stretchy", "no")


SPOILS = [spoil_order, spoil_declaration, spoil_twice, spoil_style, spoil_nesting, spoil_text, spoil_hint, spoil_math,
          spoil_script, spoil_feedback, spoil_number, spoil_word, spoil_label, spoil_name, spoil_sign]  # fmt: skip


@pytest.mark.parametrize("spoil", SPOILS)
def test_what_the_schemas_do_not_allow_is_found(first, spoil):
    root = etree.fromstring(etree.tostring(first))
    spoil(root)
    assert faults(root)


def test_right_answers_earn_all_marks_and_see_the_solution_only(first):
    found = Attempt(first, RIGHT).processed()
    assert found.score == 10.0
    assert len(found.feedback) == 1
    assert "worked" in found.feedback[0]
    declared = first.xpath("string(//*[@identifier='MAXSCORE']/*/*)")
    assert float(declared) == 10.0


def test_the_answers_that_a_system_shows_as_right_are_right(first):
    right = {name: str(value) for name, value in Attempt(first, {}).right.items()}
    assert Attempt(first, right).processed().score == 10.0


def test_blanks_and_words_for_numbers_earn_nothing(first):
    for typed in ({}, dict.fromkeys(RIGHT, "x"), dict.fromkeys(RIGHT, "  ")):
        found = Attempt(first, typed).processed()
        assert found.score == 0.0
        assert len(found.feedback) == 1


@pytest.mark.parametrize("name", RIGHT)
def test_each_field_counts(first, name):
    whole = {"n-0", "d-1", "d-0"}
    lost = 10.0 - Attempt(first, RIGHT | {name: "77"}).processed().score
    field = {each.key: each for asked in (GAIN, POLES, STABLE, MARGIN) for each in asked.fields}
    share = 3.0 if name in whole else 1 / 3 if name.startswith("p") else 1.0
    assert lost == pytest.approx(share, abs=0.01)
    assert name in whole or name in field


def test_a_usual_mistake_earns_its_share_and_its_hint_once(first):
    found = Attempt(first, RIGHT | {"k-1-1": "-4", "k-1-2": "-3"}).processed()
    assert found.score == 9.0
    assert len(found.feedback) == 2
    assert "look at the sign" in found.feedback[0]


def test_a_mistake_without_a_share_has_its_hint(first):
    found = Attempt(first, RIGHT | {"k-1-2": "8"}).processed()
    assert (found.score, found.feedback[0]) == (9.0, "no")
    silent = Attempt(first, RIGHT | {"p-3": "2.4"}).processed()
    assert silent.score == pytest.approx(10 - 1 / 3, abs=0.01)
    assert len(silent.feedback) == 1


@pytest.mark.parametrize(("typed", "score"), [
    ({"n-0": "2.5", "d-1": "3.9"}, 8.0),  # what the mistake leads to everywhere
    ({"n-0": "2.5"}, 7.0),  # half of it
    ({"n-0": "2.5", "d-1": "3.9", "d-0": "9"}, 7.0),  # and another one
    ({"d-0": ""}, 7.0),
])  # fmt: skip
def test_an_answer_that_is_right_as_a_whole_only(first, typed, score):
    found = Attempt(first, RIGHT | typed).processed()
    assert found.score == score
    assert ("twice" in found.feedback) == ("n-0" in typed)


def test_an_essay_has_no_score_until_it_is_marked_and_its_key_is_for_who_marks_it(package):
    root = documents(package)["items/place-b-1.xml"]
    found = Attempt(root, {"essay": "T = I"}).processed()
    assert found.score is None
    assert len(found.feedback) == 1
    (key,) = root.iter(f"{QTI}rubricBlock")
    assert key.get("view") == "scorer"
    assert "T = ..." in "".join(key.itertext())
    root.find(f"{QTI}itemBody").remove(key)
    assert "T = ..." not in "".join(root.find(f"{QTI}itemBody").itertext())


values = st.decimals(min_value=-2000, max_value=2000, allow_nan=False, allow_infinity=False, places=5)


@settings(max_examples=300, deadline=None)
@given(values, st.decimals(min_value="0.00001", max_value=5, places=5), st.integers(-1, 1), st.integers(-2, 2))
def test_the_edges_of_a_tolerance_are_those_of_the_numbers_as_typed(value, tolerance, side, beyond):
    typed = value + side * tolerance + beyond * Decimal("0.00001")
    asked = Asked("x", "x", "", "", Fraction(2), ((Fixed("x ="), number("x", str(value), str(tolerance))),))
    bare = replace(item("one", (asked,)), question=Content(), feedback=Content())
    root = etree.fromstring(etree.tostring(written(bare)))
    found = Attempt(root, {"x": f"{typed:f}"}).processed()
    assert found.score == (2.0 if abs(typed - value) <= tolerance else 0.0)


def test_tolerances_are_told_in_few_digits(first):
    told = {each.get("tolerance") for each in first.iter(f"{QTI}equal") if each.get("tolerance")}
    assert all(len(each.split()[0]) <= len("0.005000000005") for each in told)
    assert "0.005 0.005" in told


@pytest.mark.parametrize("count", [1, 2, 3, 7, 11])
def test_fields_share_the_marks_of_their_answer_to_the_last_hundredth(count):
    lines = tuple((number(f"x-{i}", str(i)),) for i in range(count))
    root = written(item("one", (Asked("x", "x", "", "", Fraction(5), lines),)))
    right = {f"x-{i}": str(i) for i in range(count)}
    assert Attempt(root, right).processed().score == pytest.approx(5, abs=1e-9)


def test_a_paper_has_all_parts_of_a_question_in_one_variant(package):
    test = documents(package)["test.xml"]
    regulator, fixed = test.find(f"{QTI}testPart").findall(f"{QTI}assessmentSection")
    assert regulator.find(f"{QTI}selection").get("select") == "1"
    drawn = [[each.get("href") for each in inner] for inner in regulator.findall(f"{QTI}assessmentSection")]
    assert drawn == [[f"items/place-{part}-{variant}.xml" for part in "ab"] for variant in "12"]
    assert fixed.find(f"{QTI}selection") is None
    assert [each.get("href") for each in fixed] == ["items/fixed-a.xml"]
    assert float(test.find(f"{QTI}outcomeDeclaration").get("normalMaximum")) == 20.0
    identifiers = [each.get("identifier") for each in test.iter() if each.tag.endswith(("Section", "ItemRef"))]
    assert len(set(identifiers)) == len(identifiers)


def test_the_manifest_names_what_is_there_and_nothing_else(package):
    archive = opened(package)
    manifest = documents(package)["imsmanifest.xml"]
    files = {each.get("href") for each in manifest.iter(f"{CP}file")}
    assert files == set(archive.namelist()) - {"imsmanifest.xml"}
    resources = {each.get("identifier") for each in manifest.iter(f"{CP}resource")}
    assert {each.get("identifierref") for each in manifest.iter(f"{CP}dependency")} <= resources
    assert {each.get("type") for each in manifest.iter(f"{CP}resource")} == {
        "imsqti_test_xmlv2p1",
        "imsqti_item_xmlv2p1",
    }
    for resource in manifest.iter(f"{CP}resource"):
        assert resource.get("href") in {each.get("href") for each in resource.iter(f"{CP}file")}


def test_images_are_files_beside_the_items(package):
    archive = opened(package)
    for name, root in documents(package).items():
        for each in root.iter(f"{QTI}img"):
            assert f"items/{each.get('src')}" in archive.namelist(), name
            assert re.fullmatch(r"images/image-[0-9a-f]{12}\.svg", each.get("src"))
            assert each.get("alt")


def test_hostile_texts_stay_texts(package):
    for name, root in documents(package).items():
        assert not [each for each in root.iter() if each.tag.endswith("script")], name
        assert {each.get("href") for each in root.iter(f"{QTI}a")} <= {"https://example.org/?a=1&b=2"}
    text = opened(package).read("items/place-a-1.xml").decode()
    assert "alert(1)" in text
    assert "<script" not in text
    assert 'title="1 &lt;b&gt; ]]&gt; &amp; place-a-1"' in text


def test_signs_that_xml_cannot_hold_are_left_out():
    made = item("one", (GAIN,))
    odd = replace(made, name="a\x00\x08\ud800b\ufffe", question=Content((Text("c\x0bd"),)))
    root = written(odd)
    assert root.get("title") == "ab"
    assert "cd" in "".join(root.itertext())


@pytest.mark.parametrize("path", ["../x", "/x", "a/../b", "a//b", ".x", "a/.b", "a b", "", "ü"])
def test_no_file_leaves_the_package(path):
    with pytest.raises(AssertionError):
        zipped({path: b""})


def test_formulas_keep_what_presentation_needs(first):
    matrix = next(first.iter(f"{MATH}mtable"))
    assert matrix.getparent().getparent().getparent().get("display") == "block"
    aligned = written(
        replace(item("one", (GAIN,)), question=Content((Text("$$\\begin{aligned}a&=b\\\\c&=d\\end{aligned}$$"),)))
    )
    assert {each.get("columnalign") for each in aligned.iter(f"{MATH}mtd")} >= {"right", "left"}


def test_a_package_has_no_dates_and_begins_as_xml(package):
    archive = opened(package)
    assert {each.date_time for each in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}
    assert {each.extra for each in archive.infolist()} == {b""}
    for name in archive.namelist():
        if name.endswith(".xml"):
            assert archive.read(name).decode().startswith(HEADER)


words = st.text(st.characters(exclude_categories=("Cs",)), max_size=60)


@settings(max_examples=60, deadline=None)
@given(words, words, words)
def test_any_text_makes_a_valid_item(name, text, hint):
    asked = Asked("x", "x", text, text, Fraction(1), ((number("x", "1", "0", ("2", "1/2", hint)),),), grid=True)
    made = replace(item("one", (asked,)), name=name, question=content(text, hostile=name))
    root = etree.fromstring(etree.tostring(written(made)))
    assert faults(root) == []
    assert item_xml(made, "en").tag == "assessmentItem"


def test_the_hint_is_told_in_mathml(first):
    hint = next(first.iter(f"{QTI}modalFeedback"))
    assert SIGN.count("$") == 2
    assert next(hint.iter(f"{MATH}math")).get("alttext") == "u = -K x"


def test_a_line_of_fields_has_words_to_choose_in_it():
    mixed = ((Fixed("a ="), number("a", "1"), *STABLE.lines[0]), MARGIN.lines[0])
    root = written(item("one", (replace(FRACTION, lines=mixed, whole=False),)))
    assert faults(root) == []
    (choice,) = root.iter(f"{QTI}inlineChoiceInteraction")
    assert [each.text for each in choice] == ["yes", "no & <never>"]


def test_displayed_formulas_stand_in_paragraphs_of_their_own():
    text = "First\n$$a = 1$$ $$b = 2$$\nthen\n$$c = 3$$\n\n$$d = 4$$"
    body = written(replace(item("one", (GAIN,)), question=Content((Text(text),)))).find(f"{QTI}itemBody")
    shown = [[each.get("alttext") for each in block.iter(f"{MATH}math")] for block in body.findall(f"{QTI}p")]
    assert shown[:3] == [["a = 1"], ["b = 2", "c = 3"], ["d = 4"]]


def test_words_without_a_symbol_have_no_prompt():
    bare = replace(STABLE, symbol="", lines=((Fixed(""), STABLE.lines[0][1]),))
    root = written(item("one", (bare,)))
    assert faults(root) == []
    assert [each.tag for each in root.iter(f"{QTI}choiceInteraction", f"{QTI}prompt")] == [f"{QTI}choiceInteraction"]
