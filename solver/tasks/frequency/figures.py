"""Bode's and Nyquist's diagrams of loops whose values are numbers."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from solver.derivation.frequency_figures import BodeDiagram, FrequencyResponse, MarkedFrequency, NyquistDiagram
from solver.lazy import exact

if TYPE_CHECKING:
    from sympy import Expr

LARGE = 8
"""A curve that goes farther than this from the origin hides what happens at −1."""


def response_of(L: exact.OnAxis, name: str = "L") -> FrequencyResponse:
    """Return a function on the axis in Bode's form, in numbers."""
    c, power = L.start
    roots = tuple((complex(r), m) for r, m in L.roots)
    period = 0.0 if L.sample_time is None else float(L.sample_time)
    return FrequencyResponse(name, float(c), power, roots, float(L.delay), period)


def bode_figure(
    caption: str,
    *loops: tuple[str, exact.OnAxis],
    margins: exact.Margins | None = None,
    marked: Iterable[tuple[Expr, str]] = (),
    asymptotes: bool = False,
) -> tuple[BodeDiagram, ...]:
    """Return Bode's diagram of functions under their names (LaTeX); marked are the margins of the first one.

    `marked` are further frequencies with their names.
    """
    marks = [*_margins(margins), *(MarkedFrequency(float(omega), name) for omega, name in marked)]
    responses = tuple(response_of(L, name) for name, L in loops)
    return (BodeDiagram(caption, responses, tuple(marks), asymptotes),)


def _margins(found: exact.Margins | None) -> Iterable[MarkedFrequency]:
    """The crossovers that decide with their margins; the others without."""
    if found is None:
        return
    for each in found.gains.found:
        decides = each is found.at_gain
        margin = float(found.phase_margin) if decides else None
        yield MarkedFrequency(float(each.omega), r"\omega_{g}" if decides else "", "gain", margin)
    for each in found.phases.found:
        decides = each is found.at_phase
        margin = float(found.gain_margin_db) if decides else None
        if each.omega != 0:
            yield MarkedFrequency(float(each.omega), r"\omega_{\varphi}" if decides else "", "phase", margin)


def nyquist_figures(
    caption: str, near: str, L: exact.OnAxis, crossings: Sequence[Expr], name: str = "L"
) -> tuple[NyquistDiagram, ...]:
    """Return Nyquist's diagram; of a curve that goes far from −1 also what happens near that point."""
    response = response_of(L, name)
    named = tuple(float(x) for x in dict.fromkeys(crossings))
    whole = NyquistDiagram(caption, response, named)
    if not _goes_far(L, named):
        return (whole,)
    return whole, NyquistDiagram(near, response, named, near=True)


def _goes_far(L: exact.OnAxis, crossings: Sequence[float]) -> bool:
    c, power = L.start
    sizes = [abs(x) for x in crossings] + ([abs(float(c))] if power == 0 else [])
    if power == 0 and L.excess == 0:
        sizes.append(abs(float(L.N.LC() / L.D.LC())))
    return max(sizes, default=0.0) > LARGE


__all__ = ["bode_figure", "nyquist_figures", "response_of"]
