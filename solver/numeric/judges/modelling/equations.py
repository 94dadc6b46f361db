"""Whether A, B, C, D move as linear equations say: derivatives found by least squares, transforms at random points.

Jets are the derivatives (discrete: samples) of the unknown functions and of the inputs; the equations are linear in
them, so that their coefficients are their values where one jet is 1 and the others are 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from random import Random
from typing import Any, NamedTuple

import numpy as np

from solver.numeric.evaluation.arithmetic import Array, equilibration
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import SEED, PointSource, free_symbols

TRIALS = 3
SAYS = {
    "A": "the derivative of the state at a random state",
    "B": "the derivative of the state at random inputs",
    "C": "the output at a random state",
    "D": "the output at random inputs",
}
"""What is compared in the judging of each matrix by derivatives."""

Jet = tuple[str, int]


class Question(NamedTuple):
    """Expressions that are zero, outputs, the jets by their symbols, unknowns, inputs, the states as named.

    `algebraic` are unknowns that have no states.
    """

    equations: Sequence[Any]
    outputs: Sequence[Any]
    jets: Mapping[Any, Jet]
    unknowns: Sequence[str]
    inputs: Sequence[str]
    states: Sequence[Jet]
    algebraic: Sequence[str] = ()


class _Numbers:
    """The coefficients of expressions in the jets at one point of the parameters."""

    def __init__(self, question: Question, point: Mapping[Any, complex]) -> None:
        self.question = question
        self.point = dict(point)
        self.order = max((k for _, k in question.jets.values()), default=0) + 1

    def coefficients(self, expressions: Iterable[Any], by: int = 0) -> list[dict[Jet, complex]]:
        """The coefficient of each jet, all of them `by` derivatives further."""
        found = []
        for expression in expressions:
            inside = [s for s in self.question.jets if s in free_symbols([expression])]
            zero = {**self.point, **dict.fromkeys(self.question.jets, 0.0)}
            row = {}
            for symbol in inside:
                name, k = self.question.jets[symbol]
                row[name, k + by] = _value(expression, {**zero, symbol: 1.0})
            found.append(row)
        return found


def _value(expression: Any, point: Mapping[Any, complex]) -> complex:
    return complex(np.ravel(value_of(expression, Environment.at([dict(point)])).value)[0])


def _points(question: Question) -> Iterator[dict[Any, complex]]:
    everything = [*question.equations, *question.outputs]
    symbols = [symbol for symbol in sorted(free_symbols(everything), key=str) if symbol not in question.jets]
    source = PointSource(symbols)
    for _ in range(TRIALS):
        yield dict(source.draw())


def states_of(question: Question) -> list[Jet]:
    """As named, else each unknown with its derivatives below the highest that occurs in the equations."""
    if question.states:
        return list(question.states)
    inside = []
    for equation in question.equations:
        own = [jet for symbol, jet in question.jets.items() if symbol in free_symbols(equation)]
        later = -min((k for _, k in own if k < 0), default=0)  # samples of the past: the equation so much later
        inside += [(name, k + later) for name, k in own]
    dynamic = [name for name in question.unknowns if name not in question.algebraic]
    return [(name, k) for name in dynamic for k in range(max((o for n, o in inside if n == name), default=0))]


def model_residuals(question: Question, found: Mapping[str, Any], *, free: bool) -> Iterator[tuple[str, str, float]]:
    """Yield for each matrix a label and how far it is from what the equations say, at several points."""
    judge = _by_transforms if free else _by_derivatives
    worst: dict[tuple[str, str], float] = {}
    random = Random(SEED)  # noqa: S311 - nothing secret
    for point in _points(question):
        numbers = _Numbers(question, point)
        matrices = {name: _matrix(M, numbers.point) for name, M in found.items()}
        for name, label, residual in judge(numbers, matrices, random):
            worst[name, label] = max(residual, worst.get((name, label), 0.0))
    for (name, label), residual in worst.items():
        yield name, label, residual


def _matrix(M: Any, point: Mapping[Any, complex]) -> Array:
    values = [_value(entry, point) for entry in M]
    return np.array(values, dtype=complex).reshape(M.shape)


def _solved(numbers: _Numbers, given: Mapping[Jet, complex]) -> dict[Jet, complex]:
    """All jets where some are given, by least squares on the equations and their derivatives."""
    rows = [row for by in range(numbers.order) for row in numbers.coefficients(numbers.question.equations, by)]
    unknown = sorted({jet for row in rows for jet in row} - set(given))
    left = np.array([[row.get(jet, 0.0) for jet in unknown] for row in rows], dtype=complex)
    right = -np.array([sum(c * given.get(jet, 0.0) for jet, c in row.items()) for row in rows], dtype=complex)
    if not unknown:
        return dict(given)
    rows_by, columns_by = (factors[0] for factors in equilibration(left[None]))  # coefficients of very different sizes
    scaled = left * rows_by[:, None] * columns_by[None, :]
    solution = columns_by * np.linalg.lstsq(scaled, rows_by * right, rcond=None)[0]
    return {**dict(zip(unknown, solution, strict=True)), **given}


def _by_derivatives(numbers: _Numbers, found: Mapping[str, Array], random: Random) -> Iterator[tuple[str, str, float]]:
    """A and C with the inputs at rest, B and D in the state of rest."""
    question, states = numbers.question, states_of(numbers.question)
    inputs = [(name, 0) for name in question.inputs]
    rest = {(name, k): 0.0 for name in question.inputs for k in range(numbers.order + 2)}
    for of, given in (("AC", states), ("BD", inputs)):
        values = np.array([random.uniform(0.5, 2.0) for _ in given], dtype=complex)
        at = {**rest, **dict.fromkeys(states, 0.0), **dict(zip(given, values, strict=True))}
        jets = _solved(numbers, at)
        moved = np.array([jets.get((name, k + 1), np.nan) for name, k in states], dtype=complex)
        outputs = [
            sum(c * jets.get(jet, np.nan) for jet, c in row.items()) for row in numbers.coefficients(question.outputs)
        ]
        for name, wanted in zip(of, (moved, np.array(outputs, dtype=complex)), strict=True):
            M = found.get(name)
            if M is not None:
                fits = M.shape == (len(wanted), len(values))
                yield name, SAYS[name], _distance(M @ values, wanted) if fits else np.inf


def _distance(found: Array, wanted: Array) -> float:
    size = max(1.0, float(np.max(np.abs(wanted), initial=0.0)))
    distance = float(np.max(np.abs(found - wanted), initial=0.0)) / size
    return distance if np.isfinite(distance) else np.inf


def _by_transforms(numbers: _Numbers, found: Mapping[str, Array], random: Random) -> Iterator[tuple[str, str, float]]:
    """det(sI − A) up to a constant, and with all matrices the transfer function, at random s."""
    question = numbers.question
    s, other = (complex(random.uniform(0.5, 2.0), random.uniform(0.5, 2.0)) for _ in range(2))
    A, label = found.get("A"), "the characteristic polynomial of the equations"
    if A is None:
        return
    if A.shape[0] != A.shape[1]:
        yield "A", label, np.inf
        return
    unit = np.eye(len(A))
    P, wanted = _polynomials(numbers, question.unknowns), np.linalg.det(s * unit - A) / np.linalg.det(other * unit - A)
    ratio = np.linalg.det(P(s)) / np.linalg.det(P(other))
    yield "A", label, _distance(np.array([wanted]), np.array([ratio]))
    if not {"B", "C"} <= set(found):
        return
    B, C = found["B"], found["C"]
    D = found.get("D", np.zeros((len(C), B.shape[1])))
    Q = _polynomials(numbers, question.inputs)
    unknowns = np.linalg.solve(P(s), -Q(s))
    outputs = numbers.coefficients(question.outputs)
    of_unknowns, of_inputs = (
        np.array([[sum(c * s**k for (n, k), c in row.items() if n == name) for name in names] for row in outputs])
        for names in (question.unknowns, question.inputs)
    )
    transfer = of_unknowns @ unknowns + of_inputs
    own = C @ np.linalg.solve(s * unit - A, B) + D
    for name in ("B", "C", "D"):
        if name in found:
            yield name, "the transfer function of the equations at random points", _distance(own, transfer)


def _polynomials(numbers: _Numbers, names: Sequence[str]) -> Any:
    """The equations' coefficients of some functions as polynomials in s."""
    rows = []
    for row in numbers.coefficients(numbers.question.equations):
        delay = min((k for _, k in row), default=0)  # the equation some samples later
        rows.append({(name, k - min(delay, 0)): c for (name, k), c in row.items()})
    return lambda s: np.array(
        [[sum(c * s**k for (n, k), c in row.items() if n == name) for name in names] for row in rows], dtype=complex
    )


