"""What generated questions are drawn from: matrices of chosen modes in integer coordinates, poles, quotients."""

import random
from collections.abc import Sequence
from typing import Any

import sympy as sp

Rows = list[list[Any]]
Asked = dict[str, Any]


class Dice:
    """Draws of one question."""

    def __init__(self, seed: str) -> None:
        self.random = random.Random(seed)

    def one(self, choices: Sequence[Any]) -> Any:
        """One of several."""
        return self.random.choice(choices)

    def integer(self, low: int, high: int) -> int:
        """An integer, both ends possible."""
        return self.random.randint(low, high)

    def entries(self, rows: int, columns: int, size: int = 2) -> sp.Matrix:
        """Small integers, no column of zeros."""
        M = sp.Matrix(rows, columns, lambda *_: self.integer(-size, size))
        for j in range(columns):
            if not any(M[:, j]):
                M[self.integer(0, rows - 1), j] = 1
        return M

    def coordinates(self, n: int) -> sp.Matrix:
        """An integer matrix of determinant 1."""
        lower = sp.Matrix(n, n, lambda i, j: 1 if i == j else self.integer(-1, 1) if i > j else 0)
        upper = sp.Matrix(n, n, lambda i, j: 1 if i == j else self.integer(-1, 1) if i < j else 0)
        return lower * upper

    def modes(self, n: int, stable: bool, discrete: bool = False) -> list[sp.Matrix]:
        """Blocks of n states: real modes, pairs and now and then a chain."""
        real = [-1, -2, -3, -4, "-1/2"] if not discrete else [0, "1/2", "-1/2", "1/3", "1/4"]
        real = list(map(sp.Rational, real)) + ([] if stable else [sp.Integer(0), sp.Integer(1), sp.Integer(2)])
        blocks, left = [], n
        while left:
            value = self.one(real)
            kind = self.one(["real", "real", "pair", "chain"] if left > 1 else ["real"])
            omega = self.one([1, 2, 3]) if not discrete else sp.Rational(1, 2)
            pair = sp.Matrix([[value, omega], [-omega, value]])
            chain = sp.Matrix([[value, 1], [0, value]])
            blocks.append({"real": sp.Matrix([[value]]), "pair": pair, "chain": chain}[kind])
            left -= blocks[-1].rows
        return blocks

    def matrix(self, n: int, stable: bool = False, discrete: bool = False) -> sp.Matrix:
        """A matrix with these modes, or of small integers with whatever modes that gives."""
        if not stable and self.random.random() < 0.4:
            return self.entries(n, n, 3)
        T = self.coordinates(n)
        return T * sp.diag(*self.modes(n, stable, discrete)) * T.inv()

    def plant(self, n: int, m: int = 1, p: int = 1, **kind: Any) -> Asked:
        """A, B, C as a question writes them."""
        time = {"time": "discrete"} if kind.get("discrete") else {}
        return {**time, "A": rows(self.matrix(n, **kind)), "B": rows(self.entries(n, m)), "C": rows(self.entries(p, n))}

    def poles(self, n: int, discrete: bool = False) -> list[Any]:
        """So many poles where motion decays."""
        found: list[Any] = []
        while (left := n - sum(2 if "±" in str(pole) else 1 for pole in found)) > 0:
            pair = left > 1 and self.random.random() < 0.5
            if discrete:
                found.append(self.one(["0.2 ± 0.3j", "0.4 ± 0.2j"]) if pair else self.one([0, 0.5, 0.2, "1/3"]))
            else:
                found.append(f"{-self.integer(1, 4)} ± {self.integer(1, 4)}j" if pair else -self.integer(1, 6))
        return found

    def factors(self, count: int, variable: str = "s") -> str:
        """A product of so many factors, as a textbook writes it."""
        one = [f"({variable}+{self.integer(1, 5)})" for _ in range(count)]
        if count > 1 and self.random.random() < 0.4:
            one[:2] = [f"({variable}^2+{self.integer(1, 4)}{variable}+{self.integer(2, 9)})"]
        if self.random.random() < 0.2:
            one[0] = variable if count == 1 else one[0]
        return "".join(one) or "1"

    def transfer(self, n: int, zeros: int, variable: str = "s") -> str:
        """A transfer function of n poles."""
        return f"{self.integer(1, 6)}{self.factors(zeros, variable) if zeros else ''}/({self.factors(n, variable)})"

    def letters(self, M: Rows, *names: str) -> Rows:
        """The matrix with letters in place of some entries."""
        n, m = len(M), len(M[0])
        changed = [list(row) for row in M]
        for name in names:
            changed[self.integer(0, n - 1)][self.integer(0, m - 1)] = name
        return changed


def rows(M: sp.Matrix) -> Rows:
    """The matrix as rows of numbers and fractions."""
    return [[int(x) if x.is_Integer else str(x) for x in row] for row in M.tolist()]
