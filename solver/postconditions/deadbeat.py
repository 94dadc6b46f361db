"""States that an input brings to rest, stage by stage."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.lazy import numeric
from solver.stated.algebra import difference, product


def of_stages_to_rest(found: Any, A: Any, B: Any) -> Iterator[Claim | Check]:
    """A V − B W = image, among the states before; a stage has all x with Aᵏx in [B, AB, …, Aᵏ⁻¹B], no others."""
    n = A.rows
    before = sp.ImmutableMatrix(sp.zeros(n, 0))
    reached, power = before, sp.ImmutableMatrix(sp.eye(n))
    dimensions = [0]
    for _ in range(n):
        reached, power = sp.ImmutableMatrix(sp.Matrix.hstack(reached, power * B)), sp.ImmutableMatrix(power * A)
        both = sp.ImmutableMatrix(sp.Matrix.hstack(reached, power))
        dimensions.append(n - numeric.rank(both) + numeric.rank(reached))
    for k, stage in enumerate(found, 1):
        yield Claim(difference(product(A, stage.V), product(B, stage.W)), stage.image)
        within = sp.ImmutableMatrix(sp.Matrix.hstack(before, stage.image))
        yield Check.that("states of the stages before", "numpy.linalg.svd", numeric.rank(within) == before.cols)
        before = sp.ImmutableMatrix(sp.Matrix.hstack(before, stage.V))
        complete = numeric.independent(before) and before.cols == dimensions[k]
        yield Check.that("all states of the stage", "numpy.linalg.svd", complete)
    yield Check.that("no further stage", "numpy.linalg.svd", before.cols == max(dimensions))
