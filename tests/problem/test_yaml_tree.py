from __future__ import annotations

import pytest
import yaml

from solver.problem import yaml_tree
from solver.problem.nodes import MappingNode, ScalarNode, SequenceNode
from solver.problem.source import InputError, Source
from solver.problem.yaml_tree import parse_yaml

LOADERS = [yaml.SafeLoader] + ([yaml.CSafeLoader] if yaml.__with_libyaml__ else [])


@pytest.fixture(params=LOADERS, autouse=True, ids=lambda loader: loader.__name__)
def each_loader(request, monkeypatch):
    """Everything here holds for libyaml and for the parser in Python."""
    monkeypatch.setattr(yaml_tree, "Loader", request.param)


def parse(text):
    return parse_yaml(Source("f.yaml", text))


def complaints(text):
    with pytest.raises(InputError) as caught:
        parse(text)
    return [(each.line, each.column, each.message) for each in caught.value.diagnostics]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("a: 1", {"a": "1"}),
        ("a: 0.10", {"a": "0.10"}),
        ("a: 010", {"a": "010"}),
        ("a: 1e3", {"a": "1e3"}),
        ("a: 12:30:45", {"a": "12:30:45"}),
        ("a: 2026-01-01", {"a": "2026-01-01"}),
        ("a: [no, on, yes, off, n, y]", {"a": ["no", "on", "yes", "off", "n", "y"]}),
        ("a: [true, True, TRUE, false, False]", {"a": [True, True, True, False, False]}),
        ("a: ['true', \"null\", '~', '']", {"a": ["true", "null", "~", ""]}),
        ("a: [null, ~, Null]", {"a": [None, None, None]}),
        ("a:", {"a": None}),
        ("a: .nan", {"a": ".nan"}),
        ("a: 0x1F", {"a": "0x1F"}),
        ("a: -3 ± 2j", {"a": "-3 ± 2j"}),
        ("no: 1\n1: 2\ntrue: 3", {"no": "1", "1": "2", "true": "3"}),
        ("a: |\n  x: y\n  # z\n", {"a": "x: y\n# z\n"}),
        ("a: >\n  x\n  y\n", {"a": "x y\n"}),
        ("a: 'it''s'", {"a": "it's"}),
        ("a: [[1, 2], [3, 4]]", {"a": [["1", "2"], ["3", "4"]]}),
        ("a:\n- 1\n- b: 2\n", {"a": ["1", {"b": "2"}]}),
        ("\ufeffa: 1", {"a": "1"}),
        ("a: 1\r\nb: 2\r\n", {"a": "1", "b": "2"}),
        ("---\na: 1\n...\n", {"a": "1"}),
        ("%YAML 1.2\n---\na: 1", {"a": "1"}),
        ("a: می\u200cخواهم", {"a": "می\u200cخواهم"}),
        ("a: </script>\\input{x}", {"a": "</script>\\input{x}"}),
        ("- 1", ["1"]),
        ("x", "x"),
    ],
)
def test_scalars_stay_text_but_for_true_false_and_null(text, value):
    assert parse(text).plain() == value


def test_every_value_knows_its_place():
    tree = parse("title: x\nsystem:\n  A: [[1, -22], ['3 ', \"4\"]]\n")
    system = tree["system"]
    rows = system["A"].items
    assert isinstance(tree, MappingNode)
    assert isinstance(rows[0], SequenceNode)
    entry, quoted = rows[0].items[1], rows[1].items[0]
    assert isinstance(entry, ScalarNode)
    assert (entry.place.line, entry.place.column, entry.place.length) == (3, 11, 3)
    assert (quoted.place.column, quoted.place.length, quoted.style) == (18, 4, "quoted")
    assert (system.entries["A"].key.place.line, system.entries["A"].key.place.column) == (3, 3)
    assert (system["A"].place.column, system["A"].place.length) == (6, 23)


