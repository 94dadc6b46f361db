"""How one equation that is no product is solved for an unknown: the rules, each with what it costs.

A rule looks at a factor and tells its kind and its outcomes; the cheapest over all equations is taken first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from typing import Any

import sympy as sp

from solver.exact.modelling.branches import Outcome, toward
from solver.exact.modelling.evaluation import sign_of, vanishes
from solver.exact.modelling.factors_of_equations import factored, generators
from solver.exact.modelling.inverse_functions import inverted, sine_is
from solver.exact.modelling.real_roots import complex_roots, quotient, real_roots, square_root

VALUE, RELATION, INVERSE, QUADRATIC, WAVE, POLYNOMIAL, DIVISION, CIRCLE, CURVE = range(9)

TWO = 2


@dataclass(frozen=True)
class Rule:
    """A way to solve a factor: its cost, the kind of the move, what it leads to, and what the page tells."""

    cost: int
    kind: str
    outcomes: tuple[Outcome, ...]
    values: dict[str, Any] = field(default_factory=dict)


def rule_for(p: Any, unknowns: set[Any], n: sp.Symbol) -> Rule | None:
    """Return the cheapest rule for a factor."""
    inside = [x for x in unknowns if p.has(x)]
    rules: list[Callable[[], Iterator[Rule]]] = [
        lambda: _linear(p, inside, unknowns),
        lambda: _one_generator(p, unknowns, n),
        lambda: _root_and_square(p, unknowns),
        lambda: _wave(p, unknowns, n),
        lambda: _circle(p, unknowns, n),
        lambda: _divided(p, inside),
        lambda: _curve(p, inside, unknowns),
    ]
    for rule in rules:
        found = min(rule(), key=lambda each: (each.cost, _length(each)), default=None)
        if found is not None:
            return found
    return None


def _length(rule: Rule) -> Any:
    return (
        sum(v.count_ops() for o in rule.outcomes for v in o.put.values()),
        [str(x) for o in rule.outcomes for x in o.put],
    )


def _straight(p: Any, x: Any) -> tuple[Any, Any] | None:
    """Coefficient and rest of p = c x + r."""
    c = sp.diff(p, x)
    return None if c.has(x) or c == 0 else (sp.expand(c), p.xreplace({x: sp.S.Zero}))


def _linear(p: Any, inside: list[Any], unknowns: set[Any]) -> Iterator[Rule]:
    """c x + r = 0 with a coefficient that no unknown changes: x = −r/c."""
    for x in inside:
        straight = _straight(p, x)
        if straight is None or straight[0].free_symbols & unknowns:
            continue
        c, r = straight
        alone = not r.free_symbols & unknowns
        value = quotient(-r, c)
        nonzero = (c,) if sign_of(c) is None and not never_zero(c) else ()
        yield Rule(VALUE if alone else RELATION, "linear", (Outcome({x: value}, nonzero=nonzero, shown=((x, value),)),),
                   {"unknown": x, "value": value, "coefficient": c, "assumed": nonzero})  # fmt: skip


def never_zero(c: Any) -> bool:
    """Whether an expression is zero for no real values: a product of numbers, exponentials and (−1)ⁿ."""
    if c.is_number:
        return not vanishes(c)
    if c.is_Mul:
        return all(map(never_zero, c.args))
    if c.is_Pow and c.exp.is_Integer:
        return never_zero(c.base)
    return isinstance(c, sp.exp | sp.cosh) or (c.is_Pow and c.base == -1) or bool(c.is_nonzero)


def _coefficients(p: Any, g: Any) -> list[Any] | None:
    """The coefficients of a polynomial in g; None where it is none."""
    y = sp.Dummy()
    whole = sp.expand(p).xreplace({g: y})
    try:
        found = sp.Poly(whole, y)
    except sp.PolynomialError:
        return None
    return [sp.factor_terms(c) for c in found.all_coeffs()]


def _one_generator(p: Any, unknowns: set[Any], n: sp.Symbol) -> Iterator[Rule]:
    """A polynomial in an unknown, or in one function of unknowns."""
    found = generators(p, unknowns)
    if len(found) != 1 or generators(sp.expand(p), unknowns) != found:
        return
    g = found[0]
    coefficients = _coefficients(p, g)
    if coefficients is None or any(c.free_symbols & unknowns for c in coefficients):
        return
    roots = (real_roots if g.is_real is not None or not g.is_Symbol else complex_roots)(coefficients)
    if roots is None:
        return
    lead = coefficients[0]
    nonzero = (lead,) if sign_of(lead) is None and not never_zero(lead) else ()
    degree = len(coefficients) - 1
    cost = INVERSE if degree == 1 else QUADRATIC if degree == 2 else POLYNOMIAL
    values = {"of": g, "roots": [root for root, _ in roots], "degree": degree, "polynomial": p, "assumed": nonzero}
    if g.is_Symbol:
        outcomes = tuple(Outcome({g: root}, needs=needs, nonzero=nonzero, shown=((g, root),)) for root, needs in roots)
        yield Rule(cost, "roots", outcomes, values)
    elif degree == 1:
        inverse = inverted(g, roots[0][0], n)
        if inverse is not None:
            known = {g: roots[0][0]}
            own = tuple(replace(o, nonzero=nonzero, known=known) for o in inverse)
            yield Rule(cost, "inverse", own, {**values, "value": roots[0][0], "argument": g.args[0], "n": n})
    else:
        outcomes = tuple(Outcome(equations=(g - root,), needs=needs, nonzero=nonzero, shown=((g, root),))
                         for root, needs in roots)  # fmt: skip
        yield Rule(cost, "values_of", outcomes, values)


def _root_and_square(p: Any, unknowns: set[Any]) -> Iterator[Rule]:
    """A polynomial in an unknown and its root: one in the root alone."""
    found = generators(p, unknowns)
    radicals = [g for g in found if g.is_Pow and g.exp.is_Rational and g.exp.p == 1 and g.base.is_Symbol]
    if len(found) != TWO or len(radicals) != 1 or radicals[0].base not in found:
        return
    (g,), y = radicals, sp.Dummy("y")
    coefficients = _coefficients(sp.expand(p).xreplace({g: y}).xreplace({g.base: y**g.exp.q}), y)
    if coefficients is None or any(c.free_symbols & unknowns for c in coefficients):
        return
    roots = real_roots(coefficients)
    if roots is not None:
        outcomes = tuple(Outcome(equations=(g - r,), needs=needs, shown=((g, r),)) for r, needs in roots)
        values = {"of": g, "roots": [r for r, _ in roots], "degree": len(coefficients) - 1, "polynomial": p}
        yield Rule(QUADRATIC, "values_of", outcomes, values)


def _sine_and_cosine(p: Any, unknowns: set[Any]) -> Any:
    """The one angle whose sine and cosine are all that holds an unknown."""
    found = generators(p, unknowns)
    angles = {g.args[0] for g in found if isinstance(g, sp.sin | sp.cos)}
    return angles.pop() if len(angles) == 1 and all(isinstance(g, sp.sin | sp.cos) for g in found) else None


def _wave(p: Any, unknowns: set[Any], n: sp.Symbol) -> Iterator[Rule]:
    """a sin x + b cos x + d = 0: a single sine with a phase."""
    x = _sine_and_cosine(p, unknowns)
    if x is None:
        return
    s, c = sp.Dummy(), sp.Dummy()
    whole = sp.expand(p).xreplace({sp.sin(x): s, sp.cos(x): c})
    a, b = sp.diff(whole, s), sp.diff(whole, c)
    if a.has(s, c) or b.has(s, c) or a == 0 or b == 0:
        return
    d = whole.xreplace({s: sp.S.Zero, c: sp.S.Zero})
    nonzero = (a,) if sign_of(a) is None and not never_zero(a) else ()
    values = {"a": a, "b": b, "d": d, "argument": x, "n": n, "assumed": nonzero}
    if d == 0:
        angle = sp.atan(quotient(-b, a))
        yield Rule(WAVE, "tangent", (toward(x, angle + n * sp.pi, integer=n, nonzero=nonzero),),
                   {**values, "value": quotient(-b, a)})  # fmt: skip
        return
    R, phase = square_root(sp.expand(a**2 + b**2)), _phase(a, b)
    v = -d / R
    inverse = sine_is(x + phase, v, n)
    turned = (toward(x, sp.expand(o.shown[0][1] - phase), integer=n, needs=o.needs, nonzero=nonzero) for o in inverse)
    yield Rule(WAVE, "wave", tuple(turned),
               {**values, "amplitude": R, "phase": phase, "value": v})  # fmt: skip


def _phase(a: Any, b: Any) -> Any:
    """The angle φ with a = R cos φ, b = R sin φ."""
    sign = sign_of(a)
    angle = sp.atan(quotient(b, a))
    if sign == 1:
        return angle
    return angle + sp.pi if sign == -1 else sp.atan2(b, a)


def _circle(p: Any, unknowns: set[Any], n: sp.Symbol) -> Iterator[Rule]:
    """A polynomial in sin x and cos x: the two as unknowns with sin² x + cos² x = 1."""
    x = _sine_and_cosine(p, unknowns)
    if x is None:
        return
    c, s = sp.Dummy("c"), sp.Dummy("s")
    whole = sp.expand(p).xreplace({sp.cos(x): c, sp.sin(x): s})
    resultant = sp.resultant(whole, s**2 + c**2 - 1, s)
    coefficients = _coefficients(resultant, c)
    roots = real_roots([sp.expand(each) for each in coefficients]) if coefficients and len(coefficients) > 1 else None
    if roots is None:
        return
    outcomes = []
    for root, needs in roots:
        if sign_of(1 - root**2) == -1:
            continue
        square = 1 - root**2
        sines = [sp.S.Zero] if sign_of(square) == 0 else [sp.sqrt(square), -sp.sqrt(square)]
        for sine in sines:
            if vanishes(whole.xreplace({c: root, s: sine})):
                angle = sp.acos(root) * (-1 if sign_of(sine) == -1 else 1)
                outcomes.append(toward(x, angle + 2 * n * sp.pi, integer=n, needs=needs))
    yield Rule(CIRCLE, "circle", tuple(outcomes), {"argument": x, "n": n, "roots": [root for root, _ in roots],
                                                   "polynomial": p})  # fmt: skip


def _divided(p: Any, inside: list[Any]) -> Iterator[Rule]:
    """c x + r = 0 where the coefficient holds other unknowns: it is zero together with r, or x = −r/c."""
    for x in inside:
        straight = _straight(p, x)
        if straight is None:
            continue
        c, r = straight
        value = quotient(-r, c)
        if _cannot_vanish(c):
            yield Rule(RELATION, "linear", (Outcome({x: value}, shown=((x, value),)),),
                       {"unknown": x, "value": value, "coefficient": c, "assumed": ()})  # fmt: skip
        else:
            outcomes = (Outcome(equations=(c, r), shown=((c, sp.S.Zero), (r, sp.S.Zero))),
                        Outcome({x: value}, nonzero=(c,), shown=((x, value),)))  # fmt: skip
            yield Rule(DIVISION, "division", outcomes, {"unknown": x, "value": value, "coefficient": c, "rest": r})


def _cannot_vanish(c: Any) -> bool:
    """Whether an expression in unknowns is never zero, as a sum of positive terms is not."""
    parts = factored(c)
    whole = parts.constant * sp.Mul(*parts.factors)
    return never_zero(c) or never_zero(whole) or _all_of_one_sign(c) or all(map(_all_of_one_sign, parts.factors))


def _all_of_one_sign(c: Any) -> bool:
    signs = {_sign_of_term(term) for term in sp.Add.make_args(c)}
    return len(signs) == 1 and None not in signs


def _sign_of_term(term: Any) -> int | None:
    sign = 1
    for f in sp.Mul.make_args(term):
        own = 1 if isinstance(f, sp.exp | sp.cosh) else -1 if f.is_negative else 1 if f.is_positive else None
        if own is None:
            return None
        sign *= own
    return sign


def _curve(p: Any, inside: list[Any], unknowns: set[Any]) -> Iterator[Rule]:
    """A quadratic equation in one unknown whose coefficients hold others."""
    for x in inside:
        coefficients = _coefficients(p, x)
        if coefficients is None or len(coefficients) != 3 or any(c.has(x) for c in coefficients):
            continue
        if coefficients[0].free_symbols & unknowns:
            continue
        roots = real_roots([sp.expand(c) for c in coefficients]) or []
        outcomes = tuple(Outcome({x: root}, needs=needs, shown=((x, root),)) for root, needs in roots)
        yield Rule(CURVE, "roots", outcomes, {"of": x, "roots": [root for root, _ in roots], "degree": 2,
                                              "polynomial": p, "assumed": ()})  # fmt: skip
