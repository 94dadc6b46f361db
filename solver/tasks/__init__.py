"""The catalogue: every task under this package, found by walking it. One file a task; nothing is listed by hand."""

from __future__ import annotations

from functools import cache
from importlib import import_module
from pkgutil import walk_packages

from solver.derivation import Task

GROUPS = ("Representation and analysis", "Design")


@cache
def catalogue() -> dict[str, Task]:
    """Return all tasks by name, group by group, in alphabetical order within a group. Imports no algebra."""
    modules = [import_module(info.name) for info in walk_packages(__path__, prefix=f"{__name__}.")]
    tasks = {value.name: value for module in modules for value in vars(module).values() if isinstance(value, Task)}
    ordered = sorted(tasks.values(), key=lambda task: (GROUPS.index(task.group), task.name))
    return {task.name: task for task in ordered}
