"""Current observer: the estimate is corrected by the output of the same instant, x̂ = x̄ + L (y − C x̄)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Claim,
    Derivation,
    Given,
    Refusal,
    Slip,
    Task,
    option,
)
from solver.lazy import numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import design as judges
from solver.options.poles import Poles
from solver.stated.algebra import difference, product
from solver.tasks import meanings, mistakes
from solver.tasks.design.mapped_poles import (
    SampledPoles,
    asked_faults,
    listed,
    numeric_poles_in_z,
    poles_in_z,
    with_mapping_mistakes,
)
from solver.tasks.design.pole_options import PLACING
from solver.tasks.digital.current_order import (
    current_gain_of,
    current_pole_faults,
    error_of,
    prediction_of,
    shown_next,
)
from solver.tasks.freedom import current_gain_is_free
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import System
    from solver.tasks.needed import WithOutput

PREDICTOR = Slip(
    "predictor_gain", r"it is the gain of the prediction observer, $A\sym{L}$; the current observer has $\sym{L}$"
)
CURRENT = Slip("current_gain", r"it is the gain of the current observer; the prediction observer has $A\sym{L}$")
ERROR_OF_PREDICTOR = Slip(
    "predictor_error", r"it is $A - \sym{L}C$, as of a prediction observer; here it is $(I - \sym{L}C)A$"
)
ORDER = Slip("order_of_factors", r"it is $A(I - \sym{L}C)$; the error is corrected last, $(I - \sym{L}C)A$")


@dataclass(frozen=True, kw_only=True)
class CurrentObserverOptions(SampledPoles):
    """Where the estimation error has its poles."""

    poles: tuple[Expr, ...] | None = option(
        Poles(), "the n eigenvalues of (I − LC) A (or those that the gain can move)"
    )


current_observer: Task[WithOutput, CurrentObserverOptions] = Task(
    "current_observer",
    title="Current observer",
    doc="x̂ = x̄ + L (y − C x̄), x̄ = A x̂ + B u, with a gain L that gives the error x − x̂ the poles asked for.",
    needs=("A", "C"),
    options=CurrentObserverOptions,
    answers=[
        AnswerName(
            "L",
            r"\sym{L}",
            r"the gain of the current observer, $\hat{x} = \bar{x} + \sym{L}(y - C\bar{x})$",
            free=current_gain_is_free,
            principal=True,
            earned=PLACING,
        ),
        AnswerName(
            "L_prediction",
            r"L_{\text{p}}",
            "the gain of the prediction observer with the same poles",
            free=current_gain_is_free,
            principal=True,
            earned=("prediction",),
        ),
        AnswerName(
            "error_A",
            r"(I - \sym{L}C)A",
            "the matrix of the estimation error",
            free=current_gain_is_free,
            earned=("equation",),
        ),
    ],
    example={"time": "discrete", "poles": '["0.4 ± 0.2j"]'},
)


@current_observer.refusal
def has_another_number_of_poles(system: System, options: CurrentObserverOptions) -> Iterator[Refusal]:
    """Neither n poles, nor as many as the gain can move; poles in s where they cannot be mapped."""
    wrong = [*asked_faults(system, options)]
    yield from wrong
    name, poles = listed(options)
    if not wrong and isinstance(system, systems.StateSpace) and poles is not None:
        yield from current_pole_faults(system, poles, name)


def _designed(given: Given[WithOutput, CurrentObserverOptions]) -> Derivation[Answers]:
    """The gain by the method of the same name for the pair (A, CA), and the prediction observer beside it."""
    poles = yield from poles_in_z(given)
    found = yield from current_gain_of(given.system, poles, given.method)
    yield from error_of(given.system, found)
    L_p = yield from prediction_of(given.system, found)
    return Answers(L=found.K, L_prediction=L_p, error_A=found.loop)


SOURCE = "Franklin, Powell and Workman, Digital Control of Dynamic Systems, section 8.2.4"


@current_observer.method("coefficient_matching", title="Comparison of coefficients", source=SOURCE, time="discrete")
def by_coefficient_matching(given: Given[WithOutput, CurrentObserverOptions]) -> Derivation[Answers]:
    """The coefficients of det(zI − A + LCA), with L unknown, are those of the polynomial asked for."""
    return (yield from _designed(given))


@current_observer.method("bass_gura", title="Formula of Bass and Gura", source=SOURCE, time="discrete")
def by_bass_gura(given: Given[WithOutput, CurrentObserverOptions]) -> Derivation[Answers]:
    """L = (Wᵀ 𝒪̄)⁻¹ (â − a) with 𝒪̄ of the pair (A, CA)."""
    return (yield from _designed(given))


@current_observer.method("canonical_form", title="Observable canonical form", source=SOURCE, time="discrete")
def by_canonical_form(given: Given[WithOutput, CurrentObserverOptions]) -> Derivation[Answers]:
    """In observable canonical form of (A, CA) the gain is read off and transformed back."""
    return (yield from _designed(given))


@current_observer.method("ackermann", title="Ackermann's formula", source=SOURCE, time="discrete")
def by_ackermann(given: Given[WithOutput, CurrentObserverOptions]) -> Derivation[Answers]:
    """L = p̂(A) 𝒪̄⁻¹ (0, …, 0, 1)ᵀ, 𝒪̄ with the rows CA, CA², …."""
    return (yield from _designed(given))


@current_observer.method("unity_rank", title="Gain of rank one", source=SOURCE, time="discrete")
def by_unity_rank(given: Given[WithOutput, CurrentObserverOptions]) -> Derivation[Answers]:
    """Several outputs combined to one, L = l g."""
    return (yield from _designed(given))


@current_observer.verification("L", "L_prediction", "error_A")
def has_the_poles(given: Given[WithOutput, CurrentObserverOptions], answers: Answers) -> Iterable[Check]:
    """(I − LC) A and A − L_p C have the eigenvalues asked for, beside those that no gain moves."""
    A, C, poles = given.system.A, given.system.C, numeric_poles_in_z(given)
    At, shown = sp.ImmutableMatrix(A.T), sp.ImmutableMatrix(C * A)
    identity, errors = sp.eye(A.rows), {}
    if "L" in answers:
        fits = answers["L"].shape == (A.rows, C.rows)
        errors["L"] = sp.ImmutableMatrix((identity - answers["L"] * C) * A) if fits else sp.ImmutableMatrix(0, 0, [])
    if "L_prediction" in answers:
        L_p = answers["L_prediction"]
        fits = L_p.shape == (A.rows, C.rows)
        errors["L_prediction"] = sp.ImmutableMatrix(A - L_p * C) if fits else sp.ImmutableMatrix(0, 0, [])
    if "error_A" in answers:
        errors["error_A"] = answers["error_A"]
    labels = {"L": r"$(I - \sym{L}C)A$ has the poles asked for", "L_prediction": "$A - L_pC$ has the poles asked for"}
    for name, error in errors.items():
        yield numeric.check_residual(
            labels.get(name, "the error has the poles asked for"),
            "characteristic polynomial",
            partial(
                judges.placed_matrix_residual,
                At,
                sp.ImmutableMatrix(shown.T),
                sp.ImmutableMatrix(error.T),
                poles,
            ),
            answer=name,
        )
    if "error_A" in answers:
        yield from _is_the_error_matrix(given, answers)


def _is_the_error_matrix(given: Given[WithOutput, CurrentObserverOptions], answers: Answers) -> Iterator[Check]:
    """A matrix (I − LC) A for some L; for the submitted L, if there is one."""
    A, C, error = given.system.A, given.system.C, answers["error_A"]
    if error.shape != A.shape:
        return
    yield numeric.check_residual(
        r"it is $(I - \sym{L}C)A$ for some $\sym{L}$",
        "numpy.linalg.pinv",
        lambda: judges.row_space_residual(sp.ImmutableMatrix(A - error), sp.ImmutableMatrix(C * A)),
        answer="error_A",
    )
    L = answers.get("L")
    if L is not None and L.shape == (A.rows, C.rows):
        identity = sp.ImmutableMatrix(sp.eye(A.rows))
        claim = Claim(product(difference(identity, product(L, C)), A), error)
        yield numeric.check_claim(claim, r"it belongs to $\sym{L}$", answer="error_A")


@current_observer.consequence("error_A", of=("L",))
def error_of_the_gain(given: Given[WithOutput, CurrentObserverOptions], found: Mapping[str, Any]) -> Any:
    """(I − LC) A."""
    return sp.ImmutableMatrix(given.system.A - found["L"] * shown_next(given.system))


@current_observer.consequence("L_prediction", of=("L",))
def prediction_of_the_gain(given: Given[WithOutput, CurrentObserverOptions], found: Mapping[str, Any]) -> Any:
    """A L."""
    return sp.ImmutableMatrix(given.system.A * found["L"])


current_observer.mistaken_question(mistakes.EXCHANGED)(mistakes.inputs_for_outputs)


@current_observer.mistake(PREDICTOR, "L")
def gain_of_the_predictor(wrong: Attempt[WithOutput, CurrentObserverOptions]) -> Iterable[Any]:
    """A L in place of L."""
    yield wrong.answers["L_prediction"]


@current_observer.mistake(CURRENT, "L_prediction")
def gain_of_the_current_observer(wrong: Attempt[WithOutput, CurrentObserverOptions]) -> Iterable[Any]:
    """L in place of A L."""
    yield wrong.answers["L"]


@current_observer.mistake(ERROR_OF_PREDICTOR, "error_A")
def error_of_a_predictor(wrong: Attempt[WithOutput, CurrentObserverOptions]) -> Iterable[Any]:
    """A − LC with the gain of the current observer."""
    yield wrong.given.system.A - wrong.answers["L"] * wrong.given.system.C


@current_observer.mistake(ORDER, "error_A")
def factors_turned_round(wrong: Attempt[WithOutput, CurrentObserverOptions]) -> Iterable[Any]:
    """A (I − LC)."""
    yield wrong.given.system.A - wrong.answers["L_prediction"] * wrong.given.system.C


current_observer.mistake(mistakes.ADDED, "error_A")(mistakes.plus_for_minus)


with_mapping_mistakes(current_observer)


@current_observer.meaning("L", "L_prediction", "error_A")
def poles_of_the_error(wrong: Attempt[WithOutput, CurrentObserverOptions]) -> Reason | None:
    """The poles that the gain or the matrix of the error has."""
    plant, value = wrong.given.system, wrong.value
    errors = {
        "L": lambda: plant.A - value * shown_next(plant),
        "L_prediction": lambda: plant.A - value * plant.C,
        "error_A": lambda: value,
    }
    return meanings.poles_given(errors[wrong.name](), numeric_poles_in_z(wrong.given))
