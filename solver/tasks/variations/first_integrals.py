"""Lemma: first integrals of the equation of Euler and Lagrange, where they shorten the work."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product
from solver.stated.calculus import denoted, partial_derivative
from solver.tasks.variations.euler_equations import PHI
from solver.tasks.variations.ordinary_equations import solved, way_of
from solver.tasks.variations.unknowns import Family

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.tasks.variations.euler_equations import Stationary

INTEGRATED = "integrated"


@lemma("first_integrals")
def general_solution_of(found: Stationary) -> Derivation[list[Family]]:
    """The extremals with constants: of the equations, or of a first integral where that is shorter."""
    t = found.system.t
    integral = _integral(found)
    if integral is None:
        return (yield from solved(found.expressions, found.functions, t))
    constant = sp.Symbol("C1", real=True)
    (name,) = found.functions
    if integral == "algebraic":
        return (yield from _algebraic(found, name))
    if integral == "cyclic":
        momentum = found.by_name[name].momenta[0]
        yield Step("cyclic", unclaimed="the equation integrated once", momentum=momentum, constant=constant,
                   x=found.system.symbol((name, 0)), rate=found.system.symbol((name, 1)))  # fmt: skip
        families = yield from solved([momentum - constant], [name], t, (constant,))
    else:
        value = yield from _beltrami(found, name, constant)
        families = yield from solved([value - constant], [name], t, (constant,))
    return [family for family in families if _keeps(family, found)]


def _integral(found: Stationary) -> str | None:
    """The first integral by which to go: "cyclic" without x, "beltrami" without t; None: by the equation itself.

    "algebraic" is an equation without derivatives, which is solved as it stands.
    """
    if len(found.functions) == 1 and found.expressions[0].free_symbols.isdisjoint(_derivatives(found)):
        return "algebraic"
    if len(found.functions) != 1 or max(found.system.orders.values()) != 1:
        return None
    (name,), (equation,), t = found.functions, found.expressions, found.system.t
    way = way_of([equation], [name], t)
    x, rate = found.system.symbol((name, 0)), found.system.symbol((name, 1))
    if way == INTEGRATED or not found.phi.has(rate):
        return None
    if not found.phi.has(x):
        return "cyclic"
    return None if way or found.phi.has(t) else "beltrami"


def _derivatives(found: Stationary) -> set[Symbol]:
    highest = 2 * max(found.system.orders.values())
    return {found.system.symbol((name, k)) for name in found.functions for k in range(1, highest + 1)}


@lemma("first_integrals")
def _algebraic(found: Stationary, name: str) -> Derivation[list[Family]]:
    """An equation without derivatives holds at each time by itself: it has no constants."""
    (equation,), x = found.expressions, found.system.symbol((name, 0))
    if not exact.are_linear_in([equation], [x]):
        raise Unsolved("ordinary_equations/beyond", equation=equation)
    value: Expr = sp.factor(-equation.xreplace({x: sp.S.Zero}) / sp.diff(equation, x))
    claim = Claim(equation.xreplace({x: value}), sp.S.Zero, "the function put into the equation")
    yield Step("algebraic", claims={"solved": claim}, x=x, value=value)
    return [Family({name: value}, ())]


@lemma("first_integrals")
def _beltrami(found: Stationary, name: str, constant: Symbol) -> Derivation[Expr]:
    """φ − x' ∂φ/∂x' is constant where t does not occur in φ."""
    x, rate = found.system.symbol((name, 0)), found.system.symbol((name, 1))
    phi = denoted(PHI, found.phi)
    value: Expr = sp.factor(sp.together(found.phi - rate * found.by_name[name].momenta[0]))
    stated = difference(phi, product(rate, partial_derivative(phi, rate)))
    yield Step("beltrami", claims={"beltrami": Claim(stated, value, "Beltrami's integral")}, x=x, rate=rate,
               constant=constant)  # fmt: skip
    return value


def _keeps(family: Family, found: Stationary) -> bool:
    """Whether a branch satisfies the equation itself: a constant satisfies Beltrami's integral in any case."""
    (name,), t = found.functions, found.system.t
    function = family.functions[name]
    if function.has(t):
        return True
    still = {found.system.symbol((name, k)): sp.S.Zero for k in (1, 2)} | {found.system.symbol((name, 0)): function}
    return all(exact.is_zero(each.xreplace(still)) for each in found.expressions)
