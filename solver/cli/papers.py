"""What `solve check` is asked to mark: answer files, each with the problem that it answers, which is solved once."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import click

from solver.classroom import Submission, read_submission
from solver.classroom.reading.files import answer_files, load_submitted
from solver.cli.destination import STANDARD, AtFault
from solver.cli.executing import Workers
from solver.cli.inputs import WILD, found_by, is_one_file
from solver.cli.named import named_in
from solver.cli.progress import Meter
from solver.cli.solving import INPUT_AT_FAULT, SOLVED, source_of
from solver.document.model import Document, Presentation
from solver.engine import Solution
from solver.limits import Limits, Solved, Supervision, solve_within
from solver.messages import Messages
from solver.papers.kept import NOTHING, Kept
from solver.papers.marked import keep_solved, solved_before
from solver.problem.model import Problem
from solver.problem.nodes import MappingNode
from solver.problem.partial import ruled
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.problem.yaml_tree import parse_yaml
from solver.tasks import catalogue

NAMES_NOTHING = "it names no problem; call solve check PROBLEM ANSWERS, or EXAM for an exam, or add the key 'problem'"
SHOWN = 3
CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f]")


@dataclass(frozen=True, slots=True)
class CheckRequest:
    """What the command line asks for; `limits` are those of each part, `partial` the rule for all wrong answers.

    With `key` a sheet has the right values too, `syntax` asks only how values are read, `changes` is a file of changes,
    `report` a page of what the marks of a class say. With `again` nothing is used that was marked before.
    """

    files: tuple[str, ...]
    format: str | None
    output: str | None
    table: str | None
    solution: bool
    presentation: Presentation
    limits: Limits
    partial: str | None = None
    key: bool = False
    syntax: bool = False
    changes: str | None = None
    workers: Workers = field(default_factory=Workers)
    report: str | None = None
    again: bool = False

    @property
    def templates(self) -> Path | None:
        """The folder of templates that come before the installed ones."""
        return self.presentation.templates

    @property
    def chosen_format(self) -> str:
        """The format asked for, meant by the ending of the output, or text."""
        endings = {".html": "html", ".json": "json"}
        return self.format or endings.get(Path(self.output or "").suffix.lower(), "html" if self.solution else "text")


@dataclass(frozen=True, slots=True)
class Paper:
    """An answer file, by the name it goes by, and the problem's; where it is at fault (`code`) there is no submission.

    `fault` says what is wrong with it.
    """

    name: str
    problem: str = ""
    submission: Submission | None = None
    code: int = SOLVED
    fault: str = ""


def told_apart(files: tuple[str, ...]) -> tuple[str | None, tuple[str, ...]]:
    """Return the problem file, None if the answer files name theirs, and the answer files and folders."""
    if len(files) == 1 or _holds_answers(files[0]):
        return None, files
    return files[0], files[1:]


def _holds_answers(file: str) -> bool:
    """Whether it is an answer file, or a folder or a pattern of them."""
    if not is_one_file(file):
        return True
    try:
        root = parse_yaml(source_of(file), colonless=True) if file != STANDARD else None
    except InputError:
        return False
    return isinstance(root, MappingNode) and "answers" in root and "find" not in root


def files_in(named: Sequence[str], *others: str | None) -> tuple[str, ...]:
    """Return the files that are named, for a folder or a pattern those found, by name, less the other ones read."""
    apart = {Path(file).resolve() for file in others if file}
    found: list[str] = []
    for name in named:
        if is_one_file(name):
            found.append(name)
            continue
        inside = map(str, answer_files(Path(name))) if Path(name).is_dir() else _fitting(name)
        files = [file for file in _that_can_be_told(inside) if Path(file).resolve() not in apart]
        if not files:
            raise click.UsageError(f"there is no answer file in {name}; they end in .yaml.{below(name)}")
        found += files
    return tuple(dict.fromkeys(found))


def printable(name: str) -> str:
    """Return the name of a file as a terminal may print it: signs that would command it are written as in Python."""
    return CONTROL.sub(lambda sign: repr(sign[0])[1:-1], name)


def _that_can_be_told(files: Iterable[str]) -> Iterator[str]:
    """Yield the files whose names can be printed; say which ones have to be called otherwise before they are read."""
    for file in files:
        if CONTROL.search(file):
            click.echo(f"passed over, give it another name: {printable(file)}", err=True)
        else:
            yield file


def _fitting(pattern: str) -> list[str]:
    """Return the answer files that fit a pattern. What a link among the folders leads to is nobody's answer."""
    named = next(place for place, part in enumerate(Path(pattern).parts) if WILD.search(part))
    found = {file: [folder for folder in Path(file).parents if len(folder.parts) > named] for file in found_by(pattern)}
    linked = {folder for folders in found.values() for folder in folders if folder.is_symlink()}
    if linked:
        click.echo(f"passed over, links: {', '.join(map(str, sorted(linked)))}", err=True)
    return [file for file, folders in found.items() if linked.isdisjoint(folders)]


