"""An observer of full order, step by step: the gain by placement of the dual, the equations, the duality."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Refusal, Step, Unsolved, lemma
from solver.derivation.figures import Diagram
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product
from solver.stated.matrices import determinant, transpose
from solver.tasks.design.frames import Placement, characteristic
from solver.tasks.design.observer_gain import number_fault, require_decay
from solver.tasks.design.placement import place
from solver.tasks.figures import error_of_estimate

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.systems import StateSpace


def observer_pole_faults(system: StateSpace, poles: Sequence[Expr], option: str = "poles") -> Iterator[Refusal]:
    """What is wrong with the number of poles of an observer of full order."""
    if system.C is None:
        return
    n, seen = system.order, exact.reachable_order(system.A.T, system.C.T)
    if fault := number_fault(poles, n, seen):
        yield option, fault


def require_detectable(A: ImmutableMatrix, C: ImmutableMatrix, *, discrete: bool) -> None:
    """Raise Unsolved where a part of the error that no gain reaches does not decay."""
    modes = exact.observable_decomposition(A, None, C).hidden_modes
    require_decay(modes, (), discrete=discrete)


@lemma("observer")
def observer_gain_of(
    system: StateSpace, poles: Sequence[Expr], method: str = "coefficient_matching"
) -> Derivation[Placement]:
    """L from the dual of a pole placement; entries that move nothing are set to zero."""
    A, C, x = system.A, system.C, sp.Symbol("z" if system.discrete else "s")
    if C is None:
        raise Unsolved("observers/no_output")
    for _, fault in observer_pole_faults(system, poles):
        raise Unsolved("engine/refused", message=fault)
    yield Step("error", unclaimed="the definition of the observer and of its error", discrete=system.discrete)
    require_detectable(A, C, discrete=system.discrete)
    found = yield from place(A, C, poles, method, x=x, dual=True)
    if found.free:
        L = sp.ImmutableMatrix(found.K.subs(dict.fromkeys(found.free, 0)).applyfunc(exact.tidy))
        loop = sp.ImmutableMatrix((A - L * C).applyfunc(exact.tidy))
        claim = Claim(characteristic(loop, x), found.polynomial, "polynomial of the error")
        yield Step("free_entries", claims={"polynomial": claim}, L=L, free=list(found.free), x=x)
        found = replace(found, K=L, loop=loop, free=())
    if method != "coefficient_matching":
        dual = difference(transpose(A), product(transpose(C), transpose(found.K)))
        pencil = difference(product(x, sp.ImmutableMatrix(sp.eye(A.rows))), dual)
        claim = Claim(determinant(pencil), found.polynomial, "the dual closed loop has the same polynomial")
        yield Step("duality", claims={"dual": claim}, detail="full", method=method, x=x)
    return found


@lemma("observer")
def observer_equation_of(system: StateSpace, found: Placement) -> Derivation[None]:
    """The state equation of the observer with its numbers."""
    A, B, C, D, L = system.A, system.B, system.C, system.D, found.K
    claims = {"matrix": Claim(difference(A, product(L, C)), found.loop, "matrix of the observer")}
    forward = B
    if B is not None and D is not None and not D.is_zero_matrix:
        forward = sp.ImmutableMatrix((B - L * D).applyfunc(exact.tidy))
        claims["input"] = Claim(difference(B, product(L, D)), forward, "input matrix of the observer")
    yield Step(
        "equation",
        claims=claims,
        figures=(
            *_diagram(system, through=forward is not B),
            *error_of_estimate(found.loop, discrete=system.discrete),
        ),
        forward=forward,
        L=L,
        fixed=found.fixed,
        discrete=system.discrete,
    )


def _diagram(system: StateSpace, *, through: bool) -> tuple[Diagram, ...]:
    """The block diagram; none without an input, or where it acts on the output directly."""
    discrete = {"plant": "x(k+1)=Ax(k)+Bu(k)", "integrator": "z^{-1}"} if system.discrete else {}
    if system.B is None or through:
        return ()
    return (Diagram("The plant and its observer.", "observer", {"L": r"\sym{L}", **discrete}),)
