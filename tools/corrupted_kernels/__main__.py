"""`python -m tools.corrupted_kernels [PROBLEM ...]`: what becomes of pages where a kernel is a little wrong."""

from __future__ import annotations

import argparse
import sys
from collections import Counter, defaultdict
from collections.abc import Iterable
from pathlib import Path

from solver.document.model import Presentation
from tools.corrupted_kernels.equivalents import RIGHT, judged
from tools.corrupted_kernels.runs import CAUGHT, SAME, SURVIVED, Extent, Outcome, outcomes
from tools.corrupted_kernels.samples import covering

COLUMNS = ("caught", SAME, RIGHT, SURVIVED)


def column(outcome: Outcome) -> str:
    """The column of the table that a case belongs to."""
    return "caught" if outcome.became in CAUGHT else outcome.became


def table(found: Iterable[Outcome]) -> str:
    """The counts by kernel."""
    counts: dict[str, Counter[str]] = defaultdict(Counter)
    for outcome in found:
        counts[outcome.kernel][column(outcome)] += 1
    lines = [f"{'kernel':<32}" + "".join(f"{word:>20}" for word in COLUMNS)]
    for name in [*sorted(counts), "all"]:
        own = sum(counts.values(), Counter()) if name == "all" else counts[name]
        lines.append(f"{name:<32}" + "".join(f"{own[word]:>20}" for word in COLUMNS))
    return "\n".join(lines)


def main() -> int:
    """Run the command; 1 if a corrupted result reached a page under “verified”."""
    parser = argparse.ArgumentParser(prog="python -m tools.corrupted_kernels", description=__doc__)
    parser.add_argument("problems", nargs="*", type=Path, help="problem files (some that ask every task in every way)")
    parser.add_argument("--changes", type=int, default=3, help="changes made of the result of a call (3)")
    parser.add_argument("--calls", type=int, help="calls of each kernel that are corrupted in a part (all)")
    parser.add_argument("--detail", default="full", help="the level of detail of the page (full)")
    options = parser.parse_args()
    presentation = Presentation(options.detail, notation="course")
    found: list[Outcome] = []
    for path in options.problems or covering():
        for outcome in map(judged, outcomes(path, Extent(options.changes, options.calls), presentation)):
            found.append(outcome)
            if outcome.became == SURVIVED:
                print(f"{outcome.key}\n    {outcome.shown[:600]}", flush=True)
    print(table(found))
    return int(any(outcome.became == SURVIVED for outcome in found))


if __name__ == "__main__":
    sys.exit(main())
