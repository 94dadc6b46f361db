"""Judges of stability: verdicts from eigenvalues, conditions at many points."""

import re

import numpy as np
from scipy.linalg import solve_continuous_lyapunov, solve_discrete_lyapunov

from tests.classroom.corpus.judges.registry import ImpossibleError, difference, judge, truth, unique, word
from tests.classroom.corpus.meanings import Meaning
from tests.hunt.asked import Point, holds, points
from tests.hunt.judges.found import hidden, rank
from tests.hunt.judges.stability import margin, spectrum_of
from tests.hunt.plants import fraction, matrices

SLACK = 1e-5


def _sizes(values: np.ndarray, discrete: bool) -> np.ndarray:
    return np.abs(values) - 1 if discrete else values.real


@judge("stability", "verdict")
def verdict(point: Point, meant: Meaning):
    A = matrices(point)[0]
    values = np.linalg.eigvals(A)
    sizes = _sizes(values, point.discrete)
    border = values[np.abs(sizes) <= SLACK]
    simple = all(len(A) - rank(A - v * np.eye(len(A))) == np.sum(np.abs(values - v) < 1e-4) for v in border)
    said = "asymptotically stable" if np.all(sizes < -SLACK) else "unstable"
    if len(border) and np.all(sizes <= SLACK) and simple:
        said = "marginally stable"
    return [word(meant.word == said)]


@judge("stability", "bibo_stable")
def bibo(point: Point, meant: Meaning):
    A, B, C, _ = matrices(point)
    seen = list(np.linalg.eigvals(A))
    for gone in [*hidden(A, B), *hidden(A.T, C.T)]:
        near = min(seen, key=lambda value: abs(value - gone), default=None)
        if near is not None and abs(near - gone) < 1e-5:
            seen.remove(near)
    return [word(truth(meant) == bool(np.all(_sizes(np.array(seen), point.discrete) < -SLACK)))]


@unique("stability", "P")
def lyapunov(point: Point):
    A = matrices(point)[0]
    Q = point.matrix(point.option("Q")) if point.option("Q") else np.eye(len(A))
    F = A if point.option("dual") else A.T
    return solve_discrete_lyapunov(F, Q) if point.discrete else solve_continuous_lyapunov(F, -Q)


@judge("stability_range", "condition")
@judge("routh_hurwitz", "condition")
def condition(point: Point, meant: Meaning):
    """True exactly where the roots decay: at many points, and on both sides of each bound that is named."""
    if any(_told(meant.words, other) != (gap < 0) for other, gap in _margins(point)):
        return [1.0]
    for text in meant.words:
        if re.search(r"[<>]=", text) and "=" in text:  # roots on the border do not decay
            return [1.0]
    return [0.0]


SAMPLED: dict[str, list[tuple[Point, float]]] = {}
"""By each question the points that are tried, with their margins: all its submissions are held to the same."""


def _margins(point: Point) -> list[tuple[Point, float]]:
    """Points at random, near and far, and of a single parameter close to each other, without those at the border."""
    question = point.question
    if (key := repr(question)) not in SAMPLED:
        drawn = [other for wide in (False, True) for other in points(question, 150, widely=wide)]
        found = [(other, gap) for other in drawn if abs(gap := margin(other)) > SLACK]
        names = question.symbols
        for value in np.arange(-30.03, 30.03, 0.05) if len(names) == 1 else ():
            other = Point(question, {names[0]: point.exactly(str(round(value, 4)))})
            if all(holds(each, other) for each in question.conditions) and _allowed(point, names[0], value):
                found += [(other, gap)] if abs(gap := margin(other)) > 1e-3 else []
        SAMPLED[key] = found
    return SAMPLED[key]


def _allowed(point: Point, name: str, value: float) -> bool:
    assumed = point.question.assume.get(name, "")
    return not (("positive" in assumed and value <= 0) or ("negative" in assumed and value >= 0))


def _told(words: list[str], point: Point) -> bool:
    return any(all(holds(each, point) for each in text.split(" and ")) for text in words)


@unique("routh_hurwitz", "right_half_plane_roots")
@unique("stability", "right_half_plane_roots")
def right_half_plane(point: Point):
    return np.sum(_sizes(spectrum_of(point), point.discrete) > 1e-4)


@unique("routh_hurwitz", "imaginary_axis_roots")
def imaginary_axis(point: Point):
    return np.sum(np.abs(spectrum_of(point).real) <= 1e-4)


@judge("routh_hurwitz", "stable")
def stable(point: Point, meant: Meaning):
    return [word(truth(meant) == bool(np.all(spectrum_of(point).real < -1e-4)))]


@judge("routh_hurwitz", "array")
def array(point: Point, meant: Meaning):
    """Rows up to a positive factor; only arrays without a zero in their first column are asked for here."""
    polynomial = fraction(point, point.question.system["polynomial"])[0]
    width = len(polynomial) // 2 + len(polynomial) % 2
    rows = [np.append(polynomial[i::2], np.zeros(width))[:width] for i in (0, 1)]
    while len(rows) < len(polynomial):
        upper, above = rows[-2:]
        rows.append(np.append(upper[1:], 0) - upper[0] / above[0] * np.append(above[1:], 0))
    theirs = np.array(rows)
    ours = meant()
    if ours.ndim != 2 or len(ours) != len(theirs):
        raise ImpossibleError("rows")
    ours = np.pad(ours, ((0, 0), (0, max(0, width - ours.shape[1]))))[:, :width]
    factors = ours[:, 0].real / theirs[:, 0].real
    return [1.0] if np.any(factors <= 0) else ours - factors[:, None] * theirs


@judge("routh_hurwitz", "determinants")
def determinants(point: Point, meant: Meaning):
    polynomial = fraction(point, point.question.system["polynomial"])[0]
    n = len(polynomial) - 1
    of = dict(enumerate(polynomial))
    H = np.array([[of.get(2 * (j + 1) - (i + 1), 0) for j in range(n)] for i in range(n)])
    return difference(meant(), [np.linalg.det(H[: i + 1, : i + 1]) for i in range(n)])


KINDS = {True: "stable", False: "unstable"}


@judge("phase_portrait", "kind")
def kind(point: Point, meant: Meaning):
    A = matrices(point)[0]
    trace, det = np.trace(A), np.linalg.det(A)
    spread = trace**2 - 4 * det
    side = KINDS[bool(trace < 0)]
    if abs(det) < 1e-9:
        said = "line of equilibria" if abs(trace) > 1e-9 else "shear"
    elif det < 0:
        said = "saddle"
    elif abs(spread) < 1e-9:
        said = f"{side} star" if rank(A - trace / 2 * np.eye(2)) == 0 else f"{side} degenerate node"
    else:
        said = f"{side} node" if spread > 0 else "center" if abs(trace) < 1e-9 else f"{side} focus"
    return [word(meant.word == said)]
