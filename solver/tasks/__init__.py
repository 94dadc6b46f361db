"""The catalogue: every task under this package, found by its declaration. One file a task; nothing is listed by hand.

A file declares its task as `name: Task[...] = Task("name", group="...", title="...", ...)` and, below, each method as
`@name.method("method", ...)`. Declarations are found by reading the files, and a file is imported when its task is
wanted: a problem that asks for one task does not pay for the others, nor does the list of all.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, MutableMapping
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from solver.derivation import Task

GROUPS = ("Representation and analysis", "Design")

DECLARATION = re.compile(
    r'^(?P<name>\w+): Task\[.*\] = Task\(\s*"(?P=name)",\s*group="(?P<group>[^"]+)",\s*title="(?P<title>[^"]+)"',
    re.MULTILINE,
)
METHOD = re.compile(r'^@(?P<task>\w+)\.method\(\s*(?:"(?P<name>\w+)")?', re.MULTILINE)


class Declaration(NamedTuple):
    """What the file of a task says of it; a task with one way to solve it may leave the method without a name."""

    name: str
    group: str
    title: str
    methods: tuple[str, ...]
    module: str


class Catalogue(MutableMapping[str, Task[Any, Any]]):
    """Tasks by name, group by group, in alphabetical order within a group; each is imported when it is first wanted."""

    def __init__(self, declarations: list[Declaration]) -> None:
        self._declarations = {each.name: each for each in declarations}
        self._tasks: dict[str, Task[Any, Any]] = {}

    def declarations(self) -> list[Declaration]:
        """Return what is declared of each task; imports none."""
        return list(self._declarations.values())

    def __getitem__(self, name: str) -> Task[Any, Any]:
        if name not in self._tasks:
            self._tasks[name] = getattr(import_module(self._declarations[name].module), name)
        return self._tasks[name]

    def __setitem__(self, name: str, task: Task[Any, Any]) -> None:
        self._declarations[name] = Declaration(name, task.group, task.title, tuple(task.methods), "")
        self._tasks[name] = task

    def __delitem__(self, name: str) -> None:
        del self._declarations[name]
        self._tasks.pop(name, None)

    def __iter__(self) -> Iterator[str]:
        return iter(self._declarations)

    def __len__(self) -> int:
        return len(self._declarations)

    def __contains__(self, name: object) -> bool:
        return name in self._declarations


@cache
def catalogue() -> Catalogue:
    """Return all tasks. Imports no algebra."""
    return Catalogue(sorted(_declared(), key=lambda each: (GROUPS.index(each.group), each.name)))


def _declared() -> Iterator[Declaration]:
    """Yield the declaration of every task."""
    root = Path(__file__).parent
    for path in root.rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        for match in DECLARATION.finditer(text):
            name = match["name"]
            methods = [method["name"] or name for method in METHOD.finditer(text) if method["task"] == name]
            module = ".".join((__name__, *path.relative_to(root).with_suffix("").parts))
            yield Declaration(name, match["group"], match["title"], tuple(methods), module)


__all__ = ["GROUPS", "Catalogue", "Declaration", "catalogue"]
