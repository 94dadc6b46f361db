"""`solve check` from the outside: exit codes, formats, sheets, tables of marks, files at fault."""

import csv
import io
import json

import pytest

PROBLEM = """\
title: A plant
system: {A: [[1, 2], [3, 1]], B: [0, 1]}
find:
  a: {task: characteristic_polynomial, marks: 1}
  b: {task: eigenstructure, marks: 2, answers: diagonalizable}
"""
RIGHT = "student: A-17\nanswers: {a: {polynomial: x}, b: {diagonalizable: yes}}\n".replace("x", "lamda^2-2lamda-5")
WRONG = "student: =1+1\nanswers: {a: {polynomial: lamda^2+2lamda-5}, b: {diagonalizable: no}}\n"


@pytest.fixture
def folder(tmp_path):
    """The problem and four answer files, in the folder the command runs in."""
    for name, text in {"problem": PROBLEM, "right": RIGHT, "wrong": WRONG, "bad": "answers: {a: {p: [}}"}.items():
        (tmp_path / f"{name}.yaml").write_text(text, encoding="utf-8")
    named = "problem: problem.yaml\n" + RIGHT
    (tmp_path / "named.yaml").write_text(named, encoding="utf-8")
    return tmp_path


def test_right_answers_end_with_zero_and_wrong_ones_with_one(solve, folder):
    assert solve("check", "problem.yaml", "right.yaml").code == 0
    assert solve("check", "problem.yaml", "wrong.yaml").code == 1
    assert solve("check", "named.yaml").code == 0


def test_the_problem_is_sought_beside_the_answers_that_name_it(solve, folder):
    (folder / "class").mkdir()
    for name in ("problem.yaml", "named.yaml"):
        (folder / name).rename(folder / "class" / name)
    assert solve("check", "class/named.yaml").code == 0


def test_answers_from_standard_input_may_name_a_problem(solve, folder, monkeypatch):
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO((folder / "named.yaml").read_bytes())))
    assert solve("check", "-").code == 0


def test_json_is_as_documented(solve, folder):
    data = json.loads(solve("check", "problem.yaml", "wrong.yaml", "-f", "json").out)
    assert data["parts"][0]["id"] == "a"
    assert data["parts"][0]["answers"]["polynomial"]["verdict"] == "wrong"
    assert data["parts"][0]["answers"]["polynomial"]["reason"]
    assert (data["parts"][1]["marks"], data["parts"][1]["out_of"]) == (0, 2)


def test_the_command_line_says_what_wrong_answers_earn(solve, folder):
    (folder / "half.yaml").write_text("answers: {a: {polynomial: -lamda^2+2lamda+5}}")
    for rule, marks in (("named", 0.5), ("none", 0)):
        data = json.loads(solve("check", "problem.yaml", "half.yaml", "-f", "json", "--partial", rule).out)
        assert data["parts"][0]["answers"]["polynomial"]["mistake"] == "sign"
        assert data["marks"] == marks


def test_a_bad_file_does_not_stop_the_rest_and_the_table_has_a_line_for_each(solve, folder):
    done = solve("check", "problem.yaml", "right.yaml", "bad.yaml", "wrong.yaml", "--csv", "marks.csv")
    assert done.code == 2
    assert "bad.yaml:1:" in done.err
    rows = list(csv.reader((folder / "marks.csv").read_text(encoding="utf-8").splitlines()))
    assert rows == [
        ["file", "student", "a.polynomial", "a", "b.diagonalizable", "b", "total", "out of", "needs review"],
        ["right.yaml", "A-17", "1", "1", "2", "2", "3", "3", "no"],
        ["bad.yaml", "", "", "", "", "", "not readable", "", "yes"],
        ["wrong.yaml", "'=1+1", "0", "0", "0", "0", "0", "3", "no"],
    ]


def test_files_of_one_name_have_a_sheet_each_and_what_is_read_is_not_overwritten(solve, folder):
    for group in ("north", "south"):
        (folder / group).mkdir()
        (folder / group / "ada.yaml").write_text(RIGHT, encoding="utf-8")
    files = ("north/ada.yaml", "south/ada.yaml", "right.yaml")
    assert solve("check", "problem.yaml", *files, "-f", "html", "-o", "sheets/").code == 0
    names = sorted(path.name for path in (folder / "sheets").iterdir())
    assert names == ["north-ada.marked.html", "right.marked.html", "south-ada.marked.html"]
    for option in ("--csv", "-o"):
        done = solve("check", "problem.yaml", "right.yaml", option, "./right.yaml")
        assert (done.code, "not overwritten" in done.err) == (2, True)
    assert (folder / "right.yaml").read_text(encoding="utf-8") == RIGHT


