"""`solve FOLDER -o build/` again: what a file was solved to is kept while nothing that it depends on has changed."""

from __future__ import annotations

import os
from collections.abc import Collection, Mapping
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from solver.cli.destination import STANDARD
from solver.cli.kept import Record, hash_of_folder, key_of
from solver.cli.outcome import INPUT_AT_FAULT, Outcome
from solver.problem.files import load
from solver.problem.images import Image, NoImage, load_image
from solver.problem.source import InputError, Source

if TYPE_CHECKING:
    from solver.cli.solving import Request
    from solver.document.model import Presentation


class Solved:
    """What files were solved to; `told` has what is told of those that did not change and whose files are all there.

    Nothing is kept where files do not go to one folder. Who leaves the context writes the record.
    """

    def __init__(self, request: Request, *, anew: bool = False) -> None:
        self.request = request
        folder = request.destination.folder
        self.record = Record(folder, anew=anew) if folder is not None else None
        self.folder = folder or Path()
        found = {file: self._get(file) for file in request.files}
        self.told = {file: outcome for file, outcome in found.items() if outcome is not None}

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self.record is not None:
            self.record.write()

    def _get(self, file: str) -> Outcome | None:
        """Return what is told of a file, None where it is to be solved."""
        if self.record is None or file == STANDARD:
            return None
        try:
            source = load(file)
        except InputError:
            return None
        name, key = self._name_of(file), self._key_of(file, source)
        told = self.record.get(name, key)
        if told is None or not _is_told(told) or told["images"] != images_of(source, told["images"]):
            return None
        return Outcome(told["code"], told["out"], told["err"])

    def put(self, file: str, source: Source, images: Mapping[str, Image], made: Outcome, told: Outcome) -> None:
        """Keep what is told of a file that was read as `source`, and which files were written."""
        if self.record is None or file == STANDARD or told.code >= INPUT_AT_FAULT:
            return
        files = {Path(path).relative_to(self.folder).as_posix(): each for path, each in made.files.items()}
        pictures = {address: image.file_name for address, image in images.items()}
        data = {"code": told.code, "out": told.out, "err": told.err, "images": pictures}
        self.record.put(self._name_of(file), self._key_of(file, source), files, data)

    def _name_of(self, file: str) -> str:
        return "solved " + Path(os.path.relpath(file, self.folder)).as_posix()

    def _key_of(self, file: str, source: Source) -> str:
        request, destination = self.request, self.request.destination
        where = {format_: str(path) for format_, path in destination.paths(file).items()}
        presentation = request.presentation
        told = (
            repr(presentation),
            hash_of_folder(presentation.templates),
            request.verbose,
            pdf_engine(destination.formats, presentation),
        )
        return key_of(file, source.text, where, told)


def pdf_engine(formats: Collection[str], presentation: Presentation) -> str:
    """Return what makes PDFs, where some are made."""
    from solver.render import pdf

    if "pdf" not in formats:
        return ""
    with suppress(pdf.PdfUnavailable):
        return str(pdf.chosen(presentation.pdf_engine))
    return ""


def images_of(source: Source, addresses: Any) -> dict[str, str]:
    """Return the images at these addresses by what they hold, "" where there is none."""
    found: dict[str, str] = {}
    for address in addresses:
        found[address] = ""
        with suppress(NoImage):
            found[address] = load_image(address, source).file_name
    return found


def _is_told(told: Mapping[str, Any]) -> bool:
    kinds = {"code": int, "out": str, "err": str, "images": dict}
    return set(told) == set(kinds) and all(isinstance(told[name], kind) for name, kind in kinds.items())
