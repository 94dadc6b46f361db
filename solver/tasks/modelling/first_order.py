"""Lemma: equations brought to first order: solve for the highest derivatives, choose the states, x' = f and y = h."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, TypeVar

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.modelling.mass_matrix import mass_matrix
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.jets import Jet
    from solver.systems import Equations

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class FirstOrder:
    """x' = `f`, y = `h` in the `states`, the inputs and, of linear equations, their derivatives.

    `model` are the equations that are left when what has no derivative is `eliminated`; `x0` is the initial state,
    where one is given. In discrete time f is x(k+1).
    """

    model: Equations
    states: tuple[Jet, ...]
    f: tuple[Expr, ...]
    h: tuple[Expr, ...]
    eliminated: dict[Symbol, Expr] = field(default_factory=dict)
    x0: ImmutableMatrix | None = None

    @property
    def X(self) -> list[Symbol]:
        """The symbols of the states."""
        return [self.model.symbol(jet) for jet in self.states]

    @property
    def U(self) -> list[Symbol]:
        """The symbols of the inputs."""
        return [self.model.symbol((name, 0)) for name in self.model.inputs]

    @property
    def is_linear(self) -> bool:
        """Whether f and h are sums of states, inputs and their derivatives with constant factors."""
        return _are_linear([*self.f, *self.h], self.model)


def result_of(derivation: Derivation[T]) -> T:
    """Run a derivation whose steps are not shown. Raises Unsolved."""
    while True:
        try:
            next(derivation)
        except StopIteration as end:
            found: T = end.value
            return found


def is_linear(model: Equations) -> bool:
    """Whether every equation and output is a sum of unknowns, inputs and their derivatives with constant factors."""
    return _are_linear([*(left - right for left, right in model.sides), *model.outputs], model)


def _are_linear(expressions: Sequence[Expr], model: Equations) -> bool:
    jets = list(model.jets)
    return not exact.is_nonlinear(expressions, jets) and bool(exact.is_linear(expressions, jets))


@lemma("first_order")
def first_order_of(model: Equations) -> Derivation[FirstOrder]:
    """Eliminate, solve for the highest derivatives, choose the states. Raises Unsolved."""
    model = yield from _without_delays(model)
    model, eliminated = yield from _eliminated(model, _without_derivatives(model))
    model, by_rates = yield from _eliminated(model, _rates(model))
    eliminated = {**{x: value.xreplace(by_rates) for x, value in eliminated.items()}, **by_rates}
    solved, rest = yield from _solved_for_the_highest(model)
    states = _states(model)
    following = [model.symbol((name, k + 1)) for name, k in states]
    rows = tuple(solved.get(symbol, symbol) for symbol in following)
    X = [model.symbol(jet) for jet in states]
    moved = [(symbol, row, symbol in solved) for symbol, row in zip(following, rows, strict=True)]
    yield Step("states", unclaimed="a choice", states=X, following=moved, discrete=model.discrete)
    normal = sp.expand if is_linear(model) else exact.normal
    outputs = tuple(normal(_below_the_highest(model, output, solved)) for output in model.outputs)
    found = FirstOrder(model, states, rows, outputs, {**eliminated, **rest}, _initial(model, states))
    if not found.is_linear:
        _check_inputs(found)
    return found


def _below_the_highest(model: Equations, output: Expr, solved: Mapping[Symbol, Expr]) -> Expr:
    """An output in what is below the highest derivatives; higher ones are the derivatives of these."""
    highest = {model.jets[symbol][0]: symbol for symbol in solved if symbol in model.jets}
    for _ in range(len(model.jets)):
        orders = {symbol: jet for symbol, jet in model.jets.items() if output.has(symbol) and jet[0] in highest}
        above = {symbol: jet for symbol, jet in orders.items() if jet[1] > model.jets[highest[jet[0]]][1]}
        if not above:
            break
        put = {
            symbol: _advanced(model, solved[highest[name]], k - model.jets[highest[name]][1])
            for symbol, (name, k) in above.items()
        }
        output = output.xreplace(put).xreplace(dict(solved))
    put_in: Expr = output.xreplace(dict(solved))
    return put_in


@lemma("first_order")
def functions_of(found: FirstOrder) -> Derivation[None]:
    """The right sides one above the other: f and h."""
    f, h = (sp.ImmutableMatrix(list(each)) for each in (found.f, found.h))
    following = sp.ImmutableMatrix([found.model.symbol((name, k + 1)) for name, k in found.states])
    yield Step("functions", unclaimed="the rows found above", f=f, h=h, X=found.X, following=following,
               discrete=found.model.discrete)  # fmt: skip


def _check_inputs(found: FirstOrder) -> None:
    """Derivatives of inputs are taken into the states of linear equations only."""
    model = found.model
    inside = set().union(*(e.free_symbols for e in (*found.f, *found.h)))
    late = [symbol for symbol, (name, k) in model.jets.items() if name in model.inputs and k and symbol in inside]
    if late:
        raise Unsolved("equations/input_derivative", symbols=sorted(late, key=str))


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
    """The derivative with respect to time, `by` times (discrete: so many samples later)."""
    functions = (*model.unknowns, *model.inputs)
    moved = {symbol: jet for symbol, jet in model.jets.items() if jet[0] in functions}
    if model.discrete:
        later: Expr = expression.xreplace({s: model.symbol((name, k + by)) for s, (name, k) in moved.items()})
        return later
    for _ in range(by):
        moved |= {model.symbol((name, k + 1)): (name, k + 1) for name, k in list(moved.values())}
        following = {s: model.symbol((name, k + 1)) for s, (name, k) in moved.items()}
        expression = exact.time_derivative(expression, following)
    return expression


@lemma("first_order")
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


def _solved_for(expressions: Sequence[Expr], wanted: Sequence[Symbol], *, linear: bool) -> dict[Symbol, Expr] | None:
    """Solve for symbols that occur linearly; None where that is not possible."""
    found: dict[Symbol, Expr] | None
    if linear:
        found = exact.solved_for(expressions, wanted)
    else:
        found = exact.solved_linearly(expressions, wanted) if exact.are_linear_in(expressions, wanted) else None
    return found


def _without_derivatives(model: Equations) -> dict[int, list[str]]:
    """The equations without derivatives, by their numbers, with the algebraic unknowns in them."""
    return {i: [name for name in model.algebraic if (left - right).has(model.symbol((name, 0)))]
            for i, (left, right) in enumerate(model.sides) if not _derivatives_in(model, left - right)}  # fmt: skip


def _rates(model: Equations) -> dict[int, list[str]]:
    """The equations, as x' = r omega, with an algebraic unknown whose own derivative stands in another one only."""
    orders, found = _orders(model), {}
    for i, (left, right) in enumerate(model.sides):
        inside = {model.jets[s] for s in (left - right).free_symbols if s in model.jets}
        found[i] = [name for name in model.algebraic if orders.get(name, 0) > 0
                    and [k for each, k in inside if each == name] == [0]]  # fmt: skip
    return {i: names for i, names in found.items() if names}


