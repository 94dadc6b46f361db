"""What is made of several files is called in one folder: after the files, told apart by the folders these are in."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from pathlib import Path

YAML = (".yaml", ".yml")


def stems_of(files: Iterable[str], nameless: str) -> dict[str, str]:
    """Return a stem for each file, no two alike: `a`; where several are called so, with the folders before, `x-a`.

    Names that differ in capitals only are alike, as for some file systems. Standard input is called `nameless`.
    """
    whole = {file: (nameless,) if file == "-" else _names(Path(file).resolve()) for file in files}
    apart = {_end(names, len(names)) for names in whole.values()}  # `a.yaml` and `a.yml` are not, by any folder
    ends = Counter(names[-k:] for names in apart for k in range(1, len(names) + 1))
    found, taken = dict[str, str](), set[str]()
    for file, names in whole.items():
        count = next((k for k in range(1, len(names)) if ends[_end(names, k)] == 1), len(names))
        stem = "-".join(names[-count:])
        chosen, number = stem, 1
        while chosen.casefold() in taken:
            number += 1
            chosen = f"{stem}-{number}"
        taken.add(chosen.casefold())
        found[file] = chosen
    return found


def stem_of(path: Path) -> str:
    """Return the name of a file without the ending of YAML."""
    return path.stem if path.suffix.lower() in YAML else path.name


def _names(path: Path) -> tuple[str, ...]:
    """The folders of a file, and its name without the ending."""
    return (*path.parts[1:-1], stem_of(path))


def _end(names: tuple[str, ...], count: int) -> tuple[str, ...]:
    return tuple(name.casefold() for name in names[-count:])
