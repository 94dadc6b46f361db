"""Lemma: the first point conjugate to the start, by Jacobi's equation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.jets import jet_symbol
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, total
from solver.stated.calculus import derivative, partial_derivative, value_at
from solver.tasks.variations.ordinary_equations import solution_of, way_of
from solver.tasks.variations.unknowns import Constants, unknown_of

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import Functional
    from solver.tasks.variations.found_extremal import Extremal


LETTER = "D"
"""Of the constants in the solution of Jacobi's equation; those of the extremal have C."""


@dataclass(frozen=True)
class FirstConjugate:
    """The first zero of the solution of Jacobi's equation (None: there is none), and the solution, where known.

    `reason` says why it is not decided, else it is empty.
    """

    point: Expr | None
    solution: Expr | None = None
    reason: str = ""


def jets_along(system: Functional, found: Extremal) -> dict[Symbol, Expr]:
    """The functions and their derivatives along the extremal, by their symbols."""
    highest = 2 * max(system.orders.values()) + 1
    return {
        system.symbol((name, k)): sp.diff(found.x[name], system.t, k)
        for name in system.functions
        for k in range(highest + 1)
    }


def second_variation_of(system: Functional, found: Extremal, name: str) -> exact.SecondVariation:
    """P, Q and R of one function along the extremal."""
    jets = jets_along(system, found)
    pair = [system.symbol((name, k)) for k in (0, 1)]
    return exact.second_variation(system.integrand, pair[0], pair[1], jets, system.t)


def stand_apart(system: Functional) -> bool:
    """Whether no second derivative of φ mixes two functions."""
    pairs = [[system.symbol((name, k)) for k in (0, 1)] for name in system.functions]
    return not any(
        sp.diff(system.integrand, a, b) != 0
        for i, one in enumerate(pairs)
        for other in pairs[:i]
        for a in one
        for b in other
    )


def name_of_variation(system: Functional) -> str:
    """U, or another letter that the question does not have."""
    taken = {*system.functions, *(str(symbol) for symbol in system.parameters)}
    return next(letter for letter in ("u", "v", "w", "h", "eta") if letter not in taken)


@lemma("conjugate_points")
def first_zero_of(system: Functional, found: Extremal, name: str) -> Derivation[FirstConjugate]:
    """Jacobi's equation of one function, its solution that begins as variations do, the first zero of that.

    Variations begin with u = 0 where the value at the start is given (then the zero is the conjugate point), else with
    R u' + Q u = 0.
    """
    t, letter, at = system.t, name_of_variation(system), system.start
    u = [jet_symbol((letter, k)) for k in range(3)]
    of = second_variation_of(system, found, name)
    equation = exact.jacobi_equation(of, u, t)
    yield _equation_step(system, found, of, name, u)
    fixed = begins_fixed(system, name)
    if not way_of([equation], [letter], t):
        signs = exact.signs_in_time(sp.factor(of.rest(t) / of.R), t, at, found.t_f)
        if fixed and signs is not None and signs <= {0, 1}:
            yield Step("no_zero", unclaimed="by the signs of its coefficients", u=u, stop=found.t_f)
            return FirstConjugate(None)
        return FirstConjugate(None, reason="jacobi")
    constants = Constants.beside((), [equation], LETTER)
    general = yield from solution_of(equation, unknown_of(letter, [equation]), t, constants)
    begin = (sp.S.Zero, sp.S.One) if fixed else (sp.S.One, exact.tidy((-of.Q / of.R).subs(t, at)))
    solution = exact.with_values(general, constants.found, t, at, begin)
    if solution is None:
        return FirstConjugate(None, reason="jacobi")
    claims = {
        "value": Claim(value_at(solution, t, at), begin[0], "the solution at the start"),
        "slope": Claim(value_at(derivative(solution, t), t, at), begin[1], "its slope there"),
    }
    yield Step("from_start", claims=claims, u=u[0], solution=solution, start=at, begin=begin, fixed=fixed)
    zero = exact.conjugate(solution, t, at, found.t_f) if fixed else exact.first_zero_from(solution, t, at, found.t_f)
    if zero is None:
        return FirstConjugate(None, solution, reason="zero")
    claims = {}
    if zero.point is not None and not zero.point.has(sp.Float):
        claims["zero"] = Claim(value_at(solution, t, zero.point), sp.S.Zero, "the first zero")
    yield Step("zero", claims=claims, unclaimed="" if claims else "where its zeros lie", u=u[0], point=zero.point,
               searched=zero.searched, start=at, name=system.symbol((name, 0)), fixed=fixed,
               several=len(system.functions) > 1)  # fmt: skip
    return FirstConjugate(zero.point, solution)


def begins_fixed(system: Functional, name: str) -> bool:
    """Whether the value at the start is given."""
    pair = system.ends.get((name, 0))
    return pair is not None and pair[0].value is not None


def _equation_step(system: Functional, found: Extremal, of: exact.SecondVariation, name: str, u: list[Symbol]) -> Step:
    """The coefficients of the second variation and Jacobi's equation."""
    t, jets = system.t, jets_along(system, found)
    x, rate = system.symbol((name, 0)), system.symbol((name, 1))
    claims = {}
    for key, (a, b) in {"P": (x, x), "Q": (x, rate), "R": (rate, rate)}.items():
        first = sp.diff(system.integrand, a)
        stated: Any = partial_derivative(first, b)
        for symbol, value in jets.items():
            if first.has(symbol) or symbol == b:
                stated = value_at(stated, symbol, value)
        claims[key] = Claim(stated, getattr(of, key), "a coefficient of the second variation")
    if of.Q != 0:
        claims["rest"] = Claim(difference(of.P, derivative(of.Q, t)), of.rest(t), r"$P - \dot{Q}$")
    if of.R.has(t):
        claims["slope"] = Claim(derivative(of.R, t), sp.diff(of.R, t), r"$\dot{R}$")
    terms = [(of.R, u[2]), (sp.diff(of.R, t), u[1]), (-of.rest(t), u[0])]
    return Step("jacobi", claims=claims, x=x, rate=rate, P=of.P, Q=of.Q, R=of.R, u=u,
                left=total(*(product(c, jet) for c, jet in terms if c != 0)),
                several=len(system.functions) > 1)  # fmt: skip
