"""Where answer files may lead: to problems and exams below their folder or the current one, and nowhere else."""

import os

import pytest

from tests.helpers.small_problems import GOOD
from tests.papers.exams import EXAM, write_exam

SECRET = "nobody but the owner reads this"
ANSWERS = "answers: {a: {characteristic_polynomial: 1}}\n"


@pytest.fixture
def course(tmp_path, monkeypatch):
    """A course with a folder of answers, beside what is none of a student's business."""
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "problem.yaml").write_text(f"secret: {SECRET}\n", encoding="utf-8")
    here = tmp_path / "course"
    (here / "answers").mkdir(parents=True)
    (here / "good.yaml").write_text(GOOD, encoding="utf-8")
    return here


def submit(course, head, name="anna.yaml", rest=ANSWERS):
    path = course / "answers" / name
    path.write_text(f"{head}\n{rest}", encoding="utf-8")
    return path


@pytest.mark.parametrize(
    "named",
    [
        "../../other/problem.yaml",
        "../../course/../other/problem.yaml",
        "link.yaml",
        "linked/problem.yaml",
        "chain.yaml",
    ],
)
def test_what_leads_out_is_told_and_not_read(solve, course, monkeypatch, named):
    monkeypatch.chdir(course)
    (course / "answers" / "link.yaml").symlink_to("../../other/problem.yaml")
    (course / "chain.yaml").symlink_to("../other/problem.yaml")
    (course / "answers" / "chain.yaml").symlink_to("../chain.yaml")
    (course / "answers" / "linked").symlink_to("../../other")
    submit(course, f"problem: {named}")
    done = solve("check", "answers/anna.yaml")
    assert done.code == 2
    assert "answers/anna.yaml:1:10: error:" in done.err
    assert "is not followed: it leads out of the folder of the answers and out of the current one" in done.err
    assert "name it on the command line: solve check PROBLEM ANSWERS" in done.err
    assert SECRET not in done.out + done.err


@pytest.mark.parametrize(
    ("named", "why"),
    [
        ("/etc/passwd", "the file of a problem ends in .yaml"),
        ("/etc/../etc/hosts.yaml", "it does not begin at the folder of this file"),
        ("//host/share/x.yaml", "it does not begin at the folder of this file"),
        (r"\\\\host\\share\\x.yaml", "it does not begin at the folder of this file"),
        (r"C:\\x.yaml", "it does not begin at the folder of this file"),
        ("C:x.yaml", "it does not begin at the folder of this file"),
        ("-", "the file of a problem ends in .yaml"),
        (".ssh/config", "the file of a problem ends in .yaml"),
        (r"good.yaml\0.yaml", "an escape makes the invisible character"),
        ("a/" * 3000 + "x.yaml", "cannot be"),
        ("circle.yaml", "cannot be"),
    ],
)
def test_whole_paths_and_other_files_are_not_followed(solve, course, monkeypatch, named, why):
    monkeypatch.chdir(course / "answers")
    (course / "answers" / "circle.yaml").symlink_to("circle.yaml")
    submit(course, f'problem: "{named}"')
    done = solve("check", "anna.yaml")
    assert done.code == 2
    assert why in done.err
    assert "Traceback" not in done.err


def test_devices_and_pipes_are_not_opened(solve, course, monkeypatch):
    monkeypatch.chdir(course)
    os.mkfifo(course / "pipe.yaml")
    submit(course, "problem: ../pipe.yaml")
    done = solve("check", "answers/anna.yaml")
    assert done.code == 2
    assert "pipe.yaml: error: it is not a regular file" in done.err


def test_problems_beside_below_and_in_the_current_folder_are_followed(solve, course, monkeypatch):
    monkeypatch.chdir(course)
    (course / "answers" / "sets").mkdir()
    for folder in (course / "answers", course / "answers" / "sets"):
        (folder / "good.yaml").write_text(GOOD, encoding="utf-8")
    for name in ("good.yaml", "sets/good.yaml", "../good.yaml", "../answers/good.yaml"):
        submit(course, f"problem: {name}")
        assert solve("check", "answers/anna.yaml").code == 0, name


