"""Lemma: ordinary differential equations solved step by step, for whatever task meets them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import quotient
from solver.stated.calculus import derivative
from solver.tasks.variations.constant_coefficients import by_characteristic_equation
from solver.tasks.variations.equations_in_turn import Together, can_be_solved, solved_in_sequence
from solver.tasks.variations.separation import Ways, by_separation, ways_to_separate
from solver.tasks.variations.unknowns import Constants, Family, Unknown, unknown_of
from solver.tasks.variations.variable_coefficients import by_integrating_factor, by_powers

if TYPE_CHECKING:
    from sympy import Expr, Symbol

BEYOND = ""
"""The way of an equation that is not solved here."""


def way_of(equations: Sequence[Expr], unknowns: Sequence[str], t: Symbol, constants: Sequence[Symbol] = ()) -> str:
    """How equations would be solved, as "integrated", "constant_coefficients"; empty where they are beyond.

    Nonlinear ones of first order are "separable"; several ones are solved "in_turn".
    """
    if len(equations) != len(unknowns):
        return BEYOND
    if len(unknowns) == 1:
        unknown = unknown_of(unknowns[0], equations)
        way = _way(equations[0], unknown, t)[0]
        return way or ("separable" if _separable(equations[0], unknown, t, constants) is not None else BEYOND)
    system = _together(equations, unknowns)
    return "in_turn" if can_be_solved(system, t, lambda e, unknown: _way(e, unknown, t)[0]) else BEYOND


def _together(equations: Sequence[Expr], unknowns: Sequence[str]) -> Together:
    named = tuple(unknown_of(name, equations) for name in unknowns)
    return Together(tuple(enumerate(equations, 1)), named)


def _way(equation: Expr, unknown: Unknown, t: Symbol) -> tuple[str, exact.LinearForm | None]:
    """The way of one equation, and the sum that it is, where it is linear."""
    factors = exact.factors_that_vanish(equation, unknown.jets)
    form = exact.linear_form(factors[0], unknown.jets) if len(factors) == 1 else None
    if form is None or form.order == 0:
        return BEYOND, form
    if form.lowest == form.order:
        return ("integrated" if exact.integrated(form.right, t, form.order) else BEYOND), form
    if form.is_constant(t):
        return "constant_coefficients", form
    if form.order == 1:
        return ("integrating_factor" if exact.integrating_factor(form, t) else BEYOND), form
    if exact.euler_cauchy(form, t) is not None and _has_powers(form, t):
        return "euler_cauchy", form
    return ("reduced" if form.lowest > 0 and _can_be_reduced(form, t) else BEYOND), form


def _has_powers(form: exact.LinearForm, t: Symbol) -> bool:
    """Whether the roots of an Euler–Cauchy equation are known, and its right side is one of powers and logarithms."""
    found = exact.euler_cauchy(form, t)
    try:
        return found is not None and bool(exact.powers_of_time(found)) and exact.trials_in_powers(found, t) is not None
    except exact.NotExact:
        return False


def _can_be_reduced(form: exact.LinearForm, t: Symbol) -> bool:
    """Whether the equation for the lowest derivative that occurs is of first order, and can be integrated."""
    lower = exact.LinearForm(form.coefficients[form.lowest :], form.right)
    return lower.order == 1 and exact.integrating_factor(lower, t) is not None


def _separable(equation: Expr, unknown: Unknown, t: Symbol, constants: Sequence[Symbol]) -> Ways | None:
    """How the variables of an equation of first order are separated, where they can be."""
    if unknown.order_in(equation) != 1:
        return None
    numbering = Constants.beside(constants, [equation])
    return ways_to_separate(equation, unknown, t, constants, numbering.new())


@lemma("ordinary_equations")
def solved(
    equations: Sequence[Expr],
    unknowns: Sequence[str],
    t: Symbol,
    constants: Sequence[Symbol] = (),
    letter: str = "C",
) -> Derivation[list[Family]]:
    """The general solution of equations (expressions that are zero, as many as unknowns), branch by branch.

    Derivatives are the symbols of `jet_symbol`; `constants` stand in the equations and are constants of integration,
    new ones are called by the `letter` and a number. Raises Unsolved for what is beyond, with the equation.
    """
    numbering = Constants.beside(constants, equations, letter)
    if len(unknowns) > 1:
        functions = yield from solved_in_sequence(_together(equations, unknowns), t, numbering, solution_of)
        return [Family({name: functions[name] for name in unknowns}, tuple(numbering.found))]
    (name,), (equation,) = unknowns, equations
    unknown = unknown_of(name, equations)
    if _way(equation, unknown, t)[0] == BEYOND and (ways := _separable(equation, unknown, t, constants)) is not None:
        numbering.new()
        branches = yield from by_separation(ways, unknown, t, numbering)
        return [Family({name: each}, tuple(numbering.found)) for each in branches]
    function = yield from solution_of(equation, unknown, t, numbering)
    return [Family({name: function}, tuple(numbering.found))]


@lemma("ordinary_equations")
def solution_of(equation: Expr, unknown: Unknown, t: Symbol, constants: Constants) -> Derivation[Expr]:
    """The general solution of one linear equation; its constants are added to those there are."""
    way, form = _way(equation, unknown, t)
    if not way or form is None:
        raise Unsolved("ordinary_equations/beyond", equation=equation)
    if way == "euler_cauchy" and (powers := exact.euler_cauchy(form, t)) is not None:
        return (yield from by_powers(form, powers, unknown, t, constants))
    yield from _standard_form(equation, unknown, form, t)
    if way == "integrated":
        return (yield from _by_integration(form, unknown, t, constants))
    if way == "integrating_factor":
        return (yield from by_integrating_factor(form, unknown, t, constants))
    if way == "reduced":
        return (yield from _by_reduction(form, unknown, t, constants))
    return (yield from by_characteristic_equation(form, unknown, t, constants))


@lemma("ordinary_equations")
def _by_reduction(form: exact.LinearForm, unknown: Unknown, t: Symbol, constants: Constants) -> Derivation[Expr]:
    """The lowest derivative that occurs as the unknown, and its integrals."""
    lower = exact.LinearForm(form.coefficients[form.lowest :], form.right)
    rate = Unknown(unknown.name, unknown.jets[form.lowest :])
    yield Step("reduced", unclaimed="a name", derivative=rate.symbol, order=lower.order)
    slope = yield from by_integrating_factor(lower, rate, t, constants)
    lines = exact.LinearForm((*([sp.S.Zero] * form.lowest), sp.S.One), slope)
    if exact.integrated(slope, t, form.lowest) is None:
        raise Unsolved("ordinary_equations/beyond", equation=unknown.jets[form.lowest] - slope)
    return (yield from _by_integration(lines, unknown, t, constants))


@lemma("ordinary_equations")
def _standard_form(equation: Expr, unknown: Unknown, form: exact.LinearForm, t: Symbol) -> Derivation[None]:
    """The equation divided by the factor of its highest derivative, where it is not yet so."""
    left = form.of(unknown.jets)
    if any(sp.expand(equation + sign * (left - form.right)) == 0 for sign in (-1, 1)):
        return
    divisor = sp.factor(equation / (left - form.right))
    claim = Claim(quotient(equation, divisor), left - form.right, "the equation divided by a factor")
    yield Step("standard_form", claims={"divided": claim}, left=left, right=form.right, divisor=divisor,
               varies=divisor.has(t, *unknown.jets))  # fmt: skip


@lemma("ordinary_equations")
def _by_integration(form: exact.LinearForm, unknown: Unknown, t: Symbol, constants: Constants) -> Derivation[Expr]:
    """x⁽ⁿ⁾ = f(t) integrated n times, each time with a constant."""
    n, own = form.order, []
    lines: list[tuple[Any, Expr]] = [(unknown.jets[n], form.right)]
    claims = {}
    for times, primitive in enumerate(exact.integrated(form.right, t, n) or (), 1):
        own.append(constants.new())
        parts = [c * t ** (times - i) / sp.factorial(times - i) for i, c in enumerate(own, 1)]
        claims[f"slope{times}"] = Claim(
            derivative(sp.Add(primitive, *parts), t), lines[-1][1], "the derivative of what was found"
        )
        lines.append((unknown.jets[n - times], sp.Add(primitive, *parts)))
    yield Step("integrated", claims=claims, lines=lines, n=n, zero=form.right == 0, x=unknown.symbol)
    return lines[-1][1]
