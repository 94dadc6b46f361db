"""Blank answer files: nothing is answered in them, all that is asked can be filled in, and nothing is given away."""

import json
import re

import pytest
import sympy as sp

from solver.classroom import read_submission
from solver.classroom.blank import blank_answers
from solver.classroom.examples import EXPRESSIONS, FREE_MATRIX, example_of
from solver.classroom.marking import Marker
from solver.problem.asked import asked_of
from solver.problem.source import Source
from solver.problem.yaml_tree import parse_yaml
from solver.tasks import catalogue
from tests.helpers.marked import marked, solved
from tests.helpers.solved import EXAMPLES, by_problem, solution_of

QUICK = EXAMPLES[::12]
EXAMPLE = re.compile(r"(?m)^(    \w+:) *# .*, for example (.*)$")
PLANT = "system: {A: [[1, 2], [3, 1]], B: [0, 1], C: [1, 3]}\n"


def lines_of(text):
    """The lines of a blank file that name an answer, by the name."""
    return {line.split(":")[0].strip(): line for line in text.splitlines() if re.match(r"    \w+:", line)}


@pytest.mark.parametrize(**by_problem(EXAMPLES, QUICK))
def test_a_blank_file_answers_nothing_and_names_all_that_is_asked(path):
    solution = solution_of(path)
    text = blank_answers(solution, "it's here.yaml")
    submission = read_submission(Source("blank.yaml", text), solution.problem)
    assert (submission.student, submission.strange) == ("", ())
    assert not any(submission.answers.values())
    root = parse_yaml(Source("blank.yaml", text))
    assert root["problem"].text == "it's here.yaml"
    for part in solution.problem.parts:
        assert tuple(root["answers"][part.id].entries) == asked_of(part, catalogue()[part.task])


@pytest.mark.parametrize(**by_problem(EXAMPLES, QUICK))
def test_the_examples_of_the_notation_are_read_and_are_not_the_answer(path):
    solution = solution_of(path)
    text, count = EXAMPLE.subn(lambda found: f"{found[1]} {json.dumps(found[2])}", blank_answers(solution))
    submission = read_submission(Source("filled.yaml", text), solution.problem)
    assert sum(map(len, submission.answers.values())) == count
    marker = Marker(solution, submission)
    assert not any(marker.unread.values())
    for part, values in marker.values.items():
        for name, read in values.items():
            assert read.value != marker.ours(part)[name]


def test_sizes_are_told_where_the_question_leaves_no_choice():
    find = "find: {a: {task: pole_placement, poles: [-1, -2]}, b: fundamental_subspaces, c: eigenstructure}\n"
    lines = lines_of(blank_answers(solved(PLANT + find)))
    assert lines["K"] == "    K:  # a matrix, 1×2, for example [1, 2]"
    for name in ("null_space", "right_eigenvectors"):
        assert lines[name].endswith(f"# a matrix, for example {FREE_MATRIX}")
    assert lines["eigenvalues"].endswith("# a list, for example [-9, 7 ± 5j]")


def test_whether_there_is_an_answer_is_not_told():
    question = "find: {{a: {{task: model_matching, target: '{}'}}}}\n"
    feasible, infeasible = (
        lines_of(blank_answers(solved(PLANT + question.format(target))))
        for target in ("(3s - 1)/(s^2 + 6s + 13)", "(s + 5)/(s^2 + 6s + 13)")
    )
    assert feasible == infeasible


@pytest.mark.parametrize(("variable", "which"), [(name, i) for name in EXPRESSIONS for i in (0, 1)])
def test_an_example_that_is_the_answer_gives_way_to_another(variable, which):
    texts, values = zip(*EXPRESSIONS[variable], strict=True)
    assert example_of(values[which]) == texts[1 - which if which == 0 else 0]


def test_a_matrix_that_is_the_example_gives_way_to_another():
    assert example_of(sp.ImmutableMatrix([[1, 2]]), sized=True) == "[2, 3]"
    assert example_of(sp.ImmutableMatrix([1, 3]), sized=True) == "[[1], [2]]"
    assert example_of([sp.Integer(-9), 7 + 5 * sp.I, 7 - 5 * sp.I]) == "[-11, 13/2]"


def test_texts_of_the_problem_cannot_leave_their_comment():
    find = 'find: {\'1\': {task: eigenstructure, prompt: "Find\\nall: [\\nanswers: {a: 1}"}}\ntitle: "A\\n b: 1"\n'
    text = blank_answers(solved(PLANT + find))
    assert "# A b: 1" in text
    assert marked(PLANT + find, text)["1"].marks == 0


def test_equations_and_counts_have_examples_of_their_own():
    system = "system: {lagrangian: {coordinates: [theta], kinetic: theta'^2/2, potential: -cos(theta)}}\n"
    lines = lines_of(blank_answers(solved(system + "find: {a: equations_of_motion}\n")))
    assert lines["equations"] == "    equations:  # a list, for example [17 theta'' + 23 theta = 0]"
    find = "find: {a: {task: steady_state_error, feedback: unity, answers: [system_type]}}\n"
    lines = lines_of(blank_answers(solved('system: {transfer_function: "1/(s(s + 1))"}\n' + find)))
    assert lines["system_type"] == "    system_type:  # a whole number, for example 11"
