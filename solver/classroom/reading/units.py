"""Units behind numbers: 2 rad/s, 0.5 s. The answer's own is left out, its kind converted, others refused."""

from __future__ import annotations

import re

SPELLINGS = {
    "rad/s": ("rad/s", "rad/sec", "rad s^-1", "rad s⁻¹", "rad*s^-1", "1/s", "s^-1", "s⁻¹", "rads^-1"),
    "s": ("s", "sec", "secs", "second", "seconds", "sek", "Sekunden"),
    "°": ("°", "deg", "degree", "degrees", "Grad", "grad"),
    "dB": ("dB", "db", "decibel", "decibels"),
    "": ("Hz", "kHz", "mHz", "rad", "ms", "min", "rpm", "V", "volt"),
}
"""Units of answers and how they are written; under "" those that no answer has."""
CONVERTED = {
    "s": {"ms": "e-3", "min": "*60"},
    "rad/s": {"Hz": "*2*pi", "kHz": "*2000*pi", "rpm": "*pi/30"},
    "°": {"rad": "*180/pi"},
}
"""What stands behind a number instead of another unit of its kind; a power of ten, where it has digits alone."""
_DIGITS = re.compile(r"[-+]?\d+\.?\d*")
_UNIT = re.compile(r"^(.*[\d)\].])\s*([A-Za-zµ°][A-Za-z0-9/*^⁻¹\s-]*|1/s)\s*\.?$", re.DOTALL)
_BRACKETS = re.compile(r"(?<=[\w).])\s*\[\s*(rad/s|1/s|s|Hz|dB|V|ms|min)\s*\]\s*$")
_ALWAYS_UNITS = {
    each for own, spellings in SPELLINGS.items() for each in spellings if own in ("", "°", "dB") or "rad" in each
}


class ForeignUnitError(Exception):
    """A value has a unit that does not belong to the answer."""


def without_unit(text: str, unit: str) -> str:
    """Return a number without the unit of its answer ("": it has none). Raises ForeignUnitError."""
    text = _BRACKETS.sub(r" \1", text)
    found = _UNIT.match(text) if "∠" not in text else None  # the angle of 2∠30°
    if found is None:
        return text
    number, written = found[1].strip(), " ".join(found[2].split())
    if written in SPELLINGS.get(unit, ()) and unit:
        return number
    if factor := CONVERTED.get(unit, {}).get(written):
        return f"{number}{factor}" if _DIGITS.fullmatch(number) else _times(number, factor)
    foreign = _ALWAYS_UNITS if not unit else {each for spellings in SPELLINGS.values() for each in spellings}
    if written in foreign:
        wanted = f"{unit} is expected" if unit else "none is expected"
        raise ForeignUnitError(f"the unit {written} is not read; {wanted}")
    return text


def _times(number: str, factor: str) -> str:
    return f"({number})*10^(-3)" if factor.startswith("e") else f"({number}){factor}"
