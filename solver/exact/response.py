"""Responses x(t), y(t) of linear systems in closed form, to inputs that are sums of terms of `signals`.

Such an input is the output of a system without input, u = C_u w, w' = A_u w, so x is a part of e^{Mt} for the matrix
M = [[A, B C_u], [0, A_u]]: resonance, repeated roots and several inputs are no special cases. A step that comes later
starts a piece of its own, which is shifted in time.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import factorial

import sympy as sp
from sympy.functions.combinatorial.numbers import stirling

from solver.exact.fields import NotExact
from solver.exact.long_run import Peak, limit, peak
from solver.exact.rational import RationalMatrix, between
from solver.exact.signals import Signal, Term, delayed, read_signal, written
from solver.systems import StateSpace

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

    In discrete time there is one piece, beginning at 0, and impulses are part of its generator.
    """

    delay: sp.Expr
    inputs: sp.ImmutableMatrix
    impulses: sp.ImmutableMatrix
    generator: Generator | None

    def image(self, x: sp.Symbol, *, discrete: bool) -> sp.ImmutableMatrix:
        """The transform (m×1) of the inputs, from the start of the piece."""
        if self.generator is None:
            return self.impulses
        made = between(self.generator.C, self.generator.A, self.generator.w0).expression(x)
        return sp.ImmutableMatrix(made * (x if discrete else 1) + self.impulses)


def read_inputs(inputs: Sequence[sp.Expr], time: sp.Symbol, *, discrete: bool) -> tuple[Piece, ...]:
    """The pieces of the inputs, the first one at time zero; raises NotExact for inputs of another kind."""
    signals = [read_signal(u, time, discrete=discrete) for u in inputs]
    if discrete:
        signals = [_from_the_start(signal, time) for signal in signals]
        written_out = sp.ImmutableMatrix([_expression(signal, time, discrete=True) for signal in signals])
        none = sp.ImmutableMatrix(sp.zeros(len(signals), 1))
        return (Piece(sp.S.Zero, written_out, none, _generator(signals, discrete=True)),)
    return tuple(_piece(signals, delay, time) for delay in delayed(signals))


def _piece(signals: Sequence[Signal], delay: sp.Expr, t: sp.Symbol) -> Piece:
    """What begins in the signals at one time of continuous time."""
    local: list[Signal] = []
    for signal in signals:
        here = sum(
            (c * written(term, t, discrete=False) for (d, term), c in signal.terms.items() if d == delay), sp.S.Zero
        )
        local.append(read_signal(here.subs(t, t + delay), t, discrete=False))
    inputs = sp.ImmutableMatrix([_expression(signal, t, discrete=False) for signal in local])
    impulses = sp.ImmutableMatrix([signal.impulses.get(delay, sp.S.Zero) for signal in signals])
    return Piece(delay, inputs, impulses, _generator(local, discrete=False))


def _from_the_start(signal: Signal, k: sp.Symbol) -> Signal:
    """Return f(k) step(k − m) as f(k) less its first m values."""
    latest = max([*signal.delays, sp.S.Zero])
    if latest > LATEST_SAMPLE:
        raise NotExact(f"Steps and impulses later than sample {LATEST_SAMPLE} are not taken.")
    terms: dict[tuple[sp.Expr, Term], sp.Expr] = {}
    pulses = dict(signal.impulses)
    for (delay, term), c in signal.terms.items():
        terms[sp.S.Zero, term] = terms.get((sp.S.Zero, term), sp.S.Zero) + c
        for i in map(sp.Integer, range(int(delay))):
            pulses[i] = pulses.get(i, sp.S.Zero) - c * written(term, k, discrete=True).subs(k, i)
    return Signal(
        {key: c for key, c in terms.items() if sp.expand(c) != 0},
        {at: weight for at, weight in pulses.items() if sp.expand(weight) != 0},
    )


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


@dataclass(frozen=True)
class Response:
    """Transforms of x and y for one piece (in discrete time divided by z); `y` is None where the system has no C."""

    x: RationalMatrix
    y: RationalMatrix | None


def piece_response(system: StateSpace, x0: sp.MatrixBase | None, piece: Piece | None) -> Response:
    """The response to an initial state (None: zero) and to one piece of the inputs (None: no input).

    An impulse in y itself (D ≠ 0) is left out: it is no function of time.
    """
    n, A = system.order, system.A
    start = sp.Matrix(x0) if x0 is not None else sp.zeros(n, 1)
    if piece is not None and system.B is not None:
        start += system.B * piece.impulses
    generator = piece.generator if piece is not None and system.B is not None else None
    left, C = sp.eye(n), system.C
    out = C if C is not None else None
    if generator is not None and system.B is not None:
        q = generator.A.rows
        A = sp.ImmutableMatrix(
            sp.Matrix.vstack(
                sp.Matrix.hstack(sp.Matrix(system.A), system.B * generator.C),
                sp.Matrix.hstack(sp.zeros(q, n), sp.Matrix(generator.A)),
            )
        )
        start = start.col_join(generator.w0)
        left = left.row_join(sp.zeros(n, q))
        if C is not None:
            D = system.D if system.D is not None else sp.zeros(C.rows, system.B.cols)
            out = sp.Matrix(C).row_join(D * generator.C)
    right = sp.ImmutableMatrix(start)
    x = between(sp.ImmutableMatrix(left), A, right)
    return Response(x, between(sp.ImmutableMatrix(out), A, right) if out is not None else None)


