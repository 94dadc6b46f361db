"""The blank answer file of a problem: parts, names of answers, how each is written; nothing of our own answers.

Of an answer only its kind is told, and the size of a matrix where the question leaves no choice of it. Where an answer
may be missing nothing is told, for that would say that it is there.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from textwrap import wrap
from typing import Any

import sympy as sp

from solver.classroom.examples import example_of
from solver.classroom.kinds import kind_of
from solver.classroom.marking import Marker
from solver.classroom.reading.answer_file import Submission
from solver.derivation import AnswerName
from solver.document.checks import Say
from solver.document.model import Presentation
from solver.document.works import document_of
from solver.engine import Solution
from solver.problem.asked import asked_of
from solver.problem.model import Part
from solver.problem.source import Source
from solver.render.prose import inline_as_text
from solver.tasks import catalogue
from solver.words import Phrase

WIDTH = 110


def blank_answers(solution: Solution, problem: str = "", templates: Path | None = None) -> str:
    """Return the answer file to fill in, YAML with comments; `problem` is the file it names."""
    marker = _marker(solution, templates)
    say = marker.messages.say
    lines = [*comment(solution.problem.title), *comment(say(HOW))]
    lines += [" ".join(["problem:", quoted(problem)])] if problem else []
    lines += ["student:", "answers:", *blank_parts(solution, templates)]
    return "\n".join(lines) + "\n"


def _marker(solution: Solution, templates: Path | None) -> Marker:
    return Marker(solution, Submission(Source("", ""), "", {}), templates)


def blank_parts(solution: Solution, templates: Path | None = None) -> list[str]:
    """Return the lines of the parts, as they stand under `answers`."""
    marker, lines = _marker(solution, templates), list[str]()
    paper = document_of(solution, Presentation("question", templates))
    works = {work.id: work for work in paper.parts}
    for part in solution.problem.parts:
        work = works[part.id]
        lines += ["", *comment(f"({work.letter}) {work.title}. {inline_as_text(work.question)}", "  ")]
        lines += [f"  {quoted(part.id)}:", *_answers(part, marker)]
    return lines


HOW = "Write each value after its name, in quotes where it has a colon or a brace; what is left blank is not answered."


def _answers(part: Part, marker: Marker) -> Iterator[str]:
    task, ours, say = catalogue()[part.task], marker.ours(part.id), marker.messages.say
    asked = asked_of(part, task)
    width = max(map(len, asked), default=0)
    for name in asked:
        answer = task.answers[name]
        # how an answer is written is not told where that says that there is one, beyond what the system says
        known = name in ours and (not answer.optional or callable(answer.principal))
        told = _how(ours[name], answer, marker.is_determined(part, name), say) if known else ""
        yield f"    {name + ':':{width + 2}} # {told}".rstrip(" #") if told else f"    {name}:"
    others = [name for name, answer in task.answers.items() if name not in asked and _given(answer, part)]
    if others:
        yield from comment(say(Phrase("judged too, without marks: {names}", names=", ".join(others))), "    ")


def _given(answer: AnswerName, part: Part) -> bool:
    """Whether one of the methods gives the answer."""
    return not answer.methods or bool(set(answer.methods) & set(part.methods))


def _how(value: Any, declared: AnswerName, determined: bool, say: Say) -> str:
    """Return how an answer is written: its kind, its size where that is no choice, an example that is not ours."""
    sized = isinstance(value, sp.MatrixBase) and determined and 0 not in value.shape
    kind = kind_of(value)
    kind = say("a whole number" if declared.count and kind == "an expression" else kind)
    if sized:
        kind = say(Phrase("{kind}, {rows}×{columns}", kind=kind, rows=value.rows, columns=value.cols))
    example = example_of(value, sized=sized, intervals=declared.intervals, zero=declared.zero, count=declared.count)
    return say(Phrase("{kind}, for example {example}", kind=kind, example=example)) if example else kind


def comment(text: str, indent: str = "") -> list[str]:
    """Return a text as lines of comment."""
    return [f"{indent}# {line}" for line in wrap(" ".join(text.split()), WIDTH - len(indent), break_on_hyphens=False)]


def quoted(text: str) -> str:
    """Return a text as YAML reads it back."""
    plain = text[:1].isalpha() and all(sign.isalnum() or sign in "-_./" for sign in text)
    return text if plain and text.lower() not in WORDS else "'" + text.replace("'", "''") + "'"


WORDS = ("yes", "no", "true", "false", "null", "on", "off", "y", "n")
"""What YAML may take for something else than a text."""
