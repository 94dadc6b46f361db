"""A solution as Markdown with `$math$`, as notebooks and repositories show it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from solver.derivation import Status
from solver.render.pointing import agreeing, noting, picturing, referring, unlinked
from solver.render.prose import plain

if TYPE_CHECKING:
    from solver.document.checks import Say
    from solver.document.model import CheckRow, Document, Work, WorkStep

_TAG = re.compile(r"<(?=[A-Za-z/!?])")


def markdown_of(document: Document) -> str:
    """Return the whole solution. Raw HTML in a user's text is made harmless."""
    lines = [f"# {plain(document.title)}", plain(document.source), _harmless(document.statement), document.given]
    parts = document.shown
    for part in parts:
        lines += _part(document, part)
    lines += _appendix(document, parts)
    return "\n\n".join(line.strip() for line in lines if line.strip()) + "\n"


def _harmless(markdown: str) -> str:
    """A blank after < keeps a tag from being one, and changes nothing in a formula."""
    return _TAG.sub("< ", markdown)


def _part(document: Document, part: Work) -> Iterator[str]:
    paper, checks = document.presentation.is_paper, document.checks_of(part)
    say = document.messages.say
    marks = f" ({plain(part.marks)} {say('mark' if part.marks == '1' else 'marks')})" if part.marks else ""
    yield f"## ({plain(part.letter)}) {plain(part.title)}{marks}"
    if not part.again:
        yield _harmless(part.question)
        yield part.given
    if part.named_method:
        source = f" ({plain(part.source)})" if part.source else ""
        yield f"*{say('Method:')} {plain(part.named_method)}*{source}"
    elif part.source:
        yield f"*{plain(part.source)}*"
    if part.status is Status.FAILED and not paper:
        yield f"> **{say('Do not rely on this answer:')}** {part.reason}."
    yield from _steps(part.steps, "###", say)
    if part.status is Status.UNSOLVED and not paper:
        yield f"> **{say('Unsolved.')}** {part.reason}"
    if part.boxed or part.same:
        yield f"### {say('Answer')}"
        for answer in part.boxed:
            yield f"$$\n{answer.shown}\n$$"
            if answer.marks and document.presentation.detail == "key":
                yield f"({plain(answer.marks)} {say('mark' if answer.marks == '1' else 'marks')})"
    if part.same:
        yield agreeing(part.same, say)
    if part.noted:
        yield noting(part, say)
    if checks != "none":
        yield f"{document.tally_of(part)}."
    if checks != "none" and part.unchecked:
        yield part.unchecked


def _appendix(document: Document, parts: Iterable[Work]) -> Iterator[str]:
    """Yield the tables of checks, behind all parts."""
    say, tables = document.messages.say, [part for part in parts if document.checks_of(part) == "table"]
    if tables:
        yield f"## {say('Checks')}"
    for part in tables:
        yield f"### {plain(document.heading_of(part))}"
        yield _table(part.rows, say)


def _steps(steps: Iterable[WorkStep], level: str, say: Say, prefix: str = "") -> Iterator[str]:
    for number, step in enumerate(steps, 1):
        yield f"{level} {prefix}{number}{'' if prefix else '.'} {step.title}"
        if step.refers:
            yield referring(step, say)
        yield unlinked(step.markdown)
        for each in step.pictured:
            yield picturing(each, say)
        for figure in step.figures:
            yield f"*{say('Figure:')}* {_harmless(figure.caption)}"
            if figure.alt:
                yield plain(figure.alt)
        yield from _steps(step.steps, level + "#" if len(level) < 6 else level, say, f"{prefix}{number}.")


def _table(rows: Iterable[CheckRow], say: Say) -> str:
    lines = [f"| {' | '.join(map(say, ('Checked', 'By', 'Error', 'Result')))} |", "|---|---|---|---|"]
    for row in rows:
        reason = f" ({row.reason})" if row.reason else ""
        error = f"${row.residual}$" if row.residual else ""
        status = f"**{say(row.status)}**" if row.status == "failed" else say(row.status)
        lines.append(f"| {_cell(row.claim + reason)} | {_cell(row.oracle)} | {error} | {status} |")
    return "\n".join(lines)


def _cell(markdown: str) -> str:
    return " ".join(markdown.split()).replace("|", r"\|").replace(r"\\|", r"\|")