@lemma("first_order")
def _eliminated(
    model: Equations, relations: Mapping[int, Sequence[str]]
) -> Derivation[tuple[Equations, dict[Symbol, Expr]]]:
    """Algebraic unknowns by relations, equations by their numbers; they and their derivatives put into the others."""
    differences = [left - right for left, right in model.sides]
    wanted = [name for name in model.algebraic if any(name in names for names in relations.values())]
    symbols = [model.symbol((name, 0)) for name in wanted]
    used = [i for i, names in relations.items() if names]
    found = _solved_for([differences[i] for i in used], symbols, linear=is_linear(model)) if used else None
    if not found:
        return model, {}
    put = {model.symbol((name, k)): _advanced(model, found[model.symbol((name, 0))], k)
           for name in wanted for k in {k for each, k in model.jets.values() if each == name}}  # fmt: skip
    claims = {
        f"relation{i}": Claim(model.sides[i][0].xreplace(put), model.sides[i][1].xreplace(put), "the relation")
        for i in used
    }
    others = [pair for i, pair in enumerate(model.sides) if i not in used]
    kept = [tuple(side.xreplace(put) for side in pair) for pair in others]
    later = [(x, put[x]) for x in put if x not in found and any(side.has(x) for pair in others for side in pair)]
    yield Step("eliminated", claims=claims, relations=[model.sides[i] for i in used], found=list(found.items()),
               later=later, kept=kept, rates=any(_derivatives_in(model, differences[i]) for i in used))  # fmt: skip
    left = _with_jets(model, kept, [output.xreplace(put) for output in model.outputs])
    names = tuple(name for name in model.unknowns if name not in wanted)
    return replace(left, unknowns=names, algebraic=tuple(n for n in model.algebraic if n not in wanted)), found


@lemma("first_order")
def _solved_for_the_highest(model: Equations) -> Derivation[tuple[dict[Symbol, Expr], dict[Symbol, Expr]]]:
    """The highest derivatives, and unknowns without any, in terms of what is below them."""
    wanted = {symbol: model.jets[symbol][1] for symbol in highest_in(model)}
    if not any(wanted.values()):
        raise Unsolved("equations/no_states")
    differences = [left - right for left, right in model.sides]
    found = _solved_for(differences, list(wanted), linear=is_linear(model))
    if found is None:
        if exact.are_linear_in(differences, list(wanted)):
            raise Unsolved("equations/not_solvable")
        raise Unsolved("equations/highest_not_linear")
    claims = {
        f"equation{i}": Claim(left.xreplace(found), right.xreplace(found), Phrase("equation {i}", i=i))
        for i, (left, right) in enumerate(model.sides, 1)
    }
    steps = mass_matrix(differences, list(wanted), found)
    yield Step("highest", claims=claims, steps=steps, equations=model.sides, found=list(found.items()),
               discrete=model.discrete)  # fmt: skip
    return found, {symbol: value for symbol, value in found.items() if wanted[symbol] == 0}


def highest_in(model: Equations) -> tuple[Symbol, ...]:
    """Return the highest derivative of each unknown that occurs; the unknown itself where none does."""
    return tuple(model.symbol(jet) for jet in _orders(model).items())


def _states(model: Equations) -> tuple[Jet, ...]:
    """The states as named, else each unknown with its derivatives below the highest."""
    orders = _orders(model)
    usual = tuple((name, k) for name in model.unknowns for k in range(orders.get(name, 0)))
    if model.states and set(model.states) != set(usual):
        raise Unsolved("equations/states", usual=[model.symbol(jet) for jet in usual])
    if not usual:
        raise Unsolved("equations/no_states")
    return model.states or usual


def _initial(model: Equations, states: Sequence[Jet]) -> ImmutableMatrix | None:
    """The initial state, where it is given; what is not named starts at zero."""
    if not model.initial:
        return None
    return sp.ImmutableMatrix([model.initial.get(jet, sp.Integer(0)) for jet in states])
