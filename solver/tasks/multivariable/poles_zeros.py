"""Lemma: poles and zeros from their polynomials, what they mean, and what they must not be confused with."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product
from solver.stated.calculus import denoted, value_at
from solver.stated.matrices import determinant, rank
from solver.tasks.figures import plane, roots
from solver.tasks.multivariable.minors import Found
from solver.tasks.representation.lowest_terms import from_roots

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Poly

    from solver.stated import Stated

MOST_WRITTEN = 3
"""Polynomials of a higher degree with parameters have conditions that nobody reads."""


@lemma("poles_zeros")
def poles_and_zeros_of(found: Found, *, discrete: bool, by_minors: bool = False) -> Derivation[Answers]:
    """The roots of both polynomials, the determinant, directions; remarks."""
    G, x = found.G, found.G.variable
    poles, zeros = (roots_of(p) for p in (found.poles, found.zeros))
    yield _listed(found, poles, zeros, discrete)
    answers: dict[str, Any] = {
        "pole_polynomial": found.poles.as_expr(),
        "zero_polynomial": found.zeros.as_expr(),
        "normal_rank": sp.Integer(found.rank),
    }
    answers |= {name: values for name, values in (("poles", poles), ("zeros", zeros)) if values is not None}
    if G.shape[0] == G.shape[1]:
        answers["determinant"] = exact.rational_determinant(G)
        if G.shape != (1, 1) and not by_minors:
            yield _determinant(found, answers["determinant"])
    directions = yield from _directions(found)
    if directions is not None:
        answers["zero_directions"] = directions
    if zeros is not None and poles is not None:
        yield from _not_of_entries(found, zeros, poles)
        shared = [z for z in dict.fromkeys(zeros) if z in poles]
        if shared:
            yield Step("shared", unclaimed="both lists are displayed", values=shared, x=x, detail="full")
    yield from _where_the_zeros_lie(found.zeros, zeros, poles or [], discrete)
    yield from _exceptions(found)
    return Answers(**answers)


def roots_of(p: Poly) -> list[Expr] | None:
    """The roots of a monic polynomial with multiplicity; None where they have no usable form."""
    if p.degree() == 0:
        return []
    try:
        found = exact.spectrum(companion_of(p)).roots
    except exact.NotExact:
        return None
    return [_written(root) for root in found for _ in range(root.multiplicity)]


def _written(root: exact.Root) -> Expr:
    """The root, what stands before the square root over one denominator."""
    if not root.sigma.free_symbols or root.shift == 0:
        return root.value
    return sp.factor(root.sigma) + (root.value - root.sigma)


def companion_of(p: Poly) -> ImmutableMatrix:
    """A matrix with a monic polynomial as its characteristic one."""
    low, n = [*reversed(p.all_coeffs()[1:])], p.degree()
    return sp.ImmutableMatrix(n, n, lambda i, j: -low[j] if i == n - 1 else sp.Integer(int(j == i + 1)))


def _listed(found: Found, poles: list[Expr] | None, zeros: list[Expr] | None, discrete: bool) -> Step:
    x = found.G.variable
    claims = {
        name: Claim(exact.in_factors(p), from_roots(x, values), name)
        for name, p, values in (("poles", found.poles, poles), ("zeros", found.zeros, zeros))
        if values
    }
    return Step(
        "poles_zeros",
        claims=claims,
        unclaimed="" if claims else "there are no roots to put into a product",
        x=x,
        poles=poles,
        zeros=zeros,
        pole_polynomial=exact.in_factors(found.poles),
        zero_polynomial=exact.in_factors(found.zeros),
        rank=found.rank,
        figures=plane(
            "Poles and zeros",
            roots("poles", poles or ()),
            roots("zeros", zeros or (), "ring"),
            discrete=discrete,
        ),
    )


def _determinant(found: Found, value: Expr) -> Step:
    """The determinant of a square G: a constant times the quotient of both polynomials."""
    return Step(
        "determinant_of_transfer_matrix",
        claims={"value": Claim(determinant(found.G.matrix), value, "the determinant of G")},
        x=found.G.variable,
        value=value,
        G=found.G.matrix,
        rank=found.rank,
        m=found.G.shape[0],
    )


def _directions(found: Found) -> Derivation[ImmutableMatrix | None]:
    """Columns u with G(z) u = 0, in the order of the zeros; None where that makes no sense, or nobody reads them."""
    if found.G.domain.is_FractionField and found.zeros.degree() > 1:
        return None
    try:
        listed = exact.zero_directions(found.G, found.rank, found.zeros, found.poles)
    except exact.NotExact:
        return None
    if listed is None or found.G.shape[1] == 1:
        return None
    at_zero = [each.value for each in listed]
    blocks = [sp.ImmutableMatrix(sp.Matrix.hstack(*each.columns)) for each in listed]
    yield Step(
        "directions",
        claims={
            **{
                f"value{i}": Claim(_at(found.G, each.root.value), M, "the value at a zero")
                for i, (each, M) in enumerate(zip(listed, at_zero, strict=True), 1)
            },
            **{
                f"zero{i}": Claim(product(M, u), sp.ImmutableMatrix(sp.zeros(M.rows, u.cols)), "$G(z)\\,u = 0$")
                for i, (M, u) in enumerate(zip(at_zero, blocks, strict=True), 1)
            },
        },
        detail="tutor",
        listed=[(each.root.value, u) for each, u in zip(listed, blocks, strict=True)],
        x=found.G.variable,
    )
    return sp.ImmutableMatrix(sp.Matrix.hstack(*blocks))


def _not_of_entries(found: Found, zeros: Sequence[Expr], poles: Sequence[Expr]) -> Iterator[Step]:
    """A zero of an entry where G keeps its rank: it is no zero of the system."""
    G, x = found.G, found.G.variable
    if G.shape == (1, 1):
        return
    for i, j, z in exact.rational_zeros_of_entries(G):
        if z in zeros or z in poles:
            continue
        there = sp.ImmutableMatrix(G.matrix.xreplace({x: z}).applyfunc(sp.cancel))
        yield Step(
            "not_of_entries",
            claims={
                "there": Claim(_at(G, z), there, "the value at a zero of an entry"),
                "rank": Claim(rank(there), sp.Integer(found.rank), "the rank at a zero of an entry"),
            },
            detail="full",
            x=x,
            i=i + 1,
            j=j + 1,
            z=z,
            rank=found.rank,
        )
        return


def _at(G: exact.TransferMatrix, z: Expr) -> Stated:
    """The value of G at a point, by its name."""
    return value_at(denoted(f"G({G.variable})", G.matrix), G.variable, z)


def _where_the_zeros_lie(p: Poly, zeros: list[Expr] | None, poles: list[Expr], discrete: bool) -> Iterator[Step]:
    """Zeros outside the region of stability, and with parameters the condition that there are none."""
    if p.degree() == 0:
        return
    A = companion_of(p)
    if not A.free_symbols:
        placed = exact.location(A, discrete=discrete).placed if zeros is not None else ()
        outside = [each.root.value for each in placed if each.position == 1]
        on = [each.root.value for each in placed if each.position == 0 and each.root.value not in poles]
        if outside or on:
            yield Step(
                "outside",
                unclaimed="read off the zeros",
                detail="full",
                outside=outside,
                on=on,
                discrete=discrete,
                x=p.gen,
            )
        return
    if p.degree() > MOST_WRITTEN:
        return
    try:
        condition = exact.stable_where(A, discrete=discrete)
    except exact.NotExact:
        return
    yield Step(
        "inside_where",
        unclaimed="the signs of the coefficients decide",
        detail="full",
        condition=condition,
        always=condition is sp.true,
        never=condition is sp.false,
        edge=_edge(p, discrete),
        degree=p.degree(),
        discrete=discrete,
        x=p.gen,
    )


def _edge(p: Poly, discrete: bool) -> list[Any]:
    """Conditions for a zero at the point of constant signals."""
    value = sp.cancel(p.as_expr().xreplace({p.gen: sp.S.One if discrete else sp.S.Zero}))
    return [sp.Eq(factor, 0) for factor in exact.vanishing_factors(value)]


def _exceptions(found: Found) -> Iterator[Step]:
    """Where with parameters the poles, the zeros or the rank are others."""
    if not found.G.domain.is_FractionField:
        return
    try:
        conditions = exact.parameter_exceptions(exact.rational_minors(found.G))
    except exact.NotExact:
        return
    if conditions:
        yield Step("exceptions", unclaimed="conditions for a case of its own", detail="full", conditions=conditions)
