"""Rational roots found by trial and divided out, even polynomials as quadratics in x², and what is left of them."""

from __future__ import annotations

from collections.abc import Generator
from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.quadratics import quadratic_formula
from solver.arithmetic.values import put_in
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, total
from solver.stated.calculus import value_at
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Poly, Symbol

IN_SIGHT = 30
"""Two whole numbers are found by their sum and a product that is not larger."""


@where_exact
def factored(polynomial: Expr, factors: Expr, x: Symbol) -> tuple[Step, ...]:
    """How the factors are found, of which `factors` is the product; none where a look or the field gives them."""
    p = sp.Poly(polynomial, x)
    if not (p.domain.is_ZZ or p.domain.is_QQ) or p.degree() < 2:
        return ()
    return tuple(_factored(p.monic(), _bases(factors, x), x))


@where_exact
def roots_found(polynomial: Expr, roots: list[Expr], x: Symbol) -> tuple[Step, ...]:
    """How the roots are found: those that are rational by trial, a pair that is left by the formula."""
    p = sp.Poly(polynomial, x)
    if p.degree() < 2 or p.degree() != len(roots) or any(each.has(sp.I) for each in p.all_coeffs()):
        return ()
    p = p.monic()
    rational = [root for root in roots if root.is_Rational]
    others = [root for root in roots if not root.is_Rational]
    if p.degree() > 2 and not (p.domain.is_ZZ or p.domain.is_QQ):
        return ()
    return tuple(_roots_found(p, rational, others, x))


@where_exact
def values_at(
    polynomial: Expr, x: Symbol, points: list[Expr], name: Expr | None = None, short_for: Expr | None = None
) -> tuple[Step, ...]:
    """The numbers put into a polynomial, and what it is there; x may be `short_for` what the page has, such as ω²."""
    return tuple(_values_at(polynomial, x, points, name, short_for))


@lemma("arithmetic/roots")
def _values_at(
    polynomial: Expr, x: Symbol, points: list[Expr], name: Expr | None, short_for: Expr | None
) -> Derivation[None]:
    claims = {}
    for i, point in enumerate(points, 1):
        numbers, value = put_in(polynomial, x, point), sp.expand(polynomial.subs(x, point))
        claims[f"put_in{i}"] = Claim(value_at(polynomial, x, point), numbers, Phrase("a number put in"))
        claims[f"value{i}"] = Claim(numbers, value, Phrase("a number put in"))
    yield Step("values", detail="tutor", claims=claims, count=len(points), x=x, name=name, short_for=short_for)


@lemma("arithmetic/roots")
def _factored(p: Poly, factors: list[Poly], x: Symbol) -> Derivation[None]:
    split = _in_squares(p, factors, x)
    if split is not None:
        yield split
        return
    roots = [-each.nth(0) / each.nth(1) for each in factors if each.degree() == 1]
    rational = [root for root in roots if root.is_Rational]
    yield from _divided_out(p, rational, x)


@lemma("arithmetic/roots")
def _roots_found(p: Poly, rational: list[Expr], others: list[Expr], x: Symbol) -> Derivation[None]:
    rest = yield from _divided_out(p, rational, x)
    if rest.degree() == 2 and len(others) == 2 and all(root.is_number for root in others):
        upper_sign_first = sorted(others, key=_size, reverse=True)
        _, b, c = rest.all_coeffs()
        yield from quadratic_formula(x, b, c, upper_sign_first)


def _size(root: Expr) -> tuple[float, float]:
    value = complex(root)
    return value.imag, value.real


