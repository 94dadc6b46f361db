"""Lemma: linear equations solved in turn, as a person does; see `solver.exact.modelling.turns`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, lemma
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.lazy import exact

Side = tuple["Expr", "Expr"]


@lemma("elimination")
def elimination_of(solved: exact.Solved, equations: Sequence[Side]) -> Derivation[None]:
    """Tell what was found in each turn. What an equation says as it stands is not told again."""
    rows: list[tuple[Symbol, Expr, Expr]] = []
    claims: dict[str, Claim] = {}
    for turn in solved.turns:
        if turn.stated is None:
            if claims:
                yield Step("turns", claims=claims, rows=rows)
                rows, claims = [], {}
            yield _kept(turn, solved.values)
            continue
        ((x,), (value,)) = turn.symbols, turn.values
        if turn.stated == value and equations[turn.equation][0] == x:
            continue
        rows.append((x, turn.stated, value))
        claims[str(x)] = Claim(turn.stated.xreplace(solved.values), value, Phrase("the value of {name}", name=str(x)))
    if claims:
        yield Step("turns", claims=claims, rows=rows)


def _kept(turn: exact.Turn, values: Mapping[Symbol, Expr]) -> Step:
    """Unknowns that are kept until equations hold nothing else."""
    claims = {
        f"closing{i}": Claim(left.xreplace(values), right.xreplace(values), "what is left when all is put in")
        for i, left, right in turn.closing
    }
    found = list(zip(turn.symbols, turn.values, strict=True))
    closing = [(left, right) for _, left, right in turn.closing]
    return Step("kept", claims=claims, symbols=turn.symbols, through=turn.through, found=found, closing=closing)
