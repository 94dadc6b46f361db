"""What users and their scripts rely on: names of tasks, methods, options and answers, as documented for good."""

import pytest

from solver.tasks import catalogue

ANALYSIS, DESIGN = "Representation and analysis", "Design"
PLACING = ("coefficient_matching", "bass_gura", "canonical_form", "ackermann")
SPECIFIED = "overshoot settling_time peak_time rise_time damping_ratio natural_frequency settling_band"
# task: group, methods in order (empty: one only), options, answers
PROMISED = {
    "realization": (ANALYSIS, "", "form convention", "A B C D"),
    "transfer_function": (ANALYSIS, "adjugate faddeev_leverrier impedance", "input output", "G poles zeros cancelled"),
    "similarity_transformation": (ANALYSIS, "", "T", "A B C D"),
    "characteristic_polynomial": (ANALYSIS, "determinant faddeev_leverrier", "", "polynomial"),
    "resolvent": (ANALYSIS, "adjugate faddeev_leverrier", "", "resolvent polynomial"),
    "eigenstructure": (
        ANALYSIS, "", "", "eigenvalues right_eigenvectors left_eigenvectors jordan_form diagonalizable"
    ),
    "state_transition_matrix": (
        ANALYSIS, "laplace z_transform power_series cayley_hamilton modal", "terms convention", "Phi Phi_truncated"
    ),
    "matrix_function": (ANALYSIS, "cayley_hamilton modal", "function", "F"),
    "response": (
        ANALYSIS, "laplace convolution z_transform", "kind initial_state input", "x y y_final y_peak t_peak"
    ),
    "stability": (
        ANALYSIS, "eigenvalues lyapunov routh", "Q dual",
        "verdict bibo_stable eigenvalues P array right_half_plane_roots",
    ),
    "stability_range": (ANALYSIS, "routh eigenvalues", "parameters", "condition"),
    "phase_portrait": (ANALYSIS, "", "", "kind eigenvalues"),
    "controllability": (
        ANALYSIS, "rank pbh gramian", "horizon",
        "controllability_matrix determinant rank controllable uncontrollable_modes exceptions gramian",
    ),
    "observability": (
        ANALYSIS, "rank pbh gramian", "horizon",
        "observability_matrix determinant rank observable unobservable_modes exceptions gramian",
    ),
    "stabilizability": (ANALYSIS, "", "", "stabilizable hidden_modes condition"),
    "detectability": (ANALYSIS, "", "", "detectable hidden_modes condition"),
    "kalman_decomposition": (
        ANALYSIS, "", "part",
        "T A B C orders hidden_modes A_c B_c C_c A_o B_o C_o A_co B_co C_co",
    ),
    "parameter_condition": (ANALYSIS, "", "property parameter", "values"),
    "minimal_realization": (ANALYSIS, "", "", "A B C D cancelled"),
    "fundamental_subspaces": (
        ANALYSIS, "", "matrix", "null_space column_space row_space left_null_space rank"
    ),
    "desired_poles": (DESIGN, "", SPECIFIED, "damping_ratio natural_frequency poles polynomial"),
    "pole_placement": (
        DESIGN, " ".join((*PLACING, "unity_rank")), f"poles structure eigenvectors {SPECIFIED}",
        "K closed_loop_A polynomial gain_polynomial fixed_poles conditions eigenvectors",
    ),
    "reference_tracking": (DESIGN, "", "gain poles", "F N K_o"),
    "servo": (DESIGN, " ".join((*PLACING, "unity_rank")), "poles", "K k_I closed_loop_A"),
    "model_matching": (DESIGN, "", "target", "feasible compensator A B C K"),
    "observer": (DESIGN, " ".join((*PLACING, "unity_rank")), "poles", "L error_A polynomial gain_polynomial"),
    "reduced_observer": (
        DESIGN, "", "poles measured", "L J N M T A11 A12 A21 A22 B1 B2 A_combined B_combined"
    ),
    "observer_feedback": (
        DESIGN, "", "poles gain observer_poles observer_gain reduced", "closed_loop_A eigenvalues compensator S1 S2"
    ),
    "lqr": (
        DESIGN, "riccati hamiltonian", "Q R N output_weight tolerances initial_state cost_factor",
        "P K u Q R closed_loop_A eigenvalues cost equations solutions definiteness minimal_solution",
    ),
    "kalman_filter": (DESIGN, "riccati hamiltonian", "Q R", "P L error_A eigenvalues"),
    "optimal_tracking": (DESIGN, "", "Q R gain", "K F N K_o"),
}  # fmt: skip


