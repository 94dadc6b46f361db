"""The frequency response of T: magnitude and phase, the steady answer to a sinusoid, resonance and bandwidth."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
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
from solver.derivation.lemmas import worded_by
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.options.number import Number
from solver.options.signal import Signal
from solver.stated.algebra import product, quotient, total
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute, phase
from solver.tasks.frequency import response_checks, response_mistakes
from solver.tasks.frequency.boundary import of_samples, period_of
from solver.tasks.frequency.crossovers import angle_rows, approximation, formula_of, on_axis_of, shown_polynomial
from solver.tasks.frequency.figures import bode_figure
from solver.tasks.frequency.late_response import of_late_loop
from solver.tasks.frequency.parametric_response import has_parameters, of_parameters
from solver.tasks.frequency.steady import Passed, axis_of, constant_through, dies_out, input_of, steady_answers
from solver.tasks.frequency.worked_out import value_worked_out
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
        'a sinusoidal input, such as "2cos(4t)" (discrete: in k or t), or a sum of such and a constant',
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
                   principal=True, unit="ratio", earned=("on_axis", "functions", "value", "factors")),
        AnswerName("phase", r"\varphi", "the phase in degrees", principal=True, free=True, unit="°",
                   earned=("on_axis", "functions", "value", "factors")),
        AnswerName("y_steady_state", r"y_{ss}", "what is left of the output", optional=True, principal=True,
                   earned=("rest", "value", "factors", "steady_state")),
        AnswerName("resonant_frequency", r"\omega_{r}", "where the magnitude is largest, if that is not at 0",
                   optional=True, unit="rad/s", earned=("resonance",)),
        AnswerName("resonant_peak", r"M_{r}", "the magnitude at resonance", optional=True, unit="ratio",
                   earned=("resonance",)),
        AnswerName("resonant_phase", r"\varphi_{r}", "the phase at resonance, in degrees", optional=True, free=True,
                   unit="°", earned=("resonance",)),
        AnswerName("bandwidth", r"\omega_{b}", r"where the magnitude has fallen to $1/\sqrt{2}$ of that at 0",
                   optional=True,
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
    if has_parameters(loop, options):
        return (yield from of_parameters(loop, options, *(yield from _transfer(loop))))
    T = _on_boundary(loop, *(yield from _transfer(loop)))
    if options.input is not None:
        return (yield from _steady(loop, T, options.input))
    if options.frequency is not None:
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


def _transfer(loop: OpenLoop) -> Derivation[tuple[Expr, Expr]]:
    """Numerator and denominator of T = C G/(1 + L) of a closed loop, of C G of an open one."""
    s, N, D = loop.variable, loop.numerator, loop.denominator
    if not loop.closed:
        return N, D
    forward = sp.cancel(loop.C * loop.G)
    if sp.cancel(1 + N / D) == 0:
        raise Unsolved("conversions/ill_posed_loop")
    closed = sp.cancel(forward / (1 + N / D))
    claim = Claim(quotient(forward, total(sp.S.One, N / D)), closed, "the closed loop")
    yield Step("closed", claims={"T": claim}, s=s)
    above, below = sp.fraction(closed)
    return above, below


def _on_boundary(loop: OpenLoop, above: Expr, below: Expr) -> exact.OnAxis:
    """T(jω), or T(e^{jωT})."""
    if loop.discrete:
        return of_samples(loop, above, below)
    return exact.on_axis(above, below, loop.variable, loop.delay)


def _functions(T: exact.OnAxis) -> Derivation[Answers]:
    """Magnitude and phase as functions of ω."""
    omega, s, w = sp.Symbol("omega"), T.variable, T.parts.w
    P, Q = (p.as_expr().subs(w, T.place(omega)) for p in (T.parts.above, T.parts.below))
    magnitude = sp.sqrt(P) / sp.sqrt(Q)
    angle = exact.phase_function(T, omega)
    yield Step("functions", unclaimed="the answers, which have checks of their own", magnitude=magnitude, angle=angle,
               late=T.late, s=s, positive=angle.has(sp.atan2), discrete=T.discrete)  # fmt: skip
    return Answers(magnitude=magnitude, phase=angle)


def _value(
    T: exact.OnAxis, omega: Expr, *, normalized: bool = False, several: bool = False
) -> Derivation[tuple[Expr, Expr]]:
    """T(jω) at one frequency (of `several`), its size and its angle; `normalized`: in radians per sample."""
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
    yield Step("value", claims=claims, steps=value_worked_out(T, omega, magnitude), omega=omega, value=value,
               rows=rows, turns=turns, angle=angle, s=s,
               magnitude=magnitude, near=approximation(magnitude), T=formula_of(T), discrete=T.discrete,
               point=T.point(omega), alias=_alias(T, omega), normalized=normalized, several=several,
               letter=sp.Symbol("omega"), axis=axis_of(omega))  # fmt: skip
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
    given = input_of(u, discrete=loop.discrete, period=period_of(loop))
    whole = loop.numerator + loop.denominator if loop.closed else loop.denominator
    counts: Any = exact.root_counts(sp.Poly(whole, loop.variable).all_coeffs(), discrete=loop.discrete)
    if counts is None or counts.outside or counts.on:
        raise Unsolved("frequency/never_steady", p=whole, closed=loop.closed, discrete=loop.discrete)
    grows = [given.grows(wave.omega) for wave in given.found.sinusoids]
    yield from dies_out(whole, closed=loop.closed, discrete=loop.discrete, several=given.several, theta=grows[0],
                        sampled=loop.discrete and not given.in_samples)  # fmt: skip
    normalized = loop.discrete and loop.sample_time is None
    at = sp.Integer(int(loop.discrete))
    return (yield from steady_answers(
        given, lambda omega: _passed(T, omega, several=given.several, normalized=normalized),
        lambda: constant_through(formula_of(T), T.variable, at, T.value(sp.S.Zero)[0])))  # fmt: skip


@worded_by("frequency_response/frequency_response")
def _passed(T: exact.OnAxis, omega: Expr, *, several: bool, normalized: bool) -> Derivation[Passed]:
    """What T does to a sinusoid; of several one that is blocked adds nothing."""
    if several and T.magnitude(omega) == 0:
        value = Claim(value_at(formula_of(T), T.variable, T.point(omega)), sp.S.Zero, "the value of $T$")
        yield Step("blocked", claims={"value": value}, omega=omega, letter=sp.Symbol("omega"), axis=axis_of(omega))
        return Passed(sp.S.Zero, sp.S.Zero, sp.S.Zero)
    magnitude, angle = yield from _value(T, omega, normalized=normalized, several=several)
    return Passed(magnitude, angle, _radians(T, omega, angle))


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
