"""Elimination with a pen: one unknown expressed by one equation and put into the others, until one is left."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.affine import affine, tidy, vanishes
from solver.exact.linear_algebra.fields import domain_matrix


@dataclass(frozen=True, slots=True)
class LinearEquation:
    """Σ cⱼ vⱼ = right, numbered from 1 as it was given."""

    number: int
    coefficients: tuple[sp.Expr, ...]
    right: sp.Expr

    @property
    def unknowns(self) -> tuple[int, ...]:
        """The positions of the unknowns that are in it."""
        return tuple(j for j, c in enumerate(self.coefficients) if c != 0)


@dataclass(frozen=True, slots=True)
class Substitution:
    """An unknown as an equation gives it, `constant` + Σ `shares`ⱼ vⱼ; the equations before and after it is put in."""

    equation: LinearEquation
    unknown: int
    constant: sp.Expr
    shares: tuple[sp.Expr, ...]
    changed: tuple[tuple[LinearEquation, LinearEquation], ...]


def elimination(
    equations: Sequence[tuple[sp.Expr, sp.Expr]], unknowns: Sequence[sp.Symbol], free: Sequence[int] = ()
) -> tuple[Substitution, ...]:
    """Eliminate one unknown after another from equations that have a solution; the `free` ones are left.

    Taken is the equation with the fewest unknowns, in it a coefficient ±1, then a number, then any.
    """
    M, constants = affine([left - right for left, right in equations], unknowns)
    left = [LinearEquation(i + 1, tuple(M.row(i)), tidy(-c)) for i, c in enumerate(constants)]
    found: list[Substitution] = []
    while candidates := [(each, j) for each in left for j in each.unknowns if j not in free]:
        equation, j = min(candidates, key=lambda each: _effort(each[0], each[1], left, free))
        a = equation.coefficients[j]
        shares = tuple(sp.S.Zero if i == j else tidy(-c / a) for i, c in enumerate(equation.coefficients))
        constant = tidy(equation.right / a)
        others = [each for each in left if each is not equation]
        after = [_put_in(each, j, constant, shares) if each.coefficients[j] != 0 else each for each in others]
        changed = tuple((old, new) for old, new in zip(others, after, strict=True) if old is not new)
        found.append(Substitution(equation, j, constant, shares, changed))
        left = after
    return tuple(found)


def independent_equations(
    equations: Sequence[tuple[sp.Expr, sp.Expr]], unknowns: Sequence[sp.Symbol]
) -> list[tuple[sp.Expr, sp.Expr]]:
    """Return as many independent equations as there are, of the others those with fewer unknowns first."""
    M, _ = affine([left - right for left, right in equations], unknowns)
    order = sorted(range(M.rows), key=lambda i: sum(entry != 0 for entry in M.row(i)))
    columns = domain_matrix(sp.Matrix([M.row(i) for i in order]).T).rref()[1]
    return [equations[i] for i in sorted(order[j] for j in columns)]


def _effort(
    equation: LinearEquation, j: int, all_equations: Sequence[LinearEquation], free: Sequence[int]
) -> tuple[int, int, int, int, int]:
    """How hard it is to express unknown j by an equation, and how often it must then be put in."""
    a = equation.coefficients[j]
    kind = 0 if a in (1, -1) else 1 if a.is_Rational else 2 if not a.free_symbols else 3
    elsewhere = sum(each.coefficients[j] != 0 for each in all_equations)
    return sum(i not in free for i in equation.unknowns), kind, elsewhere, equation.number, j


def _put_in(equation: LinearEquation, j: int, constant: sp.Expr, shares: Sequence[sp.Expr]) -> LinearEquation:
    a = equation.coefficients[j]
    pairs = zip(equation.coefficients, shares, strict=True)
    coefficients = [sp.S.Zero if i == j else _sum(c, a * share) for i, (c, share) in enumerate(pairs)]
    return LinearEquation(equation.number, tuple(coefficients), _sum(equation.right, -a * constant))


def _sum(left: sp.Expr, right: sp.Expr) -> sp.Expr:
    """The sum; of decimals zero where nothing but their last digits is left."""
    value = tidy(left + right)
    return sp.S.Zero if vanishes(value) else value
