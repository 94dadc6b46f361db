"""Functions of time and integrands along them as a person writes them, and integrals over time."""

from __future__ import annotations

import sympy as sp

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.variations.exponential_sums import ExponentialSum, read
from solver.exact.variations.quotients import quotient
from solver.exact.variations.table_of_integrals import table_integral

DIGITS = 30
"""Of integrals in decimals."""
DECIMALS = sp.Rational(1, 10**12)
"""Decimals that differ by less are one."""
EXPONENTIALS = (sp.exp, sp.cosh, sp.sinh, sp.tanh)


def in_time(function: sp.Expr, t: sp.Symbol) -> sp.Expr:
    """Return a function of t, or a number, without common factors; with cosh and sinh where that is shorter."""
    if function.has(sp.Float):
        return function
    if not function.has(*EXPONENTIALS, sp.E):
        return sp.expand(function) if function.is_polynomial(t) else _under_one_root(function)
    try:
        above, below = _read_fraction(function, t)
        cancelled: sp.Expr = quotient(above, below, rising=True)
        above, below = _read_fraction(cancelled, t)
    except NotExact:
        return function
    return _hyperbolic(above, below) or cancelled


def _under_one_root(function: sp.Expr) -> sp.Expr:
    """√2 √(3t/2 + 1/2) as √(3t + 1), and the same of other fractional powers."""
    constant, root = function.as_independent(*function.free_symbols, as_Add=False)
    if not (isinstance(root, sp.Pow) and root.exp.is_Rational and not root.exp.is_Integer):
        return function
    inside = sp.Abs(constant) ** (1 / root.exp)
    return sp.sign(constant) * sp.expand(inside * root.base) ** root.exp if inside.is_Rational else function


def _read_fraction(function: sp.Expr, t: sp.Symbol) -> tuple[ExponentialSum, ExponentialSum]:
    above, below = sp.fraction(sp.together(function))
    return read(sp.expand(above), [t]), read(sp.expand(below), [t])


def _hyperbolic(above: ExponentialSum, below: ExponentialSum) -> sp.Expr | None:
    """N/D by cosh and sinh, where the exponentials of both come in pairs about one and the same exponent."""
    pairs = [_in_pairs(part) for part in (above, below)]
    if any(pair is None for pair in pairs):
        return None
    (first, N), (second, D) = pairs  # type: ignore[misc]  # neither is None
    if first != second or not (N.has(sp.sinh, sp.cosh) or D.has(sp.sinh, sp.cosh)):
        return None
    number, rest = sp.factor_terms(N).as_coeff_Mul()
    other, divisor = sp.factor_terms(D).as_coeff_Mul()
    return sp.Mul(number / other, rest / divisor)


def _in_pairs(part: ExponentialSum) -> tuple[sp.Expr, sp.Expr] | None:
    """The exponent in the middle, and the sum without it as cosh and sinh; None where it is none of pairs."""
    if any(mode.angle != 0 for mode, _ in part.terms) or not part.terms:
        return None
    middle = sp.expand(sp.Add(*(mode.exponent for mode, _ in part.terms)) / len(part.terms))
    found = {(sp.expand(mode.exponent - middle), mode.monomial): c for mode, c in part.terms}
    terms = []
    for (exponent, monomial), c in found.items():
        if exponent == 0:
            terms.append(c * monomial)
            continue
        if exponent.could_extract_minus_sign():
            continue
        opposite = found.get((-exponent, monomial))
        if opposite not in (c, -c):
            return None
        terms.append(2 * c * monomial * (sp.cosh(exponent) if opposite == c else sp.sinh(exponent)))
    whole = len(terms) + sum(exponent != 0 and exponent.could_extract_minus_sign() for exponent, _ in found)
    return (middle, sp.Add(*terms)) if whole == len(found) else None


def along(integrand: sp.Expr, t: sp.Symbol) -> sp.Expr:
    """Return an expression in t as a sum of functions that can be integrated, where it is one; else in factors."""
    if integrand.is_polynomial(t):
        return sp.expand(integrand)
    integrand = without_roots(integrand)
    try:
        modes, below = _modes(integrand, t)
    except NotExact:
        whole = sp.expand(integrand)
        return whole if whole.count_ops() <= integrand.count_ops() else sp.factor(sp.together(integrand))
    return (_shown(modes) if integrand.has(*EXPONENTIALS) else modes.expression) / below