@pytest.mark.parametrize(
    ("text", "column", "length"),
    [
        ("a: 1 + xy", 8, 2),
        ("a: '1 + xy'", 9, 2),
        ('a: "1 + xy"', 9, 2),
        ('a: "1 \\u002b xy"', 4, 13),  # an escape: offsets no longer fit, the whole value is underlined
        ("a: '1 '' xy'", 4, 9),
        ("a: 1 +\n  xy", 4, 1),
        ("a: |\n  1 + xy\n", 4, 1),
    ],
)
def test_an_offset_in_a_text_is_a_column_in_the_file(text, column, length):
    fault = parse(text)["a"].fault_inside("m", 4, 2)
    assert [(each.line, each.column, each.length) for each in fault.diagnostics] == [(1, column, length)]


@pytest.mark.parametrize(
    ("text", "line", "column", "message"),
    [
        ("a: &x 1", 1, 4, "anchors (&x) are not read here"),
        ("a: &x [1]", 1, 4, "anchors (&x) are not read here"),
        ("a: *x", 1, 4, "aliases (*x) are not read here"),
        ("a: !x 1", 1, 4, "tags (!x) are not read here"),
        ("a: !!python/object/apply:os.system [x]", 1, 4, "tags (!!python/object/apply:os.system) are not read here"),
        ("a: !!float 1", 1, 4, "tags (!!float) are not read here"),
        ("a: 1\nb: {<<: {c: 1}}", 2, 5, "merge keys (<<) are not read here"),
        ("a: 1\nb: 2\na: 3", 3, 1, "key 'a' is given twice"),
        ("a: 1\n---\nb: 2", 2, 1, "a second document starts here; a file holds one problem"),
        ("a: 1\n\tb: 2", 2, 1, "a tab; use spaces instead"),
        ("a: 1 \t# x", 1, 6, "a tab; use spaces instead"),
        ("a: x\u202ey", 1, 5, "the invisible character U+202E is not allowed"),
        ("a: x\u200by", 1, 5, "the invisible character U+200B is not allowed"),
        ("a: x\x00", 1, 5, "the invisible character U+0000 is not allowed"),
        ("a: x\x1b[31m", 1, 5, "the invisible character U+001B is not allowed"),
        ("a: x\u2028y: z", 1, 5, "the invisible character U+2028 is not allowed"),
        ("a: x\x85y: z", 1, 5, "the invisible character U+0085 is not allowed"),
        ("a: x\ry: z", 1, 5, "the invisible character U+000D is not allowed"),
        ("a: \ud800", 1, 4, "the invisible character U+D800 is not allowed"),
        ("a: \U000e0041", 1, 4, "the invisible character U+E0041 is not allowed"),
        ('a: "$\\frac{1}{2}$"', 1, 4, "an escape makes the invisible character U+000C"),
        ('a: "\\u202e"', 1, 4, "an escape makes the invisible character U+202E"),
        ('a: "\\0"', 1, 4, "an escape makes the invisible character U+0000"),
        ('a: "$\\sqrt{2}$"', 1, 6, "unknown escape in a text in double quotes"),
        ("? [1, 2]\n: 3", 1, 3, "a key must be a word, not a list"),
        ("{{a: 1}: 2}", 1, 2, "a key must be a word, not a mapping"),
        ("title: a: b", 1, 9, "a ':' is not expected here"),
        ("title:Servo\nb: 1", 2, 2, "a ':' is not expected here"),
        ("a: @x", 1, 4, "a value cannot start with '@'"),
        ("a: `x`", 1, 4, "a value cannot start with '`'"),
        ("a: %x", 1, 4, "a value cannot start with '%'"),
        ("a: [1, 2\n", 1, 4, "the closing ']' is missing"),
        ("a: {b: 1", 1, 4, "the closing '}' is missing"),
        ("a: 'x", 1, 4, "the closing quote is missing"),
        ("a: [1, 2\nb: 3", 2, 2, "a ',' or the closing ']' is missing"),
        ("a: {b: 1\nc: 2", 2, 2, "a ',' or the closing '}' is missing"),
        ("a: [1,,2]", 1, 7, "a value is missing here"),
        ("a: ]", 1, 4, "a value is missing here"),
        ("a:\n  b: 1\n c: 2", 3, 2, "this line does not fit what stands above it"),
        ("- a\nb: 1", 2, 1, "this line does not fit what stands above it"),
        ("a: [1] [2]", 1, 8, "this is not expected here"),
        ("a: 'it's'", 1, 8, "this is not expected here"),
        ("{a: 1}}", 1, 7, "this is not expected here"),
        ("a: |x\n  b", 1, 5, "nothing may follow '|' or '>' on its line"),
        ("a: - b", 1, 4, "a list cannot start here"),
        ("a: * b", 1, 5, "a name is missing"),
        ("", 0, 0, "the file is empty"),
        ("# only a comment\n\n", 0, 0, "the file is empty"),
    ],
)
def test_what_problem_files_do_not_need_is_refused_at_its_place(text, line, column, message):
    assert complaints(text) == [(line, column, message)]


