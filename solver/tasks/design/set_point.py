"""Following a constant reference, as lemmas: the set point, and the gain of the reference."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.arithmetic.determinants import expanded, first_line
from solver.arithmetic.equations import system_solved
from solver.arithmetic.exactness import where_exact
from solver.arithmetic.products import multiplied
from solver.derivation import Answers, Check, Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import design as judges
from solver.stated import Stated
from solver.stated.algebra import product, total
from solver.stated.matrices import determinant, inverse, transpose
from solver.tasks.design.frames import free_symbols
from solver.tasks.figures import step_of_the_reference
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.derivation.figures import Motion
    from solver.tasks.needed import WithBoth


def feedthrough(plant: Any) -> ImmutableMatrix:
    """D, zero where the plant has none (p×m)."""
    return plant.D if plant.D is not None else sp.ImmutableMatrix(sp.zeros(plant.C.rows, plant.B.cols))


def equations_of_rest(plant: Any) -> ImmutableMatrix:
    """[[A, B], [C, D]], in discrete time with A − I."""
    A = plant.A - sp.eye(plant.order) if plant.discrete else plant.A
    return sp.ImmutableMatrix(sp.Matrix(sp.BlockMatrix([[A, plant.B], [plant.C, feedthrough(plant)]])))


def set_point_checks(plant: Any, answers: Answers, K: ImmutableMatrix | None = None) -> Iterable[Check]:
    """F, N and K_o (with the gain K) belong to a set point: each by itself, and those that are present together."""
    n, m, p = plant.order, plant.B.cols, plant.C.rows
    M, identity = equations_of_rest(plant), sp.eye(n + m)
    rows = {"F": identity[:n, :], "N": identity[n:, :]}
    if K is not None and K.shape == (m, n):
        rows["K_o"] = sp.Matrix(K).row_join(sp.eye(m))
    conditions = {name: (sp.ImmutableMatrix(L), answers[name]) for name, L in rows.items() if name in answers}
    labels = {"F": "$x_d = Fr$ is a state of rest with $y = r$", "N": "$u_d = Nr$ holds the plant at rest with $y = r$"}
    for name, condition in conditions.items():
        yield numeric.check_residual(
            labels.get(name, "$u = -Kx + K_or$ brings $y$ to $r$"),
            "numpy.linalg.lstsq",
            partial(judges.set_point_residual, M, p, [condition]),
            answer=name,
        )
    if len(conditions) > 1:
        yield numeric.check_residual(
            Phrase("${conditions}$ belong to the same set point", conditions=", ".join(conditions)),
            "numpy.linalg.lstsq",
            lambda: judges.set_point_residual(M, p, list(conditions.values())),
        )


def determinant_of_rest(M: ImmutableMatrix, det: Expr) -> tuple[dict[str, Claim], tuple[Step, ...]]:
    """The determinant of the equations of rest: claims, with the first line of its expansion, and further lines."""
    claims = {
        "determinant": Claim(determinant(M), det, "determinant of the matrix of the steady state"),
        "stated": Claim(determinant(M), first_line(M), Phrase("the determinant expanded")),
    }
    return claims, expanded(M, exact.multiplied_out(det))


@where_exact
def rest_by_elimination(found: exact.SetPoint) -> tuple[Step, ...]:
    """The equations of rest for one reference solved for F and N; nothing for several, or for many solutions."""
    M, n = found.matrix, found.F.rows
    if found.F.cols > 1 or not M.is_square:
        return ()
    unknowns = (*free_symbols((M,), n, "fvw"), *free_symbols((M,), M.cols - n, "nu"))
    left = (M * sp.Matrix(unknowns)).flat()
    return system_solved(list(zip(left, found.right.flat(), strict=True)), unknowns, found.stacked.flat())


@lemma("set_point")
def set_point_of(plant: Any) -> Derivation[exact.SetPoint]:
    """F and N with x_d = F r, u_d = N r: the plant rests there with the output r. Raises Unsolved if there are none."""
    A, B, C, D = plant.A, plant.B, plant.C, feedthrough(plant)
    n, m, p = A.rows, B.cols, C.rows
    try:
        found = exact.set_point(A, B, C, D, discrete=plant.discrete)
    except exact.NoSetPoint as finding:
        raise Unsolved("tracking/no_set_point", rank=finding.rank, n=n, m=m, p=p, discrete=plant.discrete) from finding
    M, right = found.matrix, found.right
    square, steps = m == p and found.unique, rest_by_elimination(found)
    claims = {"solution": Claim(product(M, found.stacked), right, "the set point")}
    if square:
        more, lines = determinant_of_rest(M, exact.determinant(M))
        claims, steps = claims | more, lines + steps
    elif found.rank == n + p:
        claims["least"] = Claim(least_solution(found), found.stacked, "the least solution")
    yield Step(
        "set_point",
        claims=claims,
        M=M,
        right=right,
        F=found.F,
        N=found.N,
        n=n,
        m=m,
        p=p,
        discrete=plant.discrete,
        square=square,
        unique=found.unique,
        full=found.rank == n + p,
        exceptions=found.exceptions,
        steps=steps,
    )
    return found


def least_solution(found: exact.SetPoint) -> Stated:
    """Mᵀ(MMᵀ)⁻¹ [0; I] as stated, for a matrix M of independent rows."""
    M = found.matrix
    return product(transpose(M), inverse(product(M, transpose(M))), found.right)


@lemma("set_point")
def reference_gain(K: ImmutableMatrix, found: exact.SetPoint, plant: WithBoth) -> Derivation[ImmutableMatrix]:
    """K_o = N + K F in u = −K x + K_o r, and what the loop does."""
    K_o = sp.ImmutableMatrix((found.N + K * found.F).applyfunc(exact.tidy))
    stated = total(found.N, product(K, found.F))
    yield Step(
        "reference_gain",
        claims={"K_o": Claim(stated, K_o, "gain of the reference")},
        figures=after_a_step(plant, K, K_o),
        steps=multiplied(K, found.F, exact.added(K * found.F)),
    )
    return K_o


def after_a_step(plant: WithBoth, K: ImmutableMatrix, K_o: ImmutableMatrix) -> tuple[Motion, ...]:
    """What y and u do after a step of the reference."""
    D = feedthrough(plant)
    loop, seen = exact.added(plant.A, -plant.B * K), exact.added(plant.C, -D * K)
    forward = exact.added(plant.B * K_o), exact.added(D * K_o)
    control = (sp.ImmutableMatrix(-K), K_o)
    return step_of_the_reference(loop, forward[0], (seen, forward[1]), control, discrete=plant.discrete)
