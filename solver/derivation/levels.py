"""Whether a derivation carries out its arithmetic, which only pages at the level `tutor` show and which costs most."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

_carried_out: ContextVar[bool] = ContextVar("arithmetic_carried_out", default=True)


@contextmanager
def carrying_out(wanted: bool) -> Iterator[None]:
    """Have the derivations that run meanwhile carry out their arithmetic, or leave it."""
    before = _carried_out.set(wanted)
    try:
        yield
    finally:
        _carried_out.reset(before)


def carries_out() -> bool:
    """Whether arithmetic is to be carried out now."""
    return _carried_out.get()
