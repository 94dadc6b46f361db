"""Linear differential equations with constant coefficients: the characteristic polynomial and its functions.

A root λ = σ + jω of p(λ) of multiplicity m contributes tʲ e^{σt} cos ωt and tʲ e^{σt} sin ωt, j < m. Right sides are
sums of tⁿ e^{σt} cos ωt and tⁿ e^{σt} sin ωt: as p(D) (q e^{λt}) = e^{λt} Σ p⁽ʲ⁾(λ)/j! q⁽ʲ⁾, a polynomial q of the same
degree, times tᵏ for a k-fold root λ, solves them (W. Walter, Ordinary Differential Equations, §20).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import factorial
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.affine import solve_affine, tidy
from solver.exact.linear_algebra.fields import NotExact, vanishing_factors
from solver.exact.linear_algebra.spectrum import Factor, Root, is_lower, spectrum
from solver.exact.time_response.signals import read_signal
from solver.exact.variations.linear_forms import LinearForm

NAMES = (("A", "B"), ("M", "N"), ("P", "Q"), ("F", "G"), ("V", "W"))
"""Letters for the coefficients of cosines (and powers alone) and of sines."""


@dataclass(frozen=True)
class FundamentalSystem:
    """The factors of the characteristic polynomial and n independent solutions of the homogeneous equation.

    `exceptions` are conditions on parameters under which roots meet.
    """

    factors: tuple[Factor, ...]
    functions: tuple[sp.Expr, ...]
    exceptions: tuple[sp.Basic, ...]

    @property
    def roots(self) -> tuple[Root, ...]:
        """The distinct roots."""
        return tuple(root for factor in self.factors for root in factor.roots)


@dataclass(frozen=True)
class Trial:
    """A part of the right side, the trial function for it, and what comparing coefficients gives.

    `equations` have a function of time and both sides of what its coefficients must satisfy; `resonance` is the
    multiplicity of the root σ + jω. `exceptions` are factors in parameters whose zeros need another trial function.
    """

    right: sp.Expr
    exponent: sp.Expr
    angle: sp.Expr
    resonance: int
    letters: tuple[sp.Symbol, ...]
    function: sp.Expr
    equations: tuple[tuple[sp.Expr, sp.Expr, sp.Expr], ...]
    values: tuple[sp.Expr, ...]
    exceptions: tuple[sp.Expr, ...]

    def derivative(self, order: int, t: sp.Symbol) -> sp.Expr:
        """A derivative of the trial function, the exponential in front."""
        cosines = [letter for letter in self.letters if letter.name[0] == self.letters[0].name[0]]
        sines = self.letters[len(cosines) :]
        monomial = [sp.S.Zero] * order + [sp.S.One]
        taylor = _taylor(monomial, self.exponent, self.angle)
        rows = _compared(taylor, self.resonance, cosines, sines, t)
        waves = (sp.cos(self.angle * t), sp.sin(self.angle * t)) if sines else (sp.S.One,)
        parts = [sp.Add(*(sp.collect(c, self.letters) * t**n for n, c in rows[i].items())) for i in range(len(waves))]
        inner = sp.Add(*(part * wave for part, wave in zip(parts, waves, strict=True)))
        return sp.exp(self.exponent * t) * inner

    @property
    def solution(self) -> sp.Expr:
        """The trial function with the values put in."""
        envelope, rest = sp.sift(
            sp.Mul.make_args(self.function), lambda factor: isinstance(factor, sp.exp), binary=True
        )
        inner = sp.Mul(*rest).xreplace(dict(zip(self.letters, self.values, strict=True)))
        return sp.Mul(*envelope) * sp.expand(inner)


def fundamental_system(coefficients: Sequence[sp.Expr], t: sp.Symbol) -> FundamentalSystem:
    """Solutions of Σ cᵢ x⁽ⁱ⁾ = 0, cₙ = 1; raises NotExact for an irreducible factor of degree ≥ 3 with parameters."""
    n = len(coefficients) - 1
    found = spectrum(sp.ImmutableMatrix(n, n, lambda i, j: -coefficients[j] if i == n - 1 else sp.Integer(j == i + 1)))
    factors = _slowest_first(found.factors)
    functions = [each for factor in factors for root in factor.roots for each in _functions(root, t)]
    return FundamentalSystem(factors, tuple(functions), found.exceptions)


def _slowest_first(factors: Sequence[Factor]) -> tuple[Factor, ...]:
    """What grows before what decays, as sums are written; as they stand where parameters decide."""
    firsts = [factor.roots[0].value for factor in factors]
    if any(value.free_symbols for value in firsts):
        return tuple(factors)
    return tuple(sorted(factors, key=lambda factor: -max(sp.re(sp.N(root.value)) for root in factor.roots)))


def _functions(root: Root, t: sp.Symbol) -> Iterator[sp.Expr]:
    """tʲ times the exponential of a real root, or the two waves for the upper root of a pair."""
    paired = root.kind in ("complex", "symbolic", "decimal") and root.shift != 0
    if paired and _is_second(root):
        return
    for j in reversed(range(root.multiplicity)):
        if not paired:
            yield t**j * sp.exp(root.value * t)
            continue
        even, odd = (sp.cosh, sp.sinh) if root.kind == "symbolic" else (sp.cos, sp.sin)
        for wave in (even, odd):
            yield t**j * sp.exp(root.sigma * t) * wave(_upright(root.shift) * t)


def _is_second(root: Root) -> bool:
    """Of a pair σ ± δ the one with the minus."""
    return bool(root.shift.could_extract_minus_sign()) if root.kind == "symbolic" else is_lower(root)


def _upright(shift: sp.Expr) -> sp.Expr:
    return -shift if shift.could_extract_minus_sign() else shift


def trials(form: LinearForm, t: sp.Symbol) -> tuple[Trial, ...]:
    """A trial function for each exponent and angle on the right side; raises NotExact for any other right side."""
    if form.right == 0:
        return ()
    taken = {str(symbol) for c in (*form.coefficients, form.right) for symbol in c.free_symbols}
    names = iter([pair for pair in NAMES if not {*pair} & taken])
    found: dict[tuple[sp.Expr, sp.Expr], dict[tuple[int, bool], sp.Expr]] = {}
    signal = read_signal(form.right, t, discrete=False)
    if signal.impulses or any(delay != 0 for delay, _ in signal.terms):
        raise NotExact("signals/no_rational_transform", part=form.right)
    for (_, (power, growth, angle, sine)), c in signal.terms.items():
        found.setdefault((growth, angle), {})[power, sine] = c
    last = ("R", "S")
    return tuple(_trial(form, t, place, parts, next(names, last)) for place, parts in found.items())


def _trial(
    form: LinearForm,
    t: sp.Symbol,
    place: tuple[sp.Expr, sp.Expr],
    parts: dict[tuple[int, bool], sp.Expr],
    names: tuple[str, str],
) -> Trial:
    sigma, omega = place
    degree = max(power for power, _ in parts)
    taylor = _taylor(form.coefficients, sigma, omega)
    k = next(j for j, value in enumerate(taylor) if not all(map(_vanishes, value)))
    cosines, sines = (_letters(name, degree) for name in names)
    letters = (*cosines, *(sines if omega != 0 else ()))
    rows = _compared(taylor, k, cosines, sines if omega != 0 else (), t)
    waves = (sp.cos(omega * t), sp.sin(omega * t)) if omega != 0 else (sp.S.One,)
    equations = []
    for sine, wave in enumerate(waves):
        for power in range(degree, -1, -1):
            left = sp.expand(rows[sine].get(power, sp.S.Zero))
            right = parts.get((power, bool(sine)), sp.S.Zero)
            if left != 0 or right != 0:
                equations.append((t**power * sp.exp(sigma * t) * wave, sp.collect(left, letters), right))
    M = sp.ImmutableMatrix([[tidy(sp.diff(left, x)) for x in letters] for _, left, _ in equations])
    solved = solve_affine(M, [right for _, _, right in equations], letters)
    polynomials = [_polynomial(each, t) for each in (cosines, sines)[: len(waves)]]
    function = t**k * sp.exp(sigma * t) * sp.Add(*(p * w for p, w in zip(polynomials, waves, strict=True)))
    norm = sp.Add(*(part**2 for part in taylor[k])) if omega != 0 else taylor[k][0]
    right = sp.Add(*(c * t**n * sp.exp(sigma * t) * waves[int(sine)] for (n, sine), c in parts.items()))
    return Trial(right, sigma, omega, k, letters, function, tuple(equations), solved.values,
                 tuple(vanishing_factors(norm)))  # fmt: skip


def _letters(name: str, degree: int) -> tuple[sp.Symbol, ...]:
    """A; or A_0, A_1, … for a polynomial."""
    if degree == 0:
        return (sp.Symbol(name, real=True),)
    return tuple(sp.Symbol(f"{name}_{i}", real=True) for i in range(degree + 1))


def _polynomial(letters: Sequence[sp.Symbol], t: sp.Symbol) -> sp.Expr:
    return sp.Add(*(letter * t**i for i, letter in enumerate(letters)))


def _taylor(coefficients: Sequence[sp.Expr], sigma: sp.Expr, omega: sp.Expr) -> list[tuple[sp.Expr, sp.Expr]]:
    """Real and imaginary part of p⁽ʲ⁾(σ + jω)/j! for j = 0 … n."""
    x, j = sp.Dummy("x"), sp.Dummy("j")
    p = sp.Add(*(c * x**i for i, c in enumerate(coefficients)))
    found = []
    for order in range(len(coefficients)):
        value = sp.expand((sp.diff(p, x, order) / factorial(order)).subs(x, sigma + j * omega))
        found.append(_parts(value, j))
    return found


def _parts(value: sp.Expr, j: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    """Real and imaginary part of a polynomial in j with j² = −1."""
    real, imaginary = sp.S.Zero, sp.S.Zero
    for (k,), c in sp.Poly(value, j).terms():
        turned = (-1) ** (k // 2) * c.as_expr()
        real, imaginary = (real, imaginary + turned) if k % 2 else (real + turned, imaginary)
    return tidy(real), tidy(imaginary)


def _vanishes(value: sp.Expr) -> bool:
    """Whether a value is zero for all values of the parameters."""
    if value.is_Rational:
        return bool(value == 0)
    if value.free_symbols:
        return bool(sp.cancel(sp.expand(value)) == 0)
    return bool(abs(sp.N(value, 60)) < sp.Float(10) ** -40)


def _compared(
    taylor: Sequence[tuple[sp.Expr, sp.Expr]],
    k: int,
    cosines: Sequence[sp.Symbol],
    sines: Sequence[sp.Symbol],
    t: sp.Symbol,
) -> tuple[dict[int, sp.Expr], dict[int, sp.Expr]]:
    """The coefficients of tⁿ cos ωt and tⁿ sin ωt in p(D) of the trial function, without e^{σt}, by n.

    It is the real part of q e^{λt} with q = tᵏ (P − jQ), P and Q the polynomials of the cosine and of the sine.
    """
    P, Q = (t**k * _polynomial(each, t) for each in (cosines, sines))
    real, imaginary = sp.S.Zero, sp.S.Zero
    for order, (a, b) in enumerate(taylor):
        dP, dQ = (sp.diff(each, t, order) for each in (P, Q))
        real, imaginary = real + a * dP + b * dQ, imaginary + b * dP - a * dQ
    return _by_powers(real, t), _by_powers(-imaginary, t)


def _by_powers(value: sp.Expr, t: sp.Symbol) -> dict[int, sp.Expr]:
    terms: Iterable[Any] = sp.Poly(sp.expand(value), t).terms()
    return {n: c for (n,), c in terms if c != 0}
