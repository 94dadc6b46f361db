"""Bode's and Nyquist's diagrams as data: responses in Bode's form, in numbers, and what is marked in them."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class FrequencyResponse:
    """L(jω) = c (jω)^power ∏ (1 − jω/r)^m e^{−jωT}, under its name (LaTeX).

    `roots` are (r, m), m > 0 for zeros and < 0 for poles, of each conjugate pair the upper one; r real or complex.
    With a sampling `period` T it is c (z − 1)^power ∏ ((z − r)/(1 − r))^m at z = e^{jωT}, up to ω = π/T.
    """

    name: str
    gain: float
    power: int
    roots: tuple[tuple[complex, int], ...]
    delay: float = 0.0
    period: float = 0.0

    @property
    def last(self) -> float:
        """The Nyquist frequency of a discrete loop, else 0."""
        return math.pi / self.period if self.period else 0.0


@dataclass(frozen=True, slots=True)
class MarkedFrequency:
    """A frequency with its name (LaTeX, "" for a line alone); where it has a margin, that, in degrees or dB.

    `of` is "gain" where |L| = 1, "phase" where the phase is −180°, "" for a line alone.
    """

    omega: float
    name: str
    of: str = ""
    margin: float | None = None


@dataclass(frozen=True, slots=True)
class BodeDiagram:
    """Magnitude in dB above phase in degrees, over the frequency; `asymptotes` shows those of the first response.

    Marked are frequencies of the first response.
    """

    caption: str
    responses: tuple[FrequencyResponse, ...]
    marked: tuple[MarkedFrequency, ...] = ()
    asymptotes: bool = False
    alt: str = ""


@dataclass(frozen=True, slots=True)
class NyquistDiagram:
    """The curve of L(jω) in its plane with the point −1; that of ω < 0 is dashed.

    `crossings` are real values of L. `near` shows the surroundings of −1 only.
    """

    caption: str
    response: FrequencyResponse
    crossings: tuple[float, ...] = ()
    near: bool = False
    alt: str = ""


__all__ = ["BodeDiagram", "FrequencyResponse", "MarkedFrequency", "NyquistDiagram"]
