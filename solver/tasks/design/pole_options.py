"""The poles asked for: the option `poles`, or two specifications of the step response, or both."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Derivation, Given, Refusal, option
from solver.lazy import exact, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import design as judges
from solver.options.poles import Poles
from solver.tasks.design.desired_poles import NAMES, StepSpecifications, band, faults, second_order_of, specified
from solver.tasks.design.mapped_poles import (
    SampledPoles,
    listed,
    mapped_poles,
    mapping_faults,
    numeric_poles_in_z,
    poles_in_z,
)
from solver.tasks.sample_times import sample_time_of
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, Symbol

PLACING = (
    "desired",
    "gain_polynomial",
    "equations",
    "coefficients",
    "ackermann_row",
    "ackermann_polynomial",
    "canonical_rows",
    "all_inputs",
)
"""Steps that earn the marks of a gain, by any method of placing poles."""


@dataclass(frozen=True, kw_only=True)
class PoleOptions(StepSpecifications, SampledPoles):
    """The poles of the closed loop, or what is asked of its step response."""

    poles: tuple[Expr, ...] | None = option(
        Poles(), "poles of the closed loop: all n, or only those of the controllable part"
    )


def variable(system: systems.System) -> Symbol:
    """The variable of polynomials: s, or z in discrete time."""
    return sp.Symbol("z" if system.discrete else "s")


def asked_poles(given: Given[Any, PoleOptions]) -> Derivation[list[Expr]]:
    """Return the poles asked for; two from the specifications, where these are given, are worked out.

    Those of a discrete plant are mapped to z where they are given in s, by themselves or by specifications.
    """
    options = given.options
    poles = yield from poles_in_z(given)
    if not specified(options):
        return poles
    found = yield from second_order_of(options)
    pair = list(found.poles)
    if given.system.discrete:
        pair = yield from mapped_poles(pair, sample_time_of(given))
    return [*pair, *poles]


def numeric_poles(given: Given[Any, PoleOptions]) -> list[Any]:
    """Return the poles asked for without the exact kernels, in decimals where specifications give them."""
    options = given.options
    poles = numeric_poles_in_z(given)
    if specified(options):
        pair = judges.second_order_poles(specified(options), band(options))
        if given.system.discrete:
            pair = judges.sampled_poles(pair, sample_time_of(given))
        poles = [*pair, *poles]
    return poles


def pole_faults(system: Any, options: PoleOptions, extra: int = 0) -> Iterable[Refusal]:
    """Return what is wrong with the poles asked for; `extra` states (integrators) come to those of the plant."""
    if specified(options):
        yield from faults(options)
    elif not any(options.has(name) for name in ("poles", "s_poles", *NAMES)):
        yield "", Reason("placement/no_poles")
    wrong = [*mapping_faults(system, options, others=bool(specified(options)))]
    yield from wrong
    name, given = listed(options)
    count = len(given or ()) + 2 * bool(specified(options))
    unknown = options.later & {"poles", "s_poles", *NAMES}
    if wrong or unknown or not count or not isinstance(system, systems.StateSpace) or system.B is None:
        return
    allowed = _numbers_of_poles(system, options) if not extra else {system.order + extra}
    if count not in allowed:
        where = name if given else next(iter(specified(options)), "")
        numbers = {"n": system.order + extra, "all": max(allowed), "some": min(allowed), "count": count}
        yield where, Reason("placement/number_of_poles", numbers)


def _numbers_of_poles(system: systems.StateSpace, options: PoleOptions) -> set[int]:
    """Return n, and the number of poles that the gain can move."""
    n, B = system.order, system.B
    assert B is not None  # noqa: S101 - the caller has seen to it
    structure = getattr(options, "structure", None)
    try:
        if structure and len(structure) == n and B.cols == 1:
            row = sp.ImmutableMatrix([list(structure)])
            unknowns = sorted(row.free_symbols - set(system.parameters), key=str)
            return {n, n + 1 - len(exact.fixed_factor(system.A, B, row, unknowns))}
        return {n, exact.reachable_order(system.A, B) or n}
    except exact.NotExact:
        return {n}
