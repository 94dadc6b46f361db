"""Lemma: the forward path of a loop, controller and plant in series."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import sympy as sp
from solver.stated.algebra import product

if TYPE_CHECKING:
    from sympy import Expr, Symbol


@lemma("forward_path")
def forward_path_of(C: Any, G: Any, path: Any, x: Symbol, *, open_loop: bool, several: bool) -> Derivation[None]:
    """C G is `path`; each is a transfer function, or a matrix where there are `several` inputs or outputs.

    `open_loop`: the loop is not closed, so that G stands for the path from here on.
    """
    claims = {"forward": Claim(product(C, G), path, "forward path $C G$")}
    yield Step("forward", claims=claims, x=x, C=C, G=G, open=open_loop, several=several)


def by_powers(polynomial: Expr, x: Symbol) -> Expr:
    """Return a polynomial multiplied out and sorted by powers of x."""
    sorted_by_powers: Expr = sp.Poly(polynomial, x).as_expr()
    return sorted_by_powers


def polynomials_of(element: Expr) -> tuple[Expr, Expr]:
    """Return numerator and denominator of a quotient of polynomials in lowest terms."""
    top, bottom = sp.fraction(sp.together(element))
    return sp.expand(top), sp.expand(bottom)
