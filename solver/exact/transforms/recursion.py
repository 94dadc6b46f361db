"""Linear difference equations run through sample by sample: each latest sample from those before."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.transforms.difference_operators import SampleOperators
from solver.exact.transforms.operators import Jet


@dataclass(frozen=True)
class LatestSample:
    """A latest sample as a combination of earlier ones and of inputs, Σ c · sample + rest(k)."""

    jet: Jet
    samples: Mapping[Jet, sp.Expr]
    inputs: Mapping[Jet, sp.Expr]
    rest: sp.Expr


def latest_samples(operators: SampleOperators) -> tuple[LatestSample, ...]:
    """The equations solved for the latest sample of each unknown; raises NotExact where they cannot be."""
    L = operators.leading
    if sp.expand(L.det()) == 0:
        raise NotExact("difference_equation/not_explicit", names=[sp.Symbol(name) for name in operators.unknowns])
    inverse = L.inv()
    tops = [(name, operators.spans[name][1]) for name in operators.unknowns]
    found = []
    for j, top in enumerate(tops):
        samples: dict[Jet, sp.Expr] = {}
        inputs: dict[Jet, sp.Expr] = {}
        rest = sp.S.Zero
        for i, row in enumerate(operators.rows):
            weight = inverse[j, i]
            for jet, c in row.unknowns.items():
                if jet not in tops:
                    samples[jet] = samples.get(jet, sp.S.Zero) - weight * c
            for jet, c in row.inputs.items():
                inputs[jet] = inputs.get(jet, sp.S.Zero) + weight * c
            rest += weight * row.rest
        found.append(LatestSample(top, _tidied(samples), _tidied(inputs), sp.expand(rest)))
    return tuple(found)


def _tidied(coefficients: Mapping[Jet, sp.Expr]) -> dict[Jet, sp.Expr]:
    return {jet: tidy(c) for jet, c in coefficients.items() if tidy(c) != 0}


@dataclass(frozen=True)
class Run:
    """The values by unknown and sample, and of each sample that was computed the products that make it."""

    values: Mapping[Jet, sp.Expr]
    steps: tuple[tuple[Jet, tuple[tuple[sp.Expr, sp.Expr], ...], sp.Expr], ...]


def run_through(
    latest: tuple[LatestSample, ...],
    start: Mapping[Jet, sp.Expr],
    input_at: Callable[[str, int], sp.Expr],
    rest_at: Callable[[sp.Expr, int], sp.Expr],
    span: tuple[int, int],
) -> Run:
    """The values for k from the first to below the last of `span`, the number of the equations; each from the others.

    What is not known of a sample is zero. A step has (coefficient, value) of each product.
    """
    values = dict(start)
    steps = []
    for k in range(*span):
        new: dict[Jet, sp.Expr] = {}
        for each in latest:
            products = [(c, values.get((x, k + q), sp.S.Zero)) for (x, q), c in each.samples.items()]
            products += [(c, input_at(x, k + p)) for (x, p), c in each.inputs.items()]
            rest = rest_at(each.rest, k)
            products += [(sp.S.One, rest)] if rest != 0 else []
            jet = (each.jet[0], k + each.jet[1])
            new[jet] = tidy(sp.expand(sp.Add(*(c * value for c, value in products))))
            steps.append((jet, tuple(products), new[jet]))
        values |= new
    return Run(values, tuple(steps))
