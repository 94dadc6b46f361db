"""Euler–Cauchy equations Σ γₖ Tᵏ x⁽ᵏ⁾ = f with T = t + c: powers Tᵐ solve them.

As functions of s = log T their solutions have an equation with constant coefficients (W. Walter, Ordinary Differential
Equations, §20).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import sympy as sp

from solver.exact.linear_algebra.affine import tidy
from solver.exact.variations.constant_coefficients import FundamentalSystem, Trial, fundamental_system, trials
from solver.exact.variations.linear_forms import LinearForm


@dataclass(frozen=True)
class EulerCauchy:
    """T = t + c, the factors γₖ, and the equation for x as a function of s = log T (monic)."""

    T: sp.Expr
    factors: tuple[sp.Expr, ...]
    in_logarithm: LinearForm
    s: sp.Symbol

    def back(self, function: sp.Expr) -> sp.Expr:
        """A function of s as one of t."""
        return function.xreplace({self.s: sp.log(self.T)})

    @property
    def falling(self) -> tuple[tuple[sp.Expr, int], ...]:
        """γₖ with k, the highest first: Tᵏ x⁽ᵏ⁾ gives m (m − 1) … (m − k + 1)."""
        return tuple((c, k) for k, c in reversed(list(enumerate(self.factors))) if c != 0)


def euler_cauchy(form: LinearForm, t: sp.Symbol) -> EulerCauchy | None:
    """The equation in this form; None where it is none, or has constant coefficients."""
    T = _moved_time(form, t)
    if T is None:
        return None
    n = form.order
    factors = [tidy(sp.cancel(c * T ** (n - k))) for k, c in enumerate(form.coefficients)]
    if any(c.has(t) for c in factors):
        return None
    m, s = sp.Dummy("m"), sp.Symbol("s")
    p = sp.Poly(sp.expand(sp.Add(*(c * sp.expand(sp.ff(m, k)) for k, c in enumerate(factors)))), m)
    right = sp.expand((form.right * T**n).xreplace({T: sp.exp(s)} if t != T else {t: sp.exp(s)}))
    right = sp.expand(sp.expand_log(right.xreplace({t: sp.exp(s) - (T - t)}), force=True))
    right = sp.powdenest(sp.expand_power_base(right, force=True), force=True).xreplace({sp.log(sp.exp(s)): s})
    low = [tidy(c.as_expr() if isinstance(c, sp.Poly) else c) for c in reversed(p.all_coeffs())]
    return EulerCauchy(T, tuple(factors), LinearForm(tuple(low), sp.expand(right)), s)


def _moved_time(form: LinearForm, t: sp.Symbol) -> sp.Expr | None:
    """T = t + c, from the denominator of a coefficient."""
    for c in form.coefficients[:-1]:
        below = sp.denom(sp.factor(sp.together(c)))
        for factor in sp.Mul.make_args(below):
            base = factor.as_base_exp()[0]
            slope = sp.diff(base, t)
            if slope != 0 and not slope.has(t):
                return sp.expand(base / slope)
    return None


def powers_of_time(found: EulerCauchy) -> FundamentalSystem:
    """The solutions Tᵐ, (log T)ʲ Tᵐ, Tᵅ cos(β log T), … of the homogeneous equation; raises NotExact."""
    system = fundamental_system(found.in_logarithm.coefficients, found.s)
    return replace(system, functions=tuple(found.back(f) for f in system.functions))


def trials_in_powers(found: EulerCauchy, t: sp.Symbol) -> tuple[Trial, ...]:
    """The trial functions for powers of T and of log T on the right side; raises NotExact for others."""
    n, T = len(found.factors) - 1, found.T

    def on_right(value: sp.Expr) -> sp.Expr:
        return sp.expand(found.back(value) / T**n) if t == T else found.back(value) / T**n

    return tuple(
        replace(each, right=on_right(each.right), function=found.back(each.function),
                equations=tuple((on_right(f), left, right) for f, left, right in each.equations))
        for each in trials(found.in_logarithm, found.s)
    )  # fmt: skip
