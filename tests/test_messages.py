"""Reasons and phrases in words: of the language, else in English; a user's folder of templates comes first."""

import pytest
from jinja2 import UndefinedError

from solver.messages import Messages, environment
from solver.words import Phrase, Reason, Told, folders, languages

OWN = """\
{% macro small(v) %}
{% if v.x %}
{{ v.x }} < {{ v.y|formula if v.y is not string else v.y }},
{% endif %}
is small.
{% endmacro %}
"""


@pytest.fixture
def own(tmp_path):
    """A user's folder with reasons, in English and in a language of its own, and phrases."""
    for file, text in {
        "wording/reasons/own.md.jinja": OWN,
        "wording/la/reasons/own.md.jinja": OWN.replace("is small", "parvum est"),
        "wording/la/phrases.yaml": "row {i}: versus {i}\nno phrase: nihil\n",
        "wording/la/more/phrases.yaml": "the rank: ordo\n",
        "wording/la/none/phrases.yaml": "# nothing yet\n",
        "wording/de/phrases.yaml": "row {i}: Reihe {i}\n",
    }.items():
        (tmp_path / file).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / file).write_text(text, encoding="utf-8")
    return tmp_path


def test_a_reason_is_one_line_in_the_language_or_in_english(own):
    reason = Reason("own/small", {"x": "a", "y": "b & c"})
    assert Messages(own).reason(reason) == "a < b & c, is small."
    assert Messages(own, "la").reason(reason) == "a < b & c, parvum est."
    assert Messages(own, "de").reason(reason) == "a < b & c, is small."
    assert Messages(own).told(reason) == Messages(own).reason(reason)
    with pytest.raises(UndefinedError):
        Messages(own).reason(Reason("own/small", {}))


@pytest.mark.parametrize("kind", ["own/large", "nowhere/small"])
def test_a_reason_without_words_is_told_by_its_place(own, kind):
    file, _, macro = kind.partition("/")
    with pytest.raises(LookupError, match=rf"'{macro}' of templates/wording/reasons/{file}\.md\.jinja is missing"):
        Messages(own, "la").reason(Reason(kind))


def test_phrases_are_worded_by_their_pattern_and_the_folder_of_the_user_wins(own):
    row = Phrase("row {i}", i=2)
    assert (row, str(Messages().say(row))) == ("row 2", "row 2")
    assert Messages(own, "la").say(row) == "versus 2"
    assert Messages(own, "de").say(row) == "Reihe 2"
    assert Messages(None, "de").say(row) == "Zeile 2"
    assert Messages(own, "la").say(Phrase("{what}: {n}", what=Phrase("row {i}", i=1), n=3)) == "versus 1: 3"
    assert Messages(own, "la").say("no phrase") == Messages(own, "la").told("no phrase") == "nihil"
    assert Messages(own, "la").named("the_rank") == "ordo"
    assert Messages(own, "la").say("unknown") == "unknown"
    assert Messages(notation="ogata").say(r"the gain $\sym{K}$") == "the gain $K$"


def test_languages_are_the_folders_with_phrases(own):
    assert languages(own) == ["en", "de", "la"]
    assert languages() == ["en", "de"]
    assert folders(own)[:2] == [own / "wording", own]


def test_what_has_no_answer_is_told_with_its_reason():
    one, other = Told("response/no_input", x=1), Told(Reason("stability/no_parameter", {"name": "k"}))
    assert one.reason == Reason("response/no_input", {"x": 1})
    assert str(other) == "k is no parameter of the system"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("It holds.{% if v.x %} Always.{% endif %}\nNext.", "It holds. Always.\nNext."),
        ("It holds.{% if v.x %} Always.{% endif %}\n{% if v.x %}\nNext.\n{% endif %}", "It holds. Always.\nNext.\n"),
        ("It holds.{% if v.x %} Always.{% endif -%}\nNext.", "It holds. Always.Next."),
        ("{% if v.x %}\nIt holds.\n{% endif %}\nNext.", "It holds.\nNext."),
    ],
)
def test_a_line_of_text_that_ends_in_a_tag_stays_a_line(tmp_path, text, expected):
    (tmp_path / "wording").mkdir()
    (tmp_path / "wording" / "own.md.jinja").write_text(text, encoding="utf-8")
    assert environment(tmp_path).get_template("own.md.jinja").render(v={"x": True}) == expected
