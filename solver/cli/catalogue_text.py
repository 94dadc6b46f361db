"""The catalogue as plain text. Reads the declarations of the tasks; needs no algebra."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from textwrap import wrap
from typing import Any

from solver.derivation import AnswerName, Method, Option, Slip, Task
from solver.formula.terminal import flat
from solver.notation import spelled
from solver.problem.template import OTHER_NAMES
from solver.symbols import COURSE

WIDTH = 100
FORMULA = re.compile(r"\$([^$]*)\$")
TIMES = {"continuous": "continuous time", "discrete": "discrete time", "both": ""}


def one(task: Task[Any, Any]) -> str:
    """Return all about a task."""
    needs = ", ".join(OTHER_NAMES.get(need, need) for need in task.needs) if task.needs else "nothing"
    lines = [task.name, f"  {task.title}.", *_wrapped(task.doc, "  "), f"  Needs {needs} of the system.", ""]
    lines += ["Methods", *_table(_method_rows(task)), ""] if set(task.methods) - {task.name} else []
    lines += ["Options", *_table(map(_option_row, task.options.values())), ""]
    lines += ["Answers", *_table(map(_answer_row, task.answers.values()))]
    lines += ["", "Mistakes, beside those of any task", *_table(map(_slip_row, task.slips))] if task.slips else []
    return "\n".join(lines)


def _method_rows(task: Task[Any, Any]) -> Iterator[tuple[str, str]]:
    for method in task.methods.values():
        yield method.name, "; ".join(filter(None, [method.title, _when(method), method.source]))


def _when(method: Method) -> str:
    return TIMES[method.time]


def _option_row(option: Option) -> tuple[str, str]:
    facts = [option.kind.words]
    if option.required:
        facts.append("required")
    if option.default is not None:
        facts.append(f"default {str(option.default).lower() if isinstance(option.default, bool) else option.default}")
    return option.name, f"{option.doc} [{'; '.join(facts)}]{_only(option.methods)}"


def _answer_row(answer: AnswerName) -> tuple[str, str]:
    sense = " (where it makes sense)" if answer.optional else ""
    return answer.name, _in_text(answer.doc) + sense + _only(answer.methods)


def _slip_row(slip: Slip) -> tuple[str, str]:
    return slip.name, _in_text(slip.words)


def _in_text(words: str) -> str:
    return FORMULA.sub(lambda formula: flat(formula[1]), spelled(words, COURSE))


def _only(methods: tuple[str, ...]) -> str:
    return f" (only {', '.join(methods)})" if methods else ""


def _table(rows: Iterable[tuple[str, str]]) -> Iterator[str]:
    """Yield two columns, the second wrapped."""
    listed = list(rows)
    width = max((len(name) for name, _ in listed), default=0)
    for name, text in listed:
        first, *rest = _wrapped(text, " " * (width + 4)) or [""]
        yield f"  {name:{width}}  {first.lstrip()}"
        yield from rest


def _wrapped(text: str, indent: str) -> list[str]:
    return wrap(text, WIDTH, initial_indent=indent, subsequent_indent=indent, break_on_hyphens=False)