def below(folder: str) -> str:
    """Return how the answer files in the folders of a folder are named, "" where there are none."""
    pattern = Path(folder) / "*" / "*.yaml"
    there = Path(folder).is_dir() and any(Path(folder).glob("*/*.yaml"))
    return f" For those of its folders: '{pattern}'" if there else ""


class Problems:
    """The problems that answer files are about, each solved once."""

    def __init__(self, request: CheckRequest, meter: Meter, kept: Kept = NOTHING) -> None:
        self.request = request
        self.kept = kept
        self.meter = meter
        self.solved: dict[str, Solved] = {}
        self.solutions: dict[str, Solution] = {}
        self.nameless: dict[str, list[tuple[str, str]]] = {}
        self.told: set[str] = set()

    def paper(self, file: str, problem: str | None) -> Paper:
        """Read an answer file; what is wrong with it becomes words on standard error, and a code.

        What is wrong with the problem is the same for all: it is told once.
        """
        try:
            source = submitted(file)
            name = problem or self._named(source, file)
            if not name:
                return Paper(file, code=INPUT_AT_FAULT, fault=self._why_nameless(file))
            return Paper(file, name, read_submission(source, self.solution(name).problem))
        except InputError as error:
            fault, code = error.render(), INPUT_AT_FAULT
        except AtFault as error:
            fault, code = f"{file}: error: {error.format_message()}", error.exit_code
        if fault not in self.told:
            click.echo(fault, err=True)
        self.told.add(fault)
        return Paper(file, code=code, fault=fault)

    def _named(self, source: Source, file: str) -> str:
        """Return the problem that a file names, "" where it names none that is followed: that is told once for all."""
        try:
            if name := named_in(source, "problem", file):
                return name
            named_in(source, "exam", file)  # what is wrong with it is the reason
        except InputError as error:
            why = "\n".join(f"{each.message} {each.note}" for each in error.diagnostics)
            self.nameless.setdefault(why, []).append((file, error.render()))
            return ""
        fault = f"{file}: error: {NAMES_NOTHING}"
        self.nameless.setdefault(NAMES_NOTHING, []).append((file, fault))
        return ""

    def _why_nameless(self, file: str) -> str:
        return next(fault for found in self.nameless.values() for each, fault in found if each == file)

    def tell_nameless(self) -> None:
        """Tell of files that name no problem why that is, once where it is the same."""
        for (_, fault), *others in self.nameless.values():
            click.echo(fault, err=True)
            if others:
                names = ", ".join(file for file, _ in others[:SHOWN]) + (", …" if others[SHOWN:] else "")
                click.echo(f"the same in {len(others)} more of the files: {names}", err=True)

    def solution(self, name: str) -> Solution:
        """Return the solved problem; raises InputError."""
        if name not in self.solutions:
            problem = self.request.presentation.of(read_problem(source_of(name), catalogue()))
            if self.request.partial:
                problem = ruled(problem, self.request.partial, catalogue())
            told = self.request.presentation if self.request.solution else None
            self.solved[name] = solved_before(self.kept, problem, told) or self._solve(name, problem, told)
            self.solutions[name] = self.solved[name].solution()
        return self.solutions[name]

    def _solve(self, name: str, problem: Problem, told: Presentation | None) -> Solved:
        with self.meter.file(name) as notify:
            solved = solve_within(problem, self.request.limits, told, Supervision(notify))
        keep_solved(self.kept, solved, told)
        return solved

    def document(self, name: str) -> Document | None:
        """Return the worked solution in words where it is to be shown."""
        return self.solved[name].document(name) if self.request.solution else None

    def messages(self, name: str) -> Messages:
        """How a marking is worded: in the language and notation of the problem."""
        display = self.solutions[name].problem.display
        return Messages(self.request.templates, display.language, display.notation)


def submitted(file: str) -> Source:
    """Return the text of an answer file; raises InputError. A link that leads out of its folder is not followed."""
    return source_of(file) if file == STANDARD else load_submitted(Path(file))
