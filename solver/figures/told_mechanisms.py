"""What is seen in the schematic of a mechanical system, in words."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from solver.derivation.mechanisms import Joint, Link, Mechanism, Turn
from solver.formula.terminal import flat
from solver.words import Phrase

Say = Callable[[str], str]
STEEP, LEVEL = 0.99, 0.01


def of_mechanism(figure: Mechanism, say: Say) -> str:
    """Tell the bodies and how they move, what joins them, the coordinates and the forces."""
    told = [*_joints(figure, say), *_links(figure, say), *_coordinates(figure, say)]
    if figure.gravity:
        told.append(say(Phrase("gravity {name} points downward", name=flat(figure.gravity))))
    return ". ".join(text[:1].upper() + text[1:] for text in told) + "."


def _names(figure: Mechanism, say: Say) -> list[str]:
    """What the joints are called where they are spoken of again."""
    words = {"pivot": "the pivot", "support": "the fixed support", "wall": "the wall"}
    return [
        say(words[each.shape]) if each.shape in words else say(Phrase("the {shape} {name}", shape=say(each.shape),
                                                                      name=flat(each.label).partition(",")[0]))
        for each in figure.joints
    ]  # fmt: skip


def _joints(figure: Mechanism, say: Say) -> Iterator[str]:
    """Each body, and the line that it moves along."""
    for number, joint in enumerate(figure.joints):
        if joint.shape in ("wall", "support"):
            continue
        free = not any(number == link.ends[1] for link in figure.links)
        pattern = {
            "box": "a box of mass {name} moves along {line}", "pivot": "a pivot without mass moves along {line}",
            "disc": "a disc of mass {name} moves along {line}",
        }[joint.shape]  # fmt: skip
        if joint.direction is not None:
            yield say(Phrase(pattern, name=_mass(joint, say), line=say(_line(joint.direction))))
        elif free:
            yield say(Phrase("a disc of mass {name} moves freely in the plane", name=_mass(joint, say)))


def _mass(joint: Joint, say: Say) -> str:
    """The mass of a body, and its inertia if it has one."""
    mass, _, inertia = flat(joint.label).partition(",")
    if not inertia:
        return mass
    return say(Phrase("{mass} and inertia {inertia}", mass=mass, inertia=inertia.strip()))


def _line(direction: tuple[float, float]) -> str:
    if abs(direction[1]) > STEEP:
        return "the vertical"
    return "the horizontal" if abs(direction[1]) < LEVEL else "an incline"


def _links(figure: Mechanism, say: Say) -> Iterator[str]:
    names, seen = _names(figure, say), set[int]()
    for link in figure.links:
        first, second = link.ends
        joint = figure.joints[second]
        end = names[second]
        if joint.shape == "disc" and joint.direction is None and second not in seen:
            end = say(Phrase("a disc of mass {name}", name=_mass(joint, say)))
        seen.add(second)
        yield _link(link, names[first], end, say)


def _link(link: Link, start: str, end: str, say: Say) -> str:
    pattern = {
        "rod": "a rod {label} joins {start} to {end}" if link.label else "a rod joins {start} to {end}",
        "spring": "a spring {label} lies between {start} and {end}",
        "beam": "on a beam {label} that turns about {start} slides {end}",
        "guide": "on a straight guide through {start} slides {end}",
    }[link.kind]
    return say(Phrase(pattern, label=flat(link.label), start=start, end=end))


def _coordinates(figure: Mechanism, say: Say) -> Iterator[str]:
    names = _names(figure, say)
    for each in figure.distances:
        pattern = "the length from {start} to {end} is {label}"
        if each.link is None:
            yield say(Phrase("the position of {end} is {label}", label=flat(each.label), end=names[each.joint]))
        else:
            start = names[figure.links[each.link].ends[0]]
            yield say(Phrase(pattern, label=flat(each.label), start=start, end=names[each.joint]))
    for turn in figure.turns:
        end = names[figure.links[turn.link].ends[1]]
        yield say(Phrase("the angle of {end} from {start} is {label}", label=flat(turn.label), end=end,
                         start=say(_reference(turn))))  # fmt: skip
    for push in figure.pushes:
        yield say(Phrase("the force {label} acts on {end}", label=flat(push.label), end=names[push.joint]))


def _reference(turn: Turn) -> str:
    """What an angle is measured from."""
    quarter = round(turn.start / 90)
    if abs(turn.start - 90 * quarter) > 0.01:
        return "the direction of the link before"
    return ("the horizontal", "the upward vertical", "the horizontal to the left", "the downward vertical")[quarter % 4]
