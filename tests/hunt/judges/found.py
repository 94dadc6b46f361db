"""What was answered, as numbers at a point; what is wrong with it, as words."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import sympy as sp

from tests.hunt.asked import Point, real

TOLERANCE = 1e-9
"""Relative to the largest entry: what doubles can tell apart in matrices this small."""

JUMPS = {
    "Heaviside": lambda x, at_zero=1: int(x > 0) or int(x == 0) * at_zero,
    "KroneckerDelta": lambda i, j: int(i == j),
}


class Found:
    """The answers of a part at a point. `value` of each is the text that the JSON has, read by sympy as promised."""

    def __init__(self, point: Point, values: Mapping[str, Any]) -> None:
        self.point = point
        self.values = values
        self.wrong: list[str] = []
        self._free: dict[sp.Symbol, sp.Rational] = {}

    def __contains__(self, name: str) -> bool:
        return name in self.values

    def exactly(self, name: str, **more: Any) -> Any:
        """An answer at the point, exactly; more names may be given values."""
        return _at(self.values[name], self.point.values | {sp.Symbol(key): sp.sympify(x) for key, x in more.items()})

    def matrix(self, name: str, **more: Any) -> np.ndarray:
        """A matrix, or an expression as one, of numbers; letters the answer leaves free get some value."""
        return self.numbers(self.exactly(name, **more))

    def number(self, name: str, **more: Any) -> complex:
        """A number."""
        return complex(self.matrix(name, **more)[0, 0])

    def list(self, name: str) -> np.ndarray:
        """Numbers of a list."""
        return np.array([self.numbers(each)[0, 0] for each in self.exactly(name)], dtype=complex)

    def numbers(self, value: Any) -> np.ndarray:
        """A value without the point's letters as numbers; any other letter gets one value, always the same."""
        M = value if isinstance(value, sp.MatrixBase) else sp.Matrix([[value]])
        for letter in sorted(M.free_symbols - set(self._free), key=str):
            self._free[letter] = sp.Rational(self.point.random.randint(-20, 20) * 2 + 1, 8)
        M = M.subs(self._free)
        entries = [complex(each.evalf(25)) for each in M]
        return real(np.array(entries, dtype=complex).reshape(M.shape))

    def quickly(self, name: str, letter: str) -> Callable[[Any], np.ndarray]:
        """An answer as a function of t or k, in floating point."""
        value = self.exactly(name)
        M = sp.Matrix(value if isinstance(value, sp.MatrixBase) else [[value]])
        f = sp.lambdify(sp.Symbol(letter), M.tolist(), [JUMPS, "mpmath"])
        return lambda x: np.array(f(x), dtype=complex)

    def same(self, what: str, ours: Any, theirs: Any, tolerance: float = TOLERANCE) -> None:
        """Note what is wrong if two arrays differ by more than doubles do."""
        a, b = np.asarray(ours, dtype=complex), np.asarray(theirs, dtype=complex)
        if a.shape != b.shape:
            self.wrong.append(f"{what}: shape {a.shape} for {b.shape}")
            return
        scale = max(1.0, float(np.max(np.abs(b), initial=0)))
        off = float(np.max(np.abs(a - b), initial=0))
        if not off <= tolerance * scale:
            self.wrong.append(f"{what}: off by {off:.3g} of {scale:.3g}")

    def holds(self, what: str, truth: Any) -> None:
        """Note what is wrong unless something holds."""
        if not truth:
            self.wrong.append(what)

    def spectrum(self, what: str, roots: Any, M: np.ndarray) -> None:
        """Whether the roots are those of det(x − M), with their multiplicities: the polynomials are compared."""
        roots, n = np.asarray(roots, dtype=complex), len(M)
        if len(roots) != n:
            self.wrong.append(f"{what}: {len(roots)} for {n}")
            return
        for x in circle(M):
            self.same(what, [np.prod((x - roots) / abs(x))], [np.linalg.det((x * np.eye(n) - M) / abs(x))])

    def polynomial(self, what: str, name: str, letter: str, M: np.ndarray) -> None:
        """Whether an answer is det(x − M)."""
        for x in circle(M):
            ours = self.number(name, **{letter: sp.sympify(x)})
            self.same(what, [ours / abs(x) ** len(M)], [np.linalg.det((x * np.eye(len(M)) - M) / abs(x))])


def circle(M: np.ndarray) -> np.ndarray:
    """More points than the order, on a circle around the spectrum."""
    n = len(M)
    radius = 1.5 * max(1.0, float(np.max(np.abs(np.linalg.eigvals(M)), initial=0)))
    return radius * np.exp(2j * np.pi * (np.arange(n + 2) + 0.3) / (n + 2))


def _at(value: Any, values: Mapping[sp.Symbol, Any]) -> Any:
    if isinstance(value, list | tuple):
        return [_at(each, values) for each in value]
    if isinstance(value, dict):
        return {key: _at(each, values) for key, each in value.items()}
    return value.subs(values) if isinstance(value, sp.Basic | sp.MatrixBase) else value


def rank(M: np.ndarray) -> int:
    """The rank, rows scaled first."""
    if not M.size:
        return 0
    size = np.max(np.abs(M), axis=1, keepdims=True)
    return int(np.linalg.matrix_rank(M / np.where(size > 0, size, 1), tol=1e-8))


def krylov(A: np.ndarray, B: np.ndarray) -> np.ndarray:
    """[B, AB, …, Aⁿ⁻¹B]."""
    columns = [B]
    for _ in range(len(A) - 1):
        columns.append(A @ columns[-1])
    return np.hstack(columns)


def hidden(A: np.ndarray, B: np.ndarray) -> list[complex]:
    """The eigenvalues that no input reaches: those of the quotient by the controllable subspace."""
    n = len(A)
    scale = max(1.0, float(np.linalg.norm(A, 2)))
    U, s, _ = np.linalg.svd(krylov(A / scale, B))
    r = int(np.sum(s > 1e-9 * max(1e-300, s[0]))) if s.size and s[0] > 0 else 0
    return list(np.linalg.eigvals(U[:, r:n].conj().T @ A @ U[:, r:n])) if r < n else []


def monic(roots: Any) -> np.ndarray:
    """The coefficients of the monic polynomial with these roots, of which there may be none."""
    return np.atleast_1d(np.poly(np.asarray(roots, dtype=complex)))
