"""Statements of the program that note that they run: one store into shared memory before each.

Of statements that follow each other without a branch only the first has its note: where it runs, so do the others,
unless one of them raises. Cheap enough for all tests: a tracer would make them twice as slow. What runs in a process
forked by a test is noted too. What runs on import is not noted.
"""

from __future__ import annotations

import ast
import builtins
import gc
import importlib.abc
import importlib.machinery
import mmap
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from types import CodeType
from typing import Any

import numpy as np
from numpy.typing import NDArray

ROOT = Path(__file__).parents[2]
MEMORY = "__statements_that_ran__"
BODIES = ("body", "orelse", "finalbody")
LEADING_ON = (ast.Assign, ast.AugAssign, ast.AnnAssign, ast.Expr, ast.Pass, ast.Delete, ast.Import, ast.ImportFrom)
"""Statements after which the next one runs, if they do not raise or give way to others."""
CATCHING = (ast.Try, ast.With)
"""Statements in which one that raises may go unseen."""


class Program:
    """The statements inside the functions of the program, each with a number."""

    def __init__(self, folder: Path = ROOT / "solver") -> None:
        self.first: dict[str, int] = {}
        """The number of the first statement of a file."""
        self.lines: list[tuple[int, int]] = []
        """First and last line of each statement; of one that has others inside, of what stands before them."""
        notes: list[int] = []
        for path in sorted(folder.rglob("*.py")):
            self.first[str(path)] = len(self.lines)
            for _, statement, noted in _statements(ast.parse(path.read_bytes())):
                notes.append(len(self.lines) if noted else notes[-1])
                self.lines.append(_lines(statement))
        self.notes = np.array(notes, dtype=np.intp)
        """The number of the statement whose note tells of each."""
        self.memory = mmap.mmap(-1, max(1, len(self.lines)))  # shared with processes forked from this one

    def watch(self, package: str = "solver") -> None:
        """Let what is imported of the program from now on note what runs."""
        setattr(builtins, MEMORY, self.memory)
        sys.meta_path.insert(0, Finder(package, self.first))

    def files(self) -> dict[str, tuple[int, list[tuple[int, int]]]]:
        """By file: the number of its first statement, and the lines of each."""
        ends = [*self.first.values(), len(self.lines)][1:]
        names = [Path(path).relative_to(ROOT).as_posix() for path in self.first]
        return {
            name: (first, self.lines[first:end])
            for name, first, end in zip(names, self.first.values(), ends, strict=True)
        }

    def ran(self) -> NDArray[np.uint8]:
        """A byte for each statement, 1 if it ran since the last time this was asked."""
        found = np.frombuffer(self.memory[:], dtype=np.uint8)
        self.memory[:] = bytes(len(found))
        return np.asarray(found[self.notes])


class Finder(importlib.abc.MetaPathFinder):
    """Finds modules as ever, and has those of the program noted."""

    def __init__(self, package: str, first: dict[str, int]) -> None:
        self.package = package
        self.first = first

    def find_spec(self, fullname: str, path: Any, target: Any = None) -> Any:
        """Return the ordinary spec with a loader of ours."""
        if fullname.partition(".")[0] != self.package:
            return None
        spec = importlib.machinery.PathFinder.find_spec(fullname, path, target)
        if spec and spec.origin in self.first:
            spec.loader = Loader(fullname, spec.origin, self.first[spec.origin])
        return spec


class Loader(importlib.machinery.SourceFileLoader):
    """Compiles a module with its notes, and leaves no compiled file."""

    def __init__(self, name: str, path: str, first: int) -> None:
        super().__init__(name, path)
        self.number = first

    def get_code(self, fullname: str) -> CodeType:
        """Return the module compiled with a note before each statement."""
        path = self.get_filename(fullname)
        tree = ast.parse(self.get_data(path), path)
        for number, (body, statement, noted) in enumerate([*_statements(tree)], self.number):
            if noted:
                body.insert(body.index(statement), _note(number, statement))
        return compile(tree, path, "exec", dont_inherit=True)


def _note(number: int, statement: ast.stmt) -> ast.stmt:
    """Return `memory[number] = 1`, as if it stood where the statement is."""
    at = {
        "lineno": statement.lineno,
        "col_offset": statement.col_offset,
        "end_lineno": statement.end_lineno,
        "end_col_offset": statement.end_col_offset,
    }
    memory, index = ast.Name(MEMORY, ast.Load(), **at), ast.Constant(number, **at)
    return ast.Assign([ast.Subscript(memory, index, ast.Store(), **at)], ast.Constant(1, **at), **at)


def _statements(tree: ast.AST) -> Iterator[tuple[list[ast.stmt], ast.stmt, bool]]:
    """Yield each statement inside a function with the list it stands in, and whether it is noted; no docstrings."""
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            yield from _inside(node)


def _inside(node: ast.AST) -> Iterator[tuple[list[ast.stmt], ast.stmt, bool]]:
    """Yield the statements of one function; those of functions in it come by themselves."""
    for name in BODIES:
        body: list[ast.stmt] = getattr(node, name, None) or []
        noted = True
        for i, statement in enumerate(body):
            if i or not _is_text(statement):
                yield body, statement, noted
                noted = isinstance(node, CATCHING) or not _leads_on(statement)
            if not isinstance(statement, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
                yield from _inside(statement)
    for part in [*getattr(node, "handlers", ()), *getattr(node, "cases", ())]:
        yield from _inside(part)


def _leads_on(statement: ast.stmt) -> bool:
    """Whether the next statement runs after this one and before anything else does."""
    within = ast.walk(statement)
    return isinstance(statement, LEADING_ON) and not any(isinstance(each, ast.Yield | ast.YieldFrom) for each in within)


def _is_text(statement: ast.stmt) -> bool:
    return isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)


def _lines(statement: ast.stmt) -> tuple[int, int]:
    """Return the lines of a statement, without those of the statements in it."""
    inside = [each.lineno for name in BODIES for each in getattr(statement, name, None) or []]
    inside += [each.body[0].lineno for each in getattr(statement, "handlers", ())]
    if isinstance(statement, ast.Match):
        return statement.lineno, statement.end_lineno or statement.lineno
    last = min(inside, default=(statement.end_lineno or statement.lineno) + 1) - 1
    return statement.lineno, max(statement.lineno, last)


@cache
def program() -> Program:
    """The program as it is, read once in a process."""
    collecting = gc.isenabled()
    gc.disable()  # trees of syntax are many objects and no garbage
    try:
        return Program()
    finally:
        if collecting:
            gc.enable()
