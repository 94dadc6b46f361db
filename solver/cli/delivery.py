"""Markings handed back: printed, or written to files named after the answer files."""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from solver.classroom import Marking
from solver.classroom.report.data import as_data, as_json
from solver.classroom.report.sheet import render_sheet
from solver.classroom.report.text import print_marking
from solver.classroom.report.words import number, to_be_reviewed
from solver.cli.destination import STANDARD, write_beside, write_changed, write_whole
from solver.cli.papers import CheckRequest, Paper, Problems
from solver.cli.solving import in_words
from solver.cli.stems import stems_of
from solver.messages import Messages
from solver.words import Phrase

SUFFIXES = {"html": ".marked.html", "json": ".marked.json", "text": ".marked.txt"}


class Delivery:
    """Hands back the markings of answer files; `several` data become one list."""

    def __init__(self, request: CheckRequest, files: Sequence[str], several: bool) -> None:
        self.request = request
        self.several = several
        self.stems = stems_of(files, "answers")
        self.format = request.chosen_format
        self.items: list[dict[str, Any]] = []
        self.to_review: list[str] = []
        self.messages = Messages()
        output = request.output or ""
        place = Path(output)
        folder = bool(output) and (place.is_dir() or output.endswith("/"))
        self.is_list = several and self.format == "json" and not folder
        self.is_list = self.is_list and (not output or output == STANDARD or place.suffix.lower() == ".json")
        if output and output != STANDARD and several and place.is_file() and not self.is_list:
            raise click.UsageError(f"{output} is one file; name a folder for {len(files)} answer files.")

    def hand_back(self, paper: Paper, marking: Marking | None, problems: Problems) -> None:
        """Write or print the marking of a paper; of one at fault there is none."""
        if marking is None or marking.needs_review:
            self.to_review.append(paper.name)
        if marking is not None:
            self.messages = problems.messages(paper.problem)
        if self.is_list:
            self.items.append({"file": paper.name, **_data(paper, marking)})
        if marking is None or self.is_list:
            return
        content = self._content(paper, marking, problems)
        output, say = self.request.output, self.messages.say
        if output == STANDARD or (output is None and self.format != "html"):
            sys.stdout.write(content)
            sys.stdout.flush()
            return
        path = self.write(paper.name, content.encode())
        total = Phrase("{marks} of {out_of} marks", marks=number(marking.marks), out_of=number(marking.out_of))
        said = (say(total), say(Phrase("wrote {path}", path=path)), to_be_reviewed(marking, say))
        click.echo(f"{paper.name}: {'; '.join(filter(None, said))}")

    def conclude(self) -> None:
        """Write or print the list of the data of all papers; of texts say which files need review."""
        if not self.is_list:
            if self.several and self.to_review and self.format == "text":
                files = Phrase("needs review: {answers}", answers=", ".join(self.to_review))
                click.echo(self.messages.say(files))
            return
        content = json.dumps(self.items, ensure_ascii=False, allow_nan=False, indent=1) + "\n"
        output = self.request.output
        if output is None or output == STANDARD:
            sys.stdout.write(content)
            sys.stdout.flush()
        else:
            write_whole(Path(output), content.encode())
            click.echo(f"wrote {output}", err=True)

    def _content(self, paper: Paper, marking: Marking, problems: Problems) -> str:
        if self.format == "json":
            return as_json(marking)
        if self.format == "html":
            solution, document = problems.solutions[paper.problem], problems.document(paper.problem)
            with in_words("the sheet"):
                return render_sheet(solution, marking, document, self.request.templates, key=self.request.key)
        from rich.console import Console

        from solver.render.terminal import WIDTH

        to_terminal = self.request.output is None and sys.stdout.isatty()
        console = Console(highlight=False, width=None if to_terminal else WIDTH, force_terminal=to_terminal)
        with console.capture() as captured:
            print_marking(marking, paper.name, console, self.messages)
        return captured.get()

    def write(self, file: str, content: bytes) -> Path:
        """Write the marking of a file where it goes; return where that is."""
        path = self.path_of(file)
        is_named = self.request.output is not None and path == Path(self.request.output)
        is_beside = path.parent.resolve() == Path(file).parent.resolve()
        (write_beside if is_beside and not is_named else write_changed)(path, content)
        return path

    def path_of(self, file: str) -> Path:
        """Where the marking of a file goes: as named, into the folder named, or beside the answers."""
        if self.request.output is None:
            beside = Path("answers") if file == STANDARD else Path(file)
            return beside.with_name(beside.stem + SUFFIXES[self.format])
        place = Path(self.request.output)
        folder = self.several or place.is_dir() or self.request.output.endswith("/")
        return place / (self.stems[file] + SUFFIXES[self.format]) if folder else place


def _data(paper: Paper, marking: Marking | None) -> dict[str, Any]:
    if marking is None:
        return {"student": "", "error": paper.fault, "needs_review": True}
    return {"student": marking.student, **as_data(marking)}
