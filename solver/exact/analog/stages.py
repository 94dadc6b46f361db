"""What stages of ideal operational amplifiers make of their inputs: sums of multiples, derivatives and integrals.

With a virtual ground each input of an inverting stage adds −(Z_f/Z) V, where Z is R or 1/(s C), so that every input
reaches every output by a sum of terms c sᵏ (L. O. Chua, C. A. Desoer, E. S. Kuh, Linear and Nonlinear Circuits, 4).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import sympy as sp

if TYPE_CHECKING:
    from sympy import Expr, Symbol

Powers = Mapping[int, Any]
"""Coefficients by the power of s."""
NOTHING: Mapping[str, Any] = MappingProxyType({})


class ImpulseAtStartError(Exception):
    """A capacitor would meet a jump of a stage's output at t = 0."""


@dataclass(frozen=True)
class StageResponse:
    """An output: Σ c sᵏ of each signal, and of what is `held` (in time k < 0); `start` is its value before t = 0."""

    terms: Mapping[str, Powers]
    held: Powers = field(default_factory=dict)
    start: Any = sp.S.Zero

    def transform(self, symbols: Mapping[str, Symbol]) -> Expr:
        """Return the Laplace transform, by the transforms of the signals."""
        s = sp.Symbol("s")
        parts = [c * s**k * symbols[name] for name, powers in self.terms.items() for k, c in powers.items()]
        found: Expr = sp.Add(*parts, *(c * s**k for k, c in self.held.items()))
        return found

    def in_time(self, symbols: Mapping[str, Symbol]) -> Expr:
        """Return it in time: a signal that is differentiated or integrated as v(t), else as v."""
        t, taken = sp.Symbol("t"), {str(x) for x in self._letters()} | {str(x) for x in symbols.values()}
        parts = []
        for name, powers in self.terms.items():
            varied = any(k != 0 for k in powers)
            for k, c in powers.items():
                parts.append(c * (of_time(symbols[name], k, taken) if varied else symbols[name]))
        rest = (c * t ** (-k - 1) / sp.factorial(-k - 1) for k, c in self.held.items() if k < 0)
        found: Expr = sp.Add(*parts, *rest)
        return found

    def _letters(self) -> set[Any]:
        values = [c for powers in (*self.terms.values(), self.held) for c in powers.values()]
        return set().union(*(getattr(c, "free_symbols", ()) for c in values))


def of_time(symbol: Symbol, power: int, taken: Iterable[str] = ()) -> Expr:
    """Return v(t), its derivative (power > 0) or its integral from 0 on (power < 0), over a name that is not taken."""
    t, function = sp.Symbol("t"), sp.Function(symbol.name)
    if power >= 0:
        derived: Expr = sp.Derivative(function(t), (t, power)) if power else function(t)
        return derived
    letter = next(each for each in ("tau", "sigma", "eta", "xi", "tau_o") if each not in set(taken))
    over = [sp.Symbol(letter if i == 0 else f"{letter}_{i}") for i in range(-power)]
    limits = [(x, 0, end) for x, end in zip(over, [*over[1:], t], strict=True)]
    integrated: Expr = sp.Integral(function(over[0]), *limits)
    return integrated


def stage_gains(stage: Any) -> tuple[tuple[Any, int], ...]:
    """Return for each input of a stage c and k of Z_f/Z = c sᵏ."""
    found = []
    for _, part in stage.inputs:
        above = stage.feedback.value if stage.feedback.letter == "R" else 1 / stage.feedback.value
        below = part.value if part.letter == "R" else 1 / part.value
        found.append((above / below, (part.letter == "C") - (stage.feedback.letter == "C")))
    return tuple(found)


def stage_response(
    stage: Any, signals: Mapping[str, StageResponse], starts: Mapping[str, Any] = NOTHING
) -> StageResponse:
    """Return the output of a stage by what its inputs are made of; a signal that is not among these is by itself.

    Capacitors that lead to the minus input are charged to what their signal is before t = 0: what `starts` has for one
    by itself, else zero. Raises ImpulseAtStartError where such a signal is known to jump.
    """
    terms: dict[str, dict[int, Any]] = {}
    held: dict[int, Any] = {}
    start = stage.initial if stage.feedback.letter == "C" else sp.S.Zero
    for (name, part), (gain, shift) in zip(stage.inputs, stage_gains(stage), strict=True):
        signal = signals.get(name, StageResponse({name: {0: sp.S.One}}, start=starts.get(name, sp.S.Zero)))
        for source, powers in signal.terms.items():
            _add(terms.setdefault(source, {}), powers, -gain, shift)
        rest = dict(signal.held)
        if part.letter == "C":  # what passes is the change since t = 0
            rest[-1] = sp.cancel(rest.get(-1, sp.S.Zero) - signal.start)
            if rest[-1] != 0 and stage.feedback.letter == "R" and name in signals:
                raise ImpulseAtStartError
        elif stage.feedback.letter == "R":
            start -= gain * signal.start
        _add(held, {k: c for k, c in rest.items() if c != 0}, -gain, shift)
    _add(held, {-1: stage.initial}, 1, 0)
    kept = {name: {k: c for k, c in powers.items() if c != 0} for name, powers in terms.items()}
    return StageResponse({name: powers for name, powers in kept.items() if powers},
                    {k: c for k, c in held.items() if c != 0}, start)  # fmt: skip


def _add(into: dict[int, Any], powers: Powers, factor: Any, shift: int) -> None:
    for k, c in powers.items():
        into[k + shift] = sp.cancel(into.get(k + shift, sp.S.Zero) + factor * c)


def cascade_responses(stages: Iterable[Any]) -> tuple[StageResponse, ...]:
    """Return the outputs of all stages by the given signals. Raises ImpulseAtStartError."""
    found: dict[str, StageResponse] = {}
    for stage in stages:
        found[stage.output] = stage_response(stage, found)
    return tuple(found.values())