def test_a_label_that_looks_like_markup_is_printed_as_it_is(solve, folder):
    text = "student: '[/b] [red]x'\nanswers: {a: {polynomial: 2+, poles: 1}, z: 1}\n"
    (folder / "odd.yaml").write_text(text, encoding="utf-8")
    done = solve("check", "problem.yaml", "odd.yaml", "right.yaml")
    assert done.code == 0
    assert "[/b] [red]x" in done.out
    assert "the problem has no part 'z'" in " ".join(done.out.split())
    data = json.loads(solve("check", "problem.yaml", "odd.yaml", "-f", "json").out)
    assert [remark.partition(":")[0] for remark in data["remarks"]] == [
        "line 2, column 31 is left out", "line 2, column 42 is left out",
    ]  # fmt: skip
    assert data["parts"][0]["answers"]["polynomial"]["verdict"] == "not judged"


def test_a_sheet_shows_values_verdicts_and_on_request_the_solution(solve, folder):
    assert solve("check", "problem.yaml", "wrong.yaml", "-f", "html").code == 1
    sheet = (folder / "wrong.marked.html").read_text(encoding="utf-8")
    assert "<math" in sheet
    assert "The opposite is true." in sheet
    assert "Worked solution" not in sheet
    solve("check", "problem.yaml", "wrong.yaml", "--solution", "-o", "out.html")
    assert "Worked solution" in (folder / "out.html").read_text(encoding="utf-8")


def test_an_answer_file_without_problem_is_at_fault(solve, folder):
    done = solve("check", "right.yaml")
    assert done.code == 2
    assert "names no problem" in done.err


def test_a_marking_is_told_in_the_language_and_the_symbols_asked_for(solve, folder):
    placed = PROBLEM.replace(
        "{task: eigenstructure, marks: 2, answers: diagonalizable}", "{task: pole_placement, poles: [-1, -2]}"
    )
    (folder / "placed.yaml").write_text(placed, encoding="utf-8")
    (folder / "mine.yaml").write_text("answers: {a: {polynomial: lamda}, b: {K: [1, 1]}}", encoding="utf-8")
    german = solve("check", "placed.yaml", "mine.yaml", "--language", "de")
    assert (german.code, german.err) == (1, "")
    assert "a  Charakteristisches Polynom: 0 von 1" in german.out
    assert "✗ K: falsch – mit Ihrem K_f sind die Pole −1.562, 2.562; verlangt sind −2, −1" in german.out
    assert "Characteristic polynomial: 0 of 1" in solve("check", "placed.yaml", "mine.yaml").out
    done = solve("check", "placed.yaml", "mine.yaml", "-f", "html", "--language", "de", "--notation", "ogata")
    assert done.out == "mine.yaml: 0 von 1 Punkten; mine.marked.html geschrieben\n"
    assert "K_f" not in (folder / "mine.marked.html").read_text(encoding="utf-8")
    refused = solve("check", "placed.yaml", "mine.yaml", "--language", "dee")
    assert refused.code == 2
    assert "did you mean 'de'?" in refused.err


def test_one_file_is_an_answer_file_and_so_is_the_first_of_several_that_has_answers(solve, folder):
    assert "it names no problem; call solve check PROBLEM ANSWERS" in solve("check", "right.yaml").err
    assert "this is a problem, not an answer file" in solve("check", "problem.yaml").err
    done = solve("check", "named.yaml", "right.yaml")
    assert "named.yaml (A-17): 3 of 3" in done.out
    assert "right.yaml: error: it names no problem" in done.err


def test_a_marking_in_a_file_has_no_signs_for_a_terminal(solve, folder, monkeypatch):
    monkeypatch.setattr("sys.stdout.isatty", lambda: True)
    monkeypatch.delenv("NO_COLOR")
    assert "\x1b[" in solve("check", "problem.yaml", "wrong.yaml").out
    solve("check", "problem.yaml", "wrong.yaml", "-o", "marking.txt")
    assert "\x1b" not in (folder / "marking.txt").read_text(encoding="utf-8")


def test_one_marking_may_replace_a_file_and_several_may_not(solve, folder):
    (folder / "marking.html").write_text("old", encoding="utf-8")
    refused = solve("check", "problem.yaml", "right.yaml", "wrong.yaml", "-o", "marking.html")
    assert "marking.html is one file; name a folder for 2 answer files." in refused.err
    assert (folder / "marking.html").read_text(encoding="utf-8") == "old"
    assert solve("check", "problem.yaml", "right.yaml", "-o", "marking.html").code == 0
    assert "A-17" in (folder / "marking.html").read_text(encoding="utf-8")
