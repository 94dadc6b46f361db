"""Lemma: the frequency response of a closed loop with a dead time at one frequency, by the value of L there."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import quotient, total
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute, phase
from solver.tasks.frequency.closed_loop import is_stable
from solver.tasks.frequency.crossovers import negative_axis_of, on_axis_of

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpenLoop
    from solver.tasks.frequency.frequency_response import ResponseOptions

DIGITS = 30


def of_late_loop(loop: OpenLoop, options: ResponseOptions) -> Derivation[Answers]:
    """T(jω) at one frequency, of a sinusoid after it was seen that the loop settles."""
    wave, t = None, sp.Symbol("t")
    if options.input is not None:
        wave = exact.sinusoid(options.input, t)
        if wave is None:
            raise Unsolved("frequency/no_sinusoid", u=options.input)
        yield from _settles(loop)
    omega = wave.omega if wave else options.frequency
    if omega is None:
        raise Unsolved("frequency/closed_with_dead_time")
    names = sorted({*loop.parameters, *omega.free_symbols} - {loop.variable}, key=str)
    if names:
        raise Unsolved("frequency/parameters", names=names)
    magnitude, angle = yield from _value(loop, omega)
    answers = Answers(magnitude=magnitude, phase=angle)
    if wave and options.input is not None:
        radians = sp.N(angle * sp.pi / 180, 30)
        y = sp.Add(*(sp.expand(size * magnitude) * f(angle_of(omega * t + radians), evaluate=False)
                     for size, f, angle_of in waves_of(options.input, wave)))  # fmt: skip
        yield Step("steady_state", unclaimed="the answer, which has a check of its own", y=y, omega=omega,
                   u=options.input, angle=angle, radians=radians, magnitude=magnitude, discrete=False)  # fmt: skip
        answers["y_steady_state"] = y
    return answers


@lemma("late_response")
def _value(loop: OpenLoop, omega: Expr) -> Derivation[tuple[Expr, Expr]]:
    """T = F/(1 + L) at jω with F = C G e^{−Ts}: its size, and its angle in degrees, in decimals."""
    s, at = loop.variable, sp.I * omega
    L, F = loop.numerator / loop.denominator * loop.factor, sp.cancel(loop.C * loop.G) * loop.factor
    if sp.expand(loop.denominator.subs(s, at)) == 0:
        raise Unsolved("frequency/pole_at_the_frequency", omega=omega)
    at_L, at_F = (_number(each.subs(s, at)) for each in (L, F))
    if abs(1 + at_L) < sp.Float("1e-25"):
        raise Unsolved("frequency/pole_at_the_frequency", omega=omega)
    T = _number(F.subs(s, at) / (1 + L.subs(s, at)))
    size = sp.N(abs(T), DIGITS)
    if size == 0:
        raise Unsolved("frequency/zero_at_the_frequency", omega=omega)
    angle = sp.N(sp.arg(T) * 180 / sp.pi, DIGITS)
    claims = {
        "L": Claim(value_at(L, s, at), at_L, "the value of $L$"),
        "F": Claim(value_at(F, s, at), at_F, "the value of the forward path"),
        "T": Claim(quotient(at_F, total(1, at_L)), T, "the value of $T$"),
        "magnitude": Claim(absolute(T), size, "the magnitude"),
        "phase": Claim(phase(T), angle, "the phase"),
    }
    yield Step("value", claims=claims, omega=omega, unity=loop.H == 1, s=s)
    return size, angle


@lemma("late_response")
def _settles(loop: OpenLoop) -> Derivation[None]:
    """By Nyquist's count the loop is stable, so that a steady answer is left; raises Unsolved where it is not."""
    L = exact.on_axis(loop.numerator, loop.denominator, loop.variable, loop.delay)
    yield from on_axis_of(L)
    yield from negative_axis_of(L)
    if not (yield from is_stable(loop)):
        raise Unsolved("frequency/never_steady_late")


def waves_of(u: Expr, wave: exact.Sinusoid) -> list[tuple[Expr, Any, Callable[[Any], Any]]]:
    """The input as size, sin or cos, and how its angle grows by the phase: one wave where it was written as one."""
    size, alone = u.as_independent(*(x for x in u.free_symbols if str(x) in ("t", "k")), as_Add=False)
    if isinstance(alone, sp.sin | sp.cos):
        start = alone.args[0].as_independent(sp.Symbol("t"), sp.Symbol("k"), as_Add=True)[0]
        if not (alone.args[0] - start).could_extract_minus_sign():
            return [(size, alone.func, lambda turned: turned + (sp.N(start, 30) if turned.has(sp.Float) else start))]
    return [(part, f, lambda turned: turned) for part, f in ((wave.cosine, sp.cos), (wave.sine, sp.sin)) if part != 0]


def _number(value: Any) -> Any:
    """A complex number in decimals."""
    real, imaginary = sp.N(value, DIGITS + 20).as_real_imag()
    return sp.Float(real, DIGITS) + sp.I * sp.Float(imaginary, DIGITS)


__all__ = ["of_late_loop", "waves_of"]
