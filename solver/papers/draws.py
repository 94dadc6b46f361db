"""What is drawn: the choices of values of a family in an order that belongs to the seed, none twice."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from solver.conditions import symbols_of
from solver.papers.constructions import Construction
from solver.papers.generator import Permutation
from solver.problem.family import Family, Required

Values = Mapping[str, sp.Expr]


@dataclass(frozen=True, slots=True)
class Draw:
    """The values drawn for the names of a family, and how they are written."""

    values: Values
    texts: Mapping[str, str]

    @property
    def told(self) -> str:
        """The values in words: a = 2, b = −3."""
        return ", ".join(f"{name} = {text}" for name, text in self.texts.items())


class Draws:
    """All choices of values; number 0 is the first that is drawn.

    Where there are constructions, every other draw is made by one of them in turn (see `constructions`), as long as
    choices are left; then they have no number of their own, and the family is through when all choices were drawn.
    """

    def __init__(self, family: Family, seed: int, constructions: Sequence[Construction] = ()) -> None:
        self.family = family
        self.order = Permutation(family.size, seed)
        self.constructions = constructions

    @property
    def count(self) -> int:
        """So many draws there are."""
        return self.family.size * (2 if self.constructions else 1)

    def places(self, number: int) -> list[int]:
        """Return which of its values each name has in a draw: the digits of its number, the first name the slowest."""
        if self.constructions:
            number, turn = divmod(number, 2)
            if turn == 0 and (places := self._constructed(number)) is not None:
                return places
        rest, found = self.order.at(number), list[int]()
        for each in reversed(self.family.varied):
            rest, place = divmod(rest, len(each.values))
            found.append(place)
        return found[::-1]

    def _constructed(self, number: int) -> list[int] | None:
        number, turn = divmod(number, len(self.constructions))
        return self.constructions[turn].at(number)

    def at(self, places: list[int]) -> Draw:
        """Return the draw of these places."""
        chosen = list(zip(self.family.varied, places, strict=True))
        return Draw(
            {each.name: each.values[place] for each, place in chosen},
            {each.name: each.texts[place] for each, place in chosen},
        )


def holds(required: Required, values: Values) -> bool:
    """Whether a condition holds of values that are drawn; those about the system hold here."""
    if required.chain is None:
        return True
    put_in = {x: values[x.name] for x in symbols_of(*required.chain.sides)}
    sides = [side.xreplace(put_in) for side in required.chain.sides]
    return all(
        _compared(left - right, sign)
        for left, right, sign in zip(sides[:-1], sides[1:], required.chain.signs, strict=True)
    )


def _compared(difference: sp.Expr, sign: str) -> bool:
    """Whether left < right (and so on) where left − right is the difference; False where that is no real number."""
    if difference.has(sp.zoo, sp.nan, sp.oo):
        return False
    value = difference if difference.is_Rational else sp.N(difference, 40, chop=True)
    if sign in {"!=", "="}:
        return bool(value != 0) is (sign == "!=")
    if not value.is_real:
        return False
    return bool({"<": value < 0, "<=": value <= 0, ">": value > 0, ">=": value >= 0}[sign])
