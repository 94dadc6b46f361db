"""The Riccati equations of the entries solved case by case, where a pen can do it; shown only if nothing is missed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.arithmetic.values import all_put_in
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product
from solver.stated.calculus import value_at
from solver.words import Phrase, formula

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.stated import Stated

LARGEST = 3
"""Larger matrices are not solved with a pen."""

CLOSE = 1e-15


Rows = Sequence[tuple[int, int, "Expr"]]
"""The equations by the places of their entries, counted from 1."""


@dataclass(frozen=True)
class _Told:
    """What the cases are told of: the unknown matrix, its equations and solutions."""

    P: ImmutableMatrix
    rows: Rows
    solutions: Sequence[ImmutableMatrix]


@lemma("riccati_cases")
def cases_of(P: ImmutableMatrix, rows: Rows, solutions: Sequence[exact.RiccatiSolution]) -> Derivation[bool]:
    """Show the case split if it leads to just these solutions; returns whether it was shown."""
    n = P.rows
    unknowns = [P[i, j] for i in range(n) for j in range(i, n)]
    split = exact.case_split([equation for *_, equation in rows], unknowns) if n <= LARGEST else None
    if split is None:
        return False
    ends = [sp.ImmutableMatrix(P.subs(end)) for end in split.ends()]
    if not _same(ends, [each.P for each in solutions]):
        return False
    steps = tuple(_steps(split, _Told(P, rows, [each.P for each in solutions]), {}))
    yield Step("cases", unclaimed="its parts are checked one by one", steps=steps, detail="full", n=n)
    return True


def _same(ends: Sequence[ImmutableMatrix], solutions: Sequence[ImmutableMatrix]) -> bool:
    """Whether both list the same matrices; an end may be reached twice."""
    reached = {_number(end, solutions) for end in ends}
    return reached == set(range(1, len(solutions) + 1))


def _number(end: ImmutableMatrix, solutions: Sequence[ImmutableMatrix]) -> int:
    """The place of a matrix among the solutions, from 1; 0 if it is none of them. Parameters take some value."""
    symbols = sorted(set().union(end.free_symbols, *(P.free_symbols for P in solutions)), key=str)
    point = {symbol: sp.Rational(10 * i + 31, 10) for i, symbol in enumerate(symbols)}
    for number, P in enumerate(solutions, 1):
        gaps = ((end - P).subs(point)).evalf(30)
        size = 1 + max(abs(entry) for entry in P.subs(point).evalf(30))
        if max(abs(gap) for gap in gaps) < CLOSE * size:
            return number
    return 0


def _steps(case: Any, told: _Told, known: Mapping[Any, Expr]) -> list[Step]:
    """The steps of one case and of what follows from it, cases within cases as substeps; `known` led to the case."""
    values, x, equation = case.values, case.unknown, case.equation
    following = [
        _steps(each, told, known if x is None else _known(known, x, value))
        for each, value in zip(case.following, values, strict=True)
    ]
    if case.kind == "found":
        end = sp.ImmutableMatrix(told.P.subs(case.known))
        number, count = _number(end, told.solutions), len(told.solutions)
        return [Step("end", unclaimed="checked as a solution below", P=end, number=number, count=count)]
    if case.kind == "contradiction":
        return [Step("contradiction", unclaimed="an equation that does not hold", equation=equation)]
    if case.kind == "factors":
        claims = {"factors": Claim(equation, _as_product(equation, values), "the equation as a product")}
        parts = zip(values, following, strict=True)
        return [
            Step("factors", claims=claims, equation=equation, values=values),
            *(_factor(value, steps) for value, steps in parts),
        ]
    says = Phrase("${x}$ put into its equation", x=formula(x))
    claims = {f"root{i}": Claim(value_at(equation, x, value), sp.Integer(0), says) for i, value in enumerate(values, 1)}
    before = _before(equation, told.rows, known)
    equation = sp.collect(equation, x)
    if before is not None:
        claims["put_in"] = Claim(before["stated"], equation, says)
    if case.kind == "substitute":
        step = Step("substitute", claims=claims, equation=equation, x=x, value=values[0], before=before)
        return [step, *following[0]]
    formula_claims, shown = _quadratic_formula(equation, x)
    claims |= formula_claims
    roots = Step(
        "roots",
        claims=claims,
        unclaimed="" if claims else "there is no root to put in",
        equation=equation,
        x=x,
        values=values,
        condition=case.condition,
        before=before,
        **shown,
    )
    if len(values) == 1:
        return [roots, *following[0]]
    return [roots, *(_case(x, value, steps) for value, steps in zip(values, following, strict=True))]


def _known(known: Mapping[Any, Expr], x: Any, value: Expr) -> dict[Any, Expr]:
    """What is known once x has a value."""
    return {**{name: sp.expand(each.subs(x, value)) for name, each in known.items()}, x: value}


def _before(equation: Expr, rows: Rows, known: Mapping[Any, Expr]) -> dict[str, Any] | None:
    """The equation of an entry that this is, with what is known put in; None for one that is as it was, or a factor."""
    for i, j, original in rows:
        used = {x: value for x, value in known.items() if original.has(x)}
        if used and sp.expand(original.subs(used)) == equation:
            return {"row": (i, j), "known": list(used.items()), "stated": all_put_in(original, used)}
    return None


def _quadratic_formula(equation: Expr, x: Any) -> tuple[dict[str, Claim], dict[str, Any]]:
    """Of ax² + bx + c = 0 with a = 1 the centre and the radicand, as they come from the numbers; without c the factors.

    `divided` is the equation where it is divided by another a.
    """
    coefficients = sp.Poly(equation, x).all_coeffs()
    if len(coefficients) != 3:
        return {}, {"centre": None}
    a, b, c = coefficients
    if c == 0 and b != 0:
        return {"product": Claim(equation, product(x, a * x + b), Phrase("a common factor"))}, {"centre": None}
    centre, square, rest = (sp.expand(each) for each in (-b / (2 * a), (b / (2 * a)) ** 2, c / a))
    claim = Claim(difference(square, rest), sp.expand(square - rest), Phrase("the radicand"))
    divided = sp.collect(sp.expand(equation / a), x)
    claims = {} if a == 1 else {"divided": Claim(product(a, divided), equation, Phrase("divided"))}
    return claims | {"radicand": claim}, {"centre": centre, "divided": None if a == 1 else divided, "by": a}


def _as_product(equation: Expr, factors: Sequence[Expr]) -> Stated:
    """An equation as the product of its factors, each as often as it counts, behind a number."""
    rest = sp.cancel(equation / sp.Mul(*factors))
    powers: list[Expr] = []
    for factor in factors:
        count = 1
        while not sp.denom(less := sp.cancel(rest / factor)).free_symbols & factor.free_symbols:
            rest, count = less, count + 1
        powers.append(factor**count)
    return product(rest, *powers)


def _case(x: Any, value: Expr, steps: Sequence[Step]) -> Step:
    return Step("case", unclaimed="one of the cases", x=x, value=value, steps=tuple(steps))


def _factor(value: Expr, steps: Sequence[Step]) -> Step:
    return Step("zero_factor", unclaimed="one of the cases", value=value, steps=tuple(steps))
