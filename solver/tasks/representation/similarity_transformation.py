"""A change of coordinates x = T ξ, and what it leaves as it is."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from solver.arithmetic.inverses import inverted
from solver.arithmetic.products import multiplied
from solver.derivation import (
    AnswerName,
    Answers,
    Check,
    Claim,
    Derivation,
    Given,
    Refusal,
    Step,
    Task,
    option,
    state_equations,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.options.matrix import MatrixOf
from solver.stated.algebra import difference, product, quotient
from solver.stated.matrices import adjugate, determinant, inverse
from solver.tasks.plant_options import PlantOptions
from solver.tasks.representation.plants import matrices_of, stated_transfer, variable_of
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.systems import StateSpace, System


@dataclass(frozen=True, kw_only=True)
class SimilarityTransformationOptions(PlantOptions):
    """The new coordinates."""

    T: ImmutableMatrix = option(MatrixOf("n", "n"), "the matrix T of x = T ξ, invertible", required=True)


similarity_transformation: Task[StateSpace, SimilarityTransformationOptions] = Task(
    "similarity_transformation",
    title="Similarity transformation",
    doc="The same system in other coordinates ξ, x = T ξ: T⁻¹ A T, T⁻¹ B, C T and D.",
    needs=("A",),
    options=SimilarityTransformationOptions,
    answers=[
        AnswerName("A", r"\bar{A}", "$T^{-1}AT$", principal=True, earned=("inverse",)),
        AnswerName("B", r"\bar{B}", "$T^{-1}B$", optional=True, principal=lambda system: "B" in system.provides),
        AnswerName("C", r"\bar{C}", "$CT$", optional=True, principal=lambda system: "C" in system.provides),
        AnswerName("D", r"\bar{D}", "$D$, as before", optional=True),
    ],
)
similarity_transformation.together(state_equations(r"\xi"))


@similarity_transformation.refusal
def of_a_matrix_that_is_no_change_of_coordinates(
    system: System,  # noqa: ARG001 - T alone decides
    options: SimilarityTransformationOptions,
) -> Iterable[Refusal]:
    """T is square and has an inverse."""
    T = options.T
    if T is None:
        return
    if T.rows != T.cols:
        yield "T", Reason("representation/size_of_T", {"rows": T.rows, "columns": T.cols})
    elif exact.is_singular(T):
        yield "T", Reason("representation/singular_T")


@similarity_transformation.method(source="Lecture note, equation (1.14.2)")
def by_products(given: Given[StateSpace, SimilarityTransformationOptions]) -> Derivation[Answers]:
    """ξ' = T⁻¹ A T ξ + T⁻¹ B u, y = C T ξ + D u."""
    plant, T = given.system, given.options.T
    det, adj, T_inverse = exact.inverse_in_full(T)
    yield Step(
        "inverse",
        claims={
            "determinant": Claim(determinant(T), det, r"$\det T$"),
            "adjugate": Claim(adjugate(T), adj, r"$\operatorname{adj} T$"),
            "inverse": Claim(inverse(T), T_inverse, "$T^{-1}$"),
        },
        steps=inverted("T", T, T_inverse),
        T=T,
        det=det,
        adj=quotient(adj, det),
    )
    AT = exact.product_of(plant.A, T)
    moved = Answers(A=exact.product_of(T_inverse, AT))
    yield Step(
        "system_matrix",
        claims={
            "AT": Claim(product(plant.A, T), AT, "$A T$"),
            "A": Claim(product(inverse(T), plant.A, T), moved["A"], "$T^{-1} A T$"),
        },
        steps=(*multiplied(plant.A, T, AT), *multiplied(T_inverse, AT, moved["A"])),
        inverted=T_inverse,
        AT=AT,
        discrete=plant.discrete,
    )
    others, claims = Answers(), {}
    lines: tuple[Step, ...] = ()
    if plant.B is not None:
        others["B"] = exact.product_of(T_inverse, plant.B)
        lines += multiplied(T_inverse, plant.B, others["B"])
        claims["B"] = Claim(product(inverse(T), plant.B), others["B"], "$T^{-1} B$")
    if plant.C is not None:
        others["C"] = exact.product_of(plant.C, T)
        lines += multiplied(plant.C, T, others["C"])
        claims["C"] = Claim(product(plant.C, T), others["C"], "$C T$")
    if claims:
        yield Step(
            "input_and_output", claims=claims, steps=lines, inverted=T_inverse, B=plant.B, C=plant.C, T=T, D=plant.D
        )
    if plant.B is not None and plant.C is not None:
        others["D"] = matrices_of(plant)[3]
    moved.update(others)
    yield _unchanged(plant, moved)
    return moved


def _unchanged(plant: StateSpace, moved: Answers) -> Step:
    """det(xI − Ā) = det(xI − A), and G is the same."""
    x, A = variable_of(plant), moved["A"]
    chi = exact.faddeev_leverrier(plant.A).characteristic_polynomial(x)
    pencil = difference(product(x, sp.ImmutableMatrix(sp.eye(A.rows))), A)
    claims = {"polynomial": Claim(determinant(pencil), chi, "the characteristic polynomial is unchanged")}
    if "D" in moved:
        G = exact.transfer_matrix(*matrices_of(plant), x)
        there = stated_transfer(_in_new_coordinates(plant, moved), x)
        claims["transfer"] = Claim(there, _plain(G.matrix), "the transfer function is unchanged")
    return Step("unchanged", claims=claims, x=x, discrete=plant.discrete)


def _in_new_coordinates(plant: StateSpace, moved: Mapping[str, Any]) -> StateSpace:
    return replace(plant, **{name: moved[name] for name in ("A", "B", "C", "D")})


def _plain(M: Any) -> Any:
    return M[0, 0] if M.shape == (1, 1) else M


@similarity_transformation.verification("A")
def commutes_with_the_transformation(
    given: Given[StateSpace, SimilarityTransformationOptions], answers: Answers
) -> Iterable[Check]:
    """T Ā = A T, with no inverse in it."""
    left, right = product(given.options.T, answers["A"]), product(given.system.A, given.options.T)
    yield numeric.check_claim(Claim(left, right), r"$T\bar{A} = AT$")


@similarity_transformation.verification("B", "C", "D")
def give_the_same_input_and_output(
    given: Given[StateSpace, SimilarityTransformationOptions], answers: Answers
) -> Iterable[Check]:
    """T B̄ = B, C̄ = C T, D̄ = D."""
    plant, T = given.system, given.options.T
    if "B" in answers:
        yield numeric.check_claim(Claim(product(T, answers["B"]), plant.B), r"$T\bar{B} = B$", answer="B")
    if "C" in answers:
        yield numeric.check_claim(Claim(answers["C"], product(plant.C, T)), r"$\bar{C} = CT$", answer="C")
    if "D" in answers:
        yield numeric.check_claim(Claim(answers["D"], matrices_of(plant)[3]), r"$\bar{D} = D$", answer="D")
