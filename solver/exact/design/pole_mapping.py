"""Poles of a sampled motion, exact: e^{st} is (e^{sT})ᵏ at the times t = kT."""

from __future__ import annotations

import sympy as sp

from solver.exact.design.eigenvectors import conjugated


def pole_in_z(s: sp.Expr, period: sp.Expr) -> sp.Expr:
    """Return z = e^{sT} = e^{σT}(cos ωT + j sin ωT) for s = σ + jω and the sampling period T; symbols are real."""
    exponent = sp.expand(s * period)
    mirror = conjugated(exponent)
    real, imaginary = sp.expand((exponent + mirror) / 2), sp.expand((exponent - mirror) / (2 * sp.I))
    size = sp.exp(real)
    return size if imaginary == 0 else size * sp.cos(imaginary) + sp.I * size * sp.sin(imaginary)


def without_squared_sines(value: sp.Expr) -> sp.Expr:
    """Return the value, multiplied out, with 1 − cos² for sin²: what the two poles of a pair give is in cosines."""
    squares = {
        each: (1 - sp.cos(each.base.args[0]) ** 2) ** (each.exp / 2)
        for each in value.atoms(sp.Pow)
        if isinstance(each.base, sp.sin) and each.exp.is_Integer and each.exp.is_positive and each.exp % 2 == 0
    }
    return sp.expand(value.xreplace(squares)) if squares else value
