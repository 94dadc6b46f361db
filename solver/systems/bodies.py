"""What a mechanical system is made of: bodies in the plane and springs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sympy import Expr


@dataclass(frozen=True)
class Body:
    """A body in the plane, y upward: its mass and the position of its centre, its inertia about it and its angle."""

    mass: Expr | None = None
    position: tuple[Expr, ...] = ()
    inertia: Expr | None = None
    angle: Expr | None = None


@dataclass(frozen=True)
class Spring:
    """A spring: stiffness, length, and the length at which it is at rest."""

    stiffness: Expr
    length: Expr
    rest: Expr
