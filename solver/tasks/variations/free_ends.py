"""Lemma: what a free end, or one on a curve, adds to the second variation.

With the solution u of Jacobi's equation that begins as variations do and has no zero up to the end, the least second
variation of those that end with h is w h², w = R u'/u + Q (Gelfand and Fomin, §29; Bliss, Lectures on the Calculus of
Variations, §§30–32).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient, total
from solver.stated.calculus import derivative, value_at
from solver.tasks.variations.conjugate_points import jets_along, second_variation_of

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import Functional
    from solver.tasks.variations.found_extremal import Extremal


@lemma("free_ends")
def sign_at_free_end(system: Functional, found: Extremal, name: str, u: Expr) -> Derivation[int | None]:
    """The sign of R u'/u + Q + ∂²(terminal cost)/∂x² at the end; None where it is not decided."""
    t, of, at = system.t, second_variation_of(system, found, name), found.t_f
    jets = jets_along(system, found)
    x = system.symbol((name, 0))
    cost = sp.diff(system.terminal_cost, x, 2).xreplace(jets).subs(t, at)
    slope, there, R, Q = (value.subs(t, at) for value in (sp.diff(u, t), u, of.R, of.Q))
    stated = total(quotient(product(value_at(of.R, t, at), value_at(derivative(u, t), t, at)), value_at(u, t, at)),
                   value_at(of.Q, t, at), cost)  # fmt: skip
    w = exact.tidy(sp.expand(sp.cancel(R * slope / there) + Q + cost))
    yield Step("free_end", claims={"end": Claim(stated, w, "the second variation at the free end")}, x=x, value=w,
               cost=cost, end=at, sign=(sign := exact.sign_of(w)))  # fmt: skip
    return sign


@lemma("free_ends")
def sign_of_moving_end(system: Functional, found: Extremal, name: str, u: Expr) -> Derivation[int | None]:
    """The sign of S''(t_f), S(T) the value along the extremal from the start to the curve at T."""
    t, at = system.t, found.t_f
    end = system.ends[name, 0][1]
    curve: Any = end.value if end.curve is None else end.curve
    jets = jets_along(system, found)
    x, rate, second = (system.symbol((name, k)) for k in range(3))

    def there(expression: Expr) -> Expr:
        return expression.xreplace(jets).subs(t, at)

    phi, c, p = system.integrand, sp.diff(curve, t).subs(t, at), there(rate)
    field = there(second) + (c - p) * exact.tidy(sp.cancel((sp.diff(u, t) / u).subs(t, at)))
    momentum = sp.diff(phi, rate)
    cost = sp.diff(system.terminal_cost.xreplace({x: curve}), t, 2).subs(t, at)
    drift = there(sp.diff(momentum, t)) + there(sp.diff(momentum, x)) * c + there(sp.diff(momentum, rate)) * field
    parts = [there(sp.diff(phi, t)), there(sp.diff(phi, x)) * c, there(momentum) * sp.diff(curve, t, 2).subs(t, at),
             (c - p) * drift, cost]  # fmt: skip
    value = exact.tidy(sp.expand(sp.Add(*parts)))
    terms = total(parts[0], product(there(sp.diff(phi, x)), c), parts[2], product(c - p, drift), cost)
    yield Step("moving_end", claims={"bend": Claim(terms, value, "the second derivative by the end time")}, value=value,
               field=field, curve=curve, end=at, x=x, on_curve=end.curve is not None,
               sign=(sign := exact.sign_of(value)))  # fmt: skip
    return sign
