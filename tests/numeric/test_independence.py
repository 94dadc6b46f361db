"""The oracles share no code with what they check, and cost nothing until they are used."""

import ast
import subprocess
import sys
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules

import pytest

import solver.numeric

FOLDER = Path(solver.numeric.__file__).parent
FORBIDDEN_NAMES = {"simplify", "nsimplify", "lambdify", "sympify", "parse_expr", "eval", "jordan_form", "eigenvects"}


@pytest.mark.parametrize("path", sorted(FOLDER.rglob("*.py")), ids=lambda path: path.stem)
def test_an_oracle_imports_nothing_of_what_it_checks(path):
    tree = ast.parse(path.read_text(encoding="utf-8"))
    imported = {node.module or "" for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    imported |= {alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names}
    ours = {name for name in imported if name.split(".")[0] == "solver"}
    allowed = (
        "solver.numeric",
        "solver.derivation",
        "solver.stated",
        "solver.conditions",
        "solver.jets",
        "solver.startup",
        "solver.matrices",
        "solver.patches",
        "solver.symbols",
        "solver.words",
    )
    assert all(name.startswith(allowed) for name in ours), ours
    called = {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
    called |= {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    assert not called & FORBIDDEN_NAMES


def test_scipy_is_imported_only_by_what_needs_it():
    program = (
        "import sys, sympy, solver.numeric as n; from solver.derivation import Claim;"
        "from solver.stated.matrices import determinant; x = sympy.Symbol('x');"
        "n.check_claim(Claim(determinant(x * sympy.eye(2)), x**2), ''); print('scipy' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"


def test_every_public_name_is_documented():
    topics = [f"solver.numeric.judges.{each.name}" for each in iter_modules([str(FOLDER / "judges")])]
    for package in (solver.numeric, *map(import_module, topics)):
        for name in package.__all__:
            value = getattr(package, name)
            assert callable(value) is False or value.__doc__, name
