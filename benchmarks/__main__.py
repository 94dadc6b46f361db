"""Print the tables of speed targets: `python -m benchmarks [--quick] [GROUP]`.

The groups are exponential, placement, mechanics, circuits, horizons, multivariable, transforms, classical,
analog, command, class and growth; and, only where they are named, desk: a class of sixty from empty folder to grades;
scale [PARTS]: many parts by processes and a cluster; papers [VARIANTS]: an exam for very many, 1000 if nothing is said.

`--quick` leaves out the entrywise inverse Laplace transform, which takes seconds at n = 10, and the table of growth.
`--write` puts the tables that were measured into docs/performance.md.
Exit code 0 if every target is met, else 1.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Iterator
from pathlib import Path

from benchmarks import (
    analog,
    circuits,
    class_of_sixty,
    classroom,
    command_line,
    finite_horizons,
    frequency,
    growth,
    holds,
    linearization,
    many_papers,
    matrix_exponential,
    mechanics,
    multivariable,
    pages,
    pole_placement,
    regulators,
    root_locus,
    scale,
    transforms,
    zeros,
)
from benchmarks.timing import Failure, Row

PAGE = Path(__file__).parents[1] / "docs" / "performance.md"
HEADER = f"{'work':<44} {'ours':>9} {'peer':>10} {'ratio':>7}  {'target':<20} {'met':<4} peer"


def measured(chosen: str | None, *, quick: bool) -> Iterator[Row | Failure]:
    """The rows of the chosen group, or of all."""
    if chosen in (None, "exponential"):
        yield from matrix_exponential.rows(quick=quick)
        yield from holds.rows()
    if chosen in (None, "placement"):
        yield from pole_placement.rows()
    if chosen in (None, "mechanics"):
        yield from mechanics.rows()
    if chosen in (None, "circuits"):
        yield from circuits.rows()
        yield from linearization.rows()
    if chosen in (None, "horizons"):
        yield from finite_horizons.rows()
        yield from regulators.rows()
    if chosen in (None, "multivariable"):
        yield from multivariable.rows()
        yield from zeros.rows()
    if chosen in (None, "transforms"):
        yield from transforms.rows(quick=quick)
    if chosen in (None, "classical"):
        yield from root_locus.rows()
        yield from frequency.rows()
        yield from pages.rows()
    if chosen in (None, "analog"):
        yield from analog.rows()
    if chosen in (None, "command"):
        yield from command_line.rows()
    if chosen in (None, "class"):
        yield from classroom.rows()


def line(row: Row | Failure) -> str:
    """One line of the table; times in milliseconds."""
    if isinstance(row, Failure):
        return f"{row.name:<44} not measured: {row.reason}"
    peer = "" if row.peer is None else f"{row.peer:.2f}"
    ratio = "" if row.ratio is None else f"{row.ratio:.1f}×"
    met = "yes" if row.met else "NO"
    return f"{row.name:<44} {row.ours:>9.2f} {peer:>10} {ratio:>7}  {row.target:<20} {met:<4} {row.peer_name}".rstrip()


def put_into_page(name: str, table: str) -> None:
    """Replace a table of docs/performance.md, which stands between comments with its name."""
    begin, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->"
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(begin)
    after = rest.partition(end)[2]
    PAGE.write_text(f"{before}{begin}\n{table}\n\n{end}{after}", encoding="utf-8")


def main() -> int:
    """Measure, print, and return the exit code."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="leave out what takes seconds")
    parser.add_argument("--write", action="store_true", help="put the tables into docs/performance.md")
    groups = (
        "exponential",
        "placement",
        "mechanics",
        "circuits",
        "horizons",
        "multivariable",
        "transforms",
        "classical",
        "analog",
        "command",
        "class",
        "desk",
        "scale",
        "papers",
        "growth",
    )
    parser.add_argument("group", nargs="?", choices=groups)
    parser.add_argument("task", nargs="?", help="of the table of growth, one task only; of scale and papers, how many")
    chosen = parser.parse_args()
    if chosen.group == "desk":
        return class_of_sixty.main()
    if chosen.group == "scale":
        return scale.main(int(chosen.task or scale.BUSY))
    if chosen.group == "papers":
        return many_papers.main(int(chosen.task or many_papers.VARIANTS))
    print("times in ms: the least processor time (of whole processes: wall time), caches emptied before each run")
    print(f"load of the machine: {os.getloadavg()[0]:.1f}\n")
    met = True
    if chosen.group != "growth":
        met = _rows(chosen.group, quick=chosen.quick, write=chosen.write and chosen.group is None)
    if chosen.group == "growth" or (chosen.group is None and not chosen.quick):
        met = _growth(chosen.task, write=chosen.write and chosen.task is None) and met
    return 0 if met else 1


def _rows(group: str | None, *, quick: bool, write: bool) -> bool:
    print(HEADER)
    met, printed = True, [HEADER]
    for row in measured(group, quick=quick):
        printed.append(line(row))
        print(printed[-1], flush=True)
        met = met and row.met
    if write:
        put_into_page("targets", "\n".join(["```text", *printed, "```"]))
    return met


def _growth(task: str | None, *, write: bool) -> bool:
    print(f"\nseconds of processor time, solved and checked; targets not met in bold\n\n{growth.HEADER}")
    met, printed = True, [growth.HEADER]
    for each in growth.lines(task):
        printed.append(str(each))
        print(printed[-1], flush=True)
        met = met and each.met
    if write:
        put_into_page("growth", "\n".join(printed))
    return met


if __name__ == "__main__":
    sys.exit(main())
