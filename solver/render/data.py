"""A solution as JSON: the same keys in the same order for the same problem, every value readable by sympy."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import sympy as sp

from solver.derivation import Check, PartResult, Step
from solver.render.plain import sympy_text
from solver.render.view import PartView, SolutionView, view_of
from solver.render.wording import WordedStep
from solver.stated import Stated

if TYPE_CHECKING:
    from solver.engine import Solution
    from solver.problem.model import Part

VERSION = 1

KNOWN = frozenset({"s", "z", "t", "k", "lamda"})
"""Names whose meaning is fixed; they are not listed among the symbols."""

Data = dict[str, Any]


def render_json(solution: Solution, view: SolutionView | None = None) -> str:
    """Return the solution as JSON text; the steps are those of the view (by default at the level "full")."""
    return json.dumps(as_data(solution, view), ensure_ascii=False, allow_nan=False, indent=1) + "\n"


def as_data(solution: Solution, view: SolutionView | None = None) -> Data:
    """Return the solution as dictionaries, lists, texts and numbers."""
    view = view or view_of(solution)
    parts = {part.id: part for part in solution.problem.parts}
    pairs = zip(solution.parts, view.parts, strict=True)
    return {
        "version": VERSION,
        "title": view.title,
        "status": str(view.status),
        "symbols": _symbols(solution.parts, view.parts),
        "parts": [_part(result, shown, parts[result.id]) for result, shown in pairs],
    }


def _part(result: PartResult, shown: PartView, part: Part) -> Data:
    """Return one part by one method; `marks`, `reason` and `unchecked` stand only where there are any."""
    data: Data = {"id": result.id, "task": result.task, "method": result.method, "status": str(result.status)}
    if part.marks is not None:
        data["marks"] = int(part.marks) if part.marks.is_Integer else float(part.marks)
    if shown.reason:
        data["reason"] = shown.reason
    if shown.unchecked:
        data["unchecked"] = shown.unchecked
    data["answers"] = {
        answer.name: {"value": sympy_text(answer.value), "latex": answer.tex, "symbol": answer.symbol}
        for answer in shown.answers
    }
    data["checks"] = [_check(check) for check in result.checks]
    data["steps"] = [_step(step) for step in shown.steps]
    return data


def _check(check: Check) -> Data:
    data: Data = {
        "claim": check.claim,
        "oracle": check.oracle,
        "residual": _finite(check.residual),
        "tolerance": _finite(check.tolerance),
        "status": str(check.status),
    }
    return data | ({"reason": check.reason} if check.reason else {})


def _finite(number: float | None) -> float | None:
    """JSON has no nan and no infinity."""
    return float(number) if number is not None and math.isfinite(number) else None


def _step(worded: WordedStep) -> Data:
    return {
        "kind": worded.step.kind,
        "title": worded.title,
        "text": worded.markdown,
        "values": {name: sympy_text(value) for name, value in _values(worded.step).items()},
        "steps": [_step(step) for step in worded.steps],
    }


def _values(step: Step) -> Mapping[str, Any]:
    """Return the values of a step that are data, and what its claims found, by name."""
    found = {name: claim.right for name, claim in step.claims.items()}
    return {name: value for name, value in {**step.values, **found}.items() if _is_data(value)}


def _is_data(value: Any) -> bool:
    """Whether a value is mathematics (or a list of it) and not an object of the program."""
    if isinstance(value, list | tuple):
        return all(map(_is_data, value))
    return isinstance(value, sp.Basic | sp.MatrixBase | Stated | str | int | float)


def _symbols(results: Sequence[PartResult], shown: Sequence[PartView]) -> list[str]:
    """Return every free name of the answers and steps but those whose meaning is fixed, sorted."""
    names: set[str] = set()
    for result in results:
        names.update(_names(result.answers.values()))
    for part in shown:
        for worded in (each for step in part.steps for each in step.walk()):
            names.update(_names(_values(worded.step).values()))
    return sorted(names - KNOWN)


def _names(values: Iterable[Any]) -> Iterator[str]:
    """Yield the names of all free symbols."""
    for value in values:
        if isinstance(value, list | tuple):
            yield from _names(value)
        elif isinstance(value, Stated):
            yield from _names(value.operands)
        elif isinstance(value, sp.Basic | sp.MatrixBase):
            yield from (str(symbol) for symbol in value.free_symbols)
