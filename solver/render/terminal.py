"""A solution on a terminal: a summary of answers and checks, and the whole solution as plain text."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from solver.derivation import CheckStatus, Status
from solver.formula.terminal import flat
from solver.formula.terminal.boxes import cells
from solver.render.displaying import word_of
from solver.render.pointing import agreeing, noting, picturing, referring
from solver.render.prose import inline_as_text, to_text
from solver.render.prose_text import INDENT, display_lines, fits, indented, wrapped
from solver.words import Phrase

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from solver.document.checks import Say
    from solver.document.model import CheckRow, Document, Work, WorkAnswer, WorkStep

WIDTH = 100
"""Cells of a line where there is no terminal to ask."""

LINE_END = "\\\\"
"""Ends a line of a formula, or a row of a matrix."""

COLOURS: dict[Status | CheckStatus, str] = {
    Status.VERIFIED: "green",
    Status.UNSOLVED: "yellow",
    Status.FAILED: "bold red",
    CheckStatus.PASSED: "green",
    CheckStatus.SKIPPED: "yellow",
    CheckStatus.FAILED: "bold red",
}


def print_summary(document: Document, console: Console, *, verbose: bool = False) -> None:
    """Print each part's answers and how they were checked; the table of checks if verbose or if one failed."""
    _print_rule(_plain(document.title), console)
    for part in document.shown:
        console.print()
        _print_part(part, console, document.messages.say)
        if part.rows and (verbose or part.status is Status.FAILED):
            console.print(_table(part.rows, document.messages.say))
    console.print()


def _print_part(part: Work, console: Console, say: Say) -> None:
    _print_line(console, (f"{part.id}  {heading(part, say)}", "bold"))
    for answer in part.found:  # in lines that fit
        _print_as_it_stands(console, ("\n".join(indented(answer_lines(answer, console.width))), ""))
    status, verdict = say(part.status), verdict_of(part, say)
    _print_line(console, (INDENT, ""), (status, COLOURS[part.status]), (verdict.removeprefix(status), ""))


def _print_rule(title: str, console: Console) -> None:
    """Print a title with a line behind it."""
    from rich.text import Text  # noqa: PLC0415 - rich is needed only to print, not to write text

    room = console.width - cells(title) - 1
    if title and room > 0:
        _print_as_it_stands(console, (f"{title} ", ""), ("─" * room, "dim"))
    else:
        console.rule(Text(title), align="left", style="dim")


def _print_line(console: Console, *pieces: tuple[str, str]) -> None:
    """Print pieces of text, each in its style, on a line, or on several where it is too long for that."""
    from rich.text import Text  # noqa: PLC0415 - as above

    text = "".join(words for words, _ in pieces)
    if text.isprintable() and cells(text) <= console.width:
        _print_as_it_stands(console, *pieces)
    else:
        console.print(Text.assemble(*pieces))


def _print_as_it_stands(console: Console, *pieces: tuple[str, str]) -> None:
    """Print pieces of text that rich need not lay out, each in its style, and end the line."""
    from rich.segment import Segment, Segments  # noqa: PLC0415 - as above

    shown = [Segment(words, console.get_style(style) if style else None) for words, style in pieces]
    console.print(Segments([*shown, Segment.line()]), crop=False)


def _table(rows: Iterable[CheckRow], say: Say) -> Table:
    from rich.table import Table  # noqa: PLC0415 - as above
    from rich.text import Text  # noqa: PLC0415

    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="dim")
    for indent, name in ((INDENT, "checked"), ("", "by"), ("", "residual"), ("", "tolerance"), ("", "")):
        table.add_column(indent + say(name))
    for row in rows:
        cells = [Text(cell) for cell in _cells(row, say)]
        cells[-1].stylize(COLOURS[row.status])
        table.add_row(*cells)
    return table


def _cells(row: CheckRow, say: Say) -> tuple[str, ...]:
    claim = INDENT + inline_as_text(row.claim)
    if row.reason:
        claim += f" ({inline_as_text(row.reason)})"
    return claim, inline_as_text(row.oracle), flat(row.residual), flat(row.tolerance), say(row.status)


def heading(part: Work, say: Say) -> str:
    """Return task and method of a part in words."""
    method = f": {part.named_method}" if part.named_method else ""
    marks = f" [{part.marks} {say('mark' if part.marks == '1' else 'marks')}]" if part.marks else ""
    return f"{part.title}{method}{marks}"


