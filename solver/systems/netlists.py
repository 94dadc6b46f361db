"""The reading of netlists: one element a line, `NAME NODE NODE VALUE`; faults stand at their places."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from difflib import get_close_matches
from typing import TYPE_CHECKING

from solver.systems.networks import (
    GROUND,
    Element,
    Forest,
    cuts_of_currents,
    loops_of_voltages,
    nodes_of,
    normal_tree,
)

if TYPE_CHECKING:
    from solver.systems.kind import Reader

KEY = "circuit"
FIELDS = {
    **dict.fromkeys("VIRLC", "NODE NODE VALUE"),
    **dict.fromkeys("EG", "NODE NODE PLUS MINUS VALUE"),
    **dict.fromkeys("FH", "NODE NODE ELEMENT VALUE"),
    "O": "OUT 0 PLUS MINUS",
}
"""What follows the name of an element, by its letter; a value that is left out has the name of the element."""
KINDS = "V, I, R, L, C, E, F, G, H or O"
MULTIPLES = {"T": 12, "G": 9, "MEG": 6, "k": 3, "m": -3, "u": -6, "n": -9, "p": -12}
"""Suffixes that other programs read as powers of ten, where here they would be names."""
MULTIPLE = rf"([+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?)({'|'.join(MULTIPLES)})"

CONSTANTS = ("e", "j")
"""Names of numbers that somebody who writes them after a source means as its own."""


def read_netlist(reader: Reader) -> tuple[Element, ...]:
    """Return the elements; those that cannot be read are missing, and told."""
    lines = [(item, words_of(text)) for item, text in enumerate(reader.texts(KEY))]
    read = {item: element for item, words in lines if (element := _element(reader, item, words)) is not None}
    names = [words[0][1] for _, words in lines if words]
    for item, words in lines:
        if words and words[0][1] in [other[0][1] for _, other in lines[:item] if other]:
            _complain(reader, item, words[0], f"there is an element {words[0][1]} above already")
        if item in read and read[item].letter in "FH" and read[item].controls[0] not in names:
            near = get_close_matches(read[item].controls[0], names, n=1)
            message = f"there is no element {read[item].controls[0]} whose current could control {read[item].name}"
            _complain(reader, item, words[3], message, *near)
    if len(read) == len(lines):
        for item, message in _faults(tuple(read.values())):
            reader.complain(KEY, message, item=item)
    return tuple(read.values())


Word = tuple[int, str]
"""A word of a line with the place where it begins."""


def words_of(text: str) -> list[Word]:
    """Return the words of a line with their places."""
    return [(found.start(), found[0]) for found in re.finditer(r"\S+", text)]


def _complain(reader: Reader, item: int, word: Word, message: str, suggestion: str = "") -> None:
    reader.complain_inside(KEY, item, (word[0], len(word[1])), message, suggestion)


def _element(reader: Reader, item: int, words: Sequence[Word]) -> Element | None:
    """Return the element of a line, None if it is wrong."""
    if not words:
        reader.complain(KEY, f"an element is expected here: NAME NODE NODE VALUE, with a name in {KINDS}", item=item)
        return None
    (_, name), letter = words[0], words[0][1][0]
    if letter not in FIELDS:
        upper = letter.upper() + name[1:] if letter.upper() in FIELDS else ""
        message = f"{name} is no element: a name begins with its kind, {KINDS}"
        _complain(reader, item, words[0], message, upper)
        return None
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name):
        _complain(reader, item, words[0], "a name is made of letters, digits and _")
        return None
    needed = FIELDS[letter].removesuffix(" VALUE").split()
    if len(words) - 1 < len(needed):
        expected = f"{name} needs {len(needed)} words after its name: {name} {FIELDS[letter]}"
        _complain(reader, item, words[-1], expected)
        return None
    rest = words[1 + len(needed) :]
    if letter == "O" and rest:
        _complain(reader, item, rest[0], f"an ideal operational amplifier has no value: {name} {FIELDS[letter]}")
        return None
    bare = _bare(reader, item, words[: 1 + len(needed)])
    return bare if bare is None or letter == "O" else _with_value(reader, item, bare, rest, len(name))


def _bare(reader: Reader, item: int, words: Sequence[Word]) -> Element | None:
    """Return the element without its value."""
    (_, name), *others = words
    nodes = others[:2] if name[0] in "FH" else others
    wrong = [word for word in nodes if not re.fullmatch(r"\w+", word[1], re.ASCII)]
    for word in wrong:
        _complain(reader, item, word, "a node is a number or a name of letters, digits and _")
    first, second, *controls = (word for _, word in others)
    if first == second and not wrong:
        _complain(reader, item, others[1], f"both ends of {name} are at the node {first}: it does nothing")
    return None if wrong or first == second else Element(name, (first, second), controls=tuple(controls))


def _with_value(reader: Reader, item: int, element: Element, rest: Sequence[Word], name: int) -> Element | None:
    """Return the element with its value, or as the input that a source is; `name` is the length of its name."""
    if rest and (scaled := re.fullmatch(MULTIPLE, " ".join(word for _, word in rest))) is not None:
        power = f"{scaled[1]}e{MULTIPLES[scaled[2]]}"
        message = f"{scaled[0]} would be the product {scaled[1]}·{scaled[2]}; write a power of ten"
        _complain(reader, item, rest[0], message, power)
        return None
    start = words_of(reader.texts(KEY)[item])[0][0]
    value = reader.value_inside(KEY, item, rest[0][0]) if rest else reader.value_inside(KEY, item, start, name)
    if value is None:
        return None
    at = rest[0] if rest else (start, element.name)
    if element.letter in "VI":
        if value.is_Symbol:
            return replace(element, source=str(value))
        if value.free_symbols or at[1] in CONSTANTS:
            _complain(reader, item, at, *_misread(element, at[1], is_constant=at[1] in CONSTANTS))
            return None
    elif value == 0 and element.letter in "RLC":
        _complain(reader, item, at, f"{element.name} is zero; leave the element out, or join its nodes")
        return None
    return replace(element, value=value)


def _misread(element: Element, text: str, *, is_constant: bool) -> tuple[str, ...]:
    """What is wrong with the value of a source, and a suggestion."""
    if is_constant:
        return f"{text} is a number here; give the input another name", f"{text}_s"
    return (f"the value of the source {element.name} names an input or is a number",)


def _faults(elements: Sequence[Element]) -> Iterator[tuple[int, str]]:
    """Yield what is wrong with the circuit as a whole: the number of an element, and a message."""
    numbers = {element.name: i for i, element in enumerate(elements)}
    ends = [node for element in elements for node in element.nodes]
    if GROUND not in ends:
        yield 0, "no element is at the node 0, the ground"
        return
    whole = Forest()
    for element in elements:
        whole.add(element)
    grounded = whole.reached(GROUND)
    told: set[str] = set()
    for i, element in enumerate(elements):
        for node in element.watched:
            if node not in ends and node not in told:
                yield i, f"the node {node} is floating: no element but inputs without current are connected to it"
                told.add(node)
        apart = [node for node in element.nodes if node not in grounded and node not in told]
        if apart:
            island = whole.reached(apart[0])
            names = ", ".join(node for node in nodes_of(elements) if node in island)
            yield i, f"no path of elements leads from the nodes {names} to the ground, node 0"
            told |= island
    if told:
        return
    tree = normal_tree(elements)
    for loop in loops_of_voltages(tree):
        yield numbers[loop[-1].name], f"{_names(loop)} form a loop of voltage sources"
    for cut in cuts_of_currents(tree):
        yield numbers[cut[0].name], f"{_alone(cut)} a part of the circuit to the rest"


def floating(elements: Sequence[Element], seen: Sequence[str]) -> Iterator[tuple[int, str]]:
    """Yield nodes at which one element ends alone, and that nothing watches: the number of the element, a message."""
    ends = [node for element in elements for node in element.nodes]
    watched = {node for element in elements for node in element.watched} | {*seen, GROUND}
    for i, element in enumerate(elements):
        for node in element.nodes:
            if ends.count(node) == 1 and node not in watched:
                yield i, f"the node {node} is floating: {element.name} alone ends there"


def _names(elements: Sequence[Element]) -> str:
    *others, last = (element.name for element in elements)
    return f"{', '.join(others)} and {last}" if others else str(last)


def _alone(cut: Sequence[Element]) -> str:
    """The current sources that join two parts, as a subject."""
    alone = f"the current source {cut[0].name} alone joins"
    return alone if len(cut) == 1 else f"current sources alone ({_names(cut)}) join"
