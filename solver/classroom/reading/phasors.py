"""Phasors in place of the sinusoids they stand for: 3.54∠-45° is 3.54 sin(ωt - 45°) beside an input that is a sine."""

from __future__ import annotations

import re
from typing import Any

import sympy as sp

_PHASOR = re.compile(
    r"^\s*(?P<size>[^∠=<>,;]+?)\s*∠\s*\(?(?P<angle>[-+−]?[^∠=<>,;()]*(?:°|deg|rad|π|pi)[^∠=<>,;()]*)\)?\s*$"
)


def as_sinusoid(text: str, ours: Any) -> str:
    """Return a phasor as a sinusoid like ours, of its frequency, a cosine or a sine; any other text as it is."""
    found = _PHASOR.match(text)
    waves = ours.atoms(sp.sin, sp.cos) if found and isinstance(ours, sp.Expr) else set()
    moving = [(wave.func, wave.args[0].as_independent(*_times(wave), as_Add=True)[1]) for wave in waves if _times(wave)]
    if found is None or len(moving) != 1:
        return text
    ((wave, angle),) = moving
    return f"{found['size']}*{wave}({angle} + ({found['angle'].strip()}))"


def _times(wave: sp.Basic) -> list[sp.Symbol]:
    return [each for each in wave.free_symbols if isinstance(each, sp.Symbol) and each.name in ("t", "k")]
