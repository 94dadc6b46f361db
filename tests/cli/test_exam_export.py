"""`solve exam --export`: one file for each learning system, what a person must mark, and what is wrong."""

import pytest

from tests.papers.banks.moodle_reader import read_moodle
from tests.papers.exams import EXAM, write_exam


@pytest.fixture
def exam(tmp_path):
    """An exam in a folder."""
    return write_exam(tmp_path, EXAM.replace("answers: [eigenvalues]", "answers: [eigenvalues, right_eigenvectors]"))


def test_a_bank_is_written_in_place_of_papers(solve, exam, tmp_path):
    done = solve("exam", exam, "-o", "build", "--export", "moodle", "--jobs", 1)
    assert done.code == 0, done.err
    assert [path.name for path in (tmp_path / "build").iterdir()] == ["exam-moodle.xml"]
    assert "8 questions, 6 with fields, 2 essays, all verified" in done.out
    assert (
        "essay: Question 3, (c) Eigenvalues and eigenvectors, in words: right_eigenvectors: several values are right"
        in done.err
    )
    read = read_moodle((tmp_path / "build" / "exam-moodle.xml").read_bytes())
    names = [each.idnumber for each in read]
    assert names[:2] == ["final-exam-1-f-2026-1", "final-exam-1-f-2026-2"]
    assert names[2:] == [f"final-exam-{each}" for each in ("2-a", "2-b", "3-a", "3-b", "3-c", "3-c-rest")]
    assert read[0].category == read[1].category == "$course$/top/Final <exam>/1. A family"
    assert read[0].tags == ["Pole placement by state feedback", "Variant 1"]
    assert [each.grade for each in read[:2]] == [10, 10]
    assert all("<h3>1. " in each.feedback for each in read)


def test_the_same_bank_is_written_by_any_number_of_processes(solve, exam, tmp_path):
    for jobs, folder in ((1, "one"), (2, "two")):
        assert solve("exam", exam, "-o", folder, "--export", "moodle,qti,canvas", "--jobs", jobs).code == 0
    files = {path.name: path.read_bytes() for path in (tmp_path / "one").iterdir()}
    assert sorted(files) == ["exam-canvas.zip", "exam-moodle.xml", "exam-qti.zip"]
    assert files == {path.name: path.read_bytes() for path in (tmp_path / "two").iterdir()}


def test_a_question_is_solved_once(solve, exam, called):
    assert solve("exam", exam, "-o", "build", "--export", "moodle", "--jobs", 1).code == 0
    assert {name for name, _ in called} == {"tried", "made_of"}
    solved = [text for _, text in called]
    assert len(solved) == len(set(solved)) == 4


def test_detail_tells_how_much_the_feedback_tells(solve, exam, tmp_path):
    sizes = []
    for detail in ("key", "full"):
        assert solve("exam", exam, "-o", detail, "--export", "moodle", "--detail", detail, "--jobs", 1).code == 0
        sizes.append((tmp_path / detail / "exam-moodle.xml").stat().st_size)
    assert sizes[0] < sizes[1]


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--export", "mooodle"], "Did you mean moodle?"),
        (["--export", ""], "no format named"),
        (["--export", "moodle", "-f", "html"], "-f means nothing"),
        (["--export", "moodle", "-o", "-"], "name a folder"),
    ],
)
def test_what_is_wrong_is_said(solve, exam, options, told):
    done = solve("exam", exam, *options)
    assert done.code == 2
    assert told in done.err


UNSOLVED = """\
title: t
system: {A: [[1, 0], [0, 2]], B: [0, 1]}
find: {a: {task: pole_placement, poles: [-1, -2]}}
"""


def test_a_question_without_a_solution_is_left_out_and_the_others_go_on(solve, tmp_path):
    write_exam(tmp_path, EXAM, step=UNSOLVED)
    done = solve("exam", "exam.yaml", "-o", "build", "--export", "moodle,qti,canvas", "--jobs", 1)
    assert done.code == 0, done.err
    assert "left out, as it has no solution: 2. t: part a: " in done.err
    read = read_moodle((tmp_path / "build" / "exam-moodle.xml").read_bytes())
    assert {each.idnumber[:12] for each in read} == {"final-exam-1", "final-exam-3"}


def test_where_no_question_has_a_solution_nothing_is_written(solve, tmp_path):
    only = EXAM.replace("  - {problem: family.yaml, marks: 10}\n", "")
    write_exam(tmp_path, only[: only.index("  - problem:\n")] + "variants: {count: 2}\n", step=UNSOLVED)
    done = solve("exam", "exam.yaml", "-o", "build", "--export", "moodle", "--jobs", 1)
    assert done.code == 1
    assert "nothing was written: no question has a solution" in done.err
    assert not list(tmp_path.rglob("*-moodle.xml"))


def test_a_part_without_a_solution_is_left_out_and_the_others_go_on(solve, tmp_path):
    write_exam(tmp_path, EXAM, step='title: t\nsystem: {A: [[1, 0], [0, 2]], B: [0, 1]}\n'
               "find: {a: {task: pole_placement, poles: [-1, -2]}, b: controllability}\n")  # fmt: skip
    done = solve("exam", "exam.yaml", "-o", "build", "--export", "moodle", "--jobs", 1)
    assert done.code == 0, done.err
    assert "left out, as it has no solution: " in done.err
    assert "part a: " in done.err
    read = read_moodle((tmp_path / "build" / "exam-moodle.xml").read_bytes())
    assert [each.idnumber for each in read if each.idnumber.startswith("final-exam-2")] == ["final-exam-2-b"]


def test_identifiers_of_long_names_are_short_enough_and_each_ones_own(solve, tmp_path):
    names = [f"{'Maria ' * 11}{each}" for each in ("Abad", "Zorn")]
    (tmp_path / "class.csv").write_text("\n".join(["name", *names]), encoding="utf-8")
    long = EXAM[: EXAM.index("  - {problem: step.yaml")] + "variants: {students: class.csv}\nseed: 20262026\n"
    write_exam(tmp_path, long.replace("Final <exam>", "The final exam " * 8))
    assert solve("exam", "exam.yaml", "-o", "build", "--export", "moodle", "--jobs", 1).code == 0
    read = read_moodle((tmp_path / "build" / "exam-moodle.xml").read_bytes())
    assert len({each.idnumber for each in read}) == len(read) == 2
