"""Pole placement as lemmas: for a state feedback K, and by duality for an observer gain L.

L of (A, C) is the transpose of the gain K of (Aᵀ, Cᵀ). Everything is computed for the pair (A, B); a `Frame` writes it
down, transposed for an observer, so that each formula appears in the form in which the reader knows it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Literal

from solver.arithmetic.determinants import expanded, first_line
from solver.arithmetic.factors import factors_multiplied
from solver.arithmetic.inverses import inverted
from solver.arithmetic.products import is_worked_out, multiplied, rows_times_columns
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, total
from solver.stated.matrices import determinant, inverse
from solver.tasks.design.coefficient_matching import matched
from solver.tasks.design.frames import (
    Frame,
    Pair,
    Placement,
    Wanted,
    characteristic,
    expansion_of,
    linear_factors,
    movable_poles,
)
from solver.tasks.design.placement_methods import METHODS
from solver.tasks.figures import eigenvalues_of, plane
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.derivation.figures import Plane

__all__ = ["Placement", "closed_loop_of", "desired_polynomial_of", "place"]


@lemma("placement")
def desired_polynomial_of(
    poles: Sequence[Expr], x: Symbol, *, dual: bool = False, partial: bool = False
) -> Derivation[tuple[Expr, ...]]:
    """Π (x − pᵢ), multiplied out; returns its coefficients, highest power first. `partial`: there are other poles."""
    coefficients: tuple[Expr, ...] = exact.monic(poles)
    polynomial = exact.polynomial_in(x, coefficients)
    yield Step(
        "desired",
        claims={"polynomial": Claim(linear_factors(x, poles), polynomial, "desired characteristic polynomial")},
        x=x,
        poles=list(poles),
        dual=dual,
        partial=partial,
        steps=factors_multiplied(x, poles),
    )
    return coefficients


@lemma("placement")
def place(
    A: ImmutableMatrix,
    B: ImmutableMatrix,
    poles: Sequence[Expr],
    method: str,
    *,
    x: Symbol,
    dual: bool = False,
    named: Literal["", "augmented", "current"] = "",
    wanted: Wanted | None = None,
) -> Derivation[Placement]:
    """Find K (m×n) with det(xI − A + BK) = Π(x − pᵢ). `dual`: B is C (p×n), the gain is L (n×p) of A − LC.

    `poles` are all n, or those of the controllable (observable) part; `method` is one of METHODS. Several inputs are
    joined to one first. `named` as "augmented", A and B are those of a plant with integrators; as "current", B is C A.
    Raises Unsolved if a mode that no gain moves is not among n poles.
    """
    wanted = wanted or Wanted()
    frame = Frame(
        dual, several=(B.rows if dual else B.cols) > 1, augmented=named == "augmented", current=named == "current"
    )
    plant, inputs = frame.shown(A), frame.shown(B)
    desired = wanted.coefficients or (
        yield from desired_polynomial_of(poles, x, dual=frame.dual, partial=len(poles) < A.rows)
    )
    reduction = yield from _one_input(frame, plant, inputs)
    loop = plant if reduction.preliminary is None else sp.ImmutableMatrix(plant - inputs * reduction.preliminary)
    b = sp.ImmutableMatrix(inputs * reduction.g)
    pair = Pair(frame.reduced(shifted=reduction.preliminary is not None), loop, b, x, desired, poles)
    order = yield from _controllability(pair)
    if method == "coefficient_matching":
        found = yield from matched(pair, wanted.row, wanted.unknowns)
    elif order == plant.rows:
        k = yield from METHODS[method](pair)
        found = Placement(k, loop, exact.polynomial_in(x, desired))
    else:
        found = yield from _part_placed(pair, poles, method)
    K = yield from _all_inputs(pair.frame, reduction, found.K)
    yield from closed_loop_of(
        frame, plant, inputs, K, found.polynomial, x, by_comparison=method == "coefficient_matching"
    )
    gain_polynomial = None if frame.several else found.gain_polynomial
    loop = frame.shown(sp.ImmutableMatrix((plant - inputs * K).applyfunc(exact.tidy)))
    return replace(found, K=frame.shown(K), loop=loop, gain_polynomial=gain_polynomial)


@lemma("placement")
def _one_input(frame: Frame, A: ImmutableMatrix, B: ImmutableMatrix) -> Derivation[exact.Direction]:
    """Several inputs: choose g with (A, Bg), if need be (A − BK₀, Bg), as controllable as (A, B)."""
    if not frame.several:
        return exact.Direction(sp.ImmutableMatrix([[1]]), None)
    found = exact.direction(A, B)
    if found is None:
        raise Unsolved("placement/no_single_input")
    claims = {"input": Claim(frame.times(frame.shown(B), frame.shown(found.g)), frame.shown(B * found.g), "one input")}
    if found.preliminary is not None:
        K0 = found.preliminary
        stated = difference(frame.shown(A), frame.times(frame.shown(B), frame.shown(K0)))
        claims["preliminary"] = Claim(stated, frame.shown(A - B * K0), "loop with the preliminary gain")
    yield Step(
        "one_input",
        claims=claims,
        g=frame.shown(found.g),
        K0=None if found.preliminary is None else frame.shown(found.preliminary),
        m=B.cols,
        **_named(frame),
    )
    return found


@lemma("placement")
def _controllability(pair: Pair) -> Derivation[int]:
    """The matrix [b, Ab, …, Aⁿ⁻¹b], its columns, its determinant and its rank; one below n is worth a step later."""
    frame, A, b, n = pair.frame, pair.A, pair.b, pair.A.rows
    C_o = exact.controllability_matrix(A, b)
    line = "row {i} of the observability matrix" if frame.dual else "column {i} of the controllability matrix"
    claims = {}
    for i in range(1, n):
        factors, says = frame.ordered(frame.shown(A), frame.shown(C_o[:, i - 1])), Phrase(line, i=i + 1)
        claims[f"column{i + 1}"] = Claim(product(*factors), frame.shown(C_o[:, i]), says)
        if is_worked_out(*factors):
            claims[f"entries{i + 1}"] = Claim(product(*factors), rows_times_columns(*factors), says)
    det = exact.determinant(C_o)
    shown = frame.shown(C_o)
    claims["determinant"] = Claim(determinant(shown), det, "its determinant")
    claims["stated"] = Claim(determinant(shown), first_line(shown), Phrase("the determinant expanded"))
    order = exact.reachable_order(A, b)
    lines = expanded(shown, exact.multiplied_out(det))
    sure = not det.free_symbols or bool(det.is_nonzero)
    values = {"C_o": shown, "det": det, "order": order, "n": n, "sure": sure}
    yield Step("controllability", claims=claims, steps=lines, **values, **pair.flags)
    if order == 0:
        raise Unsolved("placement/nothing_reached", dual=frame.dual)
    return order


@lemma("placement")
def _part_placed(pair: Pair, poles: Sequence[Expr], method: str) -> Derivation[Placement]:
    """Place the poles of the controllable part; the others stay where they are."""
    frame, x, part = pair.frame, pair.x, exact.controllable_part(pair.A, pair.b)
    shown, r, A_c, A_u = frame.shown, part.orders[0], part.block(0, 0), part.block(1, 1)
    b, b_c = sp.ImmutableMatrix(part.B), sp.ImmutableMatrix(part.input_block(0))
    back = shown(sp.ImmutableMatrix(part.T_inverse))
    fixed_chi = exact.faddeev_leverrier(A_u).coefficients
    fixed = exact.roots_of(fixed_chi)
    yield Step(
        "decomposition",
        claims={
            "inverse": Claim(inverse(shown(part.T)), back, "$T^{-1}$"),
            "A": Claim(frame.times(back, shown(pair.A), shown(part.T)), shown(part.A), r"$T^{-1} A T$"),
            "B": Claim(frame.times(back, shown(pair.b)), shown(b), r"$T^{-1} b$"),
            "fixed": Claim(characteristic(shown(A_u), x), linear_factors(x, fixed), "fixed modes"),
        },
        T=shown(part.T),
        A_c=shown(A_c),
        b_c=shown(b_c),
        A_u=shown(A_u),
        fixed=fixed,
        order=r,
        steps=inverted("T", shown(part.T), back),
        **pair.flags,
    )
    movable = movable_poles(poles, fixed, pair.A.rows, dual=frame.dual)
    desired = exact.monic(movable)
    full = exact.monic([*movable, *fixed])
    yield Step(
        "movable",
        claims={"movable": Claim(linear_factors(x, movable), exact.polynomial_in(x, desired), "movable poles")},
        fixed=fixed,
        movable=list(movable),
        all_given=len(poles) == pair.A.rows,
        **pair.flags,
    )
    inner = Pair(frame.part(), A_c, b_c, x, desired, poles)
    k_c = yield from METHODS[method](inner)
    k, free = exact.lifted_gain(part, k_c, pair.unknowns)
    stretched = sp.ImmutableMatrix([[*k_c.flat(), *free]])
    yield Step(
        "lift",
        claims={"gain": Claim(frame.times(shown(stretched), back), shown(k), "original coordinates")},
        stretched=shown(stretched),
        free=list(free),
        order=r,
        **pair.flags,
    )
    return Placement(k, pair.A, exact.polynomial_in(x, full), None, fixed, free)


@lemma("placement")
def _all_inputs(frame: Frame, reduction: exact.Direction, k: ImmutableMatrix) -> Derivation[ImmutableMatrix]:
    """K = K₀ + g k of several inputs."""
    if not frame.several:
        return k
    g, K0 = reduction.g, reduction.preliminary
    K = sp.ImmutableMatrix(((K0 if K0 is not None else sp.zeros(g.rows, k.cols)) + g * k).applyfunc(exact.tidy))
    stated = frame.times(frame.shown(g), frame.shown(k))
    if K0 is not None:
        stated = total(frame.shown(K0), stated)
    yield Step("all_inputs", claims={"gain": Claim(stated, frame.shown(K), "gain of all inputs")}, **_named(frame))
    return K


@lemma("placement")
def closed_loop_of(
    frame: Frame,
    A: ImmutableMatrix,
    B: ImmutableMatrix,
    K: ImmutableMatrix,
    polynomial: Expr,
    x: Symbol,
    *,
    by_comparison: bool = False,
) -> Derivation[None]:
    """A − BK and its characteristic polynomial, which is the one asked for; found `by_comparison` it is known."""
    loop = frame.shown(sp.ImmutableMatrix((A - B * K).applyfunc(exact.tidy)))
    left, right = frame.ordered(frame.shown(B), frame.shown(K))
    fed_back = frame.shown(sp.ImmutableMatrix((B * K).applyfunc(exact.tidy)))
    claims, lines = ({}, ()) if by_comparison else expansion_of(loop, x, polynomial)
    yield Step(
        "closed_loop",
        claims={
            **claims,
            "loop": Claim(difference(frame.shown(A), product(left, right)), loop, "closed loop"),
            "polynomial": Claim(characteristic(loop, x), polynomial, "characteristic polynomial of the closed loop"),
        },
        figures=_moved(frame.shown(A), loop, dual=frame.dual, discrete=x.name == "z"),
        K=frame.shown(K),
        x=x,
        steps=multiplied(left, right, fed_back) + lines,
        **_named(frame),
    )


def _moved(before: ImmutableMatrix, after: ImmutableMatrix, *, dual: bool, discrete: bool) -> tuple[Plane, ...]:
    """The poles before and after."""
    caption = (
        "Poles of the error, without correction and with it" if dual else "Poles of the open and of the closed loop"
    )
    names = ("without correction", "with correction") if dual else ("open loop", "closed loop")
    moved = eigenvalues_of(names[1], after, "square")
    return plane(caption, eigenvalues_of(names[0], before), moved, discrete=discrete) if moved else ()


def _named(frame: Frame) -> dict[str, Any]:
    """What the wording needs to name the whole plant."""
    return {"dual": frame.dual, "augmented": frame.augmented, "current": frame.current}
