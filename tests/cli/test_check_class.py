"""`solve check` for a class: folders, the list of data, the table, what needs review, changes, how values are read."""

import csv
import json
import os
from fractions import Fraction

import pytest

PROBLEM = """\
title: A plant
system: {A: [[1, 2], [3, 1]], B: [0, 1], C: [1, 3]}
find:
  a: {task: pole_placement, poles: ["-3 ± 2j"], marks: 10, answers: [K, polynomial, closed_loop_A]}
  b: {task: controllability, marks: 1}
"""
ADA = "student: Ada\nanswers: {a: {K: [13, 8], polynomial: s^2+6s+13, closed_loop_A: [[1, 2], [-10, -7]]}}\n"
BOB = "student: Bob\nanswers: {a: {K: [13, 7], polynomial: s^2 +}, b: {controllable: yes}}\n"


@pytest.fixture
def folder(tmp_path):
    """The problem, and a folder of answer files, one of them at fault."""
    (tmp_path / "problem.yaml").write_text(PROBLEM, encoding="utf-8")
    (tmp_path / "class").mkdir()
    for name, text in {"ada.yaml": ADA, "bob.yml": BOB, "eve.yaml": "answers: [", ".hidden.yaml": ADA}.items():
        (tmp_path / "class" / name).write_text(text, encoding="utf-8")
    return tmp_path


def table(folder):
    return list(csv.DictReader((folder / "marks.csv").read_text(encoding="utf-8").splitlines()))


def test_a_folder_stands_for_the_answer_files_in_it_and_their_data_are_a_list(solve, folder):
    done = solve("check", "problem.yaml", "class", "-f", "json")
    assert done.code == 2
    ada, bob, eve = json.loads(done.out)
    assert [each["file"] for each in (ada, bob, eve)] == ["class/ada.yaml", "class/bob.yml", "class/eve.yaml"]
    assert (ada["student"], ada["marks"], ada["needs_review"]) == ("Ada", 10, False)
    assert ada["parts"][1]["not_submitted"] == ["controllable"]
    assert bob["parts"][0]["answers"]["K"]["marks"] == 1.67
    assert bob["parts"][0]["answers"]["K"]["typed"] == "[13, 7]"
    assert bob["needs_review"]
    assert "eve.yaml:2:" in eve["error"]
    assert eve["needs_review"] is True


def test_the_list_may_go_to_a_file_that_is_there_and_one_file_is_no_list(solve, folder):
    (folder / "all.json").write_text("old", encoding="utf-8")
    files = ("class/ada.yaml", "class/bob.yml")
    assert solve("check", "problem.yaml", *files, "-o", "all.json").code == 1
    assert [each["student"] for each in json.loads((folder / "all.json").read_text(encoding="utf-8"))] == ["Ada", "Bob"]
    assert json.loads(solve("check", "problem.yaml", "class/ada.yaml", "-f", "json").out)["student"] == "Ada"
    solve("check", "problem.yaml", *files, "-f", "json", "-o", "each/")
    assert json.loads((folder / "each" / "bob.marked.json").read_text(encoding="utf-8"))["student"] == "Bob"


def test_a_folder_without_answer_files_is_said_to_be_so(solve, folder):
    (folder / "empty").mkdir()
    done = solve("check", "problem.yaml", "empty")
    assert (done.code, "there is no answer file in empty" in done.err) == (2, True)


def test_patterns_stand_for_answer_files(solve, folder):
    text = (folder / "class" / "ada.yaml").read_text(encoding="utf-8")
    (folder / "class" / "ada.yaml").write_text(f"problem: ../problem.yaml\n{text}", encoding="utf-8")
    done = solve("check", "class/a*.yaml", "class/[a]da.yaml", "-f", "json")
    assert [each["file"] for each in json.loads(done.out)] == ["class/ada.yaml"]


