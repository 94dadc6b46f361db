"""Observer of full order: the gain L that gives the estimation error the poles asked for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Attempt, Check, Claim, Derivation, Given, Refusal, Task, option
from solver.lazy import numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import design as judges
from solver.options.poles import Poles
from solver.stated.algebra import difference, product
from solver.tasks import consequences, meanings, mistakes
from solver.tasks.design.frames import characteristic, unknown_gains
from solver.tasks.design.full_order import observer_equation_of, observer_gain_of, observer_pole_faults
from solver.tasks.design.mapped_poles import (
    SampledPoles,
    asked_faults,
    listed,
    numeric_poles_in_z,
    poles_in_z,
    with_mapping_mistakes,
)
from solver.tasks.design.pole_options import PLACING
from solver.tasks.freedom import observer_gain_is_free
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.systems import System
    from solver.tasks.needed import WithOutput


@dataclass(frozen=True, kw_only=True)
class ObserverOptions(SampledPoles):
    """Where the estimation error has its poles."""

    poles: tuple[Expr, ...] | None = option(Poles(), "the n eigenvalues of A − LC (or those of the observable part)")


observer: Task[WithOutput, ObserverOptions] = Task(
    "observer",
    title="Observer",
    doc="x̂' = A x̂ + B u + L (y − C x̂) with a gain L that gives the error x − x̂ the poles asked for.",
    needs=("A", "C"),
    options=ObserverOptions,
    answers=[
        AnswerName(
            "L",
            r"\sym{L}",
            "the gain of the observer",
            free=observer_gain_is_free,
            principal=True,
            earned=PLACING,
        ),
        AnswerName("error_A", r"A - \sym{L} C", "the matrix of the estimation error", free=observer_gain_is_free),
        AnswerName("polynomial", r"\hat{p}", "the characteristic polynomial of the estimation error"),
        AnswerName(
            "gain_polynomial",
            "p_l",
            "the characteristic polynomial of the error with the unknown entries $l_{1}$, $l_{2}$, … of the gain",
            ("coefficient_matching",),
            optional=True,
            told=("gain_polynomial",),
        ),
    ],
    example={"poles": "[-4, -5]"},
)


@observer.refusal
def has_another_number_of_poles(system: System, options: ObserverOptions) -> Iterator[Refusal]:
    """Neither n poles, nor as many as the observable part has; poles in s where they cannot be mapped."""
    wrong = [*asked_faults(system, options)]
    yield from wrong
    name, poles = listed(options)
    if not wrong and isinstance(system, systems.StateSpace) and poles is not None:
        yield from observer_pole_faults(system, poles, name)


def _designed(given: Given[WithOutput, ObserverOptions]) -> Derivation[Answers]:
    """The gain by the method of the same name for the dual pair (Aᵀ, Cᵀ), written for (A, C)."""
    poles = yield from poles_in_z(given)
    found = yield from observer_gain_of(given.system, poles, given.method)
    yield from observer_equation_of(given.system, found)
    answers = Answers(L=found.K, error_A=found.loop, polynomial=found.polynomial)
    if given.method == "coefficient_matching" and found.gain_polynomial is not None:
        answers["gain_polynomial"] = found.gain_polynomial
    return answers


@observer.method("coefficient_matching", title="Comparison of coefficients", source="Lecture note, section 4.1")
def by_coefficient_matching(given: Given[WithOutput, ObserverOptions]) -> Derivation[Answers]:
    """The coefficients of det(sI − A + LC), with L unknown, are those of the polynomial asked for."""
    return (yield from _designed(given))


@observer.method("bass_gura", title="Formula of Bass and Gura", source="Lecture note, section 4.1, by duality")
def by_bass_gura(given: Given[WithOutput, ObserverOptions]) -> Derivation[Answers]:
    """L = (Wᵀ 𝒪)⁻¹ (â − a)."""
    return (yield from _designed(given))


@observer.method("canonical_form", title="Observable canonical form", source="Lecture note, section 4.1, by duality")
def by_canonical_form(given: Given[WithOutput, ObserverOptions]) -> Derivation[Answers]:
    """In observable canonical form the gain is read off and transformed back."""
    return (yield from _designed(given))


@observer.method("ackermann", title="Ackermann's formula", source="J. Ackermann (1972), by duality")
def by_ackermann(given: Given[WithOutput, ObserverOptions]) -> Derivation[Answers]:
    """L = p̂(A) 𝒪⁻¹ (0, …, 0, 1)ᵀ."""
    return (yield from _designed(given))


@observer.method("unity_rank", title="Gain of rank one", source="C.-T. Chen, Linear System Theory and Design, 8.6")
def by_unity_rank(given: Given[WithOutput, ObserverOptions]) -> Derivation[Answers]:
    """Several outputs combined to one, L = l g."""
    return (yield from _designed(given))


@observer.verification("L", "error_A", "polynomial")
def has_the_poles(given: Given[WithOutput, ObserverOptions], answers: Answers) -> Iterable[Check]:
    """A − LC has the eigenvalues asked for, beside those that no gain moves."""
    A, C, poles = given.system.A, given.system.C, numeric_poles_in_z(given)
    At, Ct = sp.ImmutableMatrix(A.T), sp.ImmutableMatrix(C.T)
    if "L" in answers:
        yield numeric.check_residual(
            r"$A - \sym{L} C$ has the poles asked for",
            "characteristic polynomial",
            lambda: judges.placed_residual(At, Ct, sp.ImmutableMatrix(answers["L"].T), poles),
            answer="L",
        )
    if "error_A" in answers:
        yield from _is_the_error_matrix(given, answers)
    if "polynomial" in answers:
        x = sp.Symbol("z" if given.system.discrete else "s")
        yield numeric.check_residual(
            "the polynomial has the poles asked for",
            "characteristic polynomial of its companion matrix",
            lambda: judges.placed_matrix_residual(At, Ct, _companion(answers["polynomial"], x, A.rows), poles),
            answer="polynomial",
        )


def _is_the_error_matrix(given: Given[WithOutput, ObserverOptions], answers: Answers) -> Iterator[Check]:
    """A matrix A − LC for some L, with the poles asked for; for the submitted L, if there is one."""
    A, C, error = given.system.A, given.system.C, answers["error_A"]
    At, Ct = sp.ImmutableMatrix(A.T), sp.ImmutableMatrix(C.T)
    yield numeric.check_residual(
        "the error has the poles asked for",
        "characteristic polynomial",
        lambda: judges.placed_matrix_residual(At, Ct, sp.ImmutableMatrix(error.T), numeric_poles_in_z(given)),
        answer="error_A",
    )
    if error.shape == A.shape:
        yield numeric.check_residual(
            r"it is $A - \sym{L} C$ for some $\sym{L}$",
            "numpy.linalg.pinv",
            lambda: judges.row_space_residual(sp.ImmutableMatrix(A - error), C),
            answer="error_A",
        )
    if "L" in answers and C.rows > 1:
        claim = Claim(difference(A, product(answers["L"], C)), error)
        yield numeric.check_claim(claim, r"it belongs to $\sym{L}$", answer="error_A")


def _companion(polynomial: Expr, x: Any, n: int) -> ImmutableMatrix:
    """The companion matrix of a monic polynomial of degree n; an empty matrix for any other."""
    poly = sp.Poly(polynomial, x)
    if poly.degree() != n or poly.LC() != 1:
        return sp.ImmutableMatrix(0, 0, [])
    c = poly.all_coeffs()
    return sp.ImmutableMatrix(n, n, lambda i, j: -c[n - j] if i == n - 1 else sp.Integer(int(j == i + 1)))


@observer.verification("gain_polynomial")
def is_the_determinant(given: Given[WithOutput, ObserverOptions], answers: Answers) -> Iterable[Check]:
    """det(sI − A + LC) at random values of s and of the entries of L."""
    A, C = given.system.A, given.system.C
    x = sp.Symbol("z" if given.system.discrete else "s")
    unknowns = unknown_gains((A.T, C.T), numeric_poles_in_z(given), dual=True)
    L = sp.ImmutableMatrix(list(unknowns))
    claim = Claim(characteristic(sp.ImmutableMatrix(A - L * C), x), answers["gain_polynomial"])
    yield numeric.check_claim(claim, r"$\det(sI - A + LC)$ with unknown gain")


observer.consequence("error_A", of=("L",))(consequences.error_matrix)
observer.consequence("polynomial", of=("error_A",))(consequences.polynomial_of("error_A"))


observer.mistaken_question(mistakes.EXCHANGED)(mistakes.inputs_for_outputs)


observer.mistake(mistakes.ADDED, "error_A")(mistakes.plus_for_minus)
observer.mistake(mistakes.OBSERVER_ADDED, "L")(mistakes.negative)


with_mapping_mistakes(observer)


@observer.meaning("L", "error_A", "polynomial")
def poles_of_the_error(wrong: Attempt[WithOutput, ObserverOptions]) -> Reason | None:
    """The poles that the gain, the matrix of the error or the polynomial has."""
    plant, asked = wrong.given.system, numeric_poles_in_z(wrong.given)
    if wrong.name == "polynomial":
        return meanings.roots_given(wrong.value, sp.Symbol("z" if plant.discrete else "s"), asked)
    return meanings.poles_given(wrong.value if wrong.name == "error_A" else plant.A - wrong.value * plant.C, asked)
