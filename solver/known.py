"""What is known of the symbols of a part, applied to what it is about and to what it takes from earlier parts."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import fields, replace
from typing import Any

from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.problem.conditions import differences
from solver.problem.model import Chain, Part
from solver.problem.refusals import Refusal


def wrong_conditions(conditions: Iterable[Chain]) -> Iterator[Refusal]:
    """Yield what is wrong with conditions: those that contradict the ones before them, and those that say nothing."""
    said: tuple[Any, ...] = ()
    for i, chain in enumerate(conditions):
        told = tuple(each for each in differences(chain) if each.difference.free_symbols)
        said = (*said, *told)
        if exact.contradict(said):
            never = "this condition never holds" if len(said) == len(told) else ""
            yield f"conditions {i}", never or "this condition contradicts those before it"
            return
        if told and all(map(exact.always_holds, told)):
            yield f"conditions {i}", "this condition always holds, so it says nothing"


def symbols_of(part: Part) -> dict[str, Any]:
    """Return the symbols of a part by name, with what is assumed of them there."""
    system: Any = part.system
    told = [getattr(system, each.name) for each in fields(system)] + list(part.options.values())
    found = {symbol.name: symbol for value in told for symbol in getattr(value, "free_symbols", ())}
    return {**found, **part.symbols}


def named_alike(value: Any, symbols: Mapping[str, Any]) -> Any:
    """Return a value with the symbols of the part in place of others of the same names: of a part that knows less."""
    if isinstance(value, list | tuple):
        return type(value)(named_alike(each, symbols) for each in value)
    if isinstance(value, dict):
        return {name: named_alike(each, symbols) for name, each in value.items()}
    others = [each for each in getattr(value, "free_symbols", ()) if symbols.get(each.name, each) != each]
    return value.xreplace({each: symbols[each.name] for each in others}) if others else value


def has_real_entries(system: Any) -> bool:
    """Whether no matrix of a system has an imaginary number in it."""
    values = (getattr(system, each.name) for each in fields(system))
    return not any(value.has(sp.I) for value in values if hasattr(value, "shape"))


def signed(system: Any) -> Any:
    """Return a system with a − b in place of |a − b| where conditions say that it is positive."""
    values = {each.name: getattr(system, each.name) for each in fields(system)}
    changed = {name: exact.without_bars(value) for name, value in values.items() if hasattr(value, "xreplace")}
    written = {name: value for name, value in changed.items() if value is not values[name]}
    return replace(system, **written) if written else system
