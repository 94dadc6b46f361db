"""What a wrong value would mean, in the student's terms: the poles that a gain gives, what A does with a vector.

What is told follows from the value and the question alone; our answer is never in it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt
from solver.lazy import numeric
from solver.lazy import sympy as sp
from solver.tasks.told import alike, short, shortened, spectrum, told
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

POINTS = (1, 2, 3)
NEAR = 1e-2
"""A vector that A turns by less may be an eigenvector in rounded numbers."""


def poles_given(loop: ImmutableMatrix, asked: Sequence[Expr], beside: str = "") -> Reason | None:
    """Return the poles of a loop beside those asked for; None where they look alike, or the loop holds symbols.

    `beside` is the symbol of another value of the student's that the loop is made of.
    """
    found, wanted = spectrum(loop), told(asked)
    if found is None or found == wanted:
        return None
    return Reason("meanings/poles", {"found": found, "wanted": wanted, "beside": beside})


def sum_of_poles(part: ImmutableMatrix, asked: Sequence[Expr]) -> Reason | None:
    """Return the trace of the block of a loop in which its poles add up, beside the sum of those asked for."""
    own, wanted = short(part.trace()), short(sp.Add(*asked))
    told_apart = own.is_number and wanted.is_number and own != wanted
    return Reason("meanings/sum_of_poles", {"own": own, "wanted": wanted}) if told_apart else None


def unstable(loop: ImmutableMatrix, *, discrete: bool) -> Reason | None:
    """Return the poles of a loop that is not asymptotically stable, None for one that is."""
    found = spectrum(loop)
    sizes = [complex(each.at + sp.I * (each.beside or 0)) for each in found or ()]
    if all(abs(z) < 1 if discrete else z.real < 0 for z in sizes):
        return None
    return Reason("meanings/unstable", {"found": found})


def roots_given(polynomial: Expr, x: Any, asked: Sequence[Expr]) -> Reason | None:
    """Return the roots of a polynomial beside those asked for."""
    if polynomial.free_symbols - {x} or not polynomial.is_polynomial(x):
        return None
    found, wanted = told(_roots(sp.Poly(polynomial, x))), told(asked)
    return None if found == wanted or not found else Reason("meanings/roots", {"found": found, "wanted": wanted})


def _roots(p: Any) -> list[Any]:
    """The roots of a polynomial, each as often as it occurs: multiple ones converge slowly, if at all."""
    return [root for part, times in p.sqf_list()[1] for root in part.nroots(n=30, maxsteps=500) * times]


def no_eigenvalue(wrong: Attempt[Any, Any]) -> Reason | None:
    """Return a listed value that is no eigenvalue of A, or how many there must be, or their sum."""
    return not_in_the_spectrum(wrong.given.system.A, wrong.value)


def not_in_the_spectrum(A: ImmutableMatrix, values: Sequence[Expr]) -> Reason | None:
    """Return a listed value that is no eigenvalue of A, or how many there must be, or what their sum must be."""
    strange = stranger(A, values)
    if strange is not None or A.free_symbols or any(not each.is_number for each in values):
        return strange
    if len(values) != A.rows:
        return Reason("meanings/count", {"count": len(values), "n": A.rows})
    total, trace = short(sp.Add(*values)), short(A.trace())
    return Reason("meanings/trace", {"total": total, "trace": trace}) if total != trace else None


def stranger(A: ImmutableMatrix, values: Sequence[Expr]) -> Reason | None:
    """Return the first of some values that is no eigenvalue of A."""
    known = [each.at + sign * sp.I * (each.beside or 0) for each in spectrum(A) or () for sign in (1, -1)]
    for value in values if known else ():
        if value.is_number and not any(_near(value, other) for other in known):
            determinant = short((value * sp.eye(A.rows) - A).det())
            return Reason("meanings/no_eigenvalue", {"value": short(value), "determinant": determinant})
    return None


def _near(value: Any, other: Any) -> bool:
    return abs(complex(value - other)) < NEAR * max(1.0, abs(complex(other)))


def hidden(wrong: Attempt[Any, Any]) -> Reason | None:
    """Return a listed mode that is no eigenvalue of A."""
    return stranger(wrong.given.system.A, wrong.value)


def turned_by(A: ImmutableMatrix, V: Any, *, rows: bool = False) -> Reason | None:
    """Return a column (or row) of V that A does not map to a multiple of it; None where A has other than such."""
    if V.shape != A.shape or A.free_symbols or V.free_symbols:
        return None
    M, W = (A.T, V.T) if rows else (A, V)
    for j in range(W.cols):
        v, image = W[:, j], M * W[:, j]
        if v.is_zero_matrix or not _along(v, image):
            shown = (shortened(each.T if rows else each) for each in (v, image))
            vector, mapped = (sp.ImmutableMatrix(each) for each in shown)
            return Reason("meanings/turned", {"j": j + 1, "v": vector, "image": mapped, "rows": rows})
    return None


def _along(v: Any, image: Any) -> bool:
    """Whether the image is a multiple of v, but for the rounding of a few digits."""
    own, other = ([complex(x) for x in each] for each in (v, image))
    k = max(range(len(own)), key=lambda i: abs(own[i]))
    factor = other[k] / own[k]
    gap = max(abs(b - factor * a) for a, b in zip(own, other, strict=True))
    return gap <= NEAR * max(1e-12, *(abs(b) for b in other), abs(factor) * abs(own[k]))


def at_a_point(value: Any, formula: Any) -> Reason | None:
    """Return an entry of a value that differs at a point from what a formula of the question gives there."""
    found = difference_of(value, formula)
    return Reason("meanings/at_a_point", found) if found is not None else None


def difference_at(value: Any, formula: Any, x: Any, point: int) -> Reason | None:
    """Return an entry of a value in x that differs at one point from a formula of the question."""
    found = difference_of(value.xreplace({x: sp.Integer(point)}), formula)
    return None if found is None else Reason("meanings/at_a_point", {**found, "x": x, "point": sp.Integer(point)})


def difference_of(left: Any, right: Any) -> dict[str, Any] | None:
    """Return the first entry in which two formulas differ, at a short value of their variable if they have one."""
    symbols = sorted(numeric.free_symbols(left) | numeric.free_symbols(right), key=str)
    if len(symbols) > 1:
        return None
    for point in POINTS if symbols else (0,):
        try:
            a, b = (_values(side, {symbol: complex(point) for symbol in symbols}) for side in (left, right))
        except (numeric.NotEvaluable, numeric.ShapeMismatch):
            continue
        if a.shape != b.shape:
            return None
        for i, j in ((i, j) for i in range(a.rows) for j in range(a.cols) if not alike(a[i, j], b[i, j])):
            at = {"x": symbols[0] if symbols else None, "point": sp.Integer(point)}
            return {**at, "single": a.shape == (1, 1), "i": i + 1, "j": j + 1, "left": a[i, j], "right": b[i, j]}
    return None


def _values(formula: Any, point: Any) -> Any:
    """The values of a formula at a point, as they are told; one number as a matrix of one."""
    found = numeric.evaluate(formula, point)
    rows = [[found]] if isinstance(found, complex) else found.tolist()
    return sp.ImmutableMatrix([[short(sp.Float(z.real) + sp.I * sp.Float(z.imag)) for z in row] for row in rows])


def finite_at(values: Sequence[Expr], formula: Any, x: Any, *, zeros: bool) -> Reason | None:
    """Return the first of some values at which a transfer function is finite, or is not zero where zeros are listed."""
    for value in values:
        try:
            found = _values(formula, {x: complex(value)})
        except numeric.NotEvaluable:
            continue
        size = max(abs(complex(each)) for each in found)
        if found.shape == (1, 1) and (size > NEAR if zeros else size < 1 / NEAR):
            return Reason("meanings/finite", {"x": x, "value": short(value), "G": found[0, 0], "zeros": zeros})
    return None


def _all_alike(M: Any, N: Any) -> bool:
    """Whether two matrices of numbers are told alike, entry by entry."""
    return all(alike(a, b) for a, b in zip(M.flat(), N.flat(), strict=True))


def begins(Phi: ImmutableMatrix, A: ImmutableMatrix, *, discrete: bool) -> Reason | None:
    """Return how a transition matrix begins where that is not with I and A."""
    x = sp.Symbol("k" if discrete else "t")
    if Phi.shape != A.shape or (Phi.free_symbols | A.free_symbols) - {x}:
        return None
    start = shortened(Phi.xreplace({x: sp.Integer(0)}))
    if not _all_alike(start, sp.eye(A.rows)):
        return Reason("meanings/start", {"x": x, "value": start})
    second = Phi.xreplace({x: sp.Integer(1)}) if discrete else Phi.diff(x).xreplace({x: sp.Integer(0)})
    if not _all_alike(second, A):
        return Reason("meanings/second", {"discrete": discrete, "value": shortened(second)})
    return None


def half_plane(wrong: Attempt[Any, Any], modes: Sequence[Expr] | None, *, stable: bool) -> Reason | None:
    """Return that the half-plane was taken for the unit disc, where it gives that modes in discrete time are stable."""
    if not wrong.given.system.discrete or not modes or any(mode.free_symbols for mode in modes):
        return None
    left = all(complex(sp.N(mode, 30)).real < 0 for mode in modes)
    return Reason("meanings/half_plane") if left == stable else None
