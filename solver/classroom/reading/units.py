"""Units behind numbers: 2 rad/s, 0.5 s. The answer's own is left out, its kind converted, others refused."""

from __future__ import annotations

import re
from collections.abc import Sequence

SPELLINGS = {
    "rad/s": (
        "rad/s",
        "rad/sec",
        "rad per second",
        "rad·s⁻¹",
        "rad·s^-1",
        "rad s^-1",
        "rad s⁻¹",
        "rad*s^-1",
        "1/s",
        "s^-1",
        "s⁻¹",
        "rads^-1",
    ),
    "1/s": ("1/s", "s^-1", "s⁻¹", "1/sec", "sec^-1"),
    "1/s^2": ("1/s^2", "1/s²", "s^-2", "s⁻²", "1/sec^2", "sec^-2"),
    "s": ("s", "sec", "secs", "second", "seconds", "sek", "Sekunden"),
    "°": ("°", "deg", "degree", "degrees", "Grad", "grad"),
    "dB": ("dB", "db", "decibel", "decibels"),
    "dB/decade": (
        "dB/dec",
        "dB/decade",
        "dB/Dekade",
        "dB/Dek",
        "dB/dek",
        "db/dek",
        "dB per decade",
        "dB pro Dekade",
        "db/dec",
        "db/decade",
    ),
    "ratio": (),
    "": ("dB/oct", "dB/octave", "dB/Oktave", "Hz", "kHz", "mHz", "rad", "ms", "min", "rpm", "V", "volt"),
}
"""Units of answers and how they are written; under "" those that no answer has. A ratio may be told in decibels."""
CONVERTED = {
    "s": {"ms": "e-3", "min": "*60"},
    "rad/s": {"Hz": "*2*pi", "kHz": "*2000*pi", "rpm": "*pi/30"},
    "°": {"rad": "*180/pi"},
    "ratio": dict.fromkeys(SPELLINGS["dB"], "dB"),
}
"""What stands behind a number instead of another unit of its kind; a power of ten, where it has digits alone; or dB."""
_PER_SECONDS = {
    unit: re.compile(rf"(?<=[\d)\]π])(?<!\s1)\s*/\s*s(?:ec)?{power}\s*\.?$")
    for unit, power in (("1/s", ""), ("rad/s", ""), ("1/s^2", r"(?:²|\^2)"))
}
"""5/s is 5 1/s."""
_DIGITS = re.compile(r"[-+]?\d+\.?\d*")
_WHOLE = re.compile(r"[-+]?\d{1,3}")
_OF_PI = re.compile(r"[-+−]?\s*[\d./]*\s*[*·]?\s*(?:π|pi)\s*(?:[/*·]\s*[\d.]+)?")
_UNIT = re.compile(r"^(.*(?:[\d)\].π∞]|\bpi))\s*([A-Za-zµ°][A-Za-z0-9/*·^⁻¹²\s-]*|1/s(?:²|\^2)?)\s*\.?$", re.DOTALL)
_LIST = re.compile(r"^\s*[\[({]([^\[\](){}]*[,;][^\[\](){}]*)[\])}]\s*([A-Za-zµ°1][A-Za-z0-9/*^⁻¹\s-]*|°)\s*$")
_BRACKETS = re.compile(r"(?<=[\w).])\s*\[\s*(rad/s|1/s|s|Hz|dB|V|ms|min)\s*\]\s*$")
_BRACED = re.compile(r"(?<=[\d\s/])(s|sec|rad[ */]?s)\s*\^\s*[{(]\s*([-−]1)\s*[)}](?=\s*$)")
_ARGUMENT = re.compile(r"(?:sin|cos|tan)\s*\(?\s*[\d.]+\s*°$")
_DEGREES, _LETTERS = re.compile(r"(?<=[\d)])\s*°"), re.compile(r"[^\W\d_]")
_ALWAYS_UNITS = {
    each for own, spellings in SPELLINGS.items() for each in spellings if own in ("", "°", "dB") or "rad" in each
}


class ForeignUnitError(Exception):
    """A value has a unit that does not belong to the answer."""


def without_unit(text: str, unit: str) -> str:
    """Return a number without the unit of its answer ("": it has none). Raises ForeignUnitError."""
    text = _BRACED.sub(r"\1^\2", _BRACKETS.sub(r" \1", text))
    if unit in _PER_SECONDS:
        text = _PER_SECONDS[unit].sub("", text)
    found = None if "∠" in text or _ARGUMENT.search(text) else _UNIT.match(text)  # the angle of 2∠30°, cos 30°
    if found is None:
        return text
    number, written = found[1].strip(), " ".join(found[2].split())
    if unit == "°" and written in SPELLINGS[unit] and not _LETTERS.search(number):
        number = _DEGREES.sub("", number)  # 180° - 154.6°
    if written in SPELLINGS.get(unit, ()) and unit:
        if unit == "°" and _OF_PI.fullmatch(number):
            raise ForeignUnitError(f"a multiple of π is in radians, and {written} stands behind it")
        return number
    if factor := CONVERTED.get(unit, {}).get(written):
        return f"{number}{factor}" if _DIGITS.fullmatch(number) and factor != "dB" else _times(number, factor)
    foreign = _ALWAYS_UNITS if not unit else {each for spellings in SPELLINGS.values() for each in spellings}
    if written in foreign:
        wanted = f"{unit} is expected" if unit not in ("", "ratio") else "none is expected"
        raise ForeignUnitError(f"the unit {written} is not read; {wanted}")
    return text


def shared(items: Sequence[str], unit: str) -> list[str]:
    """Return the items of 1, 10, 50 rad/s, each with the unit behind the last; others as they are."""
    last = _UNIT.match(items[-1]) if items else None
    if last is None or not unit or any(_UNIT.match(each) for each in items[:-1]):
        return [*items]
    written = " ".join(last[2].split())
    known = written in SPELLINGS[unit] or written in CONVERTED.get(unit, {}) or written in _ALWAYS_UNITS
    return [f"{each} {written}" for each in items[:-1]] + [items[-1]] if known else [*items]


def inside(text: str, unit: str) -> str:
    """Return [1, 10, 50] rad/s as a list without brackets; any other text as it is."""
    found = _LIST.match(text)
    return f"{found[1]} {found[2]}" if found and unit and shared(["1", f"1 {found[2]}"], unit)[0] != "1" else text


def _times(number: str, factor: str) -> str:
    if factor == "dB":  # nobody means less than a tenth: √2 is 3 dB
        return f"10^(({number}.0)/20)" if _WHOLE.fullmatch(number) else f"10^(({number})/20)"
    return f"({number})*10^(-3)" if factor.startswith("e") else f"({number}){factor}"
