"""The work of `solve check --syntax`: how the values of answer files are read, printed or as data."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

import click

from solver.classroom.syntax import Readings, readings
from solver.cli.papers import Paper, Problems
from solver.cli.solving import SOLVED, UNSOLVED
from solver.limits import Exceeded, call_within
from solver.messages import Messages
from solver.render.prose import inline_as_text
from solver.words import Phrase


def tell_readings(papers: Sequence[Paper], problems: Problems) -> int:
    """Say how the values of each paper are read; return 1 where one is not, or in several ways."""
    as_json = problems.request.format == "json"
    codes, items = [SOLVED], list[dict[str, Any]]()
    for paper in papers:
        codes.append(paper.code)
        if paper.submission is None:
            items.append({"file": paper.name, "student": "", "error": paper.fault})
            continue
        solution, messages = problems.solutions[paper.problem], problems.messages(paper.problem)
        try:
            found: Readings = call_within(
                problems.request.limits, readings, solution, paper.submission, problems.request.templates
            )
        except Exceeded as limit:
            click.echo(f"{paper.name}: error: {messages.say(limit.reason)}", err=True)
            codes.append(UNSOLVED)
            continue
        codes.append(SOLVED if found.all_clear else UNSOLVED)
        items.append({"file": paper.name, **asdict(found)})
        if not as_json:
            _print(paper.name, found, messages)
    if as_json:
        click.echo(json.dumps(items if len(papers) > 1 else items[0], ensure_ascii=False, indent=1))
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