def test_the_columns_of_the_table_add_up(solve, folder):
    solve("check", "problem.yaml", "class", "--csv", "marks.csv")
    for row in table(folder)[:2]:
        of_answers = [row["a.K"], row["a.polynomial"], row["a.closed_loop_A"]]
        assert sum(map(Fraction, of_answers)) == Fraction(row["a"])
        assert Fraction(row["a"]) + Fraction(row["b"]) == Fraction(row["total"])
    ada, bob, eve = table(folder)
    assert (ada["a.K"], ada["a"], ada["b.controllable"], ada["total"], ada["out of"]) == ("3.34", "10", "0", "10", "11")
    assert (bob["student"], bob["needs review"]) == ("Bob", "yes")
    assert (eve["file"], eve["total"], eve["needs review"]) == ("class/eve.yaml", "not readable", "yes")


def test_the_table_is_told_in_the_language_asked_for(solve, folder):
    solve("check", "problem.yaml", "class", "--csv", "marks.csv", "--language", "de")
    assert list(table(folder)[0])[:2] == ["Datei", "Name"]
    assert [row["durchzusehen"] for row in table(folder)] == ["nein", "ja", "ja"]


def test_what_is_not_judged_is_said_on_the_last_line(solve, folder):
    done = solve("check", "problem.yaml", "class/bob.yml")
    assert done.code == 1
    assert done.out.splitlines()[-1] == "needs review: a.polynomial (not judged)"
    assert "– closed_loop_A: not submitted" in done.out
    assert "needs review" not in solve("check", "problem.yaml", "class/ada.yaml").out
    assert "needs review: a.polynomial (not judged)" in solve("check", "problem.yaml", "class", "-f", "html").out


def test_the_last_line_of_several_files_names_those_that_need_review(solve, folder):
    out = solve("check", "problem.yaml", "class").out
    assert out.splitlines()[-1] == "needs review: class/bob.yml, class/eve.yaml"


def test_a_sheet_that_cannot_be_written_does_not_stop_the_rest(solve, folder):
    (folder / "class" / "ada.marked.html").mkdir()
    done = solve("check", "problem.yaml", "class", "-f", "html")
    assert done.code == 2
    assert "class/ada.yaml: error: cannot write" in done.err
    assert (folder / "class" / "bob.marked.html").is_file()


CHANGES = """\
changes:
  Bob:
    comment: Come and see me.
    a:
      comment: Mind the second pole.
      K: {marks: 3, comment: Nearly.}
      polynomial: {verdict: correct}
  class/ada.yaml:
    b: {controllable: {verdict: correct, comment: Handed in on paper.}}
"""


