"""Write the files of a new task, filled in so that they run and pass all tests as they are.

    python tools/new_task.py steady_state_error classical        (make task NAME=steady_state_error TOPIC=classical)

As written the task finds the determinant of A. Its files are filled in one after the other; nothing else is touched.
"""

from __future__ import annotations

import keyword
import re
import sys
from collections.abc import Iterator
from pathlib import Path

from solver.tasks import catalogue
from solver.tasks.declarations import topics

ROOT = Path(__file__).parents[1]
NAME = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*")

TOPIC = '''\
"""Questions of @words@."""

from solver.derivation import Topic

TOPIC = Topic(group="Representation and analysis", order=@order@, title="@title@")
'''

TASK = '''\
"""@title@."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from solver.derivation import AnswerName, Answers, Check, Claim, Derivation, Given, Step, Task
from solver.lazy import exact, numeric
from solver.stated.matrices import determinant
from solver.tasks.plant_options import PlantOptions

if TYPE_CHECKING:
    from solver.systems import StateSpace

@name@: Task[StateSpace, PlantOptions] = Task(
    "@name@",
    title="@title@",
    doc="The determinant of A.",
    needs=("A",),
    options=PlantOptions,
    answers=[AnswerName("determinant", r"\\det A", "the determinant")],
)


@@name@.method(source="Strang, Linear Algebra and Its Applications, chapter 4")
def by_recursion(given: Given[StateSpace, PlantOptions]) -> Derivation[Answers]:
    """The determinant by the recursion of Faddeev and LeVerrier."""
    A = given.system.A
    found = exact.determinant(A)
    yield Step("determinant", claims={"determinant": Claim(determinant(A), found, "determinant")}, A=A)
    return Answers(determinant=found)


@@name@.verification("determinant")
def is_that_of_the_matrix(given: Given[StateSpace, PlantOptions], answers: Answers) -> Iterable[Check]:
    """The determinant by elimination, in numbers."""
    yield numeric.check_claim(Claim(determinant(given.system.A), answers["determinant"]), r"$\\det A$")
'''

QUESTION = """\
{% macro question(system, options) %}
Find the determinant of the {{ "matrix" if system.bare else "system matrix" }} $A$.
{% endmacro %}
"""

WORDING = """\
{% macro determinant(v, c) %}
### Determinant
{% if full %}
The recursion of Faddeev and LeVerrier finds the coefficients of the characteristic polynomial from traces, one after
the other; the last of them is the determinant but for its sign. The determinant is the product of the eigenvalues:
it is zero exactly when one of them is, and then the matrix has no inverse.
{% endif %}
{{ claim(c.determinant, "\\\\det A") }}
{% endmacro %}
"""

PROBLEM = """\
# @title@ of a plant with two states.
title: @title@
system:
  A: [[0, 1], [-2, -3]]
find:
  a: @name@
"""

TEST = '''\
"""@title@: steps, answer, corruptions, marking."""

import numpy as np
import pytest

from solver.derivation import Status
from tests.helpers.asking import ask, rejected, system
from tests.helpers.marked import solved, verdict

PLANTS = [[[0, 1], [-2, -3]], [[1, 2], [3, 4]], [[2, 0, 1], [0, 3, 0], [1, 0, 2]]]


@pytest.mark.parametrize("rows", PLANTS)
def test_the_determinant_is_numpys(rows):
    result = ask("@name@", system(rows))
    assert result.status is Status.VERIFIED
    assert [step.kind for step in result.steps] == ["determinant"]
    assert float(result.answers["determinant"]) == pytest.approx(np.linalg.det(np.array(rows)))


@pytest.mark.parametrize("rows", PLANTS)
def test_another_value_is_rejected(rows):
    found = ask("@name@", system(rows)).answers["determinant"]
    assert not rejected("@name@", system(rows), {"determinant": found})
    for wrong in (-found, found + 1, found / 2):
        assert rejected("@name@", system(rows), {"determinant": wrong})


def test_a_student_may_write_it_in_any_form():
    problem = solved("title: T\\nsystem: {A: [[0, 1], [-2, -3]]}\\nfind: {a: @name@}\\n")
    assert verdict(problem, "a", "determinant", "4/2").verdict == "correct"
    assert verdict(problem, "a", "determinant", "-2").verdict == "wrong"
'''


class Refused(Exception):  # noqa: N818 - a message for the terminal
    """The name of a task or of its topic does not do."""


def files(root: Path, name: str, topic: str) -> Iterator[tuple[Path, str]]:
    """Yield the files of a new task with their texts."""
    words = {"@name@": name, "@title@": _title(name)}
    folder = root / "solver" / "tasks" / topic
    if not folder.is_dir():
        order = 10 + max(each.order for each in topics(root / "solver" / "tasks").values())
        about = {"@words@": topic.replace("_", " "), "@order@": str(order), "@title@": _title(topic)}
        yield folder / "__init__.py", _filled(TOPIC, about)
    wording = root / "templates" / "wording" / name
    yield folder / f"{name}.py", _filled(TASK, words)
    yield wording / "question.md.jinja", QUESTION
    yield wording / f"{name}.md.jinja", WORDING
    yield root / "problems" / "examples" / f"{name.replace('_', '-')}.yaml", _filled(PROBLEM, words)
    yield root / "tests" / "tasks" / f"test_{name}.py", _filled(TEST, words)


def _title(name: str) -> str:
    return name.replace("_", " ").capitalize()


def _filled(text: str, words: dict[str, str]) -> str:
    for word, value in words.items():
        text = text.replace(word, value)
    return text


def new_task(root: Path, name: str, topic: str) -> list[Path]:
    """Write the files and return their paths; raises Refused."""
    for word in (name, topic):
        if not NAME.fullmatch(word) or keyword.iskeyword(word):
            raise Refused(f"'{word}' does not do as a name: write it in small letters with underscores, root_locus")
    if name in catalogue():
        raise Refused(f"there is a task {name} already")
    written = []
    for path, text in files(root, name, topic):
        if path.exists():
            raise Refused(f"{path.relative_to(root)} is there already; take another name")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        written.append(path)
    return written


def main(arguments: list[str]) -> int:
    """Write the files and say which; 2 where a name does not do."""
    try:
        name, topic = arguments
        written = new_task(ROOT, name, topic)
    except ValueError:
        print("Name the task and its topic: make task NAME=steady_state_error TOPIC=classical", file=sys.stderr)
        return 2
    except Refused as reason:
        print(reason, file=sys.stderr)
        return 2
    print("\n".join(f"wrote {path.relative_to(ROOT)}" for path in written))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