def test_one_who_stands_elsewhere_names_the_problem(solve, course, monkeypatch):
    monkeypatch.chdir(course.parent / "other")
    path = submit(course, "problem: ../good.yaml")
    assert "is not followed" in solve("check", path).err
    assert solve("check", course / "good.yaml", path).code == 0


def test_nobody_else_is_kept_from_being_marked(solve, course, monkeypatch):
    monkeypatch.chdir(course)
    submit(course, "problem: ../good.yaml", "anna.yaml")
    submit(course, "problem: ../../other/problem.yaml", "ben.yaml")
    (course / "answers" / "cleo.yaml").symlink_to("../../other/problem.yaml")
    done = solve("check", "answers", "--csv", "marks.csv")
    assert done.code == 2
    assert "answers/cleo.yaml: error: it is a link that leads out of its folder" in done.err
    assert "ben.yaml,," in (course / "marks.csv").read_text("utf-8")
    assert SECRET not in done.out + done.err


QUESTION = "exam: X\nquestions: [{problem: good.yaml, marks: 3}]\n"


def test_the_exam_that_most_files_name_is_followed(solve, course, monkeypatch):
    monkeypatch.chdir(course)
    (course / "exam.yaml").write_text(QUESTION, encoding="utf-8")
    (course / "answers" / "mine.yaml.txt").write_text(QUESTION, encoding="utf-8")
    (course / "answers" / "sets").mkdir()
    (course / "answers" / "sets" / "mine.yaml").write_text(QUESTION.replace("good", "../../good"), encoding="utf-8")
    rest = "answers: {1: {a: {characteristic_polynomial: 1}}}\n"
    submit(course, "exam: sets/mine.yaml", "anna.yaml", rest)
    submit(course, "exam: ../exam.yaml", "ben.yaml", rest)
    submit(course, "exam: ../exam.yaml", "cleo.yaml", rest)
    submit(course, "exam: ../../other/problem.yaml", "dora.yaml", rest)
    done = solve("check", "answers", "--jobs", 1)
    assert done.code == 2
    assert "anna.yaml:1:7: error: it names another exam than most files, which answer exam.yaml" in done.err
    assert "dora.yaml:1:7: error: '../../other/problem.yaml' is not followed" in done.err
    assert "marked 2 of 4 files" in done.err
    named = solve("check", "exam.yaml", "answers", "--jobs", 1)
    assert "marked 4 of 4 files" in named.err


def test_what_solve_exam_writes_is_found_again(solve, tmp_path):
    write_exam(tmp_path, EXAM.replace("marks: 10", "marks: 10, page_break: no"))
    assert solve("exam", "exam.yaml", "--jobs", 1).code == 0
    sheet = tmp_path / "exam-papers" / "answers" / "answers-1.yaml"
    text = sheet.read_text("utf-8")
    assert "../../exam.yaml" in text
    sheet.write_text(text.replace("verdict:", "verdict: unstable", 1), encoding="utf-8")
    (tmp_path / "exam-papers" / "answers" / "answers-2.yaml").unlink()
    done = solve("check", "exam-papers/answers", "--jobs", 1)
    assert "marked 1 of 1 files" in done.err


@pytest.mark.parametrize("address", ["../other/x.png", "out.png", "/etc/x.png"])
def test_pictures_of_a_problem_in_an_exam_stay_below_its_folder(solve, course, monkeypatch, address):
    monkeypatch.chdir(course)
    (course.parent / "other" / "x.png").write_bytes(b"\x89PNG\r\n\x1a\n" + SECRET.encode())
    (course / "out.png").symlink_to("../other/x.png")
    inline = f"""exam: X
questions:
  - problem:
      statement: "![x]({address})"
      system: {{matrix: [[1, 2], [3, 4]]}}
      find: {{a: characteristic_polynomial}}
"""
    (course / "exam.yaml").write_text(inline, encoding="utf-8")
    done = solve("exam", "exam.yaml")
    assert done.code == 2
    assert "folder of the problem" in done.err or "no such file" in done.err