def _divided_out(p: Poly, rational: list[Expr], x: Symbol) -> Generator[Step, None, Poly]:
    """Each rational root but zero, the smallest first, until what is left is of degree two; returns what is left."""
    rest = p
    while rest.degree() > 0 and rest.nth(0) == 0:
        rest = rest.quo(sp.Poly(x, x))
    left = sorted((root for root in rational if root != 0), key=lambda root: (abs(root), root))
    while rest.degree() > 2 and left:
        root = left.pop(0)
        quotient = rest.quo(sp.Poly(x - root, x))
        yield _root(rest, root, quotient, x)
        rest = quotient
    if rest.degree() == 2 and len(left) == 2:
        _, b, c = rest.all_coeffs()
        if not _is_in_sight(rest):
            yield from quadratic_formula(x, b, c, sorted(left, reverse=True))
        elif rest != p:
            yield _in_sight(rest, left, x)
        rest = sp.Poly(1, x)
    return rest


def _is_in_sight(quadratic: Poly) -> bool:
    return all(each.is_Integer for each in quadratic.all_coeffs()) and abs(quadratic.nth(0)) <= IN_SIGHT


def _in_sight(p: Poly, roots: list[Expr], x: Symbol) -> Step:
    """Two whole numbers by their sum and their product."""
    first, second = roots
    claims = {
        "sum": Claim(total(first, second), -p.nth(1), Phrase("the sum of two roots")),
        "product": Claim(product(first, second), p.nth(0), Phrase("the product of two roots")),
        "factors": Claim(p.as_expr(), product(x - first, x - second), Phrase("two factors in sight")),
    }
    return Step("in_sight", detail="tutor", claims=claims, x=x, first=first, second=second)


def _root(p: Poly, root: Expr, quotient: Poly, x: Symbol) -> Step:
    """p(root) = 0, and p as multiples of x − root, from the highest power down."""
    expression, factor = p.as_expr(), x - root
    multiples = [product(c * x**k, factor) for (k,), c in quotient.terms()]
    claims = {
        "put_in": Claim(value_at(expression, x, root), put_in(expression, x, root), Phrase("a root put in")),
        "zero": Claim(put_in(expression, x, root), sp.S.Zero, Phrase("a root put in")),
        "multiples": Claim(expression, total(*multiples), Phrase("divided by a factor")),
        "factor": Claim(total(*multiples), product(factor, quotient.as_expr()), Phrase("divided by a factor")),
    }
    return Step("root", detail="tutor", claims=claims, x=x, root=root, factor=factor)


def _in_squares(p: Poly, factors: list[Poly], x: Symbol) -> Step | None:
    """A polynomial of degree four in x² that is a product there, or the difference of two squares."""
    if p.degree() != 4 or p.nth(3) != 0 or p.nth(1) != 0 or p.nth(0) == 0:
        return None
    b, c = p.nth(2), p.nth(0)
    root = sp.sqrt(b**2 / 4 - c)
    if root.is_Rational:
        first, second = x**2 + b / 2 - root, x**2 + b / 2 + root
        claims = {"product": Claim(p.as_expr(), product(first, second), Phrase("factors in the square"))}
        return Step("squares", detail="tutor", claims=claims, x=x, b=b, c=c, first=-b / 2 + root, second=-b / 2 - root)
    quadratic = next((each for each in factors if each.degree() == 2), None)
    if quadratic is None or quadratic.nth(1) == 0:
        return None
    beta, gamma = abs(quadratic.nth(1)), quadratic.nth(0)
    stated = difference(power(x**2 + gamma, 2), power(beta * x, 2))
    claims = {
        "completed": Claim(p.as_expr(), stated, Phrase("the difference of two squares")),
        "product": Claim(stated, product(x**2 + beta * x + gamma, x**2 - beta * x + gamma), Phrase("its factors")),
    }
    return Step("completed", detail="tutor", claims=claims, x=x)


def _bases(factors: Any, x: Symbol) -> list[Poly]:
    """The factors that hold x, each as often as it occurs, with their leading coefficients divided off."""
    found = []
    for each in sp.Mul.make_args(factors):
        base, times = each.as_base_exp()
        if base.has(x) and times.is_Integer:
            found += [sp.Poly(base, x).monic()] * int(times)
    return found
