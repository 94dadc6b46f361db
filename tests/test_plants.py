"""How the engine brings a system to what a task works on."""

import numpy as np
import sympy as sp

from solver.derivation import Status
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue


def solved(text):
    return solve_problem(read_problem(Source("p.yaml", text), catalogue())).parts


def test_a_transfer_function_is_realized_for_a_question_about_states():
    (part,) = solved("system: {transfer_function: '(s+3)/(2s^2+6s+4)'}\nfind: {a: eigenstructure}\n")
    assert part.status is Status.VERIFIED
    assert part.steps[0].kind == "realized"
    assert sorted(part.answers["eigenvalues"]) == [-2, -1]


def test_a_factor_that_cancels_stays_an_eigenvalue():
    (part,) = solved("system: {transfer_function: '(s+1)/((s+1)(s+2))'}\nfind: {a: eigenstructure}\n")
    assert sorted(part.answers["eigenvalues"]) == [-2, -1]


def test_a_gain_closes_the_loop_of_the_realization():
    (part,) = solved("system: {transfer_function: '1/s^2'}\nfind: {a: {task: eigenstructure, gain: [2, 3]}}\n")
    assert [step.kind for step in part.steps[:2]] == ["realized", "closed_loop"]
    assert np.allclose(sorted(map(float, part.answers["eigenvalues"])), [-2, -1])


def test_a_constant_has_no_states():
    (part,) = solved("system: {transfer_function: '3/2'}\nfind: {a: eigenstructure}\n")
    assert part.status is Status.UNSOLVED
    assert "constant" in str(part.reason)


def test_in_discrete_time_too():
    (part,) = solved("system: {time: discrete, transfer_function: 1/(z-1/2)}\nfind: {a: characteristic_polynomial}\n")
    assert part.answers["polynomial"] == sp.Symbol("lamda") - sp.Rational(1, 2)


def test_a_later_part_goes_on_with_the_decimals_of_an_earlier_one():
    solution = solve_problem(
        read_problem(
            Source(
                "p.yaml",
                "system: {A: [[0, 1], [-2, -3]], B: [0, 1]}\nfind:\n"
                "  a: {task: desired_poles, overshoot: 14%, settling_time: 2}\n"
                "  b: {task: pole_placement, poles: {from: a}}\n"
                "  c: {task: eigenstructure, gain: {from: b}}\n",
            ),
            catalogue(),
        )
    )
    poles, _, closed = solution.parts
    assert closed.status is Status.VERIFIED
    assert np.allclose(
        np.sort_complex([complex(value) for value in closed.answers["eigenvalues"]]),
        np.sort_complex([complex(value) for value in poles.answers["poles"]]),
    )
    document = document_of(solution)
    assert all("." in part.answers[0].tex for part in document.parts)
