"""Lemma: Jury's table row by row, what its rows must fulfil, and how many roots they count inside the unit circle."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.arithmetic.roots import values_at
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient
from solver.stated.calculus import value_at
from solver.stated.matrices import determinant, matrix_of, partitioned
from solver.tasks.stability.criterion import polynomial_of
from solver.words import Phrase

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from sympy import Expr, Symbol

LETTERS = "abcdefghijklmnopqrstuvw"


@dataclass(frozen=True, slots=True)
class Comparison:
    """The names and values of the two ends of a row of the table, the first of which must be larger in size.

    `relation` is 1, 0 or −1 where the sizes are known to be as they must, equal or the other way round, else None;
    then `sizes` are the absolute values.
    """

    larger: str
    smaller: str
    large: Expr
    small: Expr
    relation: int | None
    sizes: tuple[Expr, Expr] | None


def letter(i: int) -> str:
    """The letter of row i of the table, without those in reverse order."""
    return LETTERS[i] if i < len(LETTERS) else f"r^{{({i})}}"


@lemma("jury_table")
def necessary_conditions(coefficients: Sequence[Expr], z: Symbol) -> Derivation[None]:
    """p(1) > 0, (−1)ⁿ p(−1) > 0 and |a₀| < aₙ, with what is seen of them."""
    found, n = exact.jury_conditions(coefficients), len(coefficients) - 1
    p, sign = polynomial_of(coefficients, z), sp.Integer((-1) ** n)
    at_minus_one = value_at(p, z, sp.Integer(-1))
    claims = {
        "at_one": Claim(value_at(p, z, sp.Integer(1)), found.at_one, "$p(1)$"),
        "at_minus_one": Claim(product(sign, at_minus_one) if n % 2 else at_minus_one, found.at_minus_one, "$p(-1)$"),
    }
    known = [exact.sign_of(each) for each in (found.at_one, found.at_minus_one)]
    lines = values_at(p, z, [sp.S.One, sp.S.NegativeOne])
    yield Step("necessary", claims=claims, steps=lines, p=p, z=z, n=n, odd=n % 2 == 1, known=known,
               ends=comparison(0, coefficients[::-1]))  # fmt: skip


def comparison(i: int, row: Sequence[Expr]) -> Comparison:
    """Compare the ends of row i of the table: of the coefficients the last must be larger, else the first."""
    m, name = len(row) - 1, letter(i)
    (large, small), (k, other) = ((row[m], row[0]), (m, 0)) if i == 0 else ((row[0], row[m]), (0, m))
    relation, sizes = exact.sign_of(sp.expand(large**2 - small**2)), None
    signs = [exact.sign_of(each) for each in (large, small)]
    if relation is not None and None not in signs:
        sizes = (signs[0] * large, signs[1] * small)
    return Comparison(f"{name}_{{{k}}}", f"{name}_{{{other}}}", large, small, relation if sizes else None, sizes)


@lemma("jury_table")
def table_of(coefficients: Sequence[Expr], z: Symbol, *, whole: bool) -> Derivation[exact.JuryTable]:
    """The table, down to rows of three entries, or `whole` to a row of one."""
    table, n = exact.jury_table(coefficients, whole=whole), len(coefficients) - 1
    for i, row in enumerate(table.rows[1:], 1):
        above = table.rows[i - 1].entries
        yield Step("row", detail="tutor", claims=_entries(above, row), letter=letter(i), count=len(row.entries),
                   divisor=row.divisor, divided=letter(i - 2) if row.divisor != 1 else "")  # fmt: skip
    powers = [sp.Pow(z, k, evaluate=False) for k in range(n + 1)]
    shown = sp.ImmutableMatrix(sp.Matrix.vstack(sp.Matrix([powers]), sp.Matrix(table.matrix)))
    divided = [letter(i) for i, row in enumerate(table.rows) if row.divisor != 1]
    yield Step("table", unclaimed="the entries are checked row by row", table=partitioned(shown, (1,), ()), n=n,
               rows=len(table.rows), whole=whole, divided=divided)  # fmt: skip
    return table


def _entries(above: Sequence[Expr], row: exact.JuryRow) -> dict[str, Claim]:
    """The determinants |r₀ r₍ₘ₋ₖ₎; rₘ rₖ| of the row above, and their products, divided where they are."""
    m = len(above) - 1
    claims: dict[str, Claim] = {}
    for k, entry in enumerate(row.entries):
        stated: Any = determinant(matrix_of([[above[0], above[m - k]], [above[m], above[k]]]))
        products: Any = difference(product(above[0], above[k]), product(above[m], above[m - k]))
        if row.divisor != 1:
            stated, products = quotient(stated, row.divisor), quotient(products, row.divisor)
        claims[f"determinant{k}"] = Claim(stated, products, Phrase("the determinant of entry {k}", k=k))
        claims[f"entry{k}"] = Claim(products, entry, Phrase("entry {k} of the row", k=k))
    return claims


@lemma("jury_table")
def comparisons_of(table: exact.JuryTable) -> Derivation[None]:
    """Compare the ends of the rows below the coefficients, down to the one of three entries."""
    rows = [(i, row.entries) for i, row in enumerate(table.rows) if i and len(row.entries) > 2]
    if not rows:
        return
    found = [comparison(i, row) for i, row in rows]
    yield Step("comparisons", unclaimed="compared; the answers have checks of their own", found=found,
               several=len(rows) > 1, undecided=any(each.relation is None for each in found))  # fmt: skip


@lemma("jury_table")
def products_of(table: exact.JuryTable) -> Derivation[int]:
    """The number of roots inside: of negative products of the first entries below the coefficients."""
    firsts = [row.entries[0] for row in table.rows[1:]]
    signs = [exact.sign_of(each) for each in firsts]
    inside = exact.inside_by_jury(table)
    assert inside is not None  # noqa: S101 - asked of tables without a zero in the first column
    listed = [(letter(i), sign, total) for i, (sign, total) in enumerate(_with_products(signs), 1)]
    yield Step("products", unclaimed="counted; the number has a check of its own", listed=listed, inside=inside,
               outside=len(firsts) - inside)  # fmt: skip
    return inside


def _with_products(signs: Sequence[int | None]) -> Iterable[tuple[int, int]]:
    """Each sign with that of the product up to it."""
    total = 1
    for sign in signs:
        total *= sign or 0
        yield sign or 0, total
