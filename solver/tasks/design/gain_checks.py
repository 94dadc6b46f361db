"""Judging a state feedback by its defining property: the spectrum of A − BK."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Check, Claim
from solver.lazy import numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import design as judges
from solver.stated.algebra import difference, product
from solver.tasks.design.frames import characteristic, unknown_gains

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol


@dataclass(frozen=True)
class Asked:
    """A question about K (m×n) for A n×n, B n×m: the poles asked for, and the shape of the row K if one is given."""

    A: ImmutableMatrix
    B: ImmutableMatrix
    poles: Sequence[Expr]
    x: Symbol
    row: ImmutableMatrix | None = None
    unknowns: Sequence[Symbol] = ()


def judge_gain(asked: Asked, answers: Answers, K_name: str = "K", loop_name: str = "closed_loop_A") -> Iterable[Check]:
    """Judge the gain, the closed loop and its polynomial, each alone, and A − BK together."""
    A, B, poles, shape = asked.A, asked.B, asked.poles, (asked.row, asked.unknowns)
    K, loop = answers.get(K_name), answers.get(loop_name)
    if K is not None:
        yield numeric.check_residual(
            r"$\det(xI - A + BK) = \prod_i (x - p_i)$ at random $x$",
            "numpy.linalg.det",
            lambda: judges.placed_residual(A, B, K, poles, *shape),
            answer=K_name,
        )
    if K is not None and asked.row is not None:
        yield numeric.check_residual(
            "$K$ has the shape asked for",
            "numpy.linalg.lstsq",
            lambda: judges.fit_residual(asked.row, asked.unknowns, K),
            answer=K_name,
        )
    if loop is not None:
        yield numeric.check_residual(
            "the closed loop has the poles asked for",
            "numpy.linalg.det",
            lambda: judges.placed_matrix_residual(A, B, loop, poles, *shape),
            answer=loop_name,
        )
        yield numeric.check_residual(
            "$A$ less the closed loop is $B$ times a gain",
            "numpy.linalg.lstsq",
            lambda: judges.range_residual(A, B, loop),
            answer=loop_name,
        )
    if loop is not None and K is not None and K.shape == (B.cols, A.rows):
        yield numeric.check_claim(Claim(difference(A, product(B, K)), loop), "$A - BK$", answer=loop_name)
    if "polynomial" in answers:
        yield numeric.check_residual(
            "the polynomial has the roots asked for",
            "random points",
            lambda: judges.roots_residual(answers["polynomial"], asked.x, A, B, poles, *shape),
            answer="polynomial",
        )


def judge_gain_polynomial(asked: Asked, polynomial: Any) -> Check:
    """Compare with det(xI − A + BK) for the unknown row K."""
    label = r"$\det(xI - A + BK)$ with unknown $K$"
    if asked.B.cols > 1:
        return Check.skipped(label, "numpy.linalg.det", "there are several inputs", answer="gain_polynomial")
    row = asked.row if asked.row is not None else sp.ImmutableMatrix([unknown_gains((asked.A, asked.B), asked.poles)])
    loop = difference(asked.A, product(asked.B, row))
    return numeric.check_claim(
        Claim(characteristic(loop, asked.x, asked.A.rows), polynomial), label, answer="gain_polynomial"
    )
