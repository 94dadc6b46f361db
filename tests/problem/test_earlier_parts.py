"""Systems taken from earlier parts, and parts with names of their own."""

from __future__ import annotations

import pytest
import sympy as sp

from solver.derivation import Status
from solver.engine import solve_problem
from solver.problem.model import Reference
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue

s = sp.Symbol("s")
PLANT = "system: {transfer_function: 1/(s^2 + 2s + 5)}\n"


def read(text):
    return read_problem(Source("file.yaml", text), catalogue())


def solved(text):
    return {part.id: part for part in solve_problem(read(text)).parts}


def complaint(text):
    with pytest.raises(InputError) as caught:
        read(text)
    (found,) = caught.value.diagnostics
    return f"{found.line}:{found.column} {found.message}"


def test_a_realization_is_taken_as_a_plant_and_its_loop_is_closed():
    found = solved(
        PLANT + "find:\n  a: realization\n  b: {task: pole_placement, system: {from: a}, poles: [-1, -2]}\n"
        "  c: {task: stability, system: {from: a, gain: {from: b}}}\n"
        "  d: {task: stability, system: {from: a, gain: [1, 2]}}\n"
    )
    assert all(part.status is Status.VERIFIED for part in found.values())
    assert sorted(found["c"].answers["eigenvalues"]) == [-2, -1]
    assert sp.Poly.from_expr(sp.prod(s - root for root in found["d"].answers["eigenvalues"]).expand(), s) == sp.Poly(
        s**2 + 4 * s + 6, s
    )


def test_without_a_matrix_the_transfer_function_is_taken():
    found = solved(
        "system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}\nfind:\n  a: transfer_function\n"
        "  b: {task: transfer_function, system: {from: a}, feedback: unity}\n"
        "  c: {task: realization, system: {from: a}}\n"
    )
    assert sp.cancel(found["b"].answers["G"] - 1 / (s**2 + 3 * s + 3)) == 0
    assert found["c"].answers["A"].charpoly().all_coeffs() == [1, 3, 2]


def test_decimals_of_an_earlier_part_are_taken_as_printed():
    found = solved(
        "system: {A: [[0, 1, 0], [0, 0, 1], [1, 1, 0]], B: [0, 0, 1], C: [1, 0, 0]}\nfind:\n"
        "  a: {task: realization, form: modal}\n  b: {task: stability, system: {from: a}}\n"
    )
    assert found["b"].status is Status.VERIFIED
    assert found["b"].answers["verdict"] == "unstable"


def test_an_unsolved_part_leaves_those_about_its_result_unsolved():
    found = solved(
        "system: {A: [[1, 0], [0, 2]], B: [1, 0], C: [1, 0]}\nfind:\n  a: {task: observer, poles: [-1, -2]}\n"
        "  b: {task: similarity_transformation, T: [[1, 1], [0, 1]]}\n"
        "  c: {task: stability, system: {from: b, gain: {from: d}}}\n".replace("{from: d}", "{from: a, answer: L}")
    )
    assert found["a"].status is found["c"].status is Status.UNSOLVED
    assert "part a" in str(found["c"].reason)
    found = solved(
        "system: {transfer_function: 5}\nfind:\n  a: realization\n  b: {task: stability, system: {from: a}}\n"
    )
    assert found["b"].status is Status.UNSOLVED
    assert str(found["b"].reason) == "it asks about the result of part a, which was not found"


@pytest.mark.parametrize(
    ("part", "says"),
    [
        ("{task: stability, system: {from: b}}", "3:39 'b' is not an earlier part"),
        ("{task: stability, system: {from: a}}", "3:39 part a answers no system: neither A nor a transfer function G"),
        ("{task: stability, system: {from: a, A: 1}}", "3:42 'A' cannot stand beside 'from'"),
        ("{task: stability, system: {from: a, gain: {form: b}}}", "3:48 a matrix, or {from: part}, is expected here"),
    ],
)
def test_what_is_wrong_with_a_reference_is_said_at_its_place(part, says):
    text = f"{PLANT}find: {{a: dc}}\n".replace(
        "{a: dc}", "{a: {task: matrix_function, function: A^2},\n  c: " + part + "}"
    )
    with pytest.raises(InputError) as caught:
        read(text)
    assert says in [f"{each.line}:{each.column} {each.message}" for each in caught.value.diagnostics]


def test_a_system_of_the_whole_problem_refers_to_no_part():
    assert "is not an earlier part" in complaint("system: {from: a}\nfind: {a: stability}\n")


def test_names_of_a_part_win_over_those_of_the_problem():
    problem = read(
        "parameters: {a: 2}\nassume: {b: positive}\nsystem: {A: [[0, 1], [-a, -b]]}\nfind:\n"
        "  p: stability\n  q: {task: stability, parameters: {a: 3, b: 4}}\n"
        "  r: {task: stability, assume: {b: negative}}\n"
    )
    p, q, r = (part.system.A for part in problem.parts)
    assert (p[1, 0], q[1, 0], r[1, 0], q[1, 1]) == (-2, -3, -2, -4)
    assert (p[1, 1].is_negative, r[1, 1].is_positive) == (True, True)
    assert [part.own_system for part in problem.parts] == [False, True, True]
    assert complaint("system: {A: 1}\nfind:\n  p: {task: stability, parameters: {q: 1}}\n") == (
        "3:37 the parameter 'q' occurs nowhere"
    )


def test_a_list_of_parameters_is_the_option_and_a_mapping_the_values():
    text = "system: {A: [[0, 1], [-a, -b]]}\nfind:\n  p: {task: stability_range, parameters: "
    assert read(text + "[a, b]}\n").parts[0].options["parameters"] == ("a", "b")
    (part,) = read(text + "{a: 1}}\n").parts
    assert part.system.A[1, 0] == -1
    assert "parameters" not in part.options


def test_the_sources_of_a_part_are_its_system_and_its_options():
    problem = read(
        PLANT + "find:\n  a: realization\n  b: {task: pole_placement, system: {from: a}, poles: [-1, -2]}\n"
        "  c: {task: stability, system: {from: a, gain: {from: b}}}\n"
    )
    assert problem.parts[2].sources == ("a", "b")
    assert problem.parts[2].system.gain == Reference("b", "K")


@pytest.mark.parametrize("system", ["{from: a}", "{transfer_function: 1/(s^3 + 2s + 5)}"])
@pytest.mark.parametrize(
    "asked",
    [
        "lqr, R: 1, initial_state: [1, 0]",
        "response, input: 1, initial_state: [1, 0]",
        "minimum_energy_control, final_time: 1, initial_state: [1, 0]",
        "finite_horizon_lqr, final_time: 1, terminal_weight: [[1, 0], [0, 1]]",
    ],
)
def test_matrices_of_another_size_than_a_system_that_is_found_later_are_refused(system, asked):
    text = "system: {transfer_function: 1/(s^3 + 2s + 5)}\nfind:\n  a: realization\n"
    part = solved(text + f"  b: {{task: {asked}, system: {system}}}\n")["b"]
    assert part.status is Status.UNSOLVED
    assert part.reason.values["fault"].kind == "engine/misfit"
