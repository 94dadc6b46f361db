"""The Laplace and the z-transform and their inverses."""

from __future__ import annotations

from typing import Any

from solver.formula.building import row
from solver.formula.nodes import Fenced, Row
from solver.stated.declaration import Binding, Printer, Show, Stated, operation


def laplace(function: Any, t: Any, s: Any) -> Stated:
    """ℒ{f(t)}(s) of a function (a scalar or a matrix) of t ≥ 0 that is smooth there."""
    return Stated("laplace", (function, t, s))


def z_transform(sequence: Any, k: Any, z: Any) -> Stated:
    """𝒵{f(k)}(z) of a sequence (of scalars or matrices), k = 0, 1, …."""
    return Stated("z_transform", (sequence, k, z))


def inverse_laplace(image: Any, s: Any, t: Any) -> Stated:
    """ℒ⁻¹{F(s)}(t), t ≥ 0, of a rational F (a scalar or a matrix)."""
    return Stated("inverse_laplace", (image, s, t))


def inverse_z(image: Any, z: Any, k: Any) -> Stated:
    """𝒵⁻¹{F(z)}(k), k = 0, 1, …, of a rational F (a scalar or a matrix)."""
    return Stated("inverse_z", (image, z, k))


def _transform(letter: str) -> Printer:
    def write(show: Show, transformed: Any, *_variables: Any) -> Row:
        return row(letter, Fenced(r"\{", show(transformed), r"\}", tall=True))

    return write


operation(laplace, binding=Binding(1))(_transform(r"\mathcal{L}"))
operation(z_transform, binding=Binding(1))(_transform(r"\mathcal{Z}"))
operation(inverse_laplace, binding=Binding(1))(_transform(r"\mathcal{L}^{-1}"))
operation(inverse_z, binding=Binding(1), whole=(2,))(_transform(r"\mathcal{Z}^{-1}"))
