"""What parameters decide, as figures: root loci, and where conditions on two parameters hold."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Locus:
    """The roots of D + K N for K ≥ 0: the coefficients of N and D, highest power first, numbers; `gain` is K's LaTeX.

    `angles` of asymptotes are in degrees, from `centroid`. `meetings` are points with their K > 0, where branches meet,
    `crossings` those not below the real axis where they cross the imaginary axis, in discrete time the unit circle.
    """

    caption: str
    numerator: tuple[Any, ...]
    denominator: tuple[Any, ...]
    gain: str = "K"
    centroid: Any = None
    angles: tuple[Any, ...] = ()
    meetings: tuple[tuple[Any, Any], ...] = ()
    crossings: tuple[tuple[Any, Any], ...] = ()
    discrete: bool = False


@dataclass(frozen=True, slots=True)
class ParameterRegion:
    """Where all `conditions`, polynomials in the symbols `x` and `y`, are positive; shaded in the plane of both.

    `names` are the curves on which they are zero, `labels` those of the axes, all as LaTeX.
    """

    caption: str
    x: Any
    y: Any
    conditions: tuple[Any, ...]
    names: tuple[str, ...]
    labels: tuple[str, str]
