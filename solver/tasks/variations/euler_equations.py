"""Lemma: the equations of Euler and Lagrange of a functional, constraints adjoined by multipliers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.jets import jet_symbol
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.calculus import denoted, partial_derivative, time_derivative
from solver.tasks.variations.jets import following, jets_of
from solver.words import Phrase, formula

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import Functional

PHI, ADJOINED = r"\varphi", r"\varphi_a"


@dataclass(frozen=True)
class EulerEquation:
    """What is zero for one function, cleared of factors that never vanish, and the derivatives that led to it."""

    name: str
    left: Expr
    derivative: exact.VariationalDerivative


@dataclass(frozen=True)
class Stationary:
    """A functional with its constraints adjoined: φ, and the equations of its extremals.

    `functions` are those of the question, then the multipliers that vary with time; `constants` are the multipliers of
    integrals.
    """

    system: Functional
    phi: Expr
    equations: tuple[EulerEquation, ...] = field(default=())

    @cached_property
    def functions(self) -> tuple[str, ...]:
        """The functions that are sought, multipliers among them."""
        return (*self.system.functions, *self.system.multipliers[: len(self.system.constraints)])

    @cached_property
    def constants(self) -> tuple[Symbol, ...]:
        """The multipliers that are constant."""
        return tuple(jet_symbol((name, 0)) for name in self.system.multipliers[len(self.system.constraints) :])

    @cached_property
    def expressions(self) -> list[Expr]:
        """What is zero along an extremal: the equations, then the constraints."""
        return [*(each.left for each in self.equations), *map(constrained, self.system.constraints)]

    @cached_property
    def by_name(self) -> Mapping[str, exact.VariationalDerivative]:
        """The derivatives of φ by each function of the question."""
        return {each.name: each.derivative for each in self.equations}


def constrained(sides: tuple[Expr, Expr]) -> Expr:
    """What stands beside the multiplier of a constraint: f − x' of x' = f, and c of c = 0."""
    left, right = sides
    found: Expr = left if right == 0 else right - left
    return found


@lemma("euler_equations")
def adjoined_of(system: Functional) -> Derivation[Stationary]:
    """The integrand with what is constrained, each with its multiplier."""
    varying = [jet_symbol((name, 0)) for name in system.multipliers]
    bound = [*map(constrained, system.constraints), *(each.integrand for each in system.integral_constraints)]
    if not bound:
        return Stationary(system, system.integrand)
    stated = total(denoted(PHI, system.integrand), *(product(x, c) for x, c in zip(varying, bound, strict=True)))
    terms = [system.integrand, *(x * c for x, c in zip(varying, bound, strict=True))]
    claim = Claim(stated, _written(terms), "the integrand with multipliers")
    number = len(system.constraints)
    yield Step("adjoined", claims={"adjoined": claim}, varying=varying[:number], constant=varying[number:])
    return Stationary(system, sp.Add(*terms))


@lemma("euler_equations")
def euler_equations_of(adjoined: Stationary) -> Derivation[Stationary]:
    """For each function the derivatives of φ, what d/dt makes of them, and the equation."""
    system, equations = adjoined.system, []
    for name in system.functions:
        equations.append((yield from _equation_of(adjoined, name)))
    found = Stationary(system, adjoined.phi, tuple(equations))
    if len(found.expressions) > 1:
        yield Step("equations", unclaimed="those found above", equations=found.expressions,
                   constraints=len(system.constraints))  # fmt: skip
    return found


@lemma("euler_equations")
def _equation_of(adjoined: Stationary, name: str) -> Derivation[EulerEquation]:
    system, moves = adjoined.system, following(adjoined.system)
    jets = jets_of(system, name)
    phi = denoted(PHI if adjoined.phi == system.integrand else ADJOINED, adjoined.phi)
    found = exact.variational_derivative(adjoined.phi, jets, moves)
    claims = dict(_lines(phi, jets, found, moves))
    stated = [found.partials[0], *((-1) ** k * chain[-1] for k, chain in enumerate(found.rates) if k)]
    terms = [term for term in stated if term != 0]
    highest = [system.symbol((each, k)) for k in reversed(range(2 * max(system.orders.values()) + 1))
               for each in (name, *system.functions)]  # fmt: skip
    multipliers = [jet_symbol((each, k)) for each in system.multipliers for k in range(3)]
    cleared = exact.cleared(found.expression, highest, [system.t, *multipliers])
    if cleared.by != 1 or cleared.left != found.expression:
        claims["cleared"] = Claim(quotient(_stated(found, terms), cleared.by), cleared.left, "the equation divided")
    yield Step("equation", claims=claims, unclaimed="" if claims else "nothing is to be found", name=jets[0],
               jets=jets, phi=phi, raw=_stated(found, terms), signs=len(terms) > 1, left=cleared.left, by=cleared.by,
               lines=[claims[key] for key in claims if key != "cleared"], order=len(jets) - 1)  # fmt: skip
    return EulerEquation(name, cleared.left, found)


def _lines(
    phi: Any, jets: Sequence[Symbol], found: exact.VariationalDerivative, moves: Mapping[Symbol, Expr]
) -> Iterator[tuple[str, Claim]]:
    """The derivatives of φ by x, x', …, then what d/dt makes of those by derivatives."""
    for k, (q, partial) in enumerate(zip(jets, found.partials, strict=True)):
        says = Phrase("the derivative by ${q}$", q=formula(q))
        stated = partial_derivative(phi, q)
        yield f"partial{k}", Claim(stated, partial, says)
        before = partial
        for j, rate in enumerate(found.rates[k]):
            if partial == 0:
                break
            stated, before = time_derivative(denoted(stated, before), moves.items()), rate
            yield f"rate{k}_{j}", Claim(stated, rate, "the total derivative, by the chain rule")


def _stated(found: exact.VariationalDerivative, terms: Sequence[Expr]) -> Any:
    """∂φ/∂x − d/dt ∂φ/∂x' with both written out."""
    if not terms:
        return found.expression
    if len(terms) == 2 and terms[0] == found.partials[0] and -terms[1] in (chain[-1] for chain in found.rates[1::2]):
        return difference(terms[0], -terms[1])
    return total(*terms) if len(terms) > 1 else terms[0]


def _written(terms: Sequence[Expr]) -> Any:
    kept = [term for term in terms if term != 0]
    return total(*kept) if len(kept) > 1 else kept[0]
