"""Responses x(t), y(t) of linear systems in closed form, to inputs that are sums of terms of `signals`.

Such an input is the output of a system without input, u = C_u w, w' = A_u w, so x is a part of e^{Mt} for the matrix
M = [[A, B C_u], [0, A_u]]: resonance, repeated roots and several inputs are no special cases. A step that comes later
starts a piece of its own, which is shifted in time.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import sympy as sp

from solver.exact.functions.rational import RationalMatrix, between
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.time_response.input_generators import Piece, read_inputs
from solver.exact.time_response.long_run import limit
from solver.exact.time_response.peaks import Peak, peak
from solver.exact.time_response.signals import read_signal
from solver.systems import StateSpace


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


def weighting(system: StateSpace) -> RationalMatrix:
    """The transform C (sI − A)⁻¹ B of the response to impulses from rest (p×m), without D."""
    C, A, B = (sp.ImmutableMatrix(M) for M in (system.C, system.A, system.B))
    return between(C, A, B)


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
            late, discrete = sp.zeros(*images[0][1].shape), self.system.discrete
            for delay, image in images:
                late += image.function(self.time, discrete=discrete).matrix.xreplace({self.time: self.time - delay})
            limits = [limit_of_sum(entry, self.time, discrete=discrete) for entry in late.flat()]
            return sp.ImmutableMatrix(limits) if all(each is not None for each in limits) else None
        return limit(images[0][1], discrete=self.system.discrete) if images else None

    @cached_property
    def y_peak(self) -> Peak | None:
        """The peak of a single output; None where its size is largest at the start or in the limit."""
        (delay, first), discrete = self.pieces[0], self.system.discrete
        if first.y is None or self.y is None or len(self.y) > 1 or len(self.pieces) > 1 or self.impulse is not None:
            return None
        found = peak(first.y, first.y.function(self.time, discrete=discrete).matrix[0], self.time, discrete=discrete)
        return found and replace(found, time=found.time + delay, delay=delay)

    def _put_together(self, images: Sequence[tuple[sp.Expr, RationalMatrix]]) -> sp.ImmutableMatrix:
        total = sp.zeros(*images[0][1].shape)
        for delay, image in images:
            f = image.function(self.time, discrete=self.system.discrete).matrix
            total += shifted(f, self.time, delay, discrete=self.system.discrete)
        return sp.ImmutableMatrix(total)


def limit_of_sum(late: sp.Expr, t: sp.Symbol, *, discrete: bool = False) -> sp.Expr | None:
    """The limit of what is left of the pieces after the last one has begun, where modes may cancel; None if unknown."""
    try:
        smooth = late.xreplace(dict.fromkeys(late.atoms(sp.KroneckerDelta), sp.S.Zero))
        signal = read_signal(smooth, t, discrete=discrete)
    except NotExact:
        return None
    constant = sp.S.Zero
    for (_, (n, growth, angle, _)), c in signal.terms.items():
        rate = sp.Abs(growth) - 1 if discrete else growth
        if rate.is_negative:
            continue
        if n or growth != int(discrete) or angle != 0:
            return None
        constant += c
    return constant


def shifted(f: sp.MatrixBase, t: sp.Symbol, delay: sp.Expr, *, discrete: bool = False) -> sp.ImmutableMatrix:
    """f(t − T) step(t − T); a unit pulse of discrete time needs no step."""
    if delay == 0:
        return sp.ImmutableMatrix(f)
    step = sp.Heaviside(t - delay, 1) if discrete else sp.Heaviside(t - delay)

    def begun(entry: sp.Expr) -> sp.Expr:
        pulses, others = sp.sift(sp.Add.make_args(entry), lambda term: term.has(sp.KroneckerDelta), binary=True)
        return sp.Add(sp.Add(*others) * step, *pulses)

    return sp.ImmutableMatrix(_later(f, t, delay).applyfunc(begun))


def _later(f: sp.MatrixBase, t: sp.Symbol, delay: sp.Expr) -> sp.MatrixBase:
    """f(t − T), with cos(πt/4 − 5π/4) multiplied out and δ(k − 5) for δ(k − 3 − 2)."""
    pulses = {each: sp.Dummy() for each in f.atoms(sp.KroneckerDelta)}
    back = {
        dummy: sp.KroneckerDelta(*(a + (0 if a == t else delay) for a in each.args)) for each, dummy in pulses.items()
    }
    later = f.xreplace(pulses).xreplace({t: t - delay}).xreplace(back)
    waves = [each for each in later.atoms(sp.sin, sp.cos) if each.args[0].has(sp.pi)]
    return later.xreplace({each: each.func(sp.expand(each.args[0])) for each in waves})


def response(system: StateSpace, x0: sp.MatrixBase | None, inputs: Sequence[sp.Expr], time: sp.Symbol) -> ClosedForm:
    """The response to an initial state (None: zero) and inputs in the symbol `time` (empty: none); raises NotExact."""
    pieces = read_inputs(inputs, time, discrete=system.discrete) if inputs else ()
    if not pieces:
        return ClosedForm(system, ((sp.S.Zero, piece_response(system, x0, None)),), None, time)
    moving = [piece for piece in pieces if piece or (x0 is not None and piece.delay == 0)] or pieces[:1]
    found = [(piece.delay, piece_response(system, x0 if piece.delay == 0 else None, piece)) for piece in moving]
    return ClosedForm(system, tuple(found), passed_on(system, pieces, time), time)


def passed_on(system: StateSpace, pieces: Sequence[Piece], t: sp.Symbol) -> sp.ImmutableMatrix | None:
    """The impulses in y, D times those of the inputs; None if there are none."""
    if system.D is None or system.discrete:
        return None
    total = sp.zeros(system.D.rows, 1)
    for piece in pieces:
        total += system.D * piece.impulses * sp.DiracDelta(t - piece.delay)
    return sp.ImmutableMatrix(total) if any(total) else None
