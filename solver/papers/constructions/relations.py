"""What an answer and the values that are drawn have to do with each other, as equations.

An instance says which equations hold (of a gain and its Riccati equation, of a gain and its poles), which numbers of
the answer are chosen first, and which ones follow. `linear` finds for which of the names the equations are linear:
these are solved for when all others have their values.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, fields
from fractions import Fraction

import sympy as sp

Name = str
Matrix = tuple[tuple[Name, ...], ...]
"""A matrix of names."""

Power = tuple[Name, int]
Terms = tuple[tuple[Fraction, tuple[Power, ...]], ...]
"""A polynomial: factors, and the powers of names that they multiply."""


@dataclass(frozen=True, slots=True)
class Loop:
    """How the coefficients of det(sI − A + BK) belong to K: K is chosen so that all poles of the loop are stable.

    `equations` are linear in `numbers`, those of K; `coefficients` are from the constant one on, without the leading 1.
    With `whole` the poles are whole numbers.
    """

    equations: tuple[sp.Expr, ...]
    numbers: tuple[Name, ...]
    coefficients: tuple[Name, ...]
    whole: bool = False


@dataclass(frozen=True, slots=True)
class Relations:
    """Equations of letters that are drawn and of an answer: each expression is zero.

    `chosen` has the numbers of the answer that are chosen first, with what they must be (as in `nice`, or "" for
    whole numbers that are not asked for), `unknown` those that follow; matrices in `definite` must be positive
    definite, those in `semidefinite` not negative. Each group of `letters` has names that are drawn, in the order in
    which they are solved for, and how many of them may be; None means all.
    """

    equations: tuple[sp.Expr, ...]
    chosen: tuple[tuple[Name, str], ...] = ()
    unknown: tuple[tuple[Name, str], ...] = ()
    definite: tuple[Matrix, ...] = ()
    semidefinite: tuple[Matrix, ...] = ()
    letters: tuple[tuple[tuple[Name, ...], int | None], ...] = ()
    loops: tuple[Loop, ...] = ()

    def __add__(self, other: Relations) -> Relations:
        """Return what holds where both hold."""
        return Relations(*(getattr(self, each.name) + getattr(other, each.name) for each in fields(self)))


@dataclass(frozen=True, slots=True)
class Linear:
    """Equations Σⱼ rows[i][j] · solved[j] + rests[i] = 0, with polynomials in `given` for coefficients."""

    solved: tuple[Name, ...]
    given: tuple[Name, ...]
    rows: tuple[tuple[Terms, ...], ...]
    rests: tuple[Terms, ...]

    @property
    def in_rows(self) -> set[Name]:
        """The names on which the coefficients depend."""
        return {name for row in self.rows for terms in row for _, powers in terms for name, _ in powers}


def linear(relations: Relations) -> Linear | None:
    """Return the relations as equations linear in letters and all that is unknown; None where they are not.

    As many letters are solved for as can be, in their order; numbers of the answer are too where letters are too few.
    """
    polynomials = [_polynomial(each) for each in relations.equations]
    if not all(polynomials):
        return None
    found = [poly for poly in polynomials if poly is not None]
    unknown = [name for name, _ in relations.unknown]
    if not _linear_in(found, unknown):
        return None
    wanted = len(found) - len(unknown)
    letters: list[Name] = []
    for names, most in relations.letters:
        letters += _grown(found, [*letters, *unknown], names, most)
    numbers = [name for name, _ in relations.chosen]
    others = _grown(found, [*letters, *unknown], numbers, max(0, wanted - len(letters))) if letters else []
    return _collected(found, (*letters, *others, *unknown)) if letters else None


def linear_loop(loop: Loop) -> Linear | None:
    """Return the equations of a loop, linear in the gain; None where they are not."""
    polynomials = [poly for each in loop.equations if (poly := _polynomial(each)) is not None]
    if len(polynomials) < len(loop.equations) or not _linear_in(polynomials, loop.numbers):
        return None
    return _collected(polynomials, loop.numbers)


def _polynomial(expression: sp.Expr) -> sp.Poly | None:
    """Return an expression without its denominator as a polynomial over the rational numbers, None if it is none."""
    numerator = sp.fraction(sp.together(expression))[0]
    names = {x: sp.Symbol(x.name) for x in numerator.free_symbols}
    plain = numerator.xreplace(names)
    if not names or not plain.is_polynomial(*names.values()):
        return None
    found = sp.Poly(plain, *sorted(names.values(), key=str))
    return found if found.domain in {sp.ZZ, sp.QQ} else None


def _linear_in(polynomials: Iterable[sp.Poly], names: Collection[Name]) -> bool:
    """Whether no term has two of the names, or one of them twice."""
    for poly in polynomials:
        columns = [place for place, x in enumerate(poly.gens) if str(x) in names]
        if any(sum(powers[place] for place in columns) > 1 for powers in poly.monoms()):
            return False
    return True


def _grown(
    polynomials: Sequence[sp.Poly], first: Sequence[Name], others: Iterable[Name], most: int | None
) -> list[Name]:
    """Return those of some names in which, with the first ones, the polynomials are linear, `most` of them."""
    occurring = {str(x) for poly in polynomials for x in poly.gens}
    found: list[Name] = []
    for name in others:
        if most is not None and len(found) >= most:
            break
        if name in occurring and _linear_in(polynomials, {*first, *found, name}):
            found.append(name)
    return found


def _collected(polynomials: Sequence[sp.Poly], solved: tuple[Name, ...]) -> Linear:
    """Return the coefficients of names in which polynomials are linear."""
    rows, rests, given = [], [], set[Name]()
    for poly in polynomials:
        terms: dict[Name, list[tuple[Fraction, tuple[Power, ...]]]] = {}
        for powers, factor in poly.terms():
            inside = [(str(x), power) for x, power in zip(poly.gens, powers, strict=True) if power]
            column = next((name for name, _ in inside if name in solved), "")
            others = tuple((name, power) for name, power in inside if name != column)
            given |= {name for name, _ in others}
            terms.setdefault(column, []).append((Fraction(int(factor.p), int(factor.q)), others))
        rows.append(tuple(tuple(terms.get(name, ())) for name in solved))
        rests.append(tuple(terms.get("", ())))
    return Linear(solved, tuple(sorted(given)), tuple(rows), tuple(rests))
