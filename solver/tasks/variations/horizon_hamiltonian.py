"""Lemma: the Riccati differential equation made linear by the Hamiltonian matrix, P = Y X⁻¹."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.determinants import worked_out
from solver.arithmetic.roots import factored
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, exponential, product, quotient
from solver.stated.matrices import determinant, inverse
from solver.tasks.variations.horizon_question import HorizonQuestion

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

SHOWN = 2
"""Larger plants have polynomials and determinants that fill the page."""


@lemma("horizon_hamiltonian")
def solution_by_hamiltonian(asked: HorizonQuestion, found: exact.FiniteHorizon, *, canonical: bool) -> Derivation[None]:
    """[X; Y] = e^{−Hτ} [I; S] and P = Y X⁻¹; `canonical`: from the equations of the state and the costate."""
    n, tau = asked.order, found.tau
    yield _matrix(asked, found, canonical=canonical)
    X, Y = found.X, found.Y
    end = sp.ImmutableMatrix(sp.Matrix.vstack(sp.eye(n), sp.Matrix(asked.S)))
    both = sp.ImmutableMatrix(sp.Matrix.vstack(sp.Matrix(X), sp.Matrix(Y)))
    e = exponential(product(-tau, found.H))
    yield Step(
        "exponential",
        claims={"both": Claim(product(e, end), both, "state and costate, backwards from the end")},
        n=n,
        X=X,
        Y=Y,
        S=asked.S,
        T=asked.T,
        canonical=canonical,
    )
    claims = {"P": Claim(product(Y, inverse(X)), over_one_denominator(found.P), "$P = YX^{-1}$")}
    if 1 < n <= SHOWN:
        claims["det"] = Claim(determinant(X), found.determinant, r"$\det X$")
    yield Step("quotient", claims=claims, n=n, P=found.P, X=X, canonical=canonical,
               waves=X.has(sp.sin, sp.cos, sp.cosh, sp.sinh))  # fmt: skip


def _matrix(asked: HorizonQuestion, found: exact.FiniteHorizon, *, canonical: bool) -> Step:
    """H, its characteristic polynomial and the roots of that."""
    s, n = sp.Symbol("s"), asked.order
    chi = exact.faddeev_leverrier(found.H).characteristic_polynomial(s)
    factors = exact.factored(found.H, s)
    one = sp.ImmutableMatrix(sp.eye(2 * n))
    claims = {
        "G": Claim(product(asked.B, *asked.weight, asked.Bt), asked.G, r"the block $BR^{-1}B^{T}$"),
        "chi": Claim(determinant(difference(product(s, one), found.H)), chi, "its characteristic polynomial"),
    }
    if sp.expand(factors) == chi and factors != chi:
        claims["factors"] = Claim(chi, factors, "its factors")
    roots = exact.spectrum(found.H).eigenvalues
    lines = worked_out(r"\det(sI - H)", exact.pencil(found.H, s), chi, s) if n <= SHOWN else ()
    if "factors" in claims:
        lines += factored(chi, factors, s)
    return Step("matrix", claims=claims, steps=lines, H=found.H, n=n, roots=roots, canonical=canonical,
                weighed=bool(asked.weight), factor=asked.factor)  # fmt: skip


def over_one_denominator(P: ImmutableMatrix) -> Any:
    """The matrix over the denominator that all of its entries have; the matrix itself where there is none."""
    parts = [_fraction(entry) for entry in P.flat()]
    below = {d for entry, d in parts if entry != 0}
    if P.shape == (1, 1) or len(below) != 1 or below == {sp.S.One}:
        return P
    shared = next(iter(below))
    return quotient(sp.ImmutableMatrix(*P.shape, [entry for entry, _ in parts]), shared)


def _fraction(entry: Any) -> tuple[Any, Any]:
    """The numerator and the sum below it."""
    parts: tuple[Any, ...] = sp.Mul.make_args(entry)
    below = [each for each in parts if each.is_Pow and each.exp == -1 and each.base.is_Add]
    if len(below) != 1:
        return entry, sp.S.One
    above = sp.Mul(*(each for each in parts if each is not below[0]))
    return above, below[0].base
