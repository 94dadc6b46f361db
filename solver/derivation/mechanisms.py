"""The drawing of a mechanical system as data: joints, what links them, coordinates, forces. Places are numbers.

Labels are LaTeX without dollar signs. The longest rod is one unit; y points up, angles are degrees from the right.
"""

from __future__ import annotations

from dataclasses import dataclass

Place = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Joint:
    """A body or what others hang from: "box", "disc", "pivot" (no mass, it moves), "support" (fixed), "wall".

    `direction` is that of the line which it moves along, None where there is none.
    """

    shape: str
    place: Place
    label: str = ""
    direction: Place | None = None


@dataclass(frozen=True, slots=True)
class Link:
    """A "rod", a "spring", a "beam" or a massless "guide" along which the second joint slides; joints by number."""

    kind: str
    ends: tuple[int, int]
    label: str = ""


@dataclass(frozen=True, slots=True)
class Distance:
    """A coordinate that is a length: it grows from `start` to the joint; `link` is the one that it is the length of."""

    label: str
    start: Place
    joint: int
    link: int | None = None


@dataclass(frozen=True, slots=True)
class Turn:
    """A coordinate that is an angle at a joint, from the direction `start` to that of the link."""

    label: str
    link: int
    start: float
    stop: float


@dataclass(frozen=True, slots=True)
class Push:
    """A force on a joint along a direction."""

    label: str
    joint: int
    direction: Place


@dataclass(frozen=True, slots=True)
class Mechanism:
    """The drawing of bodies, rods and springs; `gravity` is the label of its arrow, "" for none."""

    caption: str
    joints: tuple[Joint, ...]
    links: tuple[Link, ...] = ()
    distances: tuple[Distance, ...] = ()
    turns: tuple[Turn, ...] = ()
    pushes: tuple[Push, ...] = ()
    gravity: str = ""
    alt: str = ""
