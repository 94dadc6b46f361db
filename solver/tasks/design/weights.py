"""The weights of a regulator: given, from the outputs or from tolerances; and the factor before the cost."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Given, Step, lemma
from solver.lazy import sympy as sp
from solver.stated import Stated
from solver.stated.algebra import product
from solver.stated.matrices import transpose
from solver.tasks.design.regulator import faulty_weights, given_or_identity

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix


def faulty_state_weight(system: Any, options: Mapping[str, Any]) -> Iterable[tuple[str, str]]:
    """Faults of the weight of the state: given twice or not at all, of the wrong size or sign."""
    ways = [name for name in ("Q", "output_weight", "tolerances") if name in options]
    if not ways and "R" not in options:
        yield "", "say what is weighed: give Q and R, or output_weight, or tolerances"
    for other in ways[1:]:
        yield other, f"the weight of the state is given twice, by {ways[0]} and by {other}"
    W: Any = options.get("output_weight")
    C: Any = getattr(system, "C", None)
    if W is not None and C is None:
        yield "output_weight", "output_weight needs outputs, and the system has no C"
    elif W is not None:
        p = C.rows
        if W.shape not in {(1, 1), (p, p)}:
            yield "output_weight", f"output_weight must be a number or {p}×{p}, one row and column for each output"
        else:
            yield from (
                ("output_weight", message.replace("Q", "output_weight", 1)) for _, message in faulty_weights({"Q": W})
            )
    tolerances = options.get("tolerances")
    if tolerances is not None and any(x.is_positive is False for x in tolerances):
        yield "tolerances", "tolerances must be positive"


def weights_as_stated(given: Given) -> tuple[Any, ImmutableMatrix]:
    """Q, as the formula that gives it where there is one, and R."""
    C, W, tolerances = given.system.C, given.output_weight, given.tolerances
    R = given_or_identity(given.R, given.system.B.cols)
    if tolerances is not None:
        return sp.ImmutableMatrix(sp.diag(*(1 / x**2 for x in tolerances))), R
    if W is None:
        return given_or_identity(given.Q, given.system.order), R
    if W.shape == (1, 1):
        return product(W[0, 0], transpose(C), C), R
    return product(transpose(C), W, C), R


def state_weight(given: Given) -> ImmutableMatrix:
    """Q (n×n) multiplied out."""
    stated, _ = weights_as_stated(given)
    if not isinstance(stated, Stated):
        return stated
    C, W = given.system.C, given.output_weight
    scale = W[0, 0] * sp.eye(C.rows) if W.shape == (1, 1) else W
    return sp.ImmutableMatrix((C.T * scale * C).expand())


@lemma("weights")
def weights_of(given: Given) -> Derivation[tuple[ImmutableMatrix, ImmutableMatrix]]:
    """Show Q and R as used."""
    W, Q = given.output_weight, state_weight(given)
    stated, R = weights_as_stated(given)
    claims = {"Q": Claim(stated, Q, "weight of the state")} if isinstance(stated, Stated) else {}
    way = "outputs" if W is not None else "tolerances" if given.tolerances is not None else "given"
    yield Step(
        "weights",
        claims=claims,
        unclaimed="" if claims else "the weights are given",
        Q=Q,
        R=R,
        way=way,
        scalar=W is not None and W.shape == (1, 1),
        chosen_Q=way == "given" and given.Q is None,
        chosen_R=given.R is None,
        tolerances=list(given.tolerances) if given.tolerances is not None else [],
        factor=cost_factor(given),
    )
    return Q, R


def cost_factor(given: Given) -> Expr:
    """The factor before the integral."""
    return given.cost_factor if given.cost_factor is not None else sp.Rational(1, 2)
