"""The increment of a functional and its variations."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Claim, Derivation, Given, Options, Step, Task
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import variations as judges
from solver.stated.algebra import difference, product, total
from solver.stated.calculus import denoted, partial_derivative, time_derivative
from solver.tasks.variations import variation_mistakes
from solver.tasks.variations.jets import following, jets_of, variations
from solver.words import Phrase, formula

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import Functional


@dataclass(frozen=True, kw_only=True)
class FunctionalVariationOptions(Options):
    """There are none."""


PHI = r"\varphi"
functional_variation: Task[Functional, FunctionalVariationOptions] = Task(
    "functional_variation",
    title="Variation of a functional",
    doc="The increment of a functional, and its first and second variation.",
    needs=("functional",),
    options=FunctionalVariationOptions,
    answers=[
        AnswerName("increment", r"\Delta", "the integrand of the increment, in $x$ and its variation"),
        AnswerName("first_variation", r"\varphi_1", "the integrand of the first variation", principal=True,
                   earned=("first_variation",)),
        AnswerName("second_variation", r"\varphi_2", "the integrand of the second variation, with its factor 1/2",
                   principal=True, earned=("second_variation",)),
    ],
)  # fmt: skip
variation_mistakes.register(functional_variation)


@functional_variation.method(source="Kirk, Optimal Control Theory, §4.1; Gelfand and Fomin, §3, §24")
def by_powers(given: Given[Functional, FunctionalVariationOptions]) -> Derivation[Answers]:
    """The increment by powers of the variation; the part of first degree, the part of second degree; by parts."""
    system = given.system
    changes = variations(system)
    found = exact.increment(system.integrand, changes)
    yield _increment(system, found, changes)
    first, second = (_sum(part) for part in found.parts[:2])
    yield _first(system, found.parts[0], changes)
    yield _second(system, found.parts[1], changes)
    if len(found.parts) > 2:
        yield Step("higher", unclaimed="parts of the increment", parts=[total(*part) for part in found.parts[2:]])
    if any(system.orders.values()):
        yield from _by_parts(system)
    whole = _sum([term for part in found.parts for term in part]) if found.whole else found.stands
    return Answers(increment=whole, first_variation=first, second_variation=second)


def _sum(terms: Iterable[Expr]) -> Expr:
    whole: Expr = sp.Add(*terms)
    return whole


def _stated(terms: Iterable[Expr]) -> Any:
    """The sum in the order of its terms."""
    listed = list(terms)
    return total(*listed) if len(listed) > 1 else sp.Add(*listed)


def _increment(system: Functional, found: exact.Increment, changes: dict[Symbol, Symbol]) -> Step:
    """φ at the changed functions less φ, multiplied out where that ends."""
    phi = system.integrand
    shifted = phi.xreplace({q: q + d for q, d in changes.items()})
    claims = {}
    if found.whole:
        terms = [term for part in found.parts for term in part]
        claims["increment"] = Claim(difference(shifted, phi), _stated(terms), "the increment multiplied out")
    return Step("increment", claims=claims, unclaimed="" if claims else "the definition of the increment", phi=phi,
                stands=difference(shifted, phi), start=system.start, stop=system.end_time)  # fmt: skip


def _first(system: Functional, part: tuple[Expr, ...], changes: dict[Symbol, Symbol]) -> Step:
    """The partial derivatives, each times its variation."""
    phi = denoted(PHI, system.integrand)
    claims, stated = {}, []
    for q, d in changes.items():
        partial = partial_derivative(phi, q)
        value = _sum(part).coeff(d)
        claims[f"partial_{q}"] = Claim(partial, value, Phrase("the derivative by ${q}$", q=formula(q)))
        stated.append(product(partial, d))
    claims["first"] = Claim(total(*stated), _stated(part), "the first variation")
    return Step(
        "first_variation",
        claims=claims,
        start=system.start,
        stop=system.end_time,
        partials=[claims[f"partial_{q}"] for q in changes],
    )


def _second(system: Functional, part: tuple[Expr, ...], changes: dict[Symbol, Symbol]) -> Step:
    """Half the second partial derivatives, each times a product of two variations."""
    phi, half = denoted(PHI, system.integrand), sp.Rational(1, 2)
    claims, stated = {}, []
    jets = list(changes)
    for i, q in enumerate(jets):
        for other in jets[i:]:
            value = sp.diff(system.integrand, q, other)
            if value == 0 and (q != other or len(jets) > 2):
                continue
            partial = partial_derivative(phi, q, 2) if q == other else partial_derivative(
                partial_derivative(phi, other), q)  # fmt: skip
            doubled = _sum(part).coeff(changes[q], 2) if q == other else _mixed(part, changes[q], changes[other])
            claims[f"partial_{q}_{other}"] = Claim(partial, doubled * (2 if q == other else 1), "a second derivative")
            square = changes[q] ** 2 if q == other else changes[q] * changes[other]
            stated.append(product(partial, square) if q == other else product(2, partial, square))
    claims["second"] = Claim(product(half, _stated_total(stated)), _stated(part), "the second variation")
    partials = [claim for name, claim in claims.items() if name != "second"]
    return Step("second_variation", claims=claims, partials=partials, mixed=len(partials) > len(jets),
                start=system.start, stop=system.end_time)  # fmt: skip


def _stated_total(stated: list[Any]) -> Any:
    return total(*stated) if len(stated) > 1 else stated[0] if stated else sp.S.Zero


def _mixed(part: tuple[Expr, ...], d: Symbol, other: Symbol) -> Expr:
    return _sum(part).coeff(d).coeff(other)


def _by_parts(system: Functional) -> Derivation[None]:
    """What stands beside δx after integration by parts, and what is left at the ends."""
    moves = following(system)
    phi, claims, factors, ends = denoted(PHI, system.integrand), {}, [], []
    for name in system.functions:
        jets = jets_of(system, name)
        found = exact.variational_derivative(system.integrand, jets, moves)
        d = variations(system)[jets[0]]
        for k, chain in enumerate(found.rates):
            inner, before = partial_derivative(phi, jets[k]), found.partials[k]
            for j, rate in enumerate(chain):
                inner, before = time_derivative(denoted(inner, before), moves.items()), rate
                if chain[-1] != 0 or j == 0:
                    claims[f"rate_{jets[k]}_{j}"] = Claim(inner, rate, "the chain rule")
        factors.append((d, found.expression))
        ends += [(momentum, variations(system)[jets[k]]) for k, momentum in enumerate(found.momenta) if momentum != 0]
    fixed = all(_is_fixed(system, name) for name in system.functions)
    cost = [(sp.diff(system.terminal_cost, q), d) for q, d in variations(system).items()]
    yield Step("by_parts", claims=claims, factors=factors, ends=ends, fixed=fixed, start=system.start,
               stop=system.end_time, order=max(system.orders.values()), constrained=bool(system.constraints),
               cost=[(value, d) for value, d in cost if value != 0])  # fmt: skip


def _is_fixed(system: Functional, name: str) -> bool:
    """Whether everything that varies at the ends is given there, at given times."""
    ends = [system.ends.get((name, k)) for k in range(max(system.orders[name], 1))]
    return system.stop is not None and all(pair and all(end.value is not None for end in pair) for pair in ends)


LABELS = {
    "increment": "the increment along random functions and variations",
    "first_variation": "the first variation along random functions and variations",
    "second_variation": "the second variation along random functions and variations",
}
ORACLE = "the functional along random functions, by quadrature; powers of the variation by Cauchy's formula"
EXACT = 1e-9
"""What doubles leave of it."""


@functional_variation.verification("increment", "first_variation", "second_variation")
def are_parts_of_the_increment(
    given: Given[Functional, FunctionalVariationOptions], answers: Answers
) -> Iterable[Check]:
    """The integrals of the answers are the increment, and what is of first and second degree in the variation."""
    system = given.system
    fixed = all(_is_fixed(system, name) for name in system.functions)
    for degree, (name, label) in enumerate(LABELS.items()):
        if name in answers:
            residual = judges.variation_residual(system, degree, answers[name], fixed=fixed)
            near = 1e-6 if numeric.holds_decimals([system.integrand, answers[name]]) else EXACT
            yield Check.within(label, ORACLE, residual, near, answer=name)
