"""Where everything in the schematic of a mechanical system stands. Units are centimetres, y points up."""

from __future__ import annotations

from itertools import combinations

from solver.derivation.mechanisms import Mechanism
from solver.figures.layout import Label
from solver.figures.mechanism_marks import gravity_of, lengths_of, marks_of
from solver.figures.mechanism_parts import LEAST, Parts
from solver.figures.strokes import Stroke, bounds_of, frame_of


def layout_of(mechanism: Mechanism) -> list[Stroke]:
    """Return what is drawn, in its order: what lies behind first."""
    parts = Parts(mechanism)
    found = [*parts.grounds(), *marks_of(parts), *parts.strokes(), *lengths_of(parts)]
    return [*found, *gravity_of(mechanism, bounds_of(found))]


def is_decent(mechanism: Mechanism) -> bool:
    """Whether bodies are apart, what joins them can be seen, and no label stands on another."""
    parts = Parts(mechanism)
    bodies = [i for i, each in enumerate(mechanism.joints) if each.shape in ("box", "disc")]
    if any(parts.gap(i, j) < LEAST / 2 for i, j in combinations(bodies, 2)):
        return False
    if any(parts.seen(link) < LEAST for link in mechanism.links):
        return False
    frames = [frame_of(each) for each in layout_of(mechanism) if isinstance(each, Label) and each.text]
    return not any(a[0] < b[1] and b[0] < a[1] and a[2] < b[3] and b[2] < a[3] for a, b in combinations(frames, 2))
