"""The kinds of system that the user guide shows are read and brought to state equations."""

import re

from solver.derivation import Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue
from tests.helpers.copies import PROJECT


def test_the_guides_systems_have_state_equations():
    guide = (PROJECT / "docs" / "user-guide.md").read_text(encoding="utf-8")
    (block,) = (
        found for found in re.findall(r"^```yaml\n(.*?)^```$", guide, re.MULTILINE | re.DOTALL) if "circuit:" in found
    )
    systems = block.split("---\n")
    kinds = ("equations", "lagrangian", "circuit", "model")
    assert [next(key for key in kinds if f"{key}:" in text) for text in systems] == list(kinds)
    for text in systems:
        solution = solve_problem(read_problem(Source("<guide>", text + "find: {a: state_space_model}\n"), catalogue()))
        assert solution.status is Status.VERIFIED
