"""A rational image as a product of strictly proper ones that a table has, for convolution."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from solver.exact.transforms.images import RationalImage


def factors_for_convolution(image: RationalImage, s: sp.Symbol) -> tuple[sp.Expr, ...]:
    """F as F₁ F₂ … with one irreducible factor below each, as far as the numerator allows; empty where there is one.

    A power of s − p stays together, as a table has it, where there is another factor beside it.
    """
    if image.proper is None or image.direct:
        return ()
    listed: list[tuple[sp.Expr, int]] = []
    for factor in image.proper.factors:
        p, m = factor.polynomial(s), factor.multiplicity
        listed += [(p, m)] if factor.degree == 1 else [(p, 1)] * m
    if len(listed) == 1 and listed[0][1] > 1:
        p, m = listed[0]
        listed = [(p, 1), (p, m - 1)]
    over = sp.factor(image.numerator)
    first = _with_numerator(listed, sp.degree(image.numerator, s), s)
    if first is None or len(first) == len(listed):
        return ()
    above = over / sp.Mul(*(listed[i][0] ** listed[i][1] for i in first))
    return (above, *(1 / p**m for i, (p, m) in enumerate(listed) if i not in first))


def _with_numerator(listed: Sequence[tuple[sp.Expr, int]], degree: int, s: sp.Symbol) -> list[int] | None:
    """The fewest factors whose degree is above that of the numerator: the numerator stands over them."""
    sizes = [(sp.degree(p, s) * m, i) for i, (p, m) in enumerate(listed)]
    enough = [i for size, i in sorted(sizes) if size > degree]
    if enough:
        return [enough[0]]
    taken: list[int] = []
    total = 0
    for size, i in sorted(sizes, reverse=True):
        taken.append(i)
        total += size
        if total > degree:
            return taken
    return None
