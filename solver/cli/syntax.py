"""The work of `solve check --syntax`: how the values of answer files are read, printed or as data."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import click

from solver.classroom.syntax import Readings, readings
from solver.cli.papers import Paper, Problems
from solver.cli.solving import SOLVED, UNSOLVED
from solver.limits import Exceeded, call_within
from solver.messages import Messages
from solver.render.prose import inline_as_text
from solver.words import Phrase


@dataclass(frozen=True, slots=True)
class Told:
    """A file with how its values are read, or why that cannot be said; `code` is the exit code that it leads to."""

    name: str
    found: Readings | None = None
    fault: str = ""
    code: int = SOLVED
    messages: Messages = field(default_factory=Messages)

    @staticmethod
    def of(name: str, found: Readings, messages: Messages) -> Told:
        """Return what is told of a file that was read."""
        return Told(name, found, code=SOLVED if found.all_clear else UNSOLVED, messages=messages)


def tell_readings(papers: Sequence[Paper], problems: Problems) -> int:
    """Say how the values of each paper are read; return 1 where one is not, or in several ways."""
    return tell((_told(paper, problems) for paper in papers), len(papers), as_json=problems.request.format == "json")


def _told(paper: Paper, problems: Problems) -> Told:
    if paper.submission is None:
        return Told(paper.name, fault=paper.fault, code=paper.code)
    solution, messages = problems.solutions[paper.problem], problems.messages(paper.problem)
    try:
        found: Readings = call_within(
            problems.request.limits, readings, solution, paper.submission, problems.request.templates
        )
    except Exceeded as limit:
        fault = messages.say(limit.reason)
        click.echo(f"{paper.name}: error: {fault}", err=True)
        return Told(paper.name, fault=fault, code=UNSOLVED)
    return Told.of(paper.name, found, messages)


def tell(papers: Iterable[Told], count: int, *, as_json: bool) -> int:
    """Print the readings of so many papers, or their data; return the worst exit code."""
    codes, items = [SOLVED], list[dict[str, Any]]()
    for each in papers:
        codes.append(each.code)
        if each.found is None:
            items.append({"file": each.name, "student": "", "error": each.fault})
            continue
        items.append({"file": each.name, **asdict(each.found)})
        if not as_json:
            _print(each.name, each.found, each.messages)
    if as_json:
        click.echo(json.dumps(items if count > 1 else items[0], ensure_ascii=False, indent=1))
    return max(codes)


def _print(name: str, found: Readings, messages: Messages) -> None:
    say = messages.say
    click.echo(f"{name} ({found.student})" if found.student else name)
    for remark in found.remarks:
        click.echo(f"    {inline_as_text(remark)}")
    for each in found.values:
        head = f"  {each.part}.{each.name} ({each.kind}): {each.typed}"
        shown = [inline_as_text(f"${formula}$") for formula in each.formulas]
        if not shown:
            click.echo(f"{head}\n    {inline_as_text(each.reason)}")
        elif len(shown) > 1:
            several = say(Phrase("it has several readings: {readings}", readings="; ".join(shown)))
            click.echo(f"{head}\n    {several}")
        else:
            click.echo(f"{head}\n    {say(Phrase('read as {value}', value=shown[0]))}")
