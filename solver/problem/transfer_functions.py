"""Transfer functions in their three spellings, cancelled exactly."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import comb

import sympy as sp

from solver.problem.lexicon import MEANINGS, SAMPLES, Lexicon, scalar
from solver.problem.matrices import MAX_SIZE
from solver.problem.nodes import MappingNode, Node, SequenceNode
from solver.problem.poles import read_conjugate_list
from solver.problem.source import Report, did_you_mean

MAX_TERMS = 500
MAX_DEGREE = 80


@dataclass(frozen=True)
class Rational:
    """A quotient of polynomials in one variable, as given and cancelled; `text` is how it was given."""

    numerator: sp.Poly
    denominator: sp.Poly
    text: str

    def cancelled(self) -> sp.Expr:
        """Return the quotient without common factors."""
        p, q = self.numerator.cancel(self.denominator, include=True)
        quotient: sp.Expr = p.as_expr() / q.as_expr()
        return quotient


def read_transfer_function(node: Node, lexicon: Lexicon, discrete: bool) -> tuple[sp.Expr, str]:
    """Return a proper rational function of s (discrete: z), cancelled, and how it was given.

    Raises Fault where it is not rational, not proper, of order above 12, or has the denominator zero.
    """
    variable = "z" if discrete else "s"
    if not isinstance(node, MappingNode):
        given = _from_expression(node, lexicon, variable, discrete)
    elif "numerator" in node or "denominator" in node:
        _expect_keys(node, ("numerator", "denominator"), required=True)
        given = _from_coefficients(node, lexicon, variable)
    else:
        _expect_keys(node, ("zeros", "poles", "gain"), required=False)
        given = _from_zeros(node, lexicon, variable)
    zeros, poles = given.numerator.degree(), given.denominator.degree()
    if zeros > poles:
        message = f"the transfer function is improper: its numerator has degree {zeros}, its denominator {poles}"
        raise node.fault(message)
    if poles > MAX_SIZE:
        raise node.fault(f"the transfer function has order {poles}; at most {MAX_SIZE} can be read")
    return given.cancelled(), given.text


def _expect_keys(node: MappingNode, keys: Sequence[str], required: bool) -> None:
    """Raise Fault for other keys, and for missing ones where all are required."""
    for entry in node:
        if entry.key.text not in keys:
            raise entry.key.fault(f"unknown key '{entry.key.text[:60]}'", suggestion=did_you_mean(entry.key.text, keys))
    for key in keys:
        if required and key not in node:
            raise node.fault(f"'{key}' is missing here")


def _from_expression(node: Node, lexicon: Lexicon, variable: str, discrete: bool) -> Rational:
    other = "s" if discrete else "z"
    barred = {name: MEANINGS[name] for name in (other, "t", "lamda")} | (SAMPLES if discrete else {})
    barred[other] = f"in {'discrete' if discrete else 'continuous'} time a transfer function is written in {variable}"
    expression = lexicon.expression(node, (variable,), barred)
    x = sp.Symbol(variable)
    top, bottom = _bounds(expression, x)
    if max(top.terms, bottom.terms) > MAX_TERMS or max(top.degree, bottom.degree) > MAX_DEGREE:
        raise node.fault("the transfer function is too large to be multiplied out")
    p, q = sp.fraction(sp.together(expression))
    if not (p.is_polynomial(x) and q.is_polynomial(x)):
        raise node.fault(f"a quotient of polynomials in {variable} is expected here")
    return Rational(*_pair(sp.expand(p), sp.expand(q), x), scalar(node).text)


def _pair(p: sp.Expr, q: sp.Expr, x: sp.Symbol) -> tuple[sp.Poly, sp.Poly]:
    """Return two polynomials in x over one domain; square roots of numbers are made part of it."""
    symbolic = (p.free_symbols | q.free_symbols) - {x}
    (P, Q), _ = sp.parallel_poly_from_expr((p, q), x, extension=None if symbolic else True)
    return P, Q


def _from_coefficients(node: MappingNode, lexicon: Lexicon, variable: str) -> Rational:
    report = Report()
    coefficients: list[list[sp.Expr]] = []
    for key in ("numerator", "denominator"):
        with report:
            coefficients.append(_coefficients(node[key], key, lexicon))
    report.conclude()
    if not coefficients[1]:
        raise node["denominator"].fault("the denominator is zero")
    x = sp.Symbol(variable)
    p, q = (sum((c * x**i for i, c in enumerate(reversed(cs))), sp.Integer(0)) for cs in coefficients)
    return Rational(*_pair(p, q, x), f"({sp.sstr(p)})/({sp.sstr(q)})")


def _coefficients(node: Node, key: str, lexicon: Lexicon) -> list[sp.Expr]:
    """Return coefficients, highest power first, without leading zeros."""
    items = node.items if isinstance(node, SequenceNode) else (node,)
    if not 0 < len(items) <= MAX_SIZE + 1:
        raise node.fault(f"{key} has {len(items)} coefficients; 1 to {MAX_SIZE + 1} can be read")
    report = Report()
    values: list[sp.Expr] = []
    for item in items:
        with report:
            values.append(lexicon.expression(item))
    report.conclude()
    while values and values[0].is_zero:
        values.pop(0)
    return values


def _from_zeros(node: MappingNode, lexicon: Lexicon, variable: str) -> Rational:
    report = Report()
    roots: dict[str, Sequence[sp.Expr]] = {"zeros": (), "poles": ()}
    gain: sp.Expr = sp.Integer(1)
    for key in roots:
        with report:
            roots[key] = read_conjugate_list(node[key], lexicon, key.removesuffix("s")) if key in node else ()
    with report:
        gain = lexicon.expression(node["gain"]) if "gain" in node else gain
    report.conclude()
    x = sp.Symbol(variable)
    p = sp.expand(sp.Mul(gain, *(sp.expand(x - zero) for zero in roots["zeros"])))
    q = sp.expand(sp.Mul(*(sp.expand(x - pole) for pole in roots["poles"])))
    factors = ["".join(f"*({sp.sstr(x - root)})" for root in roots[key]) for key in ("zeros", "poles")]
    return Rational(*_pair(p, q, x), f"({sp.sstr(gain)}){factors[0]}/(1{factors[1]})")


@dataclass(frozen=True)
class Bound:
    """Upper bounds of a polynomial multiplied out: its number of terms, and its degree in all symbols together."""

    terms: int
    degree: int

    def plus(self, other: Bound) -> Bound:
        """The bound of a sum."""
        return Bound(self.terms + other.terms, max(self.degree, other.degree))

    def times(self, other: Bound, symbols: int) -> Bound:
        """The bound of a product; a polynomial of degree d in v symbols has at most C(d+v, v) terms."""
        degree = self.degree + other.degree
        return Bound(min(self.terms * other.terms, comb(degree + symbols, symbols)), degree)


def _bounds(expression: sp.Expr, x: sp.Symbol) -> tuple[Bound, Bound]:
    """Return bounds of numerator and denominator of an expression, brought to one fraction, in x and the atoms."""
    symbols = len(expression.free_symbols | expression.atoms(sp.Function) | {x})
    one = Bound(1, 0)

    def bounds(e: sp.Expr) -> tuple[Bound, Bound]:
        if isinstance(e, sp.Pow) and e.exp.is_Integer:
            top, bottom = bounds(e.base)
            top, bottom = _power(top, abs(int(e.exp)), symbols), _power(bottom, abs(int(e.exp)), symbols)
            return (top, bottom) if e.exp > 0 else (bottom, top)
        if not isinstance(e, (sp.Add, sp.Mul)):
            return (Bound(1, 0 if e.is_number else 1), one)
        top, bottom = (Bound(0, 0), one) if isinstance(e, sp.Add) else (one, one)
        for argument in e.args:
            p, q = bounds(argument)
            if isinstance(e, sp.Add):
                top = top.times(q, symbols).plus(p.times(bottom, symbols))
            else:
                top = top.times(p, symbols)
            bottom = bottom.times(q, symbols)
        return top, bottom

    return bounds(expression)


def _power(bound: Bound, exponent: int, symbols: int) -> Bound:
    degree = bound.degree * exponent
    terms = 1 if bound.terms == 1 else min(bound.terms**exponent, comb(degree + symbols, symbols))
    return Bound(terms, degree)
