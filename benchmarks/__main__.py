"""Print the table of speed targets: `python -m benchmarks [--quick] [exponential|placement|command]`.

`--quick` leaves out the entrywise inverse Laplace transform, which takes seconds at n = 10.
Exit code 0 if every target is met, else 1.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Iterator

from benchmarks import command_line, matrix_exponential, pole_placement
from benchmarks.timing import Failure, Row

HEADER = f"{'work':<44} {'ours':>9} {'peer':>10} {'ratio':>7}  {'target':<20} {'met':<4} peer"


def measured(chosen: str | None, *, quick: bool) -> Iterator[Row | Failure]:
    """The rows of the chosen group, or of all."""
    if chosen in (None, "exponential"):
        yield from matrix_exponential.rows(quick=quick)
    if chosen in (None, "placement"):
        yield from pole_placement.rows()
    if chosen in (None, "command"):
        yield from command_line.rows()


def line(row: Row | Failure) -> str:
    """One line of the table; times in milliseconds."""
    if isinstance(row, Failure):
        return f"{row.name:<44} not measured: {row.reason}"
    peer = "" if row.peer is None else f"{row.peer:.2f}"
    ratio = "" if row.ratio is None else f"{row.ratio:.1f}×"
    met = "yes" if row.met else "NO"
    return f"{row.name:<44} {row.ours:>9.2f} {peer:>10} {ratio:>7}  {row.target:<20} {met:<4} {row.peer_name}".rstrip()


def main() -> int:
    """Measure, print, and return the exit code."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="leave out the peers that take seconds")
    parser.add_argument("group", nargs="?", choices=("exponential", "placement", "command"))
    chosen = parser.parse_args()
    print("times in ms: medians of processor time (of whole processes: wall time), caches emptied before each run")
    print(f"load of the machine: {os.getloadavg()[0]:.1f}\n\n{HEADER}")
    met = True
    for row in measured(chosen.group, quick=chosen.quick):
        print(line(row), flush=True)
        met = met and row.met
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
