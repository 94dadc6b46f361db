"""Errors planted in the installed templates, for the test that a page with a false display is not verified.

`python -m tests.helpers.planting` prints what becomes of each.
"""

import json
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from solver.document.model import Document, Presentation
from solver.document.works import document_of
from solver.engine import Solution, solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.resources import root
from solver.tasks import catalogue
from tests.helpers.planted import PLANTED, PROBLEMS


@cache
def solution(name: str) -> Solution:
    """The solution of one of the problems."""
    text = json.dumps({"title": "T", **PROBLEMS[name]}, ensure_ascii=False)
    return solve_problem(read_problem(Source("q.yaml", text), catalogue()))


def told(name: str, template: str = "", right: str = "", wrong: str = "", notation: str = "course") -> Document:
    """The document of a problem at the level tutor, with one text of a template replaced by another."""
    with TemporaryDirectory() as folder:
        if template:
            file = Path(folder) / f"{template}.md.jinja"
            file.parent.mkdir(parents=True, exist_ok=True)
            text = (root("templates") / "wording" / f"{template}.md.jinja").read_text(encoding="utf-8")
            if right not in text:
                raise ValueError(f"{right!r} does not stand in {template}")
            file.write_text(text.replace(right, wrong, 1), encoding="utf-8")
        return document_of(solution(name), Presentation("tutor", Path(folder), notation=notation))


def main() -> None:
    """Print the table."""
    for place, planted in PLANTED.items():
        document = told(*planted)
        failed = [part.id for part in document.parts if part.status == "failed"]
        faults = [part.fault for part in document.parts if part.fault]
        print(f"{place:45} {'failed' if failed else 'NOT SEEN'} {faults[:1] or ''}")


if __name__ == "__main__":
    main()
