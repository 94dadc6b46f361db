"""The work of `solve variants`: search, solve within limits, write, and say what it took."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import click

from solver.cli.destination import NAMELESS, STANDARD, AtFault, write_changed
from solver.cli.executing import Workers
from solver.cli.keeping import pdf_engine
from solver.cli.progress import search_bar
from solver.cli.solving import INPUT_AT_FAULT, SOLVED, UNSOLVED, settle, source_of
from solver.cli.store import Store
from solver.document.model import Presentation
from solver.limits import Limits
from solver.papers.again import members_again
from solver.papers.difficulty import Difficulty, spread_of
from solver.papers.families import Member, family_of
from solver.papers.making import YAML, Wanted
from solver.papers.search import Search
from solver.papers.telling import shortage, took
from solver.problem.model import Problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue


@dataclass(frozen=True, slots=True)
class Order:
    """What the command line asks for."""

    file: str
    count: int
    seed: int
    formats: tuple[str, ...]
    output: str | None
    presentation: Presentation
    limits: Limits
    check: bool
    draws: int
    workers: Workers
    again: bool = False

    @property
    def stem(self) -> str:
        """What the names of members begin with."""
        path = Path(NAMELESS if self.file == STANDARD else self.file)
        return path.stem if path.suffix.lower() in (".yaml", ".yml") else path.name

    @property
    def folder(self) -> Path:
        """Where they are written."""
        if self.output is not None:
            return Path(self.output)
        beside = Path() if self.file == STANDARD else Path(self.file).parent
        return beside / f"{self.stem}-variants"


def draw_members(order: Order) -> int:
    """Draw, write and tell the members; return the exit code."""
    if order.output == STANDARD or order.folder.is_file():
        raise click.UsageError("members are several files: name a folder with -o.")
    try:
        source = source_of(order.file)
        problem = read_problem(source, catalogue())
        family = family_of(problem)
    except InputError as error:
        click.echo(error.render(), err=True)
        return INPUT_AT_FAULT
    settle()
    store = Store(order.folder, order.presentation.templates, anew=order.again)
    with order.workers.executor() as executor, search_bar(order.count) as tell:
        search = Search(source, family, order.seed, order.draws, executor, tell)
        wanted = Wanted(order.formats, order.presentation, order.limits, order.check)
        found: list[Member] = []
        for member in members_again(
            store,
            problem,
            search,
            order.count,
            wanted,
            order.stem,
            engine=pdf_engine(order.formats, wanted.presentation),
        ):
            _write(member, order, problem)
            found.append(member)
        tell(search.draws, len(found))
    store.forget_others()
    return _conclude(order, source, search, found)


def _write(member: Member, order: Order, problem: Problem) -> None:
    """Write the files of a member, and what stands beside them."""
    files = {(member.name + name if name.startswith(".") else name): each for name, each in member.made.files.items()}
    if YAML in order.formats:
        files[f"{member.name}.yaml"] = member.text.encode()
        files |= {address: image.content for address, image in problem.images.items()}
    for name, content in files.items():
        path = order.folder / name
        if order.file != STANDARD and path.resolve() == Path(order.file).resolve():
            raise AtFault(f"{path} is the family itself; it is not overwritten")
        write_changed(path, content)
    values = ", ".join(f"{name} = {text}" for name, text in member.values.items())
    click.echo(f"{member.name}: {values}")


def _conclude(order: Order, source: Source, search: Search, found: Sequence[Member]) -> int:
    """Say what it took, how difficult they are, and what is missing; return the exit code."""
    if found:
        kinds = ", ".join(order.formats)
        click.echo(f"wrote {len(found)} {'members' if len(found) > 1 else 'member'} ({kinds}) to {order.folder}")
    click.echo(took(search))
    difficulties = [member.made.difficulty for member in found if member.made.difficulty is not None]
    if order.check and difficulties:
        click.echo(_table(difficulties, [member.name for member in found]))
    if len(found) >= order.count:
        return SOLVED
    click.echo(shortage(search, source, order.count).render(), err=True)
    return UNSOLVED


def _table(difficulties: Sequence[Difficulty], names: Sequence[str]) -> str:
    """Return the spread of difficulty as a table."""
    rows = [("difficulty", "least", "median", "most", "in")]
    for each in spread_of(difficulties):
        first = ", ".join(names[number - 1] for number in each.hardest[:3]) + (", …" if each.hardest[3:] else "")
        where = first if each.least < each.most else "all"
        rows.append((each.name, str(each.least), str(each.median), str(each.most), where))
    return "\n".join(f"{a:20}{b:>7}{c:>8}{d:>7}  {e}" for a, b, c, d, e in rows)
