"""Comparison of coefficients: the gain of one input by linear equations for its entries, in a pair's frame."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from solver.arithmetic.equations import eliminated
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product
from solver.tasks.design.comparison import compared
from solver.tasks.design.frames import Pair, Placement, characteristic, expansion_of, movable_poles
from solver.tasks.linear_algebra.characteristic_polynomial import coefficients_of_companion

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol


@lemma("coefficient_matching")
def matched(pair: Pair, shape: ImmutableMatrix | None = None, unknowns: Sequence[Symbol] = ()) -> Derivation[Placement]:
    """Equate the coefficients of det(xI − A + bk) and of the desired polynomial and solve for the unknowns in k.

    `shape` is the row k with unknowns in it (affine), by default all entries unknown. A factor of the determinant
    that holds no unknown is fixed: its roots stay where they are.
    """
    frame, A, b, x = pair.frame, pair.A, pair.b, pair.x
    unknowns = unknowns or pair.unknowns
    row = shape if shape is not None else sp.ImmutableMatrix([unknowns])
    loop = sp.ImmutableMatrix(A - b * row)
    yield Step(
        "unknown_gain",
        claims={
            "loop": Claim(
                difference(frame.shown(A), frame.times(frame.shown(b), frame.shown(row))),
                frame.shown(loop),
                "closed loop with the unknown gain",
            )
        },
        row=frame.shown(row),
        structured=shape is not None,
        **pair.flags,
    )
    coefficients = exact.loop_coefficients(A, b, row, unknowns)
    gain_polynomial = exact.polynomial_in(x, coefficients)
    claims, lines = expansion_of(frame.shown(loop), x, gain_polynomial)
    claims["polynomial"] = Claim(characteristic(frame.shown(loop), x), gain_polynomial, "closed-loop polynomial")
    yield Step(
        "gain_polynomial",
        claims=claims,
        row=frame.shown(row),
        companion=coefficients_of_companion(frame.shown(loop)),
        steps=lines,
        **pair.flags,
    )
    fixed, movable, rest = yield from _fixed_part(pair, coefficients, row, unknowns, structured=shape is not None)
    desired = list(exact.monic(movable)) if fixed else list(pair.desired)
    full = list(exact.monic([*movable, *fixed])) if fixed else desired
    solution, k = yield from _equated(pair, rest, desired, row, unknowns)
    values = dict(zip(unknowns, solution.values, strict=True))
    free = tuple(unknowns[j] for j in solution.free)
    conditions = tuple(sp.Eq(unknown, value) for unknown, value in values.items() if unknown not in free)
    return Placement(k, A, exact.polynomial_in(x, full), gain_polynomial, fixed, free, conditions)


@lemma("coefficient_matching")
def _fixed_part(
    pair: Pair, coefficients: Sequence[Expr], row: ImmutableMatrix, unknowns: Sequence[Symbol], *, structured: bool
) -> Derivation[tuple[list[Expr], list[Expr], Sequence[Expr]]]:
    """Split off the factor without unknowns; returns its roots, the poles to be placed, and the other factor."""
    divisor = exact.fixed_factor(pair.A, pair.b, row, unknowns)
    fixed = exact.roots_of(divisor)
    if not fixed:
        return [], list(pair.poles), coefficients
    x, n = pair.x, pair.A.rows
    rest = exact.divided(coefficients, divisor)
    movable = movable_poles(pair.poles, fixed, n, dual=pair.frame.dual)
    split = product(exact.polynomial_in(x, divisor), exact.polynomial_in(x, rest))
    desired = exact.polynomial_in(x, exact.monic(movable))
    yield Step(
        "fixed_factor",
        claims={
            "split": Claim(exact.polynomial_in(x, coefficients), split, "the factor without unknowns"),
            "movable": Claim(
                product(*(difference(x, pole) for pole in movable)), desired, "polynomial of the movable poles"
            ),
        },
        fixed=fixed,
        movable=movable,
        all_given=len(pair.poles) == n,
        structured=structured,
        **pair.flags,
    )
    return fixed, movable, rest


@lemma("coefficient_matching")
def _equated(
    pair: Pair,
    coefficients: Sequence[Expr],
    desired: Sequence[Expr],
    row: ImmutableMatrix,
    unknowns: Sequence[Symbol],
) -> Derivation[tuple[exact.Solution, ImmutableMatrix]]:
    """Coefficient by coefficient: linear equations for the unknowns, their solution, and the row k with it."""
    found = compared(coefficients[1:], desired[1:], unknowns)
    solution = found.solution
    yield Step(
        "equations",
        unclaimed="the equations define the gain; they are checked when it is found",
        equations=found.equations,
        **pair.flags,
    )
    if solution.residue:
        raise Unsolved("placement/contradiction")
    values = dict(zip(unknowns, solution.values, strict=True))
    k = sp.ImmutableMatrix(row.applyfunc(lambda entry: exact.tidy(entry.subs(values, simultaneous=True))))
    yield Step(
        "solution",
        claims={"equations": found.claim(solution.values)},
        found=[(u, value) for u, value in zip(unknowns, solution.values, strict=True) if u != value],
        alone=all(len(left.free_symbols & set(unknowns)) < 2 for left, _ in found.equations),
        free=found.free,
        gain=pair.frame.shown(k),
        steps=eliminated(found.equations, unknowns, solution.values),
        **pair.flags,
    )
    return solution, k
