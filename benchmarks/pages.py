"""A page with four figures (Bode, Nyquist, root locus, step response) beyond the solve: words, displays, HTML."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any

from benchmarks.command_line import IMPORT, WARMING
from benchmarks.timing import Failure, Row, milliseconds_of_each, output

PROBLEM = """\
title: A loop in four figures
system: {{transfer_function: {gain}/(s(s + {first})(s + {second}))}}
find:
  a: bode
  b: nyquist
  c: root_locus
  d: {{task: step_specifications, method: response, controller: 1, feedback: unity}}
"""
WARM = "from benchmarks.pages import warm; print(warm({count}))"
COLD = "from benchmarks.pages import cold; print(cold())"
TURNS, COUNT = 4, 6
FIGURES = 4


def problem_text(number: int) -> str:
    """A stable loop of type 1; another one for each number."""
    return PROBLEM.format(gain=2 + 3 * number, first=1 + number, second=5 + number)


def page_of(number: int) -> Callable[[], str]:
    """Return what makes the page of a loop that is solved."""
    reader, source, tasks, engine, works, model = (
        import_module(f"solver.{each}")
        for each in ("problem.reader", "problem.source", "tasks", "engine", "document.works", "document.model")
    )  # only here, so that a cold process pays for what it needs
    problem = reader.read_problem(source.Source("loop.yaml", problem_text(number)), tasks.catalogue())
    solution = engine.solve_problem(problem)

    def page() -> str:
        made: Any = works.document_of(solution, model.Presentation("full"), "loop").html()
        if made.count("<figure") != FIGURES:
            raise RuntimeError("the page has not its four figures")
        return str(made)

    return page


def warm(count: int) -> float:
    """The median time of pages that this process has not seen, after some others; loops are solved before."""
    return milliseconds_of_each([page_of(number) for number in range(1, WARMING + count + 1)], WARMING)


def cold() -> float:
    """The time of the first page of a process, with the import of what draws; the loop is solved before."""
    return milliseconds_of_each([page_of(1)], 0)


def rows() -> Iterator[Row | Failure]:
    """Return the lines of the table; `import sympy` beside them tells how quick the machine is at the time."""
    try:
        works = [WARM.format(count=COUNT), COLD, IMPORT]
        turns = [[float(output(["-c", work])) for work in works] for _ in range(TURNS)]
    except RuntimeError as reason:
        yield Failure("a page with four figures", str(reason))
        return
    quick, first, sympy = map(min, zip(*turns, strict=True))
    yield Row("a page with four figures, warm", quick, "import sympy", sympy, at_most=250)
    yield Row("a page with four figures, cold", first, "import sympy", sympy, at_most=1500)
