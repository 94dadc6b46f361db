"""The kinds of equilibrium of two states by the signs of what tells where their eigenvalues lie."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from typing import TYPE_CHECKING

from solver.lazy import exact
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

Case = tuple[list[tuple["Expr", int]], list[str]]
"""What has which sign (−1, 0, 1), and the kinds that this leaves."""


def kind_by_signs(A: ImmutableMatrix, tr: int, det: int, discriminant: int) -> str:
    """The kind by the signs of trace, determinant and discriminant."""
    speed = "stable" if tr < 0 else "unstable"
    if det < 0:
        return "saddle"
    if det == 0:
        return "line of equilibria" if tr else "all points are equilibria" if A.is_zero_matrix else "shear"
    if discriminant < 0:
        return f"{speed} focus" if tr else "center"
    if discriminant > 0:
        return f"{speed} node"
    return f"{speed} star" if _is_multiple(A) else f"{speed} degenerate node"


def kind_in_z(A: ImmutableMatrix, at_one: int, at_minus_one: int, size: int, discriminant: int) -> str:
    """The kind in discrete time by the signs of p(1), p(−1), det − 1 and the discriminant; "" for the eigenvalue −1."""
    if at_one == 0:
        return "line of equilibria" if size else "all points are equilibria" if _is_multiple(A) else "shear"
    if at_minus_one == 0:
        return ""
    if at_one * at_minus_one < 0:
        return "saddle"
    speed = "stable" if size < 0 < at_one else "unstable"
    if discriminant < 0:
        return f"{speed} focus" if size else "center"
    if discriminant == 0:
        return f"{speed} star" if _is_multiple(A) else f"{speed} degenerate node"
    return f"{speed} node"


def _is_multiple(A: ImmutableMatrix) -> bool:
    """Whether A is a multiple of the identity, given that it has a double eigenvalue."""
    return bool(A[0, 1] == 0 and A[1, 0] == 0)


def other_cases(A: ImmutableMatrix, values: Sequence[Expr], found: exact.PlanarSigns) -> Iterator[Case]:
    """Yield the cases beside the general one in which the kind is another (trace, determinant, discriminant of A)."""
    general, seen = kind_by_signs(A, *found.signs), []
    for kind in _kinds(A, found.signs)[1:]:
        beside = [(x, 0) for x in (A[0, 1], A[1, 0]) if x != 0]
        yield [*_case(values, found.signs, found.open), *beside], [kind]
    for signs in product((-1, 0, 1), repeat=3):
        known = all(is_open or sign == own for sign, own, is_open in zip(signs, found.signs, found.open, strict=True))
        if not known or not _go_together(*signs) or kind_by_signs(A, *signs) == general:
            continue
        case = _case(values, signs, found.open)
        if case not in seen and not _impossible(case):
            seen.append(case)
            yield case, _kinds(A, signs)


def _case(values: Sequence[Expr], signs: Sequence[int], are_open: Sequence[bool]) -> list[tuple[Expr, int]]:
    """The signs that are open and needed to tell the case."""
    told = zip(values, signs, are_open, _telling(*signs[1:]), strict=True)
    return [(x, sign) for x, sign, is_open, tells in told if is_open and tells]


def _go_together(tr: int, det: int, discriminant: int) -> bool:
    """Whether tr² − 4 det can have this sign."""
    if det < 0:
        return discriminant > 0
    return discriminant == abs(tr) if det == 0 else discriminant < 0 or tr != 0


def _telling(det: int, discriminant: int) -> tuple[bool, bool, bool]:
    """Whether the signs of trace, determinant, discriminant are needed to tell the case; others follow from them."""
    if det <= 0:
        return det == 0, True, False
    return True, discriminant > 0, True


def _impossible(case: Sequence[tuple[Expr, int]]) -> bool:
    """Whether no values of the parameters have these signs, as far as it is seen."""
    return bool(exact.all_positive([sign * x for x, sign in case if sign]) is sp.false)


def _kinds(A: ImmutableMatrix, signs: Sequence[int]) -> list[str]:
    """The kind; two of them where it also matters whether A is a multiple of the identity."""
    kind = kind_by_signs(A, *signs)
    if "degenerate" not in kind and kind != "shear":
        return [kind]
    if any(exact.sign_of(x) in (1, -1) for x in (A[0, 1], A[1, 0])):
        return [kind]
    return [kind, "all points are equilibria" if kind == "shear" else kind.replace("degenerate node", "star")]
