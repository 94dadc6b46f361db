"""Judges of models: values found by hand, which the corpus states beside the question; equations up to a factor."""

import itertools

import numpy as np

from tests.classroom.corpus.judges.registry import difference, judge
from tests.classroom.corpus.meanings import ImpossibleError, Meaning
from tests.hunt.asked import NAMES, Point


def _by_hand(point: Point, answer: str, **more: complex) -> np.ndarray:
    """The value that was found by hand, with numbers for its letters."""
    raw = point.option("hand")[answer]
    return Meaning(_texts(raw), np.zeros(0), {str(s): complex(v) for s, v in point.values.items()})(**more)


def _texts(raw):
    return [_texts(each) for each in raw] if isinstance(raw, list) else str(raw)


def _letters(point: Point, answer: str) -> dict[str, complex]:
    """A number for each letter of a value that the question leaves free: coordinates, velocities, whole numbers."""
    names = sorted({name for each in _flat(point.option("hand")[answer]) for name in NAMES.findall(each)})
    known = {*point.question.assume, "pi", "sin", "cos", "sqrt"}
    return {name: 0.7 + 0.31 * i for i, name in enumerate(name for name in names if name not in known)}


def _flat(raw):
    return itertools.chain.from_iterable(map(_flat, raw)) if isinstance(raw, list) else iter([str(raw)])


@judge("linearization", "A", "B")
@judge("state_space_model", "A", "B", "C", "D")
@judge("initial_state", "x0")
def matrix_of_a_model(point: Point, meant: Meaning):
    """The one matrix of the shape."""
    answer = next(name for name, own in point.option("hand").items() if np.shape(own) == np.shape(meant.raw))
    found = [
        difference(meant(), _by_hand(point, name))
        for name, own in point.option("hand").items()
        if np.shape(own) == np.shape(meant.raw) and name >= answer
    ]
    return min(found, key=lambda each: float(np.max(np.abs(each))))


@judge("equilibrium_points", "points")
@judge("solve_equations", "solutions")
def points_in_any_order(point: Point, meant: Meaning):
    """The points of the list, each once."""
    answer = next(iter(point.option("hand")))
    letters = _letters(point, answer)
    ours, theirs = np.atleast_2d(_by_hand(point, answer, **letters)), np.atleast_2d(meant(**letters))
    if ours.shape != theirs.shape:
        raise ImpossibleError(f"{theirs.shape} for {ours.shape}")
    orders = itertools.permutations(range(len(ours)))
    return min((ours[list(order)] - theirs for order in orders), key=lambda each: float(np.max(np.abs(each))))


@judge("equations_of_motion", "equations")
def equation_up_to_a_factor(point: Point, meant: Meaning):
    """One equation, whose sides differ by a constant multiple of what is zero by hand."""
    letters = _letters(point, "equations")
    several = [
        {name: value * scale**i for i, (name, value) in enumerate(letters.items(), 1)} for scale in (0.6, 1, 1.7)
    ]
    pairs = [(np.ravel(meant(**each))[0], np.ravel(_by_hand(point, "equations", **each))[0]) for each in several]
    (a, b), *others = pairs
    return np.array([a * d - b * c for c, d in others])


@judge("equations_of_motion", "kinetic", "potential", "lagrangian")
def energy(point: Point, meant: Meaning):
    """The Lagrangian found by hand."""
    letters = _letters(point, "lagrangian")
    return difference(meant(**letters), _by_hand(point, "lagrangian", **letters))
