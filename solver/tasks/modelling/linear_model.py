"""Lemma: linear equations in state space: solve for the highest derivatives, choose the states, read off."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact, systems
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.systems import Equations, StateSpace
    from solver.systems.equations import Jet


@dataclass(frozen=True, slots=True)
class LinearModel:
    """The state space, and what was eliminated: unknowns in terms of the others."""

    plant: StateSpace
    eliminated: dict[Symbol, Expr] = field(default_factory=dict)


def is_linear(model: Equations) -> bool:
    """Whether every equation and output is a sum of unknowns, inputs and their derivatives with constant factors."""
    return bool(exact.is_linear([left - right for left, right in model.sides] + list(model.outputs), list(model.jets)))


@lemma("linear_model")
def state_space_of(model: Equations) -> Derivation[LinearModel]:
    """Eliminate, solve for the highest derivatives, choose the states, read off. Raises Unsolved."""
    if not is_linear(model):
        raise Unsolved("equations/not_linear")
    model = yield from _without_delays(model)
    model, eliminated = yield from _eliminated(model)
    solved, rest = yield from _solved_for_the_highest(model)
    plant = yield from _read_off(model, solved)
    return LinearModel(plant, {**eliminated, **rest})


def _orders(model: Equations) -> dict[str, int]:
    """The highest derivative of each unknown that occurs."""
    found: dict[str, int] = {}
    inside = set().union(*(side.free_symbols for pair in model.sides for side in pair))
    for symbol, (name, k) in model.jets.items():
        if name in model.unknowns and symbol in inside:
            found[name] = max(k, found.get(name, k))
    return found


def _with_jets(model: Equations, sides: Sequence[tuple[Expr, Expr]], outputs: Sequence[Expr]) -> Equations:
    """The model with other sides and outputs; all derivatives that may occur in them are known by their symbols."""
    highest = 2 * max((abs(k) for _, k in model.jets.values()), default=0) + 1
    jets = {model.symbol((name, k)): (name, k) for name in (*model.unknowns, *model.inputs) for k in range(highest + 1)}
    return replace(model, sides=tuple(sides), outputs=tuple(outputs), jets=jets)


def _advanced(model: Equations, expression: Expr, by: int) -> Expr:
    """The derivative of a linear expression, `by` times (discrete: so many samples later)."""
    following = {
        symbol: model.symbol((name, k + by))
        for symbol, (name, k) in model.jets.items()
        if name in model.unknowns or name in model.inputs
    }
    found: Expr = expression.xreplace(following)
    return found


@lemma("linear_model")
def _without_delays(model: Equations) -> Derivation[Equations]:
    """Equations in y(k−1), ... hold at any k: they are written some samples later."""
    sides = []
    for left, right in model.sides:
        by = -min((k for symbol, (_, k) in model.jets.items() if (left - right).has(symbol)), default=0)
        sides.append((_advanced(model, left, by), _advanced(model, right, by)) if by > 0 else (left, right))
    if any(k < 0 and output.has(symbol) for output in model.outputs for symbol, (_, k) in model.jets.items()):
        raise Unsolved("equations/delayed_output")
    moved = _with_jets(model, sides, model.outputs)
    if tuple(sides) != model.sides:
        yield Step("shifted", unclaimed="the same equations, some samples later", equations=sides)
    return moved


def _derivatives_in(model: Equations, expression: Expr) -> bool:
    """Whether a derivative of an unknown occurs."""
    jets = {jet for symbol, jet in model.jets.items() if expression.has(symbol)}
    return any(k > 0 and name in model.unknowns for name, k in jets)


@lemma("linear_model")
def _eliminated(model: Equations) -> Derivation[tuple[Equations, dict[Symbol, Expr]]]:
    """Algebraic unknowns by the equations without derivatives, these and their derivatives put into the others."""
    differences = [left - right for left, right in model.sides]
    without = [i for i, e in enumerate(differences) if not _derivatives_in(model, e)]
    wanted = [name for name in model.algebraic if any(differences[i].has(model.symbol((name, 0))) for i in without)]
    symbols = [model.symbol((name, 0)) for name in wanted]
    used = [i for i in without if differences[i].has(*symbols)] if symbols else []
    found = exact.solved_for([differences[i] for i in used], symbols) if used else None
    if not found:
        return model, {}
    put = {model.symbol((name, k)): _advanced(model, found[model.symbol((name, 0))], k)
           for name in wanted for k in {k for each, k in model.jets.values() if each == name}}  # fmt: skip
    claims = {
        f"relation{i}": Claim(model.sides[i][0].xreplace(put), model.sides[i][1].xreplace(put), "the relation")
        for i in used
    }
    yield Step("eliminated", claims=claims, relations=[model.sides[i] for i in used], found=list(found.items()))
    kept = [tuple(side.xreplace(put) for side in pair) for i, pair in enumerate(model.sides) if i not in used]
    left = _with_jets(model, kept, [output.xreplace(put) for output in model.outputs])
    names = tuple(name for name in model.unknowns if name not in wanted)
    return replace(left, unknowns=names, algebraic=tuple(n for n in model.algebraic if n not in wanted)), found


@lemma("linear_model")
def _solved_for_the_highest(model: Equations) -> Derivation[tuple[dict[Symbol, Expr], dict[Symbol, Expr]]]:
    """The highest derivatives, and unknowns without any, in terms of what is below them."""
    orders = _orders(model)
    wanted = {model.symbol((name, k)): k for name, k in orders.items()}
    if not any(wanted.values()):
        raise Unsolved("equations/no_states")
    found = exact.solved_for([left - right for left, right in model.sides], list(wanted))
    if found is None:
        raise Unsolved("equations/not_solvable")
    claims = {
        f"equation{i}": Claim(left.xreplace(found), right.xreplace(found), Phrase("equation {i}", i=i))
        for i, (left, right) in enumerate(model.sides, 1)
    }
    yield Step("highest", claims=claims, equations=model.sides, found=list(found.items()), discrete=model.discrete)
    return found, {symbol: value for symbol, value in found.items() if wanted[symbol] == 0}


def _states(model: Equations) -> tuple[Jet, ...]:
    """The states as named, else each unknown with its derivatives below the highest."""
    orders = _orders(model)
    usual = tuple((name, k) for name in model.unknowns for k in range(orders.get(name, 0)))
    if model.states and set(model.states) != set(usual):
        raise Unsolved("equations/states", usual=[model.symbol(jet) for jet in usual])
    if not usual:
        raise Unsolved("equations/no_states")
    return model.states or usual


@lemma("linear_model")
def _read_off(model: Equations, solved: dict[Symbol, Expr]) -> Derivation[StateSpace]:
    """The rows of A and B are the derivatives of the states, those of C and D the outputs."""
    states = _states(model)
    X = [model.symbol(jet) for jet in states]
    following = [model.symbol((name, k + 1)) for name, k in states]
    rows = [solved.get(symbol, symbol) for symbol in following]
    outputs = [sp.expand(output.xreplace(solved)) for output in model.outputs]
    yield Step("states", unclaimed="a choice", states=X, following=list(zip(following, rows, strict=True)),
               discrete=model.discrete)  # fmt: skip
    A, C = exact.matrix_of(rows, X), exact.matrix_of(outputs, X)
    x0 = _initial(model, states)
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
    found = exact.realized(A, drives, C, through)
    if found is None:
        raise Unsolved("equations/improper")
    claims = {
        f"shift{k}": Claim(total(product(A, S), M), found.shifts[k - 1] if k else found.B, f"$A S_{k} + B_{k}$")
        for k, (S, M) in reversed(list(enumerate(zip(found.shifts, drives, strict=True))))
    }
    claims["through"] = Claim(total(product(C, found.shifts[0]), through[0]), found.D, "$C S_0 + D_0$")
    yield Step("input_derivatives", claims=claims, A=A, C=C, drives=drives, shifts=found.shifts, B=found.B, D=found.D,
               discrete=model.discrete)  # fmt: skip
    return systems.StateSpace(A, found.B, C, found.D, None if model.discrete else x0, model.discrete,
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
    return Step("matrices", claims=claims, A=A, B=B, C=C, D=D)


def _initial(model: Equations, states: Sequence[Jet]) -> ImmutableMatrix | None:
    """The initial state, where it is given; what is not named starts at zero."""
    if not model.initial:
        return None
    return sp.ImmutableMatrix([model.initial.get(jet, sp.Integer(0)) for jet in states])
