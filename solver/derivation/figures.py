"""Figures as data: what a step wants drawn. They are drawn only where a page shows them.

Labels are LaTeX without dollar signs, captions are Markdown with `$math$`; names of sets of points are words.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields, is_dataclass, replace
from typing import Any

from solver.derivation.flow_figures import FlowGraph
from solver.derivation.frequency_figures import BodeDiagram, NyquistDiagram
from solver.derivation.mechanisms import Mechanism
from solver.derivation.parameter_figures import Locus, ParameterRegion
from solver.derivation.patch_figures import PatchDiagram


@dataclass(frozen=True, slots=True)
class Curve:
    """One curve of a plot: `x` and `y` are expressions in the plot's variable; `x` None is the variable itself.

    `style` is "line", "dashed", "samples" (values at whole numbers, for discrete time), "arrow" (a trajectory with
    an arrowhead in its middle), "jumps" (points joined in their order, `x` and `y` are tuples of numbers) or "guide"
    (a thin line beside the curves, its label at its end).
    """

    y: Any
    label: str = ""
    x: Any = None
    style: str = "line"


@dataclass(frozen=True, slots=True)
class Mark:
    """A point of a plot worth naming: a peak, an equilibrium; `sign` is "dot", or "none" for the name alone."""

    x: Any
    y: Any
    label: str = ""
    sign: str = "dot"


@dataclass(frozen=True, slots=True)
class Plot:
    """Curves over `variable` from `start` to `stop`, numbers all; only the variable may be free in the expressions.

    `equal` gives both axes the same scale (a phase plane); `window` is (x_min, x_max, y_min, y_max), None fits the
    curves. `settles` is the value around which a band of 2 % is shown, and when the first curve stays in it.
    """

    caption: str
    x_label: str
    y_label: str
    variable: Any
    start: Any
    stop: Any
    curves: tuple[Curve, ...]
    marks: tuple[Mark, ...] = ()
    equal: bool = False
    window: tuple[Any, Any, Any, Any] | None = None
    settles: Any = None


@dataclass(frozen=True, slots=True)
class Panels:
    """Plots below each other, over the same variable."""

    caption: str
    plots: tuple[Plot, ...]


@dataclass(frozen=True, slots=True)
class Signals:
    """What one panel shows of a motion z: the curves rows · z + offset, each under its name, over the axis `label`.

    `level` is a value that they are to reach, such as a reference, under its name.
    """

    label: str
    names: tuple[str, ...]
    rows: Any
    offset: Any = None
    level: tuple[str, Any] | None = None


@dataclass(frozen=True, slots=True)
class Motion:
    """z' = matrix · z + drive (a column, None for zero) from `start`, in discrete time z(k + 1) = …; numbers all.

    `beside` are symbols and functions of them, z' = f(z) from the same start: these curves are dashed.
    """

    caption: str
    matrix: Any
    start: Any
    panels: tuple[Signals, ...]
    discrete: bool = False
    drive: Any = None
    beside: tuple[tuple[Any, ...], tuple[Any, ...]] | None = None


@dataclass(frozen=True, slots=True)
class Roots:
    """Points of the complex plane under one name, such as "poles": numbers, each as often as its multiplicity.

    `sign` is "cross" (poles), "ring" (zeros), "square" or "diamond" (poles beside those shown as crosses).
    """

    name: str
    values: tuple[Any, ...]
    sign: str = "cross"


@dataclass(frozen=True, slots=True)
class Region:
    """Where poles −σ ± jω meet specifications; None asks for nothing.

    At least the damping ratio `damping`, σ ≥ `decay`, |s| ≥ `radius`, ω ≥ `frequency`.
    """

    damping: Any = None
    decay: Any = None
    radius: Any = None
    frequency: Any = None


@dataclass(frozen=True, slots=True)
class Plane:
    """Poles and zeros in the s-plane; in the z-plane, with the unit circle, in discrete time.

    `stable` shades where modes die out.
    """

    caption: str
    roots: tuple[Roots, ...]
    discrete: bool = False
    region: Region | None = None
    stable: bool = False


@dataclass(frozen=True, slots=True)
class Diagram:
    """A block diagram known by name (`solver/figures`), with the LaTeX to write into its blocks and at its arrows."""

    caption: str
    name: str
    labels: Mapping[str, str] = field(default_factory=dict)
    alt: str = ""


@dataclass(frozen=True, slots=True)
class Chains:
    """A realization with one input and one output as chains of integrators.

    `rows` are the states of each chain in the order of the signal. Entries are LaTeX, "" for zero, "1" for a wire.
    """

    caption: str
    rows: tuple[tuple[int, ...], ...]
    A: tuple[tuple[str, ...], ...]
    b: tuple[str, ...]
    c: tuple[str, ...]
    d: str = ""
    discrete: bool = False
    alt: str = ""


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a system: its name in words, its modes as LaTeX, and what it has to do with the others.

    `place` is (row, column) of two by two; `acts_on` are the numbers of other parts.
    """

    name: str
    modes: tuple[str, ...]
    place: tuple[int, int]
    driven: bool
    seen: bool
    acts_on: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class Parts:
    """The parts of a decomposed system: u drives some, y shows some, some act on others."""

    caption: str
    parts: tuple[Part, ...]
    alt: str = ""


