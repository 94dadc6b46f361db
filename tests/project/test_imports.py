"""Names that packages import when they are used, and modules that run when they are used."""

import ast
import importlib
import subprocess
import sys
from pathlib import Path
from pkgutil import iter_modules

import pytest

from solver.numeric import judges

JUDGES = [f"solver.numeric.judges.{each.name}" for each in iter_modules(judges.__path__)]
LAZY = ["solver.exact", "solver.numeric", *JUDGES]


@pytest.mark.parametrize("name", LAZY)
def test_every_name_of_a_stub_is_there_and_named_as_public(name):
    package = importlib.import_module(name)
    tree = ast.parse(Path(package.__file__).with_suffix(".pyi").read_text(encoding="utf-8"))
    public = next(ast.literal_eval(line.value) for line in tree.body if isinstance(line, ast.Assign))
    assert set(package.__all__) == set(public)
    for each in public:
        assert hasattr(package, each)
    with pytest.raises(AttributeError, match="has no attribute 'nothing'"):
        _ = package.nothing


@pytest.mark.parametrize("name", LAZY)
def test_no_module_hides_a_name(name):
    package = importlib.import_module(name)
    assert not {module.name for module in iter_modules(package.__path__)} & set(package.__all__)


def test_a_postponed_module_runs_when_it_is_used():
    program = (
        "import sys; from solver.imports import postpone; postpone('numpy', 'testing'); import scipy.linalg, numpy;"
        "early = 'unittest' in sys.modules; numpy.testing.assert_equal(1, 1); print(early, 'unittest' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["False", "True"]
