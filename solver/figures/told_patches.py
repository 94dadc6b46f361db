"""What is seen in a patch diagram, in words: how it is patched, element by element."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from solver.derivation.patch_figures import PatchDiagram, PatchElement
from solver.formula.terminal import flat
from solver.words import Phrase

Say = Callable[[str], str]


def of_patches(figure: PatchDiagram, say: Say) -> str:
    """Tell of each amplifier and potentiometer what feeds it, and what it computes."""
    told = [say("patch diagram"), *_elements(figure, say)]
    return ". ".join(text[:1].upper() + text[1:] for text in told) + "."


def _elements(figure: PatchDiagram, say: Say) -> Iterator[str]:
    names = [_text(each.value if each.kind == "source" else each.name) for each in figure.elements]
    for number, each in enumerate(figure.elements):
        if each.kind == "source" and not each.output:
            continue
        text = say(
            Phrase(_pattern(each), name=names[number], value=_text(each.value), inputs=_inputs(each, names, say))
        )
        if each.output:
            text += ", " + say(Phrase("its output is {voltage}", voltage=_text(each.output)))
        yield text


def _text(latex: str) -> str:
    """A label in a line of text, volts apart from their number."""
    return " ".join(map(flat, latex.split(r"\,")))


def _pattern(element: PatchElement) -> str:
    """How an element is told."""
    return {
        "source": "source {name}",
        "pot": "potentiometer {name} at {value}, fed by {inputs}",
        "summer": "summer {name}, fed by {inputs}",
        "inverter": "inverter {name}, fed by {inputs}",
        "integrator": "integrator {name}, fed by {inputs}, starts at {value}" if element.value
        else "integrator {name}, fed by {inputs}, starts at 0",
    }[element.kind]  # fmt: skip


def _inputs(element: PatchElement, names: list[str], say: Say) -> str:
    """What feeds an element, with gains where they can differ."""
    if element.kind in ("summer", "integrator"):
        told = [Phrase("{name} (gain {gain})", name=names[fed], gain=flat(gain)) for fed, gain in element.inputs]
        return ", ".join(map(say, told)) or say("nothing")
    return ", ".join(names[fed] for fed, _ in element.inputs)
