"""The catalogue: every task under this package, found by its declaration. One file a task; nothing is listed by hand.

A file declares its task as `name = Task("name", group="...", ...)`. Declarations are found by reading the files, and a
file is imported when its task is wanted: a problem that asks for one task does not pay for the others.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, MutableMapping
from functools import cache
from importlib import import_module
from pathlib import Path

from solver.derivation import Task

GROUPS = ("Representation and analysis", "Design")

DECLARATION = re.compile(r'^(?P<name>\w+) = Task\(\s*"(?P=name)",\s*group="(?P<group>[^"]+)"', re.MULTILINE)


class Catalogue(MutableMapping[str, Task]):
    """Tasks by name, group by group, in alphabetical order within a group; each is imported when it is first wanted."""

    def __init__(self, modules: dict[str, str]) -> None:
        self._modules = modules
        self._tasks: dict[str, Task] = {}

    def __getitem__(self, name: str) -> Task:
        if name not in self._tasks:
            self._tasks[name] = getattr(import_module(self._modules[name]), name)
        return self._tasks[name]

    def __setitem__(self, name: str, task: Task) -> None:
        self._modules[name] = ""
        self._tasks[name] = task

    def __delitem__(self, name: str) -> None:
        del self._modules[name]
        self._tasks.pop(name, None)

    def __iter__(self) -> Iterator[str]:
        return iter(self._modules)

    def __len__(self) -> int:
        return len(self._modules)

    def __contains__(self, name: object) -> bool:
        return name in self._modules


@cache
def catalogue() -> Catalogue:
    """Return all tasks. Imports no algebra."""
    return Catalogue({name: module for _, name, module in sorted(_declared())})


def _declared() -> Iterator[tuple[int, str, str]]:
    """Yield place of the group, name and module of every task that is declared."""
    root = Path(__file__).parent
    for path in root.rglob("*.py"):
        for match in DECLARATION.finditer(path.read_text(encoding="utf-8")):
            module = ".".join((__name__, *path.relative_to(root).with_suffix("").parts))
            yield GROUPS.index(match["group"]), match["name"], module


__all__ = ["GROUPS", "Catalogue", "catalogue"]
