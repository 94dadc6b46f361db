"""What is asked of a function at an end of the time over which a functional is taken."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sympy import Expr


@dataclass(frozen=True)
class End:
    """A value, or a curve in t on which the end lies; free without both."""

    value: Expr | None = None
    curve: Expr | None = None

    @property
    def free(self) -> bool:
        """Whether nothing is asked."""
        return self.value is None and self.curve is None


@dataclass(frozen=True)
class IntegralConstraint:
    """An integral over the same time that has a value."""

    integrand: Expr
    value: Expr