def eliminated_residual(equations: Sequence[Any], jets: Mapping[Any, Jet], symbol: Any, value: Any) -> float:
    """Return how far the equations are from holding with the unknown at that value; inf if any value would do."""
    names = tuple(dict.fromkeys(name for name, _ in jets.values()))
    own = {s: (str(s), 0) for s in sorted(free_symbols([value]), key=str) if s not in jets and str(s) in names}
    question = Question(equations, [], {**jets, **own}, names, (), ())
    random, worst = Random(SEED), 0.0  # noqa: S311 - nothing secret
    for point in _points(question):
        numbers = _Numbers(question, point)
        given = {s: random.uniform(0.5, 2.0) for s in sorted(free_symbols([value]), key=str) if s in question.jets}
        at = {question.jets[s]: complex(v) for s, v in given.items()}
        target = _value(value, {**numbers.point, **given})
        held, moved = (_misfit(numbers, {**at, jets[symbol]: target + by}) for by in (0.0, 1.0))
        worst = max(worst, held if moved > 1e-6 else np.inf)
    return worst


def _misfit(numbers: _Numbers, given: Mapping[Jet, complex]) -> float:
    """How far the equations are from holding, whatever the other jets are."""
    jets = _solved(numbers, given)
    rows = [row for by in range(numbers.order) for row in numbers.coefficients(numbers.question.equations, by)]
    return max(abs(sum(c * jets[jet] for jet, c in row.items())) for row in rows)
