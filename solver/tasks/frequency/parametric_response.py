"""Lemma: the frequency response with parameters, factor by factor: sizes are multiplied, angles are added."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import power, product, quotient, total
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute, phase
from solver.tasks.frequency.steady import Passed, axis_of, constant_through, dies_out, input_of, steady_answers

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sympy import Expr

    from solver.systems import OpenLoop
    from solver.tasks.frequency.frequency_response import ResponseOptions


def has_parameters(loop: OpenLoop, options: ResponseOptions) -> bool:
    """Whether a letter without a value stands in a continuous loop or the frequency, also that of an input."""
    time, asked = sp.Symbol("t"), [options.frequency]
    if options.input is not None:
        asked = [wave.args[0].coeff(time) for wave in options.input.atoms(sp.sin, sp.cos)]
    letters = set(loop.parameters) - {loop.variable}
    return not loop.discrete and bool(letters.union(*(each.free_symbols for each in asked if each is not None)))


def of_parameters(loop: OpenLoop, options: ResponseOptions, above: Expr, below: Expr) -> Derivation[Answers]:
    """Magnitude and phase as functions of ω, at a frequency, or what is left of the output for a sinusoid."""
    T = exact.parametric_factors(above, below, loop.variable)
    if options.input is not None:
        given = input_of(options.input)
        yield from _settles(loop, several=given.several)
        at_rest = sp.cancel((above / below).subs(loop.variable, 0))
        return (yield from steady_answers(
            given, lambda omega: _passed(T, omega, loop.delay, several=given.several),
            lambda: constant_through(_formula(T), T.s, sp.S.Zero, at_rest)))  # fmt: skip
    if options.frequency is not None:
        magnitude, angle = yield from _value(T, options.frequency, loop.delay)
        return Answers(magnitude=magnitude, phase=angle)
    magnitude, angle = yield from _value(T, sp.Symbol("omega", positive=True), loop.delay, function=True)
    answers = Answers(magnitude=magnitude, phase=angle)
    band = yield from _bandwidth(T)
    if band is not None:
        answers["bandwidth"] = band
    return answers


def _passed(T: exact.ParametricFactors, omega: Expr, delay: Expr, *, several: bool) -> Derivation[Passed]:
    magnitude, angle = yield from _value(T, omega, delay, several=several)
    return Passed(magnitude, angle, sp.expand(angle * sp.pi / 180))


@lemma("parametric_response")
def _value(
    T: exact.ParametricFactors, omega: Expr, delay: Expr, *, function: bool = False, several: bool = False
) -> Derivation[tuple[Expr, Expr]]:
    """Each factor at jω, then the quotient of the sizes and the sum of the angles."""
    if exact.decided_sign(omega) < 0:
        raise Unsolved("frequency/sign_not_known", what=omega)
    rows = T.at(omega)
    for each in rows:
        if each.value == 0:
            reason = "frequency/zero_at_the_frequency" if each.power > 0 else "frequency/pole_at_the_frequency"
            raise Unsolved(reason, omega=omega)
    claims = {}
    for i, each in enumerate(rows, 1):
        at = value_at(each.factor, T.s, sp.I * omega)
        claims[f"value{i}"] = Claim(at, each.value, "the value of a factor")
        claims[f"size{i}"] = Claim(absolute(each.value), each.size, "the size of a factor")
        claims[f"angle{i}"] = Claim(phase(each.value), each.degrees, "the angle of a factor")
    yield Step(
        "factors",
        claims=claims,
        rows=rows,
        omega=omega,
        s=T.s,
        function=function,
        T=_formula(T),
        letter=sp.Symbol("omega"),
        axis=axis_of(omega),
    )
    return (yield from _together(rows, omega, delay, function=function, several=several))


@lemma("parametric_response")
def _together(
    rows: Sequence[exact.FactorOnAxis], omega: Expr, delay: Expr, *, function: bool, several: bool
) -> Derivation[tuple[Expr, Expr]]:
    """The quotient of the sizes and the sum of the angles; as functions in the ω of the answers."""
    if function:
        plain = {omega: sp.Symbol("omega")}
        omega, rows = (
            plain[omega],
            [replace(each, size=each.size.xreplace(plain), degrees=each.degrees.xreplace(plain)) for each in rows],
        )
    magnitude = sp.Mul(*(each.size**each.power for each in rows))
    late = sp.cancel(180 * omega * delay / sp.pi)
    terms = [each.degrees if each.power == 1 else product(sp.Integer(each.power), each.degrees)
             for each in rows if each.degrees != 0]  # fmt: skip
    terms += [] if delay == 0 else [product(sp.Integer(-1), late)]
    whole = sp.Add(*(each.degrees * each.power for each in rows)) - late
    angle = whole - 360 * sp.ceiling((whole - 180) / 360) if whole.is_Rational else whole
    stated = {"magnitude": Claim(_sizes(rows), magnitude, "the sizes multiplied")}
    if len(terms) > 1:
        stated["sum"] = Claim(total(*terms), whole, "the sum of the angles")
    if angle != whole:
        stated["turned"] = Claim(total(whole, angle - whole), angle, "the phase between −180° and 180°")
    yield Step("together", claims=stated, magnitude=magnitude, angle=angle, delay=delay, several=several)
    return magnitude, angle


def _formula(T: exact.ParametricFactors) -> Expr:
    """T(s) by its factors."""
    return sp.Mul(T.number, *((sp.Add(*(c * T.s**i for i, c in enumerate(reversed(f))))) ** m for f, m in T.factors))


def _sizes(rows: Sequence[exact.FactorOnAxis]) -> Any:
    """The sizes above over those below the bar."""
    above, below = ([power(each.size, abs(each.power)) if abs(each.power) > 1 else each.size
                     for each in rows if each.power * sign > 0] for sign in (1, -1))  # fmt: skip
    top = product(*above) if len(above) > 1 else above[0] if above else sp.S.One
    if not below:
        return top
    return quotient(top, product(*below) if len(below) > 1 else below[0])


def _settles(loop: OpenLoop, *, several: bool) -> Derivation[None]:
    """By the signs of Routh's first column the system is stable; raises Unsolved where it is not, or not known."""
    whole = loop.numerator + loop.denominator if loop.closed else loop.denominator
    listed = sp.Poly(whole, loop.variable).all_coeffs()
    column = exact.routh(listed).first_column if len(listed) > 1 else ()
    for each in column:
        sign = exact.sign_of(sp.cancel(each / listed[0]))
        if sign is None:
            raise Unsolved("frequency/stability_not_known", p=whole, what=sp.factor(each / listed[0]))
        if sign != 1:
            raise Unsolved("frequency/never_steady", p=whole, closed=loop.closed, discrete=False)
    yield from dies_out(whole, closed=loop.closed, discrete=False, several=several)


