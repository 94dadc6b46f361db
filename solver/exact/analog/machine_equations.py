"""The equations that a machine computes: first-order ones for its integrators, sums for what is read out; scaled.

A right side is a sum of variables, inputs and functions of time with constant coefficients, kept as a mapping from
these to the coefficients; the key 1 is the constant term, a constant voltage. In volts and machine time, X = L x and
τ = β t, a derivative is dX/dτ = (L/β) dx/dt, so that a coefficient a of the variable "in" in the derivative of the
variable "out" becomes (L_out/L_in) a/β; in a sum, which has no time, it becomes (L_out/L_in) a, and so does an initial
value with L_in = 1 (A. S. Jackson, Analog Computation, chapter 3).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.spectrum import DIGITS

TIME = sp.Symbol("t")
MACHINE_TIME = sp.Symbol("tau")
Terms = Mapping[sp.Expr, sp.Expr]
"""The coefficient of each variable, input, function of time, and of 1 (the constant), in their order; none is zero."""


class NotLinearCombination(ValueError):  # noqa: N818 - a case, no mishap
    """A right side is no sum of variables and inputs with constant coefficients; `term` is what is none."""

    def __init__(self, term: sp.Expr) -> None:
        super().__init__(str(term))
        self.term = term


@dataclass(frozen=True)
class Integrated:
    """variable' = Σ coefficient · term with its initial value: what one integrator computes."""

    variable: sp.Symbol
    terms: Terms
    initial: sp.Expr


@dataclass(frozen=True)
class Summed:
    """variable = Σ coefficient · term: what one summer computes, an output or a static relation."""

    variable: sp.Symbol
    terms: Terms


@dataclass(frozen=True)
class MachineEquations:
    """`integrated` in the order of the states, `summed` outputs and static relations, `inputs` those left as names.

    Variables are the symbols of the question (`x`, `x_dot`, `x1`), scaled ones `X1`, `X2`, … in the order of the
    states; functions of time are in t, scaled ones in tau. Terms of `summed` may be integrated variables, inputs,
    and summed variables above it.
    """

    integrated: tuple[Integrated, ...]
    summed: tuple[Summed, ...]
    inputs: tuple[sp.Symbol, ...]

    @property
    def variables(self) -> tuple[sp.Symbol, ...]:
        """The integrated variables, then the summed ones."""
        return (*(each.variable for each in self.integrated), *(each.variable for each in self.summed))


def machine_equations(
    rates: Mapping[sp.Symbol, sp.Expr],
    initial: Sequence[sp.Expr],
    sums: Mapping[sp.Symbol, sp.Expr],
    inputs: Mapping[sp.Symbol, sp.Expr | None],
) -> MachineEquations:
    """The derivatives of the states (in their order) with initial values, and sums, as linear combinations.

    `inputs` with a function of t are put in, with None they stay names. Raises NotLinearCombination.
    """
    known = {u: value for u, value in inputs.items() if value is not None}
    left = tuple(u for u in inputs if u not in known)
    variables = [*rates, *sums, *left]
    return MachineEquations(
        tuple(
            Integrated(x, linear_terms(rate.xreplace(known), variables), start)
            for (x, rate), start in zip(rates.items(), initial, strict=True)
        ),
        tuple(Summed(y, linear_terms(value.xreplace(known), variables)) for y, value in sums.items()),
        left,
    )


def linear_terms(expression: sp.Expr, variables: Sequence[sp.Symbol]) -> Terms:
    """Return the coefficients of a linear combination; of what is left, the functions of time with their factors."""
    found: dict[sp.Expr, sp.Expr] = {}
    rest = sp.expand(expression)
    for variable in variables:
        coefficient = sp.cancel(sp.diff(rest, variable))
        if coefficient.has(TIME, *variables):
            raise NotLinearCombination(coefficient * variable)
        if coefficient != 0:
            found[variable] = coefficient
    rest = sp.expand(begun(rest.xreplace(dict.fromkeys(variables, sp.S.Zero)), TIME))
    for term in sp.Add.make_args(rest):
        factor, function = term.as_independent(TIME, as_Add=False)
        if factor != 0:
            found[function] = sp.cancel(found.get(function, sp.S.Zero) + factor)
    return {term: c for term, c in found.items() if c != 0}


