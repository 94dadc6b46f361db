"""A solution as JSON: the same keys in the same order for the same problem, every value readable by sympy."""

from __future__ import annotations

import json
import math
from typing import TYPE_CHECKING, Any

from solver.derivation import Check

if TYPE_CHECKING:
    from solver.document.model import Document, Work, WorkAnswer, WorkStep

VERSION = 1

Data = dict[str, Any]


def render_json(document: Document) -> str:
    """Return the solution as JSON text. The document must have been made with `data`, or its steps have no values."""
    return json.dumps(as_data(document), ensure_ascii=False, allow_nan=False, indent=1) + "\n"


def as_data(document: Document) -> Data:
    """Return the solution as dictionaries, lists, texts and numbers."""
    return {
        "version": VERSION,
        "title": document.title,
        "status": str(document.status),
        "symbols": sorted(_symbols(document)),
        "parts": [_part(part) for part in document.parts if not part.case],
    }


def _symbols(document: Document) -> set[str]:
    """The names of symbols; one that is a signal v(t) somewhere is read as a function there, and as a symbol anyway."""
    functions = {name for part in document.parts for name in part.functions}
    return {name for part in document.parts for name in part.symbols} - functions


def _part(part: Work) -> Data:
    """Return one part by one method; `marks`, `reason`, `unchecked` and `cases` stand only where there are any."""
    data: Data = {"id": part.id, "task": part.task, "method": part.method, "status": str(part.status)}
    if part.label:
        data["label"] = part.label
    if part.marks:
        data["marks"] = part.out_of
    data["out_of"] = part.out_of
    if part.reason:
        data["reason"] = part.reason
    if part.unchecked:
        data["unchecked"] = part.unchecked
    data |= {"question": part.question, "system": dict(part.system)}
    data["answers"] = {answer.name: _answer(answer) for answer in part.answers}
    data["checks"] = [_check(check) for check in part.checks]
    data["steps"] = [_step(step) for step in part.steps]
    if part.cases:
        data["cases"] = [{"case": case.case, **_part(case)} for case in part.cases]
    return data


def _answer(answer: WorkAnswer) -> Data:
    """Return an answer; `numeric` stands only where it has no symbols."""
    data: Data = {"value": answer.value, "latex": answer.tex, "symbol": answer.symbol}
    return data | ({"numeric": answer.numeric} if answer.numeric is not None else {})


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
    return number if number is not None and math.isfinite(number) else None


def _step(step: WorkStep) -> Data:
    return {
        "kind": step.kind,
        "title": step.title,
        "text": step.markdown,
        "values": dict(step.values),
        "steps": [_step(each) for each in step.steps],
    }
