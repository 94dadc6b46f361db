"""Lemma: the equations as a machine gets them: outputs that are no sums read off, the others in volts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.analog.machine_form import machine_model
from solver.tasks.analog.machine_options import MachineOptions, initial_of, inputs_of, states_of
from solver.tasks.analog.scaling import maxima_of, scaled_equations_of

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import Equations


@dataclass(frozen=True)
class Machine:
    """The equations in volts, those they come from, and what is read out: names with variable and factor.

    `given` are the maxima of the question, `named` the variables in volts by the others, `is_scaled` tells that
    factors other than one were asked about.
    """

    equations: exact.MachineEquations
    scaled: exact.MachineEquations
    scaling: exact.Scaling
    named: Mapping[Any, Symbol]
    readout: Mapping[str, tuple[Symbol, Expr]]
    given: Mapping[Symbol, Expr]
    reference: Expr
    beta: Expr

    def volts_per_unit(self, term: Any) -> Expr:
        """L of a variable; of the constant and of functions of time see the sources."""
        return self.scaling.of(term)


@lemma("scaled_program")
def scaled_for_machine(
    model: Equations, equations: exact.MachineEquations, options: MachineOptions
) -> Derivation[Machine]:
    """Scaled as the maxima say, found where they are not given; relations between voltages as they stand."""
    _check_numbers(equations)
    reference, beta = options.volts, options.beta
    given = {model.symbol(jet): value for jet, value in (options.maximum or {}).items()}
    kept, read = _read_off(equations)
    variables = [*(each.variable for each in kept.integrated), *(each.variable for each in kept.summed)]
    free = [u for u, value in inputs_of(model, options).items() if value is None]
    if not kept.integrated:
        known = {x: given[x] for x in variables if x in given}
    elif free and any(each.variable not in given for each in kept.integrated):
        known = {each.variable: given.get(each.variable, _at_least(reference, each)) for each in kept.integrated}
        yield Step("unscaled", unclaimed="a choice", inputs=free, reference=reference,
                   variables=[x for x in known if x not in given])  # fmt: skip
    else:
        own = {x: value for x, value in given.items() if any(each.variable == x for each in kept.integrated)}
        known = yield from maxima_of(kept, own)
    if kept.integrated:
        known = {**known, **_bounds(kept, known, given, reference)}
    if kept.summed and kept.integrated:
        rows = [(each.variable, known[each.variable]) for each in kept.summed if each.variable not in given]
        yield Step("bounds", unclaimed="the largest sizes of the terms, added up", rows=rows)
    if known:
        scaling, scaled = yield from scaled_equations_of(kept, known, reference, beta)
        named = exact.scaled_symbols(kept, scaling)
    else:
        scaling, scaled, named = exact.Scaling({}, sp.S.One), kept, {x: x for x in variables}
    told = {*map(model.symbol, states_of(model)), *(each.variable for each in kept.summed)}
    readout = {str(x): (named[x], 1 / scaling.of(x)) for x in variables if x in told}
    readout |= {str(y): (named[x], c / scaling.of(x)) for y, (x, c) in read.items()}
    realized = machine_model(model, initial_of(model, options)).outputs
    readout |= {str(y): (named[x], 1 / scaling.of(x)) for y, x in zip(model.outputs, realized, strict=True)
                if x != y and x in named and y in model.jets}  # fmt: skip
    own = {x: value for x, value in given.items() if x in variables}
    return Machine(kept, scaled, scaling, named, readout, own, reference, beta)


def _check_numbers(equations: exact.MachineEquations) -> None:
    """Coefficients and initial values are numbers; raises Unsolved."""
    rows: list[Any] = [*equations.integrated, *equations.summed]
    values = [c for each in rows for c in each.terms.values()]
    values += [each.initial for each in equations.integrated]
    symbols = sorted(set().union(*(value.free_symbols for value in values)), key=str)
    if symbols:
        raise Unsolved("analog_program/symbolic", symbols=symbols)


def _read_off(equations: exact.MachineEquations) -> tuple[exact.MachineEquations, dict[Any, tuple[Any, Expr]]]:
    """The equations without outputs that are a multiple of one integrated variable, and these."""
    integrated = {each.variable for each in equations.integrated}
    read: dict[Any, tuple[Any, Expr]] = {}
    for each in equations.summed:
        terms = list(each.terms.items())
        if len(terms) == 1 and terms[0][0] in integrated:
            read[each.variable] = terms[0]
    kept = tuple(each for each in equations.summed if each.variable not in read)
    return replace(equations, summed=kept), read


def _at_least(reference: Expr, each: exact.Integrated) -> Expr:
    """One volt per unit, unless the initial value needs less."""
    return sp.Max(reference, abs(each.initial))


def _bounds(
    equations: exact.MachineEquations, maxima: Mapping[Symbol, Expr], given: Mapping[Symbol, Expr], reference: Expr
) -> dict[Symbol, Expr]:
    """A bound of each sum: those of its terms added up; an input that is a name has the reference at most."""
    known = dict(maxima)
    for each in equations.summed:
        sizes = [abs(c) * _size(term, known, reference) for term, c in each.terms.items()]
        known[each.variable] = given.get(each.variable, sp.Add(*sizes))
    return {each.variable: known[each.variable] for each in equations.summed}


def _size(term: Any, known: Mapping[Symbol, Expr], reference: Expr) -> Expr:
    if term in known:
        return known[term]
    if term == 1:
        return sp.S.One
    if term.is_Symbol and term.name != "t":
        return reference
    try:
        return exact.bound(term)
    except exact.NoBound as case:
        raise Unsolved("analog_program/no_bound", function=case.function) from None
