"""The symbols that a text uses for the quantities of the course. Templates write `{{ sym.Phi }}`."""

from __future__ import annotations

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


def answer_symbol(name: str, declared: str, notation: str) -> str:
    """Return the symbol of an answer: what the task declares, or the notation's own where that is another one."""
    table = NOTATIONS[notation]
    return table[name] if notation != COURSE and name in table else declared or table.get(name, "")
