"""Which modes a plant loses at special values of a parameter, by the test of Popov, Belevitch and Hautus."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.matrices import rank
from solver.tasks.structure.pairs import Pair
from solver.words import Phrase

MOST = 6
"""Of more values the modes are not told one by one."""


@lemma("lost_modes")
def lost_modes_of(pair: Pair, x: Any, values: Iterable[Any]) -> Derivation[None]:
    """For each value of the parameter x, the eigenvalues at which [λI − A, B] (dual: [λI − A; C]) falls in rank."""
    found = [(value, *lost) for value in values for lost in _lost_at(pair, x, value)]
    if found and len(found) <= MOST:
        yield Step(
            "lost",
            claims={
                f"rank{i}": Claim(rank(pair.turned(test)), r, Phrase("rank at a mode that is lost"))
                for i, (_, _, test, r) in enumerate(found, 1)
            },
            detail="full",
            found=[(value, mode) for value, mode, _, _ in found],
            x=x,
            n=pair.n,
            dual=pair.dual,
        )


def _lost_at(pair: Pair, x: Any, value: Any) -> Iterable[tuple[Any, Any, int]]:
    """Each mode lost at a value, the matrix of the test there and its rank; none where no exact form is at hand."""
    F, G = (sp.ImmutableMatrix(M.xreplace({x: value}).applyfunc(sp.expand)) for M in (pair.F, pair.G))
    if any(M.has(sp.Float, sp.zoo, sp.nan) for M in (F, G)):
        return
    try:
        hidden = exact.hidden_part(F, G)
        modes = dict.fromkeys(hidden.spectrum.eigenvalues) if hidden else {}
    except exact.NotExact:
        return
    for mode in modes:
        if not mode.has(sp.Float):
            test = sp.ImmutableMatrix(sp.Matrix.hstack(mode * sp.eye(pair.n) - F, G))
            yield mode, test, int(exact.rank(test))
