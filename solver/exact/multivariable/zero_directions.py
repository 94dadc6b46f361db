"""Directions that a matrix of polynomials sends to zero at the roots of a polynomial."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.fields import Algebraic, Modulus
from solver.exact.linear_algebra.instances import element_at
from solver.exact.linear_algebra.multiples import cleared
from solver.exact.linear_algebra.row_reduction import null_space, row_reduce
from solver.exact.linear_algebra.spectrum import Root, split_over
from solver.exact.representation.polynomials import Rows, least_common_multiple, roots_of
from solver.exact.representation.transfer import TransferMatrix


@dataclass(frozen=True)
class Directions:
    """A root z and independent columns v with M(z) v = 0, all there are."""

    root: Root
    columns: tuple[sp.ImmutableMatrix, ...]


def null_directions(rows: Sequence[Sequence[sp.Poly]], p: sp.Poly) -> tuple[Directions, ...]:
    """The null space of a matrix of polynomials at each root of p, one computation for conjugate roots.

    Raises NotExact where p has no roots in a usable form.
    """
    found, spectrum, K = [], roots_of(p), rows[0][0].domain
    whole = spectrum.factors if spectrum is not None else ()
    for factor in (each for listed in whole for each in split_over(listed, K)):
        modulus = Modulus(tuple(K.convert(c, factor.modulus.domain) for c in factor.modulus.low), K)
        at_root = tuple(tuple(_at_root(entry, modulus) for entry in row) for row in rows)
        one = Algebraic([modulus.domain.one, *[modulus.domain.zero] * (modulus.degree - 1)], modulus)
        vectors = [cleared(v) for v in null_space(row_reduce(at_root), one)]
        for root in factor.roots:
            columns = (sp.ImmutableMatrix([[element_at(a, root)] for a in v]) for v in vectors)
            found.append(Directions(root, tuple(columns)))
    return tuple(found)


def zero_directions(G: TransferMatrix, rank: int, zeros: sp.Poly, poles: sp.Poly) -> tuple[Directions, ...] | None:
    """Columns u with G(z) u = 0 at each zero z, as many as its multiplicity; None where that makes no sense.

    It makes sense where G (p×m) has normal rank m, no zero is a pole, and no zero has a chain; raises NotExact.
    """
    if rank < G.shape[1] or zeros.degree() == 0 or zeros.gcd(poles).degree() > 0:
        return None
    found = null_directions(over_the_denominator(G), zeros)
    return found if all(len(each.columns) == each.root.multiplicity for each in found) else None


def over_the_denominator(G: TransferMatrix) -> Rows:
    """D(x) G(x), d the least common denominator of the entries in lowest terms."""
    entries = []
    for tops, bottoms in zip(G.tops, G.bottoms, strict=True):
        shared = [top.gcd(bottom).monic() for top, bottom in zip(tops, bottoms, strict=True)]
        entries.append([(t.quo(c), b.quo(c)) for t, b, c in zip(tops, bottoms, shared, strict=True)])
    d = least_common_multiple(bottom for row in entries for _, bottom in row)
    return [[top * d.quo(bottom) for top, bottom in row] for row in entries]


def _at_root(entry: sp.Poly, p: Modulus) -> Algebraic:
    """The polynomial at the root of p, an element of L."""
    return Algebraic(p.reduce(list(reversed(entry.rep.to_list()))), p)
