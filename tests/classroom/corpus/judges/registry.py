"""How judges are declared, and what several of them need."""

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from scipy.optimize import linear_sum_assignment

from tests.classroom.corpus.meanings import ImpossibleError, Meaning
from tests.hunt.asked import Point

Judge = Callable[[Point, Meaning], Any]

JUDGES: dict[tuple[str, str], Judge] = {}

POINTS = (1.7 + 0.9j, -0.4 + 2.3j, 3.1 - 1.2j, 0.63 + 0.31j, -2.6 + 1.4j, 0.9 - 2.2j)
"""Where functions of s or z are compared."""

MOMENTS = (0.15, 0.35, 0.8, 1.3, 1.9, 2.7, 3.6)
"""Where functions of time are compared."""

SAMPLES = range(9)


def judge(task: str, *answers: str) -> Callable[[Judge], Judge]:
    """Declare a function as the judge of answers that are judged alike."""

    def declared(function: Judge) -> Judge:
        JUDGES.update({(task, answer): function for answer in answers})
        return function

    return declared


def unique(task: str, answer: str) -> Callable[[Callable[[Point], Any]], Callable[[Point], Any]]:
    """Declare a function as the one value an answer can have."""

    def declared(function: Callable[[Point], Any]) -> Callable[[Point], Any]:
        JUDGES[task, answer] = lambda point, meant: difference(meant(), function(point))
        return function

    return declared


def difference(ours: np.ndarray, theirs: Any) -> np.ndarray:
    """How two arrays differ; a row, a column and a flat list of the same numbers are told apart by the caller."""
    theirs = np.asarray(theirs, dtype=complex)
    if np.shape(ours) != theirs.shape:
        if np.size(ours) == theirs.size == 1:
            return np.ravel(ours) - np.ravel(theirs)
        raise ImpossibleError(f"shape {np.shape(ours)} for {theirs.shape}")
    return ours - theirs


def multiset(ours: np.ndarray, theirs: Iterable[complex]) -> np.ndarray:
    """How two lists differ whose order is free."""
    a, b = np.ravel(ours), np.asarray(list(theirs), dtype=complex)
    if len(a) != len(b):
        raise ImpossibleError(f"{len(a)} values for {len(b)}")
    return a[(pairs := linear_sum_assignment(np.abs(a[:, None] - b)))[0]] - b[pairs[1]]


def matrix(meant: Meaning, shape: tuple[int, int], **more: complex) -> np.ndarray:
    """A matrix that must have a shape; a flat list is a row or a column as that asks."""
    M = meant(**more)
    if M.ndim == 2 and M.shape == shape:
        return M
    if M.ndim < 2 and 1 in shape and M.size == shape[0] * shape[1]:
        return M.reshape(shape)
    raise ImpossibleError(f"shape {M.shape} for {shape}")


def monic(M: np.ndarray) -> np.ndarray:
    """The coefficients of det(x − M)."""
    return np.atleast_1d(np.poly(M))


def polynomial_of(meant: Meaning, letter: str, coefficients: np.ndarray) -> np.ndarray:
    """How a polynomial differs from the one with these coefficients, at points."""
    return np.array([np.ravel(meant(**{letter: s}) - np.polyval(coefficients, s)) for s in POINTS])


def letter(point: Point) -> str:
    """The letter of transfer functions."""
    return "z" if point.discrete else "s"


def word(condition: bool) -> float:
    """What is left of a verdict: nothing if it is right."""
    return 0.0 if condition else 1.0


def truth(meant: Meaning) -> bool:
    """A verdict of yes or no."""
    if meant.word not in ("true", "false"):
        raise ImpossibleError("no verdict")
    return meant.word == "true"
