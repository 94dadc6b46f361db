"""Lemma: what criteria of stability share that ask a polynomial without finding its roots."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Given, Refusal, Step, lemma, option
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.options.names import Names
from solver.stated.algebra import product
from solver.tasks.plant_options import LoopOptions
from solver.tasks.stability.parameter_region import parameter_region
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.systems import Polynomial, System


@dataclass(frozen=True, kw_only=True)
class CriterionOptions(LoopOptions):
    """What may vary."""

    parameter: tuple[str, ...] | None = option(
        Names(), "the parameter asked for in the condition (default: all); the others stay symbols"
    )


def has_no_such_parameter(system: System, options: CriterionOptions) -> Iterable[Refusal]:
    """The system must have the parameters asked for."""
    found = options.parameters_with(system)
    for name in options.parameter or ():
        if name not in found and not options.later:
            yield "parameter", Reason("stability/no_parameter", {"name": name})


@lemma("criterion")
def positive_lead(p: Polynomial) -> Derivation[tuple[Expr, ...]]:
    """The coefficients, the first made positive: by a change of all signs, or divided by it where it has none."""
    lead = p.coefficients[0]
    sign = exact.sign_of(lead)
    if sign == 1:
        return p.coefficients
    factor = sp.Integer(-1) if sign == -1 else 1 / lead
    changed = tuple(sp.cancel(c * factor) for c in p.coefficients)
    claim = Claim(product(factor, p.expression), polynomial_of(changed, p.variable), "the same roots")
    yield Step("lead", claims={"lead": claim}, negative=sign == -1, x=p.variable)
    return changed


def polynomial_of(coefficients: Sequence[Expr], x: Symbol) -> Expr:
    """The polynomial in x of coefficients, highest power first."""
    n = len(coefficients) - 1
    return sp.Add(*(c * x ** (n - i) for i, c in enumerate(coefficients)))


@lemma("criterion")
def symmetric_roots(
    coefficients: Sequence[Expr], x: Symbol, counts: exact.RootCounts, name: str = "p"
) -> Derivation[None]:
    """The factor of the roots that lie symmetrically to the origin, and where they are; nothing without such roots."""
    if len(counts.symmetric) < 2:
        return
    g, rest = (polynomial_of(each, x) for each in (counts.symmetric, counts.rest))
    claim = Claim(polynomial_of(coefficients, x), product(rest, g), "the factor of the symmetric roots")
    yield Step("symmetric", claims={"factors": claim}, g=g, degree=len(counts.symmetric) - 1, rest=rest, x=x, name=name,
               outside=counts.outside_symmetric, on=counts.on, total=counts.outside)  # fmt: skip


@lemma("criterion")
def condition_of(
    given: Given[Polynomial, CriterionOptions], positive: Sequence[Expr], *, of: str, special: bool
) -> Derivation[dict[str, Any]]:
    """What must be positive, solved for the parameter; nothing without parameters.

    `of` says what is positive: "first_column", "determinants" or "inequalities"; `special` that it never is.
    """
    parameters = given.system.parameters
    if not parameters:
        return {}
    names = given.options.parameter or ()
    wanted = [symbol for name in names for symbol in parameters if symbol.name == name]
    condition = exact.all_positive([sp.Integer(-1)] if special else list(positive), wanted)
    truth = "always" if condition is sp.true else "never" if condition is sp.false else ""
    undecided = [entry for entry in positive if exact.sign_of(entry) != 1]
    discrete = given.system.discrete
    yield Step(
        "condition",
        unclaimed="the answer, which has a check of its own",
        condition=condition,
        truth=truth,
        conditions=undecided,
        never=[entry for entry in undecided if exact.sign_of(entry) in (0, -1)],
        special=special,
        of=of,
        discrete=discrete,
        figures=parameter_region(() if special else positive, wanted, condition, discrete=discrete),
    )
    return {"condition": condition}


def companion(p: Polynomial) -> ImmutableMatrix:
    """A matrix whose eigenvalues are the roots, for the oracles."""
    return companion_of(p.coefficients)


def companion_of(coefficients: Sequence[Expr]) -> ImmutableMatrix:
    """The same of coefficients, highest power first."""
    n = len(coefficients) - 1
    last = [-c / coefficients[0] for c in reversed(coefficients[1:])]
    return sp.ImmutableMatrix([[int(j == i + 1) for j in range(n)] for i in range(n - 1)] + [last])


def has_parameters(system: Any) -> bool:
    """Whether a condition is asked for."""
    return bool(system.parameters)


def has_numbers(system: Any) -> bool:
    """Whether the question is decided, and roots are counted."""
    return not system.parameters
