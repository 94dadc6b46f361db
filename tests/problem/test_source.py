from __future__ import annotations

import pytest

from solver.problem.source import Diagnostic, Fault, InputError, Report, Source, did_you_mean

SOURCE = Source("file.yaml", "title: x\nfind:\n  a: {kind: state-feedbak}\n")


def test_an_error_shows_its_place_the_line_a_caret_and_a_suggestion():
    error = InputError(SOURCE, [Diagnostic("'state-feedbak' is not known here", 3, 13, 13, "state-feedback")])
    assert error.render().split("\n") == [
        "file.yaml:3:13: error: 'state-feedbak' is not known here",
        "     3 |   a: {kind: state-feedbak}",
        "       |             ^^^^^^^^^^^^^",
        "       = did you mean 'state-feedback'?",
    ]


def test_a_note_follows_the_suggestion():
    rendered = Diagnostic("m", 1, 1, 1, "title", "a note").render(SOURCE).split("\n")
    assert rendered[-2:] == ["       = did you mean 'title'?", "       = a note"]


def test_an_error_of_the_whole_file_has_no_line():
    assert Diagnostic("it is empty").render(SOURCE) == "file.yaml: error: it is empty"


def test_errors_are_shown_once_and_in_the_order_of_the_file():
    third, first = Diagnostic("third", 3, 1), Diagnostic("first", 1, 5)
    error = InputError(SOURCE, [third, first, third, Diagnostic("second", 1, 7)])
    assert [each.message for each in error.diagnostics] == ["first", "second", "third"]


def test_at_most_twenty_errors_are_shown():
    error = InputError(SOURCE, [Diagnostic(f"error {i}", 1, i + 1) for i in range(25)])
    assert error.render().count("error: error") == 20
    assert error.render().endswith("\nand 5 more")
    assert len(error.diagnostics) == 25


def test_exactly_twenty_errors_leave_no_more():
    error = InputError(SOURCE, [Diagnostic(f"error {i}", 1, i + 1) for i in range(20)])
    assert "more" not in error.render()


@pytest.mark.parametrize(
    ("line", "column", "length", "carets"),
    [
        ("title: 制御 x", 11, 1, "            ^"),  # two wide characters before it
        ("title: 制御 x", 8, 2, "       ^^^^"),
        ("te\u0301st: x", 7, 1, "      ^".replace(" ", "", 1)),  # a combining accent takes no cell
        ("a", 2, 1, " ^"),  # the place just after the text
        ("a", 1, 500, "^"),  # never longer than the line
    ],
)
def test_the_caret_stands_under_the_place_in_a_terminal(line, column, length, carets):
    rendered = Diagnostic("m", 1, column, length).render(Source("f", line)).split("\n")
    assert rendered[2] == "       | " + carets


def test_of_a_long_line_the_part_around_the_place_is_shown():
    line = "x" * 5000 + "HERE" + "y" * 5000
    _, shown, carets = Diagnostic("m", 1, 5001, 4).render(Source("f", line)).split("\n")
    assert len(shown) < 130
    assert shown[carets.index("^") :].startswith("HERE")
    assert carets.count("^") == 4


def test_characters_that_do_not_print_are_shown_as_spaces():
    rendered = Diagnostic("m", 1, 2).render(Source("f", "a\x1b[31m\u202eb"))
    assert "\x1b" not in rendered
    assert "\u202e" not in rendered


@pytest.mark.parametrize(
    ("word", "meant"),
    [
        ("statment", "statement"),
        ("Find", "find"),
        ("pole-placement", "pole_placement"),
        ("pole placement", "pole_placement"),
        ("xyz", ""),
        ("", ""),
    ],
)
def test_did_you_mean(word, meant):
    assert did_you_mean(word, ["statement", "find", "pole_placement"]) == meant


def test_a_report_keeps_faults_and_lets_other_errors_through():
    report = Report()
    with report:
        raise Fault(Diagnostic("one"), Diagnostic("two"))
    with report:
        raise Fault
    assert [each.message for each in report.diagnostics] == ["one", "two"]
    with pytest.raises(ZeroDivisionError), report:
        _ = 1 / 0
    with pytest.raises(Fault):
        report.conclude()


def test_an_empty_report_concludes_silently():
    report = Report()
    report.conclude()
    assert not report.diagnostics
