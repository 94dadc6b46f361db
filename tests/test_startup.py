"""What makes a start quick: modules and names that wait until they are used, garbage, threads."""

import os
import subprocess
import sys
from importlib import import_module

import pytest

from solver.startup import LazyModule, names_of_stub, postpone, quiet_threads


@pytest.fixture
def package(tmp_path, monkeypatch):
    """A package with a stub and two modules that say when they run."""
    folder = tmp_path / "waiting_package"
    folder.mkdir()
    (folder / "__init__.py").write_text("", encoding="utf-8")
    (folder / "__init__.pyi").write_text("from waiting_package.late import value as value\n", encoding="utf-8")
    for name in ("late", "later"):
        (folder / f"{name}.py").write_text("import sys\nsys.ran.append(__name__)\nvalue = [1]\n", encoding="utf-8")
    monkeypatch.setattr(sys, "ran", [], raising=False)
    monkeypatch.syspath_prepend(str(tmp_path))
    yield folder
    for name in [name for name in sys.modules if name.partition(".")[0] == "waiting_package"]:
        del sys.modules[name]


def test_a_postponed_module_is_there_at_once_and_runs_at_its_first_use(package):
    postpone("waiting_package", "late")
    module = sys.modules["waiting_package"].late
    assert sys.modules["waiting_package.late"] is module
    assert sys.ran == []
    assert module.value == [1]
    assert sys.ran == ["waiting_package.late"]


def test_a_module_that_has_run_is_not_postponed_and_one_that_is_not_there_is_no_error(package):
    module = import_module("waiting_package.late")
    postpone("waiting_package", "late")
    postpone("waiting_package", "missing")
    assert sys.modules["waiting_package.late"] is module
    assert sys.ran == ["waiting_package.late"]


def test_a_lazy_module_and_the_names_of_a_stub_are_imported_once(package):
    names, get = names_of_stub("waiting_package", str(package / "__init__.py"))
    module = LazyModule("waiting_package.later")
    assert (names, sys.ran) == (["value"], [])
    assert get("value") is sys.modules["waiting_package"].value
    assert sys.ran == ["waiting_package.late"]
    assert module.value is module.value
    assert sys.ran == ["waiting_package.late", "waiting_package.later"]
    with pytest.raises(AttributeError, match="'waiting_package' has no attribute 'nothing'"):
        get("nothing")


def test_numerical_libraries_use_one_thread_unless_told_otherwise(monkeypatch):
    monkeypatch.delenv("OMP_NUM_THREADS", raising=False)
    monkeypatch.setenv("MKL_NUM_THREADS", "3")
    quiet_threads()
    assert os.environ["OMP_NUM_THREADS"] == "1"
    assert os.environ["MKL_NUM_THREADS"] == "3"


def test_no_garbage_is_collected_while_the_program_is_loaded_for_the_first_time():
    program = (
        "import gc; from solver.startup import begin_loading, end_loading\n"
        "print(begin_loading(), gc.isenabled()); end_loading(); print(gc.isenabled())\n"
        "print(begin_loading(), gc.isenabled())"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.split("\n")[:3] == ["True False", "True", "False True"]
