"""Linear equations solved by elimination: an unknown from one equation, put into the others, and back."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated import Stated
from solver.stated.algebra import difference, product, total
from solver.stated.calculus import value_at
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Symbol


@where_exact
def eliminated(
    equations: Sequence[tuple[Expr, Expr]],
    unknowns: Sequence[Symbol],
    values: Sequence[Expr],
    chosen: Sequence[int] = (),
) -> tuple[Step, ...]:
    """Solve equations, each by its sides, for the unknowns, whose values are known; one with itself as value is free.

    `chosen` are positions of unknowns that the equations leave free, with values all the same. Nothing where each
    equation has one unknown only.
    """
    free = [j for j, (unknown, value) in enumerate(zip(unknowns, values, strict=True)) if unknown == value]
    found = exact.elimination(equations, unknowns, [*free, *chosen])
    if not any(each.changed for each in found):
        return ()
    return tuple(_eliminated(_Elimination(equations, unknowns, values, found)))


@where_exact
def system_solved(
    equations: Sequence[tuple[Expr, Expr]], unknowns: Sequence[Symbol], values: Sequence[Expr]
) -> tuple[Step, ...]:
    """The equations of a matrix equation that the step states, entry by entry, and their elimination."""
    return (*_system(equations, unknowns, values), *eliminated(equations, unknowns, values))


@dataclass(frozen=True)
class PutIn:
    """An equation with an unknown's value put in, and what it is then."""

    number: int
    left: Stated
    right: Expr
    left_after: Expr
    right_after: Expr


@dataclass(frozen=True)
class Given:
    """What an equation gives for an unknown, where a divisor is not zero, and the equations it is put into."""

    number: int
    unknown: Symbol
    value: Expr
    divisors: Sequence[Expr]
    others: Sequence[PutIn]


@dataclass(frozen=True)
class _Elimination:
    equations: Sequence[tuple[Expr, Expr]]
    unknowns: Sequence[Symbol]
    values: Sequence[Expr]
    found: Sequence[exact.Substitution]

    def steps(self) -> Iterator[tuple[Given, Claim]]:
        """Each unknown as it is given, with the claim that it solves its equation."""
        known = {number: self._sides(number) for number in range(1, len(self.equations) + 1)}
        for each in self.found:
            number, unknown, value = each.equation.number, self.unknowns[each.unknown], self._value(each)
            left, right, _ = sides = known[number]
            solves = Claim(value_at(difference(left, right), unknown, value), sp.S.Zero, "an equation solved for one")
            others = []
            for before, after in each.changed:
                left, right, constant = known[before.number]
                put_in = _sum(before.coefficients, self._with(each.unknown, value), constant)
                known[before.number] = after_left, after_right, _ = self._linear(after), after.right, sp.S.Zero
                others.append(PutIn(before.number, put_in, right, after_left, after_right))
            if sides[:2] == (unknown, value) and not others:
                continue  # it reads so already
            divisors = exact.vanishing_factors(each.equation.coefficients[each.unknown])
            yield Given(number, unknown, value, divisors, others), solves

    def back(self) -> Iterator[tuple[Symbol, Stated, Expr]]:
        """The unknowns that others give, from the last to the first: with the values put in, and their own value."""
        for each in reversed(self.found):
            if any(share != 0 and self.values[j] != self.unknowns[j] for j, share in enumerate(each.shares)):
                yield (
                    self.unknowns[each.unknown],
                    _sum(each.shares, self.values, each.constant),
                    self.values[each.unknown],
                )

    def _sides(self, number: int) -> tuple[Expr, Expr, Expr]:
        """The sides of an equation as it was given, and the constant on the left one; unknowns stand on the left."""
        left, right = self.equations[number - 1]
        if right.has(*self.unknowns):
            left, right = left - right, sp.S.Zero
        return left, right, exact.affine([left], self.unknowns)[1][0]

    def _value(self, found: exact.Substitution) -> Expr:
        pairs = zip(found.shares, self.unknowns, strict=True)
        return sp.Add(found.constant, *(share * unknown for share, unknown in pairs))

    def _linear(self, equation: exact.LinearEquation) -> Expr:
        return sp.Add(*(c * unknown for c, unknown in zip(equation.coefficients, self.unknowns, strict=True)))

    def _with(self, position: int, value: Expr) -> list[Expr]:
        return [value if j == position else unknown for j, unknown in enumerate(self.unknowns)]


@lemma("arithmetic/equations")
def _system(
    equations: Sequence[tuple[Expr, Expr]], unknowns: Sequence[Symbol], values: Sequence[Expr]
) -> Derivation[None]:
    claims = {}
    for i, (left, right) in enumerate(equations):
        there = difference(left, right)
        for unknown, value in zip(unknowns, values, strict=True):
            there = value_at(there, unknown, value)
        claims[f"equation{i}"] = Claim(there, sp.S.Zero, "an equation with the values put in")
    found = list(zip(unknowns, values, strict=True))
    yield Step("system", detail="tutor", claims=claims, equations=list(equations), found=found)


@lemma("arithmetic/equations")
def _eliminated(elimination: _Elimination) -> Derivation[None]:
    claims, givens, back = {}, [], list(elimination.back())
    for given, solves in elimination.steps():
        givens.append(given)
        claims[f"given{given.number}"] = solves
        for each in given.others:
            sides = difference(each.left, each.right), each.left_after - each.right_after
            claims[f"put{given.number}_{each.number}"] = Claim(
                *sides, Phrase("an unknown put into equation ({i})", i=each.number)
            )
    for i, (_, stated, value) in enumerate(back):
        claims[f"back{i}"] = Claim(stated, value, Phrase("values put in"))
    pairs = zip(elimination.unknowns, elimination.values, strict=True)
    found = [(unknown, value) for unknown, value in pairs if unknown != value]
    yield Step("elimination", detail="tutor", claims=claims, givens=givens, back=back, found=found)


def _sum(coefficients: Sequence[Expr], values: Sequence[Any], constant: Expr) -> Stated:
    """Σ cⱼ vⱼ + constant without zeros; the constant first where the first coefficient is negative and it is not."""
    pairs = [(c, value) for c, value in zip(coefficients, values, strict=True) if c != 0 and value != 0]
    terms = [product(c, value) for c, value in pairs]
    first = next((c for c, _ in pairs), sp.S.One)
    leads = first.could_extract_minus_sign() and not constant.could_extract_minus_sign()
    return total(constant, *terms) if leads else total(*terms, constant)
