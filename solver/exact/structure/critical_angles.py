"""For which values of a parameter that occurs in sines and cosines only a matrix loses rank: the sampling periods, say.

With u = tan(θ/2) the entries are rational in u; the roots u are angles θ = 2 arctan u, and θ = π is tried by itself.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import sympy as sp

from solver.exact.linear_algebra.fields import NotExact, domain_matrix, in_sines
from solver.exact.structure.critical_values import critical_values

NAMES = ("n", "m", "n1", "n2", "n3")


@dataclass(frozen=True)
class CriticalAngles:
    """`angle` is θ, linear in the parameter; `angles` those of one turn for which the rank is lower.

    `families` are the same merged, θ as expressions in the integer `number`; `values` are the parameter's.
    """

    angle: sp.Expr
    angles: tuple[sp.Expr, ...]
    number: sp.Symbol
    families: tuple[sp.Expr, ...]
    values: tuple[sp.Expr, ...]


def is_in_angles(M: sp.MatrixBase, parameter: sp.Symbol) -> bool:
    """Whether the parameter occurs, and in sines and cosines only."""
    functions = {f: sp.Integer(0) for f in M.atoms(sp.sin, sp.cos) if f.has(parameter)}
    return bool(functions) and not M.xreplace(functions).has(parameter)


def critical_angles(M: sp.ImmutableMatrix, parameter: sp.Symbol) -> CriticalAngles:
    """The values of the parameter for which M (n×k, k ≥ n) has a rank below n; raises NotExact for several angles."""
    if len(_angles(M, parameter)) > 1:
        M = sp.ImmutableMatrix(M.applyfunc(sp.expand_trig))  # multiples of one angle
    found = _angles(M, parameter)
    if len(found) != 1 or any(not f.free_symbols for f in M.atoms(sp.sin, sp.cos)):
        raise NotExact("structure/several_angles", parameter=parameter.name)
    if not (angle := next(iter(found))).is_polynomial(parameter) or sp.degree(angle, parameter) != 1:
        raise NotExact("structure/several_angles", parameter=parameter.name)
    slope, start = sp.Poly(angle, parameter).all_coeffs()
    u = sp.Dummy("u", real=True)
    below = 1 + u**2
    turned = M.xreplace({sp.cos(angle): (1 - u**2) / below, sp.sin(angle): 2 * u / below})
    angles = [2 * sp.atan(root) for root in critical_values(sp.ImmutableMatrix(turned), u).values]
    if domain_matrix(M.xreplace({sp.cos(angle): sp.Integer(-1), sp.sin(angle): sp.Integer(0)})).rank() < M.rows:
        angles.append(sp.pi)
    taken = {str(symbol) for symbol in M.free_symbols}
    number = sp.Symbol(next(name for name in NAMES if name not in taken), integer=True)
    families = _merged(angles, number)
    values = [sp.expand((family - start) / slope) for family in families]
    return CriticalAngles(angle, tuple(angles), number, tuple(families), tuple(values))


def _angles(M: sp.MatrixBase, parameter: sp.Symbol) -> set[sp.Expr]:
    return {f.args[0] for f in M.atoms(sp.sin, sp.cos) if f.has(parameter)}


def _merged(angles: list[sp.Expr], number: sp.Symbol) -> list[sp.Expr]:
    """The angles plus any number of turns; where they divide a turn evenly, the first plus multiples of that part."""
    if any(each.free_symbols for each in angles):
        return [each + 2 * number * sp.pi for each in angles]
    ordered = sorted((each % (2 * sp.pi) for each in angles), key=sp.N)
    part = 2 * sp.pi / max(1, len(ordered))
    if len(ordered) > 1 and all(sp.expand(other - one) == part for one, other in pairwise(ordered)):
        return [ordered[0] + number * part]
    return [each + 2 * number * sp.pi for each in sorted(angles, key=sp.N)]


def vanishing_form(value: sp.Expr) -> sp.Expr:
    """A determinant in factors, with cos² − 1 seen as −sin²."""
    plain, sines = sp.factor(value), sp.factor(in_sines(value))
    return min((plain, sines), key=lambda x: (-len(sp.Mul.make_args(x)), sp.count_ops(x)))
