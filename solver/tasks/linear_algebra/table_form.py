"""Lemma: partial fractions as multiples of what a table of transforms has, numerators over quadratics split."""

from __future__ import annotations

from functools import reduce
from typing import TYPE_CHECKING, Any

from solver.arithmetic.transformed import term_by_term
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.matrices import entry_alone
from solver.stated.algebra import difference, product, total

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sympy import Expr, ImmutableMatrix, Symbol


@lemma("table_form")
def table_form_of(
    image: exact.RationalMatrix,
    terms: Sequence[Any],
    x: Symbol,
    time: Symbol,
    value: ImmutableMatrix,
    *,
    discrete: bool,
) -> Derivation[None]:
    """The fractions `terms` (1×1) written with (x − σ)/p and ω/p, where there is a numerator over a quadratic p."""
    found = exact.transformed_fractions(image, x, time, discrete=discrete)
    images = {function: left for left, function in exact.pairs_for(image, x, time, discrete=discrete)}
    functions = [(function, entry_alone(C)) for each in found for function, C in each.functions]
    shown = [(c, images[function]) for function, c in functions if c != 0 and function in images]
    if all(each.fraction.slope is None for each in found) or len(shown) != sum(c != 0 for _, c in functions):
        return
    whole = reduce(_with_term, shown[1:], product(*shown[0]))
    claims = {"form": Claim(total(*terms), whole, "multiples of what the table has")}
    steps = term_by_term(image, x, time, value, discrete=discrete)
    yield Step(
        "table_form", claims=claims, steps=steps, several=sum(each.fraction.slope is not None for each in found) > 1
    )


def _with_term(before: Any, term: tuple[Expr, Expr]) -> Any:
    """A sum with one term more, or less its opposite."""
    c, image = term
    if c.could_extract_minus_sign():
        return difference(before, product(-c, image) if c != -1 else image)
    return total(before, product(c, image) if c != 1 else image)
