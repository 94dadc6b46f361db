"""What must hold of the result of a kernel: said as claims, which the oracles evaluate for each call of a derivation.

Much of what a page says is no displayed equality: a rank, a sign, the columns that are independent, a table of pairs,
the case that was taken. So a kernel that finds such a thing has a function of its name here, in the module of its
topic; it gets the result and the arguments of a call, and yields claims, or checks where no equality says it. As it is
there for what was found in another way, it knows no kernel.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from typing import Any

from solver.derivation import Check, Claim, Step
from solver.lazy import Call, numeric
from solver.lazy import sympy as sp
from solver.stated import Stated

Postcondition = Callable[..., Iterable[Claim | Check]]


@cache
def postcondition_of(kernel: str) -> Postcondition | None:
    """Return what must hold of the results of a kernel; None where nothing is said of it."""
    modules = (import_module(f"{__name__}.{module.name}") for module in iter_modules(__path__))
    found = (vars(module).get(f"of_{kernel}") for module in modules)
    return next((function for function in found if function is not None), None)


def check_calls(calls: Iterable[Call], steps: Iterable[Step]) -> Iterator[Check]:
    """Check the results of the calls, each for the step that it was made for, beyond what the steps claim."""
    steps = list(steps)
    known = {_key(claim) for first in steps for step in first.walk() for claim in step.claims.values()}
    environments = numeric.Environments()
    judged: dict[Any, list[Any]] = {}
    for call in calls:
        if (postcondition := postcondition_of(call.kernel)) is None or _was_judged(call, judged):
            continue
        label, step = "what was found for it", min(call.step, len(steps))
        for each in postcondition(call.result, *call.arguments, **call.named):
            if isinstance(each, Check):
                yield each.displayed_in(step)
            elif (key := _key(each)) not in known:
                known.add(key)
                check = numeric.check_claim(each, each.says or label, environments=environments, shown=True)
                yield check.displayed_in(step)


def _was_judged(call: Call, judged: dict[Any, list[Any]]) -> bool:
    """Whether the same was found before for the same arguments; if not, it will have been from now on."""
    try:
        results = judged.setdefault((call.kernel, call.arguments, *sorted(call.named.items())), [])
    except TypeError:  # arguments that are lists
        return False
    if any(call.result is each for each in results) or call.result in results:
        return True
    results.append(call.result)
    return False


def _key(claim: Claim) -> tuple[Any, Any]:
    """What tells a claim from others; matrices of some steps are mutable."""
    return _frozen(claim.left), _frozen(claim.right)


def _frozen(value: Any) -> Any:
    if isinstance(value, Stated):
        return value.operation, tuple(map(_frozen, value.operands))
    return value.as_immutable() if isinstance(value, sp.MutableDenseMatrix) else value


__all__ = ["check_calls", "postcondition_of"]