@lemma("parametric_response")
def _bandwidth(T: exact.ParametricFactors) -> Derivation[Expr | None]:
    """Of c/(a s + b) and c/(a s² + b s + d) where |T| = |T(0)|/√2; None for others."""
    if len(T.factors) != 1 or T.factors[0][1] != -1 or len(T.factors[0][0]) > 3 or T.factors[0][0][-1] == 0:
        return None
    (coefficients, _), w, omega = T.factors[0], sp.Symbol("w"), sp.Symbol("omega", positive=True)
    level = sp.cancel(T.number / coefficients[-1])
    level = (level if exact.decided_sign(level) > 0 else -level) / sp.sqrt(2)
    *_, b, d = (sp.S.Zero, *coefficients)
    a = coefficients[0] if len(coefficients) == 3 else sp.S.Zero
    square = sp.expand(a**2 * w**2 + (b**2 - 2 * a * d) * w + d**2)
    if a == 0:
        root = sp.cancel(d**2 / b**2)
    else:
        middle = sp.factor((2 * a * d - b**2) / (2 * a**2))
        root = middle + sp.sqrt(sp.factor(middle**2 + d**2 / a**2))
    band = sp.sqrt(root)
    claims = {
        "square": Claim(power(absolute(value_at(_formula_of(coefficients, T.s), T.s, sp.I * omega)), 2),
                        square.xreplace({w: omega**2}), "the square of the size"),
        "root": Claim(value_at(square, w, root), 2 * d**2, "twice the value at 0"),
        "level": Claim(absolute(value_at(_formula(T), T.s, sp.I * band)), level, "the magnitude there"),
    }  # fmt: skip
    yield Step("bandwidth", claims=claims, square=square, w=w, root=root, omega=band, level=level, twice=2 * d**2)
    return band


def _formula_of(coefficients: Sequence[Expr], s: Expr) -> Expr:
    return sp.Add(*(c * s**i for i, c in enumerate(reversed(coefficients))))


__all__ = ["has_parameters", "of_parameters"]
