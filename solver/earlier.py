"""What a part takes from earlier ones: answers as options, a system of an answer."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from solver.decimals import as_printed, exactly
from solver.derivation import PartResult, Unsolved
from solver.known import named_alike, symbols_of
from solver.lazy import sympy as sp
from solver.problem.model import Part, Reference
from solver.systems import EarlierPart

Earlier = Mapping[str, PartResult]
"""Results of earlier parts by the part's id, each by the part's first method."""


def resolved(part: Part, earlier: Earlier) -> Part:
    """Return a part with what it takes from earlier ones in place of the references to it. Raises Unsolved."""
    own = symbols_of(part)
    options = {name: named_alike(_resolved(name, value, earlier), own) for name, value in part.options.items()}
    return replace(part, system=_system_of(part, earlier, own), options=options)


def _system_of(part: Part, earlier: Earlier, own: Mapping[str, Any]) -> Any:
    """Return the system of a part, taken from the result of an earlier part where it refers to one."""
    system = part.system
    if not isinstance(system, EarlierPart):
        return system
    found = earlier[system.part].answers if system.part in earlier else {}
    answers = {name: named_alike(exactly(value), own) for name, value in found.items()}
    taken = system.taken(answers, named_alike(_resolved("gain", system.gain, earlier), own))
    if taken is None:
        raise Unsolved("conversions/no_earlier_system", part=system.part)
    return taken


def _resolved(option: str, value: Any, earlier: Earlier) -> Any:
    """Return the option's value, taken from an earlier part where it refers to one."""
    if not isinstance(value, Reference):
        return value
    source = earlier.get(value.part)
    if source is None or value.answer not in source.answers:
        raise Unsolved("engine/missing_answer", answer=value.answer, part=value.part, option=option)
    found = source.answers[value.answer]
    if value.item:
        if not isinstance(found, list) or value.item > len(found):
            raise Unsolved("engine/missing_item", item=value.item, answer=value.answer, part=value.part)
        point = found[value.item - 1]
        return exactly({**_held(source), **point} if isinstance(point, dict) else point)
    return as_printed(found) if isinstance(found, sp.MatrixBase) else found


def _held(source: PartResult) -> dict[Any, Any]:
    """Return the values of what a part keeps constant, which every point that it finds has beside its own."""
    return {name: value for step in source.steps for name, value in step.values.get("held", ())}


def rests_on_decimals(part: Part, earlier: Earlier) -> bool:
    """Whether a part takes decimals from an earlier one."""
    references = [*part.options.values(), getattr(part.system, "gain", None)]
    taken = [earlier[each.part].answers.get(each.answer) for each in references if isinstance(each, Reference)]
    if isinstance(part.system, EarlierPart):
        taken += earlier[part.system.part].answers.values()
    return any(hasattr(value, "has") and value.has(sp.Float) for each in taken for value in _listed(each))


def _listed(value: Any) -> list[Any]:
    if isinstance(value, dict):
        return list(value.values())
    return [part for each in value for part in _listed(each)] if isinstance(value, list) else [value]
