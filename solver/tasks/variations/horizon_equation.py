"""Lemma: the Riccati differential equation entry by entry, and of a scalar its solution by separation of variables."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.calculus import derivative, value_at
from solver.tasks.variations.horizon_question import HorizonQuestion

if TYPE_CHECKING:
    from sympy import Expr


@lemma("horizon_equation")
def weights_of(asked: HorizonQuestion) -> Derivation[None]:
    """Show the cost and its weights."""
    yield Step(
        "weights",
        unclaimed="the weights are given",
        Q=asked.Q,
        R=asked.R,
        S=asked.S,
        T=asked.T,
        factor=asked.factor,
        ends_free=not any(asked.S.flat()),
    )


@lemma("horizon_equation")
def differential_equations_of(asked: HorizonQuestion) -> Derivation[list[Any]]:
    """−P' = AᵀP + PA − P B R⁻¹ Bᵀ P + Q by its entries; returns them as expressions that are zero."""
    P, n = asked.unknown, asked.order
    entries = exact.riccati_entries(asked.A, asked.G, asked.Q, P)
    stated = difference(asked.linear_part(P), asked.quadratic_part(P))
    places = [(i, j) for i in range(n) for j in range(i, n)]
    right = [entries[i, j] for i, j in places]
    yield Step(
        "equations",
        claims={"entries": Claim(stated, entries, "the right side of the Riccati equation")},
        P=P,
        rows=[(rate, value) for (_, rate), value in zip(asked.pairs, right, strict=True)],
        ends=[(entry, asked.S[i, j]) for (entry, _), (i, j) in zip(asked.pairs, places, strict=True)],
        T=asked.T,
        n=n,
        weighed=bool(asked.weight),
    )
    return [rate + value for (_, rate), value in zip(asked.pairs, right, strict=True)]


@dataclass(frozen=True)
class Scalar:
    """dp/dτ = q + 2a p − g p² with p = s at τ = 0, and the solution p(τ) found."""

    a: Expr
    g: Expr
    q: Expr
    s: Expr
    found: Expr

    @cached_property
    def root(self) -> Expr:
        """√(a² + g q), half the distance of the zeros times g."""
        return sp.sqrt(exact.tidy(self.a**2 + self.g * self.q))

    @cached_property
    def zeros(self) -> tuple[Expr, Expr]:
        """The zeros p₁ ≥ p₂ of the right side."""
        upper, lower = (exact.tidy((self.a + sign * self.root) / self.g) for sign in (1, -1))
        return upper, lower


@lemma("horizon_equation")
def scalar_solution(asked: HorizonQuestion, found: exact.FiniteHorizon) -> Derivation[None]:
    """The equation in τ = T − t, solved by separation: partial fractions, or 1/(p − p₁), or by its linear form."""
    p, tau = asked.unknown[0, 0], found.tau
    scalar = Scalar(asked.A[0, 0], asked.G[0, 0], asked.Q[0, 0], asked.S[0, 0], found.P[0, 0])
    right = sp.expand(scalar.q + 2 * scalar.a * p - scalar.g * p**2)
    yield Step("backwards", unclaimed="the equation above with t = T − τ", p=p, right=right, s=scalar.s)
    if scalar.g == 0:
        yield _linear(scalar, tau)
    elif exact.tidy(scalar.root) == 0:
        yield _double(scalar, p, tau)
    elif any(exact.tidy(scalar.s - zero) == 0 for zero in scalar.zeros):
        yield Step("rest", claims={"zero": Claim(value_at(right, p, scalar.s), sp.S.Zero, "it stays where it is")},
                   s=scalar.s, p=p)  # fmt: skip
    else:
        yield _factors(scalar, p, right)
        yield _separated(scalar, p)
        yield _integrated(scalar, p, tau)


def _linear(scalar: Scalar, tau: Any) -> Step:
    """Without an input that acts the equation is linear."""
    slope = total(scalar.q, product(2 * scalar.a, scalar.found))
    return Step("linear", claims={"rate": Claim(derivative(scalar.found, tau), slope, "the linear equation")},
                P=scalar.found, a=scalar.a)  # fmt: skip


def _double(scalar: Scalar, p: Any, tau: Any) -> Step:
    """Both zeros are the same: −1/(p − p₀) falls with the slope g."""
    zero = exact.tidy(scalar.a / scalar.g)
    start = scalar.s - zero
    claims = {"square": Claim(sp.expand(scalar.q + 2 * scalar.a * p - scalar.g * p**2),
                              product(-scalar.g, (p - zero) ** 2), "the right side is a square")}  # fmt: skip
    if start != 0:
        line = exact.tidy(scalar.g * tau + 1 / start)
        claims["line"] = Claim(quotient(1, difference(scalar.found, zero)), line, "its reciprocal is a line")
    return Step("double", claims=claims, p=p, zero=zero, g=scalar.g, start=start, P=scalar.found)


def _factors(scalar: Scalar, p: Any, right: Expr) -> Step:
    upper, lower = scalar.zeros
    stated = product(scalar.g, upper - p, p - lower)
    return Step("factors", claims={"factors": Claim(right, stated, "the factors of the right side")},
                p=p, upper=upper, lower=lower)  # fmt: skip


def _separated(scalar: Scalar, p: Any) -> Step:
    upper, lower = scalar.zeros
    apart = exact.tidy(upper - lower)
    parts = total(quotient(1, upper - p), quotient(1, p - lower))
    whole = quotient(1, product(upper - p, p - lower))
    claims = {
        "fractions": Claim(whole, product(exact.tidy(1 / apart), parts), "partial fractions"),
        "rate": Claim(product(scalar.g, difference(upper, lower)), exact.tidy(2 * scalar.root), "the rate"),
    }
    return Step("separated", claims=claims, p=p, g=scalar.g, rate=exact.tidy(2 * scalar.root))


def _integrated(scalar: Scalar, p: Any, tau: Any) -> Step:
    upper, lower = scalar.zeros
    start = exact.tidy((scalar.s - lower) / (upper - scalar.s))
    grown = start * sp.exp(exact.tidy(2 * scalar.root) * tau)
    ratio = quotient(difference(scalar.found, lower), difference(upper, scalar.found))
    claims = {
        "start": Claim(quotient(difference(scalar.s, lower), difference(upper, scalar.s)), start, "at the end"),
        "ratio": Claim(ratio, grown, "the integrated equation"),
    }
    general = quotient(p - lower, upper - p)
    return Step("integrated", claims=claims, p=p, general=general, grown=grown, start=start, P=scalar.found)
