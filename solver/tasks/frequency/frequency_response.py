"""The frequency response of T: magnitude and phase, the steady answer to a sinusoid, resonance and bandwidth."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Check,
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
from solver.numeric.judges import frequency as judges
from solver.options.number import Number
from solver.options.signal import Signal
from solver.stated.algebra import product, quotient, total
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute, phase
from solver.tasks.frequency import response_mistakes
from solver.tasks.frequency.crossovers import angle_rows, approximation, formula_of, on_axis_of
from solver.tasks.frequency.figures import bode_figure
from solver.tasks.plant_options import LoopOptions
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpenLoop, System


@dataclass(frozen=True, kw_only=True)
class ResponseOptions(LoopOptions):
    """A frequency, or a sinusoid."""

    input: Expr | None = option(Signal(), 'a sinusoidal input, such as "2cos(4t)", whose steady answer is asked for')
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
                   principal=True, earned=("on_axis", "functions", "value")),
        AnswerName("phase", r"\varphi", "the phase in degrees", principal=True, free=True, unit="°",
                   earned=("on_axis", "functions", "value")),
        AnswerName("y_steady_state", r"y_{ss}", "what is left of the output", optional=True, principal=True,
                   earned=("steady_state",)),
        AnswerName("resonant_frequency", r"\omega_{r}", "where the magnitude is largest, if that is not at 0",
                   optional=True, unit="rad/s", earned=("resonance",)),
        AnswerName("resonant_peak", r"M_{r}", "the magnitude there", optional=True, earned=("resonance",)),
        AnswerName("resonant_phase", r"\varphi_{r}", "the phase there, in degrees", optional=True, free=True, unit="°",
                   earned=("resonance",)),
        AnswerName("bandwidth", r"\omega_{b}", "where the magnitude has fallen to 1/√2 of that at 0", optional=True,
                   unit="rad/s", earned=("bandwidth",)),
    ],
)  # fmt: skip

response_mistakes.register(frequency_response)


@frequency_response.refusal
def is_no_frequency(system: System, options: ResponseOptions) -> Iterable[Refusal]:  # noqa: ARG001 - any system
    """A frequency is positive; with an input it is that of the input."""
    if options.frequency is not None and options.frequency.is_number and not options.frequency.is_positive:
        yield "frequency", Reason("frequency/not_positive")
    if options.frequency is not None and options.input is not None:
        yield "frequency", Reason("frequency/frequency_of_the_input")


@frequency_response.method(source="Ogata, Modern Control Engineering, §7–1", time="continuous")
def on_the_axis(given: Given[OpenLoop, ResponseOptions]) -> Derivation[Answers]:
    """T(jω) by its size and angle; at one frequency, or as functions with resonance and bandwidth."""
    loop, options = given.system, given.options
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
    yield Step("picture", unclaimed="drawn from the numbers found above",
               figures=bode_figure("Bode diagram of $T$", ("T", T), marked=marked))  # fmt: skip
    return answers


def _transfer(loop: OpenLoop) -> Derivation[exact.OnAxis]:
    """T = C G/(1 + L) of a closed loop, C G of an open one."""
    s, N, D = loop.variable, loop.numerator, loop.denominator
    if not loop.closed:
        return exact.on_axis(N, D, s, loop.delay)
    if loop.delay != 0:
        raise Unsolved("frequency/closed_with_dead_time")
    forward = sp.cancel(loop.C * loop.G)
    if sp.cancel(1 + N / D) == 0:
        raise Unsolved("conversions/ill_posed_loop")
    closed = sp.cancel(forward / (1 + N / D))
    claim = Claim(quotient(forward, total(sp.S.One, N / D)), closed, "the closed loop")
    yield Step("closed", claims={"T": claim}, s=s)
    above, below = sp.fraction(closed)
    return exact.on_axis(above, below, s)


def _functions(T: exact.OnAxis) -> Derivation[Answers]:
    """Magnitude and phase as functions of ω."""
    omega, s, w = sp.Symbol("omega"), T.variable, T.parts.w
    P, Q = (p.as_expr().subs(w, omega**2) for p in (T.parts.above, T.parts.below))
    magnitude = sp.sqrt(P) / sp.sqrt(Q)
    angle = exact.phase_function(T, omega)
    yield Step("functions", unclaimed="the answers, which have checks of their own", magnitude=magnitude, angle=angle,
               late=T.late, s=s, positive=angle.has(sp.atan2))  # fmt: skip
    return Answers(magnitude=magnitude, phase=angle)


def _value(T: exact.OnAxis, omega: Expr) -> Derivation[tuple[Expr, Expr]]:
    """T(jω) at one frequency, its size and its angle."""
    s = T.variable
    below = T.parts.below.as_expr().subs(T.parts.w, omega**2)
    if sp.expand(below) == 0:
        raise Unsolved("frequency/pole_at_the_frequency", omega=omega)
    real, imaginary = T.value(omega)
    value, magnitude = real + sp.I * imaginary, T.magnitude(omega)
    at = value_at(formula_of(T), s, sp.I * omega)
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
               magnitude=magnitude, near=approximation(magnitude), T=formula_of(T))  # fmt: skip
    return magnitude, angle


def _steady(loop: OpenLoop, T: exact.OnAxis, u: Expr) -> Derivation[Answers]:
    """What is left of the output of a stable system."""
    t = sp.Symbol("t")
    wave = exact.sinusoid(u, t)
    if wave is None:
        raise Unsolved("frequency/no_sinusoid", u=u)
    whole = loop.numerator + loop.denominator if loop.closed else loop.denominator
    counts: Any = exact.root_counts(sp.Poly(whole, loop.variable).all_coeffs())
    if counts is None or counts.outside or counts.on:
        raise Unsolved("frequency/never_steady", p=whole, closed=loop.closed)
    yield Step("stable", unclaimed="counted by a Routh array; the answer has a check of its own", p=whole,
               closed=loop.closed, u=u)  # fmt: skip
    magnitude, angle = yield from _value(T, wave.omega)
    radians = _radians(T, wave.omega, angle)
    turned = wave.omega * t + radians
    y = sp.Add(*(sp.expand(size * magnitude) * f(turned, evaluate=False)
                 for size, f in ((wave.cosine, sp.cos), (wave.sine, sp.sin)) if size != 0))  # fmt: skip
    yield Step("steady_state", unclaimed="the answer, which has a check of its own", y=y, omega=wave.omega, u=u,
               angle=angle, radians=radians, magnitude=magnitude)  # fmt: skip
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
    if p.domain.is_QQ:
        p = p.clear_denoms(convert=True)[1].primitive()[1]
    shown = (-p if p.LC().is_negative else p).as_expr()
    for i, each in enumerate(found.stationary, 1):
        claims[f"root{i}"] = Claim(value_at(shown, w, sp.expand(each**2)), sp.S.Zero, "a root in $w = \\omega^2$")
    peak = found.peak
    if peak is not None:
        at = value_at(formula_of(T), T.variable, sp.I * peak.omega)
        claims["peak"] = Claim(absolute(at), peak.magnitude, "the largest magnitude")
        claims["phase"] = Claim(phase(at), peak.phase, "the phase there")
    rows = [(each, approximation(each), T.magnitude(each)) for each in found.stationary]
    square = (T.parts.above.as_expr() / T.parts.below.as_expr()) if T.parts.above.degree() > 0 else None
    return Step("resonance", claims=claims, unclaimed="" if claims else "there is no such frequency", p=shown, w=w,
                rows=rows, peak=peak, moves=p.degree() > 0, square=square, start=T.magnitude(sp.S.Zero),
                root=sp.expand(peak.omega**2) if peak else None,
                near_omega=approximation(peak.omega) if peak else None,
                near=approximation(peak.magnitude) if peak else None)  # fmt: skip


def _bandwidth(T: exact.OnAxis, band: exact.Bandwidth) -> Step:
    """Where |T| = |T(0)|/√2."""
    w, claims = T.parts.w, {}
    p = band.polynomial
    if p.domain.is_QQ:
        p = p.clear_denoms(convert=True)[1].primitive()[1]
    shown = (-p if p.LC().is_negative else p).as_expr()
    if band.omega is not None:
        at = value_at(formula_of(T), T.variable, sp.I * band.omega)
        claims["root"] = Claim(value_at(shown, w, sp.expand(band.omega**2)), sp.S.Zero, "a root in $w = \\omega^2$")
        claims["level"] = Claim(absolute(at), band.level, "the magnitude there")
    return Step("bandwidth", claims=claims, unclaimed="" if claims else "there is no such frequency", p=shown, w=w,
                omega=band.omega, root=sp.expand(band.omega**2) if band.omega is not None else None,
                near=approximation(band.omega) if band.omega is not None else None, level=band.level)  # fmt: skip


BY_VALUES = "mpmath, values of C G/(1 + C G H) at jω"
TOLERANCE = 1e-19


def _numbers(given: Given[OpenLoop, ResponseOptions]) -> judges.ClosedResponse:
    loop = given.system
    H = loop.H if loop.closed else sp.S.Zero
    return judges.closed_response(loop.C, loop.G, H, loop.variable, loop.delay)


@frequency_response.verification("magnitude", "phase", "y_steady_state")
def is_the_value(given: Given[OpenLoop, ResponseOptions], answers: Answers) -> Iterable[Check]:
    """T(jω) by numbers; phases are judged up to full turns."""
    found, options = _numbers(given), given.options
    at = judges.frequencies_asked(options.input, options.frequency)
    if "magnitude" in answers:
        yield Check.within("$|T(j\\omega)|$", BY_VALUES, found.magnitude_residual(answers["magnitude"], at), TOLERANCE,
                           answer="magnitude")  # fmt: skip
    if "phase" in answers:
        yield Check.within("$\\angle T(j\\omega)$", BY_VALUES, found.phase_residual(answers["phase"], at), TOLERANCE,
                           answer="phase")  # fmt: skip
    if "y_steady_state" in answers:
        residual = found.steady_residual(answers["y_steady_state"], options.input)
        yield Check.within("the steady answer to the input", BY_VALUES, residual, TOLERANCE, answer="y_steady_state")


@frequency_response.verification("resonant_frequency", "resonant_peak", "resonant_phase")
def is_the_largest(given: Given[OpenLoop, ResponseOptions], answers: Answers) -> Iterable[Check]:
    """The largest magnitude is sought among samples and refined."""
    peak = _numbers(given).peak()
    for name, place in (("resonant_frequency", 0), ("resonant_peak", 1), ("resonant_phase", 2)):
        if name in answers:
            known = [] if peak is None else [peak[place]]
            judged = "phase_margin" if place == 2 else name  # modulo 360°
            residual = judges.margin_residual(answers[name], known, judged) if known else float("inf")
            yield Check.within(
                "the largest magnitude and where it is", "mpmath, samples refined", residual, TOLERANCE, answer=name
            )


@frequency_response.verification("bandwidth")
def falls_there_first(given: Given[OpenLoop, ResponseOptions], answers: Answers) -> Iterable[Check]:
    """The first frequency of all samples where |T| has fallen to |T(0)|/√2."""
    found = _numbers(given).bandwidth()
    residual = judges.margin_residual(answers["bandwidth"], [found], "bandwidth") if found else float("inf")
    yield Check.within("$|T(j\\omega_b)| = |T(0)|/\\sqrt{2}$", "mpmath, samples bisected", residual, TOLERANCE)
