"""Antiderivatives of sums of c xⁿ e^{ax+p} cos(bx+q) and c xⁿ e^{ax+p} sin(bx+q), term by term.

∫ xⁿ e^{λx} dx = e^{λx} Σᵢ (−1)ⁱ n!/(n−i)! x^{n−i}/λ^{i+1}; of λ = a + jb the real part belongs to the cosine, the
imaginary one to the sine.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.affine import tidy

Wave = tuple[bool, sp.Expr]
"""Whether it is a sine, and its angle, linear in the variable."""


@dataclass(frozen=True)
class Antiderivative:
    """An integrand as a sum of terms that can be integrated, and its antiderivative, entry by entry."""

    integrand: sp.ImmutableMatrix
    function: sp.ImmutableMatrix


@dataclass(frozen=True)
class _Term:
    """c xⁿ e^{exponent} wave."""

    factor: sp.Expr
    power: int
    exponent: sp.Expr
    wave: Wave | None

    def expression(self, x: sp.Symbol) -> sp.Expr:
        return self.factor * x**self.power * sp.exp(self.exponent) * _written(self.wave)


def antiderivative(integrand: sp.ImmutableMatrix, x: sp.Symbol) -> Antiderivative | None:
    """An antiderivative in x of each entry; None where an entry is no sum of such terms."""
    terms = [_terms(entry, x) for entry in integrand.flat()]
    known = [each for each in terms if each is not None]
    if len(known) < len(terms):
        return None
    shape = integrand.shape
    written = [sp.Add(*(term.expression(x) for term in entry)) for entry in known]
    found = [sp.Add(*(_integral(term, x) for term in entry)) for entry in known]
    return Antiderivative(sp.ImmutableMatrix(*shape, written), sp.ImmutableMatrix(*shape, found))


def _terms(entry: sp.Expr, x: sp.Symbol) -> list[_Term] | None:
    found: list[_Term] = []
    for term in sp.Add.make_args(sp.expand_mul(entry)):
        read = _read(term, x)
        if read is None:
            return None
        found += read
    return found


def _read(term: sp.Expr, x: sp.Symbol) -> list[_Term] | None:
    """A product as a sum of terms, products of sines and cosines as sums of them; None for anything else."""
    found, waves = _Term(sp.S.One, 0, sp.S.Zero, None), []
    for each in _factors(term):
        linear = [argument for argument in each.args if sp.diff(argument, x, 2) == 0]
        if not each.has(x):
            found = replace(found, factor=found.factor * each)
        elif each == x:
            found = replace(found, power=found.power + 1)
        elif isinstance(each, sp.exp) and linear:
            found = replace(found, exponent=found.exponent + each.args[0])
        elif isinstance(each, sp.sin | sp.cos) and linear:
            waves.append((isinstance(each, sp.sin), each.args[0]))
        else:
            return None
    exponent = sp.expand(found.exponent)
    return [replace(found, exponent=exponent, factor=c * found.factor, wave=wave) for c, wave in _summed(waves)]


def _factors(term: sp.Expr) -> Iterator[Any]:
    for each in sp.Mul.make_args(term):
        factor: Any = each
        if factor.is_Pow and factor.exp.is_Integer and factor.exp > 0:
            yield from [factor.base] * int(factor.exp)
        else:
            yield factor


def _summed(waves: list[Wave]) -> list[tuple[sp.Expr, Wave | None]]:
    """A product of waves as a sum: sin a cos b = (sin(a + b) + sin(a − b))/2, and so on."""
    if not waves:
        return [(sp.S.One, None)]
    found: list[tuple[sp.Expr, Wave | None]] = [(sp.S.One, waves[0])]
    for sine, angle in waves[1:]:
        parts: list[tuple[sp.Expr, Wave | None]] = []
        for c, wave in found:
            of_sine, other = wave or (False, sp.S.Zero)
            both = of_sine and sine
            mixed = of_sine != sine
            a, b = (other, angle) if of_sine else (angle, other)
            above, below = sp.expand(a + b), sp.expand(a - b)
            parts += [(-c / 2 if both else c / 2, (mixed, above)), (c / 2, (mixed, below))]
        found = parts
    return found


def _written(wave: Wave | None) -> sp.Expr:
    if wave is None:
        return sp.S.One
    sine, angle = wave
    return sp.sin(angle) if sine else sp.cos(angle)


def _integral(term: _Term, x: sp.Symbol) -> sp.Expr:
    a = sp.diff(term.exponent, x)
    b = sp.diff(term.wave[1], x) if term.wave else sp.S.Zero
    n, envelope = term.power, sp.exp(term.exponent)
    if a == 0 and b == 0:
        return term.factor * envelope * _written(term.wave) * x ** (n + 1) / (n + 1)
    parts = []
    for i in range(n + 1):
        real, imaginary = _reciprocal(a, b, i + 1)
        weight = (-1) ** i * sp.ff(n, i) * term.factor
        parts.append(tidy(weight * real) * x ** (n - i) * envelope * _written(term.wave))
        if term.wave:
            sine, angle = term.wave
            other, sign = (sp.cos(angle), 1) if sine else (sp.sin(angle), -1)
            parts.append(tidy(sign * weight * imaginary) * x ** (n - i) * envelope * other)
    return sp.Add(*parts)


def _reciprocal(a: sp.Expr, b: sp.Expr, power: int) -> tuple[sp.Expr, sp.Expr]:
    """Real and imaginary part of (a + jb)^−power."""
    j = sp.Dummy("j")
    real, imaginary = sp.S.Zero, sp.S.Zero
    for (k,), c in sp.Poly(sp.expand((a - j * b) ** power), j).terms():
        sign = (-1) ** (k // 2)
        real, imaginary = (real, imaginary + sign * c) if k % 2 else (real + sign * c, imaginary)
    below = sp.expand((a**2 + b**2) ** power)
    return real / below, imaginary / below
