"""Gramians over a finite time, exactly: W(T) = ∫₀ᵀ e^{At} B Bᵀ e^{Aᵀt} dt, in discrete time Σ_{k<N} Aᵏ B Bᵀ (Aᵀ)ᵏ.

e^{At}B = Σ fᵢ(t) Gᵢ with the modes fᵢ and constant matrices Gᵢ, so W(T) = Σᵢⱼ ∫fᵢfⱼ Gᵢ Gⱼᵀ: all that is integrated
are products of modes, that is powers times exponentials times one cosine or sine.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import product
from math import factorial
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.functions.closed_forms import exponential
from solver.exact.linear_algebra.fields import collected, matrix_of, side_by_side
from solver.exact.structure.controllability import controllability_matrix


@dataclass(frozen=True)
class Mode:
    """c tᵏ e^{σt} cos(ωt), with the sine instead where `odd`."""

    factor: sp.Expr
    power: int
    sigma: sp.Expr
    omega: sp.Expr
    odd: bool


@dataclass(frozen=True)
class InputResponse:
    """e^{At}B = Σ functions[i] coefficients[i], the functions independent, the coefficients constant n×m."""

    shape: tuple[int, int]
    functions: tuple[sp.Expr, ...]
    coefficients: tuple[sp.ImmutableMatrix, ...]

    @cached_property
    def matrix(self) -> sp.ImmutableMatrix:
        """The closed form of e^{At}B (n×m)."""
        total = sp.zeros(*self.shape)
        for function, G in zip(self.functions, self.coefficients, strict=True):
            total += G * function
        return sp.ImmutableMatrix(total)

    @property
    def stacked(self) -> sp.ImmutableMatrix:
        """[G₁, G₂, …]: a row q with q e^{At}B = 0 for all t is one with q [G₁, G₂, …] = 0."""
        if not self.coefficients:
            return sp.ImmutableMatrix(sp.zeros(*self.shape))
        return sp.ImmutableMatrix(sp.Matrix.hstack(*self.coefficients))


def input_response(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, t: sp.Symbol) -> InputResponse:
    """e^{At}B by its modes (A n×n, B n×m); raises NotExact where the spectrum of A has no usable form."""
    found = exponential(A, t)
    n = A.rows
    pairs = []
    for function, coefficients in found.terms:
        G = sp.ImmutableMatrix((sp.Matrix(n, n, coefficients) * B).applyfunc(collected))
        if any(G.flat()):
            pairs.append((function, G))
    return InputResponse((n, B.cols), tuple(f for f, _ in pairs), tuple(G for _, G in pairs))


@lru_cache(maxsize=16)
def finite_gramian(
    A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, T: sp.Expr, V: sp.ImmutableMatrix | None = None
) -> sp.ImmutableMatrix:
    """∫₀ᵀ e^{At} B V Bᵀ e^{Aᵀt} dt (n×n) in closed form, V symmetric (m×m; None: the identity).

    Raises NotExact where the spectrum of A has no closed form.
    """
    t = sp.Dummy("t")
    response = input_response(A, B, t)
    modes = [list(_modes(function, t)) for function in response.functions]
    n = A.rows
    entries: list[dict[sp.Expr, sp.Expr]] = [{} for _ in range(n * n)]
    for i, (first, G) in enumerate(zip(modes, response.coefficients, strict=True)):
        for j, (second, H) in enumerate(zip(modes[: i + 1], response.coefficients, strict=False)):
            weight = (G * H.T if V is None else G * V * H.T).applyfunc(sp.expand)
            weight = weight if i == j else weight + weight.T
            for function, c in _integral(first, second, T).items():
                for at, w in enumerate(weight.flat()):
                    if w:
                        entries[at][function] = entries[at].get(function, sp.S.Zero) + c * w
    return sp.ImmutableMatrix(n, n, [_put_together(entry) for entry in entries])


def _put_together(entry: dict[sp.Expr, sp.Expr]) -> sp.Expr:
    return sp.Add(*(collected(c) * function for function, c in entry.items()))


def _modes(function: sp.Expr, t: sp.Symbol) -> Iterator[Mode]:
    """A function of e^{At}, as a sum of modes: cosh and sinh are split into exponentials."""
    power, sigma, omega, odd, shift = 0, sp.S.Zero, sp.S.Zero, False, sp.S.Zero
    sign, constant = 0, sp.S.One
    factor: Any
    for factor in sp.Mul.make_args(function):
        if factor == t:
            power = 1
        elif factor.is_Pow and factor.base == t:
            power = int(factor.exp)
        elif isinstance(factor, sp.exp):
            sigma += factor.args[0].coeff(t)
        elif isinstance(factor, sp.cos | sp.sin):
            omega, odd = factor.args[0].coeff(t), isinstance(factor, sp.sin)
        elif isinstance(factor, sp.cosh | sp.sinh):
            shift, sign = sp.expand(factor.args[0]).coeff(t), 1 if isinstance(factor, sp.cosh) else -1
        else:
            constant *= factor
    if sign:
        yield Mode(constant / 2, power, sigma + shift, sp.S.Zero, False)
        yield Mode(sign * constant / 2, power, sigma - shift, sp.S.Zero, False)
    else:
        yield Mode(constant, power, sigma, omega, odd)


def _integral(first: list[Mode], second: list[Mode], T: sp.Expr) -> dict[sp.Expr, sp.Expr]:
    """∫₀ᵀ of a product of two sums of modes, as functions of T with their coefficients."""
    found: dict[sp.Expr, sp.Expr] = {}
    for a, b in product(first, second):
        for mode in _multiplied(a, b):
            for function, c in _integrated(mode, T):
                found[function] = found.get(function, sp.S.Zero) + c
    return found


def _multiplied(a: Mode, b: Mode) -> Iterator[Mode]:
    """The product of two modes, by the addition theorems."""
    factor, power, sigma = a.factor * b.factor, a.power + b.power, sp.expand(a.sigma + b.sigma)
    plus, minus = sp.expand(a.omega + b.omega), sp.expand(a.omega - b.omega)
    half = factor / 2
    if a.odd and b.odd:
        yield Mode(half, power, sigma, minus, False)
        yield Mode(-half, power, sigma, plus, False)
    elif a.odd or b.odd:
        yield Mode(half, power, sigma, plus, True)
        yield Mode(half if a.odd else -half, power, sigma, minus, True)
    else:
        yield Mode(half, power, sigma, minus, False)
        yield Mode(half, power, sigma, plus, False)


def _integrated(mode: Mode, T: sp.Expr) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """∫₀ᵀ of a mode, from ∫ tᵏe^{μt} = e^{μt} Σᵢ (−1)^{k−i} k!/i! tⁱ/μ^{k−i+1}, μ = σ + jω."""
    k, sigma, omega = mode.power, mode.sigma, mode.omega
    if omega == 0 and mode.odd:
        return
    if omega == 0 and sigma == 0:
        yield _split(T ** (k + 1), mode.factor / (k + 1))
        return
    envelope, norm = sp.exp(sp.expand(sigma * T)), sp.expand(sigma**2 + omega**2)
    c, s = sp.cos(omega * T), sp.sin(omega * T)
    for i in range(k + 1):
        m = k - i + 1
        real, imaginary = _powers_of_conjugate(sigma, omega, m)
        factor = mode.factor * (-1) ** (k - i) * sp.Rational(factorial(k), factorial(i)) / norm**m
        pairs = ((c, imaginary), (s, real)) if mode.odd else ((c, real), (s, -imaginary))
        for function, weight in pairs:
            yield _split(T**i * envelope * function, factor * weight)
        if i == 0:
            yield sp.S.One, -factor * (imaginary if mode.odd else real)


def _split(function: sp.Expr, c: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """The number in front of a function of T counts to its coefficient."""
    number, rest = function.as_coeff_Mul()
    return rest, number * c


def _powers_of_conjugate(sigma: sp.Expr, omega: sp.Expr, m: int) -> tuple[sp.Expr, sp.Expr]:
    """Real and imaginary part of (σ − jω)ᵐ."""
    real, imaginary = sp.S.One, sp.S.Zero
    for _ in range(m):
        real, imaginary = real * sigma + imaginary * omega, imaginary * sigma - real * omega
    return sp.expand(real), sp.expand(imaginary)


def discrete_gramian(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, steps: int) -> sp.ImmutableMatrix:
    """Σ_{k<N} Aᵏ B Bᵀ (Aᵀ)ᵏ (n×n), N = `steps`."""
    M, block = side_by_side(A, B)
    total: DomainMatrix = block * block.transpose()
    for _ in range(steps - 1):
        block = M * block
        total = total + block * block.transpose()
    return matrix_of(total)


def reached_in(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, steps: int) -> sp.ImmutableMatrix:
    """[B, AB, …, A^{N−1}B], N = `steps` ≤ n: what can be reached in so many steps of discrete time."""
    return sp.ImmutableMatrix(controllability_matrix(A, B)[:, : B.cols * min(steps, A.rows)])
