"""Finds calls that the solving path must not make; run as `python tools/forbidden_calls.py [PATH...]`.

Text of a stranger must never be evaluated, and sympy's general routines are slow or wrong where we need an exact
answer. The tests may call them: they are good oracles.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from pathlib import Path

EVALUATES = "evaluates text as code"
SLOW = "slow or wrong; see docs/architecture.md"

FUNCTIONS = {
    **dict.fromkeys(("eval", "exec", "compile", "__import__", "sympify", "parse_expr", "lambdify"), EVALUATES),
    **dict.fromkeys(("simplify", "nsimplify", "inverse_laplace_transform", "laplace_transform"), SLOW),
}
"""Forbidden as functions of any module and, but for `compile`, as methods."""

METHODS = {**dict.fromkeys(("jordan_form", "eigenvects", "diagonalize", "simplify", "nsimplify"), SLOW), **FUNCTIONS}
del METHODS["compile"]  # of regular expressions

SHELLS = {"system", "popen"}
BROAD = {"Exception", "BaseException"}


def violations(path: Path) -> Iterator[tuple[int, str]]:
    """Yield line and reason of each forbidden call in a file."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"), str(path))):
        if isinstance(node, ast.Call):
            yield from ((node.lineno, reason) for reason in _of_call(node))
        elif isinstance(node, ast.ExceptHandler) and _is_silent(node):
            yield node.lineno, "an except clause for everything that does nothing"


def _of_call(node: ast.Call) -> Iterator[str]:
    function = node.func
    name = getattr(function, "id", getattr(function, "attr", ""))
    owner = getattr(getattr(function, "value", None), "id", "")
    known = FUNCTIONS if isinstance(function, ast.Name) else METHODS
    if name in known:
        yield f"{name}(): {known[name]}"
    if isinstance(function, ast.Attribute) and name == "exp" and not node.args:
        yield f".exp(): {SLOW}"
    if name == "S" and node.args and not _is_number(node.args[0]):
        yield f"S() of what may be a text: {EVALUATES}"
    if owner == "pickle" and name in {"load", "loads", "Unpickler"}:
        yield "pickle runs code of whoever wrote the data"
    if owner == "os" and name in SHELLS:
        yield f"os.{name}() starts a shell"
    if any(keyword.arg == "shell" and not _is_false(keyword.value) for keyword in node.keywords):
        yield "shell=True starts a shell"


def _is_number(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, int | float)


def _is_false(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and node.value is False


def _is_silent(handler: ast.ExceptHandler) -> bool:
    """Whether a handler catches everything and passes it over."""
    broad = handler.type is None or (isinstance(handler.type, ast.Name) and handler.type.id in BROAD)
    return broad and all(isinstance(statement, ast.Pass | ast.Continue) for statement in handler.body)


def files_under(paths: list[str]) -> Iterator[Path]:
    """Yield the Python files named, and those under the folders named, sorted."""
    for path in map(Path, paths):
        yield from sorted(path.rglob("*.py")) if path.is_dir() else [path]


def main(paths: list[str]) -> int:
    """Print every violation; return 1 if there is one."""
    found = [(path, line, reason) for path in files_under(paths) for line, reason in violations(path)]
    for path, line, reason in found:
        print(f"{path}:{line}: {reason}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:] or ["solver"]))
