"""Kernels as tasks see them: every call is noted, so that its result is held to what must hold of it."""

import inspect

import pytest
import sympy as sp

from solver import exact
from solver.lazy import exact as seen
from solver.lazy import noted_calls
from solver.postconditions import postcondition_of

A = sp.ImmutableMatrix([[0, 1], [-2, -3]])


@pytest.mark.parametrize("kernel", ["spectrum", "determinant", "characteristic_factors"])
def test_calls_are_noted_whether_a_kernel_remembers_its_results_or_not(kernel):
    with noted_calls([]) as calls:
        found = getattr(seen, kernel)(A)
    assert [(call.kernel, call.arguments) for call in calls] == [(kernel, (A,))]
    assert calls[0].result == found == getattr(exact, kernel)(A)


@pytest.mark.parametrize("kernel", sorted(name for name in exact.__all__ if postcondition_of(name)))
def test_a_kernel_with_a_postcondition_is_one_whose_calls_are_noted(kernel):
    value = getattr(exact, kernel)
    assert inspect.isfunction(inspect.unwrap(value))
    assert getattr(seen, kernel) is not value