@dataclass(frozen=True)
class ClosedForm:
    """A response: x (n×1) and y (p×1, or None) as functions of time, t ≥ 0 or k = 0, 1, …; and its pieces in order."""

    system: StateSpace
    pieces: tuple[tuple[sp.Expr, Response], ...]
    impulse: sp.ImmutableMatrix | None
    time: sp.Symbol

    @cached_property
    def x(self) -> sp.ImmutableMatrix:
        """The states."""
        return self._put_together([(delay, each.x) for delay, each in self.pieces])

    @cached_property
    def y(self) -> sp.ImmutableMatrix | None:
        """The outputs, with what impulses an input passes on through D."""
        images = [(delay, each.y) for delay, each in self.pieces if each.y is not None]
        if not images:
            return None
        y = self._put_together(images)
        return sp.ImmutableMatrix(y + self.impulse) if self.impulse is not None else y

    @cached_property
    def y_final(self) -> sp.ImmutableMatrix | None:
        """The limit of y; None where none is known to exist."""
        images = [(delay, each.y) for delay, each in self.pieces if each.y is not None]
        if len(images) > 1:
            late = sp.zeros(*images[0][1].shape)
            for delay, image in images:
                late += image.function(self.time, discrete=False).matrix.xreplace({self.time: self.time - delay})
            limits = [limit_of_sum(entry, self.time) for entry in late.flat()]
            return sp.ImmutableMatrix(limits) if all(each is not None for each in limits) else None
        return limit(images[0][1], discrete=self.system.discrete) if images else None

    @cached_property
    def y_peak(self) -> Peak | None:
        """The peak of a single output; None where its size is largest at the start or in the limit."""
        image = self.pieces[0][1].y
        if self.y is None or image is None or len(self.y) > 1 or len(self.pieces) > 1 or self.impulse is not None:
            return None
        return peak(image, self.y[0], self.time, discrete=self.system.discrete)

    def _put_together(self, images: Sequence[tuple[sp.Expr, RationalMatrix]]) -> sp.ImmutableMatrix:
        total = sp.zeros(*images[0][1].shape)
        for delay, image in images:
            f = image.function(self.time, discrete=self.system.discrete).matrix
            total += f if delay == 0 else shifted(f, self.time, delay)
        return sp.ImmutableMatrix(total)


def limit_of_sum(late: sp.Expr, t: sp.Symbol) -> sp.Expr | None:
    """The limit of what is left of the pieces after the last one has begun, where modes may cancel; None if unknown."""
    try:
        signal = read_signal(late, t, discrete=False)
    except NotExact:
        return None
    constant = sp.S.Zero
    for (_, (n, growth, angle, _)), c in signal.terms.items():
        if growth.is_negative:
            continue
        if n or growth != 0 or angle != 0:
            return None
        constant += c
    return constant


def shifted(f: sp.MatrixBase, t: sp.Symbol, delay: sp.Expr) -> sp.ImmutableMatrix:
    """F(t − T) step(t − T)."""
    later = f.xreplace({t: t - delay}) if delay != 0 else f
    step = sp.Heaviside(t - delay) if delay != 0 else sp.S.One
    return sp.ImmutableMatrix(later.applyfunc(lambda entry: entry * step))


def response(system: StateSpace, x0: sp.MatrixBase | None, inputs: Sequence[sp.Expr], time: sp.Symbol) -> ClosedForm:
    """The response to an initial state (None: zero) and inputs in the symbol `time` (empty: none); raises NotExact."""
    pieces = read_inputs(inputs, time, discrete=system.discrete) if inputs else ()
    if not pieces:
        return ClosedForm(system, ((sp.S.Zero, piece_response(system, x0, None)),), None, time)
    found = [(piece.delay, piece_response(system, x0 if piece.delay == 0 else None, piece)) for piece in pieces]
    return ClosedForm(system, tuple(found), passed_on(system, pieces, time), time)


def passed_on(system: StateSpace, pieces: Sequence[Piece], t: sp.Symbol) -> sp.ImmutableMatrix | None:
    """The impulses in y, D times those of the inputs; None if there are none."""
    if system.D is None or system.discrete:
        return None
    total = sp.zeros(system.D.rows, 1)
    for piece in pieces:
        total += system.D * piece.impulses * sp.DiracDelta(t - piece.delay)
    return sp.ImmutableMatrix(total) if any(total) else None
