"""Lemma: the Routh array of det(sI − A), row by row, with both special cases."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, quotient, total
from solver.stated.calculus import derivative, value_at
from solver.stated.matrices import partitioned
from solver.tasks.linear_algebra.characteristic_polynomial import determinant_of
from solver.words import Phrase

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sympy import Expr, ImmutableMatrix, Symbol


@dataclass(frozen=True, slots=True)
class Tabled:
    """The array of χ (discrete: of its image in w, after `ones` roots at z = 1 were divided out)."""

    array: exact.RouthArray
    ones: int
    variable: Symbol


@lemma("routh_array")
def routh_array_of(A: ImmutableMatrix, *, discrete: bool) -> Derivation[Tabled]:
    """Write down χ, in discrete time its bilinear image, and its array."""
    resolvent = yield from determinant_of(A, sp.Symbol("z" if discrete else "s"), for_its="coefficients")
    coefficients, ones, x = resolvent.coefficients, 0, sp.Symbol("s")
    if discrete:
        x = sp.Symbol("w")
        coefficients, ones = yield from bilinear_image_of(coefficients, x)
    array = yield from rows_of(exact.routh(coefficients), x)
    return Tabled(array, ones, x)


@lemma("routh_array")
def rows_of(array: exact.RouthArray, x: Symbol) -> Derivation[exact.RouthArray]:
    """The array row by row, and as a whole."""
    yield from _rows(array, x)
    width = array.matrix.cols
    powers = sp.ImmutableMatrix([_written_power(x, row.power) for row in array.rows])
    whole = sp.ImmutableMatrix(sp.Matrix.hstack(sp.Matrix(powers), sp.Matrix(array.matrix)))
    yield Step(
        "array",
        unclaimed="the entries are checked row by row",
        table=partitioned(whole, (), (1,)),
        x=x,
        width=width,
        special=[row.special for row in array.rows if row.special],
        epsilon=array.epsilon,
    )
    return array


@lemma("routh_array")
def bilinear_image_of(listed: Sequence[Expr], w: Symbol) -> Derivation[tuple[tuple[Expr, ...], int]]:
    """(w − 1)ⁿ χ((w + 1)/(w − 1)); roots at z = 1, which w = ∞ stands for, are divided out first."""
    z = sp.Symbol("z")
    chi = _polynomial(listed, z)
    left, ones = exact.off_the_point_one(listed)
    rest = _polynomial(left, z)
    if ones:
        split = Claim(chi, product(power(z - 1, ones), rest), "the factor of the roots at one")
        yield Step("point_one", claims={"split": split}, ones=ones, rest=rest)
    n, image = len(left) - 1, exact.bilinear(left)
    stated = product((w - 1) ** n, value_at(rest, z, (w + 1) / (w - 1)))
    p = by_falling_powers(image, w)
    yield Step("bilinear", claims={"image": Claim(stated, p, "the bilinear image")}, n=n, p=p, chi=rest)
    return image, ones


def _written_power(x: Symbol, exponent: int) -> Expr:
    """xᵏ as rows are labelled, x¹ and x⁰ too."""
    return sp.Pow(x, exponent, evaluate=False)


def by_falling_powers(listed: Sequence[Expr], x: Symbol) -> Any:
    """The polynomial as it is written by the powers of x, where parameters in its coefficients would mix them up."""
    if not any(c.free_symbols for c in listed):
        return _polynomial(listed, x)
    n = len(listed) - 1
    terms = [
        c if i == n else x ** (n - i) if c == 1 else product(c, x ** (n - i)) for i, c in enumerate(listed) if c != 0
    ]
    return total(*terms)


def _polynomial(listed: Sequence[Expr], x: Symbol) -> Expr:
    n = len(listed) - 1
    return sp.Add(*(c * x ** (n - i) for i, c in enumerate(listed)))


@lemma("routh_array")
def _rows(array: exact.RouthArray, x: Symbol) -> Derivation[None]:
    """The rows from the third on by their determinants; the special cases where they occur."""
    rows = array.rows
    p, first = by_falling_powers(array.coefficients, x), [(_written_power(x, r.power), [*r.computed]) for r in rows[:2]]
    yield Step("first_rows", unclaimed="the coefficients, written alternately", p=p, x=x, first=first)
    for i, row in enumerate(rows):
        if i > 1:
            claims = _entries(rows[i - 2].entries, rows[i - 1].entries, row.computed)
            yield Step("row", detail="tutor", claims=claims, power=_written_power(x, row.power), entries=row.computed)
        if row.special == "pivot":
            yield Step("zero_pivot", detail="full", unclaimed="ε takes the place of zero by definition", row=row,
                       power=_written_power(x, row.power), epsilon=array.epsilon,
                       vanishes=_where_all_zero(row.computed))  # fmt: skip
        elif row.special == "zeros":
            yield _auxiliary(row, x)


def _entries(above: Sequence[Expr], row: Sequence[Expr], computed: Sequence[Expr]) -> dict[str, Claim]:
    """(r₁ a_{j+1} − a₁ r_{j+1})/r₁; what is beyond a row's end is zero."""
    claims: dict[str, Claim] = {}
    for j, entry in enumerate(computed, 1):
        a, r = (each[j] if j < len(each) else sp.Integer(0) for each in (above, row))
        stated: Any = quotient(difference(product(row[0], a), product(above[0], r)), row[0])
        claims[f"entry{j}"] = Claim(stated, entry, Phrase("entry {j} of the row", j=j))
    return claims


def _where_all_zero(row: Sequence[Expr]) -> list[tuple[Expr, Expr]]:
    """The equations that say of a row with parameters that it is all zero, each by its sides; none if it never is."""
    entries = [entry for entry in row if entry != 0]
    if any(entry.is_nonzero or not entry.free_symbols for entry in entries):
        return []
    return [_solved(entry) for entry in entries]


def _solved(entry: Expr) -> tuple[Expr, Expr]:
    """The sides of x = value, where the entry is linear in its only parameter, else of entry = 0."""
    symbols: list[Any] = sorted(entry.free_symbols, key=str)
    x, *others = symbols
    p = entry.as_poly(x)
    if others or p is None or p.degree() != 1:
        return entry, sp.S.Zero
    return x, -p.nth(0) / p.nth(1)


def _auxiliary(row: exact.RouthRow, x: Symbol) -> Step:
    """The derivative of the auxiliary polynomial in place of a row of zeros."""
    order = row.power + 1
    p = sp.Add(*(c * x ** (order - 2 * i) for i, c in enumerate(row.auxiliary)))
    found = sp.Add(*(c * x ** (row.power - 2 * i) for i, c in enumerate(row.entries)))
    return Step(
        "zero_row",
        claims={"derivative": Claim(derivative(p, x), found, "the derivative of the auxiliary polynomial")},
        power=_written_power(x, row.power),
        above=_written_power(x, order),
        auxiliary=p,
        x=x,
    )
