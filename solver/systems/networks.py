"""The graph of a circuit: branches that form no loop, the way between two nodes along them, and the normal tree.

A normal tree takes voltage sources and outputs of amplifiers first, then capacitors, resistors, inductors, and current
sources last (N. Balabanian and T. A. Bickart, Electrical Network Theory, chapter 4).
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from sympy import Expr, Symbol

GROUND = "0"
ORDER = "VEHOCRLGFI"
"""The letters of elements in the order in which a normal tree takes them."""
VOLTAGES, CURRENTS = "VEHO", "GFI"
"""The letters of what sets a voltage, or a current, whatever the other."""


@dataclass(frozen=True, slots=True)
class Element:
    """One element; its voltage and current count from the first node to the second.

    `value` is None for an operational amplifier and for a source that is an input; `source` is the name of the input.
    `controls` are the two nodes whose voltage controls E and G, or the inputs (plus, minus) of an operational
    amplifier; of F and H it is the name of the element whose current controls them.
    """

    name: str
    nodes: tuple[str, str]
    value: Expr | None = None
    source: str = ""
    controls: tuple[str, ...] = ()

    @property
    def letter(self) -> str:
        """The letter that tells what it is."""
        return self.name[0]

    @property
    def symbol(self) -> Symbol:
        """Its name as a symbol."""
        return sp.Symbol(self.name, real=True)

    @property
    def given(self) -> Expr | None:
        """What a source gives: an input or a number."""
        return sp.Symbol(self.source, real=True) if self.source else self.value

    @property
    def control_current(self) -> Symbol:
        """The current that controls F or H."""
        return sp.Symbol(f"i_{self.controls[0]}", real=True)

    @property
    def watched(self) -> tuple[str, ...]:
        """The nodes whose voltages it acts on without taking a current from them."""
        return self.controls if self.letter in "EGO" else ()


Way = tuple[tuple[Element, int], ...]
"""Elements one after the other, each with 1 if it is passed from its first node to its second, else −1."""


@dataclass
class Forest:
    """Branches that form no loop."""

    near: dict[str, list[tuple[str, Element, int]]] = field(default_factory=dict)

    def add(self, element: Element) -> None:
        """Add a branch."""
        a, b = element.nodes
        self.near.setdefault(a, []).append((b, element, 1))
        self.near.setdefault(b, []).append((a, element, -1))

    def way(self, start: str, end: str) -> Way | None:
        """Return the way between two nodes, None where there is none."""
        found: dict[str, Way] = {start: ()}
        queue = deque([start])
        while queue and end not in found:
            here = queue.popleft()
            for there, element, sign in self.near.get(here, ()):
                if there not in found:
                    found[there] = (*found[here], (element, sign))
                    queue.append(there)
        return found.get(end)

    def reached(self, start: str, without: Element | None = None) -> set[str]:
        """Return the nodes that are reached from one, without passing an element."""
        found, queue = {start}, [start]
        while queue:
            for there, element, _ in self.near.get(queue.pop(), ()):
                if there not in found and element != without:
                    found.add(there)
                    queue.append(there)
        return found


@dataclass(frozen=True)
class Tree:
    """A normal tree of a circuit: its branches, and the links that close a loop each."""

    branches: tuple[Element, ...]
    links: tuple[Element, ...]
    forest: Forest

    def loop(self, link: Element) -> Way:
        """Return the way in the tree from the first node of a link to its second: v_link is the sum along it."""
        return self.forest.way(*link.nodes) or ()

    def cut(self, branch: Element) -> Way:
        """Return the links that join the two parts of the tree without a branch: its current is the sum of theirs.

        The sign is that with which the current of the link adds to that of the branch.
        """
        side = self.forest.reached(branch.nodes[0], without=branch)
        crossing = [link for link in self.links if (link.nodes[0] in side) != (link.nodes[1] in side)]
        return tuple((link, -1 if link.nodes[0] in side else 1) for link in crossing)


def normal_tree(elements: Iterable[Element]) -> Tree:
    """Return the normal tree; among elements of one letter those first that come first."""
    forest, branches, links = Forest(), list[Element](), list[Element]()
    for element in sorted(elements, key=lambda each: ORDER.index(each.letter)):
        inside = forest.way(*element.nodes) is None
        (branches if inside else links).append(element)
        if inside:
            forest.add(element)
    return Tree(tuple(branches), tuple(links), forest)


def loops_of_voltages(tree: Tree) -> Iterator[tuple[Element, ...]]:
    """Yield loops of elements that all set their voltage: contradictory, or with any current."""
    for link in tree.links:
        if link.letter in VOLTAGES:
            yield (*(element for element, _ in tree.loop(link)), link)


def cuts_of_currents(tree: Tree) -> Iterator[tuple[Element, ...]]:
    """Yield sets of elements that all set their current and are all that joins one part of a circuit to the rest."""
    for branch in tree.branches:
        if branch.letter in CURRENTS:
            yield (branch, *(element for element, _ in tree.cut(branch)))


def nodes_of(elements: Sequence[Element]) -> tuple[str, ...]:
    """Return the nodes in the order in which they occur."""
    return tuple(dict.fromkeys(node for element in elements for node in (*element.nodes, *element.watched)))
