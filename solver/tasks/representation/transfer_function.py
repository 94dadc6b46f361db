"""The transfer function G = C (sI − A)⁻¹ B + D, in discrete time in z."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Attempt, Check, Claim, Derivation, Given, Step, Task, lemma, option
from solver.lazy import exact, numeric, systems
from solver.lazy import sympy as sp
from solver.matrices import entry_alone
from solver.numeric.judges import representation as judges
from solver.options.channel import Channel
from solver.stated.algebra import power, product, quotient, total
from solver.tasks import meanings, mistakes
from solver.tasks.linear_algebra.characteristic_polynomial import recursion_of, shows_its_factors
from solver.tasks.linear_algebra.resolvent import adjugate_of_pencil
from solver.tasks.modelling import circuit_mistakes
from solver.tasks.plant_options import LoopOptions
from solver.tasks.representation.lowest_terms import fractions_of, lowest_terms_of, rows_as_matrix
from solver.tasks.representation.plants import (
    chosen_channel,
    matrices_of,
    numbers_of,
    shown_channel,
    stated_matrix,
    stated_transfer,
    variable_of,
)
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.systems import StateSpace
    from solver.tasks.needed import InputOutput


@dataclass(frozen=True, kw_only=True)
class TransferFunctionOptions(LoopOptions):
    """The channel of interest."""

    input: int | None = option(Channel("input"), "the input, where only one is of interest")
    output: int | None = option(Channel("output"), "the output, where only one is of interest")


transfer_function: Task[InputOutput, TransferFunctionOptions] = Task(
    "transfer_function",
    title="Transfer function",
    doc="The transfer function (several inputs or outputs: transfer matrix) from u to y, its poles and its zeros.",
    needs=("transfer_function",),
    options=TransferFunctionOptions,
    answers=[
        AnswerName(
            "G",
            "G",
            "the transfer function $C(sI - A)^{-1}B + D$, in lowest terms",
            principal=True,
            earned=("numerator", "quotient", "coefficients", "poles_zeros"),
        ),
        AnswerName("poles", "p_i", "the poles", optional=True, earned=("poles_zeros",)),
        AnswerName("zeros", "z_i", "the zeros (with several inputs or outputs: the transmission zeros)", optional=True),
        AnswerName("cancelled", r"\text{cancelled}", "the modes of the system that $G$ does not show", optional=True),
    ],
)


@transfer_function.method("adjugate", title="Adjugate over determinant", source="Lecture note, equation (1.11.3)")
def by_adjugate(given: Given[InputOutput, TransferFunctionOptions]) -> Derivation[Answers]:
    """G = (C adj(sI − A) B + det(sI − A) D)/det(sI − A)."""
    plant = yield from shown_channel(given)
    if isinstance(plant, systems.TransferFunction):
        G = yield from fractions_of(plant)
    else:
        G = yield from transfer_function_of(plant)
    return (yield from lowest_terms_of(G, given_as_fraction=isinstance(plant, systems.TransferFunction)))


@transfer_function.method(
    "faddeev_leverrier", title="Faddeev–LeVerrier algorithm", source="Gantmacher, The Theory of Matrices I, IV §5"
)
def by_faddeev_leverrier(given: Given[InputOutput, TransferFunctionOptions]) -> Derivation[Answers]:
    """G = (C N₀ B s^{n−1} + … + C Nₙ₋₁ B)/χ(s) + D, with the Nₖ and χ of the recursion."""
    plant = yield from shown_channel(given)
    if isinstance(plant, systems.TransferFunction):
        G = yield from fractions_of(plant)
        return (yield from lowest_terms_of(G, given_as_fraction=True))
    x, (A, B, C, D) = variable_of(plant), matrices_of(plant)
    resolvent = yield from recursion_of(A)
    G = exact.transfer_matrix(A, B, C, D, x)
    coefficients = [exact.multiply(exact.multiply(C, N), B) for N in resolvent.adjugate_coefficients]
    strictly = rows_as_matrix(G.strictly_proper_numerators)
    powers = [
        product(entry_alone(M), power(x, A.rows - 1 - k)) for k, M in enumerate(coefficients) if not M.is_zero_matrix
    ]
    yield Step(
        "coefficients",
        claims={
            **{
                f"coefficient{k}": Claim(product(C, N, B), entry_alone(M), f"$C N_{k} B$")
                for k, (N, M) in enumerate(zip(resolvent.adjugate_coefficients, coefficients, strict=True))
            },
            "sum": Claim(
                total(*powers) if powers else entry_alone(strictly), entry_alone(strictly), "numerator, by powers"
            ),
        },
        x=x,
        n=A.rows,
    )
    yield from _quotient_of(plant, G, strictly)
    return (yield from lowest_terms_of(G))


@transfer_function.method(
    "impedance",
    title="Impedances and nodal analysis",
    source="Desoer and Kuh, Basic Circuit Theory, chapters 7 and 10",
    system="circuit",
    needs=("impedances",),
)
def by_impedances(given: Given[InputOutput, TransferFunctionOptions]) -> Derivation[Answers]:
    """The quotient that nodal analysis finds, in lowest terms."""
    plant = chosen_channel(given)
    assert isinstance(plant, systems.TransferFunction)  # noqa: S101 - what the method needs is one
    G = exact.transfer_matrix_of_fractions(plant.numerators, plant.denominators, plant.variable)
    return (yield from lowest_terms_of(G, given_as_fraction=True))


@lemma("transfer_function")
def transfer_function_of(plant: StateSpace) -> Derivation[exact.TransferMatrix]:
    """G = (C adj(xI − A) B + det(xI − A) D)/det(xI − A), not cancelled."""
    x, (A, B, C, D) = variable_of(plant), matrices_of(plant)
    direct = D is not None and not D.is_zero_matrix
    adj = yield from adjugate_of_pencil(A, x, for_its="both" if direct else "factors")
    G = exact.transfer_matrix(A, B, C, D, x)
    right = sp.ImmutableMatrix((adj * B).applyfunc(sp.expand))
    strictly = rows_as_matrix(G.strictly_proper_numerators)
    factors = (C, adj, B) if A.rows > 1 else (C, B)
    yield Step(
        "numerator",
        claims={
            "right": Claim(product(adj, B), right, r"$\operatorname{adj}(" + str(x) + r"I - A)\,B$"),
            "product": Claim(product(*factors), entry_alone(strictly), "numerator"),
        },
        x=x,
        n=A.rows,
        right=right,
        C=C,
        G=entry_alone(G.matrix),
    )
    yield from _quotient_of(plant, G, strictly, factored=True)
    return G


@lemma("transfer_function")
def _quotient_of(
    plant: StateSpace, G: exact.TransferMatrix, strictly: ImmutableMatrix, *, factored: bool = False
) -> Derivation[None]:
    """The numerator of C (xI − A)⁻¹ B over χ, D brought over the same denominator."""
    x, D, N, chi = G.variable, plant.D, rows_as_matrix(G.numerators), G.chi
    if D is not None and not D.is_zero_matrix:
        with_D = total(entry_alone(strictly), product(G.chi, entry_alone(D)))
        yield Step(
            "through", claims={"sum": Claim(with_D, entry_alone(N), "numerator with $D$")}, x=x, D=entry_alone(D)
        )
    elif factored and shows_its_factors(plant.A, x):  # what was seen as a product stays one
        chi = exact.factored(plant.A, x)
    yield Step(
        "quotient",
        claims={"G": Claim(stated_transfer(plant, x), quotient(entry_alone(N), chi), f"$G({x})$")},
        x=x,
    )


@transfer_function.verification("G")
def has_the_values_of_the_formula(
    given: Given[InputOutput, TransferFunctionOptions], answers: Answers
) -> Iterable[Check]:
    """G(s) = C (sI − A)⁻¹ B + D at random s, the inverse by numpy."""
    plant = chosen_channel(given)
    label = Phrase("$G({x}) = C({x}I - A)^{{-1}}B + D$ at random points", x=variable_of(plant))
    yield numeric.check_claim(Claim(stated_matrix(plant), answers["G"]), label)


@transfer_function.verification("poles", "zeros", "cancelled")
def are_those_of_the_minimal_part(
    given: Given[InputOutput, TransferFunctionOptions], answers: Answers
) -> Iterable[Check]:
    """The poles are the eigenvalues of the minimal part, zeros those of its system matrix, what is left cancelled."""
    plant = numbers_of(chosen_channel(given))
    residuals = {
        "poles": (r"the poles are the eigenvalues of the minimal part", judges.pole_residual),
        "zeros": (r"the zeros are where the minimal part blocks", judges.zero_residual),
        "cancelled": (r"poles and cancelled modes make up $\det(sI - A)$", judges.cancelled_residual),
    }
    for name, (label, residual) in residuals.items():
        if name in answers:
            check = partial(residual, plant, list(answers[name]))
            yield numeric.check_residual(label, "orthogonal bases (50 digits)", check, answer=name)


@transfer_function.consequence("poles", of=("G",), symbolic=False)
def poles_of_the_fraction(given: Given[InputOutput, TransferFunctionOptions], found: Mapping[str, Any]) -> Any:
    """The poles of G as it is found."""
    return _fractions(given, found["G"]).poles


@transfer_function.consequence("zeros", of=("G",), symbolic=False)
def zeros_of_the_fraction(given: Given[InputOutput, TransferFunctionOptions], found: Mapping[str, Any]) -> Any:
    """The zeros of G as it is found."""
    return _fractions(given, found["G"]).zeros


def _fractions(given: Given[InputOutput, TransferFunctionOptions], G: Any) -> exact.TransferMatrix:
    """A transfer function, or a matrix of them, as quotients of polynomials."""
    matrix = G if isinstance(G, sp.MatrixBase) else sp.ImmutableMatrix([[G]])
    pairs = [[sp.fraction(sp.together(entry)) for entry in row] for row in matrix.tolist()]
    tops, bottoms = ([[sp.expand(pair[i]) for pair in row] for row in pairs] for i in (0, 1))
    return exact.transfer_matrix_of_fractions(tops, bottoms, variable_of(given.system))


transfer_function.mistaken_question(mistakes.EXCHANGED)(mistakes.inputs_for_outputs)
circuit_mistakes.name_mistakes(transfer_function)


@transfer_function.meaning("G")
def value_at_a_point(wrong: Attempt[InputOutput, TransferFunctionOptions]) -> Reason | None:
    """Its value and that of the formula."""
    return meanings.at_a_point(wrong.value, stated_matrix(chosen_channel(wrong.given)))


@transfer_function.meaning("poles", "zeros")
def value_at_one_of_them(wrong: Attempt[InputOutput, TransferFunctionOptions]) -> Reason | None:
    """The value of G where it has no pole, or no zero."""
    plant = chosen_channel(wrong.given)
    return meanings.finite_at(wrong.value, stated_matrix(plant), variable_of(plant), zeros=wrong.name == "zeros")