def verdict_of(part: Work, say: Say) -> str:
    """Return how the part ended: "verified: 12 of 12 checks passed", "unsolved: time limit of 60 s"."""
    passed = sum(row.status is CheckStatus.PASSED for row in part.rows)
    counted = Phrase("{passed} of {count} checks passed", passed=passed, count=len(part.rows))
    checks = say(counted) if part.rows else ""
    told = filter(None, [inline_as_text(part.reason), checks, inline_as_text(part.unchecked)])
    more = "; ".join(each.removesuffix(".") for each in told)
    return f"{say(part.status)}: {more}" if more else say(part.status)


def answer_lines(answer: WorkAnswer, width: int = WIDTH) -> list[str]:
    """Return an answer as `symbol = value`, drawn in two dimensions where it fits, a wide matrix entry by entry."""
    broken = LINE_END in answer.equation and answer.symbol and not word_of(answer.symbol)
    line = f"{answer.symbol} = {answer.tex}" if broken else answer.equation
    line = answer.derived or line
    equation = line if fits(line, width - len(INDENT)) else answer.narrow
    return [line.removeprefix(INDENT) for line in display_lines(equation, width - len(INDENT))]


def text_document(document: Document, width: int = WIDTH) -> str:
    """Return the whole worked solution as plain text."""
    title = _plain(document.title)
    blocks = [f"{title}\n{'=' * len(title)}", _plain(document.source), to_text(document.statement, width)]
    blocks.append(to_text(document.given, width))
    parts = document.shown
    blocks += [block for part in parts for block in _blocks(document, part, width)]
    blocks += _appendix(document, parts)
    return "\n\n".join(block.rstrip() for block in blocks if block.strip()) + "\n"


def _blocks(document: Document, part: Work, width: int) -> Iterator[str]:
    say = document.messages.say
    head = f"({part.letter}) {heading(part, say)}"
    yield f"{head}\n{'-' * len(head)}"
    if not part.again:
        yield to_text(part.question, width)
        yield to_text(part.given, width)
    if part.source:
        yield f"[{part.source}]"
    yield from _step_blocks(part.steps, "", width, say)
    for answer in part.boxed:
        marks = f" [{answer.marks}]" if answer.marks and document.presentation.detail == "key" else ""
        head = f"{say('Answer')}: {inline_as_text(answer.doc)}{marks}"
        yield f"{head}\n\n" + "\n".join(indented(answer_lines(answer, width)))
    if part.same:
        yield f"{say('Answer')}: {inline_as_text(agreeing(part.same, say))}"
    if part.noted:
        yield to_text(noting(part, say), width)
    if not document.presentation.is_paper:
        yield "\n".join(wrapped(verdict_of(part, say), width))


def _appendix(document: Document, parts: Iterable[Work]) -> Iterator[str]:
    """Yield the tables of checks, behind all parts."""
    say, tables = document.messages.say, [part for part in parts if document.checks_of(part) == "table"]
    if tables:
        yield f"{say('Checks')}\n{'-' * len(say('Checks'))}"
    for part in tables:
        yield document.heading_of(part)
        yield "\n".join(_check_lines(part.rows, say))


def _step_blocks(steps: Sequence[WorkStep], number: str, width: int, say: Say) -> Iterator[str]:
    for index, step in enumerate(steps, start=1):
        place = f"{number}{index}."
        pointed = [referring(step, say)] if step.refers else []
        body = "\n\n".join([*pointed, step.markdown, *(picturing(each, say) for each in step.pictured)])
        yield f"{place} {inline_as_text(step.title)}"
        yield "\n".join(indented(to_text(body, width - len(INDENT)).split("\n")))
        yield from _step_blocks(step.steps, place, width, say)


def _check_lines(rows: Iterable[CheckRow], say: Say) -> Iterator[str]:
    for row in rows:
        claim, oracle, residual, tolerance, status = _cells(row, say)
        bound = f", {say('residual')} {residual} ≤ {tolerance}" if residual and row.status is CheckStatus.PASSED else ""
        bound = f", {say('residual')} {residual}, {say('tolerance')} {tolerance}" if residual and not bound else bound
        yield f"{INDENT}{status}: {claim.strip()} [{oracle}{bound}]"


def _plain(text: str) -> str:
    """Return a user's text on one line, without characters that would act on the terminal."""
    return " ".join("".join(letter if letter.isprintable() else " " for letter in text).split())
