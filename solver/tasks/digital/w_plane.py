"""Lemma: a polynomial in z asked by the Routh array of its image in w, z = (1 + w)/(1 − w)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import power, product, total
from solver.stated.calculus import value_at
from solver.tasks.stability.criterion import polynomial_of, symmetric_roots
from solver.tasks.stability.routh_array import by_falling_powers, rows_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sympy import Expr, Symbol


@dataclass(frozen=True, slots=True)
class InW:
    """The array of the image, None where p(z) is a power of z + 1; how often −1 is a root; what the array counts."""

    array: exact.RouthArray | None
    minus_ones: int
    counts: exact.DiscCounts


@lemma("w_plane")
def by_the_image_in_w(coefficients: Sequence[Expr], z: Symbol) -> Derivation[InW]:
    """The image, its Routh array, and the changes of sign where signs are known."""
    w, counts = sp.Symbol("w"), exact.disc_counts(coefficients)
    p, rest, ones = polynomial_of(coefficients, z), counts.rest, counts.minus_ones
    left = polynomial_of(rest, z)
    if ones:
        claim = Claim(p, product(power(z + 1, ones), left), "the factor of the roots at minus one")
        yield Step("minus_one", claims={"split": claim}, ones=ones, rest=left, constant=len(rest) == 1)
    if len(rest) == 1:
        return InW(None, ones, counts)
    yield _image(rest, counts.image, left, z, w)
    array = yield from rows_of(exact.routh(counts.image), w)
    signs = [exact.sign_of(entry) for entry in array.at_zero]
    if counts.counts is not None:
        changes = exact.sign_changes(signs)
        yield Step(
            "sign_changes",
            unclaimed="counted; the number has a check of its own",
            column=list(zip([row.entries[0] for row in array.rows], signs, strict=True)),
            epsilon=array.epsilon,
            changes=changes,
            trusted=changes == counts.counts.outside,
        )
        yield from symmetric_roots(counts.image, w, counts.counts, name="q")
    return InW(array, ones, counts)


def _image(rest: Sequence[Expr], image: Sequence[Expr], left: Expr, z: Symbol, w: Symbol) -> Step:
    """(1 − w)ⁿ p((1 + w)/(1 − w)), each coefficient with its powers, multiplied out."""
    n, found = len(rest) - 1, by_falling_powers(image, w)
    stated = product(power(1 - w, n), value_at(left, z, (1 + w) / (1 - w)))
    terms = total(*(product(c, (1 + w) ** (n - i), (1 - w) ** i) for i, c in enumerate(rest) if c != 0))
    claims = {
        "terms": Claim(stated, terms, "each power of z replaced"),
        "image": Claim(terms, found, "the image multiplied out"),
    }
    return Step("image", claims=claims, n=n, p=left, z=z, w=w, image=found)
