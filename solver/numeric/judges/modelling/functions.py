"""Whether f and h are what equations say: at random states and inputs all derivatives are found in numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from random import Random
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.points import SEED, PointSource, free_symbols
from solver.numeric.evaluation.values import NotEvaluable, Undefined
from solver.numeric.judges.modelling.equations import Jet, Question, states_of
from solver.numeric.judges.modelling.jets import JetEquations, Jets, further

TRIALS, ATTEMPTS = 3, 12
SAYS = {
    "f": "the derivatives of the states at random states and inputs",
    "h": "the outputs at random states and inputs",
}


def function_residuals(
    question: Question, found: Mapping[str, Sequence[Any]], *, discrete: bool
) -> Iterator[tuple[str, str, float]]:
    """Yield for f and h a label and how far they are from what the equations say; inf for a wrong number of rows."""
    states = states_of(question)
    random = Random(SEED)  # noqa: S311 - nothing secret
    worst = dict.fromkeys(found, 0.0)
    own = {name: states if name == "f" else list(question.outputs) for name in found}
    worst |= {name: np.inf for name, rows in found.items() if len(rows) != len(own[name])}
    tried = 0
    for at, _, derivatives, outputs in _motions(question, found, states, random, discrete=discrete):
        tried += 1
        for name, wanted in (("f", derivatives), ("h", outputs)):
            if name in found and np.isfinite(worst[name]):
                worst[name] = max(worst[name], _apart(at, found[name], wanted, question.jets))
    for name, residual in worst.items():
        yield name, SAYS[name], residual if tried >= TRIALS else np.nan


def _motions(
    question: Question, found: Mapping[str, Sequence[Any]], states: Sequence[Jet], random: Random, *, discrete: bool
) -> Iterator[tuple[dict[Any, complex], Jets, Array, Array]]:
    """Yield points with all jets, the derivatives of the states and the outputs there."""
    everything = [*question.equations, *question.outputs, *(row for rows in found.values() for row in rows)]
    source = PointSource(symbol for symbol in free_symbols(everything) if symbol not in question.jets)
    done = 0
    for _ in range(ATTEMPTS):
        point = source.draw()
        equations = JetEquations(
            question.equations, question.jets, question.unknowns, point, discrete, further(question)
        )
        given = {jet: random.uniform(0.3, 1.4) for jet in [*states, *((name, 0) for name in question.inputs)]}
        given |= {jet: -given[jet] for symbol, jet in question.jets.items() if jet in given and symbol.is_negative}
        rest = {(name, k): random.uniform(-1.0, 1.0) for name in question.inputs for k in range(1, 3 + len(states))}
        jets = equations.solved({**rest, **given}, random)
        if jets is None:
            continue
        try:
            outputs = equations.values(list(question.outputs), jets)
        except Undefined:
            continue
        moved = np.array([jets.get((name, k + 1), np.nan) for name, k in states])
        at = {symbol: given[jet] for symbol, jet in question.jets.items() if jet in given}
        yield {**point, **at}, jets, moved, outputs
        done += 1
        if done == TRIALS:
            return


def value_residual(question: Question, symbol: Any, value: Any, *, discrete: bool) -> float:
    """Return how far an eliminated unknown's value is from what the equations give it at random states and inputs."""
    worst, random = [], Random(SEED)  # noqa: S311 - nothing secret
    name = next((jet for known, jet in question.jets.items() if str(known) == str(symbol)), (str(symbol), 0))
    for at, jets, *_ in _motions(question, {"": [value]}, states_of(question), random, discrete=discrete):
        known = {s: jets[jet] for s, jet in question.jets.items() if jet in jets}
        worst.append(_apart({**at, **known}, [value], np.array([jets.get(name, np.nan)]), question.jets))
    return max(worst) if len(worst) == TRIALS else np.nan


def _apart(at: Mapping[Any, complex], rows: Sequence[Any], wanted: Array, jets: Mapping[Any, Jet]) -> float:
    """The distance of a function from values, relative to them; inf where it cannot be evaluated there."""
    equations = JetEquations(rows, {}, (), at)
    if any(symbol in jets and symbol not in at for symbol in free_symbols(list(rows))):
        return np.inf  # what is neither a state nor an input stands in it
    try:
        found = equations.values(rows, {})
    except (NotEvaluable, Undefined, KeyError):
        return np.inf
    distance = float(np.max(np.abs(found - wanted) / np.maximum(1.0, np.abs(wanted)), initial=0.0))
    return distance if np.isfinite(distance) else np.inf
