"""The kernels give the same results with and without python-flint."""

import importlib.util
import os
import subprocess
import sys

import pytest

SCRIPT = """
import sympy as sp
from solver import exact
from tests.helpers.exact_cases import DECIMAL, EXACT
t, k, x = sp.symbols("t k x")
for name, A in (EXACT | DECIMAL).items():
    structure = exact.eigenstructure(A)
    print(name, exact.exponential(A, t).matrix, exact.power(A, k).matrix, exact.resolvent(A, x))
    print(exact.spectrum(A).eigenvalues, structure.right, structure.left, structure.jordan_form)
    print(exact.interpolation_coefficients(A, t, discrete=False), exact.faddeev_leverrier(A).coefficients)
"""


def results(ground, seed):
    environment = {**os.environ, "SYMPY_GROUND_TYPES": ground, "PYTHONHASHSEED": seed}
    environment["PYTHONPATH"] = os.pathsep.join(path for path in sys.path if path)
    command = [sys.executable, "-c", SCRIPT]
    run = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    return run.stdout


@pytest.mark.skipif(importlib.util.find_spec("flint") is None, reason="python-flint is not installed")
def test_results_do_not_depend_on_flint():
    assert results("python", "1") == results("flint", "1")


@pytest.mark.slow
def test_results_do_not_depend_on_the_order_of_hashes():
    assert results("python", "1") == results("python", "2")
