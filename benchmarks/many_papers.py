"""An exam of five questions for very many, from the exam file to papers and keys: `python -m benchmarks papers [N]`.

`solve exam` runs as a command, by 1 and 2 processes and by a Dask cluster of two workers on this machine. While it
runs, the processor time and the memory of each of its processes are read from /proc, so that other work on the machine
counts little: what a variant costs is processor time, and what is fixed (loading) is told apart by a run of a few.
The memory is that of the process that leads, which holds what was drawn, and of the largest worker: the most of the
first half and of the whole, since a worker remembers until it is renewed.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from time import perf_counter, sleep

VARIANTS, FEW, STUDENTS = 1000, 10, 100_000
PAUSE = 0.1
TICKS, PAGE = os.sysconf("SC_CLK_TCK"), os.sysconf("SC_PAGE_SIZE")

QUESTIONS: Mapping[str, str] = {
    "placement": """\
title: Pole placement by state feedback
parameters: {a: 2, b: 3, p: -4}
vary: {a: {from: -40, to: 40}, b: {from: -40, to: 40}, p: {choose: [-4, -5, -6, -7]}}
require: ["a != 0", "b != 0", "a - 3 p != 0", "b + 3 - p != 0"]
nice: {b.K: integers}
system: {A: [[0, 1], [a, b]], B: [0, 1]}
find:
  a: {task: controllability, answers: [controllable]}
  b: {task: pole_placement, poles: [p, -3], answers: [K]}
""",
    "regulator": """\
title: A regulator of first order
parameters: {a: 2, q: 3}
vary: {a: {from: 1, to: 120}, q: {from: 1, to: 120}}
nice: {a.P: integers}
system: {A: [[a]], B: [1]}
find:
  a: {task: lqr, Q: [["q^2 + 2 a q"]], R: 1, answers: [P, K]}
""",
    "motion": """\
title: Motion of a free system
parameters: {a: 1, b: 3}
vary: {a: {from: 1, to: 120}, b: {from: 1, to: 120}}
require: ["a < b"]
system: {A: [[0, 1], ["-a b", "-(a + b)"]], initial_state: [1, 0]}
find:
  a: {task: state_transition_matrix}
  b: {task: response, kind: zero_input, answers: [x]}
""",
    "step": """\
title: Step response
parameters: {a: 1, c: 2}
vary: {a: {from: 1, to: 120}, c: {from: 1, to: 120}}
system: {transfer_function: "c/(s + a)"}
find:
  a: {task: stability}
  b: {task: response, kind: zero_state, input: "step(t)", answers: [y]}
""",
    "observer": """\
title: An observer
parameters: {a: 2, b: 1, p: -6}
vary: {a: {from: -40, to: 40}, b: {from: -40, to: 40}, p: {choose: [-6, -7, -8]}}
require: ["a != 0", "b != 0", "b + 4 - p != 0"]
nice: {a.L: integers}
system: {A: [[0, 1], [a, b]], B: [0, 1], C: [1, 0]}
find:
  a: {task: observer, poles: [p, -4], answers: [L]}
""",
}
"""Families of ten thousand members or more."""


@dataclass
class Watched:
    """What the processes of one session take: seconds of processor time and megabytes, by process."""

    session: int
    seconds: dict[int, float] = field(default_factory=dict)
    leader: list[float] = field(default_factory=list)
    worker: list[float] = field(default_factory=list)

    def look(self) -> None:
        """Read what there is now; a process that has ended keeps what was read last."""
        largest = 0.0
        for entry in Path("/proc").iterdir():
            if not entry.name.isdigit():
                continue
            try:
                facts = (entry / "stat").read_text(encoding="ascii", errors="replace").rpartition(")")[2].split()
            except OSError:
                continue
            if int(facts[3]) != self.session:
                continue
            self.seconds[int(entry.name)] = (int(facts[11]) + int(facts[12])) / TICKS
            megabytes = int(facts[21]) * PAGE / 2**20
            if int(entry.name) == self.session:
                self.leader.append(megabytes)
            else:
                largest = max(largest, megabytes)
        self.worker.append(largest)


@dataclass(frozen=True)
class Run:
    """A run: its variants, wall time, processor time, and megabytes of the leader and of the largest worker."""

    name: str
    variants: int
    wall: float
    cpu: float
    leader: tuple[float, float]
    worker: tuple[float, float]


def run(name: str, count: int, *words: str) -> Run:
    """Make so many variants in an empty folder; raises RuntimeError where the command fails."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        for question, text in QUESTIONS.items():
            (folder / f"{question}.yaml").write_text(text, encoding="utf-8")
        listed = "".join(f"  - {{problem: {question}.yaml, marks: 20}}\n" for question in QUESTIONS)
        text = f"exam: Modern control systems\nquestions:\n{listed}variants: {{count: {count}}}\nseed: 2026\n"
        (folder / "exam.yaml").write_text(text, encoding="utf-8")
        environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[1])}
        start = perf_counter()
        with (folder / "said").open("wb") as said:
            process = subprocess.Popen(
                [sys.executable, "-m", "solver", "exam", "exam.yaml", "-o", "build", *words],
                cwd=folder, env=environment, stdout=said, stderr=said, start_new_session=True,
            )  # fmt: skip
            watched = Watched(process.pid)
            while process.poll() is None:
                watched.look()
                sleep(PAUSE)
        wall = perf_counter() - start
        made = len(list((folder / "build" / "keys").glob("key-*.html"))) if process.returncode == 0 else 0
        if made != count:
            raise RuntimeError(f"{name}: {made} keys; {(folder / 'said').read_text(encoding='utf-8')[-600:]}")
    return Run(name, count, wall, sum(watched.seconds.values()), early_and_late(watched.leader),
               early_and_late(watched.worker))  # fmt: skip


def early_and_late(megabytes: list[float]) -> tuple[float, float]:
    """The most of the first half of a run, and of the whole."""
    return max(megabytes[: max(1, len(megabytes) // 2)]), max(megabytes)


HEADER = (
    "| engine | variants | wall (s) | CPU (s) | CPU of a variant (s) | MB that lead | MB of a worker "
    "| CPU hours for 100,000 papers |\n|---|---|---|---|---|---|---|---|"
)
ENGINES = {
    "1 process": ("--jobs", "1"),
    "2 processes": ("--jobs", "2"),
    "Dask, 2 workers here": ("--jobs", "2", "--engine", "dask"),
}


def line(few: Run, many: Run) -> str:
    """A line of the table: what is fixed does not count for a variant."""
    each = (many.cpu - few.cpu) / (many.variants - few.variants)
    hours = (few.cpu + each * (STUDENTS - few.variants)) / 3600
    memory = ["{:.0f} → {:.0f}".format(*megabytes) for megabytes in (many.leader, many.worker)]
    cells = [
        many.name,
        f"{many.variants}",
        f"{many.wall:.0f}",
        f"{many.cpu:.0f}",
        f"{each:.2f}",
        *memory,
        f"{hours:.0f}",
    ]
    return "| " + " | ".join(cells) + " |"


def main(count: int = VARIANTS) -> int:
    """Measure and print; return the exit code: 1 where the memory is not flat."""
    print(f"load of the machine: {os.getloadavg()[0]:.1f}\n\n{HEADER}", flush=True)
    flat = True
    for name, words in ENGINES.items():
        few, many = run(name, min(FEW, count // 2), *words), run(name, count, *words)
        print(line(few, many), flush=True)
        flat = flat and all(late < 1.3 * early for early, late in (many.leader, many.worker))
    return 0 if flat else 1
