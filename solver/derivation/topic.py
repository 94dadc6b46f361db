"""What the folder of a topic declares."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Topic:
    """A topic: its title, the group of topics that it stands in, and its place there."""

    group: str
    order: int
    title: str
