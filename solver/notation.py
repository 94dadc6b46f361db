"""The symbols that a text uses for the quantities of the course. Templates write `{{ sym.Phi }}`."""

from __future__ import annotations

import re
from collections.abc import Mapping

_COMMON = {
    "x": "x",
    "xdot": r"\dot{x}",
    "u": "u",
    "y": "y",
    "A": "A",
    "B": "B",
    "C": "C",
    "D": "D",
    "Phi": r"\Phi(t)",
    "Phi_k": r"\Phi(k)",
    "Lambda": r"\Lambda",
    "eigenvector": r"\nu",
    "left_eigenvector": "w",
    "omega_n": r"\omega_n",
    "overshoot": "M_p",
    "settling_time": "t_s",
    "rise_time": "t_r",
    "peak_time": "t_p",
    "P": "P",
    "Q": "Q",
    "R": "R",
}

_COURSE = {
    **_COMMON,
    "K": "K_f",
    "L": "L_c",
    "controllability_matrix": r"\mathcal{C}_o",
    "observability_matrix": r"\mathcal{O}_v",
    "damping_ratio": r"\xi",
    "integrator": r"\xi",
}

_OGATA = {
    **_COMMON,
    "K": "K",
    "L": "K_e",
    "controllability_matrix": "M",
    "observability_matrix": "N",
    "damping_ratio": r"\zeta",
    "integrator": r"\xi",
}

NOTATIONS: Mapping[str, Mapping[str, str]] = {"course": _COURSE, "ogata": _OGATA}
"""The tables by name; both have the same keys."""

COURSE = "course"

SYMBOL = r"\sym{"
"""How a phrase of the program names a symbol of the notation: `$A - B\\sym{K}$`."""

_NAMED = re.compile(r"\\sym\{(\w+)\}(?=([A-Za-z])?)")
_COMMAND = re.compile(r"\\[A-Za-z]+\Z")


def spelled(text: str, notation: str) -> str:
    """Return a text with the symbols that it names, spelled as in the notation."""

    def symbol(found: re.Match[str]) -> str:
        shown = NOTATIONS[notation][found[1]]
        return f"{shown} " if found[2] and _COMMAND.search(shown) else shown

    return _NAMED.sub(symbol, text)


def answer_symbol(name: str, declared: str, notation: str) -> str:
    """Return the symbol of an answer: what the task declares, or the notation's own where that is another one."""
    table = NOTATIONS[notation]
    return table[name] if notation != COURSE and name in table else declared or table.get(name, "")
