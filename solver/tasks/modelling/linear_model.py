"""Lemma: linear equations in state space: brought to first order, the matrices are read off."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact, systems
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.tasks.modelling.first_order import FirstOrder, first_order_of, is_linear

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.systems import Equations, StateSpace


@dataclass(frozen=True, slots=True)
class LinearModel:
    """The state space, and what was eliminated: unknowns in terms of the others."""

    plant: StateSpace
    eliminated: dict[Symbol, Expr] = field(default_factory=dict)


@lemma("linear_model")
def state_space_of(model: Equations) -> Derivation[LinearModel]:
    """Bring linear equations to first order and read off their matrices. Raises Unsolved."""
    if not is_linear(model):
        raise Unsolved("equations/not_linear")
    found = yield from first_order_of(model)
    plant = yield from matrices_of(found)
    return LinearModel(plant, found.eliminated)


@lemma("linear_model")
def matrices_of(found: FirstOrder) -> Derivation[StateSpace]:
    """The rows of A and B are the derivatives of the states, those of C and D the outputs."""
    model, X, rows, outputs, x0 = found.model, found.X, found.f, found.h, found.x0
    A, C = exact.matrix_of(rows, X), exact.matrix_of(outputs, X)
    if not model.inputs:
        yield _matrices(model, X, rows, outputs, A, None, C, None)
        return systems.StateSpace(A, None, C, None, x0, model.discrete, model.sample_time, tuple(map(str, X)))
    top = max((k for name, k in model.jets.values() if name in model.inputs
               and any(e.has(model.symbol((name, k))) for e in (*rows, *outputs))), default=0)  # fmt: skip
    inputs = [[model.symbol((name, k)) for name in model.inputs] for k in range(top + 1)]
    drives, through = ([exact.matrix_of(each, symbols) for symbols in inputs] for each in (rows, outputs))
    if top == 0:
        yield _matrices(model, X, rows, outputs, A, drives[0], C, through[0])
        return systems.StateSpace(A, drives[0], C, through[0], x0, model.discrete, model.sample_time,
                                  tuple(map(str, X)), model.inputs)  # fmt: skip
    shifted = exact.realized(A, drives, C, through)
    if shifted is None:
        raise Unsolved("equations/improper")
    claims = {
        f"shift{k}": Claim(total(product(A, S), M), shifted.shifts[k - 1] if k else shifted.B, f"$A S_{k} + B_{k}$")
        for k, (S, M) in reversed(list(enumerate(zip(shifted.shifts, drives, strict=True))))
    }
    claims["through"] = Claim(total(product(C, shifted.shifts[0]), through[0]), shifted.D, "$C S_0 + D_0$")
    yield Step("input_derivatives", claims=claims, A=A, C=C, drives=drives, shifts=shifted.shifts, B=shifted.B,
               D=shifted.D, discrete=model.discrete)  # fmt: skip
    return systems.StateSpace(A, shifted.B, C, shifted.D, None if model.discrete else x0, model.discrete,
                              model.sample_time, (), model.inputs)  # fmt: skip


def _matrices(
    model: Equations,
    X: Sequence[Symbol],
    rows: Sequence[Expr],
    outputs: Sequence[Expr],
    A: ImmutableMatrix,
    B: ImmutableMatrix | None,
    C: ImmutableMatrix,
    D: ImmutableMatrix | None,
) -> Step:
    """The matrices, claimed to give the equations back."""
    state, right, y = (sp.ImmutableMatrix(list(each)) for each in (X, rows, outputs))
    u = sp.ImmutableMatrix([model.symbol((name, 0)) for name in model.inputs])
    of_state = product(A, state) if B is None else total(product(A, state), product(B, u))
    of_output = product(C, state) if D is None else total(product(C, state), product(D, u))
    claims = {"state": Claim(of_state, right, "state equation"), "output": Claim(of_output, y, "output")}
    driven = None if B is None else u[0, 0] if u.rows == 1 else u
    return Step("matrices", claims=claims, A=A, B=B, C=C, D=D, X=state, u=driven)
