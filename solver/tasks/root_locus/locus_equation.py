"""Lemma: the equation of the poles of a loop in the form D(s) + K N(s) = 0, with nothing in common to D and N."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient, total

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import CharacteristicEquation

GAIN = "K"


@dataclass(frozen=True, slots=True)
class Form:
    """N, D in lowest terms, K (a parameter, or the gain before L, `before`), and the polynomial D + K N as given.

    `in_factors` are N and D as they were given, None where they were not given in factors.
    """

    equation: exact.LocusEquation
    s: Symbol
    K: Symbol
    N: Expr
    D: Expr
    polynomial: Expr
    before: bool
    sample_time: Expr | None = None
    in_factors: tuple[Expr, Expr] | None = None

    @property
    def discrete(self) -> bool:
        """Whether s is z, and the unit circle bounds what is stable."""
        return self.equation.discrete


def polynomial_of(given: CharacteristicEquation, name: str | None) -> tuple[Expr, Symbol, bool]:
    """Return the polynomial of the poles, the symbol of the gain, and whether it stands before L.

    Raises Unsolved where no parameter, or more than one, could be meant, or where there is a dead time.
    """
    loop, s = given.loop, given.variable
    if loop is not None and loop.delay != 0:
        raise Unsolved("root_locus/dead_time", delay=loop.delay)
    inside = sorted(set(given.given.parameters) - {s}, key=str)
    named = [each for each in inside if each.name == (name or GAIN)] or (
        inside if not name and len(inside) == 1 else []
    )
    others = [each for each in inside if each not in named]
    if others:
        raise Unsolved("root_locus/other_parameters", others=others, named=named)
    if named:
        p = given.polynomial
        return sp.expand(p), named[0], False
    if loop is None:
        raise Unsolved("root_locus/no_parameter")
    K = sp.Symbol(name or GAIN, real=True)
    return sp.expand(loop.denominator + K * loop.numerator), K, True


@lemma("locus_equation")
def locus_equation_of(given: CharacteristicEquation, name: str | None) -> Derivation[Form]:
    """D + K N = 0, its common factors divided out; raises Unsolved where K enters otherwise, or moves no pole."""
    p, K, before = polynomial_of(given, name)
    s, loop = given.variable, given.loop
    coefficients = sp.Poly(p, s).all_coeffs()
    parts = exact.affine_parts(coefficients, K)
    if parts is None:
        raise Unsolved("root_locus/not_affine", K=K, p=p)
    D, N = (_polynomial(each, s) for each in parts)
    if N == 0 or D == 0 or max(sp.degree(D, s), sp.degree(N, s)) == 0:
        raise Unsolved("root_locus/constant", K=K)
    if sp.degree(N, s) > sp.degree(D, s):
        raise Unsolved("root_locus/improper", K=K, N=N, D=D)
    stated: Any = (
        p if loop is None else total(loop.denominator, product(K, loop.numerator) if before else loop.numerator)
    )
    shown = product(K, N)
    in_factors = loop.rational.written if before and loop is not None else None
    yield Step(
        "gain" if before else "affine",
        claims={"form": Claim(stated, total(D, shown), "the equation of the poles")},
        K=K, N=N, D=D, L=quotient(N, D), s=s, of_loop=loop is not None, in_factors=in_factors,
    )  # fmt: skip
    equation = exact.locus_equation(N, D, s, discrete=given.discrete)
    above, below = exact.written(equation.numerator), exact.written(equation.denominator)
    if equation.common.degree():
        common = exact.written(equation.common)
        fixed = [each.value for each in exact.roots_with_factors(equation.common) for _ in range(each.multiplicity)]
        claims = {
            "numerator": Claim(N, product(common, above), "the common factor of the numerator"),
            "denominator": Claim(D, product(common, below), "the common factor of the denominator"),
        }
        yield Step("common", claims=claims, common=common, fixed=fixed, K=K)
        if equation.denominator.degree() == 0:
            raise Unsolved("root_locus/constant", K=K)
        in_factors = None
    return Form(equation, s, K, above, below, p, before, given.sample_time, in_factors)


def _polynomial(coefficients: list[Expr], s: Symbol) -> Expr:
    n = len(coefficients) - 1
    return sp.Add(*(c * s ** (n - i) for i, c in enumerate(coefficients)))
