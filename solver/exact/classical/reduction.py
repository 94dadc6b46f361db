"""A transfer function reduced to its dominant poles: fast factors are replaced by their values at zero.

So the DC gain is kept, of an integrator the velocity constant. In discrete time the slowest poles are those of largest
size, and fast factors are replaced by their values at one. Source: Ogata, Modern Control Engineering, section 5-4.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.classical.decay import Decay, DecayMode, decay
from solver.exact.classical.factors import PoleZeroForm
from solver.exact.linear_algebra.radicals import complex_parts
from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.stability.inequalities import sign_of


@dataclass(frozen=True)
class Reduction:
    """The modes that are kept and dropped, the zeros too; `ratio` of the first rate dropped to the last one kept.

    `constant` is what the dropped factors are at zero (at one), zeros over poles; with the `gain`, which it is part of,
    times `top` over `bottom` the function is made. `lasting` tells how many poles are kept because their modes do not
    decay, `split` a pair that did not fit any more; `crowded` that a slow zero is dropped as there is no pole for it.
    """

    kept: tuple[DecayMode, ...]
    dropped: tuple[DecayMode, ...]
    zeros_kept: tuple[sp.Expr, ...]
    zeros_dropped: tuple[sp.Expr, ...]
    constant: sp.Expr
    gain: sp.Expr
    top: sp.Expr
    bottom: sp.Expr
    ratio: sp.Expr | None
    lasting: int
    split: DecayMode | None
    crowded: bool

    @property
    def function(self) -> sp.Expr:
        """The reduced function."""
        return sp.Mul(self.gain, self.top, 1 / self.bottom)

    @property
    def poles_kept(self) -> list[sp.Expr]:
        """The poles kept, with multiplicity."""
        return [pole for mode in self.kept for pole in mode.every]

    @property
    def poles_dropped(self) -> list[sp.Expr]:
        """The poles dropped, with multiplicity."""
        return [pole for mode in self.dropped for pole in mode.every]


class NotReduced(Exception):  # noqa: N818 - it is a finding
    """`why`: open (parameters), nothing (there are no more poles than asked for), lasting (too many do not decay)."""

    def __init__(self, why: str, count: int = 0) -> None:
        super().__init__(why)
        self.why, self.count = why, count


def reduction(form: PoleZeroForm, order: int, *, discrete: bool = False) -> Reduction:
    """The reduction to so many poles, one less rather than half a pair; raises NotReduced."""
    found = decay(form.poles, sp.Integer(1) if discrete else None)
    kept, dropped, split = _chosen(found, order, len(form.poles))
    room = sum(mode.count for mode in kept) - (1 if len(form.zeros) < len(form.poles) else 0)
    at = sp.Integer(1 if discrete else 0)
    slow, fast, crowded = _zeros(form.zeros, dropped, room, at)
    x = form.variable
    constant = sp.Integer(1)
    for root in fast:
        constant *= at - root
    for mode in dropped:
        for pole in mode.every:
            constant /= at - pole
    constant = _tidied(constant)
    top, bottom = _product(x, slow), _product(x, [pole for mode in kept for pole in mode.every])
    last = kept[-1].rate
    ratio = _tidied(dropped[0].rate / last) if kept[-1].sign == 1 else None
    if ratio is not None and ratio.has(sp.log) and not ratio.free_symbols:
        ratio = sp.N(ratio, DIGITS)
    lasting = sum(mode.count for mode in kept if mode.sign != 1)
    return Reduction(
        kept,
        dropped,
        tuple(slow),
        tuple(fast),
        constant,
        _tidied(form.gain * constant),
        top,
        bottom,
        ratio,
        lasting,
        split,
        crowded,
    )


def _chosen(
    found: Decay, order: int, count: int
) -> tuple[tuple[DecayMode, ...], tuple[DecayMode, ...], DecayMode | None]:
    if not found.in_order or any(mode.sign is None for mode in found.modes):
        raise NotReduced("open")
    if count <= order:
        raise NotReduced("nothing", count)
    lasting = [mode for mode in found.modes if mode.sign != 1]
    taken = sum(mode.count for mode in lasting)
    if taken > order:
        raise NotReduced("lasting", taken)
    kept, rest, split = list(lasting), [mode for mode in found.modes if mode.sign == 1], None
    while rest and taken + rest[0].count <= order:
        taken += rest[0].count
        kept.append(rest.pop(0))
    if rest and taken < order:
        split = rest[0]
        if not kept:
            kept.append(rest.pop(0))
    if not rest:
        raise NotReduced("nothing", count)
    return tuple(kept), tuple(rest), split


def _zeros(
    every: Sequence[sp.Expr], dropped: Sequence[DecayMode], most: int, at: sp.Expr
) -> tuple[list[sp.Expr], list[sp.Expr], bool]:
    """The zeros nearer to 0 (1) than all dropped poles, as far as there is room; the others; if there was none."""
    near = [_square(pole - at) for mode in dropped for pole in mode.poles]
    slow: list[sp.Expr] = []
    for zero in every:
        signs = [sign_of(sp.expand(square - _square(zero - at))) for square in near]
        if None in signs:
            raise NotReduced("open")
        if all(sign == 1 for sign in signs):
            slow.append(zero)
    slow.sort(key=lambda zero: float(sp.N(_square(zero - at))) if not zero.free_symbols else 0.0)
    crowded = len(slow) > most
    while len(slow) > most:
        last = slow.pop()
        if last.has(sp.I):
            slow.pop()
    fast = list(every)
    for zero in slow:
        fast.remove(zero)
    return slow, fast, crowded


def _square(root: sp.Expr) -> sp.Expr:
    """The square of the distance from the origin."""
    real, imaginary = complex_parts(root)
    return sp.expand(real**2 + imaginary**2)


def _product(x: sp.Symbol, roots: Sequence[sp.Expr]) -> sp.Expr:
    """Π(x − r) as real factors."""
    factors: dict[sp.Expr, int] = {}
    for root in roots:
        real, imaginary = complex_parts(root)
        sign = sign_of(imaginary)
        if sign == -1:
            continue
        factor = x - root if sign == 0 else x**2 - 2 * real * x + sp.expand(real**2 + imaginary**2)
        factors[factor] = factors.get(factor, 0) + 1
    return sp.Mul(*(factor**times for factor, times in factors.items()))


def _tidied(value: sp.Expr) -> sp.Expr:
    if value.free_symbols:
        return sp.factor(value)
    found = sp.expand(sp.radsimp(sp.expand(value)))
    return sp.N(sp.re(found), DIGITS) if found.has(sp.Float) else found
