"""The resolvent (xI − A)⁻¹, x = s or z, by itself and with its partial fractions: what transforms are made from."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from solver.arithmetic.fractions import expanded
from solver.arithmetic.inverses import cofactors
from solver.derivation import AnswerName, Answers, Attempt, Check, Claim, Derivation, Given, Step, Task, lemma
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import linear_algebra as judges
from solver.stated.algebra import difference, power, product, quotient, total
from solver.stated.matrices import adjugate, determinant, inverse
from solver.stated.transforms import inverse_laplace, inverse_z
from solver.tasks import mistakes
from solver.tasks.linear_algebra.characteristic_polynomial import (
    Form,
    determinant_of,
    factors_of,
    minus_determinant,
    pencil_of,
    recursion_of,
    shows_its_factors,
)
from solver.tasks.plant_options import PlantOptions
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import ImmutableMatrix, Symbol

    from solver.systems import StateSpace

resolvent: Task[StateSpace, PlantOptions] = Task(
    "resolvent",
    title="Resolvent",
    doc="The matrix (sI − A)⁻¹, the Laplace transform of e^{At}; in discrete time (zI − A)⁻¹.",
    needs=("A",),
    options=PlantOptions,
    complex_entries=True,
    answers=[
        AnswerName(
            "resolvent", "R", "the resolvent", principal=True, earned=("expansion", "companion", "adjugate", "sum")
        ),
        AnswerName("polynomial", r"\chi", "the characteristic polynomial, monic"),
    ],
)


def _variable(given: Given[StateSpace, PlantOptions]) -> Symbol:
    """The variable of the transform: s, or z in discrete time."""
    return sp.Symbol("z" if given.system.discrete else "s")


@resolvent.method("adjugate", title="Adjugate over determinant", source="Lecture note, section 1.13")
def by_adjugate(given: Given[StateSpace, PlantOptions]) -> Derivation[Answers]:
    """(xI − A)⁻¹ = adj(xI − A)/det(xI − A), the adjugate by cofactors."""
    A, x = given.system.A, _variable(given)
    inverted = yield from inverse_of_pencil(A, x)
    chi = exact.faddeev_leverrier(A).characteristic_polynomial(x)
    if A.rows > 1 and shows_its_factors(A, x):
        says = "the factors multiplied out"
        yield Step("polynomial", claims={"polynomial": Claim(exact.factored(A, x), chi, says)}, x=x)
    return Answers(resolvent=inverted, polynomial=chi)


@resolvent.method(
    "faddeev_leverrier", title="Faddeev–LeVerrier algorithm", source="Gantmacher, The Theory of Matrices I, IV §5"
)
def by_faddeev_leverrier(given: Given[StateSpace, PlantOptions]) -> Derivation[Answers]:
    """(xI − A)⁻¹ = (N₀ x^{n−1} + … + Nₙ₋₁)/χ(x), with the Nₖ and χ of the recursion."""
    A, x = given.system.A, _variable(given)
    found = yield from recursion_of(A)
    adj, chi, pencil = found.adjugate(x), found.characteristic_polynomial(x), exact.pencil(A, x)
    *above, last = found.adjugate_coefficients
    powers = [*(product(N, power(x, A.rows - 1 - k)) for k, N in enumerate(above)), last]
    yield Step(
        "sum",
        claims={
            "adjugate": Claim(adjugate(pencil), total(*powers), "adjugate by powers"),
            "entries": Claim(total(*powers), adj, "entries of the adjugate"),
            "polynomial": Claim(determinant(pencil), chi, "determinant"),
        },
        x=x,
        n=A.rows,
    )
    yield from factors_of(A, x)
    inverted = yield from quotient_of_adjugate(A, x, adj)
    return Answers(resolvent=inverted, polynomial=chi)


@resolvent.verification("resolvent")
def is_the_inverse(given: Given[StateSpace, PlantOptions], answers: Answers) -> Iterable[Check]:
    """(xI − A) R = I, entry by entry, at random x."""
    A, R, x = given.system.A, answers["resolvent"], _variable(given)
    identity = sp.ImmutableMatrix(sp.eye(A.rows))
    inverted = product(difference(product(x, identity), A), R)
    yield numeric.check_claim(Claim(inverted, identity), Phrase("$({x}I - A) R = I$", x=x))


@resolvent.verification("polynomial")
def has_the_values_of_the_determinant(given: Given[StateSpace, PlantOptions], answers: Answers) -> Iterable[Check]:
    """p(x) = det(xI − A) at random x, the determinant by numpy."""
    A, polynomial, x = given.system.A, answers["polynomial"], _variable(given)
    yield numeric.check_residual(
        Phrase(r"$\chi({x}) = \det({x}I - A)$ at random points", x=x),
        "numpy.linalg.det",
        lambda: judges.polynomial_residual(A, polynomial, x),
    )


@resolvent.mistake(mistakes.OF_THE_NEGATIVE, "resolvent")
def of_the_negative(wrong: Attempt[StateSpace, PlantOptions]) -> Iterable[Any]:
    """(A − xI)⁻¹."""
    yield -wrong.ours


@resolvent.mistake(mistakes.NOT_DIVIDED, "resolvent")
def not_divided(wrong: Attempt[StateSpace, PlantOptions]) -> Iterable[Any]:
    """adj(xI − A)."""
    yield exact.faddeev_leverrier(wrong.given.system.A).adjugate(_variable(wrong.given))


resolvent.mistake(mistakes.MINUS_DETERMINANT, "polynomial")(minus_determinant)


@lemma("resolvent")
def adjugate_of_pencil(A: ImmutableMatrix, x: Symbol, *, for_its: Form = "factors") -> Derivation[ImmutableMatrix]:
    """det(xI − A) and adj(xI − A), of which nothing is said where it is 1; returns the adjugate."""
    found = yield from determinant_of(A, x, for_its=for_its)
    pencil, adj = exact.pencil(A, x), found.adjugate(x)
    if A.rows > 1:
        yield Step(
            "adjugate",
            claims={"adjugate": Claim(adjugate(pencil), adj, "adjugate of the matrix")},
            steps=cofactors(pencil, adj),
            x=x,
            n=A.rows,
        )
    return adj


@lemma("resolvent")
def inverse_of_pencil(A: ImmutableMatrix, x: Symbol) -> Derivation[ImmutableMatrix]:
    """(xI − A)⁻¹ = adj(xI − A)/det(xI − A), of a diagonal A entry by entry; returns it with cancelled entries."""
    if A.is_diagonal():
        return (yield from _entry_by_entry(A, x))
    adj = yield from adjugate_of_pencil(A, x)
    return (yield from quotient_of_adjugate(A, x, adj))


def _entry_by_entry(A: ImmutableMatrix, x: Symbol) -> Derivation[ImmutableMatrix]:
    """The inverse of a diagonal matrix has the inverse entries."""
    pencil = yield from pencil_of(A, x)
    inverted: ImmutableMatrix = exact.resolvent(A, x)
    claim = Claim(inverse(pencil), inverted, "inverse of a diagonal matrix")
    yield Step("diagonal", claims={"entries": claim}, x=x, n=A.rows)
    return inverted


@lemma("resolvent")
def quotient_of_adjugate(A: ImmutableMatrix, x: Symbol, adj: ImmutableMatrix) -> Derivation[ImmutableMatrix]:
    """(xI − A)⁻¹ from the adjugate; returns it with cancelled entries."""
    pencil, chi = exact.pencil(A, x), exact.factored(A, x)
    inverted = exact.resolvent(A, x)
    yield Step(
        "inverse",
        claims={
            "quotient": Claim(inverse(pencil), quotient(adj, chi), "inverse by the adjugate"),
            "entries": Claim(quotient(adj, chi), inverted, "entries of the inverse"),
        },
        x=x,
        n=A.rows,
        cancels=exact.resolvent_cancels(A),
    )
    return inverted


@lemma("resolvent")
def partial_fractions_of(A: ImmutableMatrix, x: Symbol) -> Derivation[Any]:
    """(xI − A)⁻¹ as a sum of matrices over powers of the irreducible factors of det(xI − A); returns the sum."""
    pencil = exact.pencil(A, x)
    terms = exact.partial_fractions(A, x)
    expansion = total(*terms)
    yield Step(
        "partial_fractions",
        claims={"expansion": Claim(inverse(pencil), expansion, "partial fractions of the inverse")},
        steps=expanded(exact.resolvent_matrix(A), x),
        x=x,
        terms=terms,
        exceptions=exact.spectrum(A).exceptions,
        **exact.Denominators.of(exact.resolvent_matrix(A), x).named,
    )
    return expansion


@lemma("resolvent")
def completed_squares_of(image: exact.RationalMatrix, x: Symbol) -> Derivation[None]:
    """Quadratic denominators as (x − σ)² + ω², as the tables have them; no step where all are so already."""
    quadratics = exact.Denominators.of(image, x).quadratics
    shifted = [each for each in quadratics if each[1] != 0]
    if shifted:
        yield Step(
            "completed_squares",
            claims={
                f"square{i}": Claim(p, total(power(x - sigma, 2), omega**2), "completed square")
                for i, (p, sigma, omega) in enumerate(shifted, 1)
            },
            detail="full",
            x=x,
            quadratics=quadratics,
        )


@lemma("resolvent")
def transform_pairs_of(A: ImmutableMatrix, x: Symbol, time: Symbol, *, discrete: bool) -> Derivation[None]:
    """List the transform pairs that the partial fractions need; in discrete time the images carry the factor z."""
    pairs = exact.transform_pairs(A, x, time, discrete=discrete)
    yield from completed_squares_of(exact.resolvent_matrix(A), x)
    invert = inverse_z if discrete else inverse_laplace
    yield Step(
        "pairs",
        claims={
            f"pair{i}": Claim(invert(image, x, time), original, "transform pair")
            for i, (image, original) in enumerate(pairs, 1)
        },
        discrete=discrete,
        undecided=any(root.kind == "symbolic" and root.shift != 0 for root in exact.spectrum(A).roots),
    )


@resolvent.consequence("resolvent", of=("polynomial",))
def adjugate_over(given: Given[StateSpace, PlantOptions], found: Mapping[str, Any]) -> Any:
    """adj(sI − A) over the polynomial."""
    A, x = given.system.A, sp.Symbol("z" if given.system.discrete else "s")
    adj = exact.determinant_and_adjugate(exact.pencil(A, x))[1]
    return sp.ImmutableMatrix(adj / found["polynomial"])
