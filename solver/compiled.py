"""Templates compiled once and kept, as Python keeps its modules: a cold start would spend a fifth of its time on them.

They lie in `__pycache__` beside the installed templates, which are as trusted as the program. A user's folder of
templates is compiled anew each time, and where nothing can be written, all are.
"""

from __future__ import annotations

import sys
from contextlib import suppress
from pathlib import Path

import jinja2
from jinja2.bccache import Bucket

from solver import resources


class Kept(jinja2.FileSystemBytecodeCache):
    """Compiled templates in a folder; a template that has changed since is compiled anew."""

    def __init__(self) -> None:
        folder = resources.root("templates") / "__pycache__"
        if not sys.dont_write_bytecode:
            with suppress(OSError):
                folder.mkdir()
        super().__init__(str(folder), f"%s.jinja-{jinja2.__version__}.{sys.implementation.cache_tag}")

    def load_bytecode(self, bucket: Bucket) -> None:
        """Take a compiled template, if it can be read."""
        with suppress(OSError):
            super().load_bytecode(bucket)

    def dump_bytecode(self, bucket: Bucket) -> None:
        """Keep a compiled template, if that is wanted and can be."""
        if not sys.dont_write_bytecode:
            with suppress(OSError):
                super().dump_bytecode(bucket)


def kept(templates: Path | None) -> Kept | None:
    """Return where compiled templates are kept; nowhere, if a user's folder comes first."""
    return Kept() if templates is None else None
