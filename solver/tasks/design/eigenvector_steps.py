"""The steps that find one eigenvector: what is attainable for its pole, and of that the nearest to the wanted one."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from solver.derivation import Claim, Step
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, quotient, total
from solver.stated.complex_numbers import conjugate, norm
from solver.stated.matrices import inverse, transpose
from solver.tasks.structure.row_operations import row_operations

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

DIGITS = 30
"""Significant digits of an angle."""


def attainable_step(attainable: exact.Attainable, alike: Sequence[int]) -> Step:
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


def nearest_step(
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
