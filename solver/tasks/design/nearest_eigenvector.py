"""One eigenvector of the closed loop as a lemma: what is attainable for its pole, and the nearest to the wanted one."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from solver.arithmetic.row_operations import row_operations
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, quotient, total
from solver.stated.complex_numbers import conjugate, norm
from solver.stated.matrices import inverse, transpose

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

DIGITS = 30
"""Significant digits of an angle."""


@lemma("nearest_eigenvector")
def nearest_eigenvector_of(
    A: ImmutableMatrix, B: ImmutableMatrix, pole: Expr, wanted: ImmutableMatrix, *, i: int, alike: Sequence[int]
) -> Derivation[exact.Nearest]:
    """The attainable eigenvector for pole i (counted from 1) nearest to the wanted one (n×1).

    `alike` are the numbers of all poles equal to it; what is attainable is shown for the first of them only. Raises
    Unsolved if there are fewer independent eigenvectors than equal poles, or if all are orthogonal to the wanted one.
    """
    attainable = exact.attainable_eigenvectors(A, B, pole)
    if alike[0] == i:
        yield _attainable(attainable, alike)
    if len(alike) > attainable.N.cols:
        raise Unsolved("placement/too_few_eigenvectors", pole=pole, count=len(alike), dimension=attainable.N.cols)
    nearest = exact.nearest_eigenvector(attainable, wanted)
    if nearest.share == 0:
        raise Unsolved("placement/orthogonal_eigenvector", i=i, pole=pole)
    yield _nearest(attainable, nearest, wanted, i=i, like=alike[0])
    return nearest


def _attainable(attainable: exact.Attainable, alike: Sequence[int]) -> Step:
    """What is attainable for one pole: the null space of [B, λI − A], w before v."""
    N, M, matrix, m = attainable.N, attainable.M, attainable.matrix, attainable.M.rows
    stacked = sp.ImmutableMatrix(sp.Matrix.vstack(sp.Matrix(M), sp.Matrix(N)))
    zero = sp.ImmutableMatrix(sp.zeros(matrix.rows, N.cols))
    return Step(
        "attainable",
        claims={
            "solutions": Claim(product(matrix, stacked), zero, r"$B w + (\lambda I - A) \nu = 0$"),
            "equations": Claim(
                total(product(sp.ImmutableMatrix(matrix[:, :m]), M), product(sp.ImmutableMatrix(matrix[:, m:]), N)),
                zero,
                r"$B w + (\lambda I - A) \nu = 0$",
            ),
        },
        steps=row_operations(matrix, exact.row_reduction(matrix)),
        alike=alike,
        pole=attainable.pole,
        matrix=matrix,
        N=N,
        M=M,
        n=matrix.rows,
        m=m,
    )


def _nearest(
    attainable: exact.Attainable,
    nearest: exact.Nearest,
    wanted: ImmutableMatrix,
    *,
    i: int,
    like: int,
) -> Step:
    """The vector taken for pole i: the wanted one itself, or its orthogonal projection on what is attainable.

    `like` is the number of the first equal pole, whose step shows what is attainable.
    """
    degrees = degrees_off(nearest)
    N, M = attainable.N, attainable.M
    squares = exact.squared_length(nearest.v), exact.squared_length(wanted)
    claims = {
        "v": Claim(product(N, nearest.p), nearest.v, "nearest attainable eigenvector"),
        "w": Claim(product(M, nearest.p), nearest.w, r"$K \nu$"),
    }
    if nearest.share != 1:
        adjoint = transpose(conjugate(N)) if N.has(sp.I) else transpose(N)
        claims["gram"] = Claim(product(adjoint, N), nearest.gram, "matrix of the normal equations")
        claims["right"] = Claim(product(adjoint, wanted), nearest.right, "right side of the normal equations")
        claims["solution"] = Claim(product(inverse(nearest.gram), nearest.right), nearest.p, "normal equations")
        rest = sp.ImmutableMatrix((wanted - nearest.v).applyfunc(exact.tidy))
        claims["rest"] = Claim(difference(wanted, nearest.v), rest, "what cannot be had")
        claims["length"] = Claim(power(norm(nearest.v), 2), squares[0], "squared length")
        claims["cosine"] = Claim(quotient(*squares), nearest.share, "squared cosine of the angle")
        if degrees is not None:
            claims["angle"] = Claim(_angle(nearest) * 180 / sp.pi, degrees, "angle in degrees")
    return Step(
        "nearest",
        claims=claims,
        i=i,
        like=like,
        pole=attainable.pole,
        wanted=wanted,
        p=nearest.p,
        conjugate=exact.conjugated(N),
        taken=bool(nearest.share == 1),
        complex=N.has(sp.I),
        alone=N.cols == 1,
        unit=bool(squares[1] == 1),
        angle=_angle(nearest),
        degrees=degrees,
    )


def _angle(nearest: exact.Nearest) -> Expr:
    """The angle between the wanted vector and the one taken, in radians."""
    found: Expr = sp.acos(sp.sqrt(nearest.share))
    return found


def degrees_off(nearest: exact.Nearest) -> Expr | None:
    """The angle between the wanted vector and the one taken in degrees, 0 to 90; None with parameters."""
    if nearest.share == 1:
        return sp.Integer(0)
    if nearest.share.free_symbols:
        return None
    found: Expr = sp.N(_angle(nearest) * 180 / sp.pi, DIGITS)
    return found
