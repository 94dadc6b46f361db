"""Σ T(x) over the roots of a polynomial."""

from __future__ import annotations

from typing import Any

import numpy as np
import sympy as sp
from mpmath.libmp.libhyper import NoConvergence

from solver.numeric.evaluation.arithmetic import Array, multiple
from solver.numeric.evaluation.combining import add, joined
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import NotEvaluable, Undefined, Value
from solver.numeric.evaluation.walk import walk
from solver.words import Phrase

ORACLE = Oracle(75, "mpmath.polyroots")


def evaluate(environment: Environment, term: Any, variable: Any, polynomial: Any) -> Value:
    """T at the roots of each square-free factor, times the multiplicity; what T moves within a root's error counts."""
    try:
        _, factors = sp.Poly(polynomial, variable).sqf_list()
    except sp.PolynomialError as trouble:
        raise NotEvaluable(Phrase("roots of what is no polynomial in {variable}", variable=str(variable))) from trouble
    arithmetic = environment.arithmetic
    found = []
    for factor, multiplicity in factors:
        roots, errors = _roots(environment, factor.all_coeffs())
        for root, error in zip(roots.T, errors.T, strict=True):
            here, beside = (walk(term, environment.having({variable: x})) for x in (root, root + error))
            unsure = arithmetic.size(beside.value - here.value) / arithmetic.eps
            found.append(Value(here.value * multiplicity, (here.magnitude + unsure) * multiplicity))
    if not found:
        raise Undefined("a polynomial without roots")
    return joined(add, found)


def _roots(environment: Environment, coefficients: list[Any]) -> tuple[Array, Array]:
    """Return the simple roots at each point (P×n) and bounds of their errors, found with many more digits."""
    arithmetic = environment.arithmetic
    fine = multiple(2 * arithmetic.digits + 40)
    values = {symbol: fine.array(list(environment.full(x))) for symbol, x in environment.values.items()}
    points = Environment(values, environment.points, fine)
    listed = np.stack([points.full(walk(each, points).value) for each in coefficients], axis=1)
    if np.any(fine.size(listed[:, 0]) == 0):
        raise Undefined("the degree of the polynomial is another one here")
    try:
        found = [fine.context.polyroots(list(row), maxsteps=400, extraprec=400, error=True) for row in listed]
    except NoConvergence as trouble:
        raise NotEvaluable("the roots of the polynomial were not found") from trouble
    bounds = [[float(error) + arithmetic.eps * float(abs(x)) for x in roots] for roots, error in found]
    return np.stack([arithmetic.array(list(roots)) for roots, _ in found]), np.stack(
        [arithmetic.array(row) for row in bounds]
    )
