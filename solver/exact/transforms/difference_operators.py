"""Linear difference equations with constant coefficients, each as Σ c y(k+q) = Σ d u(k+p) + r(k), and transformed.

Of a sequence that begins with given values the z-transform makes y(k+q) zᵠ(Y − Σ y(m) z⁻ᵐ), m = 0 … q − 1, and y(k−q)
z⁻ᵠ Y + Σ y(−m) z^{m−q}, m = 1 … q. From rest, all values before 0 being zero, y(k+q) is zᵠ Y for any q.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.transforms.operators import Jet, in_powers_of


@dataclass(frozen=True)
class SampleRow:
    """An equation: coefficients of samples of unknowns (left) and of inputs (right), by jet, and the rest r(k)."""

    unknowns: Mapping[Jet, sp.Expr]
    inputs: Mapping[Jet, sp.Expr]
    rest: sp.Expr

    def later(self, n: int, k: sp.Symbol) -> SampleRow:
        """The equation n samples later."""
        unknowns, inputs = ({(x, q + n): c for (x, q), c in each.items()} for each in (self.unknowns, self.inputs))
        return SampleRow(unknowns, inputs, self.rest.subs(k, k + n) if n else self.rest)


@dataclass(frozen=True)
class SampleOperators:
    """The rows of difference equations in `unknowns` and `inputs`."""

    rows: tuple[SampleRow, ...]
    unknowns: tuple[str, ...]
    inputs: tuple[str, ...]
    k: sp.Symbol

    @cached_property
    def spans(self) -> dict[str, tuple[int, int]]:
        """The earliest and the latest sample of each unknown."""
        shifts = {name: [q for row in self.rows for x, q in row.unknowns if x == name] for name in self.unknowns}
        return {name: (min(each), max(each)) for name, each in shifts.items()}

    @property
    def order(self) -> int:
        """How many values start the recursion."""
        return sum(high - low for low, high in self.spans.values())

    def later(self, n: int) -> SampleOperators:
        """The equations n samples later."""
        rows = tuple(row.later(n, self.k) for row in self.rows)
        return SampleOperators(rows, self.unknowns, self.inputs, self.k)

    @cached_property
    def leading(self) -> sp.ImmutableMatrix:
        """The coefficients of the latest samples (n×n), which the equations must give."""
        tops = [(name, self.spans[name][1]) for name in self.unknowns]
        return sp.ImmutableMatrix([[row.unknowns.get(top, sp.S.Zero) for top in tops] for row in self.rows])

    def matrix(self, z: sp.Symbol) -> sp.ImmutableMatrix:
        """P(z) (n×n), in powers of z and 1/z."""
        entries = [
            [sp.Add(*(c * z**q for (x, q), c in row.unknowns.items() if x == name)) for name in self.unknowns]
            for row in self.rows
        ]
        return sp.ImmutableMatrix(entries)


def sample_operators_of(
    equations: Sequence[sp.Expr], jets: Mapping[sp.Symbol, Jet], unknowns: Sequence[str], inputs: Sequence[str],
    k: sp.Symbol,
) -> SampleOperators:  # fmt: skip
    """The rows of expressions that are zero, linear in `jets`; raises NotExact where they are not, or fix nothing."""
    rows = []
    for equation in equations:
        rest = sp.expand(equation.xreplace({each: k for each in equation.free_symbols if str(each) == str(k)}))
        left: dict[Jet, sp.Expr] = {}
        right: dict[Jet, sp.Expr] = {}
        for symbol, jet in jets.items():
            c: Any = sp.diff(rest, symbol)
            rest = sp.expand(rest - c * symbol)
            if c.has(k, *jets):
                raise NotExact("difference_equation/not_linear", equation=equation)
            if c != 0:
                own, sign = (right, -1) if jet[0] in inputs else (left, 1)
                own[jet] = tidy(sign * c)
        rows.append(SampleRow(left, right, -rest))
    found = SampleOperators(tuple(rows), tuple(unknowns), tuple(inputs), k)
    if any(not any(x == name for row in rows for x, _ in row.unknowns) for name in unknowns):
        raise NotExact("difference_equation/singular")
    if sp.expand(found.leading.det()) == 0 and cleared_adjugate(found, sp.Dummy("z"))[1] == 0:
        raise NotExact("difference_equation/singular")
    return found


def cleared_adjugate(operators: SampleOperators, z: sp.Symbol) -> tuple[sp.ImmutableMatrix, sp.Expr, tuple[int, ...]]:
    """adj and det of the matrix in positive powers of z, and the power by which each row is multiplied for that."""
    powers = tuple(max(0, *(-q for _, q in row.unknowns)) for row in operators.rows)
    P = operators.matrix(z)
    cleared = sp.Matrix(P.rows, P.cols, lambda i, j: sp.expand(P[i, j] * z ** powers[i]))
    found, whole = DomainMatrix.from_Matrix(cleared, extension=True).adj_det()
    adjugate = found.to_Matrix().applyfunc(lambda entry: in_powers_of(entry, z))
    return sp.ImmutableMatrix(adjugate), in_powers_of(found.domain.to_sympy(whole), z), powers


def start_of_sample(jet: Jet, values: Mapping[Jet, sp.Expr], z: sp.Symbol) -> sp.Expr:
    """What the transform of y(k+q) has beside zᵠ Y: the values that are left out, or that come in."""
    name, q = jet
    if q >= 0:
        return sp.Add(*(-values.get((name, m), sp.S.Zero) * z ** (q - m) for m in range(q)))
    return sp.Add(*(values.get((name, -m), sp.S.Zero) * z ** (m + q) for m in range(1, -q + 1)))


def start_of(
    operators: SampleOperators, z: sp.Symbol, initial: Mapping[Jet, sp.Expr], first: Mapping[Jet, sp.Expr]
) -> sp.ImmutableMatrix:
    """What the values at the start add on the right of each row (n×1); `first` are the first values of the inputs."""
    rows = []
    for row in operators.rows:
        unknown = (-c * start_of_sample(jet, initial, z) for jet, c in row.unknowns.items())
        given = (c * start_of_sample(jet, first, z) for jet, c in row.inputs.items() if jet[1] > 0)
        rows.append(sp.expand(sp.Add(*unknown, *given)))
    return sp.ImmutableMatrix(rows)


def window_of(operators: SampleOperators, given: Mapping[Jet, sp.Expr]) -> int | None:
    """By how many samples the equations are to be moved so that they go on from the values given; None: from none.

    As they stand they need y(a) … y(b − 1), where y(k+a) is the earliest sample and y(k+b) the latest; what is not
    given is zero then. Values at other samples must be complete.
    """

    def fits(n: int, *, whole: bool) -> bool:
        needed = {(x, m) for x, (low, high) in operators.spans.items() for m in range(low + n, high + n)}
        return set(given) <= needed and (not whole or set(given) == needed)

    if fits(0, whole=False):
        return 0
    found = [n for n in range(-MOST_MOVED, MOST_MOVED + 1) if fits(n, whole=True)]
    usable = [n for n in found if all(low + n <= 0 <= high + n for low, high in operators.spans.values())]
    return usable[0] if usable else None


MOST_MOVED = 12
"""By so many samples equations are moved at most, as many as samples are read."""
