"""The files that a command is about: those named, those in folders, and those that patterns fit, each once.

A folder stands for the `.yaml` files in it and none in the folders below; a pattern (`'ch1/*.yaml'`, `'**/*.yaml'`) is
for shells that leave it as it is, and for quotes. What a person names is taken as it is; what is only found is looked
at first, and passed over where it is no problem. Order: as named, within folders and patterns by name.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import click

from solver.cli.destination import STANDARD
from solver.problem.files import load
from solver.problem.other_files import ALSO, MARKS, PROBLEM
from solver.problem.source import InputError

ENDINGS = (".yaml", ".yml")
NOTHING_FOUND = 2
WILD = re.compile(r"[*?]|\[.+\]")
KEY = re.compile(r"""^(["']?)([A-Za-z_]\w*)\1[ \t]*:(?:[ \t\r]|$)""", re.MULTILINE)
MEANT = ("title", "statement", "parameters", "assume")
"""A file with one of these keys is meant as a problem, whatever it lacks."""


@dataclass(frozen=True, slots=True)
class Inputs:
    """The files of a command; those `passed_over` were found and are no problems: why, by the file.

    `several` says that more than one file was meant, even where one was found; `missing` has what is found nowhere.
    """

    files: tuple[str, ...]
    several: bool
    passed_over: tuple[tuple[str, str], ...] = ()
    missing: tuple[str, ...] = ()


def problems_in(named: Sequence[str]) -> Inputs:
    """Return the problem files that arguments of the command line mean."""
    files, passed_over, missing = dict[str, None](), dict[str, str](), list[str]()
    for name in named:
        if is_one_file(name):
            files[name] = None
            continue
        found = list(found_by(name))
        kinds = {each: kind_of(each) for each in found}
        problems = [each for each, kind in kinds.items() if not kind]
        files |= dict.fromkeys(problems)
        passed_over |= {each: kind for each, kind in kinds.items() if kind}
        if not problems:
            missing.append(_nothing_at(name))
    others = tuple((each, kind) for each, kind in passed_over.items() if each not in files)
    return Inputs(_each_once(files), len(named) > 1 or not all(map(is_one_file, named)), others, tuple(missing))


def tell(inputs: Inputs) -> int:
    """Say on standard error what is passed over and what is missing; return 2 where something is missing."""
    if inputs.passed_over:
        others = ", ".join(f"{file} ({kind})" for file, kind in inputs.passed_over)
        click.echo(f"passed over, no problems: {others}", err=True)
    for words in inputs.missing:
        click.echo(words, err=True)
    return NOTHING_FOUND if inputs.missing else 0


def is_one_file(name: str) -> bool:
    """Whether an argument names one file, be it there or not: neither a folder nor a pattern."""
    path = Path(name)
    return name == STANDARD or (not path.is_dir() and (WILD.search(name) is None or path.exists()))


def found_by(name: str) -> Iterator[str]:
    """Yield the `.yaml` files of a folder or a pattern by name; hidden files and folders are left out."""
    path = Path(name)
    if path.is_dir():
        yield from map(str, _inside(path))
        return
    for each in _fitting(path):
        if each.is_dir():
            yield from map(str, _inside(each))
        elif _is_meant(each):
            yield str(each)


def _fitting(pattern: Path) -> list[Path]:
    """Return what fits a pattern, by name; nothing where it is no pattern."""
    start = Path(pattern.anchor)
    wild = next(place for place, each in enumerate(pattern.parts) if WILD.search(each))
    fixed, rest = Path(*pattern.parts[:wild]), Path(*pattern.parts[wild:])
    try:
        found = sorted((fixed if wild else start).glob(str(rest)))
    except (ValueError, OSError, NotImplementedError):
        return []
    return [each for each in found if not any(part.startswith(".") for part in each.parts[wild:])]


def _inside(folder: Path) -> list[Path]:
    return [each for each in sorted(folder.iterdir()) if _is_meant(each)]


def _is_meant(path: Path) -> bool:
    return path.suffix.lower() in ENDINGS and not path.name.startswith(".") and path.is_file()


def kind_of(file: str) -> str:
    """Return what a file is that is no problem, "" of a problem and of what cannot be read: it will be told why.

    It is told by the keys at the beginnings of lines: the reader tells it better, but reads hundreds of files slowly.
    """
    try:
        keys = {match[2] for match in KEY.finditer(load(file).text)}
    except InputError:
        return ""
    if not keys or not keys.isdisjoint({MARKS[PROBLEM], ALSO[PROBLEM]}):
        return ""
    if kind := next((kind for kind, key in MARKS.items() if key in keys), ""):
        return kind
    return "" if not keys.isdisjoint(MEANT) else "it asks nothing"


def _nothing_at(name: str) -> str:
    """Return in words that no problem is found in a folder or by a pattern."""
    if not Path(name).is_dir():
        return f"{name}: error: no problem file fits this pattern"
    below = any(each.suffix.lower() in ENDINGS for each in Path(name).glob("*/*"))
    help_ = f"\n       = for those of its folders: solve '{Path(name) / '**' / '*.yaml'}'" if below else ""
    return f"{name}: error: there is no problem file in this folder; they end in .yaml{help_}"


def _each_once(files: Sequence[str] | dict[str, None]) -> tuple[str, ...]:
    """Return the files without those that are named a second time in another way."""
    found: dict[str, str] = {}
    for file in files:
        found.setdefault(file if file == STANDARD else os.path.abspath(file), file)  # noqa: PTH100 - links stay
    return tuple(found.values())
