"""Where the solutions are written: names of the files, and writing them whole or not at all."""

from __future__ import annotations

import os
import sys
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

import click

from solver.cli.stems import stem_of, stems_of
from solver.document.formats import FORMATS

STANDARD = "-"
NAMELESS = "solution"  # the stem of what is read from standard input


class AtFault(click.ClickException):
    """Something outside of the program keeps it from writing a solution; exit code 2."""

    exit_code = 2


@dataclass(frozen=True, slots=True)
class Destination:
    """Formats, and where they go: `folder` (None: beside each problem), one `file`, or standard output."""

    formats: tuple[str, ...]
    folder: Path | None = None
    file: Path | None = None
    standard_output: bool = False
    stems: Mapping[str, str] = field(default_factory=dict)
    """What is written to the folder is called so, by the problem."""

    @staticmethod
    def named(
        output: str | None, formats: tuple[str, ...] | None, problems: tuple[str, ...], *, several: bool = False
    ) -> Destination:
        """Return what -o and -f mean for these problem files; raises click.UsageError if they don't fit together.

        `several` says that more than one is meant, even if there is one.
        """
        several = several or len(problems) > 1
        if output == STANDARD:
            return _to_standard_output(formats or ("html",), several=several)
        place = Path(output) if output else None
        if place is None or output is None:
            destination = Destination(formats or ("html",))
        elif _is_folder(output, place) or several or len(formats or ()) > 1:
            _refuse_name_of_a_file(output, place, several=several)
            destination = Destination(formats or ("html",), folder=place, stems=stems_of(problems, NAMELESS))
        else:
            destination = Destination(formats or (_format_of(place),), file=place)
        destination._refuse_collisions(problems)
        return destination

    def paths(self, problem: str) -> dict[str, Path]:
        """Return the file to be written for each format; none for standard output."""
        if self.standard_output:
            return {}
        if self.file is not None:
            return {self.formats[0]: self.file}
        source = Path(NAMELESS) if problem == STANDARD else Path(problem)
        stem = self.stems.get(problem) or stem_of(source)
        folder = self.folder if self.folder is not None else source.parent
        return {each: folder / (stem + FORMATS[each].suffix) for each in self.formats}

    def _refuse_collisions(self, problems: tuple[str, ...]) -> None:
        """Refuse to write two solutions to one file, or a solution over a problem."""
        writers: dict[Path, str] = {Path(problem).resolve(): problem for problem in problems if problem != STANDARD}
        for problem in dict.fromkeys(problems):
            for path in self.paths(problem).values():
                other = writers.setdefault(path.resolve(), f"the solution of {problem}")
                if other in problems:
                    raise click.UsageError(f"{path} is a problem file; it will not be overwritten.")
                if other != f"the solution of {problem}":
                    raise click.UsageError(f"{other} and the solution of {problem} would both be written to {path}.")


def _to_standard_output(formats: tuple[str, ...], *, several: bool) -> Destination:
    if len(formats) > 1 or several:
        raise click.UsageError("-o - writes one problem in one format: name one FILE and one format.")
    if formats == ("pdf",) and sys.stdout.isatty():
        raise click.UsageError("a PDF is not for a terminal: name a file with -o, or send the output to one.")
    return Destination(formats, standard_output=True)


def _refuse_name_of_a_file(output: str, place: Path, *, several: bool) -> None:
    """Raise click.UsageError where several files would go to a new folder that is called like one of them."""
    if _is_folder(output, place) or not (meant := _format_named_by(place)):
        return
    ways = f"name a folder, {place.with_suffix('')}/" + ("" if several else f", or {meant} alone with -f {meant}")
    raise click.UsageError(f"{place} is one file, and several are to be written: {ways}.")


def _is_folder(output: str, place: Path) -> bool:
    return output.endswith(("/", os.sep)) or place.is_dir()


def _format_of(place: Path) -> str:
    """Return the format that a file's ending means (html if it means none)."""
    return _format_named_by(place) or "html"


def _format_named_by(place: Path) -> str:
    """Return the format that a file's ending means, "" if it means none."""
    return next((each for each, form in FORMATS.items() if form.suffix == place.suffix.lower()), "")


def write_whole(path: Path, content: bytes) -> None:
    """Write a file so that it is either all there or unchanged; raises AtFault in words."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        _replace(path, content)
    except OSError as error:
        raise AtFault(f"cannot write {path}: {error.strerror or error}; say with -o where to write") from None


def write_changed(path: Path, content: bytes) -> None:
    """Write a file as `write_whole` does, unless it holds just that: then it keeps its time."""
    try:
        unchanged = path.is_file() and path.stat().st_size == len(content) and path.read_bytes() == content
    except OSError:
        unchanged = False
    if not unchanged:
        write_whole(path, content)


def write_beside(path: Path, content: bytes) -> None:
    """Write a file as `write_changed` does into a folder that strangers have filled.

    A link that stands in its place, or a pipe, is replaced: it leads where the file must not go.
    """
    try:
        if path.is_symlink() or path.is_fifo():
            path.unlink()
    except OSError as error:
        raise AtFault(f"cannot write {path}: {error.strerror or error}; say with -o where to write") from None
    write_changed(path, content)


def _replace(path: Path, content: bytes) -> None:
    """Write beside the file, then put it in place; what is not a regular file (/dev/null, a pipe) is written to."""
    if path.exists() and not path.is_file():
        path.write_bytes(content)
        return
    target = path.resolve()  # a link stays a link
    handle, scratch = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name[:50]}.")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        Path(scratch).chmod(target.stat().st_mode & 0o7777 if target.exists() else 0o666 & ~_umask())
        Path(scratch).replace(target)
    except BaseException:
        with suppress(OSError):
            Path(scratch).unlink()
        raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
