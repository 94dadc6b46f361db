"""What is tried in its turn: long sweeps try a share, and another one with each change of CHANGELOG.md.

With WHOLE=1 in the environment (`make test-whole`) all is tried.
"""

import os
from pathlib import Path
from zlib import crc32

import pytest

WHOLE = os.environ.get("WHOLE") == "1"
TURN = crc32((Path(__file__).parents[2] / "CHANGELOG.md").read_bytes())


def in_turn(name: str, of: int) -> bool:
    """Whether it is the turn of what has this name, where one of so many is tried (a power of two)."""
    return WHOLE or crc32(name.encode()) % of == TURN % of


def one_of(place: int, of: int) -> tuple[pytest.MarkDecorator, ...]:
    """The marks of one of so many slow tests, numbered from 0, of which one is in turn, whichever it is."""
    return (pytest.mark.slow,) if WHOLE or place == TURN % of else (pytest.mark.slow, pytest.mark.whole)


def turn(name: str, of: int) -> tuple[pytest.MarkDecorator, ...]:
    """The marks of a slow test that is run in its turn."""
    return (pytest.mark.slow,) if in_turn(name, of) else (pytest.mark.slow, pytest.mark.whole)
