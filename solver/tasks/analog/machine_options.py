"""What is asked of a machine: what acts on the equations, the maxima, the reference voltage and the time scale."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Options, Unsolved, option
from solver.derivation.conversion import converted
from solver.lazy import sympy as sp
from solver.options.initial_values import InitialValues
from solver.options.input_functions import InputFunctions
from solver.options.number import Number
from solver.tasks.modelling.first_order import result_of
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.jets import Jet
    from solver.systems import Equations, System


@dataclass(frozen=True, kw_only=True)
class MachineOptions(Options):
    """How the problem is put on the machine."""

    maximum: Mapping[Jet, Any] | None = option(
        InitialValues(), 'the largest sizes, as {x: 50, "x\'": 250}; those not given are found from the exact response'
    )
    reference: Any = option(Number(), "the reference voltage of the machine", default=10)
    time_scale: Any = option(Number(), "β of the machine time τ = β t", default=1)
    input: Mapping[str, Any] | None = option(InputFunctions(), "the inputs as functions of t ≥ 0: {u: 500}")
    initial: Mapping[Jet, Any] | None = option(
        InitialValues(), 'initial values, as {x: 40, "x\'": 150}; else those of the system; zero where none are given'
    )

    @property
    def volts(self) -> Expr:
        """The reference voltage."""
        return _expression(self.reference)

    @property
    def beta(self) -> Expr:
        """The factor of the machine time."""
        return _expression(self.time_scale)


def _expression(value: Any) -> Expr:
    """A default is a number as it is typed."""
    found: Expr = sp.Integer(value) if isinstance(value, int) else value
    return found


def initial_of(model: Equations, options: MachineOptions) -> Mapping[Jet, Any]:
    """The initial values: those of the option, else the system's."""
    return model.initial if options.initial is None else options.initial


def inputs_of(model: Equations, options: MachineOptions) -> dict[Symbol, Expr | None]:
    """Each input with its function of time; None where it has none."""
    given = options.input or {}
    return {model.symbol((name, 0)): given.get(name) for name in model.inputs}


def faults_of(system: System, options: MachineOptions) -> Iterable[tuple[str, Reason]]:
    """What is wrong with the question as it is asked."""
    for name in ("reference", "time_scale"):
        value = getattr(options, name)
        if value is not None and _expression(value).is_nonpositive:
            yield name, Reason("machines/not_positive", {"name": name})
    with suppress(Unsolved):
        model = result_of(converted(system, ["machine"]))
        yield from _wrong_inputs(model, options)
        yield from _wrong_values(model, options)
        yield from _lacking(model, options)


def _lacking(model: Equations, options: MachineOptions) -> Iterable[tuple[str, Reason]]:
    """Inputs without a function, where a largest size is to be found; relations without derivatives need them all."""
    free = [u for u, value in inputs_of(model, options).items() if value is None]
    maxima = options.maximum or {}
    wanted = [jet for jet in states_of(model) or [(name, 0) for name in model.unknowns] if jet not in maxima]
    static = not states_of(model)
    if wanted and (free or static) and "input" not in options.later:
        values = {"inputs": [str(u) for u in free], "wanted": [_primed(jet) for jet in wanted], "static": static}
        yield "", Reason("machines/no_function", values)


def states_of(model: Equations) -> list[Jet]:
    """Each unknown with its derivatives below the highest."""
    return [(name, k) for name in model.unknowns for k in range(_order(model, name))]


def _wrong_inputs(model: Equations, options: MachineOptions) -> Iterable[tuple[str, Reason]]:
    given = options.input or {}
    for name, value in given.items():
        if name not in model.inputs:
            yield "input", Reason("machines/no_input", {"name": name, "inputs": list(model.inputs)})
        elif value is not None and value.has(sp.DiracDelta):
            yield "input", Reason("machines/impulse", {"name": name})


def _wrong_values(model: Equations, options: MachineOptions) -> Iterable[tuple[str, Reason]]:
    """Names that are no variables; maxima that are none, and initial values beyond them."""
    known = states_of(model) or [(name, 0) for name in model.unknowns]
    maxima, initial = options.maximum or {}, initial_of(model, options)
    for jet, value in maxima.items():
        shown = _primed(jet)
        if jet not in known and jet[0] not in model.inputs:
            yield "maximum", Reason("machines/no_variable", {"name": shown, "known": [_primed(j) for j in known]})
        elif value.is_nonpositive:
            yield "maximum", Reason("machines/maximum_not_positive", {"name": shown, "value": value})
        elif jet in initial and (abs(initial[jet]) - value).is_positive:
            values = {"name": shown, "value": initial[jet], "maximum": value}
            yield "maximum", Reason("machines/initial_beyond_maximum", values)
    for jet in options.initial or {}:
        if jet not in known:
            values = {"name": _primed(jet), "known": [_primed(j) for j in known]}
            yield "initial", Reason("machines/no_initial_value", values)


def _order(model: Equations, name: str) -> int:
    """The highest derivative of an unknown that occurs in the equations."""
    inside = set().union(*(side.free_symbols for pair in model.sides for side in pair))
    return max((k for symbol, (own, k) in model.jets.items() if own == name and symbol in inside), default=0)


def _primed(jet: Jet) -> str:
    """A derivative as it is written in a file: x, x', x^(4)."""
    name, k = jet
    return name + "'" * k if k < 4 else f"{name}^({k})"
