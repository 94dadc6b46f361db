"""Judges of transfer functions, realizations and models: transfer matrices at points, order by Hankel's rank."""

import numpy as np
import sympy as sp

from tests.hunt.asked import Point
from tests.hunt.judges.found import Found, hidden
from tests.hunt.plants import loop, matrices, transfer

POINTS = (1.7 + 0.9j, -0.4 + 2.3j, 5.1 - 1.2j, 0.23 + 0.31j)


def letter(point: Point) -> str:
    return "z" if point.discrete else "s"


def transfer_function(point: Point, found: Found) -> None:
    G = transfer(point)
    rows, columns = point.option("output"), point.option("input")
    for s in POINTS:
        value = G(s)[[rows - 1] if rows else slice(None)][:, [columns - 1] if columns else slice(None)]
        found.same("G", found.matrix("G", **{letter(point): sp.sympify(s)}), value)
    if "poles" in found and "zeros" in found and found.matrix("G", s=2, z=2).size == 1:
        poles, zeros = found.list("poles"), found.list("zeros")
        gains = [
            found.number("G", **{letter(point): sp.sympify(s)}) * np.prod(s - poles) / np.prod(s - zeros)
            for s in POINTS
        ]
        found.same("G is gain·∏(s − z)/∏(s − p)", gains, [gains[0]] * len(gains))
        found.holds("a zero is a pole", not len(poles) or not len(zeros) or np.min(abs(poles[:, None] - zeros)) > 1e-7)
    elif "poles" in found:
        found.holds("number of poles", len(found.list("poles")) == mcmillan_degree(G))
    states = not {"equations", "transfer_matrix"} & set(point.question.system)
    if "cancelled" in found and "poles" in found and not rows and not columns and states:
        found.spectrum("poles and cancelled", [*found.list("poles"), *found.list("cancelled")], matrices(point)[0])


def resolvent(point: Point, found: Found) -> None:
    A = matrices(point)[0]
    found.polynomial("det(s − A)", "polynomial", letter(point), A)
    for s in POINTS:
        ours = found.matrix("resolvent", **{letter(point): sp.sympify(s)})
        found.same("(s − A)⁻¹", ours, np.linalg.inv(s * np.eye(len(A)) - A))


def mcmillan_degree(G) -> int:
    """The rank of the Loewner matrix of G at points left and right: the order of a minimal realization."""
    left, right = (radius * np.exp(1j * np.linspace(0.1, 6.1, 12)) for radius in (2.1, 3.3))
    M = np.block([[(G(a) - G(b)) / (a - b) for b in right] for a in left])
    s = np.linalg.svd(M, compute_uv=False)
    return int(np.sum(s > 1e-9 * s[0])) if s[0] > 0 else 0


def _realizes(point: Point, found: Found) -> tuple[np.ndarray, ...]:
    A, B, C, D = (found.matrix(name) for name in "ABCD")
    G = transfer(point)
    for s in POINTS:
        found.same("C(s − A)⁻¹B + D", C @ np.linalg.solve(s * np.eye(len(A)) - A, B) + D, G(s))
    return A, B, C, D


def minimal_realization(point: Point, found: Found) -> None:
    A, B, C, _ = _realizes(point, found)
    found.holds("not minimal", not hidden(A, B) and not hidden(A.T, C.T))
    if "cancelled" in found:
        whole = [*np.linalg.eigvals(A), *found.list("cancelled")]
        found.spectrum("modes", whole, matrices(point)[0])


def realization(point: Point, found: Found) -> None:
    A, B, C, _ = _realizes(point, found)
    if "transfer_function" not in point.question.system:
        return
    n = len(loop(point)[1]) - 1
    found.holds("order", len(A) == n)
    form, convention = point.option("form", "controllable"), point.option("convention", "last_row")
    if form in ("controllable", "observable"):
        A, B = (A, B) if form == "controllable" else (A.T, C.T)
        ones = (A[:-1, 1:], A[-1:, :]) if convention == "last_row" else (A[1:, :-1], A[:1, :])
        found.same("ones of the companion form", ones[0], np.eye(n - 1))
        found.same("unit vector", B[:, 0], np.eye(n)[-1 if convention == "last_row" else 0])
    elif form == "diagonal":
        found.same("diagonal", A, np.diag(np.diag(A)))
    elif form == "jordan":
        side = A if convention == "superdiagonal" else A.T
        found.same("bidiagonal", side, np.diag(np.diag(A)) + np.diag(np.diag(side, 1), 1))
        found.holds("ones of the chains", set(np.diag(side, 1)) <= {0, 1})


def state_space_model(point: Point, found: Found) -> None:
    if "B" in found:
        _realizes(point, found)
