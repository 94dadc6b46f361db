"""Every task solved with all checks: what the derivations find, the oracles accept, on systems of every kind."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from solver.tasks import catalogue
from tests.helpers.asking import ask
from tests.helpers.comparing import systems_tried
from tests.helpers.strategies import plain_plants, plants, poles_of

t, k, s, A = sp.symbols("t k s A")
SIGNALS = [sp.S.One, t, sp.exp(-t), sp.sin(2 * t), t * sp.exp(-2 * t), sp.cos(t)]
SEQUENCES = [sp.S.One, k, sp.Rational(1, 2) ** k, (-1) ** k]
FUNCTIONS = [A**5, 1 / A, sp.exp(A * t), sp.sqrt(A), sp.sin(A)]
FORMS = ["controllable", "observable", "diagonal", "jordan", "modal"]
ABOUT_OTHER_THINGS = {"parameter_condition", "stability_range", "desired_poles"}
"""Tasks about parameters, or about no plant."""


def options(task, plant, draw):
    """What a question of the task needs, drawn at random."""
    n, m, p, discrete = plant.order, plant.B.cols, plant.C.rows, plant.discrete
    identities = {"Q": sp.ImmutableMatrix(sp.eye(n)), "R": sp.ImmutableMatrix(sp.eye(m))}
    reduced = n > p and draw(st.booleans())
    made = {
        "response": lambda: {
            "input": tuple(draw(st.sampled_from(SEQUENCES if discrete else SIGNALS)) for _ in range(m)),
            "initial_state": sp.ImmutableMatrix([draw(st.integers(-1, 1)) for _ in range(n)]),
            "kind": draw(st.sampled_from(["complete", "zero_input", "zero_state"])),
        },
        "matrix_function": lambda: {"function": draw(st.sampled_from(FUNCTIONS))},
        "realization": lambda: {"form": draw(st.sampled_from(FORMS))},
        "similarity_transformation": lambda: {"T": sp.ImmutableMatrix(2 * sp.eye(n))},
        "kalman_decomposition": lambda: {"part": draw(st.sampled_from(["controllable", "observable", "full"]))},
        "servo": lambda: {"poles": draw(poles_of(n + p, discrete))},
        "reduced_observer": lambda: {"poles": draw(poles_of(max(n - p, 1), discrete))},
        "observer_feedback": lambda: {
            "poles": draw(poles_of(n, discrete)),
            "observer_poles": draw(poles_of(n - p if reduced else n, discrete)),
            "reduced": reduced,
        },
        "lqr": lambda: identities,
        "optimal_tracking": lambda: identities,
        "kalman_filter": lambda: {**identities, "R": sp.ImmutableMatrix(sp.eye(p))},
        "model_matching": lambda: {"target": 1 / sp.prod([s - pole for pole in draw(poles_of(2))])},
    }
    placed = ("pole_placement", "reference_tracking", "observer")
    return {"poles": draw(poles_of(n, discrete))} if task in placed else made.get(task, dict)()


ANY = st.one_of(
    plain_plants(4),
    plants(4, discrete=None).map(lambda made: made.system),
    plants(4, discrete=None, inputs=1, outputs=1, hidden=False).map(lambda made: made.system),
)


@pytest.mark.parametrize("task", sorted(set(catalogue()) - ABOUT_OTHER_THINGS))
@systems_tried(5)
@given(ANY, st.data())
def test_no_answer_of_ours_is_called_wrong(task, plant, data):
    methods = catalogue()[task].methods_for(plant.discrete)
    if not methods or (task == "phase_portrait" and plant.order != 2):
        return
    result = ask(task, plant, data.draw(st.sampled_from(methods)), **options(task, plant, data.draw))
    assert result.status in (Status.VERIFIED, Status.UNSOLVED), [c for c in result.checks if c.status.name == "FAILED"]
    assert "no check" not in str(result.reason)
