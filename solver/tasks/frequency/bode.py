"""Bode's diagram by hand: Bode's form, the corners one by one, the slopes of the asymptotes."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Attempt, Check, Claim, Derivation, Given, Slip, Step, Task
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.numeric.judges import frequency as judges
from solver.stated.algebra import power, product, quotient
from solver.tasks.frequency.figures import bode_figure
from solver.tasks.plant_options import LoopOptions

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import OpenLoop

bode: Task[OpenLoop, LoopOptions] = Task(
    "bode",
    title="Bode diagram",
    doc="Bode's form of L, its corner frequencies, the slopes of the asymptotes, and the diagram.",
    needs=("open_loop",),
    options=LoopOptions,
    example={"transfer_function": "100(s + 1)/(s(s + 10)^2)"},
    answers=[
        AnswerName("bode_gain", r"K_{B}", r"the gain $K$ of Bode's form $K s^N \prod(1 + s/\omega_i) \cdots$",
                   unit="ratio",
                   earned=("form",)),
        AnswerName("corner_frequencies", r"\omega_{i}", "the corners, rising, a multiple one as often as it counts, a "
                   r"pair at its $\omega_n$", ordered=True, unit="rad/s", earned=("corners",)),
        AnswerName("slopes", r"\text{slopes}", "the slopes of the asymptotes before and after each corner, in dB a "
                   "decade", ordered=True, unit="dB/decade", earned=("corners",)),
    ],
)  # fmt: skip

HERTZ = Slip("hertz", "the frequencies are in Hz; rad/s are asked for")
UNSCALED = Slip(
    "not_scaled", "the factors are not brought to the form 1 + s/ω: the gain of the pole-zero form is given"
)
OCTAVE = Slip("octave", "the slopes are in dB an octave; dB a decade are asked for")
TEN_LOG = Slip("ten_log", "10 log is taken; of an amplitude it is 20 log")
POWERS = Slip("powers", "this counts poles and zeros; each makes 20 dB a decade")
BENDS = Slip("bends", "zeros and poles are exchanged at the corners: a pole bends the asymptote down")
REVERSED = Slip("reversed", "zeros and poles are exchanged: a pole bends the asymptote down")


@bode.method(source="Ogata, Modern Control Engineering, §7–2", time="continuous")
def by_corners(given: Given[OpenLoop, LoopOptions]) -> Derivation[Answers]:
    """Each factor is made 1 at s = 0; at its corner the slope changes by 20 dB a decade for each power."""
    loop = given.system
    if set(loop.parameters) - {loop.variable}:
        return (yield from _of_parameters(loop))
    L = exact.on_axis(loop.numerator, loop.denominator, loop.variable, loop.delay)
    form = exact.bode_form(L)
    yield _form(L.N.as_expr() / L.D.as_expr(), form, L.variable, L.delay)
    yield _corners(form, L.variable)
    yield _heights(form)
    yield Step("picture", unclaimed="drawn from the numbers found above", late=L.late, delay=L.delay,
               figures=bode_figure("Bode diagram of $L$ with its asymptotes", ("L", L), asymptotes=True),
               negative=bool(form.gain < 0), power=form.power, rows=_turns(form, L.variable))  # fmt: skip
    return _answers(form)


def _of_parameters(loop: OpenLoop) -> Derivation[Answers]:
    """Form, corners and slopes where the signs and the order of the corners are known; no diagram without values."""
    s, L = loop.variable, exact.parametric_factors(loop.numerator, loop.denominator, loop.variable)
    form = exact.parametric_bode_form(L)
    yield _form(sp.cancel(loop.numerator / loop.denominator), form, s, loop.delay)
    form = exact.with_corners_in_order(form)
    yield _corners(form, s)
    yield Step("phases", unclaimed="read off the factors", late=loop.delay != 0, delay=loop.delay, power=form.power,
               negative=exact.decided_sign(form.gain) == -1, rows=_turns(form, s))  # fmt: skip
    return _answers(form)


def _answers(form: exact.BodeForm) -> Answers:
    return Answers(
        bode_gain=form.gain,
        corner_frequencies=form.frequencies,
        slopes=[sp.Integer(slope) for slope in form.slopes],
    )


def _form(rational: Expr, form: exact.BodeForm, s: Symbol, delay: Expr) -> Step:
    """L as the gain, the power of s and factors that are 1 at s = 0."""
    above = [
        power(each.factor, each.power) if each.power > 1 else each.factor for each in form.corners if each.power > 0
    ]
    below = [power(each.factor, -each.power) if each.power < -1 else each.factor
             for each in form.corners if each.power < 0]  # fmt: skip
    if form.power:
        (above if form.power > 0 else below).insert(0, s ** abs(form.power))
    top = product(form.gain, *above) if above else form.gain
    stated = quotient(top, product(*below) if len(below) > 1 else below[0]) if below else top
    return Step("form", claims={"form": Claim(rational, stated, "Bode's form")}, s=s, gain=form.gain,
                power=form.power, late=delay != 0, delay=delay, corners=form.corners)  # fmt: skip


def _corners(form: exact.BodeForm, s: Symbol) -> Step:
    """One row for each corner: what bends there, and the slope from there on."""
    rows = []
    for i, place in enumerate(form.places):
        here = [each for each in form.corners if each.omega == place]
        rows.append({"omega": place, "factors": here, "before": form.slopes[i], "after": form.slopes[i + 1],
                     "change": form.slopes[i + 1] - form.slopes[i]})  # fmt: skip
    return Step("corners", unclaimed="read off the factors; the answers have checks of their own", rows=rows,
                start=form.slopes[0], slopes=list(form.slopes), power=form.power, s=s)  # fmt: skip


def _heights(form: exact.BodeForm) -> Step:
    """The heights of the asymptotes at the corners in decibels, and how far the curve is from them."""
    first = form.places[0] if form.places else sp.S.One
    at = exact.in_decibels(abs(form.gain) * first**form.power)
    rows, level = [(first, at)], at
    for i in range(1, len(form.places)):
        here, before = form.places[i], form.places[i - 1]
        level = level + form.slopes[i] * sp.N(sp.log(here / before) / sp.log(10), 30)
        rows.append((here, level))
    pairs = [(each.omega, each.damping, exact.in_decibels(1 / (2 * abs(each.damping))) * -each.power)
             for each in form.corners if each.damping]  # fmt: skip
    single = [each for each in form.corners if each.damping is None]
    return Step("heights", unclaimed="the asymptotes carried on from corner to corner", rows=rows, gain=form.gain,
                power=form.power, pairs=pairs, single=bool(single), sharp=[each for each in form.corners
                                                                          if each.damping == 0])  # fmt: skip


def _turns(form: exact.BodeForm, s: Symbol) -> list[tuple[Expr, int]]:
    """How far each factor turns the phase, in degrees."""
    return [(each.omega, each.power * _angle(each, s)) for each in form.corners]


def _angle(corner: exact.Corner, s: Symbol) -> int:
    """90° for each root, backward for those in the right half plane."""
    if corner.damping is not None:
        return 180 if corner.damping == 0 else 180 * exact.decided_sign(corner.damping)
    return 90 * exact.decided_sign(sp.cancel((corner.factor - 1) / s))


ORACLE = "mpmath.polyroots"


def _numbers(given: Given[OpenLoop, LoopOptions], answers: Answers) -> list[tuple[judges.NumericLoop, dict[str, Any]]]:
    """The loop and the answers in numbers, at some values of the parameters."""
    loop = given.system
    formulas = (loop.numerator, loop.denominator, sp.S.Zero + loop.delay)
    found = []
    for values in judges.values_of_parameters(formulas, [loop.variable]):
        N, D, delay = (each.xreplace(values) for each in formulas)
        own = {name: [(sp.S.Zero + each).xreplace(values) for each in value] if isinstance(value, list | tuple)
               else (sp.S.Zero + value).xreplace(values) for name, value in answers.items()}  # fmt: skip
        found.append((judges.numeric_loop(N, D, loop.variable, delay), own))
    return found


@bode.verification("bode_gain", "corner_frequencies", "slopes")
def are_those_of_the_roots(given: Given[OpenLoop, LoopOptions], answers: Answers) -> Iterable[Check]:
    """The limit of L/s^N, the sizes of the roots, and how many of them lie below each corner."""
    points = _numbers(given, answers)
    if "bode_gain" in answers:
        residual = max(judges.bode_gain_residual(loop, own["bode_gain"]) for loop, own in points)
        yield Check.within("the limit of $L(s)/s^{N}$ for $s \\to 0$", "mpmath", residual, 1e-12, answer="bode_gain")
    if "corner_frequencies" in answers:
        residual = max(judges.corner_residual(loop, own["corner_frequencies"]) for loop, own in points)
        yield Check.within("the sizes of zeros and poles", ORACLE, residual, 1e-12, answer="corner_frequencies")
    if "slopes" in answers:
        fits = all(judges.are_slopes(loop, own["slopes"]) for loop, own in points)
        yield Check.that("20 dB a decade for each zero, less those for poles, below a corner", ORACLE, fits,
                         answer="slopes")  # fmt: skip


@bode.mistake(HERTZ, "corner_frequencies")
def in_hertz(wrong: Attempt[OpenLoop, LoopOptions]) -> Iterable[Any]:
    """The frequencies over 2π."""
    yield [sp.N(each / (2 * sp.pi), 30) for each in wrong.ours]


@bode.mistake(UNSCALED, "bode_gain")
def of_the_pole_zero_form(wrong: Attempt[OpenLoop, LoopOptions]) -> Iterable[Any]:
    """The quotient of the leading coefficients."""
    loop = wrong.given.system
    found = [sp.Poly(p, loop.variable).LC() for p in (loop.numerator, loop.denominator)]
    if found[0] / found[1] != wrong.ours:
        yield found[0] / found[1]


@bode.mistake(OCTAVE, "slopes")
def an_octave(wrong: Attempt[OpenLoop, LoopOptions]) -> Iterable[Any]:
    """6 dB for 20 dB."""
    yield [each * sp.Rational(3, 10) for each in wrong.ours]


@bode.mistake(TEN_LOG, "slopes")
def half_of_it(wrong: Attempt[OpenLoop, LoopOptions]) -> Iterable[Any]:
    """10 dB for 20 dB."""
    yield [each / 2 for each in wrong.ours]


@bode.mistake(POWERS, "slopes")
def in_powers(wrong: Attempt[OpenLoop, LoopOptions]) -> Iterable[Any]:
    """1 for 20 dB a decade."""
    yield [each / 20 for each in wrong.ours]


@bode.mistake(BENDS, "slopes")
def bent_the_other_way(wrong: Attempt[OpenLoop, LoopOptions]) -> Iterable[Any]:
    """From the first slope on up for poles and down for zeros."""
    yield [2 * wrong.ours[0] - each for each in wrong.ours]


@bode.mistake(REVERSED, "slopes")
def with_signs_reversed(wrong: Attempt[OpenLoop, LoopOptions]) -> Iterable[Any]:
    """Poles bend up."""
    yield [-each for each in wrong.ours]
