"""Functions of parameters as generators of a field: roots, exponentials, tangents of half an angle."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp


def generators_in(M: sp.MatrixBase) -> tuple[sp.MatrixBase, dict[sp.Symbol, sp.Expr]]:
    """M with symbols in place of functions of parameters, and what they stand for; raises ValueError.

    Generators must be independent: √a stands for itself, and a for its square; exponentials are those of products of
    parameters, of 1 and of roots of integers, one for all rational multiples (Lindemann and Weierstrass).
    """
    put: dict[Any, Any] = {}
    stand: dict[sp.Symbol, sp.Expr] = {}
    for tangent in sorted(M.atoms(sp.tan), key=str):
        put[tangent] = sp.Dummy("t")
        stand[put[tangent]] = tangent
    M = M.xreplace(put)
    if M.has(sp.exp, sp.E):
        M = M.applyfunc(lambda e: e.expand(deep=False, basic=False, power_exp=True))
    shares: dict[Any, list[tuple[Any, Any]]] = {}
    for each, exponent in sorted(exponentials_in(M).items(), key=str):
        number, product = exponent.as_coeff_Mul()
        powers = product.as_powers_dict()
        known = number.is_Rational and all(x.is_Symbol and k.is_Integer for x, k in powers.items())
        if not known and not _is_a_root(product):
            raise ValueError("a function of parameters that is no generator")
        shares.setdefault(product, []).append((each, number))
    put = {}
    for product, several in shares.items():
        step = sp.Rational(1, sp.ilcm(*(number.q for _, number in several), 1))
        symbol = sp.Dummy("e")
        stand[symbol] = sp.exp(step * product)
        put |= {each: symbol ** (number / step) for each, number in several}
    M = M.xreplace(put)
    roots = {p.base for p in M.atoms(sp.Pow) if p.base.is_Symbol and p.exp.is_Rational and p.exp.q == 2}
    put = {}
    for base in sorted(roots, key=str):
        symbol = sp.Dummy("r", positive=True)
        stand[symbol] = sp.sqrt(base)
        put[base] = symbol**2
    inside = {p: put[p.base] ** p.exp for p in M.atoms(sp.Pow) if p.base in put}
    return M.xreplace(inside).xreplace(put) if put else M, stand


def exponentials_in(M: sp.MatrixBase) -> dict[sp.Expr, sp.Expr]:
    """The powers of e in M, e itself among them, with their exponents."""
    found: dict[sp.Expr, sp.Expr] = {each: each.args[0] for each in M.atoms(sp.exp)}
    return found | ({sp.E: sp.Integer(1)} if M.has(sp.E) else {})


def dependent_exponentials(M: sp.MatrixBase) -> bool:
    """Whether several powers of e with numbers above are in M (no decimals), which sympy takes for independent."""
    several = sum(not exponent.free_symbols for exponent in exponentials_in(M).values()) > 1
    return several and not M.has(sp.Float)


def _is_a_root(product: Any) -> bool:
    """Whether a number without its rational factor is 1 or √q for a square-free q."""
    return product == 1 or bool(product.is_Pow and product.base.is_Integer and product.exp == sp.Rational(1, 2))


def half_angles(M: sp.MatrixBase) -> sp.MatrixBase:
    """M with rational functions of tangents in place of sines and cosines; multiples of an angle in terms of it.

    Raises ValueError for angles whose ratio is not known, as it is a decimal.
    """
    shares: dict[sp.Expr, list[sp.Rational]] = {}
    angles = {f.args[0] for f in M.atoms(sp.sin, sp.cos)}
    for angle in angles:
        number, product = angle.as_coeff_Mul()
        shares.setdefault(product, []).append(number)
    several = {product: numbers for product, numbers in shares.items() if len(numbers) > 1}
    if not all(number.is_Rational for numbers in several.values() for number in numbers):
        raise ValueError("angles in decimals")
    if several:
        M = M.xreplace({f: of for product, numbers in several.items() for f, of in _in_one_angle(product, numbers)})
        angles = {f.args[0] for f in M.atoms(sp.sin, sp.cos)}
    substitution: dict[sp.Expr, sp.Expr] = {}
    for angle in angles:
        u = sp.tan(angle / 2)
        substitution |= {sp.cos(angle): (1 - u**2) / (1 + u**2), sp.sin(angle): 2 * u / (1 + u**2)}
    return M.xreplace(substitution) if substitution else M


def _in_one_angle(product: sp.Expr, numbers: Sequence[sp.Rational]) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """Sines and cosines of rational multiples of a product, in those of the largest angle that measures all."""
    step = sp.Rational(sp.igcd(*(number.p for number in numbers), 0), sp.ilcm(*(number.q for number in numbers), 1))
    d = sp.Dummy("d", real=True)
    for number in numbers:
        if number != step:
            for f in (sp.sin, sp.cos):
                yield f(number * product), sp.expand_trig(f(number / step * d)).xreplace({d: step * product})
