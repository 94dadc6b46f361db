"""Inputs as sums of c xⁿ e^{σx} cos ωx and c xⁿ e^{σx} sin ωx (in discrete time rˣ for e^{σx}), steps and impulses.

Such a sum is the only kind of input whose transform is a rational function (times delays), so whatever else is given
is refused by name. x is the variable of time, t or k.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import reduce
from itertools import permutations
from typing import Any, TypeVar

import sympy as sp

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.linear_algebra.signs import is_positive, possible_signs

Term = tuple[int, sp.Expr, sp.Expr, bool]
"""Power n, growth (σ, in discrete time r), angle ω ≥ 0 where its sign is known, and whether it is a sine."""

MAX_POWER = 12

Key = TypeVar("Key")


@dataclass(frozen=True)
class Signal:
    """Σ coefficient · term · step(x − delay) + Σ weight · impulse(x − delay); delays are zero or positive."""

    terms: Mapping[tuple[sp.Expr, Term], sp.Expr] = field(default_factory=dict)
    impulses: Mapping[sp.Expr, sp.Expr] = field(default_factory=dict)

    @property
    def delays(self) -> list[sp.Expr]:
        """The times at which something begins."""
        return list(dict.fromkeys([*(delay for delay, _ in self.terms), *self.impulses]))


def read_signal(expression: sp.Expr, x: sp.Symbol, *, discrete: bool) -> Signal:
    """The expression as such a sum; raises NotExact, naming the part that is none."""
    return _Reader(x, discrete).read(expression)


def written(term: Term, x: sp.Symbol, *, discrete: bool) -> sp.Expr:
    """The function of a term."""
    n, growth, angle, sine = term
    envelope = growth**x if discrete else sp.exp(growth * x)
    wave = sp.Integer(1) if angle == 0 else sp.sin(angle * x) if sine else sp.cos(angle * x)
    return x**n * envelope * wave


@dataclass(frozen=True)
class _Reader:
    x: sp.Symbol
    discrete: bool

    @property
    def still(self) -> sp.Expr:
        """The growth of a constant."""
        return sp.Integer(1 if self.discrete else 0)

    def read(self, e: Any) -> Signal:
        if not e.has(self.x):
            return self.constant(e)
        if e == self.x:
            return Signal({(sp.S.Zero, (1, self.still, sp.S.Zero, False)): sp.S.One})
        if e.is_Add:
            return reduce(_sum, map(self.read, e.args))
        if e.is_Mul:
            return reduce(self.product, map(self.read, e.args))
        return self.factor(e)

    def factor(self, e: Any) -> Signal:
        if isinstance(e, sp.exp):
            return self.exponential(e)
        return self.power(e) if e.is_Pow else self.function(e)

    def constant(self, c: sp.Expr) -> Signal:
        if c.has(sp.I):
            raise NotExact("signals/not_real")
        return Signal({(sp.S.Zero, (0, self.still, sp.S.Zero, False)): c}) if c != 0 else Signal()

    def power(self, e: Any) -> Signal:
        base, exponent = e.args
        if exponent.is_Integer and 0 < exponent <= MAX_POWER:
            return reduce(self.product, [self.read(base)] * int(exponent))
        if base.has(self.x):
            raise self.unknown(e)
        slope, offset = self.linear(exponent)
        if self.discrete:
            return self.grown(base**slope, base**offset)
        return self.grown(slope * sp.log(base), base**offset)

    def exponential(self, e: Any) -> Signal:
        slope, offset = self.linear(e.args[0])
        return self.grown(sp.exp(slope) if self.discrete else slope, sp.exp(offset))

    def grown(self, growth: sp.Expr, factor: sp.Expr) -> Signal:
        if growth.has(sp.I) or factor.has(sp.I):
            raise NotExact("signals/not_real")
        return Signal({(sp.S.Zero, (0, growth, sp.S.Zero, False)): factor})

    def function(self, e: Any) -> Signal:
        kind = e.func
        if kind in (sp.Heaviside, sp.DiracDelta):
            return self.jump(kind, *self.linear(e.args[0]))
        if kind in (sp.sinh, sp.cosh):
            u = e.args[0]
            return self.read((sp.exp(u) + (1 if kind is sp.cosh else -1) * sp.exp(-u)) / 2)
        if kind not in (sp.sin, sp.cos):
            raise self.unknown(e)
        angle, phase = self.linear(e.args[0])
        if angle.could_extract_minus_sign():
            sign, angle, phase = (-1 if kind is sp.sin else 1), -angle, -phase
        else:
            sign = 1
        c, s = sp.cos(phase), sp.sin(phase)
        cosine, sine = (s, c) if kind is sp.sin else (c, -s)
        return _sum(self.wave(sign * cosine, angle, sine=False), self.wave(sign * sine, angle, sine=True))

    def wave(self, coefficient: sp.Expr, angle: sp.Expr, *, sine: bool) -> Signal:
        """The signal c cos ωx or c sin ωx; in discrete time an angle of whole turns, or half a turn more, is none."""
        if angle == 0:
            return Signal() if sine else self.constant(coefficient)
        growth = self.still
        if self.discrete and (angle / sp.pi).is_Rational:
            angle = sp.pi * ((angle / sp.pi) % 2)
            if angle > sp.pi:
                angle, coefficient = 2 * sp.pi - angle, -coefficient if sine else coefficient
            if angle in (0, sp.pi):
                growth = sp.Integer(1) if angle == 0 else sp.Integer(-1)
                return Signal() if sine else Signal({(sp.S.Zero, (0, growth, sp.S.Zero, False)): coefficient})
        return Signal({(sp.S.Zero, (0, growth, angle, sine)): coefficient}) if coefficient != 0 else Signal()

    def jump(self, kind: Any, slope: sp.Expr, offset: sp.Expr) -> Signal:
        """A step or an impulse with the argument slope·x + offset."""
        if slope.is_positive is None and slope.is_negative is None:
            raise NotExact("signals/direction_of_time")
        delay = sp.cancel(-offset / slope)
        of_delay = possible_signs(delay)
        if -1 in of_delay and len(of_delay) > 1:
            raise NotExact("signals/before_or_after_the_start", delay=delay)
        if self.discrete and not delay.is_Integer:
            raise NotExact("signals/between_samples", delay=delay)
        if kind is sp.DiracDelta:
            weight = sp.S.One if self.discrete else 1 / sp.Abs(slope)
            return Signal() if -1 in of_delay else Signal({}, {delay: weight})
        one = (0, self.still, sp.S.Zero, False)
        if -1 in of_delay:
            delay, after = sp.S.Zero, not slope.is_negative
            return Signal({(delay, one): sp.S.One}) if after else Signal()
        if slope.is_negative:
            start = delay + 1 if self.discrete else delay  # step(m − k) is still one at k = m
            return Signal({(sp.S.Zero, one): sp.S.One, (start, one): -sp.S.One}) if start != 0 else Signal()
        return Signal({(delay, one): sp.S.One})

    def linear(self, argument: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """(a, b) of a x + b."""
        expanded = sp.expand(argument)
        slope, offset = expanded.coeff(self.x, 1), expanded.coeff(self.x, 0)
        if slope.has(self.x) or offset.has(self.x) or sp.expand(expanded - slope * self.x - offset) != 0:
            raise self.unknown(argument)
        return slope, offset

    def product(self, left: Signal, right: Signal) -> Signal:
        result = Signal()
        for (d1, a), c1 in left.terms.items():
            for (d2, b), c2 in right.terms.items():
                result = _sum(result, self.times(_later(d1, d2), a, b, c1 * c2))
        if left.impulses and right.impulses:
            raise NotExact("signals/product_of_impulses")
        for impulses, other in ((left.impulses, right), (right.impulses, left)):
            for delay, weight in impulses.items():
                result = _sum(result, Signal({}, {delay: weight * self.value(other, delay)}))
        return result

    def times(self, delay: sp.Expr, a: Term, b: Term, c: sp.Expr) -> Signal:
        """The product of two terms, by the formulas for products of sines and cosines."""
        n, growth = a[0] + b[0], (a[1] * b[1] if self.discrete else a[1] + b[1])
        if n > MAX_POWER:
            raise NotExact("signals/high_power", most=MAX_POWER)
        if a[2] == 0 or b[2] == 0:
            waves = self.wave(c, a[2] + b[2], sine=a[3] or b[3])
        else:
            if a[3] and not b[3]:
                a, b = b, a
            half, odd = c / 2, a[3] != b[3]
            sum_sign = -1 if a[3] else 1
            difference = b[2] - a[2]
            sign = 1
            if difference.could_extract_minus_sign():
                difference, sign = -difference, -1 if odd else 1
            waves = _sum(
                self.wave(half * sum_sign, a[2] + b[2], sine=odd), self.wave(half * sign, difference, sine=odd)
            )
        return Signal({(delay, self.scaled(n, growth, term)): each for (_, term), each in waves.terms.items()})

    def scaled(self, n: int, growth: sp.Expr, wave: Term) -> Term:
        """The term xⁿ e^{σx} (in discrete time xⁿ rˣ) times a wave."""
        return n, (growth * wave[1] if self.discrete else growth + wave[1]), wave[2], wave[3]

    def value(self, signal: Signal, at: sp.Expr) -> sp.Expr:
        """What an impulse at that time is multiplied by; refused where it meets a step."""
        total = sp.S.Zero
        for (delay, term), c in signal.terms.items():
            begun = sp.S.Zero if delay == 0 else at - delay
            if delay != 0 and begun == 0 and not self.discrete:
                raise NotExact("signals/impulse_at_a_step")
            if begun.is_nonnegative is None:
                raise NotExact("signals/step_or_impulse_first")
            if begun.is_nonnegative:
                total += c * written(term, self.x, discrete=self.discrete).subs(self.x, at)
        return total

    def unknown(self, e: sp.Expr) -> NotExact:
        return NotExact("signals/no_rational_transform", part=e)


def _later(a: sp.Expr, b: sp.Expr) -> sp.Expr:
    if b in (a, 0):
        return a
    if a == 0 or is_positive(b - a):
        return b
    if is_positive(a - b):
        return a
    raise NotExact("signals/later_of_two_steps")


def _sum(left: Signal, right: Signal) -> Signal:
    return Signal(_merged(left.terms, right.terms), _merged(left.impulses, right.impulses))


def _merged(left: Mapping[Key, sp.Expr], right: Mapping[Key, sp.Expr]) -> dict[Key, sp.Expr]:
    result = dict(left)
    for key, c in right.items():
        result[key] = result.get(key, sp.S.Zero) + c
    return {key: sp.expand(c) for key, c in result.items() if sp.expand(c) != 0}


def delayed(signals: Iterable[Signal]) -> list[sp.Expr]:
    """All times at which something begins in some signals, zero first, the others in order where it is known."""
    found = dict.fromkeys([sp.S.Zero, *(delay for signal in signals for delay in signal.delays)])
    return in_order(found) or list(found)


def in_order(times: Iterable[sp.Expr]) -> list[sp.Expr] | None:
    """Times, the earliest first; None where parameters decide which that is."""
    found = list(times)
    signs = {(a, b): possible_signs(sp.expand(a - b)) for a, b in permutations(found, 2)}
    if any(len(each) > 1 for each in signs.values()):
        return None
    return sorted(found, key=lambda time: sum(1 in signs[time, other] for other in found if other != time))
