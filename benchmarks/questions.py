"""The questions of the table of growth, as a user types them: every task by each method, for plants of any order."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise

import sympy as sp

from benchmarks.matrices import companion_of_integers, dense, random_integers
from solver.tasks import catalogue

LARGEST = {
    "phase_portrait": 2, "finite_horizon_lqr": 3, "minimum_energy_control": 3, "smith_form": 4,
    "smith_mcmillan_form": 5, "relative_gain_array": 5, "root_locus": 4, "pid_tuning": 2, "second_order_parameters": 2,
    "step_specifications": 2, "z_transform": 4, "difference_equation": 4, "ragazzini": 2,
    "op_amp_stage": 8,
}  # fmt: skip
"""Tasks about one order only, and those whose answers or steps fill the page from the next order on."""

PARAMETER = {"stability_range": "A", "parameter_condition": "B"}
"""Tasks about a parameter k, and the matrix that holds it."""

REGULATORS = ("lqr", "kalman_filter", "optimal_tracking")
"""These are also asked about random integers, where everything is irrational."""

QUESTION = """\
system:
{system}
find:
  a:
    task: {task}
{options}
"""


def asked() -> Iterator[tuple[str, str, str]]:
    """Every task, each of its methods, and every kind of plant that they are asked about."""
    for task, declared in catalogue().items():
        for method in (each.name for each in declared.methods.values() if not each.system):
            for kind in ("dense", "companion", *(("random",) if task in REGULATORS else ())):
                yield task, method, kind


def question(task: str, method: str, n: int, kind: str) -> str:
    """The text of the problem that asks for the task by the method about a plant of order n.

    Raises KeyError where the task needs an option of which nothing is said here.
    """
    declared = catalogue()[task]
    given = OPTIONS[task](n) if task in OPTIONS else OPTIONS_BY_METHOD.get((task, method), {})
    required = {name for name, option in declared.options_for(method).items() if option.required}
    if missing := required - set(given):
        raise KeyError(f"{task}: no value of {', '.join(sorted(missing))} in benchmarks/questions.py")
    chosen = {"method": method} if list(declared.methods) != [task] else {}
    discrete = not declared.methods[method].serves(discrete=False)
    if discrete and task in DISCRETE_OPTIONS:
        given |= DISCRETE_OPTIONS[task]
    system = _system(task, method, n, kind)
    time = {"time": "discrete"} if discrete else {}
    return QUESTION.format(task=task, system=_lines(time | system, 2), options=_lines(chosen | given, 4))


def _system(task: str, method: str, n: int, kind: str) -> dict[str, str]:
    """The system of a question in the kind that the task needs."""
    needs = catalogue()[task].needs
    if task.endswith("_compensator"):
        return {"transfer_function": f"1/(s (s + 1) {' '.join(f'(s/{100 * i} + 1)' for i in range(2, n))})"}
    if task == "pid_tuning":
        lags = n if method == "pole_placement" else n + 1
        return {"transfer_function": f"1/({' '.join(f'(s + {i})' for i in range(1, lags + 1))})"}
    if task == "dominant_pole_reduction":
        return {"transfer_function": f"1/({' '.join(f'(s + {i})' for i in range(1, n + 2))})"}
    if task == "ragazzini":
        zeros, lags = (" ".join(f"(s + {i}{half})" for i in range(1, n + more)) for half, more in ((".5", 0), ("", 1)))
        return {"transfer_function": f"({zeros})/({lags})" if zeros else f"1/{lags}"}
    if task == "step_specifications":
        return {"transfer_function": "4/(s^2 + 2s + 4)"}
    if "lagrangian" in needs:
        return chain_of_masses(n)
    if task == "block_diagram_reduction":
        return chain_of_loops(n)
    if "op_amp" in needs:
        return cascade(n)
    if "functional" in needs:
        return sums_of_squares(n)
    if "polynomial_matrix" in needs:
        return {"polynomial_matrix": str((sp.Symbol("s") * sp.eye(n) - plant(n, kind)[0]).tolist())}
    if task == "difference_equation":
        return equations(n, kind, discrete=True)
    if "machine" in needs:
        return equations(n, kind)
    return equations(n, kind) if "equations" in needs else matrices(task, method, n, kind)


def chain_of_masses(n: int) -> dict[str, str]:
    """Masses in a row, each tied to the one before it by a spring, the first to a wall; the last one is pushed."""
    q = [f"q{i}" for i in range(1, n + 1)]
    bodies = ", ".join(f"{{mass: {i}, position: [{x}, 0]}}" for i, x in enumerate(q, 1))
    springs = ", ".join(f'{{stiffness: 2, length: "{b} - {a}"}}' for a, b in zip(["0", *q], q, strict=False))
    inside = f"{{coordinates: [{', '.join(q)}], bodies: [{bodies}], springs: [{springs}], forces: {{{q[-1]}: u}}}}"
    return {"lagrangian": inside, "inputs": "[u]"}


def chain_of_loops(n: int) -> dict[str, str]:
    """Integrators in a row, each with its own feedback, the last with one round all of them."""
    names = [f"x{i}" for i in range(n + 1)]
    forward = [f"[{a}, {b}, 1/s]" for a, b in pairwise(names)]
    back = [f"[{b}, {b}, {-i}/s]" for i, b in enumerate(names[1:], 1)]
    flow = ", ".join(["[r, x0, 1]", *forward, *back, f"[{names[-1]}, x0, -1]"])
    return {"signal_flow": f"[{flow}]", "input": "r", "output": names[-1]}


def cascade(n: int) -> dict[str, str]:
    """Stages one behind the other, summers and integrators in turn, each with an input of its own too."""
    stages = []
    for i in range(1, n + 1):
        inputs = f"w{i}: {{R: {i}000}}" + (f", y{i - 1}: {{R: 2000}}" if i > 1 else "")
        stages.append(f"{{inputs: {{{inputs}}}, feedback: {'{C: 1e-6}' if i % 2 else '{R: 4000}'}}}")
    return {"op_amp": f"[{', '.join(stages)}]"}


def sums_of_squares(n: int) -> dict[str, str]:
    """∫ Σ (xᵢ'² + i² xᵢ²) dt from 0 to 1, from 0 to 1 in every function."""
    names = [f"x{i}" for i in range(1, n + 1)]
    integrand = " + ".join(f"{x}'^2 + {i * i} {x}^2" for i, x in enumerate(names, 1))
    ends = ", ".join(f"{x}: [0, 1]" for x in names)
    functional = f'{{integrand: "{integrand}", functions: [{", ".join(names)}], from: 0, to: 1, ends: {{{ends}}}}}'
    return {"functional": functional}


def plant(n: int, kind: str) -> tuple[sp.MatrixBase, sp.MatrixBase, sp.MatrixBase]:
    """A, B, C of a controllable, observable plant of one input and output.

    Dense or companion it has the eigenvalues −1 … −n; random are its entries.
    """
    if kind == "random":
        return random_integers(n, n, seed=n), random_integers(n, 1, seed=n + 1), random_integers(1, n, seed=n + 2)
    if kind == "companion":
        last, first = sp.eye(n)[:, n - 1], sp.eye(n)[0, :]
        return companion_of_integers(n), last, first
    B = sp.Matrix(n, 1, lambda i, _: 2 * i % 5 - 1)
    C = sp.Matrix(1, n, lambda _, j: (j * j + 1) % 4)
    return dense(n), B, C


def matrices(task: str, method: str, n: int, kind: str) -> dict[str, str]:
    """The plant of a question: with the parameter k where the task is about one, with two channels for unity rank."""
    A, B, C = plant(n, kind)
    k, first = sp.Symbol("k"), sp.eye(n)[:, 0]
    if PARAMETER.get(task) == "A":
        A = A - k * B * C
    if PARAMETER.get(task) == "B":
        B = B + k * first
    if method == "unity_rank":
        observes = task in ("observer", "current_observer")
        B, C = (B, C.col_join(sp.eye(n)[n - 1, :])) if observes else (B.row_join(first), C)
    return {name: str(M.tolist()) for name, M in {"A": A, "B": B, "C": C}.items()}


def equations(n: int, kind: str, *, discrete: bool = False) -> dict[str, str]:
    """The plant by the equations of its states."""
    A, B, C = plant(n, kind)
    now, rate = ("(k)", "(k+1)") if discrete else ("", "'")
    x = sp.Matrix([sp.Symbol(f"x{i}{now}") for i in range(1, n + 1)])
    right = A * x + B * sp.Symbol(f"u{now}")
    rows = ", ".join(f'"x{i + 1}{rate} = {right[i]}"' for i in range(n))
    return {"equations": f"[{rows}]", "inputs": "[u]", "outputs": f"[{(C * x)[0]}]"}


def poles(count: int) -> str:
    """The poles −2, −3, …"""
    return str([-i for i in range(2, count + 2)])


def _weights(n: int) -> dict[str, str]:
    return {"Q": str(sp.eye(n).tolist()), "R": "[[1]]"}


OPTIONS: dict[str, Callable[[int], dict[str, str]]] = {
    "similarity_transformation": lambda n: {"T": str([[int(j >= i) for j in range(n)] for i in range(n)])},
    "matrix_function": lambda _: {"function": "exp(A*t)"},
    "response": lambda n: {"input": "exp(-t)", "initial_state": str([1] * n)},
    "desired_poles": lambda _: {"damping_ratio": "1/2", "settling_time": "4"},
    "pole_placement": lambda n: {"poles": poles(n)},
    "reference_tracking": lambda n: {"poles": poles(n)},
    "servo": lambda n: {"poles": poles(n + 1)},
    "initial_state": lambda n: {"y": str([1] * n)},
    "linearization": lambda _: {"at": "{}"},
    "solve_equations": lambda _: {"equations": '["x^2 + y = 3", "x - y = 1"]', "unknowns": "[x, y]"},
    "model_matching": lambda n: {"target": f"1/(s + 20)^{n}"},
    "observer": lambda n: {"poles": poles(n)},
    "current_observer": lambda n: {"poles": poles(n)},
    "reduced_observer": lambda n: {"poles": poles(n - 1)},
    "observer_feedback": lambda n: {"poles": poles(n), "observer_poles": poles(n)},
    **dict.fromkeys(REGULATORS, _weights),
    "finite_horizon_lqr": lambda n: _weights(n) | {"final_time": "1"},
    "laplace_transform": lambda n: {"f": f"t^{n} exp(-t) sin(2t)"},
    "inverse_laplace_transform": lambda n: {"F": f"1/({' '.join(f'(s + {i})' for i in range(1, n + 1))})"},
    **dict.fromkeys(("discretization", "pulse_transfer_function"), lambda _: {"sample_time": "1/10"}),
    "pid_discretization": lambda _: {"K_p": "2", "K_i": "1", "K_d": "1/2", "sample_time": "1/10"},
    "ragazzini": lambda _: {"poles": "[1/2]", "sample_time": "1/10"},
    "pole_mapping": lambda n: {"poles": poles(n), "sample_time": "1/10"},
    "z_transform": lambda n: {"f": f'"k^{n}*2^k*cos(k)"'},
    "inverse_z_transform": lambda n: {"F": f"z/({' '.join(f'(z - 1/{i})' for i in range(2, n + 2))})"},
    "difference_equation": lambda _: {"input": "{u: 1}", "initial": '{"x1(0)": 1}'},
    "differential_equation": lambda _: {"input": '{u: "exp(-t)"}', "initial": "{x1: 1}"},
    "amplitude_scaling": lambda _: {"input": "{u: 1}"},
    "analog_program": lambda _: {"input": "{u: 1}", "time_scale": "100"},
    "minimum_energy_control": lambda n: {"initial_state": str([1] * n), "final_time": "1"},
}
"""What a question needs beside the plant, by the order of the plant."""

OPTIONS_BY_METHOD = {
    ("lead_compensator", "frequency_response"): {"velocity_constant": "5", "phase_margin": "45"},
    ("lead_compensator", "root_locus"): {"poles": '["-1 ± 2j"]'},
    ("lag_compensator", "frequency_response"): {"velocity_constant": "5", "phase_margin": "45"},
    ("lag_compensator", "root_locus"): {"velocity_constant": "20", "poles": '["-0.5 ± 2j"]'},
    ("lead_lag_compensator", "frequency_response"): {"velocity_constant": "20", "phase_margin": "50"},
    ("lead_lag_compensator", "root_locus"): {"velocity_constant": "20", "poles": '["-1 ± 2j"]'},
    ("pid_tuning", "pole_placement"): {"poles": "[-2, -3, -4]"},
}
"""The same of tasks whose methods need different things."""

DISCRETE_OPTIONS = {"response": {"input": "(-1)^k"}}
"""What stands in place of that in discrete time."""


def _lines(given: dict[str, str], indent: int) -> str:
    return "\n".join(f"{' ' * indent}{name}: {value}" for name, value in given.items())
