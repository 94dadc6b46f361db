"""Lemma: the frequency response of a closed loop with a dead time at one frequency, by the value of L there."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import quotient, total
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute, phase
from solver.tasks.frequency.closed_loop import is_stable
from solver.tasks.frequency.crossovers import negative_axis_of, on_axis_of
from solver.tasks.frequency.steady import Passed, axis_of, constant_through, input_of, steady_answers

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpenLoop
    from solver.tasks.frequency.frequency_response import ResponseOptions

DIGITS = 30


def of_late_loop(loop: OpenLoop, options: ResponseOptions) -> Derivation[Answers]:
    """T(jω) at one frequency, of sinusoids after it was seen that the loop settles."""
    given = None if options.input is None else input_of(options.input)
    asked = [options.frequency] if given is None else [wave.omega for wave in given.found.sinusoids]
    if given is not None:
        yield from _settles(loop)
    names = sorted({*loop.parameters, *(x for each in asked if each for x in each.free_symbols)} - {loop.variable},
                   key=str)  # fmt: skip
    if options.frequency is None and given is None:
        raise Unsolved("frequency/closed_with_dead_time")
    if names:
        raise Unsolved("frequency/parameters", names=names)
    if given is not None:
        return (
            yield from steady_answers(
                given, lambda omega: _passed(loop, omega, several=given.several), lambda: _at_rest(loop)
            )
        )
    magnitude, angle = yield from _value(loop, options.frequency)
    return Answers(magnitude=magnitude, phase=angle)


def _passed(loop: OpenLoop, omega: Expr, *, several: bool) -> Derivation[Passed]:
    magnitude, angle = yield from _value(loop, omega, several=several)
    return Passed(magnitude, angle, sp.N(angle * sp.pi / 180, 30))


def _at_rest(loop: OpenLoop) -> Derivation[Expr]:
    """T(0), where the dead time makes no difference."""
    T = sp.cancel(loop.C * loop.G / (1 + loop.numerator / loop.denominator))
    return (yield from constant_through(T, loop.variable, sp.S.Zero, sp.cancel(T.subs(loop.variable, 0))))


@lemma("late_response")
def _value(loop: OpenLoop, omega: Any, *, several: bool = False) -> Derivation[tuple[Expr, Expr]]:
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
    yield Step(
        "value",
        claims=claims,
        omega=omega,
        unity=loop.H == 1,
        s=s,
        several=several,
        letter=sp.Symbol("omega"),
        axis=axis_of(omega),
    )
    return size, angle


@lemma("late_response")
def _settles(loop: OpenLoop) -> Derivation[None]:
    """By Nyquist's count the loop is stable, so that a steady answer is left; raises Unsolved where it is not."""
    L = exact.on_axis(loop.numerator, loop.denominator, loop.variable, loop.delay)
    yield from on_axis_of(L)
    yield from negative_axis_of(L)
    if not (yield from is_stable(loop)):
        raise Unsolved("frequency/never_steady_late")


def _number(value: Any) -> Any:
    """A complex number in decimals."""
    real, imaginary = sp.N(value, DIGITS + 20).as_real_imag()
    return sp.Float(real, DIGITS) + sp.I * sp.Float(imaginary, DIGITS)


__all__ = ["of_late_loop"]
