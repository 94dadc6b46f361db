"""An object as the key of what is remembered about it."""

from __future__ import annotations

from typing import Generic, TypeVar

Kind = TypeVar("Kind")


class Same(Generic[Kind]):
    """An object as it is: equal to itself only."""

    __slots__ = ("it",)

    def __init__(self, it: Kind) -> None:
        self.it = it

    def __hash__(self) -> int:
        return id(self.it)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Same) and self.it is other.it
