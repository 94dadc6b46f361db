"""An extremal as it was found, for the lemmas that judge what it is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sympy import Expr


@dataclass(frozen=True)
class Extremal:
    """`phi` is the integrand with constraints adjoined; `x` has the functions, and multipliers that vary, in t.

    `multipliers` are the constant ones by name.
    """

    phi: Expr
    x: Mapping[str, Expr]
    multipliers: Mapping[str, Expr]
    t_f: Expr
