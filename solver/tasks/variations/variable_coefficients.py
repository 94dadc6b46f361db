"""Lemmas: linear equations whose coefficients vary: Euler–Cauchy, and those of first order by an integrating factor."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import power, product, total
from solver.stated.calculus import derivative
from solver.tasks.variations.constant_coefficients import carried_out, split_of, trial_steps

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.tasks.variations.unknowns import Constants, Unknown


@lemma("variable_coefficients")
def by_powers(
    form: exact.LinearForm, found: exact.EulerCauchy, unknown: Unknown, t: Symbol, constants: Constants
) -> Derivation[Expr]:
    """An Euler–Cauchy equation: powers of t are tried, then a particular solution for each part of the right side."""
    try:
        system = exact.powers_of_time(found)
        trials = exact.trials_in_powers(found, t)
    except exact.NotExact:
        raise Unsolved("ordinary_equations/right_side", right=form.right) from None
    m = sp.Symbol("m")
    p = sp.Add(*(c * m**i for i, c in enumerate(found.in_logarithm.coefficients)))
    falling = total(*(product(c, *(m - i for i in range(k))) for c, k in found.falling))
    factors = product(*(power(m - root.value, root.multiplicity) for root in system.roots))
    claims = {"indicial": Claim(falling, p, "the indicial equation"), "roots": Claim(p, factors, "its roots")}
    if (split := split_of(system, m)) is not None:
        claims["split"] = Claim(p, split, "in factors")
    yield Step("indicial", claims=claims, x=unknown.symbol, T=found.T, p=p, split=split, falling=falling, m=m,
               roots=system.roots, homogeneous=form.right == 0, left=_cleared(found, unknown),
               right=sp.expand(form.right * found.T**form.order))  # fmt: skip
    own = [constants.new() for _ in system.functions]
    free = sp.Add(*(c * f for c, f in zip(own, system.functions, strict=True)))
    claim = Claim(carried_out(form.coefficients, free, t), sp.S.Zero, "the homogeneous equation")
    yield Step("powers", claims={"solves": claim}, x=unknown.symbol, solution=free, alone=form.right == 0, T=found.T,
               repeated=any(root.multiplicity > 1 for root in system.roots), exceptions=system.exceptions,
               pairs=any(root.kind == "complex" for root in system.roots))  # fmt: skip
    if form.right == 0:
        return free
    particular = yield from trial_steps(form, trials, unknown, t)
    whole = sp.Add(free, particular)
    claim = Claim(carried_out(form.coefficients, whole, t), form.right, "the equation")
    yield Step("sum", claims={"solves": claim}, x=unknown.symbol, solution=whole)
    return whole


def _cleared(found: exact.EulerCauchy, unknown: Unknown) -> Any:
    """The left side with its powers of T."""
    return total(*(product(c, found.T**k, unknown.jets[k]) for c, k in found.falling))


@lemma("variable_coefficients")
def by_integrating_factor(
    form: exact.LinearForm, unknown: Unknown, t: Symbol, constants: Constants
) -> Derivation[Expr]:
    """x' + p(t) x = q(t) times e^{∫p dt} is the derivative of a product."""
    found = exact.integrating_factor(form, t)
    if found is None:
        raise Unsolved("ordinary_equations/beyond", equation=form.of(unknown.jets) - form.right)
    p, q = form.coefficients[0], form.right
    c = constants.new()
    solution = sp.expand((found.integral + c) / found.factor)
    claims = {
        "exponent": Claim(derivative(found.exponent, t), p, "the exponent of the factor"),
        "integral": Claim(derivative(found.integral, t), sp.Mul(found.factor, q), "the integral of the right side"),
        "solves": Claim(total(derivative(solution, t), product(p, solution)), q, "the equation"),
    }
    yield Step("integrating_factor", claims=claims, x=unknown.symbol, p=p, exponent=found.exponent, factor=found.factor,
               right=found.right, integral=found.integral + c, solution=solution, rate=unknown.jets[1])  # fmt: skip
    return solution
