"""The four ways of finding the gain of one input. Each works on a `Pair` and writes itself down in the pair's frame."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, total
from solver.stated.matrices import inverse
from solver.tasks.design.comparison import compared
from solver.tasks.design.frames import Pair, Placement, characteristic, movable_poles
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol


@lemma("placement_methods")
def _open_loop(pair: Pair) -> Derivation[tuple[Expr, ...]]:
    """The characteristic polynomial of A; returns its coefficients."""
    chi: tuple[Expr, ...] = exact.faddeev_leverrier(pair.A).coefficients
    shown = pair.frame.shown(pair.A)
    claim = Claim(characteristic(shown, pair.x), exact.polynomial_in(pair.x, chi), "open-loop polynomial")
    yield Step("open_loop", claims={"polynomial": claim}, **pair.flags)
    return chi


@lemma("placement_methods")
def by_ackermann(pair: Pair) -> Derivation[ImmutableMatrix]:
    """K = (0, …, 0, 1) 𝒞⁻¹ p̂(A)."""
    frame, A, b, n = pair.frame, pair.A, pair.b, pair.A.rows
    C_o = exact.controllability_matrix(A, b)
    last = sp.ImmutableMatrix([[int(j == n - 1) for j in range(n)]])
    q = sp.ImmutableMatrix(exact.companion_rows(A, b)[:1, :])
    stated = frame.times(frame.shown(last), inverse(frame.shown(C_o)))
    yield Step("ackermann_row", claims={"row": Claim(stated, frame.shown(q), "last row of the inverse")}, **pair.flags)
    value = exact.polynomial_of_matrix(A, pair.desired)
    shown = frame.shown(A)
    terms = [product(c, power(shown, n - i)) for i, c in enumerate(pair.desired[:-1]) if c != 0]
    if pair.desired[-1] != 0:
        terms.append(product(pair.desired[-1], sp.ImmutableMatrix(sp.eye(n))))
    yield Step(
        "ackermann_polynomial",
        claims={"value": Claim(total(*terms), frame.shown(value), r"$\hat{p}(A)$")},
        formula=exact.polynomial_in(sp.Symbol("A"), pair.desired[:-1]) * sp.Symbol("A"),
        **pair.flags,
    )
    k: ImmutableMatrix = exact.ackermann(A, b, pair.desired)
    stated = frame.times(frame.shown(q), frame.shown(value))
    yield Step("ackermann_gain", claims={"gain": Claim(stated, frame.shown(k), "Ackermann's formula")}, **pair.flags)
    return k


@lemma("placement_methods")
def by_bass_gura(pair: Pair) -> Derivation[ImmutableMatrix]:
    """Kᵀ = ((𝒞 W)ᵀ)⁻¹ (â − a), W upper triangular with the coefficients of det(sI − A)."""
    frame, A, b = pair.frame, pair.A, pair.b
    chi = yield from _open_loop(pair)
    yield Step(
        "coefficients",
        claims={"difference": _difference(pair, chi)},
        desired=sp.ImmutableMatrix(pair.desired[1:]),
        own=sp.ImmutableMatrix(chi[1:]),
        **pair.flags,
    )
    C_o, W = exact.controllability_matrix(A, b), exact.toeplitz(chi)
    CW = exact.multiply(C_o, W)
    yield Step(
        "toeplitz",
        claims={
            "product": Claim(
                frame.times(frame.shown(C_o), frame.shown(W)), frame.shown(CW), r"$\sym{controllability_matrix} W$"
            )
        },
        W=frame.shown(W),
        C_o=frame.shown(C_o),
        n=A.rows,
        **pair.flags,
    )
    delta = [exact.tidy(d - a) for d, a in zip(pair.desired[1:], chi[1:], strict=True)]
    inverted = exact.inverse(CW)
    k: ImmutableMatrix = exact.combine(delta, inverted)
    row = sp.ImmutableMatrix([delta])
    stated = frame.times(frame.shown(row), inverse(frame.shown(CW)))
    yield Step(
        "bass_gura_gain",
        claims={
            "inverse": Claim(inverse(frame.shown(CW)), frame.shown(inverted), "inverse"),
            "gain": Claim(stated, frame.shown(k), "formula of Bass and Gura"),
        },
        **pair.flags,
    )
    return k


@lemma("placement_methods")
def by_canonical_form(pair: Pair) -> Derivation[ImmutableMatrix]:
    """In ξ = P x the pair is in controllable canonical form, where the gain is read off; K = K_c P."""
    frame, A, b = pair.frame, pair.A, pair.b
    chi = yield from _open_loop(pair)
    P = exact.companion_rows(A, b)
    C_o = exact.controllability_matrix(A, b)
    n = A.rows
    last = sp.ImmutableMatrix([[int(j == n - 1) for j in range(n)]])
    shown = frame.shown
    claims = {"row1": Claim(frame.times(shown(last), inverse(shown(C_o))), shown(P[:1, :]), Phrase("row {i}", i=1))}
    for i in range(1, n):
        stated = frame.times(shown(P[i - 1 : i, :]), shown(A))
        claims[f"row{i + 1}"] = Claim(stated, shown(P[i : i + 1, :]), Phrase("row {i}", i=i + 1))
    yield Step("canonical_rows", claims=claims, P=shown(P), **pair.flags)
    back = exact.inverse(P)
    A_c, b_c = exact.multiply(exact.multiply(P, A), back), exact.multiply(P, b)
    yield Step(
        "canonical_pair",
        claims={
            "inverse": Claim(inverse(shown(P)), shown(back), "inverse of the transformation"),
            "A": Claim(frame.times(shown(P), shown(A), inverse(shown(P))), shown(A_c), "canonical form of $A$"),
            "b": Claim(frame.times(shown(P), shown(b)), shown(b_c), "canonical form of the input"),
        },
        **pair.flags,
    )
    delta = sp.ImmutableMatrix(
        [[exact.tidy(d - a) for d, a in zip(reversed(pair.desired[1:]), reversed(chi[1:]), strict=True)]]
    )
    k: ImmutableMatrix = exact.combine(delta.flat(), P)
    yield Step(
        "canonical_gain",
        claims={
            "difference": _difference(pair, chi, reverse=True),
            "gain": Claim(frame.times(shown(delta), shown(P)), shown(k), "original coordinates"),
        },
        delta=shown(delta),
        **pair.flags,
    )
    return k


def _difference(pair: Pair, chi: Sequence[Expr], *, reverse: bool = False) -> Claim:
    """The vector â − a: highest power first, or reversed; a row as K is, or a column."""
    order = slice(None, None, -1) if reverse else slice(None)
    desired = sp.ImmutableMatrix([[*pair.desired[1:]][order]])
    own = sp.ImmutableMatrix([[*chi[1:]][order]])
    gap = sp.ImmutableMatrix((desired - own).applyfunc(exact.tidy))
    shown = pair.frame.shown
    return Claim(difference(shown(desired), shown(own)), shown(gap), r"$\hat{a} - a$")


@lemma("placement_methods")
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
    yield Step(
        "gain_polynomial",
        claims={"polynomial": Claim(characteristic(frame.shown(loop), x), gain_polynomial, "closed-loop polynomial")},
        row=frame.shown(row),
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


@lemma("placement_methods")
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


@lemma("placement_methods")
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
        free=found.free,
        gain=pair.frame.shown(k),
        **pair.flags,
    )
    return solution, k


METHODS: dict[str, Callable[[Pair], Derivation[ImmutableMatrix]]] = {
    "ackermann": by_ackermann,
    "unity_rank": by_ackermann,
    "bass_gura": by_bass_gura,
    "canonical_form": by_canonical_form,
}
"""The methods that need a controllable pair; coefficient matching does without (`matched`)."""
