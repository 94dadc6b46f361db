"""Directions that a matrix of fractions sends to zero at the roots of a polynomial."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.fields import Algebraic, Modulus
from solver.exact.linear_algebra.instances import element_at
from solver.exact.linear_algebra.multiples import cleared
from solver.exact.linear_algebra.row_reduction import null_space, row_reduce
from solver.exact.linear_algebra.spectrum import Root, split_over
from solver.exact.multivariable.rational_minors import in_lowest
from solver.exact.representation.polynomials import roots_of
from solver.exact.representation.transfer import TransferMatrix

Grid = Sequence[Sequence[sp.Poly]]


@dataclass(frozen=True)
class Directions:
    """A root z, M(z), and independent columns v with M(z) v = 0, all there are."""

    root: Root
    value: sp.ImmutableMatrix
    columns: tuple[sp.ImmutableMatrix, ...]


def null_directions(tops: Grid, bottoms: Grid, p: sp.Poly) -> tuple[Directions, ...]:
    """The null space of a matrix of fractions at each root of p, one computation for conjugate roots.

    No root of p is one of a denominator. Raises NotExact where p has no roots in a usable form.
    """
    found, spectrum, K = [], roots_of(p), tops[0][0].domain
    whole = spectrum.factors if spectrum is not None else ()
    for factor in (each for listed in whole for each in split_over(listed, K)):
        modulus = Modulus(tuple(K.convert(c, factor.modulus.domain) for c in factor.modulus.low), K)
        at_root = tuple(
            tuple(_at_root(top, modulus) / _at_root(bottom, modulus) for top, bottom in zip(*row, strict=True))
            for row in zip(tops, bottoms, strict=True)
        )
        one = Algebraic([modulus.domain.one, *[modulus.domain.zero] * (modulus.degree - 1)], modulus)
        vectors = [cleared(v) for v in null_space(row_reduce(at_root), one)]
        for root in factor.roots:
            value = sp.ImmutableMatrix([[element_at(a, root) for a in row] for row in at_root])
            columns = (sp.ImmutableMatrix([[element_at(a, root)] for a in v]) for v in vectors)
            found.append(Directions(root, value, tuple(columns)))
    return tuple(found)


def zero_directions(G: TransferMatrix, rank: int, zeros: sp.Poly, poles: sp.Poly) -> tuple[Directions, ...] | None:
    """Columns u with G(z) u = 0 at each zero z, as many as its multiplicity; None where that makes no sense.

    It makes sense where G (p×m) has normal rank m, no zero is a pole, and no zero has a chain; raises NotExact.
    """
    if rank < G.shape[1] or zeros.degree() == 0 or zeros.gcd(poles).degree() > 0:
        return None
    entries = [[in_lowest(*pair) for pair in zip(*row, strict=True)] for row in zip(G.tops, G.bottoms, strict=True)]
    tops, bottoms = ([[pair[k] for pair in row] for row in entries] for k in (0, 1))
    found = null_directions(tops, bottoms, zeros)
    return found if all(len(each.columns) == each.root.multiplicity for each in found) else None


def _at_root(entry: sp.Poly, p: Modulus) -> Algebraic:
    """The polynomial at the root of p, an element of L."""
    return Algebraic(p.reduce(list(reversed(entry.rep.to_list()))), p)
