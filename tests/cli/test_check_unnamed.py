"""Answer files that name no exam, or none that is found or followed: told once for all, with the way to call it."""

import pytest

ANSWERS = "student: S\nanswers: {1: {a: {eigenvalues: [1, 4]}}}\n"


@pytest.fixture
def hand_in(tmp_path):
    """Write answer files that begin with some lines."""

    def of(*heads):
        (tmp_path / "in").mkdir()
        for number, head in enumerate(heads):
            (tmp_path / "in" / f"{number}.yaml").write_text(head + ANSWERS, encoding="utf-8")

    return of


def test_what_is_the_same_in_all_files_is_told_once(solve, hand_in):
    hand_in(*["exam: ../../exam.yaml\n"] * 3, *["variant: 1\n"] * 6, "exam: exam.txt\n")
    done = solve("check", "in")
    assert done.code == 2
    assert done.err.count("error:") == 3
    assert "in/0.yaml:1:7: error: '../../exam.yaml' is not followed" in done.err
    assert "solve check EXAM ANSWERS" in done.err
    assert "the same in 2 more of the files: in/1.yaml, in/2.yaml\n" in done.err
    assert "in/3.yaml: error: it names no problem; call solve check PROBLEM ANSWERS, or EXAM for an exam" in done.err
    assert "the same in 5 more of the files: in/4.yaml, in/5.yaml, in/6.yaml, …\n" in done.err
    assert "in/9.yaml:1:7: error: 'exam.txt' is not followed" in done.err


def test_a_problem_that_is_not_found_or_at_fault_is_told_once(solve, hand_in, tmp_path):
    hand_in(*[""] * 3)
    done = solve("check", "exma.yaml", "in")
    assert (done.code, done.err.count("error:")) == (2, 1)
    assert "exma.yaml: error: there is no such file" in done.err
    assert "needs review: in/0.yaml, in/1.yaml, in/2.yaml" in done.out + done.err
    (tmp_path / "bad.yaml").write_text("find: 1\n", encoding="utf-8")
    once, all_three = solve("check", "bad.yaml", "in/0.yaml"), solve("check", "bad.yaml", "in")
    assert all_three.code == 2
    assert all_three.err.count("error:") == once.err.count("error:") > 0


def test_an_exam_that_is_not_found_is_told_where_it_is_named(solve, hand_in):
    hand_in(*["# mine\nexam: ../exam.yaml\n"] * 3)
    done = solve("check", "in")
    assert done.code == 2
    assert done.err.count("error:") == 1
    assert "in/0.yaml:2:7: error: the exam 'exam.yaml': there is no such file" in done.err
    assert "name it on the command line: solve check EXAM ANSWERS; 2 more of the files name it" in done.err
