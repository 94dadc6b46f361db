"""A current observer, step by step: the error, the pair (A, CA), its gain, and the prediction observer beside it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from solver.arithmetic.products import multiplied
from solver.derivation import Claim, Derivation, Refusal, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product
from solver.stated.matrices import determinant
from solver.tasks.design.frames import Placement, characteristic
from solver.tasks.design.full_order import require_detectable
from solver.tasks.design.observer_gain import number_fault
from solver.tasks.design.placement import place
from solver.tasks.figures import error_of_estimate

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.systems import StateSpace
    from solver.tasks.needed import WithOutput


def shown_next(system: WithOutput) -> ImmutableMatrix:
    """C A (p×n): what the state shows one step later."""
    return sp.ImmutableMatrix(exact.multiply(system.C, system.A))


def current_pole_faults(system: StateSpace, poles: Sequence[Expr], option: str = "poles") -> Iterator[Refusal]:
    """What is wrong with the number of poles: right are n, or as many as the pair (A, CA) lets move."""
    if system.C is None:
        return
    seen = exact.reachable_order(system.A.T, exact.multiply(system.C, system.A).T)
    if fault := number_fault(poles, system.order, seen):
        yield option, fault


@lemma("current_observer")
def current_gain_of(system: WithOutput, poles: Sequence[Expr], method: str) -> Derivation[Placement]:
    """L of (I − LC) A = A − L (CA): placed for the pair (A, CA); entries that move nothing are set to zero."""
    A, C, x = system.A, system.C, sp.Symbol("z")
    for _, fault in current_pole_faults(system, poles):
        raise Unsolved("engine/refused", message=fault)
    yield Step("error", unclaimed="the definition of the observer and of its error", direct=_direct(system))
    require_detectable(A, C, discrete=True)
    CA, det = shown_next(system), exact.determinant(A)
    yield Step(
        "pair",
        claims={"CA": Claim(product(C, A), CA, "$C A$"), "determinant": Claim(determinant(A), det, r"$\det A$")},
        det=det,
        steps=multiplied(C, A, CA),
    )
    found = yield from place(A, CA, poles, method, x=x, dual=True, named="current")
    if found.free:
        L = sp.ImmutableMatrix(found.K.subs(dict.fromkeys(found.free, 0)).applyfunc(exact.tidy))
        loop = sp.ImmutableMatrix((A - L * CA).applyfunc(exact.tidy))
        claim = Claim(characteristic(loop, x), found.polynomial, "polynomial of the error")
        yield Step("free_entries", claims={"polynomial": claim}, L=L, free=list(found.free))
        found = replace(found, K=L, loop=loop, free=())
    return found


def _direct(system: StateSpace) -> bool:
    """Whether the input acts on the output directly."""
    return system.D is not None and not system.D.is_zero_matrix


@lemma("current_observer")
def error_of(system: WithOutput, found: Placement) -> Derivation[None]:
    """(I − LC) A, which is the matrix that was placed, and how the error dies out."""
    A, C, L = system.A, system.C, found.K
    identity = sp.ImmutableMatrix(sp.eye(A.rows))
    kept = sp.ImmutableMatrix((identity - exact.multiply(L, C)).applyfunc(exact.tidy))
    claims = {
        "kept": Claim(difference(identity, product(L, C)), kept, "$I - L C$"),
        "error": Claim(product(kept, A), found.loop, "$(I - L C) A$"),
    }
    B, D = system.B, system.D
    forward = None
    if B is not None:
        forward = sp.ImmutableMatrix(exact.multiply(kept, B).applyfunc(exact.tidy))
        claims["input"] = Claim(product(kept, B), forward, "$(I - L C) B$")
    through = None
    if B is not None and D is not None and _direct(system):
        through = sp.ImmutableMatrix(exact.multiply(L, D).applyfunc(exact.tidy))
        claims["through"] = Claim(product(L, D), through, "$L D$")
    yield Step(
        "equation",
        claims=claims,
        figures=error_of_estimate(found.loop, discrete=True),
        L=L,
        forward=forward,
        through=through,
        fixed=found.fixed,
        steps=multiplied(kept, A, found.loop),
    )


@lemma("current_observer")
def prediction_of(system: WithOutput, found: Placement) -> Derivation[ImmutableMatrix]:
    """L_p = A L of the prediction observer with the same poles, as A (I − LC) and (I − LC) A have them in common."""
    A, C, x, L = system.A, system.C, sp.Symbol("z"), found.K
    L_p = sp.ImmutableMatrix(exact.multiply(A, L).applyfunc(exact.tidy))
    loop = sp.ImmutableMatrix((A - exact.multiply(L_p, C)).applyfunc(exact.tidy))
    yield Step(
        "prediction",
        claims={
            "gain": Claim(product(A, L), L_p, "gain of the prediction observer"),
            "loop": Claim(difference(A, product(L_p, C)), loop, "matrix of its error"),
            "polynomial": Claim(characteristic(loop, x), found.polynomial, "its characteristic polynomial"),
        },
        singular=exact.determinant(A) == 0,
        steps=multiplied(A, L, L_p),
    )
    yield Step("comparison", unclaimed="what tells the two observers apart", detail="full")
    return L_p
