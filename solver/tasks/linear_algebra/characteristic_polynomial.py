"""The characteristic polynomial det(λI − A)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, Literal

from solver.arithmetic import determinants, roots
from solver.arithmetic.products import is_worked_out, rows_times_columns
from solver.derivation import AnswerName, Answers, Attempt, Check, Claim, Derivation, Given, Step, Task, lemma
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.matrices import entries, identity
from solver.numeric.judges import linear_algebra as judges
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.matrices import determinant, trace
from solver.tasks import meanings, mistakes
from solver.tasks.plant_options import PlantOptions
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.systems import StateSpace

characteristic_polynomial: Task[StateSpace, PlantOptions] = Task(
    "characteristic_polynomial",
    title="Characteristic polynomial",
    doc="The monic polynomial χ(λ) = det(λI − A) whose roots are the eigenvalues of A.",
    needs=("A",),
    options=PlantOptions,
    complex_entries=True,
    answers=[
        AnswerName(
            "polynomial",
            r"\chi(\lambda)",
            r"the monic polynomial $\det(\lambda I - A)$",
            earned=("expansion", "polynomial"),
        )
    ],
)


Form = Literal["both", "coefficients", "factors"]
"""What a determinant is wanted for."""

SMALLEST_COMPANION = 3
"""The determinant of a smaller companion matrix is as quickly expanded as read off."""


@lemma("determinant")
def determinant_of(
    A: ImmutableMatrix, x: Symbol, *, expanded: bool = False, for_its: Form = "both"
) -> Derivation[exact.FaddeevLeVerrier]:
    """χ(x) = det(xI − A), expanded along the row with most zeros; returns χ and the adjugate in x.

    Of a companion matrix of order three or more it is read off, unless it is to be `expanded`. What is wanted of it
    may be its coefficients, or its factors, which a triangular matrix shows at once.
    """
    pencil = yield from pencil_of(A, x)
    resolvent = exact.faddeev_leverrier(A)
    chi = resolvent.characteristic_polynomial(x)
    shape, coefficients = shape_of(pencil), "" if expanded else coefficients_of_companion(A)
    in_sight = [] if shape["triangular"] else _factors_in_sight(A, pencil, x)
    if coefficients and not shape["triangular"]:
        value = Claim(determinant(pencil), chi, "the polynomial of a companion matrix")
        yield Step("companion", claims={"value": value}, x=x, coefficients=coefficients)
    else:
        claims = expansion_of(pencil, resolvent.adjugate(x), chi)
        if in_sight:
            claims = _claims_of_factors(claims["stated"], in_sight, chi)
        if (shape["triangular"] or in_sight) and for_its == "factors":
            claims.pop("value")
        lines = determinants.expanded(pencil, chi, x) if _has_a_quadratic(in_sight, A) else ()
        yield Step("expansion", claims=claims, steps=lines, x=x, n=A.rows, **shape)
    if not (shape["triangular"] or in_sight) and for_its != "coefficients":  # else its factors have been seen
        yield from factors_of(A, x)
    return resolvent


def shows_its_factors(A: ImmutableMatrix, x: Symbol) -> bool:
    """Whether `determinant_of` finds χ(x) as the product of its factors, if it is wanted for these."""
    pencil = exact.pencil(A, x)
    return determinants.is_triangular(pencil) or bool(_factors_in_sight(A, pencil, x))


def _factors_in_sight(A: ImmutableMatrix, pencil: ImmutableMatrix, x: Symbol) -> list[Expr]:
    """The irreducible factors of χ(x), in the order of the expansion, where each row expanded along has one entry left.

    None of a matrix of order two, and none where a factor falls apart again.
    """
    found, rest = [], pencil
    while rest.rows > 2 and not determinants.is_triangular(rest):
        if determinants.most_zeros_in_a_row(rest) != rest.cols - 1:
            return []
        ((entry, rest),) = determinants.along_row(rest)
        found.append(entry)
    if not found:
        return []
    whole = determinants.is_triangular(rest)
    found += rest.diagonal() if whole else [exact.multiplied_out(exact.determinant(rest), x)]
    return found if sp.Mul(*found) == exact.factored(A, x) else []


def _claims_of_factors(stated: Claim, factors: list[Expr], chi: Expr) -> dict[str, Claim]:
    """The determinant as it is expanded, in factors, and multiplied out."""
    seen = Claim(stated.right, product(*factors), Phrase("the minors in factors"))
    return {"stated": stated, "factors": seen, "value": Claim(seen.right, chi, "the determinant multiplied out")}


def _has_a_quadratic(factors: list[Expr], A: ImmutableMatrix) -> bool:
    """Whether there is more to work out than entries of the diagonal."""
    return len(factors) < A.rows


@lemma("determinant")
def pencil_of(A: ImmutableMatrix, x: Symbol) -> Derivation[ImmutableMatrix]:
    """The matrix xI − A; returns it."""
    pencil = exact.pencil(A, x)
    says = "the matrix whose determinant is taken"
    claims = {"pencil": Claim(difference(product(x, identity(A.rows)), A), pencil, says)}
    yield Step("pencil", claims=claims, x=x, A=A, pencil=pencil)
    return pencil


@lemma("determinant")
def factors_of(A: ImmutableMatrix, x: Symbol) -> Derivation[None]:
    """The irreducible factors of χ(x); no step where it has but one."""
    chi, factored = exact.faddeev_leverrier(A).characteristic_polynomial(x), exact.factored(A, x)
    if factored != chi:
        claims = {"factors": Claim(chi, factored, "factors of the characteristic polynomial")}
        yield Step("factors", claims=claims, steps=roots.factored(chi, factored, x), x=x)


def shape_of(pencil: ImmutableMatrix) -> dict[str, Any]:
    """How the determinant is expanded: the row, and whether the matrix is triangular."""
    return {"row": determinants.row_with_most_zeros(pencil), "triangular": determinants.is_triangular(pencil)}


def coefficients_of_companion(A: ImmutableMatrix) -> str:
    """Return where a companion matrix of order three or more has its coefficients; "" if it is none.

    There they stand with changed signs, in the last row or column from the constant term on, in the first one from the
    highest power on.
    """
    n = A.rows
    if n < SMALLEST_COMPANION:
        return ""
    every, each = range(n), entries(A)
    ones_above, ones_below = 1, -1
    others = {
        "last row": (every[:-1], every, ones_above),
        "first row": (every[1:], every, ones_below),
        "first column": (every, every[1:], ones_above),
        "last column": (every, every[:-1], ones_below),
    }
    for place, (rows, columns, ones) in others.items():
        if all(each[n * i + j] == int(j - i == ones) for i in rows for j in columns):
            return place
    return ""


def expansion_of(pencil: ImmutableMatrix, adjugate: ImmutableMatrix, chi: Expr) -> dict[str, Claim]:
    """The determinant as it is written before multiplying out, and multiplied out."""
    says, line = "the determinant multiplied out", determinants.first_line(pencil)
    if determinants.is_simple(pencil):
        triangular = determinants.is_triangular(pencil)
        stated = Claim(determinant(pencil), line, "determinant of a triangular matrix" if triangular else says)
        return {"stated": stated, "value": Claim(line, chi, says)}
    i = determinants.row_with_most_zeros(pencil)
    stated = Claim(determinant(pencil), line, Phrase("determinant expanded along row {row}", row=i + 1))
    columns = [j for j in range(pencil.cols) if pencil[i, j] != 0 and adjugate[j, i] != 0]
    signs = {j: (-1) ** (i + j) for j in columns}  # cofactors, minors with their signs, are entries of the adjugate
    multiplied = total(*(product(signs[j] * pencil[i, j], signs[j] * adjugate[j, i]) for j in columns))
    if not columns:
        return {"stated": stated, "value": Claim(line, chi, "every minor is zero")}
    return {
        "stated": stated,
        "minors": Claim(line, multiplied, "minors of the expansion"),
        "value": Claim(multiplied, chi, says),
    }


@characteristic_polynomial.method(
    "determinant", title="Expansion of the determinant", source="Lecture note, section 1.12"
)
def by_determinant(given: Given[StateSpace, PlantOptions]) -> Derivation[Answers]:
    """χ(λ) = det(λI − A), expanded along a row."""
    lamda = sp.Symbol("lamda")
    resolvent = yield from determinant_of(given.system.A, lamda, expanded=True)
    return Answers(polynomial=resolvent.characteristic_polynomial(lamda))


@lemma("faddeev_leverrier")
def recursion_of(A: ImmutableMatrix) -> Derivation[exact.FaddeevLeVerrier]:
    """N₀ = I; aₖ = −tr(A Nₖ₋₁)/k, Nₖ = A Nₖ₋₁ + aₖ I; returns the coefficients of χ and of the adjugate."""
    resolvent = exact.faddeev_leverrier(A)
    coefficients = resolvent.coefficients
    identity = sp.ImmutableMatrix(sp.eye(A.rows))
    yield Step("start", unclaimed="a definition: N₀ = I and the recursion", n=A.rows, A=A)
    for k in range(1, A.rows + 1):
        N, a = resolvent.adjugate_coefficients[k - 1], coefficients[k]
        following = resolvent.adjugate_coefficients[k] if k < A.rows else sp.ImmutableMatrix(sp.zeros(A.rows))
        AN = sp.ImmutableMatrix(exact.multiply(A, N))
        yield Step(
            "recursion",
            claims={
                "product": Claim(product(A, N), AN, f"$A N_{{{k - 1}}}$"),
                "coefficient": Claim(quotient(product(-1, trace(AN)), k), a, f"$a_{{{k}}}$"),
                "next": Claim(total(AN, product(a, identity)), following, f"$N_{{{k}}}$"),
            },
            k=k,
            identity=identity,
            entries=rows_times_columns(A, N) if is_worked_out(A, N) else "",
            traces=product(sp.Rational(-1, k), total(*(AN[i, i] for i in range(A.rows)))),
            last=k == A.rows,
        )
    return resolvent


@characteristic_polynomial.method(
    "faddeev_leverrier", title="Faddeev–LeVerrier algorithm", source="Gantmacher, The Theory of Matrices I, IV §5"
)
def by_faddeev_leverrier(given: Given[StateSpace, PlantOptions]) -> Derivation[Answers]:
    """N₀ = I; aₖ = −tr(A Nₖ₋₁)/k, Nₖ = A Nₖ₋₁ + aₖ I; Nₙ = 0 closes the recursion (Cayley–Hamilton)."""
    A, lamda = given.system.A, sp.Symbol("lamda")
    resolvent = yield from recursion_of(A)
    polynomial = resolvent.characteristic_polynomial(lamda)
    yield Step(
        "polynomial",
        claims={"polynomial": Claim(determinant(exact.pencil(A, lamda)), polynomial, r"$\det(\lambda I - A)$")},
    )
    return Answers(polynomial=polynomial)


@characteristic_polynomial.verification("polynomial")
def has_the_values_of_the_determinant(given: Given[StateSpace, PlantOptions], answers: Answers) -> Iterable[Check]:
    """p(x) = det(xI − A) at random x, the determinant by numpy."""
    A, polynomial, lamda = given.system.A, answers["polynomial"], sp.Symbol("lamda")
    yield numeric.check_residual(
        r"$\chi(\lambda) = \det(\lambda I - A)$ at random points",
        "numpy.linalg.det",
        lambda: judges.polynomial_residual(A, polynomial, lamda),
    )


@characteristic_polynomial.mistake(mistakes.MINUS_DETERMINANT, "polynomial")
def minus_determinant(wrong: Attempt[StateSpace, PlantOptions]) -> Iterable[Any]:
    """det(A − λI), which is −det(λI − A) for odd n."""
    if wrong.given.system.A.rows % 2:
        yield -wrong.ours


@characteristic_polynomial.meaning("polynomial")
def value_at_a_point(wrong: Attempt[StateSpace, PlantOptions]) -> Reason | None:
    """Its value and that of the determinant."""
    return meanings.at_a_point(wrong.value, determinant(exact.pencil(wrong.given.system.A, sp.Symbol("lamda"))))
