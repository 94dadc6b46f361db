"""Names that packages import when they are used, and modules that run when they are used."""

import ast
import importlib
import subprocess
import sys
from pathlib import Path
from pkgutil import iter_modules

import pytest

from solver import exact
from solver.numeric import judges

JUDGES = [f"solver.numeric.judges.{each.name}" for each in iter_modules(judges.__path__)]
LAZY = ["solver.numeric", *JUDGES]
KERNELS = [f"solver.exact.{each.name}" for each in iter_modules(exact.__path__)]


def public_names(package):
    tree = ast.parse(Path(package.__file__).with_suffix(".pyi").read_text(encoding="utf-8"))
    return set(next(ast.literal_eval(line.value) for line in tree.body if isinstance(line, ast.Assign)))


@pytest.mark.parametrize("name", LAZY)
def test_every_name_of_a_stub_is_there_and_named_as_public(name):
    package = importlib.import_module(name)
    public = public_names(package)
    assert set(package.__all__) == public
    for each in public:
        assert hasattr(package, each)
    with pytest.raises(AttributeError, match="has no attribute 'nothing'"):
        _ = package.nothing


@pytest.mark.parametrize("name", KERNELS)
def test_every_name_of_a_topic_is_a_kernel(name):
    public = public_names(importlib.import_module(name))
    assert public <= set(exact.__all__)
    for each in public:
        assert getattr(exact, each).__module__.startswith(name)


def test_no_two_kernels_have_one_name():
    assert len(exact.__all__) == sum(len(public_names(importlib.import_module(name))) for name in KERNELS)
    with pytest.raises(AttributeError, match="has no attribute 'nothing'"):
        _ = exact.nothing


@pytest.mark.parametrize("name", ["solver.exact", *LAZY])
def test_no_module_hides_a_name(name):
    package = importlib.import_module(name)
    assert not {module.name for module in iter_modules(package.__path__)} & set(package.__all__)


def test_a_postponed_module_runs_when_it_is_used():
    program = (
        "import sys; from solver.startup import postpone; postpone('numpy', 'testing'); import scipy.linalg, numpy;"
        "early = 'unittest' in sys.modules; numpy.testing.assert_equal(1, 1); print(early, 'unittest' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["False", "True"]