def begun(function: sp.Expr, time: sp.Symbol) -> sp.Expr:
    """A function for positive times: step(t) is 1, and step(2t − 2) is written step(t − 1)."""

    def step(inside: sp.Expr, *_: sp.Expr) -> sp.Expr:
        faster = sp.expand(inside).coeff(time, 1)
        if not faster.is_positive:
            return sp.Heaviside(inside)
        since = sp.expand(inside / faster)
        return sp.S.One if since.coeff(time, 0).is_nonnegative else sp.Heaviside(since)

    found: sp.Expr = function.replace(sp.Heaviside, step) if function.has(sp.Heaviside) else function  # type: ignore[assignment]
    return found


@dataclass(frozen=True)
class Scaling:
    """Volts per unit of each variable, and of inputs (those not named have 1), and β of τ = β t."""

    factors: Mapping[Any, sp.Expr]
    time_scale: sp.Expr

    def of(self, term: sp.Expr) -> sp.Expr:
        """L of what stands in a term: 1 of a constant, of a function of time and of an input without a factor."""
        return self.factors.get(term, sp.S.One)


def scale_factors(maxima: Mapping[sp.Symbol, sp.Expr], reference: sp.Expr) -> dict[sp.Symbol, sp.Expr]:
    """L = reference/maximum; 1 for what stays zero; of a transcendental number in `DIGITS` decimals."""
    return {
        x: in_decimals(sp.cancel(reference / in_decimals(value))) if value != 0 else sp.S.One
        for x, value in maxima.items()
    }


def in_decimals(value: sp.Expr) -> sp.Expr:
    """A number with functions or irrational powers in it in decimals; any other as it is."""
    powers = any(not power.exp.is_Rational for power in value.atoms(sp.Pow))
    found: sp.Expr = sp.N(value, DIGITS) if value.is_number and (powers or value.atoms(sp.Function)) else value
    return found


def scaled_symbols(equations: MachineEquations, scaling: Scaling) -> dict[Any, sp.Symbol]:
    """X1, X2, … of the states in their order, the others (summed variables, scaled inputs) in capitals: Y of y.

    An input without a factor keeps its name: its voltage is its value.
    """
    named: dict[Any, sp.Symbol] = {
        each.variable: sp.Symbol(f"X{i}", real=True) for i, each in enumerate(equations.integrated, 1)
    }
    for other in [each.variable for each in equations.summed] + [u for u in equations.inputs if u in scaling.factors]:
        named[other] = sp.Symbol(other.name[0].upper() + other.name[1:], real=True)
    return named


def scaled(equations: MachineEquations, scaling: Scaling) -> MachineEquations:
    """The equations in volts and machine time: each coefficient (L_out/L_in) a/β, in sums (L_out/L_in) a."""
    named, beta = scaled_symbols(equations, scaling), scaling.time_scale

    def terms_of(variable: sp.Symbol, terms: Terms, slower: sp.Expr) -> Terms:
        out = scaling.of(variable)
        return {
            named.get(term, begun(term.xreplace({TIME: MACHINE_TIME / beta}), MACHINE_TIME)): sp.cancel(
                (sp.S.One if term == variable else out / scaling.of(term)) * a / slower
            )
            for term, a in terms.items()
        }

    return MachineEquations(
        tuple(
            Integrated(
                named[x.variable], terms_of(x.variable, x.terms, beta), sp.cancel(scaling.of(x.variable) * x.initial)
            )
            for x in equations.integrated
        ),
        tuple(Summed(named[y.variable], terms_of(y.variable, y.terms, sp.S.One)) for y in equations.summed),
        tuple(named.get(u, u) for u in equations.inputs),
    )


def combined(terms: Terms) -> sp.Expr:
    """The sum that the terms are."""
    return sp.Add(*(a * term for term, a in terms.items()))
