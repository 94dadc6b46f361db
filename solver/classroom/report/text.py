"""A marking as text for a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.classroom.report.hundredths import in_hundredths
from solver.classroom.report.words import earned, in_a_line, to_be_reviewed, verdict_of
from solver.classroom.verdicts import Marking, Verdict
from solver.messages import Messages
from solver.render.prose import inline_as_text
from solver.tasks import catalogue

if TYPE_CHECKING:
    from rich.console import Console

SIGNS = {Verdict.CORRECT: "✓", Verdict.WRONG: "✗", Verdict.NOT_JUDGED: "?"}
COLOURS = {Verdict.CORRECT: "green", Verdict.WRONG: "bold red", Verdict.NOT_JUDGED: "yellow"}


def print_marking(marking: Marking, name: str, console: Console, messages: Messages) -> None:
    """Print the verdicts of one answer file."""
    from rich.text import Text  # noqa: PLC0415 - rich is needed only to print

    marking = in_hundredths(marking)
    who = f"{name} ({marking.student})" if marking.student else name
    say = messages.say
    console.rule(Text(f"{who}: {say(earned(marking))}"), align="left", style="dim")
    for remark in marking.remarks:
        console.print(Text(f"    {inline_as_text(remark)}", style="yellow"))
    for part in marking.parts:
        head = Text(f"{part.id}  ", style="bold")
        note = f" ({part.note})" if part.note else ""
        head.append(f"{say(catalogue()[part.task].title)}: {say(earned(part))}{note}")
        console.print(head)
        for answer in part.answers.values():
            line = Text(f"    {SIGNS[answer.verdict]} ", style=COLOURS[answer.verdict])
            line.append(f"{answer.name}: {say(verdict_of(answer))}{in_a_line(answer, say)}", style="default")
            console.print(line)
            _print_comment(answer.comment, console)
        for missing in part.missing:
            console.print(Text(f"    – {missing}: {say('not submitted')}"))
        _print_comment(part.comment, console)
    _print_comment(marking.comment, console)
    if review := to_be_reviewed(marking, say):
        console.print(Text(review, style="yellow"))


def _print_comment(comment: str, console: Console) -> None:
    """Print what an instructor says."""
    from rich.text import Text  # noqa: PLC0415 - as above

    if comment:
        console.print(Text(f"      “{inline_as_text(comment)}”", style="italic"))
