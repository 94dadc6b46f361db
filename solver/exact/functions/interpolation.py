"""The conditions of the Cayley–Hamilton method: f(λ) = Σ αᵢ λⁱ at the eigenvalues, and its λ-derivatives."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp

from solver.exact.functions.closed_forms import polar
from solver.exact.linear_algebra.radicals import complex_parts
from solver.exact.linear_algebra.spectrum import Root, Spectrum, is_lower


@dataclass(frozen=True, slots=True)
class Condition:
    """Σ rowᵢ αᵢ = right."""

    row: tuple[sp.Expr, ...]
    right: sp.Expr


def interpolation(found: Spectrum, x: sp.Symbol, *, discrete: bool) -> list[Condition]:
    """The n conditions for α₀ … αₙ₋₁; a conjugate pair gives the real and the imaginary part of the upper root's."""
    n = len(found.eigenvalues)
    return [condition for root in found.roots for condition in _of_root(root, n, x, discrete=discrete)]


def _of_root(root: Root, n: int, x: sp.Symbol, *, discrete: bool) -> Iterator[Condition]:
    paired = root.kind in ("complex", "decimal") and root.shift != 0
    if paired and is_lower(root):
        return
    for i in range(root.multiplicity):
        row = tuple(_derivative_of_power(root.value, power, i) for power in range(n))
        if paired:
            cosine, sine = _paired_right(root, i, x, discrete=discrete)
            parts = [complex_parts(c) for c in row]
            yield Condition(tuple(real for real, _ in parts), cosine)
            yield Condition(tuple(imaginary for _, imaginary in parts), sine)
        else:
            yield Condition(row, _right(root.value, i, x, discrete=discrete))


def _derivative_of_power(value: sp.Expr, power: int, i: int) -> sp.Expr:
    """The i-th derivative of λ^power with respect to λ, multiplied out."""
    return sp.expand(sp.ff(power, i) * value ** (power - i)) if power >= i else sp.Integer(0)


def _right(value: sp.Expr, i: int, x: sp.Symbol, *, discrete: bool) -> sp.Expr:
    """The i-th λ-derivative of e^{λt}, or of λᵏ."""
    if not discrete:
        return x**i * sp.exp(value * x)
    if value == 0:
        return sp.factorial(i) * sp.KroneckerDelta(x, i)
    return sp.expand(sp.ff(x, i)) * value ** (x - i) if i else value**x


def _paired_right(root: Root, i: int, x: sp.Symbol, *, discrete: bool) -> tuple[sp.Expr, sp.Expr]:
    """Real and imaginary part of the i-th λ-derivative of e^{λt}, or of λᵏ, at λ = σ + jω."""
    if not discrete:
        envelope = x**i * sp.exp(root.sigma * x)
        return envelope * sp.cos(root.shift * x), envelope * sp.sin(root.shift * x)
    r, theta = polar(root)
    envelope = sp.expand(sp.ff(x, i)) * r ** (x - i)
    return envelope * sp.cos(theta * (x - i)), envelope * sp.sin(theta * (x - i))