def test_an_instructors_changes_win_and_are_said_to_be_such(solve, folder):
    (folder / "changes.yaml").write_text(CHANGES, encoding="utf-8")
    solve("check", "problem.yaml", "class", "--override", "changes.yaml", "--csv", "marks.csv", "-f", "html")
    ada, bob, _ = table(folder)
    assert (ada["b.controllable"], ada["total"]) == ("1", "11")
    assert (bob["a.K"], bob["a.polynomial"], bob["a"], bob["total"]) == ("3", "3.33", "6.33", "7.33")
    assert bob["needs review"] == "no"
    sheet = (folder / "class" / "bob.marked.html").read_text(encoding="utf-8")
    for said in ("Come and see me.", "Mind the second pole.", "Nearly.", "correct, by the instructor"):
        assert said in sheet
    done = solve("check", "problem.yaml", "class/bob.yml", "-f", "json", "--override", "changes.yaml")
    assert done.code == 2  # the other file that is changed is not named
    answers = json.loads(done.out)["parts"][0]["answers"]
    assert answers["polynomial"] == {
        "verdict": "correct", "by": "instructor", "typed": "s^2 +", "marks": 3.33, "out_of": 3.33,
    }  # fmt: skip
    assert answers["K"]["comment"] == "Nearly."
    assert answers["K"]["reason"]


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ("{Ada: {a: {k: {marks: 1}}}}", "did you mean 'K'?"),
        ("{Ada: {A: {K: {marks: 1}}}}", "did you mean 'a'?"),
        ("{Ada: {a: {K: {mark: 1}}}}", "did you mean 'marks'?"),
        ("{Ada: {a: {K: {verdict: right}}}}", "a verdict is one of correct, wrong, not judged"),
        ("{Ada: {a: {K: {marks: -1}}}}", "marks are a number such as 2.5"),
        ("{Ada: {a: {K: 3}}}", "{verdict: correct, marks: 2, comment: …}"),
        ("{Ada: {a: {}}, ada.yaml: {b: {}}}", "is changed under another name too"),
        ("[Ada]", "'changes:' must list the changes"),
    ],
)
def test_changes_at_fault_are_refused_before_anything_is_marked(solve, folder, changes, said):
    (folder / "changes.yaml").write_text(f"changes: {changes}", encoding="utf-8")
    done = solve("check", "problem.yaml", "class/ada.yaml", "--override", "changes.yaml", "--csv", "marks.csv")
    assert (done.code, done.out) == (2, "")
    assert "changes.yaml:1:" in done.err
    assert said in done.err
    assert not (folder / "marks.csv").exists()


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ("{Adda: {a: {K: {marks: 1}}}}", "did you mean 'ada'?"),
        ("{Ada: {a: {K: {marks: 4}}}}", "K carries 3.34 marks"),
    ],
)
def test_changes_that_fit_nobody_do_not_stop_the_rest(solve, folder, changes, said):
    (folder / "changes.yaml").write_text(f"changes: {changes}", encoding="utf-8")
    done = solve("check", "problem.yaml", "class/ada.yaml", "--override", "changes.yaml")
    assert done.code == 2
    assert said in done.err
    assert "10 of 11" in done.out


def test_how_values_are_read_is_told_without_verdicts(solve, folder):
    text = """\
    answers:
      a: {K: [13, 8], polynomial: (s+3)^2 + 4}
      b: {controllable: nope, hidden_modes: [1, 2], controllability_matrix: [[0, 2], [1, 1]]}
    """
    (folder / "mine.yaml").write_text(text, encoding="utf-8")
    done = solve("check", "problem.yaml", "mine.yaml", "--syntax")
    assert done.code == 1
    assert "a.K (a matrix): [13, 8]\n    read as [13, 8]\n" in done.out
    assert "b.controllable (yes or no): nope\n    it cannot be read (line 3, column" in done.out
    assert not {"correct", "wrong", "marks"} & set(done.out.replace(":", " ").split())
    data = json.loads(solve("check", "problem.yaml", "mine.yaml", "--syntax", "-f", "json").out)
    assert data["values"][1]["formulas"] == ["(s + 3)^{2} + 4"]
    assert solve("check", "problem.yaml", "class/ada.yaml", "--syntax").code == 0
    assert solve("check", "problem.yaml", "class/ada.yaml", "--syntax", "--csv", "marks.csv").code == 2


def test_the_marking_does_not_depend_on_how_many_files_are_marked_at_once(solve, folder):
    one, three = (solve("check", "problem.yaml", "class", "-f", "json", "--jobs", jobs).out for jobs in (1, 3))
    assert one == three


def test_a_link_beside_answers_is_not_followed_by_their_sheet(solve, folder):
    outside = folder / "outside.html"
    outside.write_text("mine", encoding="utf-8")
    sheet = folder / "class" / "ada.marked.html"
    sheet.symlink_to(outside)
    os.mkfifo(folder / "class" / "bob.marked.html")
    assert solve("check", "problem.yaml", "class/ada.yaml", "class/bob.yml", "-f", "html").code == 1
    assert outside.read_text(encoding="utf-8") == "mine"
    assert not sheet.is_symlink()
    assert "<!DOCTYPE html>" in (folder / "class" / "bob.marked.html").read_text(encoding="utf-8")
    (folder / "named.html").symlink_to(outside)
    solve("check", "problem.yaml", "class/ada.yaml", "-f", "html", "-o", "named.html")
    assert "<!DOCTYPE html>" in outside.read_text(encoding="utf-8")
