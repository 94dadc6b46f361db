"""The phase margin with parameters: the turn of 180° + ∠L in (−180°, 180°], by the quadrants of factors."""

from __future__ import annotations

import sympy as sp

from solver.exact.frequency.with_parameters import FactorOnAxis, ParametricFactors
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.stability.inequalities import sign_of

HALF_TURN = 180


def margin_in_turn(L: ParametricFactors, omega: sp.Expr) -> sp.Expr:
    """180° + ∠L(jω), ω > 0, in (−180, 180]; raises NotExact where parameters decide which turn that is."""
    some = sp.Dummy("omega", positive=True) if omega.free_symbols else omega
    rows = L.at(some)
    whole = sp.Add(HALF_TURN, *(each.degrees * each.power for each in rows)).xreplace({some: omega})
    if whole.is_Rational:
        return whole - 360 * sp.ceiling((whole - HALF_TURN) / 360)
    low, high = sp.Integer(HALF_TURN), sp.Integer(HALF_TURN)
    for each in rows:
        ends = [end * each.power for end in _range_of(each)]
        low, high = low + min(ends), high + max(ends)
    turns = sp.floor((low + HALF_TURN) / 360)
    if high - 360 * turns > HALF_TURN:
        raise NotExact("frequency/turn_not_known", angle=whole)
    return whole - 360 * turns


def _range_of(row: FactorOnAxis) -> tuple[sp.Expr, sp.Expr]:
    """Between which angles that of a factor lies."""
    if row.degrees.is_Rational:
        return row.degrees, row.degrees
    real, imaginary = row.value.as_real_imag() if not row.value.free_symbols else _parts(row.value)
    side, height = sign_of(real), sign_of(imaginary)
    quadrant = {(1, 1): (0, 90), (1, -1): (-90, 0), (-1, 1): (90, 180), (-1, -1): (-180, -90)}
    low, high = quadrant.get((side or 0, height or 0)) or ((-90, 90) if side == 1 else (-180, 180))
    return sp.Integer(low), sp.Integer(high)


def _parts(value: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """a and b of a + jb with real parameters."""
    whole = sp.expand(value)
    imaginary = whole.coeff(sp.I)
    return sp.expand(whole - sp.I * imaginary), imaginary


__all__ = ["margin_in_turn"]
