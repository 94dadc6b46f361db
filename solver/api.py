"""The Python interface: `solver.solve(path_or_text)`.

>>> import solver
>>> solution = solver.solve("problems/course/ch1/ch1-ex02.yaml")
>>> solution.status, solution.answers["a"]["Phi"]
>>> Path("page.html").write_text(solution.html(detail="tutor"), encoding="utf-8")

In a notebook the solution shows itself as a page.
"""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from solver.engine import Solution, solve_problem
from solver.problem.files import load
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.render.view import SolutionView, view_of
from solver.render.wording import Wording
from solver.tasks import catalogue

if TYPE_CHECKING:
    from solver.derivation import Answers, PartResult, Status


@dataclass(frozen=True)
class WorkedSolution:
    """A solved problem: exact answers, checks, steps, and the pages made of them."""

    solution: Solution

    @property
    def status(self) -> Status:
        """The worst status of the parts."""
        return self.solution.status

    @property
    def parts(self) -> tuple[PartResult, ...]:
        """The results, one for each part and method, in the order asked."""
        return self.solution.parts

    @property
    def answers(self) -> dict[str, Answers]:
        """The answers of each part by its id, as sympy objects, by the part's first method."""
        found: dict[str, Answers] = {}
        for part in self.parts:
            found.setdefault(part.id, part.answers)
        return found

    def view(self, detail: str = "full", templates: str | Path | None = None) -> SolutionView:
        """Return the solution in words, at the level "brief", "full" or "tutor"; `templates` come before our own."""
        return view_of(self.solution, Wording.of(self.solution.display, detail, Path(templates) if templates else None))

    def html(self, detail: str = "full", templates: str | Path | None = None) -> str:
        """Return a whole page that needs nothing from outside."""
        from solver.render.page import render_page  # noqa: PLC0415 - each format imports its own libraries

        name = self.solution.problem.name
        folder = Path(templates) if templates else None
        return render_page(self.view(detail, templates), name=name, detail=detail, templates=folder)

    def latex(self, detail: str = "full", templates: str | Path | None = None) -> str:
        """Return a whole LaTeX document."""
        from solver.render.latex_document import latex_document  # noqa: PLC0415

        return latex_document(self.view(detail, templates), Path(templates) if templates else None)

    def markdown(self, detail: str = "full", templates: str | Path | None = None) -> str:
        """Return Markdown with `$math$`."""
        from solver.render.markdown import markdown_of  # noqa: PLC0415

        return markdown_of(self.view(detail, templates))

    def json(self) -> str:
        """Return the result as JSON."""
        from solver.render.data import render_json  # noqa: PLC0415

        return render_json(self.solution)

    def _repr_html_(self) -> str:
        """The page in a frame of its own, so that its style and the notebook's do not mix."""
        frame = 'style="width: 100%; height: 40rem; border: 0" sandbox=""'
        return f'<iframe {frame} title="Worked solution" srcdoc="{escape(self.html())}"></iframe>'

    def _repr_markdown_(self) -> str:
        return self.markdown()

    def _repr_latex_(self) -> str:
        """The answers as displayed formulas."""
        shown = [answer for part in self.view("brief").parts for answer in part.answers]
        return "\n".join(f"$$\n{answer.symbol} = {answer.tex}\n$$" for answer in shown)

    def __repr__(self) -> str:
        return f"<worked solution of {self.solution.problem.title!r}: {self.status}>"


def solve(problem: str | Path, **limits: Any) -> WorkedSolution:
    """Solve a problem given as the path of a YAML file, or as YAML text (any text of more than one line).

    With `seconds` or `megabytes` (see `solver.limits.Limits`) every part is solved in a child process that is ended at
    the limit. Raises `solver.problem.source.InputError`, all errors with their places, if the input is at fault.
    """
    is_text = isinstance(problem, str) and "\n" in problem
    source = Source("<text>", str(problem)) if is_text else load(problem)
    read = read_problem(source, catalogue())
    if not limits:
        return WorkedSolution(solve_problem(read))
    from solver.limits import Limits, in_child  # noqa: PLC0415 - most uses need no child process

    return WorkedSolution(solve_problem(read, in_child(Limits(**limits))))
