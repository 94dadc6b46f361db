"""Draws made from their answer: its numbers are chosen first, and what is drawn is what they make of it.

Where hardly any draw comes out nicely, every other one is constructed. It is a draw as any other: its values are among
those that the file gives, and it is judged and solved like the others. Which one it is depends on the seed and its
number alone.
"""

from __future__ import annotations

from typing import Protocol


class Construction(Protocol):
    """A way to draws whose answer is nice."""

    def at(self, number: int) -> list[int] | None:
        """Return the places of the values of a draw by its number, None where none was found."""
