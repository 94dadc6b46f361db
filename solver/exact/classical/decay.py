"""How fast the modes of some poles decay: rates −Re p, time constants, and which modes are the slowest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.radicals import complex_parts
from solver.exact.stability.inequalities import sign_of


@dataclass(frozen=True)
class DecayMode:
    """Poles with one real part and opposite imaginary ones: one, or a conjugate pair; `rate` is −Re p.

    `sign` is that of the rate, None where parameters leave it open; `count` is how many poles these are in all.
    """

    poles: tuple[sp.Expr, ...]
    rate: sp.Expr
    sign: int | None
    multiplicity: int

    @property
    def count(self) -> int:
        """The number of poles."""
        return len(self.poles) * self.multiplicity

    @property
    def every(self) -> list[sp.Expr]:
        """The poles, each as often as it occurs."""
        return [pole for _ in range(self.multiplicity) for pole in self.poles]

    @property
    def time_constant(self) -> sp.Expr:
        """1/|Re p| of a mode that decays."""
        return sp.cancel(1 / self.rate) if self.rate.free_symbols else sp.radsimp(1 / self.rate)


@dataclass(frozen=True)
class Decay:
    """The modes, the slowest first; `in_order` is False where parameters leave open which of two is slower."""

    modes: tuple[DecayMode, ...]
    in_order: bool


def decay(poles: Sequence[sp.Expr]) -> Decay:
    """The modes of poles that are listed with multiplicity, conjugates among them."""
    found: list[DecayMode] = []
    for pole in dict.fromkeys(poles):
        real, imaginary = complex_parts(pole)
        partner = sp.expand(real - sp.I * imaginary)
        known = next((i for i, each in enumerate(found) if _same(each.poles[0], partner)), None)
        if imaginary != 0 and known is not None:
            first = found[known]
            found[known] = DecayMode((*first.poles, pole), first.rate, first.sign, first.multiplicity)
            continue
        rate = sp.factor(-real) if real.free_symbols else -real
        found.append(DecayMode((pole,), rate, sign_of(rate), list(poles).count(pole)))
    return _sorted(found)


def _same(a: sp.Expr, b: sp.Expr) -> bool:
    return bool(a == b or sp.expand(a - b) == 0)


def _sorted(modes: list[DecayMode]) -> Decay:
    """By rising rate, as far as it is known which is less; equal ones as they came."""
    listed: list[DecayMode] = []
    in_order = True
    for mode in modes:
        place = len(listed)
        for i, other in enumerate(listed):
            sign = sign_of(sp.expand(mode.rate - other.rate))
            in_order = in_order and sign is not None
            if sign == -1:
                place = i
                break
        listed.insert(place, mode)
    return Decay(tuple(listed), in_order)
