"""Where the templates and problems are: inside an installed package, or beside it in a checkout."""

from __future__ import annotations

from functools import cache
from pathlib import Path


@cache
def root(kind: str) -> Path:
    """Return the folder "templates" or "problems"; raises FileNotFoundError if the installation is broken."""
    package = Path(__file__).parent
    for folder in (package / "_data" / kind, package.parent / kind):
        if folder.is_dir():
            return folder
    raise FileNotFoundError(f"the folder {kind!r} is neither inside the solver package nor beside it")
