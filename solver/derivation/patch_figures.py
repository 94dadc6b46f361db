"""Patch diagrams of an analog computer as data for drawing."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class PatchElement:
    """An element of a program: its kind (`solver.patches.KEYS`), its name, what feeds it; all texts are LaTeX.

    `inputs` are (number of an element, gain); `value` is written beside the symbol: volts of a source, the setting of
    a potentiometer, the volts at which an integrator starts ("" for none); `output` names the voltage that leaves it.
    """

    kind: str
    name: str
    inputs: tuple[tuple[int, str], ...] = ()
    value: str = ""
    output: str = ""


@dataclass(frozen=True, slots=True)
class PatchDiagram:
    """The program of an analog computer: its elements, in any order."""

    caption: str
    elements: tuple[PatchElement, ...]
    alt: str = ""


__all__ = ["PatchDiagram", "PatchElement"]
