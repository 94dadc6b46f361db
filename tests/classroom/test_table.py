"""Tables of marks open in spreadsheets: nothing in them is a formula there."""

import pytest

from solver.classroom.report.table import harmless


@pytest.mark.parametrize(
    ("text", "cell"),
    [
        ("=1+1", "'=1+1"),
        ("-2+3", "'-2+3"),
        ("@SUM(A1)", "'@SUM(A1)"),
        ("\t=1", "'\t'=1"),
        (" +1", "' +1"),
        ("＝1+1", "'＝1+1"),  # of full width, as typed in Japanese
        ("x;=cmd|calc", "x;'=cmd|calc"),  # cells are parted at semicolons where a comma is the decimal sign
        ("Anna-Maria", "Anna-Maria"),
        ("Doe; Jo", "Doe; Jo"),
        ("a@b.c", "a@b.c"),
        ("", ""),
    ],
)
def test_what_a_spreadsheet_would_take_for_a_formula_is_text(text, cell):
    assert harmless(text) == cell