def without_roots(integrand: sp.Expr) -> sp.Expr:
    """√(a + a sinh²u) as √a cosh u, and its powers: of extremals in cosh."""
    put: dict[sp.Expr, sp.Expr] = {}
    for root in integrand.atoms(sp.Pow):
        halves = 2 * root.exp
        squares = [f for f in root.base.atoms(sp.sinh) if root.base.has(f**2)] if halves.is_Integer else []
        if len(squares) != 1 or not root.base.is_Add:
            continue
        u = squares[0].args[0]
        mark = sp.Dummy()
        rest = root.base.xreplace({squares[0] ** 2: mark})
        a, b = rest.xreplace({mark: sp.S.Zero}), sp.diff(rest, mark)
        if not rest.has(squares[0]) and _agree(a, b) and a.is_positive:
            put[root] = a**root.exp * sp.cosh(u) ** halves
    return integrand.xreplace(put)


def _agree(a: sp.Expr, b: sp.Expr) -> bool:
    """Whether two numbers are one, decimals to their digits."""
    if a.has(sp.Float) or b.has(sp.Float):
        return bool(abs(a - b) < DECIMALS * abs(a)) if a.is_number and b.is_number else False
    return bool(sp.expand(a - b) == 0)


def _shown(modes: ExponentialSum) -> sp.Expr:
    """The sum by cosh and sinh where it is one of pairs about zero."""
    pairs = _in_pairs(modes)
    return pairs[1] if pairs is not None and pairs[0] == 0 else modes.expression


def _modes(expression: sp.Expr, t: sp.Symbol) -> tuple[ExponentialSum, sp.Expr]:
    """A sum of exponentials and waves, over what does not depend on t."""
    above, below = sp.fraction(sp.together(expression))
    constant, varying = sp.factor(below).as_independent(t, as_Add=False)
    modes = read(sp.expand(above), [t])
    divisor = read(sp.expand(varying), [t]).terms
    if len(divisor) != 1 or divisor[0][0].angle != 0 or divisor[0][0].monomial != 1:
        raise NotExact("functions/form_of_the_power")
    ((mode, c),) = divisor
    return modes.shifted(-mode.exponent), constant * c


def definite_integral(integrand: sp.Expr, t: sp.Symbol, start: sp.Expr, stop: sp.Expr) -> sp.Expr | None:
    """Return the integral of an expression over t; None where no antiderivative is known, or it has no values there."""
    below: sp.Expr = sp.S.One
    if integrand.has(*EXPONENTIALS):
        try:
            modes, below = _modes(integrand, t)
        except NotExact:
            return None
        integrand = modes.expression
    terms = sp.Add.make_args(sp.expand(integrand))
    found = [each for term in terms if (each := _antiderivative(term, t)) is not None]
    if len(found) < len(terms):
        return None
    whole = sp.Add(*found)
    values = [whole.xreplace({t: end}) for end in (stop, start)]
    if any(value.has(sp.nan, sp.zoo, sp.oo) for value in values):
        return None
    return in_time(sp.expand(values[0] - values[1]) / below, t)


def decimal_integral(integrand: sp.Expr, t: sp.Symbol, start: sp.Expr, stop: sp.Expr) -> sp.Expr | None:
    """Return the integral in decimals, where everything is a number and it has a real value; else None."""
    if integrand.free_symbols - {t} or not (start.is_number and stop.is_number):
        return None
    value = sp.Integral(integrand, (t, start, stop)).evalf(DIGITS)
    return value if value.is_Float and value.is_finite else None


def _antiderivative(term: sp.Expr, t: sp.Symbol) -> sp.Expr | None:
    """Of a constant, a power of t, or what the table has."""
    constant, rest = term.as_independent(t, as_Add=False)
    base, exponent = rest.as_base_exp()
    if rest == 1:
        return constant * t
    if base == t and not exponent.has(t):
        return constant * (sp.log(t) if exponent == -1 else t ** (exponent + 1) / (exponent + 1))
    return table_integral(term, t)
