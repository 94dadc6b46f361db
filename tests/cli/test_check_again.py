"""Answers marked again: only what changed is marked, and what is written is the same as if all were."""

import shutil
import zlib

import pytest

from tests.papers.exams import write_exam

EXAM = """\
exam: Test
questions:
  - {problem: family.yaml, marks: 4}
  - marks: 10
    problem:
      system: {matrix: [[1, 2], [0, 4]]}
      find: {a: {task: eigenstructure, answers: [eigenvalues]}, b: characteristic_polynomial}
variants: {count: 2}
"""
PROBLEM = """\
system: {matrix: [[1, 2], [0, 4]]}
find: {a: {task: eigenstructure, answers: [eigenvalues]}, b: characteristic_polynomial}
"""
COUNT = 8


def answers(number, values):
    head = f"variant: 1\nstudent: S{number}\nanswers:\n  1: {{f: {{K: [1, 2]}}}}\n"
    return f"{head}  2: {{a: {{eigenvalues: {values}}}}}\n"


@pytest.fixture
def marked(solve, tmp_path, called):
    """Mark a class; return the outcome, how many submissions were marked, and all that was written."""
    called.clear()

    def mark(*words, about="exam.yaml", to="out"):
        called.clear()
        end = ("--report", f"{to}/report.html") if about == "exam.yaml" else ()
        done = solve("check", about, "in", "-f", "html", "-o", f"{to}/", "--csv", f"{to}/grades.csv", *end, *words)
        files = {path.name: path.read_bytes() for path in sorted((tmp_path / to).iterdir()) if path.is_file()}
        return done, [name for name, _ in called], files

    return mark


@pytest.fixture
def handed_in(tmp_path):
    write_exam(tmp_path, EXAM, problem=PROBLEM)
    (tmp_path / "in").mkdir()
    for number in range(COUNT):
        text = answers(number, f"[1, {number}]") if number != 5 else "student: [S5"
        (tmp_path / "in" / f"s{number:02}.yaml").write_text(text, encoding="utf-8")


def mend(folder, number, values):
    (folder / "in" / f"s{number:02}.yaml").write_text(answers(number, values), encoding="utf-8")


def test_of_a_class_only_what_was_mended_is_marked_again(marked, handed_in, tmp_path):
    first, calls, before = marked()
    assert first.code == 2
    assert calls.count("mark_packed") == COUNT  # the first question is answered alike by all
    again, calls, after = marked()
    assert (again, calls, after) == (first, [], before)
    for number, values in ((2, "[1, 4]"), (3, "[7, 9]"), (5, "[1, 55]")):
        mend(tmp_path, number, values)
    done, calls, mended = marked()
    assert calls == ["mark_packed"] * 2  # the right values of the first are those of another student
    assert done.code == 1
    assert {name for name in mended if before.get(name) != mended[name]} == {
        "s02.marked.html", "s03.marked.html", "s05.marked.html", "grades.csv", "report.html",
    }  # fmt: skip
    anew, calls, files = marked("--again")
    assert calls.count("mark_packed") == COUNT
    assert {"tried", "_whole"} <= set(calls)
    assert files == mended
    assert anew == done


def test_what_is_marked_by_another_rule_or_told_in_another_language_is_marked_again(marked, handed_in):
    marked()
    assert marked("--partial", "none")[1].count("mark_packed") == COUNT
    assert marked("--language", "de")[1].count("mark_packed") == COUNT
    assert not marked("--language", "de", "--answers")[1]


def test_a_question_that_changed_is_marked_again_for_all(marked, handed_in, tmp_path):
    _, _, before = marked()
    exam = tmp_path / "exam.yaml"
    exam.write_text(EXAM.replace("[0, 4]", "[0, 5]"), encoding="utf-8")
    _, calls, after = marked()
    assert (calls.count("_whole"), calls.count("mark_packed")) == (1, COUNT - 1)
    assert before["s04.marked.html"] != after["s04.marked.html"]
    exam.write_text(EXAM.replace("[0, 4]", "[0, 5]").replace("count: 2", "count: 2}\nseed: {2"[:9]), encoding="utf-8")
    assert not marked()[1]


def test_what_an_instructor_changes_needs_no_marking_and_goes_with_its_file(marked, handed_in, tmp_path):
    _, _, before = marked()
    changes = tmp_path / "changes.yaml"
    changes.write_text("changes: {S4: {2.a: {eigenvalues: {marks: 1.5}}}}\n", encoding="utf-8")
    done, calls, after = marked("--override", "changes.yaml")
    assert not calls
    assert done.code == 2  # the file that cannot be read
    assert {name for name in after if before[name] != after[name]} >= {"s04.marked.html", "grades.csv"}
    assert marked()[2] == before


def test_what_cannot_be_read_any_more_is_marked_again(marked, handed_in, tmp_path):
    first, calls, before = marked()
    kept = sorted((tmp_path / "out" / ".solve").rglob("*.json.z"))
    assert len(kept) > COUNT
    for number, path in enumerate(kept):
        path.write_bytes([b"", b"[", zlib.compress(b"[1]"), path.read_bytes()[:-9]][number % 4])
    again, repeated, after = marked()
    assert sorted(repeated) == sorted(calls)
    assert (again, after) == (first, before)


def test_nothing_is_kept_where_answers_are_handed_in(marked, handed_in, solve, tmp_path):
    assert solve("check", "exam.yaml", "in", "-f", "html", "-o", "in/sheets/").code == 2
    assert solve("check", "exam.yaml", "in", "-f", "json", "-o", "-").code == 2
    assert not list(tmp_path.rglob(".solve"))


def test_answers_to_a_problem_are_kept_too(marked, handed_in, solve, tmp_path):
    for path in (tmp_path / "in").iterdir():
        text = path.read_text(encoding="utf-8").replace("variant: 1\n", "")
        path.write_text(
            text.replace("  1: {f: {K: [1, 2]}}\n  2: ", "  ").replace("{a: {e", "a: {e").replace("}}", "}")
        )
    _, calls, before = marked(about="problem.yaml")
    assert calls.count("mark_packed") == COUNT - 1
    shutil.move(tmp_path / "in" / "s04.yaml", tmp_path / "in" / "renamed.yaml")
    _, calls, after = marked(about="problem.yaml")
    assert not calls
    assert after["renamed.marked.html"] == before["s04.marked.html"]
    (tmp_path / "in" / "s05.yaml").write_text("student: S5\nanswers: {b: {polynomial: lambda}}\n", encoding="utf-8")
    assert marked(about="problem.yaml")[1] == ["mark_packed"]
    assert marked("--solution", about="problem.yaml")[1] == []
    assert marked("--again", about="problem.yaml")[1].count("mark_packed") == COUNT
