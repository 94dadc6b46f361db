"""Where everything in the schematic of a mechanical system stands. Units are centimetres, y points up."""

from __future__ import annotations

from itertools import combinations

from solver.derivation.mechanisms import Mechanism
from solver.figures.layout import Label
from solver.figures.mechanism_marks import gravity_of, lengths_of, marks_of
from solver.figures.mechanism_parts import LEAST, Parts
from solver.figures.strokes import Ring, Stroke
from solver.formula.terminal import flat

Bounds = tuple[float, float, float, float]


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


def frame_of(label: Label) -> Bounds:
    """Return about what room a label takes: x_min, x_max, y_min, y_max."""
    width, height = 0.1 + 0.17 * len(flat(label.text)), 0.34
    x = label.x + (width / 2 if "right" in label.anchor else -width / 2 if "left" in label.anchor else 0)
    y = label.y + (height / 2 if "above" in label.anchor else -height / 2 if "below" in label.anchor else 0)
    return x - width / 2, x + width / 2, y - height / 2, y + height / 2


def bounds_of(strokes: list[Stroke]) -> Bounds:
    """Return x_min, x_max, y_min, y_max of the drawing, with room for labels."""
    frames: list[Bounds] = []
    for each in strokes:
        if isinstance(each, Label):
            frames.append(frame_of(each))
        elif isinstance(each, Ring):
            (x, y), r = each.place, each.radius
            frames.append((x - r, x + r, y - r, y + r))
        else:
            xs, ys = zip(*each.points, strict=True)
            frames.append((min(xs), max(xs), min(ys), max(ys)))
    x_min, x_max, y_min, y_max = zip(*frames, strict=True)
    return min(x_min) - 0.25, max(x_max) + 0.25, min(y_min) - 0.25, max(y_max) + 0.25
