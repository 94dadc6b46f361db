"""Where parameters cost the rank: several at once, by conditions on them; one in sines and cosines, by families."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from math import comb
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.calculus import value_at
from solver.stated.matrices import determinant
from solver.tasks.structure.pairs import Pair
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

MOST = 6
"""So many minors are written out."""


@lemma("critical_parameters")
def conditions_of(pair: Pair, matrix: ImmutableMatrix, wanted: Sequence[Any]) -> Derivation[Answers]:
    """The conditions under each of which all minors vanish; those on other parameters alone are said beside them."""
    yield _minors_step(pair, matrix)
    found = exact.rank_conditions(pair.turned(matrix))
    values = [each for each in found if each.free_symbols.intersection(wanted)]
    yield Step(
        "conditions",
        unclaimed="the conditions are checked with the answer",
        found=values,
        others=[each for each in found if each not in values],
        general=[symbol for symbol in pair.parameters if symbol not in wanted],
        dual=pair.dual,
        n=pair.n,
    )
    return Answers(values=values)


@lemma("critical_parameters")
def angles_of(pair: Pair, matrix: ImmutableMatrix, x: Any) -> Derivation[Answers]:
    """The angles of one turn at which all minors vanish, and what they mean for the parameter."""
    yield _minors_step(pair, matrix)
    found = exact.critical_angles(pair.turned(matrix), x)
    det = exact.vanishing_form(exact.determinant(matrix)) if matrix.rows == matrix.cols else None
    claims = (
        {}
        if det is None
        else {
            f"zero{i}": Claim(value_at(det, x, value), sp.Integer(0), "the value put into the determinant")
            for i, value in enumerate(found.values, 1)
        }
    )
    yield Step("angles", claims=claims, unclaimed="the values are checked with the answer", x=x, found=found,
               alone=found.angle == x, dual=pair.dual, n=pair.n)  # fmt: skip
    return Answers(values=list(found.values))


def _minors_step(pair: Pair, matrix: ImmutableMatrix) -> Step:
    """The determinant of a square matrix; else the minors, where they are few."""
    whole = pair.turned(matrix)
    if whole.rows == whole.cols:
        det = exact.determinant(matrix)
        claims = {"expanded": Claim(determinant(matrix), sp.expand(det), "determinant")}
        claims["factored"] = Claim(sp.expand(det), exact.vanishing_form(det), "determinant in factors")
        return Step("determinant", claims=claims, dual=pair.dual, n=pair.n)
    claims, chosen = {}, []
    few = comb(whole.cols, whole.rows) <= MOST
    for i, columns in enumerate(combinations(range(whole.cols), whole.rows) if few else (), 1):
        square = pair.turned(sp.ImmutableMatrix(whole[:, list(columns)]))
        value = exact.vanishing_form(exact.determinant(square))
        claims[f"minor{i}"] = Claim(determinant(square), value, Phrase("minor {i}", i=i))
        chosen.append([j + 1 for j in columns])
    unclaimed = "there are too many minors to write out; the conditions are checked one by one"
    return Step("minors", claims=claims, unclaimed=unclaimed, chosen=chosen, dual=pair.dual, n=pair.n)
