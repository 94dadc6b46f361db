"""Questions of textbooks and generated ones: solved, judged by other programs, read for their form.

Each is verified, or is unsolved for a reason that is said here. `HUNT_SEED=7 HUNT_TIMES=5` asks others, and more.
"""

import os
from pathlib import Path

import pytest

from tests.helpers.shares import turn
from tests.hunt.form import ugly
from tests.hunt.generated import SHARES, problem
from tests.hunt.solved import Solved, faults, solved

HERE = Path(__file__).parent
TEXTBOOK = sorted((HERE / "textbook").glob("*.yaml"))
SEED, TIMES = int(os.environ.get("HUNT_SEED", "1")), float(os.environ.get("HUNT_TIMES", "0.4"))

UNSOLVED = {
    "poles-impossible": "above 1 the formula",
    "servo-zero-at-origin": "zero at the origin",
    "lqr-not-stabilizable": "not stabilizable",
}
"""Questions of textbooks without an answer, and words of the reason."""

UGLY = {"lqr-1-2": "√(63/2 + 3√265/2) is a sum of two roots"}
"""Answers that are right and are still to be written as a person would."""

REFUSED = (
    "it must be among the poles asked for",
    "not stabilizable",
    "not detectable",
    "transmission zero",
    "a zero at",
    "The poles asked for must contain it",
)
"""Reasons for which a generated question may have no answer: what is drawn may be hidden, or have a zero there."""


def judged(parts: tuple[Solved, ...], reasons: dict[str, str] | None = None) -> list[str]:
    """What is wrong with the answers to these questions, and with their form."""
    said = []
    for one in parts:
        name = f"{one.question.id} ({one.work.method})"
        if not one.verified:
            allowed = [reasons[one.question.id]] if reasons and one.question.id in reasons else []
            allowed = list(REFUSED) if reasons is None else allowed
            if one.work.status.value != "unsolved" or not any(each in one.work.reason for each in allowed):
                said.append(f"{name}: {one.work.status.value}: {one.work.reason}")
            continue
        said += [f"{name}: {fault}" for fault in faults(one)]
        said += [f"{name}: {fault}" for fault in ugly(one) if one.question.id not in UGLY]
    return said


def test_what_the_hunt_found_is_answered():
    assert not judged(solved(HERE / "found.yaml"), {})


@pytest.mark.parametrize("path", [pytest.param(path, id=path.stem, marks=turn(path.stem, 2)) for path in TEXTBOOK])
def test_questions_of_textbooks_are_answered(path):
    assert not judged(solved(path), UNSOLVED)


@pytest.mark.slow
@pytest.mark.parametrize("part", range(4))  # a file has sixty parts at most
def test_generated_questions_are_answered(tmp_path, part):
    path = tmp_path / "generated.yaml"
    path.write_text(problem(SEED, sorted(SHARES)[part::4], TIMES), encoding="utf-8")
    assert not judged(solved(path))


def test_the_same_seed_asks_the_same():
    assert problem(3) == problem(3) != problem(4)
