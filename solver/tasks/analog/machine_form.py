"""Lemma: what a machine integrates and adds up: the equations solved for the highest derivatives, a state each."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Derivation, Given, Step, Unsolved, lemma
from solver.derivation.conversion import converted_to
from solver.jets import jet_symbol
from solver.lazy import exact, systems
from solver.lazy import sympy as sp
from solver.stated.algebra import total
from solver.tasks.analog.machine_options import initial_of, inputs_of
from solver.tasks.modelling.first_order import FirstOrder, first_order_of, result_of
from solver.tasks.modelling.linear_model import matrices_of

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.jets import Jet
    from solver.systems import Equations
    from solver.tasks.analog.machine_options import MachineOptions


def form_of(given: Given[Equations, MachineOptions]) -> Derivation[exact.MachineEquations]:
    """The machine equations of a question."""
    model, options = given.system, given.options
    return (yield from machine_form_of(model, inputs_of(model, options), initial_of(model, options)))


@lemma("machine_form")
def machine_form_of(
    model: Equations, inputs: Mapping[Symbol, Expr | None], initial: Mapping[Jet, Expr]
) -> Derivation[exact.MachineEquations]:
    """One integrator for each state, one sum for each output that is none. Raises Unsolved."""
    _check_linear(model)
    if any(k for _, k in _inside(model.jets, [side for pair in model.sides for side in pair])):
        found = yield from _first_order(replace(model, initial=dict(initial)))
        rates: dict[Any, Any] = dict(zip(found.X, found.f, strict=True))
        start = found.x0.flat() if found.x0 is not None else [sp.S.Zero] * len(rates)
        sums = _sums_of(model, found)
    else:
        rates, start, sums = {}, [], _relations(model)
    equations: exact.MachineEquations = exact.machine_equations(rates, start, sums, inputs)
    yield Step(
        "machine",
        unclaimed="the equations found above, in the order of the states",
        integrated=[(each.variable, written(each.terms), each.initial) for each in equations.integrated],
        summed=[(each.variable, written(each.terms)) for each in equations.summed],
        put=[(u, value) for u, value in inputs.items() if value is not None],
        started=any(each.initial != 0 for each in equations.integrated),
    )
    return equations


def written(terms: Mapping[Expr, Expr]) -> Any:
    """A sum with its terms in their order."""
    shown = [coefficient * term for term, coefficient in terms.items()]
    return total(*shown) if len(shown) > 1 else shown[0] if shown else sp.S.Zero


def _inside(jets: Mapping[Symbol, Jet], expressions: Iterable[Expr]) -> list[Jet]:
    """The functions and derivatives that occur."""
    free = set().union(*(each.free_symbols for each in expressions))
    return [jet for symbol, jet in jets.items() if symbol in free]


def _check_linear(model: Equations) -> None:
    """Sums of functions and derivatives with constant factors, and a constant; raises Unsolved."""
    functions = {symbol for symbol, (name, _) in model.jets.items() if name in model.functions}
    for e in (*(left - right for left, right in model.sides), *model.outputs):
        for term in sp.Add.make_args(sp.expand(e)):
            factors = [each for each in sp.Mul.make_args(term) if each.free_symbols & functions]
            if len(factors) > 1 or any(each not in functions for each in factors):
                element = next(filter(None, map(_element, factors)), "multiplier")
                raise Unsolved("machines/not_linear", term=term, element=element)


def _element(factor: Any) -> str:
    """What computes a factor that is no function of time by itself; "" where multipliers do."""
    if factor.is_Symbol or (factor.is_Pow and factor.exp.is_Integer and factor.exp > 0 and not _element(factor.base)):
        return ""
    return "divider" if factor.is_Pow and factor.exp.is_Integer else "function generator"


@lemma("machine_form")
def _first_order(model: Equations) -> Derivation[FirstOrder]:
    """The equations of first order; those that are there already are taken as they stand."""
    if _is_first_order(model):
        return result_of(first_order_of(model))
    sides = [side for pair in model.sides for side in pair]
    late = any(k and name in model.inputs for name, k in _inside(model.jets, [*sides, *model.outputs]))
    rest = dict.fromkeys(model.jets, sp.S.Zero)
    if late and any((left - right).xreplace(rest) != 0 for left, right in model.sides):
        raise Unsolved("machines/constant_and_derivative")
    found = yield from first_order_of(model)
    if not any(k and name in model.inputs for name, k in _inside(found.model.jets, [*found.f, *found.h])):
        return found
    plant = yield from matrices_of(found)
    return result_of(first_order_of((yield from converted_to(plant, systems.Equations))))


def machine_model(model: Equations, initial: Mapping[Jet, Expr]) -> Equations:
    """The equations whose states the machine has: themselves, or a realization where inputs are differentiated."""
    sides = [side for pair in model.sides for side in pair]
    if not any(k and name in model.inputs for name, k in _inside(model.jets, sides)):
        return model
    return result_of(_first_order(replace(model, initial=dict(initial)))).model


def _is_first_order(model: Equations) -> bool:
    """Whether each equation is x' = … in the order of the states, without other derivatives."""
    below = [right for _, right in model.sides]
    states = [(name, 0) for name in model.unknowns]
    plain = not any(k for _, k in _inside(model.jets, [*below, *model.outputs]))
    left = [model.symbol((name, 1)) for name in model.unknowns]
    return plain and [side for side, _ in model.sides] == left and list(model.states or states) == states


def _sums_of(model: Equations, found: FirstOrder) -> dict[Symbol, Expr]:
    """The outputs that are no states, by name: a derivative or an eliminated unknown by its own, else y, y1, y2, …."""
    taken = {*(str(x) for x in found.X), *model.functions, *(str(each) for each in model.parameters)}
    sums: dict[Symbol, Expr] = {}
    for i, (output, value) in enumerate(zip(model.outputs, found.h, strict=True), 1):
        if value in found.X:
            continue
        name = "y" if len(model.outputs) == 1 else f"y{i}"
        own: Any = output if output in model.jets else jet_symbol((name if name not in taken else f"{name}_out", 0))
        sums[own] = value
    return sums


def _relations(model: Equations) -> dict[Symbol, Expr]:
    """Relations without derivatives, each after those that it takes from. Raises Unsolved for a loop."""
    unknowns = [model.symbol((name, 0)) for name in model.unknowns]
    found: dict[Any, Any] = dict(model.sides)
    if set(found) != set(unknowns):
        solved = exact.solved_linearly([left - right for left, right in model.sides], unknowns)
        if solved is None:
            raise Unsolved("equations/not_solvable")
        found = solved
    ordered: dict[Symbol, Expr] = {}
    while len(ordered) < len(found):
        ready = [x for x in found if x not in ordered and not found[x].free_symbols & (set(found) - set(ordered))]
        if not ready:
            raise Unsolved("machines/algebraic_loop", unknowns=_looped(found, ordered))
        ordered |= {x: found[x] for x in ready}
    return ordered


def _looped(found: Mapping[Symbol, Expr], ordered: Mapping[Symbol, Expr]) -> Sequence[Symbol]:
    return [x for x in found if x not in ordered]
