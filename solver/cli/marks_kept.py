"""Where markings are kept from one `solve check` to the next: in the folder that it writes to.

They are not kept where answer files are: who hands them in could write markings, too.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextlib import AbstractContextManager, closing
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING

from solver.cli.destination import STANDARD
from solver.cli.papers import CheckRequest
from solver.cli.store import Store

if TYPE_CHECKING:
    from solver.executors import Executor
    from solver.papers.kept import Kept


def marks_kept(request: CheckRequest, about: str, files: Sequence[str]) -> Kept:
    """Return what keeps the markings of answers to a problem or an exam; nothing is kept where no file is written."""
    from solver.papers.kept import NOTHING

    folder = _folder(request)
    if folder is None or request.syntax or any(_is_in(folder, Path(file).parent) for file in files if file != STANDARD):
        return NOTHING
    named = os.path.relpath(about, folder) if about not in {"", STANDARD} else about
    return Store(
        folder, request.templates, anew=request.again, apart=f"marks-{sha256(named.encode()).hexdigest()[:12]}"
    )


def _folder(request: CheckRequest) -> Path | None:
    """Return the folder of sheets or data, else that of the table or the report."""
    output = request.output
    if output and output != STANDARD:
        path = Path(output)
        return path if path.is_dir() or output.endswith("/") or not path.suffix else path.parent
    other = next((path for path in (request.table, request.report) if path and path != STANDARD), None)
    return Path(other).parent if other else None


def _is_in(folder: Path, other: Path) -> bool:
    return folder.resolve().is_relative_to(other.resolve())


def working(request: CheckRequest, kept: Kept) -> AbstractContextManager[Executor]:
    """Return who makes the calls; where there may be none to make, nothing is prepared for them."""
    executor = request.workers.executor()
    return closing(executor) if isinstance(kept, Store) and not kept.is_new else executor


def tidy(request: CheckRequest, kept: Kept) -> None:
    """Take away what was not used where a whole folder was marked."""
    if isinstance(kept, Store) and any(Path(name).is_dir() for name in request.files):
        kept.forget_others()
