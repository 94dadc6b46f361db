"""Three ways of finding the gain of one input of a controllable pair.

Each works on a `Pair` and writes itself down in the pair's frame.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from solver.arithmetic.equations import system_solved
from solver.arithmetic.exactness import where_exact
from solver.arithmetic.inverses import inverted
from solver.arithmetic.products import multiplied, polynomial_of
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, total
from solver.stated.matrices import inverse
from solver.tasks.design.frames import Pair, characteristic, expansion_of, free_symbols
from solver.tasks.linear_algebra.characteristic_polynomial import coefficients_of_companion
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix


@lemma("placement_methods")
def _open_loop(pair: Pair) -> Derivation[tuple[Expr, ...]]:
    """The characteristic polynomial of A; returns its coefficients."""
    chi: tuple[Expr, ...] = exact.faddeev_leverrier(pair.A).coefficients
    shown = pair.frame.shown(pair.A)
    polynomial = exact.polynomial_in(pair.x, chi)
    claims, lines = expansion_of(shown, pair.x, polynomial)
    claims["polynomial"] = Claim(characteristic(shown, pair.x), polynomial, "open-loop polynomial")
    yield Step("open_loop", claims=claims, steps=lines, companion=coefficients_of_companion(shown), **pair.flags)
    return chi


@lemma("placement_methods")
def by_ackermann(pair: Pair) -> Derivation[ImmutableMatrix]:
    """K = (0, …, 0, 1) 𝒞⁻¹ p̂(A)."""
    frame, A, b, n = pair.frame, pair.A, pair.b, pair.A.rows
    C_o = exact.controllability_matrix(A, b)
    last = sp.ImmutableMatrix([[int(j == n - 1) for j in range(n)]])
    q = sp.ImmutableMatrix(exact.companion_rows(A, b)[:1, :])
    stated = frame.times(frame.shown(last), inverse(frame.shown(C_o)))
    claims = {"row": Claim(stated, frame.shown(q), "last row of the inverse")}
    yield Step("ackermann_row", claims=claims, steps=_last_row(C_o, q), **pair.flags)
    value = exact.polynomial_of_matrix(A, pair.desired)
    shown = frame.shown(A)
    terms = [product(c, power(shown, n - i)) for i, c in enumerate(pair.desired[:-1]) if c != 0]
    if pair.desired[-1] != 0:
        terms.append(product(pair.desired[-1], sp.ImmutableMatrix(sp.eye(n))))
    yield Step(
        "ackermann_polynomial",
        claims={"value": Claim(total(*terms), frame.shown(value), r"$\hat{p}(A)$")},
        formula=exact.polynomial_in(sp.Symbol("A"), pair.desired[:-1]) * sp.Symbol("A"),
        steps=polynomial_of(shown, pair.desired, frame.shown(value)),
        **pair.flags,
    )
    k: ImmutableMatrix = exact.ackermann(A, b, pair.desired)
    stated = frame.times(frame.shown(q), frame.shown(value))
    claims = {"gain": Claim(stated, frame.shown(k), "Ackermann's formula")}
    yield Step("ackermann_gain", claims=claims, steps=_multiplied(pair, q, value, k), **pair.flags)
    return k


@where_exact
def _last_row(C_o: ImmutableMatrix, q: ImmutableMatrix) -> tuple[Step, ...]:
    """q 𝒞 = (0, …, 0, 1), column by column, solved for the entries of q."""
    n = C_o.rows
    unknowns = free_symbols((C_o,), n, "qvw")
    left = (sp.Matrix([unknowns]) * C_o).flat()
    return system_solved(list(zip(left, sp.eye(n).row(n - 1), strict=True)), unknowns, q.flat())


@where_exact
def _multiplied(pair: Pair, left: ImmutableMatrix, right: ImmutableMatrix, value: ImmutableMatrix) -> tuple[Step, ...]:
    """The product of two matrices as the frame writes it."""
    shown = pair.frame.shown
    first, second = pair.frame.ordered(shown(left), shown(right))
    return multiplied(first, second, shown(value))


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
        steps=_multiplied(pair, C_o, W, CW),
        **pair.flags,
    )
    delta = [exact.tidy(d - a) for d, a in zip(pair.desired[1:], chi[1:], strict=True)]
    inverse_of = exact.inverse(CW)
    k: ImmutableMatrix = exact.combine(delta, inverse_of)
    row = sp.ImmutableMatrix([delta])
    stated = frame.times(frame.shown(row), inverse(frame.shown(CW)))
    yield Step(
        "bass_gura_gain",
        claims={
            "inverse": Claim(inverse(frame.shown(CW)), frame.shown(inverse_of), "inverse"),
            "gain": Claim(stated, frame.shown(k), "formula of Bass and Gura"),
        },
        steps=inverted("S", frame.shown(CW), frame.shown(inverse_of)) + _multiplied(pair, row, inverse_of, k),
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
    steps = _last_row(C_o, sp.ImmutableMatrix(P[:1, :]))
    steps += _multiplied(pair, sp.ImmutableMatrix(P[:-1, :]), A, sp.ImmutableMatrix(P[1:, :])) if n > 1 else ()
    yield Step("canonical_rows", claims=claims, P=shown(P), steps=steps, **pair.flags)
    back = exact.inverse(P)
    PA = exact.multiply(P, A)
    A_c, b_c = exact.multiply(PA, back), exact.multiply(P, b)
    yield Step(
        "canonical_pair",
        claims={
            "inverse": Claim(inverse(shown(P)), shown(back), "inverse of the transformation"),
            "A": Claim(frame.times(shown(P), shown(A), inverse(shown(P))), shown(A_c), "canonical form of $A$"),
            "b": Claim(frame.times(shown(P), shown(b)), shown(b_c), "canonical form of the input"),
        },
        steps=inverted("P", shown(P), shown(back))
        + _multiplied(pair, P[-1:, :], A, PA[-1:, :])
        + _multiplied(pair, PA[-1:, :], back, A_c[-1:, :]),
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
        steps=_multiplied(pair, delta, P, k),
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


METHODS: dict[str, Callable[[Pair], Derivation[ImmutableMatrix]]] = {
    "ackermann": by_ackermann,
    "unity_rank": by_ackermann,
    "bass_gura": by_bass_gura,
    "canonical_form": by_canonical_form,
}
"""The methods that need a controllable pair; coefficient matching does without (`matched`)."""
