"""Modes of transfer matrices."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.postconditions.linear_algebra import root_claim
from solver.stated.algebra import power, product, total
from solver.stated.matrices import rank


def of_modes(found: Sequence[Any], G: Any) -> Iterator[Claim | Check]:
    """G = D + Σ R_j/(x − λ)ʲ; the rank of the first residue of each pole, and how often the pole counts."""
    x = G.variable
    terms = [
        product(power(x - mode.root.value, -j), R)
        for mode in found
        for j, R in enumerate(mode.residues, 1)
        if not R.is_zero_matrix
    ]
    yield Claim(total(G.direct, *terms), G.matrix)
    for mode in found:
        yield root_claim(mode.root)
        yield Claim(rank(mode.residues[0]), sp.Integer(mode.rank))
        yield Claim(sp.Integer(len(mode.residues)), sp.Integer(mode.multiplicity))
        simple = all(R.is_zero_matrix for R in mode.residues[1:])
        yield Check.that("a simple pole", "compared", simple == mode.simple)


def of_companion_orders(found: tuple[int, int], G: Any) -> Iterator[Claim]:
    """The degrees of the least common denominators, of the columns and of the rows."""
    for order, lines in zip(found, (list(zip(*G.denominators, strict=True)), G.denominators), strict=True):
        degrees = [sp.degree(sp.lcm_list(list(line)), G.variable) for line in lines]
        yield Claim(total(*degrees), sp.Integer(order))


def of_is_upper(found: bool, mode: Any) -> Iterator[Check]:
    """The root is listed before its conjugate."""
    roots = [root.value for root in mode.factor.roots]
    own, other = mode.root.value, sp.expand(2 * mode.root.sigma - mode.root.value)
    conjugate = next((i for i, value in enumerate(roots) if sp.expand(value - other) == 0), len(roots))
    yield Check.that("the first root of a pair", "compared", (roots.index(own) <= conjugate) == found)


def of_matrix_of(found: Any, expressions: Sequence[Any], jets: Sequence[Any]) -> Iterator[Claim]:
    """The coefficients of the jets: the derivatives by them."""
    if found.rows and found.cols:
        slopes = [[sp.diff(expression, jet) for jet in jets] for expression in expressions]
        yield Claim(sp.ImmutableMatrix(slopes), found)
