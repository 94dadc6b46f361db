"""Stabilizability and detectability: whether what is hidden decays by itself."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from solver.derivation import Answers, Check, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.numeric.judges import structure as judges
from solver.tasks.structure.hidden_part import hidden_modes_of
from solver.tasks.structure.pair_checks import modes_check, that
from solver.tasks.structure.pairs import Pair
from solver.tasks.structure.rank_test import rank_of


@lemma("weak_conditions")
def decay_of_hidden_modes(pair: Pair) -> Derivation[Answers]:
    """All hidden modes inside the region of stability, its boundary not included."""
    found = yield from rank_of(pair)
    modes = yield from hidden_modes_of(pair, found.matrix)
    if modes is None:
        raise Unsolved("hidden_modes/parameters")
    hidden = exact.hidden_part(pair.F, pair.G)
    placed = exact.location(hidden.H, discrete=pair.discrete).placed if hidden else ()
    positions = [each.position for each in placed]
    undecided = [each.root.value for each in placed if each.position is None]
    holds = _verdict(positions)
    yield Step(
        "decay",
        unclaimed="the hidden modes are checked above",
        placed=[(each.root.value, each.position, each.measure) for each in placed],
        undecided=undecided,
        holds=holds,
        dual=pair.dual,
        discrete=pair.discrete,
    )
    if holds is None:
        raise Unsolved("hidden_modes/depends_on_parameters", dual=pair.dual)
    return Answers(**{"detectable" if pair.dual else "stabilizable": holds, "hidden_modes": modes})


def _verdict(positions: list[int | None]) -> bool | None:
    """False where a hidden mode does not decay, None where the parameters leave it open."""
    known = [position for position in positions if position is not None]
    if any(position >= 0 for position in known):
        return False
    return True if len(known) == len(positions) else None


def weak_checks(pair: Pair, answers: Answers) -> Iterator[Check]:
    """The polynomial of the hidden part, and where its roots lie."""
    verdict = "detectable" if pair.dual else "stabilizable"
    if verdict in answers:
        holds: Any = answers[verdict]
        yield that(
            "every hidden mode decays" if holds else "a hidden mode does not decay",
            verdict,
            lambda: bool(holds) == judges.hidden_modes_decay(pair.F, pair.G, discrete=pair.discrete),
            "orthonormal basis (50 digits), mpmath.eig",
        )
    if "hidden_modes" in answers:
        yield modes_check(pair, answers["hidden_modes"], "hidden_modes")
