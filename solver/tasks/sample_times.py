"""The sampling period of a question: an option, or a key of the system."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import Given, Refusal, Unsolved, option
from solver.options.sample_time import SampleTime
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import System


def sample_time_option() -> Any:
    """Return the field of the option `sample_time`: an `Expr` that is positive, or None where none is given."""
    return option(SampleTime(), "the sampling period T, a number or a name; the system may have it as a key instead")


def sample_time_refusals(system: System, options: Any, *, needed: bool = True) -> Iterable[Refusal]:
    """Yield what is wrong with the sampling period: it is `needed` and not given, or it is given twice, as different.

    For a task's `refusal`; where an answer does with no period, `needed` is false.
    """
    own, asked = system.sample_time, options.sample_time
    if own is None and asked is None and needed:
        yield "", Reason("sample_times/missing", {"discrete": system.discrete})
    if own is not None and asked is not None and (own - asked).equals(0) is False:
        yield "sample_time", Reason("sample_times/contradiction", {"own": own, "asked": asked})


def sample_time_of(given: Given[Any, Any]) -> Expr:
    """Return the sampling period of a question: the option, else the system's. Raises Unsolved where there is none."""
    found: Expr | None = given.options.sample_time
    found = given.system.sample_time if found is None else found
    if found is not None:
        return found
    raise Unsolved("sample_times/missing", discrete=given.system.discrete)
