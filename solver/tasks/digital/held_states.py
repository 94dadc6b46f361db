"""Lemma: state equations between a hold and a sampler, A_d = e^{AT} and B_d = ∫₀ᵀ e^{At} dt B."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.integrals import integrated
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.matrices import entry_alone
from solver.stated.algebra import difference, exponential, product
from solver.stated.calculus import integral, value_at
from solver.stated.matrices import inverse
from solver.stated.transforms import inverse_laplace
from solver.tasks.figures import plane, roots
from solver.tasks.linear_algebra.resolvent import inverse_of_pencil, partial_fractions_of, transform_pairs_of

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.systems import StateSpace

Matrices = tuple[Any, Any, Any, Any]
"""A_d, B_d, C_d, D_d; None for what the plant does not have."""


@lemma("held_states")
def held_states_of(plant: StateSpace, T: Expr) -> Derivation[Matrices]:
    """The plant at the sampling instants, its inputs held between them; returns its matrices."""
    A, B = plant.A, plant.B
    t = sp.Symbol("t")
    e = yield from _exponential_of(A)
    held = exact.zero_order_hold(A, B, T)
    claims = {
        "put": Claim(value_at(e, t, T), held.Phi, "the period put in"),
        "Phi": Claim(exponential(product(A, T)), held.Phi, "the matrix exponential"),
    }
    yield Step("transition", claims=claims, T=T, driven=B is not None, A_d=held.Phi)
    if B is not None and held.Gamma is not None:
        yield from _input_of(A, B, e, held, T)
    yield _model(plant, held, T)
    return held.Phi, held.Gamma, plant.C, plant.D if B is not None and plant.C is not None else None


@lemma("held_states")
def _exponential_of(A: ImmutableMatrix) -> Derivation[ImmutableMatrix]:
    """e^{At} by the Laplace transform; returns it."""
    s, t = sp.Symbol("s"), sp.Symbol("t")
    e = exact.exponential(A, t).matrix
    index = _nilpotent(A)
    if index:
        yield Step("series", claims={"e": Claim(exponential(product(A, t)), e, "the series ends")}, index=index,
                   factorials=[sp.factorial(k) for k in range(index)])  # fmt: skip
        return e
    yield from inverse_of_pencil(A, s)
    expansion = yield from partial_fractions_of(A, s)
    yield from transform_pairs_of(A, s, t, discrete=False)
    yield Step("exponential", claims={"e": Claim(inverse_laplace(expansion, s, t), e, "transformed back")})
    return e


def _nilpotent(A: ImmutableMatrix) -> int:
    """The least power of A that is zero; 0 where none is."""
    found = exact.powers(A, A.rows + 1)
    return next((k for k, M in enumerate(found) if M.is_zero_matrix), 0)


@lemma("held_states")
def _input_of(
    A: ImmutableMatrix, B: ImmutableMatrix, e: ImmutableMatrix, held: exact.Held, T: Expr
) -> Derivation[None]:
    """What a held input adds in a period."""
    t, Gamma = sp.Symbol("t"), held.Gamma
    assert Gamma is not None  # noqa: S101 - there is a B
    weighed = sp.ImmutableMatrix((e * B).applyfunc(sp.expand))
    stated = product(e, B)
    claims = {
        "weighed": Claim(stated, weighed, "the input matrix weighed"),
        "Gamma": Claim(integral(stated, t, sp.S.Zero, T), held.Gamma, "the integral"),
    }
    worked_out = integrated(weighed, t, sp.S.Zero, T, Gamma)
    yield Step("held_input", claims=claims, steps=worked_out, T=T, B_d=held.Gamma, weighed=entry_alone(weighed))
    identity = sp.ImmutableMatrix(sp.eye(A.rows))
    if not A.free_symbols and exact.determinant(A) != 0:
        stated = product(inverse(A), difference(held.Phi, identity), B)
        yield Step("by_the_inverse", claims={"Gamma": Claim(stated, held.Gamma, "by the inverse of A")},
                   detail="full", B_d=held.Gamma)  # fmt: skip
    M = exact.augmented(A, B)
    claim = Claim(exponential(product(M, T)), exact.held_blocks(held), "the augmented matrix")
    yield Step("augmented", claims={"whole": claim}, detail="tutor", M=M, T=T, n=A.rows, m=B.cols,
               singular=not A.free_symbols and exact.determinant(A) == 0)  # fmt: skip


def _model(plant: StateSpace, held: exact.Held, T: Expr) -> Step:
    """The discrete plant, and where its eigenvalues lie."""
    D = plant.D if plant.B is not None and plant.C is not None else None
    turning = [root.shift for root in exact.spectrum(plant.A).roots if root.kind in ("complex", "decimal")]
    known = [omega for omega in turning if omega.is_positive]
    return Step(
        "model",
        unclaimed="what was found",
        A_d=held.Phi,
        B_d=held.Gamma,
        C=plant.C,
        D=D,
        direct=D is not None and not D.is_zero_matrix,
        T=T,
        limit=sp.pi / known[0] if len(known) == 1 else None,
        figures=_figure(plant.A, T),
    )


def _figure(A: ImmutableMatrix, T: Expr) -> Any:
    """The eigenvalues of the discrete plant, where all is numbers."""
    if A.free_symbols or T.free_symbols:
        return ()
    values = [sp.exp(root * T) for root in exact.spectrum(A).eigenvalues]
    return plane(
        "The eigenvalues of the discrete plant, $z = e^{\\lambda T}$", roots("eigenvalues", values), discrete=True
    )
