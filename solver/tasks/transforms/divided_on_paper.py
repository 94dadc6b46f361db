"""Lemma: polynomials in z divided by falling powers, as on paper; the quotient holds the values of the sequence."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient, total

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from sympy import Expr

    from solver.tasks.transforms.back_transform import Names


@lemma("divided_on_paper")
def by_long_division(image: exact.RationalImage, terms: int, names: Names) -> Derivation[tuple[Expr, ...]]:
    """The scheme of the division; returns f(0), f(1), …."""
    z = names.s
    found = exact.long_division(image, z, terms)
    dividend, divisor = _in_powers(found.dividend, z), _in_powers(found.divisor, z)
    yield Step("arranged", unclaimed="by falling powers", dividend=dividend, divisor=divisor,
               first=found.rows[0] if found.rows else None, detail="full", **names.told)  # fmt: skip
    left, claims = dividend, {}
    for row in found.rows:
        rest = _in_powers(row.rest, z)
        term = row.coefficient * z**-row.step
        claims[f"row{row.step}"] = Claim(total(left, product(-term, divisor)), rest, "one step of the division")
        left = rest
    quotient_of = [row.coefficient * z**-row.step for row in found.rows]
    claims["whole"] = Claim(
        quotient(dividend, divisor), total(*quotient_of, quotient(left, divisor)), "quotient and remainder"
    )
    yield Step("scheme", claims=claims, columns=_columns(found), rows=_rows(found), divisor=divisor,
               quotient=[(row.coefficient, row.step) for row in found.rows], rest=left, **names.told)  # fmt: skip
    yield Step("values", unclaimed="read off", values=list(found.values), **names.told)
    return found.values


def _in_powers(coefficients: Mapping[int, Expr], z: Any) -> Expr:
    return sp.Add(*(c * z**n for n, c in coefficients.items()))


def _columns(found: exact.LongDivision) -> list[int]:
    """The powers of z that occur, falling."""
    used = {*found.dividend, *(n for row in found.rows for n in (*row.taken, *row.rest))}
    return list(range(max(used), min(used) - 1, -1)) if used else []


def _rows(found: exact.LongDivision) -> list[tuple[str, int | None, Expr | None, Sequence[Expr | None]]]:
    """The rows of the scheme: kind, power and coefficient of the term of the quotient, and the entries by columns."""
    columns = _columns(found)
    rows: list[Any] = [("dividend", None, None, [found.dividend.get(n) for n in columns])]
    for row in found.rows:
        rows.append(("taken", row.step, row.coefficient, [row.taken.get(n) for n in columns]))
        rows.append(("rest", None, None, [row.rest.get(n) for n in columns]))
    return rows
