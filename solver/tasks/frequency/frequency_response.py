"""The frequency response of T: magnitude and phase, the steady answer to a sinusoid, resonance and bandwidth."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from solver.arithmetic.frequencies import size_and_angle, slope_of
from solver.arithmetic.quadratics import both_roots
from solver.derivation import (
    AnswerName,
    Answers,
    Claim,
    Derivation,
    Given,
    Refusal,
    Step,
    Task,
    Unsolved,
    option,
)  # fmt: skip
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.options.number import Number
from solver.options.signal import Signal
from solver.stated.algebra import product, quotient, total
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute, phase
from solver.tasks.frequency import response_checks, response_mistakes
from solver.tasks.frequency.boundary import of_samples, on_boundary, period_of
from solver.tasks.frequency.crossovers import angle_rows, approximation, formula_of, on_axis_of, shown_polynomial
from solver.tasks.frequency.figures import bode_figure
from solver.tasks.frequency.late_response import of_late_loop, waves_of
from solver.tasks.plant_options import LoopOptions
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpenLoop, System


@dataclass(frozen=True, kw_only=True)
class ResponseOptions(LoopOptions):
    """A frequency, or a sinusoid."""

    input: Expr | None = option(
        Signal(sampled=True),
        'a sinusoidal input, such as "2cos(4t)" (discrete: in k or t), whose steady answer is asked for',
    )
    frequency: Expr | None = option(Number(), "the frequency in rad/s; without it magnitude and phase are functions")


frequency_response: Task[OpenLoop, ResponseOptions] = Task(
    "frequency_response",
    title="Frequency response",
    doc="Magnitude and phase of T(jω), the steady answer to a sinusoid, resonance and bandwidth.",
    needs=("open_loop",),
    options=ResponseOptions,
    example={"transfer_function": "4/(s^2 + s + 4)", "frequency": "2"},
    answers=[
        AnswerName("magnitude", r"|T(j\omega)|", "the magnitude, a function of omega unless a frequency is given",
                   principal=True, unit="ratio", earned=("on_axis", "functions", "value")),
        AnswerName("phase", r"\varphi", "the phase in degrees", principal=True, free=True, unit="°",
                   earned=("on_axis", "functions", "value")),
        AnswerName("y_steady_state", r"y_{ss}", "what is left of the output", optional=True, principal=True,
                   earned=("steady_state",)),
        AnswerName("resonant_frequency", r"\omega_{r}", "where the magnitude is largest, if that is not at 0",
                   optional=True, unit="rad/s", earned=("resonance",)),
        AnswerName("resonant_peak", r"M_{r}", "the magnitude there", optional=True, unit="ratio",
                   earned=("resonance",)),
        AnswerName("resonant_phase", r"\varphi_{r}", "the phase there, in degrees", optional=True, free=True, unit="°",
                   earned=("resonance",)),
        AnswerName("bandwidth", r"\omega_{b}", "where the magnitude has fallen to 1/√2 of that at 0", optional=True,
                   unit="rad/s", earned=("bandwidth",)),
    ],
)  # fmt: skip

response_mistakes.register(frequency_response)
response_checks.register(frequency_response)


@frequency_response.refusal
def is_no_frequency(system: System, options: ResponseOptions) -> Iterable[Refusal]:
    """A frequency is positive; with an input it is that of the input. In rad/s a discrete loop needs its period."""
    if options.frequency is not None and options.frequency.is_number and not options.frequency.is_positive:
        yield "frequency", Reason("frequency/not_positive")
    if options.frequency is not None and options.input is not None:
        yield "frequency", Reason("frequency/frequency_of_the_input")
    in_samples = options.input is not None and not options.input.has(sp.Symbol("t"))
    if system.discrete and system.sample_time is None and not in_samples:
        yield "", Reason("frequency/no_sample_time")


@frequency_response.method(source="Ogata, Modern Control Engineering, §7–1", time="both")
def on_the_axis(given: Given[OpenLoop, ResponseOptions]) -> Derivation[Answers]:
    """T(jω), discrete T(e^{jωT}), by size and angle; at one frequency, or as functions with resonance and bandwidth."""
    loop, options = given.system, given.options
    if loop.closed and loop.delay != 0:
        return (yield from of_late_loop(loop, options))
    T = yield from _transfer(loop)
    if options.input is not None:
        return (yield from _steady(loop, T, options.input))
    if options.frequency is not None:
        if options.frequency.free_symbols:
            raise Unsolved("frequency/parameters", names=sorted(options.frequency.free_symbols, key=str))
        magnitude, angle = yield from _value(T, options.frequency)
        return Answers(magnitude=magnitude, phase=angle)
    yield from on_axis_of(T, "T")
    answers = yield from _functions(T)
    found = exact.resonance(T)
    if found is not None:
        yield _resonance(T, found)
        if found.peak is not None:
            answers["resonant_frequency"] = found.peak.omega
            answers["resonant_peak"] = found.peak.magnitude
            answers["resonant_phase"] = found.peak.phase
    band = exact.bandwidth(T)
    if band is not None:
        yield _bandwidth(T, band)
        if band.omega is not None:
            answers["bandwidth"] = band.omega
    letters = {"resonant_frequency": r"\omega_{r}", "bandwidth": r"\omega_{b}"}
    marked = [(answers[name], letter) for name, letter in letters.items() if name in answers]
    yield Step("picture", unclaimed="drawn from the numbers found above", discrete=T.discrete, period=T.sample_time,
               figures=bode_figure("Bode diagram of $T$", ("T", T), marked=marked))  # fmt: skip
    return answers


def _transfer(loop: OpenLoop) -> Derivation[exact.OnAxis]:
    """T = C G/(1 + L) of a closed loop, C G of an open one."""
    s, N, D = loop.variable, loop.numerator, loop.denominator
    if not loop.closed:
        return on_boundary(loop)
    forward = sp.cancel(loop.C * loop.G)
    if sp.cancel(1 + N / D) == 0:
        raise Unsolved("conversions/ill_posed_loop")
    closed = sp.cancel(forward / (1 + N / D))
    claim = Claim(quotient(forward, total(sp.S.One, N / D)), closed, "the closed loop")
    yield Step("closed", claims={"T": claim}, s=s)
    above, below = sp.fraction(closed)
    return of_samples(loop, above, below) if loop.discrete else exact.on_axis(above, below, s)


def _functions(T: exact.OnAxis) -> Derivation[Answers]:
    """Magnitude and phase as functions of ω."""
    omega, s, w = sp.Symbol("omega"), T.variable, T.parts.w
    P, Q = (p.as_expr().subs(w, T.place(omega)) for p in (T.parts.above, T.parts.below))
    magnitude = sp.sqrt(P) / sp.sqrt(Q)
    angle = exact.phase_function(T, omega)
    yield Step("functions", unclaimed="the answers, which have checks of their own", magnitude=magnitude, angle=angle,
               late=T.late, s=s, positive=angle.has(sp.atan2), discrete=T.discrete)  # fmt: skip
    return Answers(magnitude=magnitude, phase=angle)


def _value(T: exact.OnAxis, omega: Expr, *, normalized: bool = False) -> Derivation[tuple[Expr, Expr]]:
    """T(jω) at one frequency, its size and its angle; `normalized`: in radians per sample."""
    s = T.variable
    below = T.parts.below.as_expr().subs(T.parts.w, T.place(omega))
    if sp.expand(below) == 0:
        raise Unsolved("frequency/pole_at_the_frequency", omega=omega)
    real, imaginary = T.value(omega)
    value, magnitude = real + sp.I * imaginary, T.magnitude(omega)
    at = value_at(formula_of(T), s, T.point(omega))
    if magnitude == 0:
        raise Unsolved("frequency/zero_at_the_frequency", omega=omega)
    angle = T.phase(omega)
    rows = list(angle_rows(T, omega))
    claims = {
        "value": Claim(at, value, "the value of $T$"),
        "magnitude": Claim(absolute(at), magnitude, "the magnitude"),
        "phase": Claim(phase(at), angle, "the phase"),
    }
    for i, row in enumerate(rows, 1):
        claims[f"angle{i}"] = Claim(phase(row["value"]), row["stated"], "the angle of a factor")
    terms = [row["degrees"] if row["power"] == 1 else product(sp.Integer(row["power"]), row["degrees"]) for row in rows]
    late = sp.expand(180 * omega * T.delay / sp.pi)
    if T.late:
        terms.append(product(sp.Integer(-1), late))
    whole = sp.Add(*(row["degrees"] * row["power"] for row in rows)) - late
    turns = sp.Integer(round(float((angle - whole) / 360)))
    if len(terms) > 1:
        claims["sum"] = Claim(total(*terms), whole, "the sum of the angles")
    if turns:
        claims["turned"] = Claim(total(whole, 360 * turns), angle, "the phase between −180° and 180°")
    yield Step("value", claims=claims, omega=omega, value=value, rows=rows, turns=turns, angle=angle, s=s,
               magnitude=magnitude, near=approximation(magnitude), T=formula_of(T), discrete=T.discrete,
               point=T.point(omega), alias=_alias(T, omega), normalized=normalized)  # fmt: skip
    return magnitude, angle


def _alias(T: exact.OnAxis, omega: Expr) -> Expr | None:
    """The frequency up to π/T that has the same samples as one beyond."""
    if T.end is None or omega <= T.end.omega:
        return None
    turns = 2 * T.end.omega
    rest = omega - turns * sp.floor(omega / turns)
    return rest if rest <= T.end.omega else turns - rest


def _steady(loop: OpenLoop, T: exact.OnAxis, u: Expr) -> Derivation[Answers]:
    """What is left of the output of a stable system."""
    in_samples = loop.discrete and not u.has(sp.Symbol("t"))
    t = sp.Symbol("k" if in_samples else "t")
    wave = exact.sinusoid(u, t)
    if wave is None:
        raise Unsolved("frequency/no_sinusoid", u=u)
    if loop.discrete:  # frequencies are in rad/s; samples at t = kT
        t, period = sp.Symbol("k"), period_of(loop)
        per_sample = wave.omega if in_samples else wave.omega * period
        wave = replace(wave, omega=per_sample / period)
    whole = loop.numerator + loop.denominator if loop.closed else loop.denominator
    counts: Any = exact.root_counts(sp.Poly(whole, loop.variable).all_coeffs(), discrete=loop.discrete)
    if counts is None or counts.outside or counts.on:
        raise Unsolved("frequency/never_steady", p=whole, closed=loop.closed, discrete=loop.discrete)
    yield Step("stable", unclaimed="counted by a Routh array; the answer has a check of its own", p=whole,
               closed=loop.closed, u=u, discrete=loop.discrete, sampled=loop.discrete and not in_samples,
               theta=per_sample if loop.discrete else None)  # fmt: skip
    magnitude, angle = yield from _value(T, wave.omega, normalized=loop.discrete and loop.sample_time is None)
    radians = _radians(T, wave.omega, angle)
    turned = (per_sample if loop.discrete else wave.omega) * t + radians
    y = sp.Add(*(sp.expand(size * magnitude) * f(angle_of(turned), evaluate=False)
                 for size, f, angle_of in waves_of(u, wave)))  # fmt: skip
    yield Step("steady_state", unclaimed="the answer, which has a check of its own", y=y, omega=wave.omega, u=u,
               angle=angle, radians=radians, magnitude=magnitude, discrete=loop.discrete)  # fmt: skip
    return Answers(magnitude=magnitude, phase=angle, y_steady_state=y)


def _radians(T: exact.OnAxis, omega: Expr, angle: Expr) -> Expr:
    """The phase in radians: a part of π, an arctangent where the value of T is exact, else decimals."""
    real, imaginary = T.value(omega)
    if angle.is_Rational:
        return angle * sp.pi / 180
    if real.has(sp.Float) or imaginary.has(sp.Float):
        return sp.N(angle * sp.pi / 180, 30)
    turn = 0 if real > 0 else 1 if imaginary > 0 else -1
    return sp.atan(sp.radsimp(imaginary / real)) + turn * sp.pi


def _resonance(T: exact.OnAxis, found: exact.Resonance) -> Step:
    """Where d|T|²/dω² = 0, and the largest magnitude."""
    w, claims = T.parts.w, {}
    p = found.polynomial
    shown = shown_polynomial(p)
    says = "a root in $\\cos\\omega T$" if T.discrete else "a root in $w = \\omega^2$"
    for i, each in enumerate(found.stationary, 1):
        claims[f"root{i}"] = Claim(value_at(shown, w, T.place(each)), sp.S.Zero, says)
    peak = found.peak
    if peak is not None:
        at = value_at(formula_of(T), T.variable, T.point(peak.omega))
        claims["peak"] = Claim(absolute(at), peak.magnitude, "the largest magnitude")
        claims["phase"] = Claim(phase(at), peak.phase, "the phase there")
    lines = slope_of(T.parts.above.as_expr(), T.parts.below.as_expr(), w) if p.degree() > 0 else ()
    lines += both_roots(w, shown)
    if peak is not None:
        lines += size_and_angle(formula_of(T), T.variable, T.point(peak.omega), peak.magnitude, peak.phase)
    rows = [(each, approximation(each), T.magnitude(each)) for each in found.stationary]
    square = (T.parts.above.as_expr() / T.parts.below.as_expr()) if T.parts.above.degree() > 0 else None
    return Step("resonance", claims=claims, unclaimed="" if claims else "there is no such frequency", p=shown, w=w,
                steps=lines, rows=rows, peak=peak, moves=p.degree() > 0, square=square, start=T.magnitude(sp.S.Zero),
                root=T.place(peak.omega) if peak else None, discrete=T.discrete, period=T.sample_time,
                end=None if T.end is None else T.magnitude(T.end.omega), at_end=peak is not None and peak.end,
                near_omega=approximation(peak.omega) if peak else None,
                near=approximation(peak.magnitude) if peak else None)  # fmt: skip


def _bandwidth(T: exact.OnAxis, band: exact.Bandwidth) -> Step:
    """Where |T| = |T(0)|/√2."""
    w, claims = T.parts.w, {}
    shown = shown_polynomial(band.polynomial)
    if band.omega is not None:
        at = value_at(formula_of(T), T.variable, T.point(band.omega))
        says = "a root in $\\cos\\omega T$" if T.discrete else "a root in $w = \\omega^2$"
        claims["root"] = Claim(value_at(shown, w, T.place(band.omega)), sp.S.Zero, says)
        claims["level"] = Claim(absolute(at), band.level, "the magnitude there")
    return Step("bandwidth", claims=claims, unclaimed="" if claims else "there is no such frequency", p=shown, w=w,
                steps=both_roots(w, shown),
                omega=band.omega, root=T.place(band.omega) if band.omega is not None else None, discrete=T.discrete,
                period=T.sample_time,
                near=approximation(band.omega) if band.omega is not None else None, level=band.level)  # fmt: skip
