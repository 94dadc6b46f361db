"""Equations as they are read: their samples and derivatives come in the order of the text."""

import pytest

from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue


@pytest.mark.parametrize(
    ("time", "equations", "jets"),
    [
        ("time: discrete, ", ["y(k+2) - 3y(k+1) + 2y(k) = u(k)"], [("y", 2), ("y", 1), ("y", 0), ("u", 0)]),
        ("time: discrete, ", ["y(k) = u(k-1) + y(k-2) + y(k-1)"], [("y", 0), ("y", -1), ("y", -2), ("u", -1)]),
        (
            "time: discrete, ",
            ["x(k+1) = x(k) + y(k)", "y(k+1) = -x(k) + y(k) + u(k)"],
            [("x", 1), ("x", 0), ("y", 0), ("y", 1), ("u", 0)],
        ),
        ("", ["y'' + 3 y' + 2 y = u' + u"], [("y", 2), ("y", 1), ("y", 0), ("u", 1), ("u", 0)]),
        ("", ["theta'' = u - theta"], [("theta", 2), ("theta", 0), ("u", 0)]),
    ],
)
def test_what_occurs_in_equations_comes_in_the_order_of_the_text(time, equations, jets):
    """Those of the left side, then those of the right; by name as the names stand, of one name the latest first."""
    text = f"system: {{{time}equations: {equations}, inputs: [u]}}\nfind: {{a: state_space_model}}\n"
    system = read_problem(Source("p.yaml", text), catalogue()).parts[0].system
    assert list(system.jets.values()) == jets


def test_a_value_at_another_time_is_no_sample_of_continuous_time():
    """x(t - 1) is neither x nor a derivative of it."""
    for equation in ("x' = -x(t-1) + u", "x' = -x + u(t - 1)", "x' = x(t + 2) + u"):
        text = f'system: {{equations: ["{equation}"], inputs: [u]}}\nfind: {{a: stability}}\n'
        with pytest.raises(InputError, match="is the value at another time") as caught:
            read_problem(Source("p.yaml", text), catalogue())
        assert "exp(-s)/(s + 1)" in str(caught.value)
