"""Sequences with values of their own at the beginning: f(0) = a, f(k) = g for k >= 1; 0 for k = 0, g for k >= 1."""

from __future__ import annotations

import re

from solver.classroom.reading.brackets import split

_BETWEEN = re.compile(r"\s*[;\n]\s*|\s*,\s*(?:and\s+|und\s+)?|\s+(?:and|und)\s+")
_FOR = r"(?:for|für|if|falls|when|wenn)"
_VALUE_AT = re.compile(r"[A-Za-z]\s*[(\[_]\s*(\d)\s*[)\]]?\s*=\s*([^=<>]+)")
_LABEL = re.compile(r"^[A-Za-z]\s*(?:[(\[]\s*[kn]\s*[)\]]|_[kn])?\s*=\s*")
_CONDITION = re.compile(
    rf"\s*(?:{_FOR}\s+)?[kn]\s*(?:(?P<sign>>=|≥|\\geq?|=|<=|≤|\\leq?|<|>)\s*(?P<at>\d)(?P<on>\s*,\s*\d.*)?)\s*\.?"
)
_ELSE = "(?:otherwise|sonst|else)"
_PIECE = re.compile(rf"(?P<value>.+?)\s+(?P<condition>{_FOR}\s.+|{_ELSE})|{_ELSE}\s*:?\s+(?P<rest>.+)")
MOST_VALUES = 4


def with_first_values(text: str) -> str:
    """Return what is told of the first values and of the later ones as a sum with unit pulses; "" of any other text."""
    text = _LABEL.sub("", text.strip(), count=1)
    values: dict[int, str] = {}
    later: list[tuple[int, str]] = []
    rest = ""
    for piece in _with_conditions(split(text, _BETWEEN)):
        if first := _VALUE_AT.fullmatch(piece):
            values[int(first[1])] = first[2]
            continue
        found = _PIECE.fullmatch(_LABEL.sub("", piece, count=1))
        if found is None:
            return ""
        value, told = found["value"] or found["rest"], found["condition"] or "else"
        condition = _CONDITION.fullmatch(told)
        if re.fullmatch(_ELSE, told.strip()):
            rest = value
        elif condition is None:
            return ""
        elif condition["sign"] == "=" and not condition["on"]:
            values[int(condition["at"])] = value
        elif condition["sign"].startswith(("<", "≤", "\\l")):
            end = int(condition["at"]) + (condition["sign"] != "<")
            values |= dict.fromkeys(range(end), value)
        else:
            later.append((int(condition["at"]) + (condition["sign"] == ">"), value))
    return _sum(values, later, rest)


def _with_conditions(pieces: list[str]) -> list[str]:
    """The pieces between commas, each with the condition behind it."""
    whole: list[str] = []
    for piece in pieces:
        bare = piece.strip()
        if whole and (found := _CONDITION.fullmatch(bare)):
            whole[-1] += f" {'' if found[0].lstrip()[:1] not in 'kn' else 'for '}{bare}"
        elif whole and re.fullmatch(r"\d|\.{3}|…|\\l?dots", bare):  # k = 1, 2, …
            whole[-1] += f", {bare}"
        elif bare:
            whole.append(bare)
    return whole


def _sum(values: dict[int, str], later: list[tuple[int, str]], rest: str) -> str:
    """The sum of the values before a sequence begins and of the sequence; "" where one is not told."""
    if len(later) != 1 or not 0 < later[0][0] <= MOST_VALUES or not (values or rest):
        return ""
    ((begin, value),) = later
    before = [values.get(at, rest) for at in range(begin)]
    if not all(before) or any(at >= begin for at in values):
        return ""
    pulses = [f"({each})*delta(k - {at})" for at, each in enumerate(before)]
    return " + ".join([*pulses, f"({value})*step(k - {begin})"])
