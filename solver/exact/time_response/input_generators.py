"""Inputs as the outputs of systems without input: u = C w, w' = A w (w(k+1) = A w(k)), w(0) = w₀.

Sums of terms of `signals` are such outputs; a step or impulse that comes later begins a piece of its own.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import factorial
from typing import Any

import sympy as sp
from sympy.functions.combinatorial.numbers import stirling

from solver.exact.functions.rational import between
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.time_response.signals import Signal, delayed, read_signal, written

LATEST_SAMPLE = 40
"""The latest sample at which something may begin in discrete time."""


@dataclass(frozen=True)
class Generator:
    """The system w' = A w, u = C w (w(k+1) = A w(k)) with w(0) = w0 that makes an input."""

    A: sp.ImmutableMatrix
    C: sp.ImmutableMatrix
    w0: sp.ImmutableMatrix


@dataclass(frozen=True)
class Piece:
    """What begins in the inputs at one time: `inputs` (m×1) in the time since, and `impulses` (m×1) at its start.

    In discrete time impulses are part of the inputs and of their generator.
    """

    delay: sp.Expr
    inputs: sp.ImmutableMatrix
    impulses: sp.ImmutableMatrix
    generator: Generator | None

    def __bool__(self) -> bool:
        """Whether anything begins."""
        return any(self.inputs.flat()) or any(self.impulses.flat())

    def image(self, x: sp.Symbol, *, discrete: bool) -> sp.ImmutableMatrix:
        """The transform (m×1) of the inputs, from the start of the piece."""
        if self.generator is None:
            return self.impulses
        made = between(self.generator.C, self.generator.A, self.generator.w0).expression(x)
        return sp.ImmutableMatrix(made * (x if discrete else 1) + self.impulses)


def later(u: sp.Expr, t: sp.Symbol, delay: sp.Expr) -> sp.Expr:
    """The input that comes a delay T later, u(t − T), zero before it; steps and impulses bring their own beginning."""
    if delay == 0:
        return u
    found = sp.S.Zero
    for term in sp.Add.make_args(sp.expand(u)):
        steps: list[Any] = [each.args[0] for each in term.atoms(sp.Heaviside)]
        begins = any(x.coeff(t) == 1 and x.xreplace({t: sp.S.Zero}).is_nonpositive for x in steps)
        started = begins or term.has(sp.DiracDelta)
        found += term.xreplace({t: t - delay}) * (sp.S.One if started else sp.Heaviside(t - delay))
    return found


def read_inputs(inputs: Sequence[sp.Expr], time: sp.Symbol, *, discrete: bool) -> tuple[Piece, ...]:
    """The pieces of the inputs, the first one at time zero; raises NotExact for inputs of another kind."""
    signals = [read_signal(u, time, discrete=discrete) for u in inputs]
    if not discrete:
        return tuple(_piece(signals, delay, time) for delay in delayed(signals))
    starts = _starts(signals)
    ends = [*starts[1:], sp.oo]
    return tuple(_samples(signals, start, end, time) for start, end in zip(starts, ends, strict=True))


def _piece(signals: Sequence[Signal], delay: sp.Expr, t: sp.Symbol) -> Piece:
    """What begins in the signals at one time of continuous time."""
    local = [_begun(signal, delay, t, discrete=False) for signal in signals]
    inputs = sp.ImmutableMatrix([_expression(signal, t, discrete=False) for signal in local])
    impulses = sp.ImmutableMatrix([signal.impulses.get(delay, sp.S.Zero) for signal in signals])
    return Piece(delay, inputs, impulses, _generator(local, discrete=False))


def _starts(signals: Sequence[Signal]) -> list[sp.Expr]:
    """The samples at which pieces begin, ascending: a pulse just behind another one goes on with that."""
    begun = {delay for signal in signals for delay, _ in signal.terms}
    pulses = {at for signal in signals for at in signal.impulses}
    found = sorted(at for at in delayed(signals) if at == 0 or at in begun or at - 1 not in pulses)
    if max(found) > LATEST_SAMPLE:
        raise NotExact("signals/late_sample", latest=LATEST_SAMPLE)
    return found


def _samples(signals: Sequence[Signal], start: sp.Expr, end: sp.Expr, k: sp.Symbol) -> Piece:
    """What begins in the signals at a sample, with the pulses from there on before the next piece."""
    local = [
        Signal(
            _begun(signal, start, k, discrete=True).terms,
            {at - start: weight for at, weight in signal.impulses.items() if start <= at < end},
        )
        for signal in signals
    ]
    inputs = sp.ImmutableMatrix([_expression(signal, k, discrete=True) for signal in local])
    none = sp.ImmutableMatrix(sp.zeros(len(signals), 1))
    return Piece(start, inputs, none, _generator(local, discrete=True))


