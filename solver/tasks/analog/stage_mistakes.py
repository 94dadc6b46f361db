"""Usual mistakes with inverting stages: values they lead to, and the stages that would have the value submitted."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import combinations
from typing import TYPE_CHECKING, Any, TypeVar

from solver.derivation import Attempt, Options, Slip, Task
from solver.lazy import exact
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpAmp

O = TypeVar("O", bound=Options)

NOT_INVERTED = Slip("inversion", "the inversion of the inputs is left out")
RATIO = Slip("ratio", "the quotient of feedback and input is upside down")
WITHOUT_RC = Slip("RC", "the factor of the product $RC$ is left out")
INITIAL_LEFT_OUT = Slip("initial", "the initial output is left out")
INITIAL_REVERSED = Slip("initial_sign", "the initial output has the wrong sign")
INPUTS_EXCHANGED = Slip("inputs", "the parts of two inputs are exchanged")
INTEGRATOR_FOR_DIFFERENTIATOR = Slip("R_and_C", "resistor and capacitor are exchanged")
ONE_STAGE_LESS = Slip("cascade", "the last stage is left out")


def register(task: Task[Any, Any]) -> None:
    """Register what goes wrong with stages."""
    for slip, changed in ((NOT_INVERTED, _not_inverted), (RATIO, _upside_down), (WITHOUT_RC, _without_rc)):
        task.mistake(slip, "v_o", "V_o")(_values(changed))
    task.mistaken_question(INITIAL_LEFT_OUT)(initial_left_out)
    task.mistaken_question(INITIAL_REVERSED)(initial_reversed)
    task.mistaken_question(INPUTS_EXCHANGED)(inputs_exchanged)
    task.mistaken_question(INTEGRATOR_FOR_DIFFERENTIATOR)(parts_exchanged)
    task.mistaken_question(ONE_STAGE_LESS)(without_the_last)


def _values(changed: Callable[[OpAmp, Any], Any]) -> Callable[[Attempt[Any, Any]], Iterator[Expr]]:
    """The answer of responses that are changed; nothing where nothing is."""

    def values(wrong: Attempt[Any, Any]) -> Iterator[Expr]:
        system = wrong.given.system
        if (initial := wrong.given.options.initial_output) is not None:
            system = system.starting(initial)
        response = exact.cascade_responses(system.stages)[-1]
        found = changed(system, response)
        if found is None:
            return
        if wrong.name == "v_o":
            yield found.in_time({name: system.symbol(name) for name in system.inputs})
        else:
            yield found.transform({name: system.transform(name) for name in system.inputs})

    return values


def _with_terms(response: Any, change: Callable[[int, Any], Any]) -> Any:
    terms = {name: {k: change(k, c) for k, c in powers.items()} for name, powers in response.terms.items()}
    return replace(response, terms=terms)


def _not_inverted(_: OpAmp, response: Any) -> Any:
    """The inputs with the other sign beside an initial output; without one the sign of the whole is reversed."""
    return _with_terms(response, lambda _, c: -c) if response.held else None


def _upside_down(system: OpAmp, response: Any) -> Any:
    static = all(k == 0 for powers in response.terms.values() for k in powers)
    if not static or response.held:
        return None
    return _with_terms(response, lambda _, c: (-1) ** len(system.stages) / abs(c) if c.is_number else 1 / c)


def _without_rc(system: OpAmp, response: Any) -> Any:
    if len(system.stages) > 1 or not any(k for powers in response.terms.values() for k in powers):
        return None
    return _with_terms(response, lambda k, c: -sp.S.One if k else c)


Question = tuple[Any, O] | None


def _initial(system: Any, options: Any) -> Any:
    """What the last stage holds, and the question without the option that says so."""
    given = getattr(options, "initial_output", None)
    held = system.stages[-1].initial if given is None else given
    return held, options if given is None else replace(options, initial_output=None)


def initial_left_out(system: Any, options: O) -> Question[O]:
    """Nothing is held before t = 0."""
    held, others = _initial(system, options)
    return (system.starting(sp.S.Zero), others) if held != 0 else None


def initial_reversed(system: Any, options: O) -> Question[O]:
    """What is held with the other sign."""
    held, others = _initial(system, options)
    return (system.starting(-held), others) if held != 0 else None


def _changed(system: Any, options: O, number: int, stage: Any) -> Question[O]:
    stages = [stage if i == number else each for i, each in enumerate(system.stages)]
    return replace(system, stages=tuple(stages)), options


def inputs_exchanged(system: Any, options: O) -> Question[O]:
    """The parts of the first two inputs that differ, exchanged."""
    for i, stage in enumerate(system.stages):
        for a, b in combinations(range(len(stage.inputs)), 2):
            (v, first), (w, second) = stage.inputs[a], stage.inputs[b]
            if first != second:
                inputs = list(stage.inputs)
                inputs[a], inputs[b] = (v, second), (w, first)
                return _changed(system, options, i, replace(stage, inputs=tuple(inputs)))
    return None


def parts_exchanged(system: Any, options: O) -> Question[O]:
    """The resistor at the only input and the capacitor in the feedback of a stage, exchanged; or the reverse."""
    for i, stage in enumerate(system.stages):
        parts = [part for _, part in stage.inputs]
        if len(parts) == 1 and parts[0].letter != stage.feedback.letter and stage.initial == 0:
            turned = replace(stage, inputs=((stage.inputs[0][0], stage.feedback),), feedback=parts[0])
            return _changed(system, options, i, turned)
    return None


def without_the_last(system: Any, options: O) -> Question[O]:
    """The output of the stage before the last."""
    if len(system.stages) == 1 or _initial(system, options)[0] != 0:
        return None
    *before, last = system.stages[:-1]
    return replace(system, stages=(*before, replace(last, output=system.stages[-1].output))), options