def test_the_key_given_twice_names_the_first_place():
    with pytest.raises(InputError, match="first given at line 2, column 3"):
        parse("s:\n  a: 1\n  b: 2\n  a: 3\n")


def test_a_missing_space_after_a_colon_is_pointed_out():
    with pytest.raises(InputError, match="line 1: a space is missing after 'title:'"):
        parse("title:Servo\nb: 1")


def test_all_refusals_of_a_file_are_reported_together():
    text = "a: &x 1\nb: *x\nc: !t 2\na: 3\n? [k]\n: 1\n"
    assert [line for line, _, _ in complaints(text)] == [1, 2, 3, 4, 5]


def test_a_bomb_of_aliases_is_refused_without_being_built():
    levels = [f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 9)}]" for i in range(1, 12)]
    found = complaints("\n".join(["a0: &a0 [x, x, x]", *levels]))
    assert {message.split()[0] for _, _, message in found} == {"anchors", "aliases"}


@pytest.mark.parametrize("unit", ["[", "{", "- ", "? ", "[{", "{a: ", "a: [", "- - [", "&a [", "!x [", "[&x "])
def test_a_hundred_thousand_openings_are_refused(unit):
    (found,) = complaints(unit * (100_000 // len(unit)))
    assert any(words in found[2] for words in ("nested", "brackets", "not expected", "not read", "missing"))


def test_no_more_than_a_hundred_faults_of_a_kind_are_listed():
    assert len(complaints("a: 1\n" + "\tb\n" * 150)) == 100


def test_the_depth_of_nesting_is_bounded():
    assert parse("[" * 24 + "]" * 24).plain()
    assert complaints("[" * 25 + "]" * 25) == [(1, 25, "values are nested more than 24 deep")]
    block = "".join(" " * i + "a:\n" for i in range(40))
    assert complaints(block) == [(24, 24, "values are nested more than 24 deep")]


def test_brackets_in_texts_do_not_count_as_nesting():
    assert parse(f"a: |\n  {'[' * 150}\nb: '{'{' * 40}'").plain()["b"] == "{" * 40


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a: [" + "1, " * 25_000 + "1]", "there are more than 20000 values in the file"),
        ("a: '" + "x" * 20_001 + "'", "a text is longer than 20000 characters"),
        ("# " + "é" * 131_072, "the file is larger than 256 KB"),
    ],
)
def test_size_is_bounded(text, message):
    assert [found[2] for found in complaints(text)] == [message]


def test_closing_brackets_open_nothing():
    text = f"title: '{']' * (yaml_tree.MAX_OPEN_BRACKETS + 1)}'\n"
    assert parse_yaml(Source("file.yaml", text))["title"].text.endswith("]")
