"""Few problems that ask every task by every method, and with every choice, that any problem asks for."""

from __future__ import annotations

from pathlib import Path

from solver.problem.files import load
from solver.problem.reader import read_problem
from solver.resources import root
from solver.tasks import catalogue


def covering() -> list[Path]:
    """Problems in problems/ that together ask all that is asked there: small ones first, always the same ones."""
    files = sorted(path for path in root("problems").rglob("*.yaml") if path.parent.name != "exams")
    asked = {path: _asked(path) for path in files if ".answers" not in path.name}
    left = set().union(*asked.values())
    chosen: list[Path] = []
    while left:
        best = max(asked, key=lambda path: (len(asked[path] & left) / (1 + 0.3 * len(asked[path])), path.stem))
        chosen.append(best)
        left -= asked[best]
    return chosen


def _asked(path: Path) -> frozenset[tuple[str, ...]]:
    """The tasks with their methods, and with what was chosen: a form, a part, a kind."""
    problem = read_problem(load(path), catalogue())
    methods = {(part.task, method) for part in problem.parts for method in part.methods}
    chosen = {(part.task, name, str(value)) for part in problem.parts for name, value in part.options.items()
              if isinstance(value, str | bool)}  # fmt: skip
    return frozenset(methods | chosen)
