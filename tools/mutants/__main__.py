"""`python -m tools.mutants [PATH ...]`: how many slips the tests of their rooms see, and which they do not."""

from __future__ import annotations

import argparse
import hashlib
import shutil
import subprocess
import sys
import time
import tomllib
from collections import Counter, defaultdict
from collections.abc import Iterable
from itertools import zip_longest
from pathlib import Path

import pytest

from tools.mutants.operators import Mutant, mutants_of
from tools.mutants.reached import FOLDER, ROOT, read
from tools.mutants.running import OUTCOMES, outcomes

EQUIVALENTS = Path(__file__).with_name("equivalents.toml")
LOST = ("survived", "not reached")


def candidates(paths: Iterable[Path]) -> list[Mutant]:
    """All slips in these files and folders but the ones that are known to change nothing."""
    excused = {tuple(each[name] for name in ("file", "function", "before", "after")) for each in equivalents()}
    files = [file for path in paths for file in (sorted(path.rglob("*.py")) if path.is_dir() else [path])]
    found = [mutant for file in files for mutant in mutants_of(file, ROOT)]
    return [each for each in found if (each.file, each.function, each.before, each.after) not in excused]


def equivalents() -> list[dict[str, str]]:
    """The slips that no test can see, each with its reason."""
    listed: list[dict[str, str]] = tomllib.loads(EQUIVALENTS.read_text(encoding="utf-8")).get("equivalent", [])
    return listed


def sample(mutants: list[Mutant], number: int, seed: int) -> list[Mutant]:
    """So many of them; the same ones as long as what they change is there."""
    return sorted(mutants, key=lambda each: hashlib.sha256(f"{seed} {each.key}".encode()).digest())[:number]


def sample_of_each(mutants: list[Mutant], number: int, seed: int) -> list[Mutant]:
    """So many of every place in the program, one of each before the next."""
    places = sorted({each.place for each in mutants})
    chosen = [sample([each for each in mutants if each.place == place], number, seed) for place in places]
    return [each for turn in zip_longest(*chosen) for each in turn if each is not None]


def is_recorded() -> bool:
    """Whether it is known which statements each test runs, and no file has changed since."""
    files = [path for folder in ("solver", "tests") for path in (ROOT / folder).rglob("*.py")]
    records = [path.stat().st_mtime for path in FOLDER.glob("*.npz")]
    return bool(records) and max(path.stat().st_mtime for path in files) < min(records)


def record(paths: list[str]) -> None:
    """Run these tests, or all that are quick and forget what was known, to see which statements each runs."""
    if not paths:
        shutil.rmtree(FOLDER, ignore_errors=True)
    command = [sys.executable, "-m", "pytest", "-q", "-n", "2", "--dist", "loadgroup", "-m", "not slow"]
    command += ["-p", "tools.mutants.reached", *paths]
    code = subprocess.run(command, cwd=ROOT, check=False, stdout=sys.stderr).returncode
    if code not in {pytest.ExitCode.OK, pytest.ExitCode.TESTS_FAILED}:  # what fails tells nothing of a slip
        raise SystemExit("the tests could not be run")


def table(found: dict[str, Counter[str]]) -> str:
    """The counts by room."""
    lines = [f"{'room':<24}{'slips':>12}" + "".join(f"{word:>12}" for word in OUTCOMES) + f"{'seen':>7}"]
    for room in [*sorted(found), "all"]:
        counts = sum(found.values(), Counter()) if room == "all" else found[room]
        lost = sum(counts[word] for word in LOST)
        cells = "".join(f"{value:>12}" for value in (counts.total(), *(counts[word] for word in OUTCOMES)))
        lines.append(f"{room:<24}{cells}{1 - lost / max(1, counts.total()):>7.0%}")
    return "\n".join(lines)


def main() -> int:
    """Run the command; 1 if fewer are seen than asked for."""
    parser = argparse.ArgumentParser(prog="python -m tools.mutants", description=__doc__)
    parser.add_argument("paths", nargs="*", type=Path, default=[ROOT / "solver"], help="files and folders of solver/")
    parser.add_argument("--sample", type=int, default=60, help="how many slips are made (60)")
    parser.add_argument("--each", type=int, help="how many are made in every folder, instead of --sample")
    parser.add_argument("--seed", type=int, default=1, help="which ones (1)")
    parser.add_argument("--lanes", type=int, default=2, help="how many at the same time (2)")
    parser.add_argument("--least", type=float, default=0.0, help="the share that must be seen, e.g. 0.9")
    parser.add_argument(
        "--record", nargs="*", metavar="TESTS", help="run these tests first to see what they run, the others are known"
    )
    options = parser.parse_args()
    if options.record is not None or not is_recorded():
        record(options.record or [])
    possible = candidates(path.resolve() for path in options.paths)
    choose, number = (sample_of_each, options.each) if options.each else (sample, options.sample)
    chosen = choose(possible, number, options.seed)
    found: dict[str, Counter[str]] = defaultdict(Counter)
    start = time.monotonic()
    for mutant, outcome in outcomes(chosen, read(), options.lanes):
        found[mutant.place][outcome] += 1
        if outcome in LOST:
            where = f"{mutant.file}:{mutant.line} {mutant.function}"
            print(f"{outcome}: {where}: {mutant.before!r} -> {mutant.after!r} ({mutant.kind})", flush=True)
    print(table(found))
    print(f"{len(chosen)} slips in {time.monotonic() - start:.0f} s")
    total = sum(found.values(), Counter())
    return int(sum(total[word] for word in LOST) > (1 - options.least) * total.total())


if __name__ == "__main__":
    sys.exit(main())
