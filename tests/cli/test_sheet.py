"""`solve sheet` and `solve schema --answers`: what a student writes into, and what an editor checks it by."""

import json

import pytest

PROBLEM = """\
title: A plant
system: {A: [[1, 2], [3, 1]], B: [0, 1]}
find: {a: {task: pole_placement, poles: [-1, -2], marks: 2}}
"""


@pytest.fixture
def problem(tmp_path):
    """A problem in a file."""
    (tmp_path / "problem.yaml").write_text(PROBLEM, encoding="utf-8")
    return "problem.yaml"


def test_a_blank_file_is_marked_as_one_that_answers_nothing(solve, problem, tmp_path):
    (tmp_path / "class").mkdir()
    done = solve("sheet", problem, "-o", "class/blank.yaml")
    assert done.out == "wrote class/blank.yaml; mark it with: solve check problem.yaml class/blank.yaml\n"
    marked = solve("check", "class/blank.yaml")
    assert marked.code == 0
    assert "0 of 2 (not answered)" in marked.out
    assert solve("check", "class/blank.yaml", "--syntax").code == 0


def test_it_is_printed_where_no_file_is_named_and_never_written_over_another(solve, problem, tmp_path):
    assert "problem: problem.yaml\nstudent:\nanswers:\n" in solve("sheet", problem).out
    (tmp_path / "mine.yaml").write_text("mine", encoding="utf-8")
    refused = solve("sheet", problem, "-o", "mine.yaml")
    assert (refused.code, "will not be overwritten" in refused.err) == (2, True)
    assert (tmp_path / "mine.yaml").read_text(encoding="utf-8") == "mine"


def test_it_is_told_in_the_language_asked_for(solve, problem):
    out = solve("sheet", problem, "--language", "de").out
    assert "K:  # eine Matrix, 1×2, zum Beispiel [1, 2]" in out
    assert "Jeder Wert steht hinter seinem Namen" in out


def test_a_problem_at_fault_is_told_with_its_place(solve, tmp_path):
    (tmp_path / "problem.yaml").write_text("find: {a: lqrr}", encoding="utf-8")
    for words in (("sheet", "problem.yaml"), ("schema", "--answers", "problem.yaml")):
        done = solve(*words)
        assert done.code == 2
        assert "problem.yaml:1:" in done.err


def test_the_schema_of_answers_knows_the_problem(solve, problem):
    data = json.loads(solve("schema", "--answers", problem).out)
    assert "K" in json.dumps(data["properties"]["answers"]["properties"]["a"])
    assert "find" not in json.loads(solve("schema", "--answers").out)["properties"]
    assert json.loads(solve("schema", "--override").out)["required"] == ["changes"]
    assert solve("schema", problem).code == 2
