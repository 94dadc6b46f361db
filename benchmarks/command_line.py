"""The command line: what help and completion cost, a cold solution, a warm one, and one written again by --watch."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from importlib import import_module
from math import log
from pathlib import Path
from time import perf_counter, sleep
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

COMPLETE = "import os; os.environ.update(_SOLVE_COMPLETE='bash_complete', COMP_WORDS='solve new pole_pl', "
COMPLETE += "COMP_CWORD='2'); from solver.cli import main; main([])"

CHANGES = 8
"""How often a file is changed under --watch."""

IMPORT = "from time import process_time as t; start = t(); import sympy; print(1000 * (t() - start))"


def companion_text(roots: Sequence[int]) -> str:
    """The companion matrix of (x + root)… of some roots as YAML."""
    low, n = [1], len(roots)
    for root in roots:  # coefficients of the product, the constant term first
        low = [a + root * b for a, b in zip([0, *low], [*low, 0], strict=True)]
    rows = [[int(j == i + 1) for j in range(n)] for i in range(n - 1)]
    return str([*rows, [-c for c in low[:-1]]])


def problem_text(n: int, first: int = 1) -> str:
    """A problem file that asks for e^{At} of order n, with the eigenvalues −first, −first − 1, …."""
    return text_of(range(first, first + n))


def text_of(roots: Sequence[int]) -> str:
    """A problem file that asks for e^{At} of a matrix whose eigenvalues are these numbers with a minus."""
    return PROBLEM.format(A=companion_text(roots))


def rows() -> Iterator[Row | Failure]:
    """Return the lines of the table."""
    for words in (["--help"], ["tasks"]):
        yield from _guarded(f"solve {words[0]}: CPU above bare Python", lambda words=words: _startup(words))
    yield from _guarded("completion of a task's name: CPU", _completion)
    yield from _guarded("cold solve, n = 3, HTML, checks", _cold)
    yield from _guarded("warm solve + check + HTML, n = 3", _warm)
    yield from _guarded("--watch: from a change to the page, wall", _watch)


def _guarded(name: str, measure: Any) -> Iterator[Row | Failure]:
    """Yield what is measured, or why it could not be: one missing part must not lose the other lines."""
    try:
        yield from measure()
    except (RuntimeError, ImportError, AttributeError, OSError) as reason:
        yield Failure(name, str(reason))


def _startup(words: list[str]) -> Iterator[Row]:
    output(["-c", NO_SYMPY.format(argv=["solve", *words])])
    (_, bare), (_, cpu) = processes(["-c", "pass"], ["-m", "solver", *words])
    yield Row(f"solve {words[0]}: CPU above bare Python", cpu - bare, at_most=150)


def _completion() -> Iterator[Row]:
    ((_, cpu),) = processes(["-c", COMPLETE])
    yield Row("completion of a task's name: CPU", cpu, at_most=150)


def _cold() -> Iterator[Row]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "problem.yaml"
        path.write_text(problem_text(3), encoding="utf-8")
        solve = ["-m", "solver", str(path), "-o", str(Path(folder) / "page.html")]
        (wall, _), (sympy_wall, _) = processes(solve, ["-c", "import sympy"])
    yield Row("cold solve, n = 3, HTML, checks", wall, "python -c 'import sympy'", sympy_wall, 1 / 2.5)


def _watch() -> Iterator[Row]:
    """Yield the least time from writing a file, with other numbers, to its page; the looks at it come in between."""
    with tempfile.TemporaryDirectory() as folder:
        path, page = Path(folder) / "problem.yaml", Path(folder) / "page.html"
        path.write_text(problem_text(3), encoding="utf-8")
        command = [sys.executable, "-m", "solver", str(path), "--watch", "-o", str(page)]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            try:
                _until(lambda: page.exists() or process.poll() is not None)
                times = [_seconds_to(page, path, problem_text(3, first)) for first in range(2, 2 + CHANGES)]
            finally:
                process.terminate()
    yield Row("--watch: from a change to the page, wall", 1000 * min(times), at_most=300)


def _seconds_to(page: Path, path: Path, text: str) -> float:
    before = page.stat().st_mtime_ns  # raises FileNotFoundError where the command has ended
    sleep(0.5)
    start = perf_counter()
    path.write_text(text, encoding="utf-8")
    _until(lambda: page.stat().st_mtime_ns != before)
    return perf_counter() - start


def _until(done: Callable[[], bool], seconds: float = 60.0) -> None:
    end = perf_counter() + seconds
    while not done():
        if perf_counter() > end:
            raise RuntimeError("nothing was written")
        sleep(0.002)


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
