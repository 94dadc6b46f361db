"""A fraction at a frequency: the size and the angle of each factor, the sizes multiplied, the angles added."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, quotient, total
from solver.stated.calculus import derivative
from solver.stated.complex_numbers import absolute, phase
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Symbol

DIGITS = 30


@where_exact
def size_and_angle(
    fraction: Expr, s: Symbol, at: Expr, size: Expr | None = None, angle: Expr | None = None
) -> tuple[Step, ...]:
    """A real fraction in s at a number, jω or another, of which the size, the angle in degrees, or both are known."""
    if fraction.has(sp.exp):
        return ()
    above, below = sp.fraction(sp.together(fraction))
    if not at.is_number or (above * below).free_symbols - {s}:
        return ()
    parts = [(sp.Poly(part, s), sign) for part, sign in ((above, 1), (below, -1))]
    if sum(p.degree() for p, _ in parts) < 2:
        return ()
    constant, rows = sp.S.One, []
    for p, sign in parts:
        factors = [(exact.shown_factor(factor), times) for factor, times in p.factor_list()[1]]
        constant *= (p.LC() / sp.Mul(*(factor.LC() ** times for factor, times in factors))) ** sign
        rows += [(factor.as_expr(), sign * times) for factor, times in factors]
    return tuple(_at(constant, rows, s, sp.N(at, DIGITS), (size, angle)))


@where_exact
def slope_of(above: Expr, below: Expr, w: Symbol) -> tuple[Step, ...]:
    """What is zero where the slope of N/D is: the derivative of one where the other is constant, or N′D − ND′."""
    return tuple(_slope_of(above, below, w)) if (above * below).free_symbols == {w} else ()


@lemma("arithmetic/frequencies")
def _slope_of(above: Expr, below: Expr, w: Symbol) -> Derivation[None]:
    N, D = (sp.expand(sp.diff(each, w)) for each in (above, below))
    alone = below if N == 0 else above if D == 0 else None
    if alone is not None:
        claims = {"slope": Claim(derivative(alone, w), sp.expand(sp.diff(alone, w)), Phrase("a derivative"))}
    else:
        parts = difference(product(N, below), product(above, D))
        claims = {"slope": Claim(parts, sp.expand(N * below - above * D), Phrase("the numerator of the slope"))}
    yield Step("slope", detail="tutor", claims=claims, above=above, below=below, w=w, alone=alone)


@lemma("arithmetic/frequencies")
def _at(
    constant: Expr, factors: list[tuple[Expr, int]], s: Symbol, at: Expr, found: tuple[Expr | None, Expr | None]
) -> Derivation[None]:
    claims: dict[str, Claim] = {}
    rows = []
    for i, (factor, times) in enumerate(factors, 1):
        value = sp.expand(factor.subs(s, at))
        size, degrees = sp.N(sp.Abs(value), DIGITS), sp.N(180 * sp.arg(value) / sp.pi, DIGITS)
        claims[f"size{i}"] = Claim(absolute(value), size, Phrase("the size of a factor"))
        claims[f"angle{i}"] = Claim(phase(value), degrees, Phrase("the angle of a factor"))
        rows.append((factor, times, value, size, degrees))
    size, angle = found
    if size is not None:
        claims["size"] = Claim(_sizes(constant, rows), size, Phrase("the sizes multiplied"))
    if angle is not None and len(rows) > 1:
        terms = [degrees if times == 1 else product(sp.Integer(times), degrees) for *_, times, degrees in _angles(rows)]
        whole = sp.Add(*(times * degrees for *_, times, degrees in _angles(rows))) + (180 if constant < 0 else 0)
        turn = 360 * sp.Integer(round(float((angle - whole) / 360))) + (180 if constant < 0 else 0)
        terms += [sp.Integer(turn)] if turn else []
        claims["angle"] = Claim(total(*terms), angle, Phrase("the angles added"))
    yield Step("factors", detail="tutor", claims=claims, rows=rows)


def _angles(rows: list[tuple[Any, ...]]) -> list[tuple[Any, ...]]:
    return [(factor, times, degrees) for factor, times, _, _, degrees in rows]


def _sizes(constant: Expr, rows: list[tuple[Any, ...]]) -> Any:
    """The product of the sizes, those of the denominator below a line."""
    above = [power(size, sp.Integer(times)) for _, times, _, size, _ in rows if times > 0]
    below = [power(size, sp.Integer(-times)) for _, times, _, size, _ in rows if times < 0]
    number = abs(constant)
    top = product(*above) if above and number == 1 else product(number, *above) if above else number
    return quotient(top, product(*below)) if below else top
