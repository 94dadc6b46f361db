"""Transfer functions in their three spellings, cancelled exactly."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from solver.problem.dead_times import without_dead_time
from solver.problem.lexicon import Lexicon
from solver.problem.matrices import MAX_SIZE
from solver.problem.nodes import MappingNode, Node, SequenceNode, scalar
from solver.problem.poles import read_conjugate_list
from solver.problem.rational_functions import Rational, expanded_size, field_degree
from solver.problem.source import Report, surplus
from solver.symbols import MEANINGS, SAMPLES

MAX_TERMS = 500
MAX_DEGREE = 80
MAX_FIELD_DEGREE = 8
FRACTION = ("numerator", "denominator")
ZEROS_POLES_GAIN = ("zeros", "poles", "gain")
ONE_CHANNEL = "it can stand in the transfer function of a system with one input and one output"


def read_transfer_function(
    node: Node, lexicon: Lexicon, discrete: bool, *, proper: bool = True, delayed: bool = False
) -> Rational:
    """Return a rational function of s (discrete: z), as it was given; `proper` says that it must be.

    Raises Fault where it is not rational, not proper, of order above 12, or has the denominator zero; and where it has
    a dead time, if it is not said that it may be `delayed`.
    """
    variable = "z" if discrete else "s"
    if not isinstance(node, MappingNode):
        given = _from_expression(node, lexicon, variable, discrete)
    elif "numerator" in node or "denominator" in node:
        _expect_keys(node, FRACTION, ZEROS_POLES_GAIN, required=True)
        given = _from_coefficients(node, lexicon, variable)
    else:
        _expect_keys(node, ZEROS_POLES_GAIN, FRACTION, required=False)
        given = _from_zeros(node, lexicon, variable)
    if given.delay != 0 and not delayed:
        raise node.fault("a quotient of polynomials in s is expected here, without a dead time", note=ONE_CHANNEL)
    zeros, poles = given.numerator.degree(), given.denominator.degree()
    if proper and zeros > poles:
        message = f"the transfer function is improper: its numerator has degree {zeros}, its denominator {poles}"
        raise node.fault(message)
    if max(zeros, poles) > MAX_SIZE:
        raise node.fault(f"the transfer function has order {max(zeros, poles)}; at most {MAX_SIZE} can be read")
    return given


def _expect_keys(node: MappingNode, keys: Sequence[str], others: Sequence[str], required: bool) -> None:
    """Raise Fault for other keys, and for missing ones where all are required."""
    for entry in node:
        if entry.key.text not in keys:
            message, suggestion = surplus(entry.key.text, list(node.entries), keys, others)
            raise entry.key.fault(message, suggestion=suggestion)
    for key in keys:
        if required and key not in node:
            raise node.fault(f"'{key}' is missing here")


def _from_expression(node: Node, lexicon: Lexicon, variable: str, discrete: bool) -> Rational:
    other = "s" if discrete else "z"
    barred = {name: MEANINGS[name] for name in (other, "t", "lamda")} | (SAMPLES if discrete else {})
    barred[other] = f"in {'discrete' if discrete else 'continuous'} time a transfer function is written in {variable}"
    x = sp.Symbol(variable)
    p, q = lexicon.fraction(node, (variable,), barred)
    p, q, delay = (p, q, sp.S.Zero) if discrete else without_dead_time(p, q, x, node, lexicon)
    for side in (p, q):
        top, bottom = expanded_size(side, x)
        if max(top.terms, bottom.terms) > MAX_TERMS or max(top.degree, bottom.degree) > MAX_DEGREE:
            raise node.fault("the transfer function is too large to be multiplied out")
    if not (p.is_polynomial(x) and q.is_polynomial(x)):
        p, q = sp.fraction(sp.together(p / q))
    if not (p.is_polynomial(x) and q.is_polynomial(x)):
        raise node.fault(f"a quotient of polynomials in {variable} is expected here")
    return Rational(*_pair(sp.expand(p), sp.expand(q), x, node), scalar(node).text, delay, _in_factors(p, q, x))


def _in_factors(p: sp.Expr, q: sp.Expr, x: sp.Symbol) -> tuple[sp.Expr, sp.Expr] | None:
    """Return p and q if one of them is a product or a power of sums in x, and no sum holds such a product."""
    factors = [factor.as_base_exp()[0] for side in (p, q) for factor in sp.Mul.make_args(side)]
    sums = [factor for factor in factors if factor.is_Add and factor.has(x)]
    products = any(side.is_Mul or side.is_Pow for side in (p, q) if any(each.has(x) for each in side.atoms(sp.Add)))
    return (p, q) if products and all(each == sp.expand(each) for each in sums) else None


def _pair(p: sp.Expr, q: sp.Expr, x: sp.Symbol, node: Node) -> tuple[sp.Poly, sp.Poly]:
    """Return two polynomials in x over one domain; square roots of numbers are made part of it."""
    if field_degree(p, q) > MAX_FIELD_DEGREE:  # cancelling would take minutes
        raise node.fault("the transfer function holds too many different roots to be cancelled exactly")
    symbolic = (p.free_symbols | q.free_symbols) - {x}
    (P, Q), _ = sp.parallel_poly_from_expr((p, q), x, extension=None if symbolic else True)
    return P, Q


def _from_coefficients(node: MappingNode, lexicon: Lexicon, variable: str) -> Rational:
    report = Report()
    coefficients: list[list[sp.Expr]] = []
    for key in FRACTION:
        with report:
            coefficients.append(_coefficients(node[key], key, lexicon))
    report.conclude()
    if not coefficients[1]:
        raise node["denominator"].fault("the denominator is zero")
    x = sp.Symbol(variable)
    p, q = (sum((c * x**i for i, c in enumerate(reversed(cs))), sp.Integer(0)) for cs in coefficients)
    return Rational(*_pair(p, q, x, node), f"({sp.sstr(p)})/({sp.sstr(q)})")


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
    above, below = (sp.Mul(*(sp.expand(x - root) for root in roots[key])) for key in ("zeros", "poles"))
    above = sp.Mul(gain, above)
    p, q = sp.expand(above), sp.expand(below)
    factors = ["".join(f"*({sp.sstr(x - root)})" for root in roots[key]) for key in ("zeros", "poles")]
    written = None if (above * below).has(sp.I) else _in_factors(above, below, x)
    return Rational(*_pair(p, q, x, node), f"({sp.sstr(gain)}){factors[0]}/(1{factors[1]})", written=written)
