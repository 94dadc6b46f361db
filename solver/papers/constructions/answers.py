"""The relations of answers: of a regulator or a filter and its Riccati equation, of a gain and the poles it places."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.conditions import symbols_of
from solver.derivation import Given
from solver.papers.constructions.relations import Loop, Matrix, Relations
from solver.papers.regulators import GAINS, weighed


@dataclass(frozen=True, slots=True)
class Asked:
    """A part whose answers must be nice, with what it works on, what its answers must be, and the letters drawn.

    Letters with many values come first: what is solved for is among them more often.
    """

    part: str
    task: str
    given: Given[Any, Any]
    kinds: Mapping[str, str]
    letters: Sequence[str]

    def unknown(self, name: str, rows: int, columns: int, *, symmetric: bool = False) -> Any:
        """Return a matrix of symbols that belong to the part."""

        def entry(i: int, j: int) -> sp.Symbol:
            i, j = (min(i, j), max(i, j)) if symmetric else (i, j)
            return sp.Symbol(f"{self.part}.{name}{i},{j}")

        return sp.ImmutableMatrix(rows, columns, entry)

    def group(self, *inside: Any, without: Sequence[Any] = ()) -> tuple[str, ...]:
        """Return the letters in some matrices or expressions, without those in others."""
        found = {x.name for x in symbols_of(*inside)} - {x.name for x in symbols_of(*without)}
        return tuple(name for name in self.letters if name in found)


def of_regulator(asked: Asked) -> Relations | None:
    """Return the relations of K and P: R K = BᵀP + Nᵀ and AᵀP + PA + Q = KᵀRK, linear in P and Q where K is known.

    Where Q has a letter for each of its entries, P is chosen in place of K. Of a filter they are the relations of the
    regulator that is dual to it, and K is Lᵀ. In discrete time there are none: a loop with whole numbers and stable
    poles has its poles at zero.
    """
    problem = weighed(asked.task, asked.given)
    A, B, Q, R, N = problem.matrices
    n, m = B.shape
    kind = asked.kinds.get(GAINS[asked.task], "")
    if problem.discrete or not (kind or "P" in asked.kinds) or (not kind and R.det().is_zero is not False):
        return None
    P = asked.unknown("P", n, n, symmetric=True)
    letters = asked.group(Q, without=(A, B, R, N))
    free = len(letters) >= n * (n + 1) // 2
    M = asked.unknown("K", m, n)
    RK, KRK = (R * M, M.T * R * M) if kind else (M, M.T * R.inv() * M)
    W = asked.unknown("Q", n, n, symmetric=True)
    if free:
        KRK = (P * B + N) * R.inv() * (B.T * P + N.T)
    equations = [*(RK - B.T * P - N.T), *(_lower(A.T * P + P * A + Q - KRK)), *(_lower(W - Q) if free else ())]
    gains = [(x.name, kind) for x in M]
    entries = [(x.name, asked.kinds.get("P", "")) for x in dict.fromkeys(P)]
    return Relations(
        tuple(equations),
        chosen=tuple(entries if free else gains),
        unknown=(*(gains if free else entries), *((x.name, "") for x in dict.fromkeys(W) if free)),
        definite=(_names(P),),
        semidefinite=(_names(W),) if free else (),
        letters=((letters, None),),
        loops=_loops(asked, A - B * (M if kind else R.inv() * M), M) if m == 1 and not free else (),
    )


def _loops(asked: Asked, closed: Any, numbers: Any) -> tuple[Loop, ...]:
    """Return how the numbers of a gain belong to the coefficients of det(sI − closed), where there is one input."""
    n = closed.rows
    coefficients = asked.unknown("c", 1, n)
    differences = [a - c for a, c in zip(_coefficients(closed), coefficients, strict=True)]
    whole = asked.kinds.get("eigenvalues") == "integers"
    return (Loop(tuple(differences), tuple(x.name for x in numbers), tuple(x.name for x in coefficients), whole),)


def _coefficients(matrix: Any) -> list[sp.Expr]:
    """Return the coefficients of det(sI − matrix), the constant one first, without the leading 1."""
    s = sp.Dummy("s")
    found: list[sp.Expr] = sp.Poly((s * sp.eye(matrix.rows) - matrix).det(method="berkowitz"), s).all_coeffs()
    return found[:0:-1]


def of_placement(asked: Asked) -> Relations | None:
    """Return the relations of K, A and the poles of A − BK, where there is one input."""
    system = asked.given.system
    return _placed(asked, "K", system.A, system.B)


def of_observer(asked: Asked) -> Relations | None:
    """Return the relations of L, A and the poles of A − LC, where there is one output."""
    system = asked.given.system
    return _placed(asked, "L", system.A.T, system.C.T)


def _placed(asked: Asked, gain: str, A: Any, B: Any) -> Relations | None:
    n, m = B.shape
    poles = asked.given.options.poles
    if m != 1 or gain not in asked.kinds or poles is None or len(poles) != n:
        return None
    K = asked.unknown("K", 1, n)
    differences = [a - b for a, b in zip(_coefficients(A - B * K), _coefficients(sp.diag(*poles)), strict=True)]
    return Relations(
        tuple(sp.expand(each) for each in differences),
        chosen=tuple((x.name, asked.kinds[gain]) for x in K),
        letters=((asked.group(A, B), n),),
    )


def _lower(matrix: Any) -> list[sp.Expr]:
    return [matrix[i, j] for i in range(matrix.rows) for j in range(i + 1)]


def _names(matrix: Any) -> Matrix:
    return tuple(tuple(x.name for x in row) for row in matrix.tolist())


ANSWERS: Mapping[str, Callable[[Asked], Relations | None]] = {
    "lqr": of_regulator,
    "kalman_filter": of_regulator,
    "pole_placement": of_placement,
    "observer": of_observer,
}
"""By task; a task that is not here has no answers from which to begin."""
