"""The catalogue: every task under this package, found by its declaration. One file a task; nothing is listed by hand.

Declarations are found by reading the files (`declarations`), and a file is imported when its task is wanted: a problem
that asks for one task does not pay for the others, nor does the list of all.
"""

from __future__ import annotations

from collections.abc import Iterator, MutableMapping
from functools import cache, cached_property
from importlib import import_module
from pathlib import Path
from typing import Any

from solver.derivation import Task, Topic
from solver.tasks.declarations import Declaration, DeclarationError, declared_by, declared_in, topics


class Catalogue(MutableMapping[str, Task[Any, Any]]):
    """Tasks by name, topic by topic, in alphabetical order within a topic; each is imported when it is first wanted."""

    def __init__(self, root: Path, package: str) -> None:
        self._root = root
        self._package = package
        self._tasks: dict[str, Task[Any, Any]] = {}
        self._added: dict[str, Declaration] = {}

    @cached_property
    def topics(self) -> dict[Path, Topic]:
        """The topics by their folder, in their order."""
        return topics(self._root)

    @cached_property
    def _found(self) -> dict[str, Declaration]:
        found: dict[str, Declaration] = {}
        for folder, topic in self.topics.items():
            for each in declared_in(folder, topic, f"{self._package}.{folder.name}"):
                if each.name in found:
                    modules = f"{found[each.name].module} and {each.module}"
                    raise DeclarationError(f"the task {each.name} is declared twice, in {modules}; rename one of them")
                found[each.name] = each
        return found

    def declarations(self) -> list[Declaration]:
        """Return what is declared of each task; imports none. Raises DeclarationError."""
        return [*self._found.values(), *self._added.values()]

    def __getitem__(self, name: str) -> Task[Any, Any]:
        if name not in self._tasks:
            declaration = self._declared(name)
            if declaration is None:
                raise KeyError(name)
            self._tasks[name] = getattr(import_module(declaration.module), name)
        return self._tasks[name]

    def _declared(self, name: str) -> Declaration | None:
        """Return the declaration of one task, without reading the others."""
        if not name.isidentifier():
            return None
        for path in self._root.glob(f"*/{name}.py"):
            package = f"{self._package}.{path.parent.name}"
            return declared_by(path, self.topics[path.parent], package)
        return None

    def __setitem__(self, name: str, task: Task[Any, Any]) -> None:
        self._added[name] = Declaration(name, task.title, tuple(task.methods), "", Topic("", 0, ""))
        self._tasks[name] = task

    def __delitem__(self, name: str) -> None:
        del self._added[name], self._tasks[name]

    def __iter__(self) -> Iterator[str]:
        return iter([*self._found, *self._added])

    def __len__(self) -> int:
        return len(self._found) + len(self._added)

    def __contains__(self, name: object) -> bool:
        return name in self._tasks or (isinstance(name, str) and self._declared(name) is not None)


@cache
def catalogue() -> Catalogue:
    """Return all tasks. Imports no algebra."""
    return Catalogue(Path(__file__).parent, __name__)


__all__ = ["Catalogue", "Declaration", "DeclarationError", "catalogue"]
