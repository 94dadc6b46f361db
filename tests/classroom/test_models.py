"""A right and a wrong answer to every model of the library are told apart."""

from pathlib import Path

import pytest
import yaml

from solver.classroom import Verdict, mark, read_submission
from solver.problem.library import folder, model_names
from solver.problem.source import Source
from tests.helpers.solved import solution_of

ANSWERS = yaml.safe_load((Path(__file__).parent / "models.yaml").read_text(encoding="utf-8"))
CASES = [
    pytest.param(
        model,
        part,
        answer,
        values,
        id=f"{model}-{part}-{answer}",
        marks=[pytest.mark.xdist_group(model), *([pytest.mark.slow] if place % 3 else [])],
    )
    for place, (model, parts) in enumerate(sorted(ANSWERS.items()))
    for part, answers in parts.items()
    for answer, values in answers.items()
]


def verdict(model, part, answer, value):
    solution = solution_of(folder() / f"{model}.yaml")
    text = yaml.safe_dump({"answers": {part: {answer: value}}})
    sheet = mark(solution, read_submission(Source("answers.yaml", text), solution.problem))
    marked = next(each for each in sheet.parts if each.id == part).answers[answer]
    return marked.verdict, marked.reason


def test_every_model_has_answers():
    assert sorted(ANSWERS) == list(model_names())


@pytest.mark.parametrize(("model", "part", "answer", "values"), CASES)
def test_right_and_wrong_are_told_apart(model, part, answer, values):
    right, why = verdict(model, part, answer, values["right"])
    assert right is Verdict.CORRECT, why
    wrong, why = verdict(model, part, answer, values["wrong"])
    assert wrong is Verdict.WRONG, why