def _begun(signal: Signal, delay: sp.Expr, x: sp.Symbol, *, discrete: bool) -> Signal:
    """The terms that begin at a delay, in the time since."""
    here = [c * written(term, x, discrete=discrete) for (begin, term), c in signal.terms.items() if begin == delay]
    begun = read_signal(sp.Add(*here).subs(x, x + delay), x, discrete=discrete)
    if not delay.free_symbols:
        return begun
    terms = {term: _one_square(c) for term, c in begun.terms.items()}
    return Signal({term: c for term, c in terms.items() if c != 0}, begun.impulses)


def _one_square(c: sp.Expr) -> sp.Expr:
    """An expression in which sin² is 1 − cos²: what a shift brings in and another takes away is gone."""
    squares = [each for each in c.atoms(sp.Pow) if each.base.func is sp.sin and each.exp == 2]
    return sp.expand(c.xreplace({each: 1 - sp.cos(*each.base.args) ** 2 for each in squares}))


def _expression(signal: Signal, x: sp.Symbol, *, discrete: bool) -> sp.Expr:
    total = sum((c * written(term, x, discrete=discrete) for (_, term), c in signal.terms.items()), sp.S.Zero)
    pulses = signal.impulses.items() if discrete else ()
    return sp.Add(total, *(weight * sp.KroneckerDelta(x, at) for at, weight in pulses))


def _generator(signals: Sequence[Signal], *, discrete: bool) -> Generator | None:
    """The blocks of all terms of all inputs; None where there is no term."""
    blocks: list[sp.Matrix] = []
    starts: list[list[sp.Expr]] = []
    owners: list[int] = []
    for i, signal in enumerate(signals):
        for A, w in [*_blocks(signal, discrete=discrete), *(_pulses(signal) if discrete else ())]:
            blocks.append(A)
            starts.append(w)
            owners.append(i)
    if not blocks:
        return None
    q = sum(len(w) for w in starts)
    selection = sp.zeros(len(signals), q)
    column = 0
    for i, w in zip(owners, starts, strict=True):
        selection[i, column] = 1
        column += len(w)
    M = sp.ImmutableMatrix(sp.diag(*blocks))
    return Generator(M, sp.ImmutableMatrix(selection), sp.ImmutableMatrix([entry for w in starts for entry in w]))


def _pulses(signal: Signal) -> Iterable[tuple[sp.Matrix, list[sp.Expr]]]:
    """A chain of delays: u(k) is its entry k."""
    if signal.impulses:
        size = int(max(signal.impulses)) + 1
        chain = sp.Matrix(size, size, lambda i, j: int(j == i + 1))
        yield chain, [signal.impulses.get(sp.Integer(i), sp.S.Zero) for i in range(size)]


def _blocks(signal: Signal, *, discrete: bool) -> Iterable[tuple[sp.Matrix, list[sp.Expr]]]:
    """For each exponential and angle, a Jordan block of the highest power of time, and its initial state."""
    groups: dict[tuple[sp.Expr, sp.Expr], dict[int, list[sp.Expr]]] = {}
    for (_, (n, growth, angle, sine)), c in signal.terms.items():
        pair = groups.setdefault((growth, angle), {}).setdefault(n, [sp.S.Zero, sp.S.Zero])
        pair[int(sine)] += c
    for (growth, angle), by_power in groups.items():
        cell, scale = _cell(growth, angle, discrete=discrete)
        vectors = {n: sp.Matrix([c, s * scale][: cell.rows]) for n, (c, s) in by_power.items()}
        size = max(by_power) + 1
        block = sp.zeros(size * cell.rows)
        for j in range(size):
            at = j * cell.rows
            block[at : at + cell.rows, at : at + cell.rows] = cell
            if j:
                block[at - cell.rows : at, at : at + cell.rows] = sp.eye(cell.rows)
        start = [_coefficient(j, cell, vectors, discrete=discrete) for j in range(size)]
        yield block, [sp.expand(entry) for vector in start for entry in vector.flat()]


def _cell(growth: sp.Expr, angle: sp.Expr, *, discrete: bool) -> tuple[sp.Matrix, sp.Expr]:
    """The block [σ] or [[σ, 1], [−ω², σ]] with the eigenvalues σ ± jω, and ω."""
    if angle == 0:
        return sp.Matrix([[growth]]), sp.S.One
    sigma, omega = (growth * sp.cos(angle), growth * sp.sin(angle)) if discrete else (growth, angle)
    return sp.Matrix([[sigma, 1], [-(omega**2), sigma]]), omega


def _coefficient(j: int, cell: sp.Matrix, vectors: Mapping[int, sp.Matrix], *, discrete: bool) -> sp.Matrix:
    """The initial state of the j-th cell of a chain, which contributes tʲ/j! e^{Rt} (C(k, j) R^{k−j}) times it."""
    total = sp.zeros(cell.rows, 1)
    for n, vector in vectors.items():
        if not discrete:
            total += factorial(j) * vector if n == j else sp.zeros(cell.rows, 1)
        else:  # kⁿ = Σ_j S(n, j) j! C(k, j)
            total += stirling(n, j) * factorial(j) * cell**j * vector
    return total
