"""What was solved for a folder of papers, each in a file of its own below `.solve/`, named by what it depends on.

The files are compressed JSON. One that cannot be read is nothing; those that a command did not use are taken away when
it has come to its end.
"""

from __future__ import annotations

import json
import zlib
from contextlib import suppress
from pathlib import Path
from typing import Any

from solver.cli.destination import AtFault, write_whole
from solver.cli.kept import hash_of_folder, key_of

FOLDER = ".solve"
SUFFIX = ".json.z"
LARGEST = 2**26
"""Bytes of what is kept of one thing; nothing unpacks to more."""


class Store:
    """Keeps plain data for a folder; the facts are completed by the templates. `anew` reads nothing that was there.

    What is kept `apart`, by such a name, is taken away apart.
    """

    def __init__(self, folder: Path, templates: Path | None, *, anew: bool = False, apart: str = "") -> None:
        self.folder = folder / FOLDER / apart
        self.templates = templates
        self.anew = anew
        self.used: set[str] = set()

    @property
    def place(self) -> str:
        """The folder, "" where nothing is in it that was used or put."""
        return str(self.folder) if self.used else ""

    @property
    def is_new(self) -> bool:
        """Whether nothing is there that could be read."""
        return self.anew or not any(self.folder.glob(f"*{SUFFIX}"))

    def get(self, *facts: Any) -> Any:
        """Return what was put for the same facts, None where there is nothing, or nothing that can be read."""
        key = self._key(facts)
        if self.anew and key not in self.used:
            return None
        try:
            packed = (self.folder / (key + SUFFIX)).read_bytes()
            unpacker = zlib.decompressobj()
            content = unpacker.decompress(packed, LARGEST)
            data = json.loads(content) if unpacker.eof else None
        except (OSError, ValueError, RecursionError, zlib.error):
            return None
        self.used.add(key)
        return data

    def put(self, data: Any, *facts: Any) -> None:
        """Keep plain data; where it cannot be written nothing is lost but time."""
        key = self._key(facts)
        self.used.add(key)
        content = zlib.compress(
            json.dumps(data, ensure_ascii=False, separators=(",", ":")).encode("utf-8", "surrogatepass")
        )
        with suppress(AtFault):
            write_whole(self.folder / (key + SUFFIX), content)

    def forget_others(self) -> None:
        """Take away what was not used."""
        for path in self.folder.glob(f"*{SUFFIX}"):
            if path.name.removesuffix(SUFFIX) not in self.used:
                with suppress(OSError):
                    path.unlink()

    def _key(self, facts: tuple[Any, ...]) -> str:
        return key_of(hash_of_folder(self.templates), *facts)[:40]