@dataclass(frozen=True, slots=True)
class Component:
    """An element of a circuit: its kind by the letter of its name, its label as LaTeX, the nodes that it joins.

    Of an operational amplifier `inputs` are the nodes of its inputs, plus and minus.
    """

    letter: str
    label: str
    nodes: tuple[str, str]
    inputs: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Schematic:
    """The drawing of a circuit; node 0 is the ground. `names` are the elements in a line of text.

    `voltages` are nodes with the symbols of their voltages, which are shown in the place of the names of nodes.
    """

    caption: str
    components: tuple[Component, ...]
    names: tuple[str, ...] = ()
    alt: str = ""
    voltages: tuple[tuple[str, str], ...] = ()


Figure = (
    Plot | Panels | Motion | Plane | Locus | ParameterRegion | Diagram | Chains | Parts | Schematic | Mechanism
    | BodeDiagram | NyquistDiagram | FlowGraph | PatchDiagram
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class DrawnCurve:
    """A curve as numbers: `x` and `y` of the same length, without gaps.

    `style` is that of a `Curve`, the sign of some `Roots`, "area", whose edge the curve is, "dashed arrow", "arc" (a
    thin line with an arrowhead) or "span" (a stretch of a straight line, measured and named).
    """

    label: str
    style: str
    x: tuple[float, ...]
    y: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class DrawnPlot:
    """A plot as numbers: what pages draw. `window` is (x_min, x_max, y_min, y_max), `alt` tells what is seen.

    `logarithmic` is said of the abscissa; the ticks of the ordinate are multiples of `y_step`, if it is not 0.
    """

    caption: str
    x_label: str
    y_label: str
    curves: tuple[DrawnCurve, ...]
    marks: tuple[Mark, ...]
    equal: bool
    window: tuple[float, float, float, float]
    alt: str = ""
    logarithmic: bool = False
    y_step: float = 0.0


@dataclass(frozen=True, slots=True)
class DrawnPanels:
    """Plots as numbers, below each other."""

    caption: str
    plots: tuple[DrawnPlot, ...]
    alt: str = ""


GAINS = {"K": r"\sym{K}", "L": r"\sym{L}"}
"""What stands in the blocks of the gains where a diagram says nothing else."""

WORDS = {"caption", "label", "name", "names", "x_label", "y_label", "gravity", "output", "value"}
"""Fields that are read."""


def worded_figure(figure: Figure, say: Callable[[str], str]) -> Figure:
    """Return a figure with its words and symbols as a page says them."""
    if isinstance(figure, Diagram):
        labels = {name: say(label) for name, label in {**GAINS, **figure.labels}.items()}
        return replace(figure, caption=say(figure.caption), labels=labels)
    worded: Figure = _worded(figure, say)
    return worded


def _worded(value: Any, say: Callable[[str], str], *, read: bool = False) -> Any:
    """Return a figure or what it is made of, with the texts said that are read."""
    if isinstance(value, str):
        return say(value) if read else value
    if isinstance(value, tuple):
        return tuple(_worded(each, say, read=read) for each in value)
    if is_dataclass(value) and not isinstance(value, type):
        return replace(
            value, **{f.name: _worded(getattr(value, f.name), say, read=f.name in WORDS) for f in fields(value)}
        )
    return value


Drawing = DrawnPlot | DrawnPanels | Diagram | Chains | Parts | Schematic | Mechanism | FlowGraph | PatchDiagram
"""A figure without expressions."""
