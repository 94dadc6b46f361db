"""What a folder of results was made of: what is there and unchanged is not made again.

A record, `.solve.json` in the folder, has for each thing that was made a key, the hash of all it depends on, the names
and hashes of the files written, and what was told. It is data that is only compared: nothing in it is run, and where it
cannot be read all is made again.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Iterable, Mapping
from functools import cache
from hashlib import sha256
from pathlib import Path
from time import monotonic
from typing import Any, Self

import click

from solver import __version__
from solver.cli.destination import AtFault, write_whole

NAME = ".solve.json"
FORMAT = 1
LARGEST = 2**28
PAUSE = 0.5
"""Seconds between two writings at least; where writing takes long, so many times that."""
SHARE = 20
LIBRARIES = ("sympy", "mpmath", "numpy", "scipy", "jinja2", "latex2mathml", "markdown-it-py", "matplotlib", "schemdraw",
             "python-flint", "typst")  # fmt: skip

Data = Mapping[str, Any]


class Record:
    """The record of a folder. Who leaves its context writes it, whatever happened; `anew` uses nothing that it has."""

    def __init__(self, folder: Path, *, anew: bool = False) -> None:
        self.folder = folder
        self.made: dict[str, Data] = _read(folder / NAME)
        self.anew = anew
        self.used: dict[str, None] = {}
        self.changed = False
        self.written, self.took = monotonic(), 0.0

    def get(self, name: str, key: str) -> Data | None:
        """Return what was told of a thing that was made of the same, if all its files are there as they were."""
        entry = self.made.get(name)
        if self.anew or entry is None or entry["key"] != key:
            return None
        if any(_hash_of_file(self.folder, file) != known for file, known in entry["files"].items()):
            return None
        self.used[name] = None
        return entry["told"]

    def told(self, name: str) -> Data:
        """Return what was told of a thing when it was made, whatever it was made of; nothing where it is not known."""
        return self.made[name]["told"] if name in self.made else {}

    def put(self, name: str, key: str, files: Mapping[str, bytes], told: Data) -> None:
        """Keep what was made: its files by their paths below the folder, and what was told, all of it plain data."""
        hashes = {file: sha256(content).hexdigest() for file, content in sorted(files.items())}
        self.made[name] = {"key": key, "files": hashes, "told": told}
        self.used[name] = None
        self.changed = True
        if monotonic() - self.written > max(PAUSE, SHARE * self.took):
            self.write()

    def forget_others(self, belongs: Callable[[str], bool]) -> None:
        """Forget what belongs to this command and was neither used nor made by it."""
        for name in [name for name in self.made if belongs(name) and name not in self.used]:
            del self.made[name]
            self.changed = True

    def write(self) -> None:
        """Write the record, if there is anything new."""
        if not self.changed:
            return
        start = monotonic()
        content = {"format": FORMAT, "made": dict(sorted(self.made.items()))}
        try:
            write_whole(self.folder / NAME, json.dumps(content, ensure_ascii=False, indent=0).encode())
        except AtFault as fault:  # all is there but the record
            click.echo(f"what was made is not kept in mind: {fault.format_message()}", err=True)
        self.changed = False
        self.written = monotonic()
        self.took = self.written - start

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.write()


def _read(path: Path) -> dict[str, Data]:
    """Return what a record has; nothing, and words on standard error, where it is none."""
    if not path.exists():
        return {}
    try:
        if not path.is_file() or path.stat().st_size > LARGEST:
            raise ValueError("it is no record")
        content = json.loads(path.read_bytes())
        if not isinstance(content, dict) or content.get("format") != FORMAT:
            raise ValueError("it is of another version")
        made: dict[str, Data] = content["made"]
        if not all(map(_is_entry, made.values())):
            raise ValueError("it is no record")
    except (OSError, ValueError, KeyError, AttributeError, RecursionError) as error:
        reason = error.args[0] if type(error) is ValueError else "it cannot be read"
        click.echo(f"{path} is not used, and all is made again: {reason}", err=True)
        return {}
    return made


def _is_entry(entry: Any) -> bool:
    if not isinstance(entry, dict) or set(entry) != {"key", "files", "told"}:
        return False
    files, told = entry["files"], entry["told"]
    return isinstance(files, dict) and isinstance(told, dict) and all(isinstance(each, str) for each in files.values())


def _hash_of_file(folder: Path, name: str) -> str:
    """Return the hash of a file below the folder, "" where there is none."""
    path = folder / name
    try:
        if Path(name).is_absolute() or ".." in Path(name).parts or not path.is_file():
            return ""
        return sha256(path.read_bytes()).hexdigest()
    except (OSError, ValueError):
        return ""


def key_of(*facts: Any) -> str:
    """Return the hash of facts that are texts, numbers, lists and so on, and of the program that uses them."""
    return sha256(json.dumps([program(), *facts], ensure_ascii=True, default=repr).encode()).hexdigest()


@cache
def program() -> str:
    """Return the hash of the program as installed: its sources, templates and models, Python, and the libraries."""
    from importlib.metadata import PackageNotFoundError, version

    from solver.resources import root

    versions = [__version__, sys.version]
    for library in LIBRARIES:
        try:
            versions.append(f"{library} {version(library)}")
        except PackageNotFoundError:
            versions.append(library)
    folders = (Path(__file__).parents[1], root("templates"), root("problems") / "models")
    return sha256("\n".join([*versions, *map(hash_of_folder, folders)]).encode()).hexdigest()


@cache
def hash_of_folder(folder: Path | None) -> str:
    """Return the hash of all files in a folder and the folders below, by their paths; "" for none."""
    if folder is None:
        return ""
    total = sha256()
    for path in _files_below(folder):
        content = path.read_bytes()
        total.update(f"{path.relative_to(folder).as_posix()}\0{len(content)}\0".encode("utf-8", "surrogateescape"))
        total.update(content)
    return total.hexdigest()


def _files_below(folder: Path) -> Iterable[Path]:
    for current, folders, files in os.walk(folder):
        folders[:] = sorted(each for each in folders if each != "__pycache__")
        yield from (path for each in sorted(files) if (path := Path(current, each)).is_file())
