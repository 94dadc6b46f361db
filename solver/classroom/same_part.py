"""A part as the key of what is remembered about it."""

from __future__ import annotations

from solver.problem.model import Part


class SamePart:
    """A part as it is: equal to itself only."""

    __slots__ = ("part",)

    def __init__(self, part: Part) -> None:
        self.part = part

    def __hash__(self) -> int:
        return id(self.part)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, SamePart) and self.part is other.part
