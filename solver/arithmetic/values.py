"""Numbers put into an expression, not yet worked out: (−5 + 9)/(−5 + 4) for (s + 9)/(s + 4) at s = −5."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from solver.lazy import sympy as sp
from solver.stated import Stated
from solver.stated.algebra import power, product, quotient, total
from solver.stated.matrices import matrix_of

if TYPE_CHECKING:
    from sympy import Expr, Symbol


def put_in(expression: Any, x: Symbol, value: Expr) -> Any:
    """The expression or matrix with a value in place of x, by falling powers of x.

    Functions have their values, and terms that are zero at x = 0 are left out.
    """
    if isinstance(expression, sp.MatrixBase):
        rows = [[put_in(entry, x, value) for entry in row] for row in expression.tolist()]
        known = all(isinstance(entry, sp.Expr) for row in rows for entry in row)
        return sp.ImmutableMatrix(rows) if known else matrix_of(rows)
    at = expression.xreplace({x: value})
    if not expression.has(x) or (at == 0 and not expression.is_Add and (value == 0 or _moves(expression))):
        return at
    if expression.is_Add:
        left = [term for term in (put_in(each, x, value) for each in _in_order(expression, x)) if term != 0]
        return _sum(left) if left else at
    if expression.is_Mul or (expression.is_Pow and expression.exp.is_negative):
        return _product(sp.Mul.make_args(expression), x, value)
    return _power(put_in(expression.base, x, value), expression.exp) if _is_power(expression, x) else at


def all_put_in(polynomial: Expr, values: Mapping[Any, Expr]) -> Stated:
    """A polynomial with the values of some of its unknowns in their places, term by term as it is printed."""
    terms = []
    for term in polynomial.as_ordered_terms():
        still, moved = term.as_independent(*values, as_Add=False)
        powers = [_power(values[base], exponent) for base, exponent in moved.as_powers_dict().items() if base != 1]
        number, rest = still.as_coeff_Mul()
        terms.append(product(number, *powers, rest))
    return total(*terms)


def _sum(terms: Sequence[Any]) -> Any:
    """The sum, as a value where nothing in it comes together."""
    if all(isinstance(term, sp.Expr) for term in terms):
        value = sp.Add(*terms)
        if len(sp.Add.make_args(value)) == len(terms):
            return value
    return total(*terms) if len(terms) > 1 else terms[0]


def _is_power(expression: Any, x: Symbol) -> bool:
    return bool(expression.is_Pow and not expression.exp.has(x))


def _power(base: Any, exponent: Any) -> Any:
    return base if exponent == 1 else power(base, exponent)


def _product(factors: Sequence[Any], x: Symbol, value: Expr) -> Any:
    """The product, factors with negative powers of what holds x below a line; numbers, powers of x, functions."""
    below = [each for each in factors if each.is_Pow and each.exp.is_negative and each.base.has(x)]
    above: list[Any] = []
    still: Any = sp.S.One
    for each in factors:
        at = each.xreplace({x: value})
        if each in below:
            continue
        if not each.has(x) or (_is_function(each, x) and (at in (1, -1) or not at.is_Number)):
            still *= at
        else:
            above.append(put_in(each, x, value))
    number, free = still.as_coeff_Mul()
    above = [each for each in above if each != 1]
    under = [_power(put_in(each.base, x, value), -each.exp) for each in below]
    if len(above) == 1 and still == -1 and isinstance(above[0], sp.Expr):
        number, above = sp.S.One, [-above[0]]
    if not under:
        return _times(number, above, free) if above else still
    if not above and free == 1 and _is_in_lowest_terms(number, under):
        return number / under[0]
    over = _times(number.p if number.is_Rational else number, above, free)
    return quotient(over, product(number.q, *under) if number.is_Rational else product(*under))


def _times(number: Any, above: Sequence[Any], free: Any) -> Any:
    """A number or a parameter before what was put in, and functions behind it."""
    functions = sp.Mul(*(each for each in sp.Mul.make_args(free) if _moves(each)))
    return product(number * free / functions, *above, functions)


def _moves(expression: Any) -> bool:
    """Whether there is a function of time in it."""
    return bool(expression.atoms(sp.exp, sp.sin, sp.cos, sp.cosh, sp.sinh))


def _is_function(factor: Any, x: Symbol) -> bool:
    """Whether x is the argument of a function, or in an exponent."""
    return bool(factor.is_Function or isinstance(factor, sp.exp) or (factor.is_Pow and factor.exp.has(x)))


def _is_in_lowest_terms(number: Any, under: Sequence[Any]) -> bool:
    """Whether a number over a number is a fraction that stays as it is."""
    below = under[0]
    whole = len(under) == 1 and isinstance(below, sp.Integer) and number.is_Rational
    return whole and bool((number / below).q == number.q * below)


def _in_order(polynomial: Expr, x: Symbol) -> list[Any]:
    """The terms by falling powers of x; a first one with a minus changes places with one without, if there are two."""
    terms = sorted(polynomial.as_ordered_terms(), key=lambda term: -_degree(term, x))
    if len(terms) == 2 and terms[0].could_extract_minus_sign() and not terms[1].could_extract_minus_sign():
        return terms[::-1]
    return terms


def _degree(term: Expr, x: Symbol) -> int:
    """The power of x that a term is a multiple of."""
    exponent = term.as_powers_dict().get(x, sp.S.Zero)
    return int(exponent) if exponent.is_Integer else 0
