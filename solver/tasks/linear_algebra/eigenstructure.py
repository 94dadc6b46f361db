"""Eigenvalues, right and left eigenvectors, Jordan form."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.arithmetic.chains import chains_worked_out
from solver.arithmetic.coordinates import both_sides
from solver.arithmetic.exactness import where_exact
from solver.arithmetic.quadratics import quadratic_formula, roots_of_squares
from solver.arithmetic.row_operations import null_vectors, row_operations
from solver.derivation import AnswerName, Answers, Attempt, Check, Claim, Derivation, Given, Step, Task, lemma
from solver.lazy import exact, numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import linear_algebra as judges
from solver.stated.algebra import power, product
from solver.stated.calculus import value_at
from solver.tasks import meanings, mistakes
from solver.tasks.form_meanings import jordan_fault
from solver.tasks.linear_algebra.characteristic_polynomial import determinant_of
from solver.tasks.plant_options import PlantOptions
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import ImmutableMatrix, Symbol

    from solver.systems import StateSpace, System

eigenstructure: Task[StateSpace, PlantOptions] = Task(
    "eigenstructure",
    title="Eigenvalues and eigenvectors",
    doc="Eigenvalues, right and left eigenvectors (chains of generalized ones where A is defective) and Jordan form.",
    needs=("A",),
    options=PlantOptions,
    complex_entries=True,
    answers=[
        AnswerName(
            "eigenvalues",
            r"\lambda_i",
            "the eigenvalues, each as often as its multiplicity",
            principal=True,
            numbered=True,
            earned=("expansion", "companion", "quadratic", "spectrum"),
        ),
        AnswerName(
            "right_eigenvectors",
            "V",
            r"right eigenvectors, $A\nu = \lambda\nu$ (chains where $A$ is defective), "
            "as columns in the order of the eigenvalues",
            free=True,
            vectors="columns",
            principal=True,
        ),
        AnswerName(
            "left_eigenvectors",
            "M",
            r"left eigenvectors, $wA = \lambda w$ (or chains), as rows in the same order: $MA = JM$",
            free=True,
            vectors="rows",
            principal=True,
        ),
        AnswerName("jordan_form", "J", "Jordan form, $AV = VJ$, ones above the diagonal", modal=True, principal=True),
        AnswerName("diagonalizable", r"\text{diagonalizable}", "whether $A$ has $n$ independent eigenvectors"),
    ],
)


@lemma("eigenvalues")
def eigenvalues_of(A: ImmutableMatrix) -> Derivation[exact.Spectrum]:
    """Roots of the characteristic polynomial, factor by factor, with their multiplicities."""
    lamda = sp.Symbol("lamda")
    resolvent = yield from determinant_of(A, lamda, for_its="factors")
    chi = resolvent.characteristic_polynomial(lamda)
    spectrum = exact.spectrum(A)
    for factor in spectrum.factors:
        if factor.degree > 1:
            yield _roots_of_factor(factor, lamda)
    linear = product(*(power(lamda - root.value, root.multiplicity) for root in spectrum.roots))
    yield Step(
        "spectrum",
        claims={"roots": Claim(chi, linear, "roots of the characteristic polynomial with their multiplicities")},
        roots=spectrum.roots,
        exceptions=spectrum.exceptions,
    )
    return spectrum


def _roots_of_factor(factor: exact.Factor, x: Symbol) -> Step:
    """The quadratic formula, for λ² where only even powers occur, or decimals where that is no help."""
    p, roots = factor.polynomial(x), [root.value for root in factor.roots]
    if factor.degree > 2 and factor.roots[0].kind != "decimal":
        split = Claim(p, product(*(x - root for root in roots)), "the factor written with its roots")
        squares = exact.squares_of_roots(factor)
        lines = (
            *quadratic_formula(x**2, factor.coefficients[2], factor.coefficients[4], squares),
            *roots_of_squares(x, squares, roots),
        )
        return Step("biquadratic", claims={"split": split}, steps=lines, p=p, roots=roots, squares=squares)
    if factor.degree > 2:
        split = Claim(p, product(*(x - root for root in roots)), "the factor written with its decimal roots")
        return Step("decimal_roots", claims={"split": split}, p=p, roots=roots, degree=factor.degree)
    claims = {
        f"root{i}": Claim(value_at(p, x, root), sp.Integer(0), "the root put into its factor")
        for i, root in enumerate(roots, 1)
    }
    _, b, c = factor.coefficients
    kind = factor.roots[0].kind
    upper = roots if kind == "complex" else roots[::-1]  # that of the upper sign first
    lines = quadratic_formula(x, b, c, upper)
    return Step("quadratic", claims=claims, steps=lines, p=p, roots=upper, pure=b == 0, root_kind=kind)


@lemma("eigenvectors")
def right_eigenvectors_of(A: ImmutableMatrix) -> Derivation[exact.Eigenstructure]:
    """(λI − A) ν = 0 for each eigenvalue; chains (A − λI) c_{j+1} = c_j where eigenvectors are too few."""
    structure = exact.eigenstructure(A)
    yield from _eigenspace_steps(A, structure.eigenspaces, left=False)
    return structure


@lemma("left_eigenvectors")
def left_eigenvectors_of(A: ImmutableMatrix, structure: exact.Eigenstructure) -> Derivation[ImmutableMatrix]:
    """Solve w (λI − A) = 0 for each eigenvalue, i.e. rows of M with M A = J M; returns M (n×n)."""
    yield from _eigenspace_steps(sp.ImmutableMatrix(A.T), structure.left_eigenspaces, left=True)
    M, J = structure.left, structure.jordan_form
    yield Step(
        "modal_matrix",
        claims={"rows": Claim(product(M, A), product(J, M), "$M A = J M$")},
        M=M,
        diagonalizable=structure.diagonalizable,
    )
    return M


def _eigenspace_steps(A: ImmutableMatrix, spaces: Sequence[exact.Eigenspace], *, left: bool) -> Derivation[None]:
    """One step for each eigenvalue of A (of the transpose, for left eigenvectors)."""
    seen: list[Any] = []
    for i, space in enumerate(spaces, 1):
        value = space.root.value
        mirrored = bool(value.has(sp.I)) and not A.has(sp.I) and sp.conjugate(value) in seen
        seen.append(value)
        kind = "conjugate" if mirrored else "chains" if space.geometric < space.algebraic else "eigenspace"
        pencil = exact.pencil(A, value)
        reduction = None if mirrored else space.reduction
        yield Step(
            kind,
            claims=_chain_claims(A, pencil, space, left=left),
            steps=_arithmetic(pencil, space, reduction) if reduction else (),
            i=i,
            value=value,
            pencil=pencil,
            reduced=sp.ImmutableMatrix(reduction.reduced[: len(reduction.pivots)]) if reduction else None,
            chains=[[v.T for v in chain] for chain in space.chains] if left else space.chains,
            algebraic=space.algebraic,
            geometric=space.geometric,
        )


@where_exact
def _arithmetic(pencil: ImmutableMatrix, space: exact.Eigenspace, reduction: exact.RowReduction) -> tuple[Step, ...]:
    """The row operations; then the unknowns and the scale, or the chains, their number and lengths."""
    operations = row_operations(pencil, reduction)
    if space.geometric < space.algebraic:
        return (*operations, *chains_worked_out(sp.ImmutableMatrix(-pencil), space.nullities, space.chains))
    return (*operations, *null_vectors(reduction, [vector for chain in space.chains for vector in chain]))


def _chain_claims(
    A: ImmutableMatrix, pencil: ImmutableMatrix, space: exact.Eigenspace, *, left: bool
) -> dict[str, Claim]:
    """A v = λ v for the first vector of each chain, (A − λI) c_{j+1} = c_j for the others."""
    says, value = (r"$w A = \lambda w$" if left else r"$A \nu = \lambda \nu$"), space.root.value
    claims: dict[str, Claim] = {}
    for number, chain in enumerate(space.chains, 1):
        claims[f"vector{number}"] = Claim(product(A, chain[0]), product(value, chain[0]), says)
        for j in range(1, len(chain)):
            nilpotent = sp.ImmutableMatrix(-pencil)
            claims[f"chain{number}_{j}"] = Claim(product(nilpotent, chain[j]), chain[j - 1], "chain of vectors")
    return claims


@eigenstructure.method(source="Lecture note, section 1.12")
def by_null_spaces(given: Given[StateSpace, PlantOptions]) -> Derivation[Answers]:
    """Eigenvalues from χ(λ) = 0, eigenvectors from the null spaces of λI − A and of its transpose."""
    A = given.system.A
    yield from eigenvalues_of(A)
    structure = yield from right_eigenvectors_of(A)
    M = yield from left_eigenvectors_of(A, structure)
    V, J = structure.right, structure.jordan_form
    claims = {"similar": Claim(product(A, V), product(V, J), "$A V = V J$")}
    yield Step("jordan_form", claims=claims, steps=both_sides(A, V, J), V=V, J=J,
               diagonalizable=structure.diagonalizable, eigenspaces=structure.eigenspaces)  # fmt: skip
    return Answers(
        eigenvalues=[J[i, i] for i in range(A.rows)],
        right_eigenvectors=V,
        left_eigenvectors=M,
        jordan_form=J,
        diagonalizable=structure.diagonalizable,
    )


@eigenstructure.verification("eigenvalues")
def are_the_roots(given: Given[StateSpace, PlantOptions], answers: Answers) -> Iterable[Check]:
    """det(xI − A) = Π(x − λᵢ) at random x."""
    yield numeric.check_residual(
        r"$\det(xI - A) = \prod_i (x - \lambda_i)$",
        "numpy.linalg.det",
        lambda: judges.spectrum_residual(given.system.A, answers["eigenvalues"]),
    )


@eigenstructure.verification("right_eigenvectors")
def are_right_chains(given: Given[StateSpace, PlantOptions], answers: Answers) -> Iterable[Check]:
    """A V = V J with independent columns; without J, V⁻¹ A V is some Jordan form, in the order of the eigenvalues."""
    A, V, J = given.system.A, answers["right_eigenvectors"], answers.get("jordan_form")
    if J is not None:
        yield numeric.check_residual(r"$A V = V J$", "numpy", lambda: judges.chain_residual(A, V, J))
    elif "eigenvalues" in answers:
        right = judges.are_in_order(A, V, answers["eigenvalues"])
        yield Check.that("the columns of $V$ stand in the order of the eigenvalues", "mpmath.inverse", right)
    yield numeric.check_residual(
        r"$V^{-1} A V$ is in Jordan form", "mpmath.inverse", lambda: judges.chains_residual(A, V)
    )
    yield Check.that(r"the columns of $V$ are independent", "numpy.linalg.svd", numeric.independent(V))


@eigenstructure.verification("left_eigenvectors")
def are_left_chains(given: Given[StateSpace, PlantOptions], answers: Answers) -> Iterable[Check]:
    """M A = J M with independent rows; without J, M A M⁻¹ is some Jordan form, in the order of the eigenvalues."""
    A, M, J = given.system.A, answers["left_eigenvectors"], answers.get("jordan_form")
    if J is not None:
        yield numeric.check_residual(r"$M A = J M$", "numpy", lambda: judges.left_residual(A, M, J))
    elif "eigenvalues" in answers:
        right = judges.are_in_order(A, M, answers["eigenvalues"], rows=True)
        yield Check.that("the rows of $M$ stand in the order of the eigenvalues", "mpmath.inverse", right)
    yield numeric.check_residual(
        r"$M A M^{-1}$ is in Jordan form", "mpmath.inverse", lambda: judges.chains_residual(A, M, rows=True)
    )
    yield Check.that(r"the rows of $M$ are independent", "numpy.linalg.svd", numeric.independent(M.T))


@eigenstructure.verification("jordan_form")
def has_the_same_blocks(given: Given[StateSpace, PlantOptions], answers: Answers) -> Iterable[Check]:
    """J is in Jordan form and has, for each eigenvalue of A, as many blocks of each size."""
    A, J = given.system.A, answers["jordan_form"]
    yield Check.that(
        r"$J$ is in Jordan form, with the eigenvalues in order",
        "inspection",
        judges.is_jordan_form(J, answers.get("eigenvalues")),
    )
    yield Check.that(r"$J$ has the blocks of $A$", r"ranks of $(A - \lambda I)^k$", judges.same_jordan_structure(A, J))


@eigenstructure.verification("diagonalizable")
def has_enough_eigenvectors(given: Given[StateSpace, PlantOptions], answers: Answers) -> Iterable[Check]:
    """The rank of A − λI tells for each eigenvalue how many independent eigenvectors it has."""
    yield Check.that(
        r"$A$ is diagonalizable as stated",
        r"ranks of $A - \lambda I$",
        answers["diagonalizable"] == judges.diagonalizable(given.system.A),
    )


eigenstructure.mistake(mistakes.DIAGONAL, "eigenvalues")(mistakes.diagonal_entries)


@eigenstructure.mistaken_question(mistakes.OTHER_SIDE)
def transposed(system: System, options: PlantOptions) -> tuple[System, PlantOptions] | None:
    """The question about Aᵀ."""
    if not isinstance(system, systems.StateSpace):
        return None
    return replace(system, A=sp.ImmutableMatrix(system.A.T)), options


@eigenstructure.consequence("jordan_form", of=("eigenvalues",))
def diagonal_of(given: Given[StateSpace, PlantOptions], found: Mapping[str, Any]) -> Any:
    """The diagonal matrix of eigenvalues that all differ."""
    values = found["eigenvalues"]
    simple = len(set(values)) == len(values) == given.system.order
    return sp.ImmutableMatrix(sp.diag(*values)) if simple else None


eigenstructure.meaning("eigenvalues")(meanings.no_eigenvalue)


@eigenstructure.meaning("jordan_form")
def fault_of_the_form(wrong: Attempt[StateSpace, PlantOptions]) -> Reason | None:
    """An entry that no Jordan form has, no eigenvalue on the diagonal, or blocks of other sizes."""
    return jordan_fault(wrong.given.system.A, wrong.value)


@eigenstructure.meaning("right_eigenvectors", "left_eigenvectors")
def turned(wrong: Attempt[StateSpace, PlantOptions]) -> Reason | None:
    """A column (row) that A turns, where there is a basis of eigenvectors."""
    if not judges.diagonalizable(wrong.given.system.A):
        return None
    return meanings.turned_by(wrong.given.system.A, wrong.value, rows=wrong.name == "left_eigenvectors")
