"""What is seen in a figure, in words made from its data: for whoever cannot see it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import pairwise
from math import dist, hypot

from solver.derivation.figures import Chains, Component, DrawnCurve, DrawnPlot, Parts, Plane, Schematic
from solver.derivation.flow_figures import FlowGraph
from solver.figures.layout import Block, Label, Layout
from solver.figures.planes import Placed, limits_of, placed
from solver.formula.terminal import flat
from solver.words import Phrase

Say = Callable[[str], str]

DIGITS = 4
EDGE = 1e-9
"""Roots so near to the edge of stability lie on it."""

BESIDE = {"guide", "area"}
"""What is no curve of its own."""


def text_of(latex: str) -> str:
    """Return a label in a line of text."""
    return flat(latex)


def number_text(x: float) -> str:
    """Return a number with few digits and a minus sign."""
    return f"{0.0 if abs(x) < EDGE else x:.{DIGITS}g}".replace("-", "−")


def of_plane(plane: Plane, say: Say) -> str:
    """Tell where the roots lie, and what region is shaded."""
    sets = [placed(each) for each in plane.roots]
    found = [_roots(each, say, discrete=plane.discrete) for each in sets]
    if plane.stable:
        found.append(say("shaded: where modes die out"))
    limits = limits_of(plane.region)
    if limits is not None:
        shown = {
            r"\sym{damping_ratio}": limits.damping, "\\sigma": limits.decay,
            r"\omega_d": limits.frequency,
        }  # fmt: skip
        told = ", ".join(f"{text_of(say(name))} ≥ {number_text(x)}" for name, x in shown.items() if x)
        if told:
            found.append(say(Phrase("shaded: {limits}", limits=told)))
    return sentences([say("the z-plane" if plane.discrete else "the s-plane"), *found])


def _roots(each: Placed, say: Say, *, discrete: bool) -> str:
    if not each.count:
        return say(Phrase("{name}: none", name=each.name))
    where = _where(each, say, discrete=discrete)
    values = ", ".join(values_text(each.places))
    return say(
        Phrase("{name} ({count}): {values}; {where}", name=each.name, count=each.count, values=values, where=where)
    )


def values_text(places: Sequence[tuple[complex, int]]) -> Iterator[str]:
    """Yield roots as text, of a pair both in one: −2 ± 3j; a multiple one with how often it is there."""
    there = dict(places)
    for value, times in places:
        mirrored = value.conjugate()
        if value.imag < 0 and mirrored in there:
            continue
        real, size = number_text(value.real), number_text(abs(value.imag))
        unit = "j" if size == "1" else f"{size}j"
        sign = "±" if value.imag > 0 and mirrored in there else "+" if value.imag > 0 else "−"
        if not value.imag:
            text = real
        elif value.real:
            text = f"{real} {sign} {unit}"
        else:
            text = f"{sign}{unit}".removeprefix("+")
        yield text if times == 1 else f"{text} ({times}×)"


def _where(each: Placed, say: Say, *, discrete: bool) -> str:
    """Say on which side of the edge of stability the roots lie."""
    sides = [0, 0, 0]
    for value, times in each.places:
        away = abs(value) - 1 if discrete else value.real
        sides[1 if abs(away) <= EDGE else 0 if away < 0 else 2] += times
    if discrete:
        words = ("inside the unit circle", "on the unit circle", "outside the unit circle")
    else:
        words = ("in the left half plane", "on the imaginary axis", "in the right half plane")
    there = [(count, word) for count, word in zip(sides, words, strict=True) if count]
    if len(there) == 1:
        ((count, word),) = there
        return say(word if count == 1 else Phrase("all {where}", where=word))
    return ", ".join(say(Phrase("{count} {where}", count=count, where=word)) for count, word in there)


def of_chains(figure: Chains, say: Say) -> str:
    """Tell which state follows which in each chain, and what goes into each integrator and into the output."""
    rows = (" → ".join(text_of(f"x_{{{state + 1}}}") for state in states) for states in figure.rows)
    told = [say(Phrase("chain: {states}", states=states)) for states in rows]
    states = [f"x_{{{i + 1}}}" for i in range(len(figure.A))]
    for name, row, drive in zip(states, figure.A, figure.b, strict=True):
        terms = _weighted([*zip(row, states, strict=True), (drive, "u")])
        into = {"name": text_of(name), "terms": terms}
        delay = Phrase("what enters the delay of {name}: {terms}", **into)
        told.append(say(delay if figure.discrete else Phrase("what enters the integrator of {name}: {terms}", **into)))
    output = _weighted([*zip(figure.c, states, strict=True), (figure.d, "u")])
    return sentences([*told, say(Phrase("output: {terms}", terms=output))])


def _weighted(terms: Sequence[tuple[str, str]]) -> str:
    """A sum of signals with their gains."""
    found = ""
    for gain, signal in terms:
        if not gain:
            continue
        text = text_of(gain)
        minus = text[:1] in "-−"
        size = text[1:].lstrip() if minus else text
        if " " in size:
            text, minus = f"({text})", False
            size = text
        sign = (" − " if minus else " + ") if found else ("−" if minus else "")
        found += sign + ("" if size == "1" else size) + text_of(signal)
    return found or "0"


def of_parts(figure: Parts, say: Say) -> str:
    """Tell the modes of each part, and what drives it, shows it, or is driven by it."""
    told = []
    for part in figure.parts:
        told.append(say(Phrase("{name}: {modes}", name=part.name, modes=", ".join(map(text_of, part.modes)))))
        relations = [say("driven by the input")] * part.driven + [say("seen in the output")] * part.seen
        relations += [say(Phrase("acts on the part {name}", name=figure.parts[i].name)) for i in part.acts_on]
        told[-1] += "".join(f"; {each}" for each in relations)
    return sentences(told)


def of_flow_graph(figure: FlowGraph, say: Say) -> str:
    """Tell each branch: from where to where, with which gain."""
    names = [text_of(name) for name in figure.nodes]
    told = [
        say(Phrase("{a} to {b}: {gain}", a=names[a], b=names[b], gain=text_of(gain) if gain else "1"))
        for a, b, gain in figure.branches
    ]
    return sentences([say("signal-flow graph"), *told])


def of_schematic(figure: Schematic, say: Say) -> str:
    """Tell between which nodes each element lies."""
    told = [
        _element(each, say(name) if name else text_of(each.label), say)
        for each, name in zip(figure.components, figure.names or ("",) * len(figure.components), strict=True)
    ]
    return sentences([say("circuit diagram"), *told])


def _element(each: Component, name: str, say: Say) -> str:
    if each.letter == "O":
        plus, minus = each.inputs
        said = Phrase(
            "{name}: output {a}, inputs {b} (plus) and {c} (minus)", name=name, a=each.nodes[0], b=plus, c=minus
        )
        return say(said)
    first, second = each.nodes
    return say(Phrase("{name} from node {a} to node {b}", name=name, a=first, b=second))


def of_diagram(layout: Layout, say: Say) -> str:
    """Name the blocks and the signals of a block diagram."""
    blocks = [text_of(each.text) for each in layout.items if isinstance(each, Block) and each.text]
    labels = [text_of(each.text) for each in layout.items if isinstance(each, Label) and each.text]
    signals = dict.fromkeys(label for label in labels if label not in ("+", "−", "-"))
    told = [Phrase("boxes: {names}", names=", ".join(blocks)), Phrase("signals: {names}", names=", ".join(signals))]
    return sentences(map(say, told))


def of_plot(plot: DrawnPlot, say: Say) -> str:
    """Tell of each curve where it begins and ends, and its largest and smallest value if they lie between."""
    curves = [each for each in plot.curves if each.style not in BESIDE and each.x]
    unnamed = [each for each in curves if not each.label]
    told = [_curve(each, plot, say) for each in curves if not _many(unnamed) or each.label]
    if _many(unnamed):
        told.append(_paths(unnamed, say))
    return sentences([*told, *_guides(plot.curves, say)])


def _curve(each: DrawnCurve, plot: DrawnPlot, say: Say) -> str:
    letter = text_of(plot.x_label) or "x"
    name = text_of(each.label or plot.y_label)
    if _turns_back(each):
        return _path(each, name, say)
    ends = {
        "name": name, "letter": letter, "start": number_text(each.x[0]), "stop": number_text(each.x[-1]),
        "first": number_text(each.y[0]), "last": number_text(each.y[-1]),
    }  # fmt: skip
    text = say(Phrase("{name} from {first} at {letter} = {start} to {last} at {letter} = {stop}", **ends))
    for pattern, at in (("largest {y} at {letter} = {x}", max), ("smallest {y} at {letter} = {x}", min)):
        place = at(range(len(each.y)), key=each.y.__getitem__)
        margin = 0.01 * (max(each.y) - min(each.y))
        if abs(each.y[place] - each.y[0]) > margin and abs(each.y[place] - each.y[-1]) > margin:
            x, y = number_text(each.x[place]), number_text(each.y[place])
            text += ", " + say(Phrase(pattern, x=x, y=y, letter=letter))
    return text


def _many(unnamed: Sequence[DrawnCurve]) -> bool:
    """Whether there are paths that are told together."""
    return len(unnamed) > 2


def _paths(unnamed: Sequence[DrawnCurve], say: Say) -> str:
    """Paths without names by where they begin, and whether they come nearer to the origin."""
    starts = ", ".join(f"({number_text(each.x[0])}, {number_text(each.y[0])})" for each in unnamed)
    away = [hypot(each.x[-1], each.y[-1]) / (hypot(each.x[0], each.y[0]) or 1) for each in unnamed]
    text = say(Phrase("{count} paths, from {starts}", count=len(unnamed), starts=starts))
    if all(each < 0.5 for each in away):
        return text + "; " + say("all of them come nearer to the origin")
    return text + "; " + say("all of them go away from it") if all(each > 2 for each in away) else text


def _turns_back(each: DrawnCurve) -> bool:
    """Whether x goes both ways, as on a path in a plane."""
    steps = [b - a for a, b in pairwise(each.x)]
    size = max(each.x) - min(each.x)
    return min(steps, default=0) < -0.01 * size and max(steps, default=0) > 0.01 * size


def _path(each: DrawnCurve, name: str, say: Say) -> str:
    """A closed path by what it encloses, another by its ends."""
    ends = [(each.x[i], each.y[i]) for i in (0, -1)]
    size = max(max(each.x) - min(each.x), max(each.y) - min(each.y))
    if dist(*ends) < 0.01 * size:
        sides = {
            "left": number_text(min(each.x)), "right": number_text(max(each.x)),
            "low": number_text(min(each.y)), "high": number_text(max(each.y)),
        }  # fmt: skip
        return say(
            Phrase("{name} is closed, from {left} to {right} across and from {low} to {high} up", name=name, **sides)
        )
    first, last = (f"({number_text(x)}, {number_text(y)})" for x, y in ends)
    return say(Phrase("{name} leads from {first} to {last}", name=name, first=first, last=last))


def _guides(curves: Iterable[DrawnCurve], say: Say) -> Iterator[str]:
    for each in curves:
        if each.style == "guide" and each.label and each.x:
            upright = each.x[0] == each.x[-1]
            value = number_text(each.x[0] if upright else each.y[0])
            yield say(Phrase("marked: {name} = {value}", name=text_of(each.label), value=value))


def sentences(texts: Iterable[str]) -> str:
    """Return texts as sentences, each with a capital letter."""
    return ". ".join(_begun(text) for text in texts if text) + "."


def _begun(text: str) -> str:
    """A sentence with a capital letter, unless it begins with a symbol."""
    word = text.split(" ", 1)[0]
    return text[:1].upper() + text[1:] if len(word) > 1 and word.strip(":,;.").isascii() and word[1].isalpha() else text
