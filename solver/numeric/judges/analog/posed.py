"""The question in numbers: linear equations as x' = A x + B w with what is read out, and the signals w over time.

Jets are the derivatives of the unknowns and of the inputs; the equations are linear in them, with a constant term.
The coefficients are differences of the equations' values, and jets that are no states follow by least squares.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array, equilibration
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.points import free_symbols
from solver.numeric.judges.analog.simulation import Grid, Signal
from solver.numeric.judges.modelling.equations import Jet, Question, states_of

TIME = sp.Symbol("t")
TRIED = (
    (sp.Rational(7, 10), sp.Rational(2, 7)),
    (sp.Rational(13, 10), sp.Rational(5, 11)),
    (sp.Rational(17, 10), sp.Rational(3, 13)),
)
"""Frequencies and amplitudes of the signals that stand for inputs without a function of their own."""

NOTHING = 1e-11
"""What least squares leave of a coefficient that is zero."""


@dataclass(frozen=True, eq=False)
class Asked:
    """What a program is to compute: the equations, the initial values of jets (else 0), each input as a function of t.

    An input that is no function (None) may be any. `readouts` are expressions in the jets by the names under which a
    program may read them out, `required` those that it must. `maxima` are the given ones of the same names.
    """

    question: Question
    initial: Mapping[Jet, Any]
    inputs: Mapping[str, Any]
    readouts: Mapping[str, Any]
    required: Sequence[str]
    time_scale: Any
    reference: Any
    maxima: Mapping[str, Any]

    @cached_property
    def posed(self) -> Posed:
        """The question in numbers; it is followed over time once."""
        return Posed(self)


@dataclass(frozen=True)
class Posed:
    """x' = A x + B w from `start`; `rows` are the readouts over (x, w), `signals` w: inputs with derivatives, and 1."""

    asked: Asked

    @cached_property
    def states(self) -> list[Jet]:
        """The states in their order."""
        return states_of(self.asked.question)

    @cached_property
    def _driving(self) -> list[Jet]:
        """The inputs with the derivatives of them that may take part; behind them stands a constant 1."""
        highest = self._order + max((k for _, k in self.asked.question.jets.values()), default=0)
        return [(name, k) for name in self.asked.question.inputs for k in range(highest + 1)]

    @cached_property
    def _order(self) -> int:
        return max((k for _, k in self.asked.question.jets.values()), default=0) + 1

    def _coefficients(self, expression: Any) -> tuple[dict[Jet, float], float]:
        """The coefficient of each jet in an expression, and its constant term."""
        jets = self.asked.question.jets
        zero = dict.fromkeys(jets, 0.0)
        constant = complex(evaluate(expression, zero)).real
        inside = [symbol for symbol in jets if symbol in free_symbols([expression])]
        found = {jets[s]: complex(evaluate(expression, {**zero, s: 1.0})).real - constant for s in inside}
        return found, constant

    @cached_property
    def _jets(self) -> dict[Jet, Array]:
        """Each jet as a row over the states, the driving jets and 1."""
        given = [*self.states, *self._driving]
        rows = []
        for expression in self.asked.question.equations:
            own, constant = self._coefficients(expression)
            for by in range(self._order):
                rows.append(({(name, k + by): c for (name, k), c in own.items()}, constant if by == 0 else 0.0))
        unknown = sorted({jet for row, _ in rows for jet in row} - set(given))
        left = np.array([[row.get(jet, 0.0) for jet in unknown] for row, _ in rows]).reshape(len(rows), len(unknown))
        right = -np.array([[*(row.get(jet, 0.0) for jet in given), constant] for row, constant in rows])
        known = dict(zip(given, np.eye(len(given) + 1), strict=False))
        if not unknown:
            return known
        by_rows, by_columns = (factors[0] for factors in equilibration(left[None]))
        solved = np.linalg.lstsq(left * by_rows[:, None] * by_columns, by_rows[:, None] * right, rcond=None)[0]
        return known | dict(zip(unknown, by_columns[:, None] * solved, strict=True))

    def _row(self, expression: Any) -> Array:
        """An expression in the jets as a row over the states, the driving jets and 1."""
        own, constant = self._coefficients(expression)
        found = sum(
            (c * self._jets[jet] for jet, c in own.items()), np.zeros(len(self.states) + len(self._driving) + 1)
        )
        found[-1] += constant
        return np.asarray(found)

    @cached_property
    def matrix(self) -> Array:
        """A and B beside each other."""
        width = len(self.states) + len(self._driving) + 1
        return np.array([self._jets[name, k + 1] for name, k in self.states]).reshape(len(self.states), width)

    @cached_property
    def A(self) -> Array:
        """The matrix of the states, n×n."""
        return self.matrix[:, : len(self.states)]

    @cached_property
    def B(self) -> Array:
        """The matrix of the driving jets and of 1."""
        return self.matrix[:, len(self.states) :]

    @cached_property
    def start(self) -> Array:
        """The initial values of the states."""
        return np.array([complex(evaluate(self.asked.initial.get(jet, sp.S.Zero), {})).real for jet in self.states])

    @cached_property
    def rows(self) -> dict[str, Array]:
        """The readouts as rows over the states, the driving jets and 1."""
        return {name: self._row(expression) for name, expression in self.asked.readouts.items()}

    @cached_property
    def functions(self) -> dict[str, Any]:
        """Each input as a function of t: its own, or one to try."""
        found = {}
        for i, (name, own) in enumerate(self.asked.inputs.items()):
            tried = sum(a * sp.sin(w * (1 + i) * TIME + w + i) for w, a in TRIED)
            found[name] = tried if own is None else own
        return found

    @cached_property
    def signals(self) -> list[Signal]:
        """The driving jets as functions of t, and 1; a jet that nothing depends on is left at zero."""
        taken = np.vstack([self.matrix, *self.rows.values()])[:, len(self.states) : -1]
        functions = [
            sp.diff(self.functions[name], TIME, k) if np.any(np.abs(column) > NOTHING) else sp.S.Zero
            for (name, k), column in zip(self._driving, taken.T, strict=True)
        ]
        return [*(Signal(each, TIME) for each in functions), Signal(sp.S.One)]

    @cached_property
    def grid(self) -> Grid:
        """The times, in t, over which it is followed."""
        changes = [rate for name in self.functions for rate in Signal(self.functions[name], TIME).rates]
        return Grid([complex(each) for each in np.linalg.eigvals(self.A)] if self.states else [], changes)

    def drive(self, times: Array) -> Array:
        """The driving jets and 1 at an array of times, in a last axis."""
        return np.stack([each.at(times.reshape(-1)).reshape(times.shape) for each in self.signals], axis=-1)

    @cached_property
    def motion(self) -> Array:
        """The states, the driving jets and 1 at the times of the grid."""
        states = self.grid.states(self.A, self.B, self.start, self.drive)
        return np.hstack([states, self.drive(self.grid.times)])