GROUPS = {each.name: each.topic.group for each in catalogue().declarations()}


@pytest.mark.parametrize("name", PROMISED)
def test_a_task_keeps_its_promises(name):
    group, methods, options, answers = PROMISED[name]
    task = catalogue()[name]
    assert GROUPS[name] == group
    assert set(methods.split() or [name]) == set(task.methods)
    assert set(options.split()) <= set(task.options)
    assert set(answers.split()) <= set(task.answers)


@pytest.mark.parametrize(
    ("name", "discrete", "method"),
    [
        ("transfer_function", False, "adjugate"),
        ("characteristic_polynomial", False, "determinant"),
        ("state_transition_matrix", False, "laplace"),
        ("state_transition_matrix", True, "z_transform"),
        ("matrix_function", False, "cayley_hamilton"),
        ("response", False, "laplace"),
        ("response", True, "z_transform"),
        ("stability", False, "eigenvalues"),
        ("stability_range", False, "routh"),
        ("controllability", False, "rank"),
        ("observability", False, "rank"),
        ("pole_placement", False, "coefficient_matching"),
        ("observer", False, "coefficient_matching"),
        ("servo", False, "coefficient_matching"),
        ("lqr", False, "riccati"),
        ("kalman_filter", False, "riccati"),
    ],
)
def test_the_first_method_is_the_default(name, discrete, method):
    assert catalogue()[name].methods_for(discrete)[0] == method


@pytest.mark.parametrize(
    ("name", "option", "words"),
    [
        ("realization", "form", ("controllable", "observable", "diagonal", "jordan", "modal")),
        ("realization", "convention", ("last_row", "first_row", "subdiagonal", "superdiagonal")),
        ("response", "kind", ("complete", "zero_input", "zero_state")),
        ("kalman_decomposition", "part", ("controllable", "observable", "full")),
        ("parameter_condition", "property", ("uncontrollable", "unobservable")),
        ("desired_poles", "settling_band", ("2%", "5%")),
    ],
)
def test_choices_are_as_documented(name, option, words):
    assert catalogue()[name].options[option].kind.choices == words


def test_nothing_promised_is_left_out():
    assert set(PROMISED) <= set(catalogue())


BY_STEPS = {"P", "K", "x", "u", "T", "values"}
"""Over a finite horizon in discrete time one a step, of a compensator one a section, of a sequence one a sample."""


def answers_declared(fact):
    """The names of the answers of which something is declared, in whatever task."""
    return {answer.name for task in catalogue().values() for answer in task.answers.values() if getattr(answer, fact)}


def test_what_marking_knows_of_an_answer_is_declared_wherever_it_stands():
    counts, in_order, vectors = (answers_declared(fact) for fact in ("count", "ordered", "vectors"))
    assert counts == {
        "rank", "right_half_plane_roots", "imaginary_axis_roots", "orders", "normal_rank", "system_type",
        "encirclements", "open_loop_unstable_poles", "closed_loop_unstable_poles", "unstable_poles", "steps",
    }  # fmt: skip
    assert in_order - BY_STEPS == {
        "orders", "definiteness", "determinants", "costates", "diagonal", "invariant_factors", "relative_degrees",
        "alpha", "corner_frequencies", "slopes", "coefficients",
    }  # fmt: skip
    assert vectors == {
        "right_eigenvectors", "left_eigenvectors", "eigenvectors", "T", "null_space", "column_space", "row_space",
        "left_null_space", "zero_directions",
    }  # fmt: skip
    for task in catalogue().values():
        for answer in task.answers.values():
            assert answer.count == (answer.name in counts)
            assert answer.ordered == (answer.name in in_order) or answer.name in BY_STEPS
            assert not answer.vectors or answer.free is True
