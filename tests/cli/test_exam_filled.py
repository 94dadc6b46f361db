"""An exam made again beside filled answer files, and files of students who are gone: told, never deleted."""

import pytest

from tests.papers.conftest import FAMILY

EXAM = """\
exam: Test
questions:
  - {marks: 10, problem: family.yaml}
  - marks: 10
    problem: {system: {matrix: [[1, 2], [0, 4]]}, find: {a: {task: eigenstructure, answers: [eigenvalues]}}}
variants: {students: class.csv}
seed: 1
"""
SHEET = "exam-papers/answers/answers-Anna.yaml"


@pytest.fixture
def made(solve, tmp_path):
    """Write the exam for students; return the outcome."""

    def of(*students, exam=EXAM):
        (tmp_path / "family.yaml").write_text(FAMILY, encoding="utf-8")
        (tmp_path / "exam.yaml").write_text(exam, encoding="utf-8")
        (tmp_path / "class.csv").write_text("\n".join(["student", *students, ""]), encoding="utf-8")
        done = solve("exam", "exam.yaml", "--jobs", 1)
        assert done.code == 0, done.err
        return done

    return of


def fill(path):
    path.write_text(path.read_text("utf-8").replace("eigenvalues:", "eigenvalues: [1, 4]"), encoding="utf-8")


def test_what_changed_since_a_kept_file_was_written_is_told_in_every_run(made, tmp_path):
    made("Anna", "Ben")
    fill(tmp_path / SHEET)
    kept = f"kept {SHEET}: there are answers in it"
    assert f"{kept}\n" in made("Anna", "Ben").err
    seeded = EXAM.replace("seed: 1", "seed: 2")
    for _ in range(2):  # the second run is the same as the first one, and the file is as old as it was
        assert f"{kept}, but its numbers have changed since (question 1)\n" in made("Anna", "Ben", exam=seeded).err
    assert f"{kept}\n" in made("Anna", "Ben").err
    other = EXAM.replace("[0, 4]", "[0, 5]")
    assert f"{kept}, but question 2 has changed since\n" in made("Anna", "Ben", exam=other).err
    moved = made("Ben", "Anna").err
    assert f"{kept}, but its numbers have changed since (question 1) and it is variant 2 now\n" in moved


def test_files_of_students_who_are_gone_are_named_and_stay(made, tmp_path):
    first = made("Anna", "Ben")
    assert "left over" not in first.err
    fill(tmp_path / SHEET)
    (tmp_path / "exam-papers" / "answers" / "notes.yaml").write_text("a: 1\n", encoding="utf-8")
    told = made("Ben").err
    assert (
        "left over in exam-papers, of nobody who has a paper now: papers/paper-Anna.html, keys/key-Anna.html, "
        "answers/answers-Anna.yaml (with answers)\n"
    ) in told
    assert (tmp_path / SHEET).exists()
    assert (tmp_path / "exam-papers" / "papers" / "paper-Anna.html").exists()
    assert "left over" not in made("Ben", "Anna").err
