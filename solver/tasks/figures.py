"""Figures that many tasks show: poles in the plane, motions. None is drawn where parameters are left."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation.figures import Motion, Plane, Region, Roots, Signals
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.words import formula

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

LARGEST = 6
"""Motions of higher order are not drawn."""


def plane(
    caption: str, *roots: Roots | None, discrete: bool = False, region: Region | None = None, stable: bool = False
) -> tuple[Plane, ...]:
    """Return the figure of some roots, those that are known; nothing where one is no number, or none is there."""
    known = [each for each in roots if each is not None]
    values = [value for each in known for value in each.values]
    if not values or any(value.free_symbols for value in values):
        return ()
    return (Plane(caption, tuple(known), discrete, region, stable),)


def roots(name: str, values: Iterable[Any], sign: str = "cross") -> Roots:
    """Return points of the plane under one name."""
    return Roots(name, tuple(values), sign)


def eigenvalues_of(name: str, A: ImmutableMatrix, sign: str = "cross") -> Roots | None:
    """Return the eigenvalues of A under one name; None where they have no usable form."""
    if A.free_symbols:
        return None
    try:
        return roots(name, exact.spectrum(A).eigenvalues, sign)
    except exact.NotExact:
        return None


def motion(
    caption: str,
    matrix: ImmutableMatrix,
    start: ImmutableMatrix,
    *panels: Signals,
    discrete: bool = False,
    drive: ImmutableMatrix | None = None,
) -> tuple[Motion, ...]:
    """Return the figure of a motion from a start; nothing where parameters are left, or of high order."""
    shown = [each for each in panels if each.names]
    parts = [matrix, start, drive, *(part for each in shown for part in (each.rows, each.offset))]
    if matrix.rows > LARGEST or not shown or any(part.free_symbols for part in parts if part is not None):
        return ()
    return (Motion(caption, matrix, start, tuple(shown), discrete, drive),)


def step_of_the_reference(
    loop: ImmutableMatrix,
    drive: ImmutableMatrix,
    output: tuple[ImmutableMatrix, ImmutableMatrix],
    control: tuple[ImmutableMatrix, ImmutableMatrix],
    *,
    discrete: bool,
) -> tuple[Motion, ...]:
    """Return y and u after a step of all references to 1, from rest; `output` and `control` are rows and offset.

    `drive`, and the offsets, have one column a reference.
    """
    r = sp.ImmutableMatrix(sp.ones(drive.cols, 1))
    rows, through = output
    y = Signals("y", numbered("y", rows.rows), rows, sp.ImmutableMatrix(through * r), ("r", sp.Integer(1)))
    gain, forward = control
    u = inputs(gain, sp.ImmutableMatrix(forward * r))
    rest = sp.ImmutableMatrix(sp.zeros(loop.rows, 1))
    caption = "From rest, after a step of the reference to $r = 1$"
    return motion(caption, loop, rest, y, u, discrete=discrete, drive=sp.ImmutableMatrix(drive * r))


def errors(n: int, of: int | None = None, letter: str = r"\tilde{x}", block: int | None = None) -> Signals:
    """Return the panel of the errors of n estimates, the last states of a motion with `of` states in all.

    They are those of the states, or of the `block` of them that is estimated.
    """
    whole = of or n
    numbers = [f"{block},{i}" if block and n > 1 else f"{block or i}" for i in range(1, n + 1)]
    names = (letter,) if n == 1 and not block else tuple(f"{letter}_{{{number}}}" for number in numbers)
    return Signals(letter, names, sp.ImmutableMatrix(sp.eye(whole)[whole - n :, :]))


def error_of_estimate(
    error: ImmutableMatrix, letter: str = r"\tilde{x}", block: int | None = None, *, discrete: bool
) -> tuple[Motion, ...]:
    """Return how the errors of estimates decay from one; `block` is that of the states estimated, if not all are."""
    caption = "The errors of the estimates, which begin at one"
    return motion(
        caption, error, start_of(None, error.rows), errors(error.rows, None, letter, block), discrete=discrete
    )


def column(x0: ImmutableMatrix) -> str:
    """Return an initial state as LaTeX on one line."""
    return f"{formula(sp.ImmutableMatrix(x0.T))}^{{T}}" if x0.rows > 1 else formula(x0[0, 0])


def states(n: int, of: int | None = None) -> Signals:
    """Return the panel of the n states, of a motion with `of` states in all."""
    return Signals("x", numbered("x", n), sp.ImmutableMatrix(sp.eye(of or n)[:n, :]))


def inputs(rows: ImmutableMatrix, offset: ImmutableMatrix | None = None) -> Signals:
    """Return the panel of the inputs u = rows · z + offset."""
    return Signals("u", numbered("u", rows.rows), rows, offset)


def start_of(x0: ImmutableMatrix | None, n: int) -> ImmutableMatrix:
    """Return the initial state that is given, or one that shows every mode: all states are one."""
    return x0 if x0 is not None and x0.rows == n else sp.ImmutableMatrix(sp.ones(n, 1))


def numbered(letter: str, count: int) -> tuple[str, ...]:
    """Return the names of signals: a letter, with numbers where there are several."""
    return (letter,) if count == 1 else tuple(f"{letter}_{{{i}}}" for i in range(1, count + 1))
