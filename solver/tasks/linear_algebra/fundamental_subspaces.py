"""The four fundamental subspaces of a matrix."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.arithmetic.row_operations import row_operations
from solver.derivation import AnswerName, Answers, Check, Claim, Derivation, Given, Step, Task, option
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import linear_algebra as judges
from solver.options.matrix import MatrixOf
from solver.stated.algebra import product
from solver.stated.matrices import rank, transpose
from solver.tasks.plant_options import PlantOptions
from solver.tasks.structure.rank_exceptions import rank_exceptions

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.systems import StateSpace


@dataclass(frozen=True, kw_only=True)
class FundamentalSubspacesOptions(PlantOptions):
    """A matrix of its own."""

    matrix: ImmutableMatrix | None = option(MatrixOf(), "the matrix, of any shape; without it the system's matrix (A)")


fundamental_subspaces: Task[StateSpace, FundamentalSubspacesOptions] = Task(
    "fundamental_subspaces",
    title="The four fundamental subspaces",
    doc="Bases of null space, column space, row space and left null space, by row reduction.",
    needs=("matrix",),
    options=FundamentalSubspacesOptions,
    answers=[
        AnswerName(
            "null_space",
            r"\operatorname{Null}(M)",
            "a basis of the null space, all $v$ with $Mv = 0$, as columns",
            free=True,
            vectors="columns",
            principal=True,
            earned=("echelon", "null_space"),
        ),
        AnswerName(
            "column_space",
            r"\operatorname{Col}(M)",
            "a basis of the column space, all $Mv$, as columns",
            free=True,
            vectors="columns",
            principal=True,
            earned=("column_space",),
        ),
        AnswerName(
            "row_space",
            r"\operatorname{Row}(M)",
            "a basis of the row space, all $M^{T}w$, as columns",
            free=True,
            vectors="columns",
            principal=True,
            earned=("row_space",),
        ),
        AnswerName(
            "left_null_space",
            r"\operatorname{Null}(M^{T})",
            "a basis of the left null space, all $y$ with $M^{T}y = 0$, as columns",
            free=True,
            vectors="columns",
            principal=True,
            earned=("left_null_space",),
        ),
        AnswerName(
            "rank",
            r"\operatorname{rank} M",
            "the rank (with parameters: the rank in general)",
            count=True,
            most=lambda given: min(_matrix(given).shape),
        ),
    ],
)


@fundamental_subspaces.method(source="Lecture note, section 2.4")
def by_row_reduction(given: Given[StateSpace, FundamentalSubspacesOptions]) -> Derivation[Answers]:
    """Row operations on M, then on its transpose, give all four bases."""
    M = _matrix(given)
    reduction = exact.row_reduction(M)
    r, pivots = len(reduction.pivots), reduction.pivots
    reduced = sp.ImmutableMatrix(reduction.reduced)
    yield _echelon(M, reduction, reduced)
    N = exact.null_basis(M)
    yield _null_space(M, reduced, N, pivots)
    C = sp.ImmutableMatrix(M[:, list(pivots)])
    R = sp.ImmutableMatrix(reduced[:r, :].T)
    yield Step(
        "column_space",
        claims={"rank": Claim(rank(C), sp.Integer(r), "the columns are independent")} if r else {},
        unclaimed="all columns are zero",
        basis=C,
        pivots=[j + 1 for j in pivots],
        height=M.rows,
    )
    both = sp.ImmutableMatrix(sp.Matrix.vstack(M, R.T))
    yield Step(
        "row_space",
        claims={"rank": Claim(rank(both), sp.Integer(r), "the rows span what the rows of $M$ span")},
        basis=R,
        width=M.cols,
    )
    L = exact.null_basis(M.T)
    yield _left_null_space(M, L)
    zero = sp.ImmutableMatrix(sp.zeros(N.cols, r))
    yield Step(
        "dimensions",
        claims={"orthogonal": Claim(product(transpose(N), R), zero, "orthogonality")} if N.cols and r else {},
        unclaimed="one of the spaces holds the zero vector only",
        r=r,
        width=M.cols,
        height=M.rows,
        exceptions=rank_exceptions(M) or [],
    )
    return Answers(null_space=N, column_space=C, row_space=R, left_null_space=L, rank=sp.Integer(r))


def _matrix(given: Given[StateSpace, FundamentalSubspacesOptions]) -> ImmutableMatrix:
    return given.system.A if given.options.matrix is None else given.options.matrix


def _echelon(M: ImmutableMatrix, reduction: exact.RowReduction, reduced: ImmutableMatrix) -> Step:
    """The reduced row echelon form, its pivots, and the free unknowns."""
    free = [j + 1 for j in range(M.cols) if j not in reduction.pivots]
    return Step(
        "echelon",
        claims={"rank": Claim(rank(M), sp.Integer(len(reduction.pivots)), "rank")},
        steps=row_operations(M, reduction),
        M=M,
        reduced=reduced,
        pivots=[j + 1 for j in reduction.pivots],
        free=free,
    )


def _null_space(M: ImmutableMatrix, reduced: ImmutableMatrix, N: ImmutableMatrix, pivots: tuple[int, ...]) -> Step:
    """The pivot unknowns in terms of the free ones; a basis without fractions."""
    unknowns = sp.symbols(f"x_1:{M.cols + 1}")
    free = [j for j in range(M.cols) if j not in pivots]
    solved = [(unknowns[j], sp.Add(*(-reduced[i, k] * unknowns[k] for k in free))) for i, j in enumerate(pivots)]
    zero = sp.ImmutableMatrix(sp.zeros(M.rows, N.cols))
    return Step(
        "null_space",
        claims={"zero": Claim(product(M, N), zero, "$M v = 0$ for the basis of the null space")} if N.cols else {},
        unclaimed="the null space holds the zero vector only",
        solved=solved,
        free=[unknowns[k] for k in free],
        basis=N,
        cleared=any(not a.is_Integer for a in reduced[:, :].flat()),
    )


def _left_null_space(M: ImmutableMatrix, L: ImmutableMatrix) -> Step:
    """The null space of the transpose."""
    turned = sp.ImmutableMatrix(M.T)
    reduction = exact.row_reduction(turned)
    zero = sp.ImmutableMatrix(sp.zeros(M.cols, L.cols))
    says = "$M^{T} y = 0$ for the basis of the left null space"
    return Step(
        "left_null_space",
        claims={"zero": Claim(product(turned, L), zero, says)} if L.cols else {},
        unclaimed="the left null space holds the zero vector only",
        steps=row_operations(turned, reduction),
        reduced=sp.ImmutableMatrix(reduction.reduced[: len(reduction.pivots)]) if reduction.pivots else None,
        basis=L,
        height=M.rows,
    )


@fundamental_subspaces.verification("null_space", "left_null_space")
def zero_and_of_the_right_dimension(
    given: Given[StateSpace, FundamentalSubspacesOptions], answers: Answers
) -> Iterable[Check]:
    """M V = 0 with as many independent columns as the dimension; the same for the transpose."""
    M = _matrix(given)
    for name, matrix in (("null_space", M), ("left_null_space", sp.ImmutableMatrix(M.T))):
        if name not in answers:
            continue
        V = answers[name]
        yield _dimension(name, V, matrix.cols, lambda matrix=matrix: matrix.cols - numeric.rank(matrix))
        if V.rows == matrix.cols and V.cols:
            zero = sp.ImmutableMatrix(sp.zeros(matrix.rows, V.cols))
            shown = "M v" if name == "null_space" else "M^{T} y"
            if numeric.holds_decimals(V):  # compared with a zero, what rounding leaves would be as wrong as can be
                yield numeric.check_residual(
                    f"${shown} = 0$",
                    "numpy",
                    partial(judges.null_residual, matrix, V),
                    answer=name,
                )
            else:
                yield numeric.check_claim(Claim(product(matrix, V), zero), f"${shown} = 0$", answer=name)


@fundamental_subspaces.verification("column_space", "row_space")
def spans_the_columns(given: Given[StateSpace, FundamentalSubspacesOptions], answers: Answers) -> Iterable[Check]:
    """As many independent columns as the rank, and none that raises the rank of M (of its transpose)."""
    M = _matrix(given)
    for name, matrix in (("column_space", M), ("row_space", sp.ImmutableMatrix(M.T))):
        if name not in answers:
            continue
        V = answers[name]
        yield _dimension(name, V, matrix.rows, lambda matrix=matrix: numeric.rank(matrix))
        if V.rows == matrix.rows and numeric.holds_decimals(V):
            yield numeric.check_residual(
                "the vectors lie in the space",
                "numpy.linalg.svd",
                partial(judges.range_residual, matrix, V),
                answer=name,
            )
        elif V.rows == matrix.rows:
            yield _that(
                "the vectors lie in the space",
                name,
                lambda matrix=matrix, V=V: numeric.rank(sp.Matrix.hstack(matrix, V)) == numeric.rank(matrix),
            )


@fundamental_subspaces.verification("rank")
def rank_by_singular_values(given: Given[StateSpace, FundamentalSubspacesOptions], answers: Answers) -> Iterable[Check]:
    """The rank by singular values."""
    M, r = _matrix(given), answers["rank"]
    yield _that(rf"$\operatorname{{rank}} M = {r}$", "rank", lambda: bool(r == numeric.rank(M)))


def _dimension(name: str, V: ImmutableMatrix, height: int, dimension: Any) -> Check:
    """Independent columns of the right height, as many as the dimension of the space."""
    return _that(
        "independent vectors, as many as the dimension",
        name,
        lambda: V.rows == height and V.cols == dimension() and numeric.independent(V),
    )


def _that(label: str, answer: str, holds: Any) -> Check:
    return numeric.check_residual(label, "numpy.linalg.svd", lambda: 0.0 if holds() else float("inf"), answer=answer)


@fundamental_subspaces.consequence("rank", of=("column_space",), symbolic=False)
def number_of_columns(_given: Any, found: Mapping[str, Any]) -> Any:
    """The dimension of the column space."""
    return sp.Integer(found["column_space"].cols)


@fundamental_subspaces.consequence("rank", of=("row_space",), symbolic=False)
def number_of_rows(_given: Any, found: Mapping[str, Any]) -> Any:
    """The dimension of the row space."""
    return sp.Integer(found["row_space"].cols)
