"""The command line: what `solve --help` costs, a cold solution, and a warm one with checks and page."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from importlib import import_module
from math import log
from pathlib import Path
from typing import Any

from benchmarks.timing import Failure, Row, milliseconds_of_each, output, processes

PROBLEM = """\
title: Benchmark
system:
  A: {A}
find:
  a: {{task: state_transition_matrix, method: laplace}}
"""

NO_SYMPY = "import sys; sys.argv = {argv}; from solver.cli import main\ntry:\n main()\nexcept SystemExit:\n pass\n"
NO_SYMPY += "assert 'sympy' not in sys.modules, 'sympy was imported'"

WARMING = 5
"""Problems after which a process is warm: Python's bytecode has adapted, the shapes of formulas are known."""

WARM = "from benchmarks.command_line import milliseconds_of_unseen; print(milliseconds_of_unseen({n}, {count}))"

IMPORT = "from time import process_time as t; start = t(); import sympy; print(1000 * (t() - start))"


def companion_text(n: int, first: int = 1) -> str:
    """The companion matrix of (x + first)(x + first + 1)… of degree n as YAML."""
    low = [1]
    for root in range(first, first + n):  # coefficients of the product, the constant term first
        low = [a + root * b for a, b in zip([0, *low], [*low, 0], strict=True)]
    rows = [[int(j == i + 1) for j in range(n)] for i in range(n - 1)]
    return str([*rows, [-c for c in low[:-1]]])


def problem_text(n: int, first: int = 1) -> str:
    """A problem file that asks for e^{At} of order n."""
    return PROBLEM.format(A=companion_text(n, first))


def rows() -> Iterator[Row | Failure]:
    """Return the lines of the table."""
    for words in (["--help"], ["tasks"]):
        yield from _guarded(f"solve {words[0]}: CPU above bare Python", lambda words=words: _startup(words))
    yield from _guarded("cold solve, n = 3, HTML, checks", _cold)
    yield from _guarded("warm solve + check + HTML, n = 3", _warm)


def _guarded(name: str, measure: Any) -> Iterator[Row | Failure]:
    """Yield what is measured, or why it could not be: one missing part must not lose the other lines."""
    try:
        yield from measure()
    except (RuntimeError, ImportError, AttributeError) as reason:
        yield Failure(name, str(reason))


def _startup(words: list[str]) -> Iterator[Row]:
    output(["-c", NO_SYMPY.format(argv=["solve", *words])])
    (_, bare), (_, cpu) = processes(["-c", "pass"], ["-m", "solver", *words])
    yield Row(f"solve {words[0]}: CPU above bare Python", cpu - bare, at_most=150)


def _cold() -> Iterator[Row]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "problem.yaml"
        path.write_text(problem_text(3), encoding="utf-8")
        solve = ["-m", "solver", str(path), "-o", str(Path(folder) / "page.html")]
        (wall, _), (sympy_wall, _) = processes(solve, ["-c", "import sympy"])
    yield Row("cold solve, n = 3, HTML, checks", wall, "python -c 'import sympy'", sympy_wall, 1 / 2.5)


def _warm() -> Iterator[Row]:
    """Yield the times of problems never seen before in a process that has solved others.

    `import sympy` beside them tells how quick the machine is at the time.
    """
    works = [WARM.format(n=3, count=8), WARM.format(n=6, count=4), IMPORT]
    turns = [[float(output(["-c", work])) for work in works] for _ in range(12)]
    three, six, sympy = map(min, zip(*turns, strict=True))
    yield Row("warm solve + check + HTML, n = 3", three, "import sympy", sympy, at_most=30)
    yield Row(f"warm, n = 6 (growth n^{log(six / three, 2):.1f})", six, at_most=three * 2**3)


def milliseconds_of_unseen(n: int, count: int) -> float:
    """The median time of problems of order n that this process has not seen, after some others of that order."""
    package = import_module("solver")  # only here, so that the rows above do not pay for it
    firsts = [*range(count + 1, count + 1 + WARMING), *range(1, count + 1)]
    works = [lambda first=first: package.solve(problem_text(n, first)).html() for first in firsts]
    return milliseconds_of_each(works, WARMING)
