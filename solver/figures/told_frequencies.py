"""What is seen in Bode's and Nyquist's diagrams, in words made from their data."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from solver.derivation.frequency_figures import BodeDiagram, FrequencyResponse, NyquistDiagram
from solver.figures.alternatives import number_text, sentences, text_of
from solver.figures.bode import PER_NEPER, corners, margin_of
from solver.figures.nyquist import on_the_axis_of_poles
from solver.figures.responses import decades, factors_at
from solver.words import Phrase

Say = Callable[[str], str]


def told_bode(figure: BodeDiagram, say: Say) -> str:
    """Tell where magnitudes and phases begin and end, where the asymptotes bend, and what is marked."""
    low, high = decades(figure.responses, [each.omega for each in figure.marked])
    told = [say("Bode diagram, logarithmic in the frequency")]
    for each in figure.responses:
        told += _course(each, low, high, say)
    if figure.asymptotes:
        told += _bends(figure.responses[0], say)
    for mark in figure.marked:
        if mark.omega > 0:
            size, angle = _at(figure.responses[0], mark.omega)
            values = {"omega": number_text(mark.omega), "size": size, "angle": angle}
            name = text_of(margin_of(mark)).replace("^∘", "°")
            margin = f" ({name})" if mark.margin is not None else ""
            told.append(say(Phrase("marked: ω = {omega} rad/s with {size} dB and {angle}°", **values)) + margin)
    return sentences(told)


def _course(response: FrequencyResponse, low: float, high: float, say: Say) -> Iterator[str]:
    (first, early), (last, late) = (_at(response, omega) for omega in (low, high))
    values = {
        "name": text_of(response.name), "low": number_text(low), "high": number_text(high), "first": first,
        "last": last, "early": early, "late": late,
    }  # fmt: skip
    says = "{name} from {first} dB and {early}° at ω = {low} rad/s to {last} dB and {late}° at ω = {high} rad/s"
    yield say(Phrase(says, **values))


def _at(response: FrequencyResponse, omega: float) -> tuple[str, str]:
    """dB and degrees as text."""
    size, angle = factors_at(response, np.array([omega]))
    return number_text(PER_NEPER * float(size[0])), number_text(float(angle[0]))


def _bends(response: FrequencyResponse, say: Say) -> Iterator[str]:
    slope = 20 * response.power
    yield say(Phrase("the asymptotes begin with {slope} dB a decade", slope=number_text(slope)))
    for omega, change in corners(response):
        slope += 20 * change
        yield say(Phrase("from ω = {omega} on {slope} dB a decade", omega=number_text(omega), slope=number_text(slope)))


def told_nyquist(figure: NyquistDiagram, say: Say) -> str:
    """Tell where the curve begins and ends, where it meets the real axis, and what it does at infinity."""
    response, name = figure.response, text_of(figure.response.name)
    told = [say(Phrase("Nyquist diagram of {name} with the point −1", name=name))]
    if figure.near:
        told[0] = say(Phrase("Nyquist diagram of {name} near the point −1", name=name))
    if response.power < 0:
        values = {"count": -response.power, "name": name}
        told.append(say(Phrase("for ω → 0 the curve goes to infinity, half turns there: {count}", **values)))
    elif response.power == 0:
        told.append(say(Phrase("it begins at {value} for ω = 0", value=number_text(response.gain))))
    for omega, m in on_the_axis_of_poles(response):
        values = {"omega": number_text(omega), "count": m}
        told.append(say(Phrase("at ω = {omega} it goes to infinity, half turns there: {count}", **values)))
    for value in figure.crossings:
        told.append(say(Phrase("it meets the real axis at {value}", value=number_text(value))))
    told.append(say("the curve of negative frequencies is its mirror image"))
    return sentences(told)


__all__ = ["told_bode", "told_nyquist"]
