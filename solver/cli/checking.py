"""The work of `solve check`: solve the problem once, mark each answer file, report, tabulate."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import click

from solver.classroom import Marking, mark_within, read_submission
from solver.classroom.reading.answer_file import problem_named_in
from solver.classroom.report.data import as_json
from solver.classroom.report.sheet import render_sheet
from solver.classroom.report.table import as_csv
from solver.classroom.report.text import print_marking
from solver.cli.destination import STANDARD, AtFault, write_whole
from solver.cli.progress import Meter
from solver.cli.solving import INPUT_AT_FAULT, SOLVED, UNSOLVED, in_words, settle, source_of
from solver.document.model import Document, Presentation
from solver.engine import Solution
from solver.limits import Limits, Solved, Supervision, solve_within
from solver.messages import Messages
from solver.problem.nodes import MappingNode
from solver.problem.partial import ruled
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.problem.yaml_tree import parse_yaml
from solver.tasks import catalogue
from solver.words import Phrase

SUFFIXES = {"html": ".marked.html", "json": ".marked.json", "text": ".marked.txt"}


@dataclass(frozen=True, slots=True)
class CheckRequest:
    """What the command line asks for; `limits` are those of each part, `partial` the rule for all wrong answers."""

    files: tuple[str, ...]
    format: str | None
    output: str | None
    table: str | None
    solution: bool
    presentation: Presentation
    limits: Limits
    partial: str | None = None

    @property
    def templates(self) -> Path | None:
        """The folder of templates that come before the installed ones."""
        return self.presentation.templates

    @property
    def chosen_format(self) -> str:
        """The format asked for, meant by the ending of the output, or text."""
        endings = {".html": "html", ".json": "json"}
        return self.format or endings.get(Path(self.output or "").suffix.lower(), "html" if self.solution else "text")


def check_files(request: CheckRequest) -> int:
    """Mark all answer files; return the worst exit code: 1 where an answer is wrong, 2 where a file is at fault."""
    settle()
    problem, answers = _told_apart(request.files)
    if request.output and request.output != STANDARD and len(answers) > 1 and Path(request.output).is_file():
        raise click.UsageError(f"{request.output} is one file; name a folder for {len(answers)} answer files.")
    read = {Path(file).resolve() for file in request.files if file != STANDARD}
    for path in (request.output, request.table):
        if path and path != STANDARD and Path(path).resolve() in read:
            raise click.UsageError(f"{path} is one of the files that are read; it is not overwritten.")
    desk = _Desk(request, answers)
    codes = [desk.mark(problem, file) for file in answers]
    if request.table:
        parts = list(dict.fromkeys(part.id for solution in desk.solutions.values() for part in solution.problem.parts))
        write_whole(Path(request.table), as_csv(desk.rows, parts).encode())
        click.echo(f"wrote {request.table}", err=True)
    return max(codes)


def _told_apart(files: tuple[str, ...]) -> tuple[str | None, tuple[str, ...]]:
    """Return the problem file, None if the answer files name theirs, and the answer files."""
    if len(files) == 1 or _is_answer_file(files[0]):
        return None, files
    return files[0], files[1:]


def _is_answer_file(file: str) -> bool:
    try:
        root = parse_yaml(source_of(file)) if file != STANDARD else None
    except InputError:
        return False
    return isinstance(root, MappingNode) and "answers" in root and "find" not in root


class _Desk:
    """Marks answer files one after the other; a problem is solved once."""

    def __init__(self, request: CheckRequest, files: Sequence[str]) -> None:
        self.request = request
        self.stems = _stems(files)
        self.solved: dict[str, Solved] = {}
        self.solutions: dict[str, Solution] = {}
        self.rows: list[tuple[str, Marking | None]] = []
        self.meter = Meter(len(files))
        self.several = len(files) > 1

    def mark(self, problem: str | None, file: str) -> int:
        """Mark one file; whatever is wrong with it becomes words on standard error and an exit code."""
        try:
            source = source_of(file)
            name = problem or self._named(source, file)
            submission = read_submission(source, self._solution(name).problem)
            with self.meter.file(file):
                marking = mark_within(self.solutions[name], submission, self.request.limits, self.request.templates)
        except InputError as error:
            click.echo(error.render(), err=True)
            self.rows.append((file, None))
            return INPUT_AT_FAULT
        except AtFault as error:
            click.echo(f"{file}: error: {error.format_message()}", err=True)
            self.rows.append((file, None))
            return error.exit_code
        finally:
            self.meter.next_file()
        self.rows.append((file, marking))
        self._deliver(name, file, marking)
        return SOLVED if marking.all_right else UNSOLVED

    def _named(self, source: Source, file: str) -> str:
        """Return the problem that an answer file names, found beside it."""
        name = problem_named_in(source)
        if not name:
            raise AtFault("it names no problem; call solve check PROBLEM ANSWERS, or add the key 'problem'")
        return str(Path(name) if file == STANDARD else Path(file).parent / name)

    def _solution(self, name: str) -> Solution:
        """Return the solved problem."""
        if name not in self.solutions:
            problem = read_problem(source_of(name), catalogue())
            messages = self.request.presentation.messages(problem.display)
            display = replace(problem.display, language=messages.language, notation=messages.notation)
            problem = replace(problem, display=display)
            if self.request.partial:
                problem = ruled(problem, self.request.partial, catalogue())
            told = self.request.presentation if self.request.solution else None
            with self.meter.file(name) as notify:
                self.solved[name] = solve_within(problem, self.request.limits, told, Supervision(notify))
            self.solutions[name] = self.solved[name].solution()
        return self.solutions[name]

    def _document(self, name: str) -> Document | None:
        """Return the worked solution in words where it is to be shown."""
        return self.solved[name].document(name) if self.request.solution else None

    def _deliver(self, name: str, file: str, marking: Marking) -> None:
        """Write or print the marking of one file."""
        format_ = self.request.chosen_format
        content = self._content(format_, name, file, marking)
        output = self.request.output
        if output == STANDARD or (output is None and format_ != "html"):
            sys.stdout.write(content)
            sys.stdout.flush()
            return
        path = self._path(file, format_)
        write_whole(path, content.encode())
        said = self._messages(name).say
        click.echo(f"{file}: {said(_total(marking))}; {said(Phrase('wrote {path}', path=path))}")

    def _content(self, format_: str, name: str, file: str, marking: Marking) -> str:
        if format_ == "json":
            return as_json(marking)
        if format_ == "html":
            with in_words("the sheet"):
                return render_sheet(self.solutions[name], marking, self._document(name), self.request.templates)
        from rich.console import Console

        from solver.render.terminal import WIDTH

        to_terminal = self.request.output is None and sys.stdout.isatty()
        console = Console(highlight=False, width=None if to_terminal else WIDTH, force_terminal=to_terminal)
        with console.capture() as captured:
            print_marking(marking, file, console, self._messages(name))
        return captured.get()

    def _messages(self, name: str) -> Messages:
        """How a marking is worded: in the language and notation of the problem."""
        display = self.solutions[name].problem.display
        return Messages(self.request.templates, display.language, display.notation)

    def _path(self, file: str, format_: str) -> Path:
        """Where the marking of a file goes: as named, into the folder named, or beside the answers."""
        if self.request.output is None:
            beside = Path("answers") if file == STANDARD else Path(file)
            return beside.with_name(beside.stem + SUFFIXES[format_])
        place = Path(self.request.output)
        folder = self.several or place.is_dir() or self.request.output.endswith("/")
        return place / (self.stems[file] + SUFFIXES[format_]) if folder else place


def _stems(files: Iterable[str]) -> dict[str, str]:
    """Return what the sheets of the files are named in one folder: where names are alike, with the folders before."""
    whole = {file: ("answers",) if file == STANDARD else _names(Path(file).resolve()) for file in files}
    found: dict[str, str] = {}
    for file, names in whole.items():
        others = [other for each, other in whole.items() if each != file]
        count = next((k for k in range(1, len(names)) if all(other[-k:] != names[-k:] for other in others)), len(names))
        stem = "-".join(names[-count:])
        number = next(n for n in range(1, len(whole) + 1) if (stem if n == 1 else f"{stem}-{n}") not in found.values())
        found[file] = stem if number == 1 else f"{stem}-{number}"
    return found


def _names(path: Path) -> tuple[str, ...]:
    """The folders of a file, and its name without the ending."""
    return (*path.parts[1:-1], path.stem)


def _total(marking: Marking) -> Phrase:
    from solver.classroom.report.words import number

    return Phrase("{marks} of {out_of} marks", marks=number(marking.marks), out_of=number(marking.out_of))
