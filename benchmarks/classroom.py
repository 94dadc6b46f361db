"""A class of sixty: one problem of eight parts, an answer file a student, marked as data and as sheets."""

from __future__ import annotations

import random
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from time import perf_counter

from benchmarks.timing import Failure, Row

STUDENTS, AT_MOST = 60, 20_000

PROBLEM = """\
title: From the plant to the regulator
system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0], initial_state: [1, 0]}
find:
  a: {task: controllability, method: rank}
  b: {task: pole_placement, method: ackermann, poles: [-4, -5], answers: [K, closed_loop_A]}
  c: {task: eigenstructure, gain: {from: b}}
  d: {task: reference_tracking, gain: {from: b}}
  e: {task: state_transition_matrix, method: laplace}
  f: {task: response, method: laplace, kind: complete, input: "1"}
  g: {task: observer, method: ackermann, poles: [-6, -7]}
  h: {task: lqr, method: riccati, Q: [[5, 0], [0, 0]], R: 1, answers: [P, K]}
"""

TYPED = {
    "a": {
        "controllability_matrix": ["[[0, 1], [1, -3]]", "[[0, 1], [1, 3]]", "[[0, 1], [-2, -3]]"],
        "controllable": ["yes", "no"],
    },
    "b": {
        "K": ["[18, 6]", "[-18, -6]", "[16, 6]", "[20, 9]", "[6, 18]"],
        "closed_loop_A": ["[[0, 1], [-20, -9]]", "[[0, 1], [16, 3]]", "[[0, 1], [-18, -9]]"],
    },
    "c": {"eigenvalues": ["[-4, -5]", "[-3, -6]", "[4, 5]", "[-4]"], "right_eigenvectors": ["[[1, 1], [-4, -5]]"]},
    "d": {"K_o": ["20", "18", "2", "-16"]},
    "e": {
        "Phi": [
            "[[2exp(-t) - exp(-2t), exp(-t) - exp(-2t)], [2exp(-2t) - 2exp(-t), 2exp(-2t) - exp(-t)]]",
            "[[2exp(t) - exp(2t), exp(t) - exp(2t)], [2exp(2t) - 2exp(t), 2exp(2t) - exp(t)]]",
            "[[2exp(-t) - exp(-2t), exp(-t) + exp(-2t)], [2exp(-2t) - 2exp(-t), 2exp(-2t) - exp(-t)]]",
        ]
    },
    "f": {
        "x": ["[0.5 + exp(-t) - 0.5exp(-2t), exp(-2t) - exp(-t)]", "[0.5 + exp(-t), exp(-2t) - exp(-t)]"],
        "y": ["0.5 + exp(-t) - 0.5exp(-2t)", "0.5 - exp(-t) + 0.5exp(-2t)", "1/2"],
    },
    "g": {"L": ["[10, 10]", "[13, 42]", "[-10, -10]", "[10, 12]"]},
    "h": {
        "P": ["[[5.33, 1], [1, 0.317]]", "[[5.33, -1], [-1, 0.317]]", "[[5, 1], [1, 0.5]]"],
        "K": ["[1, 0.317]", "[1, 0.5]", "[-1, -0.317]"],
    },
}
"""What students type for each answer: the right value first, then usual slips."""


def answers(student: int) -> str:
    """The answer file of a student: two values of three are right."""
    dice = random.Random(student)
    lines = [f"student: S-{student:02}", "answers:"]
    for part, typed in TYPED.items():
        chosen = [f"{name}: {each[0] if dice.random() < 0.65 else dice.choice(each)!s}" for name, each in typed.items()]
        lines += [f"  {part}:", *(f"    {each}" for each in chosen)]
    return "\n".join(lines) + "\n"


def rows() -> Iterator[Row | Failure]:
    """Return the lines of the table: wall time of the command, which uses all cores."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "problem.yaml").write_text(PROBLEM, encoding="utf-8")
        for student in range(STUDENTS):
            (folder / f"student{student:02}.yaml").write_text(answers(student), encoding="utf-8")
        for wanted in ("json", "html"):
            title = f"a class of {STUDENTS}, eight parts, {wanted}"
            files = [str(path) for path in sorted(folder.glob("student*.yaml"))]
            words = ["check", str(folder / "problem.yaml"), *files, "-f", wanted, "-o", str(folder / wanted)]
            if wanted == "html":
                (folder / wanted).mkdir()
            start = perf_counter()
            finished = subprocess.run([sys.executable, "-m", "solver", *words], capture_output=True, check=False)
            taken = 1000 * (perf_counter() - start)
            if finished.returncode not in (0, 1):
                yield Failure(title, finished.stderr.decode()[-200:])
            else:
                yield Row(title, taken, at_most=AT_MOST)
