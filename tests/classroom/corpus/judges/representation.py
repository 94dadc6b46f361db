"""Judges of transfer functions, realizations and models."""

import numpy as np

from tests.classroom.corpus.judges.registry import POINTS, ImpossibleError, difference, judge, letter, matrix, multiset
from tests.classroom.corpus.meanings import Meaning
from tests.hunt.asked import Point
from tests.hunt.judges.found import hidden, krylov, rank
from tests.hunt.judges.representation import mcmillan_degree
from tests.hunt.plants import loop, matrices, transfer


@judge("transfer_function", "G")
def G(point: Point, meant: Meaning):
    theirs = transfer(point)
    rows, columns = point.option("output"), point.option("input")
    left = []
    for s in POINTS:
        value = theirs(s)[[rows - 1] if rows else slice(None)][:, [columns - 1] if columns else slice(None)]
        left.append(difference(meant(**{letter(point): s}), value))
    return left


@judge("transfer_function", "poles")
def poles(point: Point, meant: Meaning):
    """The eigenvalues that are neither uncontrollable nor unobservable."""
    A, B, C, _ = matrices(point)
    return multiset(meant(), _without(np.linalg.eigvals(A), [*hidden(A, B), *hidden(A.T, C.T)]))


@judge("transfer_function", "zeros")
def zeros(point: Point, meant: Meaning):
    """Of one input and output: the roots of det(s − A + B C) − (1 − D) det(s − A), without the hidden modes."""
    A, B, C, D = matrices(point)
    top = np.polysub(np.poly(A - B @ C), (1 - D[0, 0]) * np.poly(A))
    roots = np.roots(np.trim_zeros(np.where(np.abs(top) < 1e-9, 0, top), "f"))
    return multiset(meant(), _without(roots, [*hidden(A, B), *hidden(A.T, C.T)]))


def _without(values: np.ndarray, taken: list[complex]) -> list[complex]:
    left = list(values)
    for gone in taken:
        near = min(range(len(left)), key=lambda i: abs(left[i] - gone), default=None)
        if near is not None and abs(left[near] - gone) < 1e-5:
            left.pop(near)
    return left


def realizes(point: Point, found: dict[str, Meaning]) -> list[np.ndarray]:
    """A, B, C (and D) together: the transfer matrix at points, and the order that is asked for."""
    A = found["A"]()
    n = len(A)
    p, m = transfer(point)(POINTS[0]).shape
    B, C = matrix(found["B"], (n, m)), matrix(found["C"], (p, n))
    D = matrix(found["D"], (p, m)) if "D" in found else transfer(point)(1e12).real
    if point.question.task == "minimal_realization" and n != mcmillan_degree(transfer(point)):
        raise ImpossibleError("not minimal")
    if point.question.task == "realization":
        _in_form(point, A, B, C)
    return [C @ np.linalg.solve(s * np.eye(n) - A, B) + D - transfer(point)(s) for s in POINTS]


def _in_form(point: Point, A: np.ndarray, B: np.ndarray, C: np.ndarray) -> None:
    """The pattern of the canonical form; where no convention is named, that of any textbook."""
    if "transfer_function" in point.question.system and len(A) != len(loop(point)[1]) - 1:
        raise ImpossibleError("order")
    form, convention = point.option("form", "controllable"), point.option("convention")
    if form == "diagonal" and np.any(A - np.diag(np.diag(A))):
        raise ImpossibleError("not diagonal")
    pair = {"controllable": (A, B), "observable": (A.T, C.T)}.get(form)
    if pair is not None and not _companion(*pair, convention):
        raise ImpossibleError("no companion form")


def _companion(A: np.ndarray, B: np.ndarray, convention: str | None) -> bool:
    """Coefficients in the last row with the input there, or in the first; either where none is named."""
    unit = np.eye(len(A))
    last = np.array_equal(A[:-1], unit[1:]) and np.array_equal(B[:, 0], unit[-1])
    first = np.array_equal(A[1:], unit[:-1]) and np.array_equal(B[:, 0], unit[0])
    return {"last_row": last, "first_row": first}.get(str(convention), last or first)


def decomposes(point: Point, found: dict[str, Meaning]) -> list[np.ndarray]:
    """T, A, B, C together: the coordinates belong to T, and separate the parts."""
    A, B, C, _ = matrices(point)
    T, new = found["T"](), found["A"]()
    if T.shape != A.shape or new.shape != A.shape or rank(T) < len(A):
        raise ImpossibleError("no transformation")
    left = [A @ T - T @ new]
    if "B" in found:
        left.append(T @ matrix(found["B"], B.shape) - B)
    if "C" in found:
        left.append(matrix(found["C"], C.shape) - C @ T)
    return [*left, np.linalg.solve(T, krylov(A, B))[rank(krylov(A, B)) :]]


TOGETHER = {
    "realization": realizes,
    "minimal_realization": realizes,
    "state_space_model": realizes,
    "kalman_decomposition": decomposes,
}
