"""What makes a start quick, all in one place: a program that runs for a second should load only what it needs.

Modules and names that are imported when they are first used; garbage that is not collected while modules are loaded;
one thread for small matrices.
"""

from __future__ import annotations

import ast
import gc
import os
import sys
from collections.abc import Callable
from importlib import import_module
from importlib.util import LazyLoader, find_spec, module_from_spec
from pathlib import Path
from typing import Any


def names_of_stub(package: str, file: str) -> tuple[list[str], Callable[[str], Any]]:
    """Return `__all__` and `__getattr__` of a package whose names are imported when they are first used.

    The stub `__init__.pyi` beside the package's file says, as imports, in which module each name is; type checkers
    read it too. A module directly in the package may not have a public name: it would stand in its place.
    """
    return names_of_stubs(package, Path(file).with_suffix(".pyi"))


def names_of_stubs(package: str, *stubs: Path) -> tuple[list[str], Callable[[str], Any]]:
    """Return the same for a package that has the names of several stubs."""
    trees = [ast.parse(stub.read_text(encoding="utf-8")) for stub in stubs]
    imports = [line for tree in trees for line in tree.body if isinstance(line, ast.ImportFrom)]
    homes = {alias.name: str(line.module) for line in imports for alias in line.names}

    def get(name: str) -> Any:
        if name not in homes:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        value = getattr(import_module(homes[name]), name)
        setattr(sys.modules[package], name, value)
        return value

    return list(homes), get


def postpone(package: str, name: str) -> None:
    """Let the module `package.name` run when it is first used, and not already when all names of the package are taken.

    An `import` statement of its own is a use too.
    """
    full_name = f"{package}.{name}"
    spec = None if full_name in sys.modules else find_spec(full_name)
    if spec is None or spec.loader is None:
        return
    spec.loader = LazyLoader(spec.loader)
    module = module_from_spec(spec)
    sys.modules[full_name] = module
    spec.loader.exec_module(module)
    setattr(import_module(package), name, module)


class LazyModule:
    """Stands for a module; the first attribute asked for imports it."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __getattr__(self, attribute: str) -> Any:
        value = getattr(import_module(self._name), attribute)
        setattr(self, attribute, value)  # so that the next look-up is an ordinary one
        return value


def quiet_threads() -> None:
    """Let numerical libraries use one thread: the matrices are small, and a process with threads should not fork."""
    gc.set_threshold(100_000, 20, 20)  # importing makes many objects and no garbage: a fifth faster
    for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
        os.environ.setdefault(name, "1")


def begin_loading() -> bool:
    """Collect no garbage until `end_loading`: one collection takes as long as loading numpy.

    Return whether this is the first time in the process; later there is nothing to load.
    """
    is_first = not gc.get_freeze_count()
    if is_first:
        gc.disable()
    return is_first


def end_loading() -> None:
    """Collect garbage from now on, without looking at what was loaded."""
    gc.freeze()
    gc.enable()
