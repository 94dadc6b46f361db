"""The roots of quadratic polynomials, and of those in x², by the formula with its numbers put in."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from solver.arithmetic.exactness import where_exact
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, total
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Symbol


@where_exact
def quadratic_formula(x: Expr, b: Expr, c: Expr, roots: Sequence[Expr]) -> tuple[Step, ...]:
    """x² + bx + c = 0: the formula with its numbers, the radicand, the roots (that of the upper sign first)."""
    return tuple(_quadratic_formula(x, b, c, roots) if b != 0 else _roots_of_squares(x, [-c], roots))


@where_exact
def roots_of_squares(x: Expr, squares: Sequence[Expr], roots: Sequence[Expr]) -> tuple[Step, ...]:
    """x² = y for each y: ±√y where y is real; else the root as it was found, squared."""
    return tuple(_roots_of_squares(x, squares, roots))


@lemma("arithmetic/quadratics")
def _quadratic_formula(x: Expr, b: Expr, c: Expr, roots: Sequence[Expr]) -> Derivation[None]:
    square = exact.tidy(b**2 / 4)
    radicand = exact.tidy(square - c)
    yield Step(
        "quadratic_formula",
        detail="tutor",
        claims={"radicand": Claim(difference(square, c), radicand, Phrase("the radicand"))},
        x=x,
        b=b,
        c=c,
        general=not {"b", "c"} & {symbol.name for symbol in (b + c).free_symbols},
        centre=exact.tidy(-b / 2),
        worked_out=len(sp.Add.make_args(radicand)) < sum(len(sp.Add.make_args(each)) for each in (square, c)),
        roots=list(roots),
    )


@lemma("arithmetic/quadratics")
def _roots_of_squares(x: Expr, squares: Sequence[Expr], roots: Sequence[Expr]) -> Derivation[None]:
    for y in squares:
        first, *others = (root for root in roots if exact.tidy(sp.expand(root**2 - y)) == 0)
        real, imaginary = exact.complex_parts(first)
        if real.is_negative:  # of the two the one with a positive real part is squared
            first, others, real, imaginary = others[0], [first], -real, -imaginary
        if 0 in (real, imaginary):
            claims = {"square": Claim(power(first, 2), y, Phrase("the root squared"))}
            yield Step("root_of_square", detail="tutor", claims=claims, x=x, y=y, roots=[first, *others])
            continue
        parts = total(difference(power(real, 2), power(imaginary, 2)), product(2, real, imaginary, sp.I))
        yield Step(
            "square_of_root",
            detail="tutor",
            claims={
                "parts": Claim(power(first, 2), parts, Phrase("the root squared")),
                "square": Claim(parts, y, Phrase("the root squared")),
            },
            x=x,
            y=y,
            roots=[first, *others],
        )


@where_exact
def both_roots(x: Expr, polynomial: Expr, variable: Symbol | None = None) -> tuple[Step, ...]:
    """The real roots of a quadratic polynomial in numbers, in decimals where they are irrational; else nothing.

    `variable` is what the polynomial is in, if x is an expression such as ω².
    """
    p = sp.Poly(polynomial, variable or x)
    if p.degree() != 2 or p.free_symbols_in_domain:
        return ()
    _, b, c = p.monic().all_coeffs()
    radicand = b**2 / 4 - c
    if b == 0 or not radicand.is_positive:
        return ()
    root = sp.sqrt(radicand)
    roots = [-b / 2 + root, -b / 2 - root] if root.is_Rational else [sp.N(-b / 2 + sign * root, 30) for sign in (1, -1)]
    return tuple(_quadratic_formula(x, b, c, roots))
