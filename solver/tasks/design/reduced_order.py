"""An observer of reduced order, step by step: what is measured, the blocks, J, N and M, the estimate and its error."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.products import multiplied
from solver.derivation import Claim, Derivation, Refusal, Step, lemma
from solver.derivation.figures import Diagram
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated import Stated
from solver.stated.algebra import difference, product, total
from solver.stated.matrices import determinant, inverse, partitioned
from solver.tasks.design.frames import expansion_of
from solver.tasks.design.observer_gain import Gain, Pair, gain_of, number_fault
from solver.tasks.design.plants import Plant
from solver.tasks.figures import error_of_estimate
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix


def measurement_fault(plant: Plant) -> Reason | None:
    """What is wrong with the outputs of an observer of reduced order; None if nothing is."""
    p = plant.p
    if len(exact.independent_columns(plant.C)) < p:
        return Reason("observers/dependent_outputs")
    if p == plant.n:
        return Reason("observers/all_measured")
    return None


def pole_faults(plant: Plant, poles: Sequence[Expr], option: str = "poles") -> Iterator[Refusal]:
    """A number of poles that fits neither the unmeasured states nor those of them that the output shows."""
    n, p = plant.n, plant.p
    seen = exact.reachable_order(plant.A.T, plant.C.T)
    if fault := number_fault(poles, n - p, seen - p, p):
        yield option, fault


def _column(names: Iterable[str]) -> ImmutableMatrix:
    """A column of names."""
    return sp.ImmutableMatrix([sp.Symbol(name) for name in names])


@lemma("partition")
def partition_of(plant: Plant) -> Derivation[exact.Partition]:
    """Coordinates η = (η₁, η₂), η₁ = y measured, η₂ the other states; the blocks of T⁻¹AT and T⁻¹B."""
    A, B, C, n, p = plant.A, plant.B, plant.C, plant.n, plant.p
    parts = exact.measured_first(A, B, C)
    names = plant.state_names
    selected = sp.ImmutableMatrix(sp.Matrix.hstack(sp.eye(p), sp.zeros(p, n - p)))
    claims = {"outputs": Claim(product(C, parts.T), selected, "the first coordinates are the measured ones")}
    if not parts.permutation:
        claims["inverse"] = Claim(inverse(parts.Q), parts.T, "inverse of the completed output matrix")
    yield Step(
        "measured",
        claims=claims,
        C=C,
        T=parts.T,
        Q=parts.Q,
        permutation=parts.permutation,
        measured=_column(names[row.index(1)] for row in C.tolist()) if parts.permutation else None,
        unmeasured=_column(names[j] for j in parts.unmeasured),
        exceptions=exact.vanishing_factors(exact.determinant(parts.Q)),
        D=None if plant.plain else plant.D,
    )
    yield Step(
        "blocks",
        claims={
            "A": Claim(product(inverse(parts.T), A, parts.T), partitioned(parts.A, (p,), (p,)), "$T^{-1}AT$"),
            "B": Claim(product(inverse(parts.T), B), partitioned(parts.B, (p,), ()), "$T^{-1}B$"),
        },
        blocks=parts.blocks,
        discrete=plant.discrete,
    )
    return parts


@lemma("reduced_matrices")
def error_equation_of(*, discrete: bool) -> Derivation[None]:
    """What the observer is, and what J, N and M must be for its error to be driven by nothing."""
    yield Step("error_equation", unclaimed="the conditions define J, N and M", detail="full", discrete=discrete)


def reduced_gain_of(parts: exact.Partition, poles: Sequence[Expr], *, discrete: bool) -> Derivation[Gain]:
    """The gain L for the pair (A22, A12), which is observable as far as (A, C) is."""
    blocks = parts.blocks
    design = yield from gain_of(Pair(blocks["A22"], blocks["A12"], "A_{22}", "A_{12}", discrete), poles)
    return design


@lemma("reduced_matrices")
def observer_matrices_of(
    parts: exact.Partition, L: ImmutableMatrix, plant: Plant, *, chosen: bool = False
) -> Derivation[tuple[ImmutableMatrix, ImmutableMatrix, ImmutableMatrix]]:
    """J = A22 − L A12, N = A21 − L A11 + J L, M = B2 − L B1 (less N D): the error is then driven by nothing.

    J is known already where it was `chosen`.
    """
    A11, A12, A21, A22, B1, B2 = parts.blocks.values()
    J = sp.ImmutableMatrix((A22 - exact.multiply(L, A12)).applyfunc(exact.tidy))
    N = sp.ImmutableMatrix((A21 - exact.multiply(L, A11) + exact.multiply(J, L)).applyfunc(exact.tidy))
    forward = sp.ImmutableMatrix((B2 - exact.multiply(L, B1)).applyfunc(exact.tidy))
    stated: Stated = difference(B2, product(L, B1))
    M = forward
    if not plant.plain:
        M = sp.ImmutableMatrix((forward - exact.multiply(N, plant.D)).applyfunc(exact.tidy))
        stated = difference(stated, product(N, plant.D))
    yield Step(
        "matrices",
        claims={
            "J": Claim(difference(A22, product(L, A12)), J, "$J$"),
            "N": Claim(total(difference(A21, product(L, A11)), product(J, L)), N, "$N$"),
            "M": Claim(stated, M, "$M$"),
        },
        plain=plant.plain,
        chosen=chosen,
        steps=_worked_out(([] if chosen else [(L, A12)]) + [(L, A11), (J, L), (L, B1)]),
    )
    return J, N, M


@where_exact
def _worked_out(pairs: Iterable[tuple[ImmutableMatrix, ImmutableMatrix]]) -> tuple[Step, ...]:
    """The products of pairs of matrices, without those of two numbers."""
    matrices = [(left, right) for left, right in pairs if left.shape != (1, 1) or right.shape != (1, 1)]
    return tuple(step for left, right in matrices for step in multiplied(left, right, exact.multiply(left, right)))


@lemma("reduced_matrices")
def estimate_of(parts: exact.Partition, design: Gain, J: ImmutableMatrix, plant: Plant) -> Derivation[None]:
    """The equations of the observer and of its error, and x̂ from y and ω."""
    x, q, p = plant.variable, J.rows, parts.p
    from_y = sp.ImmutableMatrix(sp.Matrix.vstack(sp.eye(p), design.L))
    from_omega = sp.ImmutableMatrix(sp.Matrix.vstack(sp.zeros(p, q), sp.eye(q)))
    from_y_x, from_omega_x = exact.multiply(parts.T, from_y), exact.multiply(parts.T, from_omega)
    yield Step(
        "estimate",
        claims={
            "y": Claim(product(parts.T, from_y), from_y_x, "what y adds to the estimate"),
            "omega": Claim(product(parts.T, from_omega), from_omega_x, "what the observer adds to the estimate"),
        },
        figures=_diagram(plant),
        unmeasured=_column(plant.state_names[j] for j in parts.unmeasured),
        from_y=from_y_x,
        from_omega=from_omega_x,
        plain=plant.plain,
        D=plant.D,
        discrete=plant.discrete,
    )
    claims, lines = expansion_of(J, x, design.polynomial) if q > 1 else ({}, ())
    claims["polynomial"] = Claim(determinant(exact.pencil(J, x)), design.polynomial, "polynomial of the error")
    yield Step(
        "error",
        claims=claims,
        steps=lines,
        figures=error_of_estimate(J, r"\tilde{\eta}", 2, discrete=plant.discrete),
        x=x,
        order=J.rows,
        discrete=plant.discrete,
        fixed=design.fixed,
    )


def _diagram(plant: Plant) -> tuple[Diagram, ...]:
    """The block diagram; none where the input acts on the output directly, which it does not show."""
    discrete = {"plant": "x(k+1)=Ax(k)+Bu(k)", "integrator": "z^{-1}"} if plant.discrete else {}
    caption = "The plant and its observer of reduced order."
    return (Diagram(caption, "reduced_observer", {"L": r"\sym{L}", **discrete}),) if plant.plain else ()
