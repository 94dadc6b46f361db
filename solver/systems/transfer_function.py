"""Transfer functions as the problem gives them, exact."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp


@dataclass(frozen=True)
class TransferFunction:
    """G(s) (discrete: G(z)) of p outputs and m inputs: a p×m matrix of rational functions, cancelled, exact."""

    matrix: sp.ImmutableMatrix
    variable: sp.Symbol
    discrete: bool = False
    sample_time: sp.Expr | None = None
    as_given: str = ""
